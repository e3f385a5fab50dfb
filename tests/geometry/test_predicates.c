/* What the predicates promise, without an oracle: known signs, symmetries, published cases. */
#define _POSIX_C_SOURCE 200809L /* popen */
#include "harness.h"
#include <fenv.h>
#include <gmds/predicates.h>

#define TINY 0x1p-1074 /* the smallest double, 5e-324 */
#define HUGE_ONE 0x1.fffffffffffffp1023

typedef struct orient2d_case {
  double p[6];
  int sign;
} orient2d_case;

START_TEST(orient2d_knows_the_cases_that_broke_others)
{
  static const orient2d_case cases[] = {
      {{0, 0, 1, 0, 0, 1}, 1},
      {{0, 0, TINY, 0, 0, TINY}, 1}, /* products underflow to 0 */
      {{0, 0, 0, TINY, TINY, 0}, -1},
      {{TINY, TINY, 2 * TINY, 2 * TINY, 3 * TINY, 3 * TINY}, 0},
      {{0, 0, 1, TINY, 2, TINY}, -1}, /* 5e-324 beside 1 */
      {{0, 0, 1, TINY, 2, 2 * TINY}, 0},
      {{TINY, TINY, 1, 1, 2, 2}, 0},
      {{TINY, 0, 1, 1, 2, 2}, -1},
      {{0, 0, 1e-200, 1e-200, 2e-200, 2.0000000000000003e-200}, 1}, /* the bound underflows before the sign is lost */
      {{0, 0, HUGE_ONE, HUGE_ONE, -HUGE_ONE, -HUGE_ONE}, 0},        /* differences overflow */
      {{0, TINY, HUGE_ONE, HUGE_ONE, -HUGE_ONE, -HUGE_ONE}, -1},
      {{-HUGE_ONE, -HUGE_ONE, HUGE_ONE, -HUGE_ONE, 0, HUGE_ONE}, 1},
      {{1e300, 1e-300, -1e300, 1e-300, 0, 1e-300}, 0},
      {{-0.0, 0, 0, -0.0, 0, 0}, 0},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const double *p = cases[i].p;
    ck_assert_msg(gmds_orient2d(p, p + 2, p + 4) == cases[i].sign, "case %zu", i);
  }
}
END_TEST

typedef struct incircle_case {
  double p[8];
  int sign;
} incircle_case;

START_TEST(incircle_knows_the_cases_that_broke_others)
{
  static const incircle_case cases[] = {
      {{0, 0, 1, 0, 0, 1, 0.5, 0.5}, 1},
      {{0, 0, 1, 0, 0, 1, 1, 1}, 0},
      {{0, 0, TINY, 0, 0, TINY, TINY, TINY}, 0}, /* every product underflows to 0 */
      {{0, 0, 2 * TINY, 0, 0, 2 * TINY, TINY, TINY}, 1},
      {{0, 0, TINY, 0, 0, TINY, 2 * TINY, TINY}, -1},
      {{0, 0, 1, 0, 0, 1, 1, 1 + 0x1p-52}, -1},
      {{0, 0, 1, 0, 0, 1, TINY, TINY}, 1}, /* 5e-324 beside 1 */
      {{0, 0, 1, 0, 0, 1, -TINY, 0}, -1},
      {{0, 0, 1e-100, 0, 0, 1e-100, 1e-100, 1e-100}, 0},
      {{-HUGE_ONE, 0, HUGE_ONE, 0, 0, HUGE_ONE, 0, -HUGE_ONE}, 0},
      {{-HUGE_ONE, 0, HUGE_ONE, 0, 0, HUGE_ONE, TINY, -HUGE_ONE}, -1},
      {{-HUGE_ONE, -HUGE_ONE, HUGE_ONE, -HUGE_ONE, HUGE_ONE, HUGE_ONE, 0, 0}, 1},
      {{-1e300, 0, 1e300, 0, 0, 1e-300, 0, 0}, 1},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const double *p = cases[i].p;
    ck_assert_msg(gmds_incircle(p, p + 2, p + 4, p + 6) == cases[i].sign, "case %zu", i);
  }
}
END_TEST

