/* Families of points that are hard for predicates in different ways. */
#ifndef GMDS_TESTS_FAMILIES_H
#define GMDS_TESTS_FAMILIES_H

#include <stdint.h>

/* X(name): fills four points; the first three serve orient2d, all four incircle. */
#define FAMILY_LIST(X)                                                                                \
  X(uniform)          /* in the unit square */                                                        \
  X(square_grid)      /* a small integer lattice, shifted and scaled by powers of two */              \
  X(decimal_grid)     /* a lattice whose coordinates were divided by 1000 */                          \
  X(lattice_circle)   /* cocircular integers of up to 30 bits: exact differences, inexact products */ \
  X(on_a_line)        /* nearly collinear, the last point moved by some units in the last place */    \
  X(on_a_circle)      /* nearly cocircular, the last point moved by some units in the last place */   \
  X(ulps_of_diagonal) /* next to a diagonal, in units in the last place */                            \
  X(mirrored)         /* exactly cocircular with 53-bit coordinates */                                \
  X(any_bits)         /* random bit patterns of finite doubles */                                     \
  X(any_exponents)    /* few digits, any exponents */                                                 \
  X(subnormals)       /* small multiples of the smallest number */                                    \
  X(subnormal_beside_normal)                                                                          \
  X(scaled_down)    /* nearly degenerate where products underflow */                                  \
  X(underflow_ties) /* products half way between two subnormals, digits of the differences lost */    \
  X(scaled_up)      /* nearly degenerate where products or differences overflow */                    \
  X(mixed_scales)   /* three far points and one near, or the other way round */

#define FAMILY_ENUM(name) family_##name,
enum { FAMILY_LIST(FAMILY_ENUM) family_count };
#undef FAMILY_ENUM

extern const char *const family_name[family_count];

/* Fills p with finite coordinates of four points. */
void family_fill(int family, uint64_t *seed, double p[8]);

#endif
