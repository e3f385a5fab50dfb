/* Determinants of differences in integers of a fixed number of 64-bit words: what is nearly degenerate, or is so with
 * more digits than a lattice has, for points whose differences are of like magnitude. Ten times as fast as expansions
 * and as integers of any length; only for compilers that multiply two words.
 *
 * Differences of coordinates are taken exactly, as a double and its tail, and are multiples of g = 2^(e - 60) where the
 * largest is below 2^e: integers below 2^61 with the tail. Minors of two rows are then below 2^123, of three 6 2^183,
 * lifts 3 2^122, and the determinant of insphere below 72 2^305: 128, 192, 128 and 320 bits hold them with their sign.
 * */
#ifndef GMDS_GEOMETRY_WORDS_H
#define GMDS_GEOMETRY_WORDS_H

#include "expansion.h"
#include <math.h>
#include <stdint.h>

#if defined __SIZEOF_INT128__
__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

/* high 2^64 + low. */
typedef struct words3 {
  int128 high;
  uint64_t low;
} words3;

/* The differences of n points from `last` over g. The value is whether all are integers. */
static inline int integer_differences(int n, const double *const *from, const double last[3], int64_t *delta)
{
  pair exact[12];
  double largest = 0;
  for (int i = 0; i < 3 * n; i++) {
    exact[i] = exact_difference(from[i / 3][i % 3], last[i % 3]);
    largest = fabs(exact[i].high) > largest ? fabs(exact[i].high) : largest;
  }
  if (!(largest >= 0x1p-900 && largest <= 0x1p900))
    return 0;
  int exponent, integers = 1;
  (void)frexp(largest, &exponent);
  const double scale = ldexp(1, 60 - exponent), g = ldexp(1, exponent - 60);
  for (int i = 0; i < 3 * n; i++) {
    int64_t h = (int64_t)(exact[i].high * scale), l = (int64_t)(exact[i].low * scale);
    integers &= ((double)h * g == exact[i].high) & ((double)l * g == exact[i].low);
    delta[i] = h + l;
  }
  return integers;
}

static inline words3 words_product(int128 a, int64_t b)
{
  int128 low = (int128)(uint64_t)a * b;
  return (words3){(int128)(int64_t)(a >> 64) * b + (low >> 64), (uint64_t)low};
}

static inline words3 words_sum(words3 a, words3 b)
{
  uint64_t low = a.low + b.low;
  return (words3){a.high + b.high + (low < a.low), low};
}

static inline int128 words_minor(const int64_t p[3], const int64_t q[3])
{
  return (int128)p[0] * q[1] - (int128)p[1] * q[0];
}

/* The determinant of three rows, p x q . r. */
static inline words3 words_determinant(const int64_t p[3], const int64_t q[3], const int64_t r[3])
{
  words3 sum = words_product(words_minor(q, r), p[2]);
  sum = words_sum(sum, words_product(words_minor(r, p), q[2]));
  return words_sum(sum, words_product(words_minor(p, q), r[2]));
}

static inline int words_sign(words3 a)
{
  return a.high < 0 ? -1 : a.high > 0 || a.low > 0;
}

/* sum += |p|^2 determinant, or minus that. */
static inline void words_add_lifted(uint64_t sum[5], const int64_t p[3], words3 determinant, int minus)
{
  uint128 lift = (uint128)((int128)p[0] * p[0] + (int128)p[1] * p[1] + (int128)p[2] * p[2]), carry = 0;
  if (determinant.high < 0) { /* its magnitude: all bits inverted, and one more */
    minus = !minus;
    determinant.low = 0 - determinant.low;
    determinant.high = ~determinant.high + (determinant.low == 0);
  }
  const uint64_t factor[2] = {(uint64_t)lift, (uint64_t)(lift >> 64)};
  const uint64_t of[3] = {determinant.low, (uint64_t)determinant.high, (uint64_t)(determinant.high >> 64)};
  uint64_t product[5] = {0};
  for (int i = 0; i < 2; i++, carry = 0) {
    for (int j = 0; j < 3; j++) {
      carry += product[i + j] + (uint128)factor[i] * of[j];
      product[i + j] = (uint64_t)carry;
      carry >>= 64;
    }
    product[i + 3] = (uint64_t)carry;
  }
  carry = minus != 0;
  for (int i = 0; i < 5; i++) {
    carry += (uint128)sum[i] + (minus ? ~product[i] : product[i]);
    sum[i] = (uint64_t)carry;
    carry >>= 64;
  }
}

static inline int words_sum_sign(const uint64_t sum[5])
{
  return sum[4] >> 63 ? -1 : (sum[0] | sum[1] | sum[2] | sum[3] | sum[4]) != 0;
}
#endif

#endif
