/* Numbers as text: exact in both directions, and nothing taken for a number that is none. */
#define _POSIX_C_SOURCE 200809L
#include "harness.h"
#include "number.h"
#include <locale.h>
#include <math.h>

static gmds_number parse(const char *text, double *x)
{
  return gmds_parse_double(text, strlen(text), x);
}

START_TEST(decimals_are_numbers)
{
  static const char *const texts[] = {"0",
                                      "-0",
                                      "+1",
                                      "1.",
                                      ".5",
                                      "1e5",
                                      "1E-5",
                                      "-1.25e+3",
                                      "00012",
                                      "1e-400",
                                      "4.9406564584124654e-324",
                                      "1.7976931348623157e308",
                                      "123456789012345678901234567890",
                                      "0.000000000000000000000000000000000000001",
                                      "9007199254740993",
                                      "1e22",
                                      "1e23"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    double x = 7, y = strtod(texts[i], NULL);
    ck_assert_msg(parse(texts[i], &x) == GMDS_NUMBER_OK, "%s", texts[i]);
    ck_assert_msg(!memcmp(&x, &y, sizeof x), "%s: %a, %a", texts[i], x, y);
  }
}
END_TEST

START_TEST(other_words_are_no_numbers)
{
  static const char *const texts[] = {"",      "-",    "+",     ".",     "e5",          "1e",   "1e+",
                                      "1.2.3", "0x10", "0x1p3", "1_000", "1,5",         "abc",  "1d5",
                                      "--1",   "1-",   " 1",    "1 ",    "infinite?no", "1e5.0"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    double x = 7;
    gmds_number result = parse(texts[i], &x);
    ck_assert_msg(result == GMDS_NUMBER_NONE || (texts[i][0] == 'i' && result == GMDS_NUMBER_NOT_FINITE), "'%s'",
                  texts[i]);
    ck_assert_double_eq(x, 7);
  }
}
END_TEST

START_TEST(what_is_not_finite_is_told_apart)
{
  static const char *const texts[] = {
      "nan", "NaN", "-nan", "nan(1)", "inf", "-Infinity", "1e309", "-1e999999999999999999", "1.#INF", "-1.#IND"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    double x = 7;
    ck_assert_msg(parse(texts[i], &x) == GMDS_NUMBER_NOT_FINITE, "%s", texts[i]);
  }
}
END_TEST

START_TEST(whole_numbers_do_not_overflow)
{
  uint64_t x = 7;
  ck_assert_int_eq(gmds_parse_count("18446744073709551615", 20, &x), GMDS_NUMBER_OK);
  ck_assert(x == UINT64_MAX);
  ck_assert_int_eq(gmds_parse_count("18446744073709551616", 20, &x), GMDS_NUMBER_TOO_LARGE);
  ck_assert_int_eq(gmds_parse_count("99999999999999999999999", 23, &x), GMDS_NUMBER_TOO_LARGE);
  ck_assert_int_eq(gmds_parse_count("-18446744073709551616", 21, &x), GMDS_NUMBER_NEGATIVE);
  ck_assert_int_eq(gmds_parse_count("-1", 2, &x), GMDS_NUMBER_NEGATIVE);
  ck_assert_int_eq(gmds_parse_count("-0", 2, &x), GMDS_NUMBER_OK);
  ck_assert_int_eq(gmds_parse_count("1.0", 3, &x), GMDS_NUMBER_NONE);
  ck_assert_int_eq(gmds_parse_count("", 0, &x), GMDS_NUMBER_NONE);
}
END_TEST

/* Any finite pattern of bits, whole numbers, short decimals: text and back is the identity, and so is the C library's
 * reading of the same text. */
START_TEST(printing_and_parsing_is_the_identity)
{
  uint64_t seed = 11;
  for (int i = 0; i < 300000; i++) {
    uint64_t bits = random_bits(&seed);
    double x, y = 0;
    memcpy(&x, &bits, sizeof x);
    if (i % 3 == 1)
      x = (double)(int64_t)bits;
    if (i % 3 == 2)
      x = (double)((int64_t)bits >> 40) / 1000;
    if (!isfinite(x))
      continue;
    char text[GMDS_DOUBLE_TEXT];
    size_t n = gmds_print_double(text, x);
    ck_assert_uint_eq(n, strlen(text));
    ck_assert_int_eq(gmds_parse_double(text, n, &y), GMDS_NUMBER_OK);
    double z = strtod(text, NULL);
    ck_assert_msg(!memcmp(&x, &y, sizeof x) && !memcmp(&x, &z, sizeof x), "%a: %s", x, text);
  }
}
END_TEST

RUN_SUITE("numbers", decimals_are_numbers, other_words_are_no_numbers, what_is_not_finite_is_told_apart,
          whole_numbers_do_not_overflow, printing_and_parsing_is_the_identity)
