/* Families of points in space that are hard for predicates in different ways. */
#ifndef GMDS_TESTS_FAMILIES3_H
#define GMDS_TESTS_FAMILIES3_H

#include <stdint.h>

/* X(name): fills five points; the first four serve orient3d, all five insphere. */
#define FAMILY3_LIST(X)                                                                                    \
  X(uniform)          /* in the unit cube */                                                               \
  X(cubic_grid)       /* a small integer lattice, shifted and scaled by powers of two */                   \
  X(decimal_grid)     /* a lattice whose coordinates were divided by 1000 */                               \
  X(lattice_sphere)   /* cospherical integers of up to 30 bits: exact differences, inexact products */     \
  X(on_a_plane)       /* nearly coplanar, one point moved by some units in the last place */               \
  X(on_a_sphere)      /* nearly cospherical, the last point moved by some units in the last place */       \
  X(on_a_circle)      /* all nearly on one circle of a sphere */                                           \
  X(above_a_circle)   /* four nearly on one circle, the last near its axis: lifts that are nearly equal */ \
  X(ulps_of_diagonal) /* next to a diagonal plane, in units in the last place */                           \
  X(mirrored)         /* exactly cospherical with 53-bit coordinates */                                    \
  X(any_bits)         /* random bit patterns of finite doubles */                                          \
  X(any_exponents)    /* few digits, any exponents */                                                      \
  X(subnormals)       /* small multiples of the smallest number */                                         \
  X(subnormal_beside_normal)                                                                               \
  X(scaled_down)    /* nearly degenerate where products underflow */                                       \
  X(underflow_ties) /* products half way between two subnormals, digits of the differences lost */         \
  X(scaled_up)      /* nearly degenerate where products or differences overflow */                         \
  X(mixed_scales)   /* far points and near ones of one sphere */

#define FAMILY3_ENUM(name) family3_##name,
enum { FAMILY3_LIST(FAMILY3_ENUM) family3_count };
#undef FAMILY3_ENUM

extern const char *const family3_name[family3_count];

/* Fills p with finite coordinates of five points. */
void family3_fill(int family, uint64_t *seed, double p[15]);

#endif
