/* The exact stages of insphere after the cheap filter in <gmds/predicates.h>: the sign of
 *
 *   A [b c d] - B [c d a] + C [d a b] - D [a b c],   A = |a|^2, ..., [b c d] = b x c . d,
 *
 * where a, b, c, d stand for their differences from e, and its symbolic perturbation.
 *
 * Cost: 25 ns on a lattice, 80 ns in words, 60 in long doubles, 0.8 to 1.4 microseconds in integers of points of
 * like magnitude, some 40 for any exponents. */
#include "stages.h"
#include "wide.h"
#include "words.h"
#include <gmds/predicates.h>

int gmds_insphere_lattice(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])
{
  const double *const from[] = {a, b, c, d};
  double x[12];
  /* Integers below 2^9 times g: minors of two rows are integers below 2^19 times g^2, of three below 6 2^27 times g^3,
   * lifts below 3 2^18 times g^2, and the sum is one below 72 2^45 times g^5. */
  if (!differences_3(4, from, e, x) || !on_lattice(12, x, 0x1p45, 0x1p-200, 0x1p200))
    return GMDS_UNDECIDED;
  double ax = x[0], ay = x[1], az = x[2], bx = x[3], by = x[4], bz = x[5];
  double cx = x[6], cy = x[7], cz = x[8], dx = x[9], dy = x[10], dz = x[11];
  double ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  double da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  double det = (ax * ax + ay * ay + az * az) * (bz * cd - cz * bd + dz * bc) -
               (bx * bx + by * by + bz * bz) * (cz * da + dz * ac + az * cd) +
               (cx * cx + cy * cy + cz * cz) * (dz * ab + az * bd + bz * da) -
               (dx * dx + dy * dy + dz * dz) * (az * bc - bz * ac + cz * ab);
  return (det > 0) - (det < 0);
}

#if defined __SIZEOF_INT128__
int gmds_insphere_words(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])
{
  const double *const from[] = {a, b, c, d};
  int64_t x[12];
  if (!integer_differences(4, from, e, x))
    return GMDS_UNDECIDED;
  const int64_t *p = x, *q = x + 3, *r = x + 6, *s = x + 9;
  uint64_t sum[5] = {0};
  words_add_lifted(sum, p, words_determinant(q, r, s), 0);
  words_add_lifted(sum, q, words_determinant(r, s, p), 1);
  words_add_lifted(sum, r, words_determinant(s, p, q), 0);
  words_add_lifted(sum, s, words_determinant(p, q, r), 1);
  return words_sum_sign(sum);
}
#else
int gmds_insphere_words(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])
{
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  (void)e;
  return GMDS_UNDECIDED;
}
#endif

#if LDBL_MANT_DIG == 64
int gmds_insphere_extended(const double a[3], const double b[3], const double c[3], const double d[3],
                           const double e[3])
{
  const long double ex = e[0], ey = e[1], ez = e[2];
  const long double ax = a[0] - ex, ay = a[1] - ey, az = a[2] - ez, bx = b[0] - ex, by = b[1] - ey, bz = b[2] - ez;
  const long double cx = c[0] - ex, cy = c[1] - ey, cz = c[2] - ez, dx = d[0] - ex, dy = d[1] - ey, dz = d[2] - ez;
  const long double ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  const long double da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  const long double alift = ax * ax + ay * ay + az * az, blift = bx * bx + by * by + bz * bz;
  const long double clift = cx * cx + cy * cy + cz * cz, dlift = dx * dx + dy * dy + dz * dz;
  const long double abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
  const long double cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
  const long double det = (alift * bcd - blift * cda) + (clift * dab - dlift * abc);
  /* The square of the size is at most 8 ABCD (A + B + C + D), before <gmds/predicates.h> makes it simpler; k = 15, u =
   * 2^-64. The exponents of long doubles hold the tenth power of any difference of doubles. */
  const long double square = 8 * alift * blift * (clift * dlift) * (alift + blift + clift + dlift);
  if (!(det * det > 0x1.c2p-121L * (1 + 0x1p-39L) * square) || !extended_is_extended())
    return GMDS_UNDECIDED;
  return det > 0 ? 1 : -1;
}
#else
int gmds_insphere_extended(const double a[3], const double b[3], const double c[3], const double d[3],
                           const double e[3])
{
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  (void)e;
  return GMDS_UNDECIDED;
}
#endif

/* What a determinant of five points is made of, on the stack: 30 kB. */
typedef struct wide_sphere {
  wide x[15], two[3], minor, lift, scratch, det;
} wide_sphere;

