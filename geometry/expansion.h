/* Floating-point expansions: a number as the exact sum of doubles that do not overlap, smallest first (Dekker 1971;
 * Knuth, vol. 2, 4.2.2; Shewchuk 1997).
 *
 * Exact while nothing underflows and nothing overflows; callers check the exponents of what they start from. Needs
 * rounding to nearest and no contraction. */
#ifndef GMDS_GEOMETRY_EXPANSION_H
#define GMDS_GEOMETRY_EXPANSION_H

/* high + low is exact, and high is the rounded result. */
typedef struct pair {
  double high, low;
} pair;

static inline pair exact_sum(double a, double b)
{
  double x = a + b, b_part = x - a, a_part = x - b_part;
  return (pair){x, (a - a_part) + (b - b_part)};
}

/* As exact_sum, for |a| >= |b| or a = 0. */
static inline pair exact_sum_ordered(double a, double b)
{
  double x = a + b;
  return (pair){x, b - (x - a)};
}

static inline pair exact_difference(double a, double b)
{
  double x = a - b, b_part = a - x, a_part = x + b_part;
  return (pair){x, (a - a_part) + (b_part - b)};
}

/* The upper 26 bits and the rest (Dekker, Veltkamp); overflows from 2^996 on. */
static inline pair split(double a)
{
  double c = 0x1.0000002p27 * a, high = c - (c - a);
  return (pair){high, a - high};
}

static inline pair exact_product_split(double a, pair sa, double b, pair sb)
{
  double x = a * b;
  return (pair){x, ((sa.high * sb.high - x) + sa.high * sb.low + sa.low * sb.high) + sa.low * sb.low};
}

static inline pair exact_product(double a, double b)
{
  return exact_product_split(a, split(a), b, split(b));
}

/* h = e + b for n components of e; the value is how many non-zero components h has. h may be e (Shewchuk, fig. 7). */
static inline int expansion_add_double(int n, const double *e, double b, double *h)
{
  int m = 0;
  for (int i = 0; i < n; i++) {
    pair s = exact_sum(b, e[i]);
    if (s.low != 0)
      h[m++] = s.low;
    b = s.high;
  }
  if (b != 0)
    h[m++] = b;
  return m;
}

/* h = e + f, with room for ne + nf components; the value is how many non-zero components h has. One merge by magnitude
 * and one carry through it (Shewchuk, fig. 8: for expansions that do not overlap, rounding to even). */
static inline int expansion_sum(int ne, const double *e, int nf, const double *f, double *h)
{
  int i = 0, j = 0, m = 0;
  double carry = 0;
  while (i < ne || j < nf) {
    double next;
    if (j == nf || (i < ne && (f[j] > e[i]) == (f[j] > -e[i])))
      next = e[i++];
    else
      next = f[j++];
    pair s = exact_sum(carry, next);
    if (s.low != 0)
      h[m++] = s.low;
    carry = s.high;
  }
  if (carry != 0)
    h[m++] = carry;
  return m;
}

/* h = b e, with room for 2n components; the value is how many non-zero components h has (Shewchuk, fig. 13). */
static inline int expansion_scale(int n, const double *e, double b, double *h)
{
  int m = 0;
  if (n == 0)
    return 0;
  pair sb = split(b), p = exact_product_split(e[0], split(e[0]), b, sb);
  double carry = p.high;
  if (p.low != 0)
    h[m++] = p.low;
  for (int i = 1; i < n; i++) {
    p = exact_product_split(e[i], split(e[i]), b, sb);
    pair s = exact_sum(carry, p.low);
    if (s.low != 0)
      h[m++] = s.low;
    s = exact_sum_ordered(p.high, s.high);
    if (s.low != 0)
      h[m++] = s.low;
    carry = s.high;
  }
  if (carry != 0)
    h[m++] = carry;
  return m;
}

/* The sign of an expansion: that of its largest component. */
static inline int expansion_sign(int n, const double *e)
{
  return n == 0 ? 0 : (e[n - 1] > 0) - (e[n - 1] < 0);
}

#endif
