/* What families of points are drawn from. */
#ifndef GMDS_TESTS_DRAW_H
#define GMDS_TESTS_DRAW_H

#include "harness.h"
#include <math.h>

static inline double integer_in(uint64_t *seed, int low, int high)
{
  return (double)low + (double)random_below(seed, (size_t)(high - low + 1));
}

/* x moved by `steps` units in the last place. */
static inline double moved(double x, int steps)
{
  for (; steps > 0; steps--)
    x = nextafter(x, INFINITY);
  for (; steps < 0; steps++)
    x = nextafter(x, -INFINITY);
  return x;
}

/* Moves the coordinates of point i by up to `most` units in the last place. */
static inline void move_point(uint64_t *seed, int dim, double *p, int i, int most)
{
  for (int k = 0; k < dim; k++)
    p[dim * i + k] = moved(p[dim * i + k], (int)integer_in(seed, -most, most));
}

static inline double finite_bits(uint64_t *seed)
{
  for (;;) {
    uint64_t bits = random_bits(seed);
    double x;
    memcpy(&x, &bits, sizeof x);
    if (isfinite(x))
      return x;
  }
}

#endif
