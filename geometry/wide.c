/* Signed integers on the stack; see wide.h. Schoolbook arithmetic (Knuth, vol. 2, 4.3.1) in limbs of 32 bits, whose
 * products and carries fit 64 bits in standard C. */
#include "wide.h"
#include <string.h>

/* |x| as mantissa 2^exponent, the mantissa an integer below 2^53. */
static uint64_t mantissa(double x, int *exponent)
{
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  int biased = (int)(bits >> 52 & 0x7ff);
  bits &= ((uint64_t)1 << 52) - 1;
  *exponent = biased ? biased - 1075 : -1074;
  return biased ? bits | (uint64_t)1 << 52 : bits;
}

/* The number of trailing zero bits: a power of two below 2^53 converts exactly, its exponent is the answer. */
static int trailing_zeros(uint64_t m)
{
  int exponent;
  (void)mantissa((double)(m & (0 - m)), &exponent);
  return exponent + 52;
}

int gmds_wide_grid(int n, const double *x)
{
  int grid = 1024;
  for (int i = 0; i < n; i++) {
    int exponent;
    uint64_t m = mantissa(x[i], &exponent);
    if (m && exponent < grid) {
      exponent += trailing_zeros(m);
      if (exponent < grid)
        grid = exponent;
    }
  }
  return grid;
}

static void trim(wide *r)
{
  while (r->n && r->limb[r->n - 1] == 0)
    r->n--;
  if (r->n == 0)
    r->sign = 0;
}

void gmds_wide_set(wide *r, double x, int grid)
{
  int exponent;
  uint64_t m = mantissa(x, &exponent);
  r->n = r->sign = 0;
  if (m == 0)
    return;
  if (exponent < grid) {
    m >>= grid - exponent;
    exponent = grid;
  }
  int zeros = (exponent - grid) / 32, shift = (exponent - grid) % 32;
  uint64_t low = (m & UINT32_MAX) << shift, high = (m >> 32 << shift) + (low >> 32);
  memset(r->limb, 0, (size_t)zeros * sizeof *r->limb);
  r->limb[zeros] = (uint32_t)low;
  r->limb[zeros + 1] = (uint32_t)high;
  r->limb[zeros + 2] = (uint32_t)(high >> 32);
  r->n = zeros + 3;
  r->sign = x > 0 ? 1 : -1;
  trim(r);
}

void gmds_wide_multiply(wide *r, const wide *a, const wide *b)
{
  r->sign = a->sign * b->sign;
  r->n = r->sign ? a->n + b->n : 0;
  memset(r->limb, 0, (size_t)r->n * sizeof *r->limb);
  if (r->n == 0)
    return;
  for (int i = 0; i < a->n; i++) {
    uint64_t factor = a->limb[i], carry = 0;
    if (factor == 0)
      continue;
    for (int j = 0; j < b->n; j++) {
      carry += r->limb[i + j] + factor * b->limb[j];
      r->limb[i + j] = (uint32_t)carry;
      carry >>= 32;
    }
    r->limb[i + b->n] = (uint32_t)carry;
  }
  trim(r);
}

static int compare_magnitudes(const wide *a, const wide *b)
{
  if (a->n != b->n)
    return a->n < b->n ? -1 : 1;
  for (int i = a->n - 1; i >= 0; i--)
    if (a->limb[i] != b->limb[i])
      return a->limb[i] < b->limb[i] ? -1 : 1;
  return 0;
}

/* |r| = |a| + |b| for a at least as long as b. */
static void add_magnitudes(wide *r, const wide *a, const wide *b)
{
  uint64_t carry = 0;
  int n = a->n;
  for (int i = 0; i < n; i++) {
    carry += (uint64_t)a->limb[i] + (i < b->n ? b->limb[i] : 0);
    r->limb[i] = (uint32_t)carry;
    carry >>= 32;
  }
  if (carry)
    r->limb[n++] = (uint32_t)carry;
  r->n = n;
}

/* |r| = |a| - |b| for |a| >= |b|. */
static void subtract_magnitudes(wide *r, const wide *a, const wide *b)
{
  uint64_t borrow = 0;
  int n = a->n;
  for (int i = 0; i < n; i++) {
    uint64_t x = (uint64_t)a->limb[i] - (i < b->n ? b->limb[i] : 0) - borrow;
    r->limb[i] = (uint32_t)x;
    borrow = x >> 63;
  }
  r->n = n;
}

/* r = a + b with the sign of b replaced. */
static void combine(wide *r, const wide *a, const wide *b, int sign_b)
{
  int compare = compare_magnitudes(a, b), sign = compare < 0 ? sign_b : a->sign;
  const wide *larger = compare < 0 ? b : a, *smaller = compare < 0 ? a : b;
  if (a->sign == -sign_b)
    subtract_magnitudes(r, larger, smaller);
  else
    add_magnitudes(r, larger, smaller);
  r->sign = sign;
  trim(r);
}

void gmds_wide_add(wide *r, const wide *a, const wide *b)
{
  combine(r, a, b, b->sign);
}

void gmds_wide_subtract(wide *r, const wide *a, const wide *b)
{
  combine(r, a, b, -b->sign);
}