/* Random points of four kinds: uniform, a small lattice, the same in subnormals, any bits. */
static void random_points(uint64_t *seed, size_t n, double *p)
{
  size_t kind = random_below(seed, 4);
  for (size_t i = 0; i < n; i++) {
    double lattice = (double)random_below(seed, 4);
    p[i] = kind == 0 ? random_unit(seed) : kind == 1 ? lattice : lattice * TINY;
    if (kind < 3)
      continue;
    do {
      uint64_t bits = random_bits(seed);
      memcpy(&p[i], &bits, sizeof bits);
    } while (!isfinite(p[i]));
  }
}

/* Calls visit for the permutation of order[0 .. n) that begins with its first `fixed` entries; parity is 1 or -1. */
static void permute(int fixed, int n, int *order, int parity, const double *p, int sign,
                    void (*visit)(const int *, int, const double *, int))
{
  if (fixed == n) {
    visit(order, parity, p, sign);
    return;
  }
  for (int i = fixed; i < n; i++) {
    int first = order[fixed];
    order[fixed] = order[i];
    order[i] = first;
    permute(fixed + 1, n, order, i == fixed ? parity : -parity, p, sign, visit);
    order[i] = order[fixed];
    order[fixed] = first;
  }
}

static void orient2d_alternates(const int *order, int parity, const double *p, int sign)
{
  ck_assert_int_eq(gmds_orient2d(p + 2 * order[0], p + 2 * order[1], p + 2 * order[2]), parity * sign);
}

static void incircle_alternates(const int *order, int parity, const double *p, int sign)
{
  ck_assert_int_eq(gmds_incircle(p + 2 * order[0], p + 2 * order[1], p + 2 * order[2], p + 2 * order[3]),
                   parity * sign);
}

START_TEST(signs_alternate_under_every_permutation)
{
  uint64_t seed = 21;
  for (int round = 0; round < 20000; round++) {
    double p[8];
    int order[] = {0, 1, 2, 3};
    random_points(&seed, 8, p);
    permute(0, 3, order, 1, p, gmds_orient2d(p, p + 2, p + 4), orient2d_alternates);
    permute(0, 4, order, 1, p, gmds_incircle(p, p + 2, p + 4, p + 6), incircle_alternates);
  }
}
END_TEST

START_TEST(the_perturbation_chooses_one_diagonal_of_every_cocircular_quadrilateral)
{
  uint64_t seed = 22;
  int ties = 0;
  for (int round = 0; round < 200000; round++) {
    double p[8];
    for (int i = 0; i < 8; i++)
      p[i] = (double)random_below(&seed, 5);
    const double *a = p, *b = p + 2, *c = p + 4, *d = p + 6;
    if (gmds_orient2d(a, b, c) <= 0 || gmds_orient2d(b, c, d) <= 0 || gmds_orient2d(c, d, a) <= 0 ||
        gmds_orient2d(d, a, b) <= 0)
      continue;
    int sign = gmds_incircle_perturbed(a, b, c, d);
    ck_assert_int_ne(sign, 0);
    ck_assert_int_eq(gmds_incircle_perturbed(b, c, a, d), sign);
    ck_assert_int_eq(gmds_incircle_perturbed(c, a, b, d), sign);
    ck_assert_int_eq(gmds_incircle_perturbed(c, d, a, b), sign);
    ck_assert_int_eq(gmds_incircle_perturbed(b, c, d, a), -sign);
    ck_assert_int_eq(gmds_incircle_perturbed(d, a, b, c), -sign);
    ties += gmds_incircle(a, b, c, d) == 0;
  }
  ck_assert_int_gt(ties, 1000);
}
END_TEST

START_TEST(a_corner_is_outside_its_own_perturbed_circle)
{
  static const double p[] = {0, 0, 2, 1, -1, 3};
  for (int i = 0; i < 3; i++)
    ck_assert_int_eq(gmds_incircle_perturbed(p, p + 2, p + 4, p + 2 * i), -1);
}
END_TEST

