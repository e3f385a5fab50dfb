/* Exact geometric predicates over all finite doubles, subnormals and the whole range of exponents included.
 *
 * Each takes pointers to 2 coordinates a point and returns the sign, -1, 0 or 1, of the exact value. NaN and infinity
 * are the caller's to refuse. Nothing is allocated, no state is kept; safe from any thread.
 *
 * A call ends at the first stage that is certain of the sign. The floating-point filters are inline, here, and decide
 * all but degenerate and nearly degenerate calls for a dozen (orient2d) or three dozen (incircle) flops and one
 * comparison. What they leave undecided goes to gmds_<predicate>_exact, compiled once in the library: plain arithmetic
 * where it is exact (lattices), expansions, and integers of up to 8400 bits.
 *
 * The filters stay valid where a compiler contracts a product and a sum into one operation, which only removes
 * roundings that the bounds allow for. They need rounding to nearest and no reassociation.
 *
 * Sources: Dekker 1971; Knuth, vol. 2, 4.2.2; Shewchuk 1997 (expansions, form of the bounds); Meyer and Pion 2008
 * (semi-static filters); Devillers and Teillaud 2011 (perturbation). */
#ifndef GMDS_PREDICATES_H
#define GMDS_PREDICATES_H

#if defined __cplusplus && __cplusplus < 201703L
#  error "gmds: <gmds/predicates.h> has hexadecimal constants: compile as C++17 or later"
#endif

#include <float.h>
#include <gmds/status.h>
#include <math.h>

#if defined __FAST_MATH__
#  error "gmds: exact predicates cannot be compiled with -ffast-math: leave the flag out for files that include this"
#endif
#if FLT_EVAL_METHOD != 0
#  error "gmds: exact predicates need doubles evaluated as doubles: on 32-bit x86 compile with -msse2 -mfpmath=sse"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The error bounds, with u = 2^-53.
 *
 * Let "size" be the sum of the absolute values of the monomials of the determinant in the rounded differences, and D
 * the sum whose last addition gives the computed determinant. That addition, rounded to nearest, keeps the sign of D,
 * so its own rounding does not count. Each monomial of D differs from the true one by a product of factors (1 + e) or
 * 1/(1 + e), |e| <= u, one for every other rounding on its way:
 *   orient2d   2 differences, 1 product                                                               k =  3
 *   incircle   4 differences, 1 product and 1 sum in the minor, the same in the lift, 1 product, 1 sum k = 10
 * so |D - exact| <= k u (1 + k u) size. The sizes that are computed, and the bound from them, go through at most 12
 * roundings. All of these terms of order u^2 are below k u 2^-48; the constants are k u (1 + 2^-40).
 * (Shewchuk's error bounds A have the same k. Meyer and Pion's, times the largest differences, are 8 u and 80 u.)
 *
 * The sizes: orient2d |l| + |r|, its two products; incircle, tight, the permanent; incircle, cheap, AB + BC + CA for
 * the three lifts A = |a - d|^2, ..., which is no smaller: by Cauchy and Schwarz a minor's |xy'| + |x'y| <= sqrt(BC)
 * <= (B + C) / 2.
 *
 * Underflow: differences never suffer from it. A product that does is wrong by at most n = 2^-1075. In orient2d that
 * is 2n, and a constant 2^-1040 in the bound covers it. In incircle the errors n of minors and lifts are multiplied by
 * a lift or a minor; t = 2^-500 added to lifts and minors of the size makes it larger by t times each of these and by
 * t^2, which times 10 u exceeds 2n times each of them, and 3n. Overflow: an infinite or NaN difference, product or lift
 * makes the size infinite or NaN, and the comparison fails; a sum of D can only overflow beside a finite size when what
 * is not in the sum is of order u. */
#define GMDS_ORIENT2D_BOUND (0x1.8p-52 * (1 + 0x1p-40))
#define GMDS_INCIRCLE_BOUND (0x1.4p-50 * (1 + 0x1p-40))

/* The sign of orient2d where `bound` times the size proves it, else 0. */
static inline int gmds_orient2d_bounded(const double a[2], const double b[2], const double c[2], double bound)
{
  double l = (a[0] - c[0]) * (b[1] - c[1]), r = (a[1] - c[1]) * (b[0] - c[0]), det = l - r;
  if (fabs(det) > bound * (fabs(l) + fabs(r)) + 0x1p-1040)
    return det > 0 ? 1 : -1;
  return 0;
}

/* The sign of incircle where `cheap` times the cheap size or `tight` times the permanent proves it, else 0. An infinite
 * `cheap` or `tight` leaves its stage out. */
static inline int gmds_incircle_bounded(const double a[2], const double b[2], const double c[2], const double d[2],
                                        double cheap, double tight)
{
  double ax = a[0] - d[0], ay = a[1] - d[1];
  double bx = b[0] - d[0], by = b[1] - d[1];
  double cx = c[0] - d[0], cy = c[1] - d[1];
  double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  double alift = ax * ax + ay * ay, blift = bx * bx + by * by, clift = cx * cx + cy * cy;
  double det = alift * (bxcy - cxby) + blift * (cxay - axcy) + clift * (axby - bxay);
  const double t = 0x1p-500;
  if (fabs(det) > cheap * (alift * blift + (clift + t) * (alift + blift + t)))
    return det > 0 ? 1 : -1;
  double permanent = (alift + t) * (fabs(bxcy) + fabs(cxby) + t) + (blift + t) * (fabs(cxay) + fabs(axcy) + t) +
                     (clift + t) * (fabs(axby) + fabs(bxay) + t);
  if (fabs(det) > tight * permanent)
    return det > 0 ? 1 : -1;
  return 0;
}

