/* Predicates of points of one plane in space.
 *
 * Let A, B, C be the differences of a, b, c from d, and n a unit normal of the plane that all lie in. In an orthonormal
 * frame of the plane d is inside the circle of a, b, c, counter-clockwise as seen from n, when
 *
 *   D = |A|^2 [B C] + |B|^2 [C A] + |C|^2 [A B] > 0,   [P Q] the determinant of two vectors in the frame,
 *
 * and clockwise when D < 0: the sign that is asked for is that of D [b - a, c - a]. Now P x Q = [P Q] n for vectors of
 * the plane. So one component, of any axis along which n is not 0, of
 *
 *   |A|^2 (B x C) + |B|^2 (C x A) + |C|^2 (A x B) = D n   and of   (b - a) x (c - a) = [b - a, c - a] n
 *
 * has the signs of D and of [b - a, c - a], both changed or neither: their product is the answer. The components are
 * those of the projections along that axis, the second an orient2d, the first an incircle but for its lifts, which are
 * those of space: of degree 4, where the sphere through a, b, c and a point off the plane takes degree 6. */
#include "stages.h"
#include "wide.h"
#include "words.h"
#include <gmds/predicates.h>

/* The two coordinates that each projection keeps, in the order of CGAL's coplanar_orientation. */
static const int kept[3][2] = {{0, 1}, {1, 2}, {0, 2}};

static int projected_orient(const int axes[2], const double a[3], const double b[3], const double c[3])
{
  const double p[2] = {a[axes[0]], a[axes[1]]}, q[2] = {b[axes[0]], b[axes[1]]}, r[2] = {c[axes[0]], c[axes[1]]};
  return gmds_orient2d(p, q, r);
}

/* The projection is one to one on a plane or flattens it: all triples of one plane find the same one. */
int gmds_coplanar_orientation(const double a[3], const double b[3], const double c[3])
{
  int sign = 0;
  for (int i = 0; i < 3 && sign == 0; i++)
    sign = projected_orient(kept[i], a, b, c);
  return sign;
}

int gmds_coplanar_side(const double a[3], const double b[3], const double c[3], const double d[3])
{
  return gmds_coplanar_orientation(a, b, c) * gmds_coplanar_orientation(a, b, d);
}

/* The bound is that of incircle with one sum more in the lift, k = 11; so are the size, as the parts of rows that a
 * minor is of are no longer than the rows, and t. */
int gmds_coplanar_filter(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3])
{
  const int w = 3 - u - v;
  double au = a[u] - d[u], av = a[v] - d[v], aw = a[w] - d[w];
  double bu = b[u] - d[u], bv = b[v] - d[v], bw = b[w] - d[w];
  double cu = c[u] - d[u], cv = c[v] - d[v], cw = c[w] - d[w];
  double alift = au * au + av * av + aw * aw, blift = bu * bu + bv * bv + bw * bw;
  double clift = cu * cu + cv * cv + cw * cw;
  double det = alift * (bu * cv - cu * bv) + blift * (cu * av - au * cv) + clift * (au * bv - bu * av);
  const double t = 0x1p-500, bound = 0x1.6p-50 * (1 + 0x1p-40);
  if (fabs(det) > bound * (alift * blift + (clift + t) * (alift + blift + t)))
    return det > 0 ? 1 : -1;
  return 0;
}

int gmds_coplanar_lattice(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const from[] = {a, b, c};
  double delta[9];
  /* Integers below 2^12 times g: minors are below 2^25 times g^2, lifts below 3 2^24 times g^2, the sum is one below
   * 9 2^49 times g^4. */
  if (!differences_3(3, from, d, delta) || !on_lattice(9, delta, 0x1p42, 0x1p-250, 0x1p250))
    return GMDS_UNDECIDED;
  const double *p = delta, *q = delta + 3, *r = delta + 6;
  double det = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * (q[u] * r[v] - r[u] * q[v]) +
               (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]) * (r[u] * p[v] - p[u] * r[v]) +
               (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) * (p[u] * q[v] - q[u] * p[v]);
  return (det > 0) - (det < 0);
}

