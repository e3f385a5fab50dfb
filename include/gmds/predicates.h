/* Exact geometric predicates over all finite doubles, subnormals and the whole range of exponents included.
 *
 * Each takes pointers to the 2 or 3 coordinates of points and returns the sign, -1, 0 or 1, of the exact value. NaN and
 * infinity are the caller's to refuse. Nothing is allocated, no state is kept; safe from any thread.
 *
 * A call ends at the first stage that is certain of the sign. The floating-point filters are inline, here, and decide
 * all but degenerate and nearly degenerate calls for a dozen (orient2d), three dozen (incircle, orient3d) or ninety
 * (insphere) flops and one comparison. What they leave undecided goes to gmds_<predicate>_exact, compiled once in the
 * library: plain arithmetic where it is exact (lattices), expansions or integers of a few words, and integers of up to
 * 10502 bits.
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
 *   orient3d   3 differences, 1 product and 1 sum in the minor, 1 product, 1 sum                      k =  7
 *   insphere   5 differences, 1 product and 1 sum in a minor of two rows, 1 product and 2 sums in one
 *              of three, 1 product and 2 sums in the lift, 1 product, 1 sum                           k = 15
 * so |D - exact| <= k u (1 + k u) size. The sizes that are computed, and the bound from them, go through at most 12
 * roundings (the square of the cheap insphere bound 40). All of these terms of order u^2 are below k u 2^-46; the
 * constants are k u (1 + 2^-40).
 * (Shewchuk's error bounds A have the same k, and 16 for insphere, where the sum of four counts one addition more.
 * Meyer and Pion's, times the largest differences, are 8 u, 80 u, 46 u and 1123 u.)
 *
 * The sizes: orient2d |l| + |r|, its two products; incircle, tight, and orient3d the permanent; incircle, cheap,
 * AB + BC + CA for the three lifts A = |a - d|^2, ..., which is no smaller: by Cauchy and Schwarz a minor's |xy'| +
 * |x'y| <= sqrt(BC) <= (B + C) / 2. Insphere, tight, the permanent; insphere, cheap, sqrt(S^5 / 32) for the sum S = A +
 * B + C + D of the four lifts, which costs no absolute value and no root when squares are compared: the permanent of
 * three rows b, c, d is the sum over the axes i of |b_i| (|c_j d_k| + |c_k d_j|) <= |b_i| sqrt((C - c_i^2) (D -
 * d_i^2)), by Cauchy and Schwarz twice no more than sqrt(B) sqrt(3 CD - CD - CD + CD), sqrt(2 BCD). The size is then at
 * most sqrt(2 ABCD) (sqrt(A) + sqrt(B) + sqrt(C) + sqrt(D)), its square 2 ABCD (4 S), and ABCD <= (S / 4)^4.
 *
 * Underflow: differences never suffer from it. A product that does is wrong by at most n = 2^-1075. In orient2d that
 * is 2n, and a constant 2^-1040 in the bound covers it. In incircle the errors n of minors and lifts are multiplied by
 * a lift or a minor; t = 2^-500 added to lifts and minors of the size makes it larger by t times each of these and by
 * t^2, which times 10 u exceeds 2n times each of them, and 3n. Overflow: an infinite or NaN difference, product or lift
 * makes the size infinite or NaN, and the comparison fails; a sum of D can only overflow beside a finite size when what
 * is not in the sum is of order u.
 * In orient3d and in insphere, tight, t is added to every factor of every term of the size. An error n of a product is
 * multiplied by the factors that follow; the size has the same monomial with t for the product, or t^2 where the
 * product was one of two already, and t^3 beside 4n: with t = 2^-300, k u t^3 exceeds 4n and each is far larger than
 * the error. In insphere, cheap, t = 2^-180 is added to S: the errors are at most 60n times a monomial of degree m <= 3
 * in lengths below sqrt(S + t), and (S + t)^(5/2 - m/2) >= 2^-450 leaves them far below the bound, whose square, above
 * 2^-1010, does not underflow. Where the square is finite all differences are below 2^103, and nothing overflows. */
#define GMDS_ORIENT2D_BOUND (0x1.8p-52 * (1 + 0x1p-40))
#define GMDS_INCIRCLE_BOUND (0x1.4p-50 * (1 + 0x1p-40))
#define GMDS_ORIENT3D_BOUND (0x1.cp-51 * (1 + 0x1p-40))
#define GMDS_INSPHERE_BOUND (0x1.ep-50 * (1 + 0x1p-40))
/* The square of the cheap one's: (15 u)^2 / 32, times S^5. */
#define GMDS_INSPHERE_SQUARE (0x1.c2p-104 * (1 + 0x1p-39))

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

