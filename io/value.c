/* Values of attributes. */
#include "value.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int gmds_value_is_real(gmds_value type)
{
  return type == GMDS_DOUBLE || type == GMDS_FLOAT;
}

int gmds_value_is_signed(gmds_value type)
{
  return type == GMDS_INT || type == GMDS_LONG;
}

/* The largest magnitude of a whole type, and that of its smallest number. */
static uint64_t largest(gmds_value type)
{
  switch (type) {
  case GMDS_INT:
    return INT32_MAX;
  case GMDS_LONG:
    return INT64_MAX;
  case GMDS_BYTE:
    return UINT8_MAX;
  default:
    return GMDS_ID_MAX;
  }
}

int gmds_value_put_whole(gmds_value type, void *at, int negative, uint64_t magnitude)
{
  uint64_t most = negative ? (gmds_value_is_signed(type) ? largest(type) + 1 : 0) : largest(type);
  if (magnitude > most)
    return 0;
  uint64_t bits = negative ? 0 - magnitude : magnitude;
  if (type == GMDS_INT) {
    int32_t x = (int32_t)bits;
    memcpy(at, &x, sizeof x);
  } else if (type == GMDS_LONG) {
    int64_t x = (int64_t)bits;
    memcpy(at, &x, sizeof x);
  } else if (type == GMDS_BYTE) {
    *(uint8_t *)at = (uint8_t)bits;
  } else {
    gmds_id x = (gmds_id)bits;
    memcpy(at, &x, sizeof x);
  }
  return 1;
}

void gmds_value_put_real(gmds_value type, void *at, double x)
{
  float f = (float)x;
  if (type == GMDS_FLOAT)
    memcpy(at, &f, sizeof f);
  else
    memcpy(at, &x, sizeof x);
}

uint64_t gmds_value_whole(gmds_value type, const void *at)
{
  int i;
  int64_t l;
  gmds_id id;
  switch (type) {
  case GMDS_INT:
    memcpy(&i, at, sizeof i);
    return (uint64_t)(int64_t)i;
  case GMDS_LONG:
    memcpy(&l, at, sizeof l);
    return (uint64_t)l;
  case GMDS_BYTE:
    return *(const uint8_t *)at;
  default:
    memcpy(&id, at, sizeof id);
    return id;
  }
}

double gmds_value_real(gmds_value type, const void *at)
{
  double d;
  float f;
  if (type == GMDS_DOUBLE) {
    memcpy(&d, at, sizeof d);
    return d;
  }
  if (type == GMDS_FLOAT) {
    memcpy(&f, at, sizeof f);
    return (double)f;
  }
  uint64_t bits = gmds_value_whole(type, at);
  return gmds_value_is_signed(type) ? (double)(int64_t)bits : (double)bits;
}

int gmds_value_is_double(gmds_value type, const void *at)
{
  if (gmds_value_is_real(type))
    return 1;
  uint64_t bits = gmds_value_whole(type, at);
  uint64_t magnitude = gmds_value_is_signed(type) && bits >> 63 ? 0 - bits : bits;
  return magnitude <= (uint64_t)1 << 53;
}

size_t gmds_print_value(char text[GMDS_DOUBLE_TEXT], gmds_value type, const void *at)
{
  if (!gmds_value_is_real(type)) {
    uint64_t bits = gmds_value_whole(type, at);
    int n = gmds_value_is_signed(type) ? snprintf(text, GMDS_DOUBLE_TEXT, "%" PRId64, (int64_t)bits)
                                       : snprintf(text, GMDS_DOUBLE_TEXT, "%" PRIu64, bits);
    return (size_t)n;
  }
  double x = gmds_value_real(type, at);
  if (!isfinite(x))
    return (size_t)snprintf(text, GMDS_DOUBLE_TEXT, "%s", isnan(x) ? "nan" : x > 0 ? "inf" : "-inf");
  if (type == GMDS_DOUBLE)
    return gmds_print_double(text, x);
  return (size_t)snprintf(text, GMDS_DOUBLE_TEXT, "%.9g", x);
}

/* nan and inf in their many spellings; a number beyond the largest double is infinite. */
static double not_finite(gmds_token token)
{
  int negative = *token.at == '-';
  for (size_t k = 0; k < token.n; k++)
    if ((token.at[k] | 0x20) == 'n' && (k + 1 == token.n || (token.at[k + 1] | 0x20) != 'f'))
      return (double)NAN; /* nan, -1.#IND; the n of inf has an f behind it */
  return negative ? -(double)INFINITY : (double)INFINITY;
}

gmds_status gmds_text_value(const gmds_text *text, gmds_token token, gmds_value type, void *at)
{
  if (gmds_value_is_real(type)) {
    double x;
    gmds_number result = gmds_parse_double(token.at, token.n, &x);
    if (result != GMDS_NUMBER_OK && result != GMDS_NUMBER_NOT_FINITE)
      return gmds_text_expected(text, "a number", token);
    gmds_value_put_real(type, at, result == GMDS_NUMBER_OK ? x : not_finite(token));
    return GMDS_OK;
  }
  int negative = token.n && *token.at == '-';
  uint64_t magnitude = 0;
  gmds_number result = gmds_parse_count(token.at + negative, token.n - (size_t)negative, &magnitude);
  if (result == GMDS_NUMBER_NONE || result == GMDS_NUMBER_NEGATIVE)
    return gmds_text_expected(text, "a whole number", token);
  if (result == GMDS_NUMBER_TOO_LARGE || !gmds_value_put_whole(type, at, negative, magnitude))
    return gmds_text_expected(text, "a whole number that its type holds", token);
  return GMDS_OK;
}

gmds_status gmds_text_next_value(gmds_text *text, gmds_value type, void *at)
{
  gmds_token token;
  gmds_text_next(text, &token);
  return gmds_text_value(text, token, type, at);
}