/* w->minor = [q r s] for rows of w->x. */
static void wide_minor(wide_sphere *w, const wide *q, const wide *r, const wide *s)
{
  const wide *const rows[] = {q, r, s};
  w->minor.sign = w->minor.n = 0;
  for (int i = 0; i < 3; i++) {
    const wide *first = rows[(i + 1) % 3], *second = rows[(i + 2) % 3];
    gmds_wide_multiply(&w->two[0], &first[0], &second[1]);
    gmds_wide_multiply(&w->two[1], &first[1], &second[0]);
    gmds_wide_subtract(&w->two[0], &w->two[0], &w->two[1]);
    gmds_wide_multiply(&w->scratch, &rows[i][2], &w->two[0]);
    gmds_wide_add(&w->minor, &w->minor, &w->scratch);
  }
}

int gmds_insphere_wide(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])
{
  /* |p|^2 [q r s] for each row p: even permutations of the four rows. */
  static const int rows[4][4] = {{0, 3, 6, 9}, {3, 6, 0, 9}, {6, 9, 0, 3}, {9, 6, 3, 0}};
  const double *const points[] = {a, b, c, d, e};
  double coordinates[15];
  for (int i = 0; i < 15; i++)
    coordinates[i] = points[i / 3][i % 3];
  int grid = gmds_wide_grid(15, coordinates);
  wide_sphere w;
  wide *x = w.x;
  for (int i = 0; i < 15; i++)
    gmds_wide_set(&x[i], coordinates[i], grid);
  for (int i = 0; i < 12; i++)
    gmds_wide_subtract(&x[i], &x[i], &x[12 + i % 3]);
  w.det.sign = w.det.n = 0;
  for (int i = 0; i < 4; i++) {
    const wide *p = &x[rows[i][0]];
    gmds_wide_multiply(&w.lift, &p[0], &p[0]);
    for (int k = 1; k < 3; k++) {
      gmds_wide_multiply(&w.scratch, &p[k], &p[k]);
      gmds_wide_add(&w.lift, &w.lift, &w.scratch);
    }
    wide_minor(&w, &x[rows[i][1]], &x[rows[i][2]], &x[rows[i][3]]);
    gmds_wide_multiply(&w.scratch, &w.lift, &w.minor);
    gmds_wide_add(&w.det, &w.det, &w.scratch);
  }
  return w.det.sign;
}

int gmds_insphere_exact(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])
{
  int sign = gmds_insphere_lattice(a, b, c, d, e);
  if (sign == GMDS_UNDECIDED) {
    sign = gmds_insphere_bounded(a, b, c, d, e, INFINITY, GMDS_INSPHERE_BOUND);
    sign = sign ? sign : gmds_insphere_words(a, b, c, d, e);
  }
  if (sign == GMDS_UNDECIDED)
    sign = gmds_insphere_extended(a, b, c, d, e);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_insphere_wide(a, b, c, d, e);
  return sign;
}

/* Whether a comes before b in lexicographic order, without a branch: which of two points of a lattice does is a
 * toss. */
static int before(const double a[3], const double b[3])
{
  return (a[0] < b[0]) | ((a[0] == b[0]) & ((a[1] < b[1]) | ((a[1] == b[1]) & (a[2] < b[2]))));
}

/* As gmds_incircle_perturbed_exact: the largest point decides, outside when it is e, else by the orientation of the
 * tetrahedron with e in its place; where that is 0 the next largest. Of distinct points of a sphere the first or the
 * second decides: both 0 would put e on a line with two of the others. */
int gmds_insphere_perturbed_exact(const double a[3], const double b[3], const double c[3], const double d[3],
                                  const double e[3])
{
  int sign = gmds_insphere_exact(a, b, c, d, e);
  if (sign)
    return sign;
  /* e first, to be found before a point that is equal to it. */
  const double *const points[] = {e, a, b, c, d};
  int place[] = {0, 1, 2, 3, 4};
  for (int last = 4; last > 0; last--) {
    int largest = 0;
    for (int i = 1; i <= last; i++)
      largest = before(points[place[largest]], points[place[i]]) ? i : largest;
    int chosen = place[largest];
    if (chosen == 0)
      return -1;
    place[largest] = place[last];
    const double *corner[] = {e, a, b, c, d};
    corner[chosen] = e;
    sign = gmds_orient3d(corner[1], corner[2], corner[3], corner[4]);
    if (sign)
      return sign;
  }
  return -1;
}
