/* The stages of the predicates after the filters, one function each, so that a test can walk through them and count.
 * Each returns the sign where it is certain of it, or GMDS_UNDECIDED; the last is always certain. */
#ifndef GMDS_GEOMETRY_STAGES_H
#define GMDS_GEOMETRY_STAGES_H

#include <math.h>

enum { GMDS_UNDECIDED = 2 };

/* For differences that are exact: their two products compared exactly. */
int gmds_orient2d_products(const double a[2], const double b[2], const double c[2]);

/* The differences with their tails as expansions. Undecided only where exponents are extreme. */
int gmds_orient2d_expansion(const double a[2], const double b[2], const double c[2]);

/* Integers on the common grid of the coordinates. Always decides. */
int gmds_orient2d_wide(const double a[2], const double b[2], const double c[2]);

/* For differences that are exact and small multiples of a power of two: the plain evaluation makes no error. */
int gmds_incircle_lattice(const double a[2], const double b[2], const double c[2], const double d[2]);

/* The filter in long doubles of 64 bits of precision, where there are such: what is nearly a tie and not one. */
int gmds_incircle_extended(const double a[2], const double b[2], const double c[2], const double d[2]);

/* For differences that are exact: the determinant as an expansion. Undecided also where exponents are extreme. */
int gmds_incircle_expansion(const double a[2], const double b[2], const double c[2], const double d[2]);

/* Integers on the common grid of the coordinates. Always decides. */
int gmds_incircle_wide(const double a[2], const double b[2], const double c[2], const double d[2]);

/* Whether each of n doubles is 0 or has its magnitude in [low, high]: what keeps expansions from under- and overflow.
 */
static inline int magnitudes_within(int n, const double *x, double low, double high)
{
  int within = 1;
  for (int i = 0; i < n; i++)
    within &= (x[i] == 0) | ((fabs(x[i]) >= low) & (fabs(x[i]) <= high));
  return within;
}

#endif