START_TEST(points_compare_lexicographically_and_zeros_are_equal)
{
  static const double a[] = {0.0, 1, 2}, b[] = {-0.0, 1, 3};
  ck_assert_int_eq(gmds_compare_points(2, a, b), 0);
  ck_assert_int_eq(gmds_compare_points(3, a, b), -1);
  ck_assert_int_eq(gmds_compare_points(3, b, a), 1);
  ck_assert_int_eq(gmds_compare_points(2, a + 1, a), 1);
}
END_TEST

START_TEST(another_rounding_mode_is_noticed)
{
  ck_assert_int_eq(gmds_predicates_check(), GMDS_OK);
#if defined FE_UPWARD && defined FE_DOWNWARD && defined FE_TOWARDZERO
  static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
    if (fesetround(modes[i]) != 0)
      continue;
    gmds_status status = gmds_predicates_check();
    fesetround(FE_TONEAREST);
    ck_assert_int_eq(status, GMDS_ERR_PLATFORM);
  }
#endif
  ck_assert_int_eq(gmds_predicates_check(), GMDS_OK);
}
END_TEST

#if defined __SSE2__
#  include <xmmintrin.h>

START_TEST(flushed_subnormals_are_noticed)
{
  const unsigned flush_results = 0x8000, flush_operands = 0x0040, before = _mm_getcsr();
  _mm_setcsr(before | flush_results);
  gmds_status results = gmds_predicates_check();
  _mm_setcsr(before | flush_operands);
  gmds_status operands = gmds_predicates_check();
  _mm_setcsr(before);
  ck_assert_int_eq(results, GMDS_ERR_PLATFORM);
  ck_assert_int_eq(operands, GMDS_ERR_PLATFORM);
}
END_TEST
#else
START_TEST(flushed_subnormals_are_noticed)
{
  printf("skipped, no known control register: flushed subnormals are noticed\n");
}
END_TEST
#endif

/* Opens a compressed file of the data folder, or returns NULL after a word. */
static FILE *open_cases(const char *name)
{
  const char *folder = data_folder(name);
  if (!folder)
    return NULL;
  char command[4096];
  snprintf(command, sizeof command, "xz -dc '%s/points/%s'", folder, name);
  return popen(command, "r");
}

/* Reads "index, n coordinates, sign"; 0 at the end of the file. */
static int read_case(FILE *file, int n, double *p, int *sign)
{
  char line[4096];
  if (!fgets(line, sizeof line, file))
    return 0;
  char *rest = line;
  (void)strtol(rest, &rest, 10);
  for (int i = 0; i < n; i++)
    p[i] = strtod(rest, &rest);
  *sign = (int)strtol(rest, &rest, 10);
  return 1;
}

START_TEST(orient2d_agrees_with_the_published_fixtures)
{
  FILE *file = open_cases("robust-predicates_orient2d.txt.xz");
  if (!file)
    return;
  double p[6];
  int sign, n = 0;
  for (; read_case(file, 6, p, &sign); n++)
    ck_assert_msg(gmds_orient2d(p, p + 2, p + 4) == sign, "line %d", n + 1);
  ck_assert_int_eq(pclose(file), 0);
  ck_assert_int_eq(n, 1000);
}
END_TEST

START_TEST(incircle_agrees_with_the_published_fixtures)
{
  FILE *file = open_cases("robust-predicates_incircle.txt.xz");
  if (!file)
    return;
  double p[8];
  int sign, n = 0;
  for (; read_case(file, 8, p, &sign); n++)
    ck_assert_msg(gmds_incircle(p, p + 2, p + 4, p + 6) == sign, "line %d", n + 1);
  ck_assert_int_eq(pclose(file), 0);
  ck_assert_int_eq(n, 1000);
}
END_TEST

RUN_SUITE("predicates", orient2d_knows_the_cases_that_broke_others, incircle_knows_the_cases_that_broke_others,
          signs_alternate_under_every_permutation,
          the_perturbation_chooses_one_diagonal_of_every_cocircular_quadrilateral,
          a_corner_is_outside_its_own_perturbed_circle, points_compare_lexicographically_and_zeros_are_equal,
          another_rounding_mode_is_noticed, flushed_subnormals_are_noticed, orient2d_agrees_with_the_published_fixtures,
          incircle_agrees_with_the_published_fixtures)
