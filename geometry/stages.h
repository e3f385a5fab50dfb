/* The stages of the predicates after the filters, one function each, so that a test can walk through them and count.
 * Each returns the sign where it is certain of it, or GMDS_UNDECIDED; the last is always certain. */
#ifndef GMDS_GEOMETRY_STAGES_H
#define GMDS_GEOMETRY_STAGES_H

#include "expansion.h"
#include <float.h>
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

/* As those of incircle, but in the words of words.h, undecided where exponents differ much, instead of expansions. */
int gmds_orient3d_lattice(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_orient3d_words(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_orient3d_extended(const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_orient3d_wide(const double a[3], const double b[3], const double c[3], const double d[3]);

int gmds_insphere_lattice(const double a[3], const double b[3], const double c[3], const double d[3],
                          const double e[3]);
int gmds_insphere_words(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3]);
int gmds_insphere_extended(const double a[3], const double b[3], const double c[3], const double d[3],
                           const double e[3]);
int gmds_insphere_wide(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3]);

/* The stages of the determinant that decides in the plane of four points, projected to the axes u and v; see
 * coplanar.c.
 */
int gmds_coplanar_filter(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_coplanar_lattice(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_coplanar_words(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3]);
int gmds_coplanar_wide(int u, int v, const double a[3], const double b[3], const double c[3], const double d[3]);

/* The differences of three coordinates of n points from those of `last`. The value is whether all are exact. */
static inline int differences_3(int n, const double *const *from, const double last[3], double *delta)
{
  int exact = 1;
  for (int i = 0; i < n; i++)
    for (int k = 0; k < 3; k++) {
      pair p = exact_difference(from[i][k], last[k]);
      delta[3 * i + k] = p.high;
      exact &= p.low == 0;
    }
  return exact;
}

/* Whether n doubles are integers below 2^bits times one power of two, and the largest of them in [low, high]. `spare`
 * is 2^(54 - bits): multiples of g = 2^(e - bits), for 2^(e-1) <= largest < 2^e, are what no digit is lost of when they
 * are added to spare times the largest. */
static inline int on_lattice(int n, const double *delta, double spare, double low, double high)
{
  double largest = 0;
  for (int i = 0; i < n; i++)
    largest = fabs(delta[i]) > largest ? fabs(delta[i]) : largest;
  double shift = spare * largest;
  int within = (largest >= low) & (largest <= high);
  for (int i = 0; i < n; i++)
    within &= (delta[i] + shift) - shift == delta[i];
  return within;
}

#if LDBL_MANT_DIG == 64
/* Whether long doubles have the precision that they are said to have: emulators (valgrind's among them) and a changed
 * control word of the processor may give less. */
static inline int extended_is_extended(void)
{
  volatile long double one = 1, small = 0x1p-63L;
  return one + small != one;
}
#endif

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
