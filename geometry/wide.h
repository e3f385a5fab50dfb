/* Signed integers of up to 10560 bits on the stack: every finite double is a multiple of 2^-1074, so a determinant of
 * doubles is an integer on a grid common to its entries. Differences of coordinates take 2099 bits at most, their
 * products 4198, the determinant of four points in a plane 8401; in space minors of three rows take 6300, lifts 4200,
 * and the determinant of five points, below 72 times the fifth power of the differences, 10502.
 *
 * Numbers are as long as their value needs, and rows of zero limbs are skipped: points of like magnitude cost a few
 * dozen multiplications. */
#ifndef GMDS_GEOMETRY_WIDE_H
#define GMDS_GEOMETRY_WIDE_H

#include <stdint.h>

enum { WIDE_LIMBS = 330 };

/* sign times the sum of limb[i] 2^(32 i), i < n; limb[n - 1] is not 0; zero is sign 0 with n = 0. */
typedef struct wide {
  int sign, n;
  uint32_t limb[WIDE_LIMBS];
} wide;

/* The largest g such that all n doubles are multiples of 2^g (any g when all are 0). The doubles are finite. */
int gmds_wide_grid(int n, const double *x);

/* r = x / 2^grid, which must be an integer. */
void gmds_wide_set(wide *r, double x, int grid);

/* r = a b. r is neither a nor b. */
void gmds_wide_multiply(wide *r, const wide *a, const wide *b);

/* r = a + b and r = a - b. r may be a or b. */
void gmds_wide_add(wide *r, const wide *a, const wide *b);
void gmds_wide_subtract(wide *r, const wide *a, const wide *b);

#endif
