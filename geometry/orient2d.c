/* The exact stages of orient2d, (a - c) x (b - c), after the filter in <gmds/predicates.h>.
 *
 * Cost on a 2.6 GHz core: 10 ns with exact differences, 60 ns as an expansion, 200 ns to some microseconds in
 * integers, by the span of the exponents. */
#include "expansion.h"
#include "stages.h"
#include "wide.h"
#include <gmds/predicates.h>

static int sign_of(double x)
{
  return (x > 0) - (x < 0);
}

/* A product of two doubles is a multiple of the product of their last places, at least 2^-53 of each: above 2^-1074
 * when the factors are above 2^-480, and so is a product of tails of coordinates above 2^-480. */
static const double least = 0x1p-480, most = 0x1p500;

int gmds_orient2d_products(const double a[2], const double b[2], const double c[2])
{
  pair acx = exact_difference(a[0], c[0]), bcy = exact_difference(b[1], c[1]);
  pair acy = exact_difference(a[1], c[1]), bcx = exact_difference(b[0], c[0]);
  const double highs[] = {acx.high, bcy.high, acy.high, bcx.high};
  if (!magnitudes_within(4, highs, least, most) || acx.low != 0 || bcy.low != 0 || acy.low != 0 || bcx.low != 0)
    return GMDS_UNDECIDED;
  pair l = exact_product(acx.high, bcy.high), r = exact_product(acy.high, bcx.high);
  /* Rounding is monotonic: highs that differ are in the order of the products. */
  return l.high != r.high ? sign_of(l.high - r.high) : sign_of(l.low - r.low);
}

/* h = x y for two pairs: 8 components at most. */
static int product(pair x, pair y, double h[8])
{
  const double e[] = {x.low, x.high};
  double low[4], high[4];
  int n_low = expansion_scale(2, e, y.low, low), n_high = expansion_scale(2, e, y.high, high);
  return expansion_sum(n_low, low, n_high, high, h);
}

int gmds_orient2d_expansion(const double a[2], const double b[2], const double c[2])
{
  const double coordinates[] = {a[0], a[1], b[0], b[1], c[0], c[1]};
  if (!magnitudes_within(6, coordinates, least, most))
    return GMDS_UNDECIDED;
  double l[8], r[8], det[16];
  int nl = product(exact_difference(a[0], c[0]), exact_difference(b[1], c[1]), l);
  int nr = product(exact_difference(c[1], a[1]), exact_difference(b[0], c[0]), r);
  return expansion_sign(expansion_sum(nl, l, nr, r, det), det);
}

int gmds_orient2d_wide(const double a[2], const double b[2], const double c[2])
{
  const double coordinates[] = {a[0], a[1], b[0], b[1], c[0], c[1]};
  int grid = gmds_wide_grid(6, coordinates);
  wide x[6], l, r;
  for (int i = 0; i < 6; i++)
    gmds_wide_set(&x[i], coordinates[i], grid);
  for (int i = 0; i < 4; i++)
    gmds_wide_subtract(&x[i], &x[i], &x[4 + i % 2]);
  gmds_wide_multiply(&l, &x[0], &x[3]);
  gmds_wide_multiply(&r, &x[1], &x[2]);
  gmds_wide_subtract(&l, &l, &r);
  return l.sign;
}

int gmds_orient2d_exact(const double a[2], const double b[2], const double c[2])
{
  int sign = gmds_orient2d_products(a, b, c);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_orient2d_expansion(a, b, c);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_orient2d_wide(a, b, c);
  return sign;
}
