/* Parsing and printing of numbers. Short decimals need one exact operation (Clinger 1990); the rest is the C library's,
 * which rounds correctly under the "C" locale. */
#include "number.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Longer than the longest exact decimal expansion of a double (1077 characters), with room for padding. */
enum { LONGEST_NUMBER = 4096 };

static int is_digit(char c)
{
  return c >= '0' && c <= '9';
}

/* The parts of a decimal number: the digits as an integer if there are at most 19 of them, and a power of ten. */
typedef struct decimal {
  int negative, digits;
  uint64_t mantissa;
  long exponent;
} decimal;

/* Skips the digits from i on, adding them to d. */
static size_t take_digits(const char *text, size_t n, size_t i, decimal *d)
{
  for (; i < n && is_digit(text[i]); i++) {
    if (d->digits || text[i] != '0')
      d->digits++;
    if (d->digits <= 19)
      d->mantissa = d->mantissa * 10 + (uint64_t)(text[i] - '0');
  }
  return i;
}

/* The exponent behind the `e` at i; beyond four digits its value no longer matters, only that it is large. */
static size_t take_exponent(const char *text, size_t n, size_t i, decimal *d)
{
  i++;
  int negative = i < n && text[i] == '-';
  if (i < n && (text[i] == '-' || text[i] == '+'))
    i++;
  long e = 0;
  size_t first = i;
  for (; i < n && is_digit(text[i]); i++)
    if (e < 100000)
      e = e * 10 + (text[i] - '0');
  d->exponent += negative ? -e : e;
  return i == first ? n + 1 : i;
}

/* Whether the text is [sign] digits [. digits] [e [sign] digits] with a digit before the e. */
static int scan_decimal(const char *text, size_t n, decimal *d)
{
  size_t i = n && (text[0] == '-' || text[0] == '+');
  *d = (decimal){.negative = n && text[0] == '-'};
  size_t first = i, point = 0;
  i = take_digits(text, n, i, d);
  if (i < n && text[i] == '.') {
    point = 1;
    size_t behind = i + 1;
    i = take_digits(text, n, behind, d);
    d->exponent = -(long)(i - behind);
  }
  if (i - first == point)
    return 0;
  if (i < n && (text[i] == 'e' || text[i] == 'E'))
    i = take_exponent(text, n, i, d);
  return i == n;
}

static int is_word(const char *text, size_t n, const char *word)
{
  size_t length = strlen(word);
  if (n < length)
    return 0;
  for (size_t i = 0; i < length; i++)
    if ((text[i] | 0x20) != word[i])
      return 0;
  return 1;
}

/* nan, inf and what C libraries print in their place: nan(...), -nan, infinity, 1.#INF, -1.#IND. */
static int is_not_finite(const char *text, size_t n)
{
  if (n && (*text == '-' || *text == '+'))
    text++, n--;
  return is_word(text, n, "nan") || is_word(text, n, "inf") || (n > 3 && !memcmp(text, "1.#", 3));
}

gmds_number gmds_parse_double(const char *text, size_t n, double *x)
{
  decimal d;
  if (n >= LONGEST_NUMBER || !scan_decimal(text, n, &d))
    return is_not_finite(text, n) ? GMDS_NUMBER_NOT_FINITE : GMDS_NUMBER_NONE;
#if FLT_EVAL_METHOD == 0
  if (d.digits <= 19 && d.mantissa <= (uint64_t)1 << 53 && d.exponent >= -22 && d.exponent <= 22) {
    static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    double m = (double)d.mantissa;
    m = d.exponent < 0 ? m / power[-d.exponent] : m * power[d.exponent];
    *x = d.negative ? -m : m;
    return GMDS_NUMBER_OK;
  }
#endif
  char copy[LONGEST_NUMBER]; /* strtod needs an end, which the last token of a file in memory has not */
  memcpy(copy, text, n);
  copy[n] = 0;
  char *end;
  double value = strtod(copy, &end);
  if (end != copy + n)
    return GMDS_NUMBER_NONE;
  if (!isfinite(value))
    return GMDS_NUMBER_NOT_FINITE;
  *x = value;
  return GMDS_NUMBER_OK;
}

gmds_number gmds_parse_count(const char *text, size_t n, uint64_t *x)
{
  size_t i = n && (text[0] == '-' || text[0] == '+');
  if (i == n)
    return GMDS_NUMBER_NONE;
  uint64_t value = 0;
  int overflow = 0;
  for (size_t k = i; k < n; k++) {
    if (!is_digit(text[k]))
      return GMDS_NUMBER_NONE;
    uint64_t digit = (uint64_t)(text[k] - '0');
    overflow |= value > (UINT64_MAX - digit) / 10;
    value = value * 10 + digit;
  }
  if (text[0] == '-' && (value || overflow))
    return GMDS_NUMBER_NEGATIVE;
  if (overflow)
    return GMDS_NUMBER_TOO_LARGE;
  *x = value;
  return GMDS_NUMBER_OK;
}

size_t gmds_print_double(char text[GMDS_DOUBLE_TEXT], double x)
{
  double back;
  int n = snprintf(text, GMDS_DOUBLE_TEXT, "%.15g", x);
  if (gmds_parse_double(text, (size_t)n, &back) != GMDS_NUMBER_OK || memcmp(&back, &x, sizeof x) != 0)
    n = snprintf(text, GMDS_DOUBLE_TEXT, "%.17g", x);
  return (size_t)n;
}