/* The sign of orient3d where `bound` times the size proves it, else 0. */
static inline int gmds_orient3d_bounded(const double a[3], const double b[3], const double c[3], const double d[3],
                                        double bound)
{
  double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  double det = az * (cxby - bxcy) + bz * (axcy - cxay) + cz * (bxay - axby);
  const double t = 0x1p-300;
  double size = (fabs(az) + t) * (fabs(bxcy) + fabs(cxby) + t) + (fabs(bz) + t) * (fabs(cxay) + fabs(axcy) + t) +
                (fabs(cz) + t) * (fabs(axby) + fabs(bxay) + t);
  if (fabs(det) > bound * size)
    return det > 0 ? 1 : -1;
  return 0;
}

/* The permanent of three rows whose first two columns have the products bc, ... in its minors; part of a size. */
static inline double gmds_insphere_minor(double az, double bc, double bz, double ac, double cz, double ab)
{
  const double t = 0x1p-300;
  return (fabs(az) + t) * (bc + t) + (fabs(bz) + t) * (ac + t) + (fabs(cz) + t) * (ab + t);
}

/* The sign of insphere where the cheap size, whose square is multiplied by `square`, or `tight` times the permanent
 * proves it, else 0. An infinite `square` or `tight` leaves its stage out. */
static inline int gmds_insphere_bounded(const double a[3], const double b[3], const double c[3], const double d[3],
                                        const double e[3], double square, double tight)
{
  double ax = a[0] - e[0], ay = a[1] - e[1], az = a[2] - e[2];
  double bx = b[0] - e[0], by = b[1] - e[1], bz = b[2] - e[2];
  double cx = c[0] - e[0], cy = c[1] - e[1], cz = c[2] - e[2];
  double dx = d[0] - e[0], dy = d[1] - e[1], dz = d[2] - e[2];
  double ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  double da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  double alift = ax * ax + ay * ay + az * az, blift = bx * bx + by * by + bz * bz;
  double clift = cx * cx + cy * cy + cz * cz, dlift = dx * dx + dy * dy + dz * dz;
  double abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
  double cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
  double det = (alift * bcd - blift * cda) + (clift * dab - dlift * abc);
  double s = alift + blift + clift + dlift + 0x1p-180, s2 = s * s;
  if (det * det > square * (s2 * s2 * s))
    return det > 0 ? 1 : -1;
  if (tight > 1)
    return 0;
  const double t = 0x1p-300;
  ab = fabs(ax * by) + fabs(bx * ay), bc = fabs(bx * cy) + fabs(cx * by), cd = fabs(cx * dy) + fabs(dx * cy);
  da = fabs(dx * ay) + fabs(ax * dy), ac = fabs(ax * cy) + fabs(cx * ay), bd = fabs(bx * dy) + fabs(dx * by);
  double permanent = (alift + t) * gmds_insphere_minor(bz, cd, cz, bd, dz, bc) +
                     (blift + t) * gmds_insphere_minor(cz, da, dz, ac, az, cd) +
                     (clift + t) * gmds_insphere_minor(dz, ab, az, bd, bz, da) +
                     (dlift + t) * gmds_insphere_minor(az, bc, bz, ac, cz, ab);
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

static inline int gmds_orient3d_filter(const double a[3], const double b[3], const double c[3], const double d[3])
{
  return gmds_orient3d_bounded(a, b, c, d, GMDS_ORIENT3D_BOUND);
}

/* By the cheap bound alone: the tight one, of what that leaves undecided, is among the exact stages. */
static inline int gmds_insphere_filter(const double a[3], const double b[3], const double c[3], const double d[3],
                                       const double e[3])
{
  return gmds_insphere_bounded(a, b, c, d, e, GMDS_INSPHERE_SQUARE, INFINITY);
}

/* Two doubles that are worked on at once. */
typedef double gmds_lanes __attribute__((vector_size(16)));

static inline gmds_lanes gmds_lanes_of(double first, double second)
{
  gmds_lanes x = {first, second};
  return x;
}

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
 * work of one call and a half. Bit k of the value is set where d lies inside the circle of triangle k for certain, bit
 * k of *undecided where the filter cannot tell, which it never can when a coordinate of that triangle is not a number.
 * */
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

/* The insphere filter of two tetrahedra and one point at a time, as gmds_incircle_filter_pair. */
static inline unsigned gmds_insphere_filter_pair(const double a0[3], const double b0[3], const double c0[3],
                                                 const double d0[3], const double a1[3], const double b1[3],
                                                 const double c1[3], const double d1[3], const double e[3],
                                                 unsigned *undecided)
{
  const gmds_lanes ex = {e[0], e[0]}, ey = {e[1], e[1]}, ez = {e[2], e[2]}, t = {0x1p-180, 0x1p-180}, zero = {0, 0};
  gmds_lanes ax = gmds_lanes_of(a0[0], a1[0]) - ex, ay = gmds_lanes_of(a0[1], a1[1]) - ey;
  gmds_lanes bx = gmds_lanes_of(b0[0], b1[0]) - ex, by = gmds_lanes_of(b0[1], b1[1]) - ey;
  gmds_lanes cx = gmds_lanes_of(c0[0], c1[0]) - ex, cy = gmds_lanes_of(c0[1], c1[1]) - ey;
  gmds_lanes dx = gmds_lanes_of(d0[0], d1[0]) - ex, dy = gmds_lanes_of(d0[1], d1[1]) - ey;
  gmds_lanes az = gmds_lanes_of(a0[2], a1[2]) - ez, bz = gmds_lanes_of(b0[2], b1[2]) - ez;
  gmds_lanes cz = gmds_lanes_of(c0[2], c1[2]) - ez, dz = gmds_lanes_of(d0[2], d1[2]) - ez;
  gmds_lanes ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  gmds_lanes da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  gmds_lanes alift = ax * ax + ay * ay + az * az, blift = bx * bx + by * by + bz * bz;
  gmds_lanes clift = cx * cx + cy * cy + cz * cz, dlift = dx * dx + dy * dy + dz * dz;
  gmds_lanes abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
  gmds_lanes cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
  gmds_lanes det = (alift * bcd - blift * cda) + (clift * dab - dlift * abc);
  gmds_lanes s = alift + blift + clift + dlift + t, s2 = s * s;
  *undecided = gmds_lanes_above(det * det, GMDS_INSPHERE_SQUARE * (s2 * s2 * s)) ^ 3;
  return gmds_lanes_above(det, zero) & ~*undecided;
}

/* The exact stages alone: what the functions below call when their filter leaves the sign undecided. */
int gmds_orient2d_exact(const double a[2], const double b[2], const double c[2]);
int gmds_incircle_exact(const double a[2], const double b[2], const double c[2], const double d[2]);
int gmds_incircle_perturbed_exact(const double a[2], const double b[2], const double c[2], const double d[2]);
int gmds_orient3d_exact(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_insphere_exact(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3]);
int gmds_insphere_perturbed_exact(const double a[3], const double b[3], const double c[3], const double d[3],
                                  const double e[3]);

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

/* The sign of (b - a) x (c - a) . (d - a): 1 when d lies above a, b, c, from where these turn counter-clockwise, and a,
 * b, c, d are a tetrahedron in the order of VTK; -1 below, 0 in their plane. */
static inline int gmds_orient3d(const double a[3], const double b[3], const double c[3], const double d[3])
{
  int sign = gmds_orient3d_filter(a, b, c, d);
  return sign ? sign : gmds_orient3d_exact(a, b, c, d);
}

/* For a, b, c, d with orient3d 1: 1 when e lies inside their sphere, -1 outside, 0 on it. */
static inline int gmds_insphere(const double a[3], const double b[3], const double c[3], const double d[3],
                                const double e[3])
{
  int sign = gmds_insphere_filter(a, b, c, d, e);
  return sign ? sign : gmds_insphere_exact(a, b, c, d, e);
}

/* As gmds_insphere, never 0, by the perturbation of gmds_incircle_perturbed. For a, b, c, d with orient3d 1; an e equal
 * to one of them is outside. */
static inline int gmds_insphere_perturbed(const double a[3], const double b[3], const double c[3], const double d[3],
                                          const double e[3])
{
  int sign = gmds_insphere_filter(a, b, c, d, e);
  return sign ? sign : gmds_insphere_perturbed_exact(a, b, c, d, e);
}

/* Points of one plane in space, which all of them must lie in exactly.
 *
 * gmds_coplanar_orientation: the turn of a, b, c as projected along the first axis, of z, x and y, that leaves anything
 * of the plane: 1 and -1 as long as all calls are about one plane, 0 when a, b, c lie on one line.
 * gmds_coplanar_side: for a, b, c not on one line, 1 when d lies on the side of the line ab that c is on, -1 on the
 * other side, 0 on the line.
 * gmds_coplanar_incircle: for a, b, c not on one line, in either order: 1 when d lies inside their circle, -1 outside,
 * 0 on it. The perturbed one is never 0; perturbed as gmds_incircle_perturbed. */
int gmds_coplanar_orientation(const double a[3], const double b[3], const double c[3]);
int gmds_coplanar_side(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_coplanar_incircle(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_coplanar_incircle_perturbed(const double a[3], const double b[3], const double c[3], const double d[3]);

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