/* The sign where a filter is certain of it, else 0. */
static inline int gmds_orient2d_filter(const double a[2], const double b[2], const double c[2])
{
  return gmds_orient2d_bounded(a, b, c, GMDS_ORIENT2D_BOUND);
}

static inline int gmds_incircle_filter(const double a[2], const double b[2], const double c[2], const double d[2])
{
  return gmds_incircle_bounded(a, b, c, d, GMDS_INCIRCLE_BOUND, GMDS_INCIRCLE_BOUND);
}

/* Two doubles that are worked on at once. */
typedef double gmds_lanes __attribute__((vector_size(16)));

/* Bit k: whether x is above y in lane k. */
static inline unsigned gmds_lanes_above(gmds_lanes x, gmds_lanes y)
{
#if defined __SSE2__
  return (unsigned)__builtin_ia32_movmskpd((gmds_lanes)(x > y));
#else
  return (unsigned)(x[0] > y[0]) | (unsigned)(x[1] > y[1]) << 1;
#endif
}

/* The incircle filter of two triangles and one point at a time, in the lanes of vectors of two doubles: less than the
 * work of one call and a half. Bit k of the value is set where d lies inside the circle of triangle k for certain, bit k
 * of *undecided where the filter cannot tell, which it never can when a coordinate of that triangle is not a number. */
static inline unsigned gmds_incircle_filter_pair(const double a0[2], const double b0[2], const double c0[2],
                                                 const double a1[2], const double b1[2], const double c1[2],
                                                 const double d[2], unsigned *undecided)
{
  const gmds_lanes t = {0x1p-500, 0x1p-500};
  gmds_lanes ax = {a0[0] - d[0], a1[0] - d[0]}, ay = {a0[1] - d[1], a1[1] - d[1]};
  gmds_lanes bx = {b0[0] - d[0], b1[0] - d[0]}, by = {b0[1] - d[1], b1[1] - d[1]};
  gmds_lanes cx = {c0[0] - d[0], c1[0] - d[0]}, cy = {c0[1] - d[1], c1[1] - d[1]};
  gmds_lanes alift = ax * ax + ay * ay, blift = bx * bx + by * by, clift = cx * cx + cy * cy;
  gmds_lanes det = alift * (bx * cy - cx * by) + blift * (cx * ay - ax * cy) + clift * (ax * by - bx * ay);
  gmds_lanes bound = GMDS_INCIRCLE_BOUND * (alift * blift + (clift + t) * (alift + blift + t));
  unsigned inside = gmds_lanes_above(det, bound), outside = gmds_lanes_above(-det, bound);
  *undecided = (inside | outside) ^ 3;
  return inside;
}

/* The exact stages alone: what the functions below call when their filter leaves the sign undecided. */
int gmds_orient2d_exact(const double a[2], const double b[2], const double c[2]);
int gmds_incircle_exact(const double a[2], const double b[2], const double c[2], const double d[2]);
int gmds_incircle_perturbed_exact(const double a[2], const double b[2], const double c[2], const double d[2]);

/* 1 when a, b, c turn counter-clockwise, -1 clockwise, 0 when they lie on one line. */
static inline int gmds_orient2d(const double a[2], const double b[2], const double c[2])
{
  int sign = gmds_orient2d_filter(a, b, c);
  return sign ? sign : gmds_orient2d_exact(a, b, c);
}

/* For a, b, c counter-clockwise: 1 when d lies inside their circle, -1 outside, 0 on it. */
static inline int gmds_incircle(const double a[2], const double b[2], const double c[2], const double d[2])
{
  int sign = gmds_incircle_filter(a, b, c, d);
  return sign ? sign : gmds_incircle_exact(a, b, c, d);
}

/* As gmds_incircle, never 0: cocircular points are told apart by the symbolic perturbation that CGAL uses (Devillers
 * and Teillaud 2011; points in lexicographic order, the largest is perturbed most), which makes the Delaunay
 * triangulation of any points unique. For a, b, c counter-clockwise; a d equal to one of them is outside. */
static inline int gmds_incircle_perturbed(const double a[2], const double b[2], const double c[2], const double d[2])
{
  int sign = gmds_incircle_filter(a, b, c, d);
  return sign ? sign : gmds_incircle_perturbed_exact(a, b, c, d);
}

/* -1, 0, 1: lexicographic order of two points of `dim` coordinates; -0 and +0 are equal. */
static inline int gmds_compare_points(int dim, const double *a, const double *b)
{
  for (int k = 0; k < dim; k++)
    if (a[k] != b[k])
      return a[k] < b[k] ? -1 : 1;
  return 0;
}

/* Whether this build and this thread compute as the predicates assume: doubles round to nearest, products and sums are
 * not contracted, subnormals are not flushed. GMDS_OK or GMDS_ERR_PLATFORM. Algorithms call it once at their start. */
gmds_status gmds_predicates_check(void);

#ifdef __cplusplus
}
#endif
#endif
