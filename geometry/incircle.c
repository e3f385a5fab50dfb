/* The exact stages of incircle after the filters in <gmds/predicates.h>: the sign of
 *
 *   A (b - d) x (c - d) + B (c - d) x (a - d) + C (a - d) x (b - d),   A = |a - d|^2, ...
 *
 * and its symbolic perturbation.
 *
 * Cost on a 2.6 GHz core: 10 ns on a lattice, 60 to 200 ns as an expansion, 200 to 500 ns in integers of points of like
 * magnitude, some 10 microseconds for any exponents. With inexact differences the integers are faster than the hundreds
 * of components of an expansion, which is why there is none for them. */
#include "expansion.h"
#include "stages.h"
#include "wide.h"
#include <gmds/predicates.h>

/* The six differences, ax ay bx by cx cy. The value is whether all are exact. */
static int differences(const double a[2], const double b[2], const double c[2], const double d[2], double delta[6])
{
  const double *const from[] = {a, b, c};
  int exact = 1;
  for (int i = 0; i < 6; i++) {
    pair p = exact_difference(from[i / 2][i % 2], d[i % 2]);
    delta[i] = p.high;
    exact &= p.low == 0;
  }
  return exact;
}

int gmds_incircle_lattice(const double a[2], const double b[2], const double c[2], const double d[2])
{
  double delta[6];
  /* With integers below 2^12 times g, minors and lifts are integers below 2^25 times g^2, and the sum one below 2^52
   * times g^4. */
  if (!differences(a, b, c, d, delta) || !on_lattice(6, delta, 0x1p42, 0x1p-250, 0x1p250))
    return GMDS_UNDECIDED;
  double ax = delta[0], ay = delta[1], bx = delta[2], by = delta[3], cx = delta[4], cy = delta[5];
  double det = (ax * ax + ay * ay) * (bx * cy - cx * by) + (bx * bx + by * by) * (cx * ay - ax * cy) +
               (cx * cx + cy * cy) * (ax * by - bx * ay);
  return (det > 0) - (det < 0);
}

#if LDBL_MANT_DIG == 64
int gmds_incircle_extended(const double a[2], const double b[2], const double c[2], const double d[2])
{
  const long double dx = d[0], dy = d[1];
  const long double ax = a[0] - dx, ay = a[1] - dy, bx = b[0] - dx, by = b[1] - dy, cx = c[0] - dx, cy = c[1] - dy;
  const long double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  const long double alift = ax * ax + ay * ay, blift = bx * bx + by * by, clift = cx * cx + cy * cy;
  const long double det = alift * (bxcy - cxby) + blift * (cxay - axcy) + clift * (axby - bxay);
  /* The cheap size and the bound of <gmds/predicates.h>, with u = 2^-64. The exponents of long doubles let no product
   * of four differences of doubles under- or overflow: the smallest is 2^-1074, the largest below 2^1026. */
  const long double size = alift * blift + clift * (alift + blift), bound = 0x1.4p-61L * (1 + 0x1p-40L) * size;
  if (!(det > bound || -det > bound) || !extended_is_extended())
    return GMDS_UNDECIDED;
  return det > 0 ? 1 : -1;
}
#else
int gmds_incircle_extended(const double a[2], const double b[2], const double c[2], const double d[2])
{
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  return GMDS_UNDECIDED;
}
#endif

/* h = |p|^2 (q x r): 32 components at most. The minor has 4 components without adjacent bits, which scaling keeps, as
 * expansion_sum needs it of what it adds. */
static int term(const double p[2], const double q[2], const double r[2], double h[32])
{
  pair l = exact_product(q[0], r[1]), m = exact_product(q[1], r[0]);
  double minor[4] = {l.low, l.high}, once[8], x[16], y[16];
  int n = expansion_add_double(2, minor, -m.low, minor);
  n = expansion_add_double(n, minor, -m.high, minor);
  int nx = expansion_scale(expansion_scale(n, minor, p[0], once), once, p[0], x);
  int ny = expansion_scale(expansion_scale(n, minor, p[1], once), once, p[1], y);
  return expansion_sum(nx, x, ny, y, h);
}

int gmds_incircle_expansion(const double a[2], const double b[2], const double c[2], const double d[2])
{
  double delta[6];
  /* A product of four differences is a multiple of the product of their last places: above 2^-1074 when the
   * differences are above 2^-210. */
  if (!differences(a, b, c, d, delta) || !magnitudes_within(6, delta, 0x1p-210, 0x1p240))
    return GMDS_UNDECIDED;
  const double *p = delta, *q = delta + 2, *r = delta + 4;
  double tp[32], tq[32], tr[32], two[64], det[96];
  int np = term(p, q, r, tp), nq = term(q, r, p, tq), nr = term(r, p, q, tr);
  int n = expansion_sum(np, tp, nq, tq, two);
  return expansion_sign(expansion_sum(n, two, nr, tr, det), det);
}

/* r = p x q, and scratch that the caller lends. */
static void wide_minor(wide *r, const wide p[2], const wide q[2], wide *scratch)
{
  gmds_wide_multiply(r, &p[0], &q[1]);
  gmds_wide_multiply(scratch, &p[1], &q[0]);
  gmds_wide_subtract(r, r, scratch);
}

int gmds_incircle_wide(const double a[2], const double b[2], const double c[2], const double d[2])
{
  const double coordinates[] = {a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]};
  int grid = gmds_wide_grid(8, coordinates);
  wide x[8], minor, lift, scratch, det = {.sign = 0};
  for (int i = 0; i < 8; i++)
    gmds_wide_set(&x[i], coordinates[i], grid);
  for (int i = 0; i < 6; i++)
    gmds_wide_subtract(&x[i], &x[i], &x[6 + i % 2]);
  for (int i = 0; i < 6; i += 2) {
    wide_minor(&minor, &x[(i + 2) % 6], &x[(i + 4) % 6], &scratch);
    gmds_wide_multiply(&lift, &x[i], &x[i]);
    gmds_wide_multiply(&scratch, &x[i + 1], &x[i + 1]);
    gmds_wide_add(&lift, &lift, &scratch);
    gmds_wide_multiply(&scratch, &lift, &minor);
    gmds_wide_add(&det, &det, &scratch);
  }
  return det.sign;
}

int gmds_incircle_exact(const double a[2], const double b[2], const double c[2], const double d[2])
{
  int sign = gmds_incircle_lattice(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_incircle_extended(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_incircle_expansion(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_incircle_wide(a, b, c, d);
  return sign;
}

/* Of the points in lexicographic order the largest is perturbed most. Raising it out of its circle decides: outside
 * when it is d; else its perturbed lift enters the determinant with the minor of the other three, which is the
 * orientation of the triangle with d in its place, and where that is 0 the next largest decides. */
int gmds_incircle_perturbed_exact(const double a[2], const double b[2], const double c[2], const double d[2])
{
  int sign = gmds_incircle_exact(a, b, c, d);
  if (sign)
    return sign;
  const double *points[] = {a, b, c, d};
  int place[] = {0, 1, 2, 3};
  for (int last = 3; last > 0; last--) {
    int largest = last;
    for (int i = 0; i < last; i++) {
      int compare = gmds_compare_points(2, points[place[i]], points[place[largest]]);
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
    sign = gmds_orient2d(triangle[0], triangle[1], triangle[2]);
    if (sign)
      return sign;
  }
  return -1;
}