#if defined __SIZEOF_INT128__
int gmds_coplanar_words(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const from[] = {a, b, c};
  int64_t x[9];
  if (!integer_differences(3, from, d, x))
    return GMDS_UNDECIDED;
  uint64_t sum[5] = {0};
  for (int i = 0; i < 9; i += 3) {
    const int64_t *q = x + (i + 3) % 9, *r = x + (i + 6) % 9;
    int128 minor = (int128)q[u] * r[v] - (int128)r[u] * q[v];
    words_add_lifted(sum, x + i, (words3){minor >> 64, (uint64_t)minor}, 0);
  }
  return words_sum_sign(sum);
}
#else
int gmds_coplanar_words(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3])
{
  (void)u;
  (void)v;
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  return GMDS_UNDECIDED;
}
#endif

int gmds_coplanar_wide(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const points[] = {a, b, c, d};
  double coordinates[12];
  for (int i = 0; i < 12; i++)
    coordinates[i] = points[i / 3][i % 3];
  int grid = gmds_wide_grid(12, coordinates);
  wide x[12], minor, lift, scratch, det = {.sign = 0};
  for (int i = 0; i < 12; i++)
    gmds_wide_set(&x[i], coordinates[i], grid);
  for (int i = 0; i < 9; i++)
    gmds_wide_subtract(&x[i], &x[i], &x[9 + i % 3]);
  for (int i = 0; i < 9; i += 3) {
    const wide *q = &x[(i + 3) % 9], *r = &x[(i + 6) % 9];
    gmds_wide_multiply(&minor, &q[u], &r[v]);
    gmds_wide_multiply(&scratch, &r[u], &q[v]);
    gmds_wide_subtract(&minor, &minor, &scratch);
    gmds_wide_multiply(&lift, &x[i], &x[i]);
    for (int k = 1; k < 3; k++) {
      gmds_wide_multiply(&scratch, &x[i + k], &x[i + k]);
      gmds_wide_add(&lift, &lift, &scratch);
    }
    gmds_wide_multiply(&scratch, &lift, &minor);
    gmds_wide_add(&det, &det, &scratch);
  }
  return det.sign;
}

/* Of the three projections the one that seems to keep most of the triangle: it makes the filters decide. */
static int widest_projection(const double a[3], const double b[3], const double c[3])
{
  double largest = 0;
  int widest = 0;
  for (int i = 0; i < 3; i++) {
    int u = kept[i][0], v = kept[i][1];
    double area = fabs((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
    if (area > largest) {
      largest = area;
      widest = i;
    }
  }
  return widest;
}

int gmds_coplanar_incircle(const double a[3], const double b[3], const double c[3], const double d[3])
{
  int first = widest_projection(a, b, c);
  for (int i = 0; i < 3; i++) {
    const int *axes = kept[(first + i) % 3];
    int turn = projected_orient(axes, a, b, c);
    if (turn == 0)
      continue;
    int sign = gmds_coplanar_filter(axes[0], axes[1], a, b, c, d);
    if (sign == 0)
      sign = gmds_coplanar_lattice(axes[0], axes[1], a, b, c, d);
    if (sign == GMDS_UNDECIDED)
      sign = gmds_coplanar_words(axes[0], axes[1], a, b, c, d);
    if (sign == GMDS_UNDECIDED)
      sign = gmds_coplanar_wide(axes[0], axes[1], a, b, c, d);
    return sign * turn;
  }
  return 0;
}

/* As gmds_incircle_perturbed_exact, over the orientations in the plane. */
int gmds_coplanar_incircle_perturbed(const double a[3], const double b[3], const double c[3], const double d[3])
{
  int sign = gmds_coplanar_incircle(a, b, c, d);
  if (sign)
    return sign;
  const double *points[] = {a, b, c, d};
  int place[] = {0, 1, 2, 3};
  for (int last = 3; last > 0; last--) {
    int largest = last;
    for (int i = 0; i < last; i++) {
      int compare = gmds_compare_points(3, points[place[i]], points[place[largest]]);
      if (compare > 0 || (compare == 0 && place[i] == 3))
        largest = i;
    }
    int chosen = place[largest];
    place[largest] = place[last];
    place[last] = chosen;
    if (chosen == 3)
      return -1;
    const double *triangle[] = {a, b, c};
    triangle[chosen] = d;
    sign = gmds_coplanar_orientation(triangle[0], triangle[1], triangle[2]);
    if (sign)
      return sign * gmds_coplanar_orientation(a, b, c);
  }
  return -1;
}
