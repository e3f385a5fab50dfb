/* The exact stages of orient3d after the filter in <gmds/predicates.h>: the sign of
 *
 *   -((a - d) . (b - d) x (c - d)),   which is (b - a) x (c - a) . (d - a).
 *
 * Cost: 20 ns on a lattice or in long doubles, 40 ns in words, 250 to 500 ns in integers of points of like
 * magnitude, some microseconds for any exponents. */
#include "stages.h"
#include "wide.h"
#include "words.h"
#include <gmds/predicates.h>

int gmds_orient3d_lattice(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const from[] = {a, b, c};
  double delta[9];
  /* Integers below 2^16 times g: minors are integers below 2^33 times g^2, the sum one below 6 2^48 times g^3. */
  if (!differences_3(3, from, d, delta) || !on_lattice(9, delta, 0x1p38, 0x1p-300, 0x1p300))
    return GMDS_UNDECIDED;
  const double *p = delta, *q = delta + 3, *r = delta + 6;
  double det =
      p[2] * (r[0] * q[1] - q[0] * r[1]) + q[2] * (p[0] * r[1] - r[0] * p[1]) + r[2] * (q[0] * p[1] - p[0] * q[1]);
  return (det > 0) - (det < 0);
}

#if defined __SIZEOF_INT128__
int gmds_orient3d_words(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const from[] = {a, b, c};
  int64_t x[9];
  if (!integer_differences(3, from, d, x))
    return GMDS_UNDECIDED;
  return -words_sign(words_determinant(x, x + 3, x + 6));
}
#else
int gmds_orient3d_words(const double a[3], const double b[3], const double c[3], const double d[3])
{
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  return GMDS_UNDECIDED;
}
#endif

#if LDBL_MANT_DIG == 64
int gmds_orient3d_extended(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const long double dx = d[0], dy = d[1], dz = d[2];
  const long double ax = a[0] - dx, ay = a[1] - dy, az = a[2] - dz, bx = b[0] - dx, by = b[1] - dy, bz = b[2] - dz;
  const long double cx = c[0] - dx, cy = c[1] - dy, cz = c[2] - dz;
  const long double det = az * (cx * by - bx * cy) + bz * (ax * cy - cx * ay) + cz * (bx * ay - ax * by);
  const long double alift = ax * ax + ay * ay + az * az, blift = bx * bx + by * by + bz * bz;
  const long double clift = cx * cx + cy * cy + cz * cz;
  /* The size is at most sqrt(2 ABC) for the squared lengths A, B, C of the rows, as <gmds/predicates.h> has it of the
   * minors of insphere; k = 7, u = 2^-64. Long doubles hold the sixth power of any difference of doubles. */
  const long double bound = 0x1.88p-123L * (1 + 0x1p-39L) * (2 * alift * blift * clift);
  if (!(det * det > bound) || !extended_is_extended())
    return GMDS_UNDECIDED;
  return det > 0 ? 1 : -1;
}
#else
int gmds_orient3d_extended(const double a[3], const double b[3], const double c[3], const double d[3])
{
  (void)a;
  (void)b;
  (void)c;
  (void)d;
  return GMDS_UNDECIDED;
}
#endif

int gmds_orient3d_wide(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double *const points[] = {a, b, c, d};
  double coordinates[12];
  for (int i = 0; i < 12; i++)
    coordinates[i] = points[i / 3][i % 3];
  int grid = gmds_wide_grid(12, coordinates);
  wide x[12], minor, scratch, det = {.sign = 0};
  for (int i = 0; i < 12; i++)
    gmds_wide_set(&x[i], coordinates[i], grid);
  for (int i = 0; i < 9; i++)
    gmds_wide_subtract(&x[i], &x[i], &x[9 + i % 3]);
  for (int i = 0; i < 9; i += 3) {
    const wide *q = &x[(i + 3) % 9], *r = &x[(i + 6) % 9];
    gmds_wide_multiply(&minor, &r[0], &q[1]);
    gmds_wide_multiply(&scratch, &q[0], &r[1]);
    gmds_wide_subtract(&minor, &minor, &scratch);
    gmds_wide_multiply(&scratch, &x[i + 2], &minor);
    gmds_wide_add(&det, &det, &scratch);
  }
  return det.sign;
}

int gmds_orient3d_exact(const double a[3], const double b[3], const double c[3], const double d[3])
{
  int sign = gmds_orient3d_lattice(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_orient3d_words(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_orient3d_extended(a, b, c, d);
  if (sign == GMDS_UNDECIDED)
    sign = gmds_orient3d_wide(a, b, c, d);
  return sign;
}
