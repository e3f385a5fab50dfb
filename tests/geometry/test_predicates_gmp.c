/* The predicates, stage by stage, against the integers of GMP. */
#include "families.h"
#include "harness.h"
#include <float.h>
#include <geometry/stages.h>
#include <gmds/predicates.h>
#include <gmp.h>

/* z = x / 2^grid. */
static void set_scaled(mpz_t z, double x, int grid)
{
  int exponent;
  double fraction = frexp(x, &exponent);
  mpz_set_d(z, ldexp(fraction, 53));
  if (x != 0)
    mpz_mul_2exp(z, z, (mp_bitcnt_t)(exponent - 53 - grid));
}

/* The coordinates of n points on a common grid, relative to the last point. */
static void differences(int n, mpz_t *z, const double *p)
{
  int grid = 1024;
  for (int i = 0; i < 2 * n; i++) {
    int exponent;
    (void)frexp(p[i], &exponent);
    if (p[i] != 0 && exponent - 53 < grid)
      grid = exponent - 53;
  }
  for (int i = 0; i < 2 * n; i++)
    set_scaled(z[i], p[i], grid);
  for (int i = 0; i < 2 * n - 2; i++)
    mpz_sub(z[i], z[i], z[2 * n - 2 + i % 2]);
}

typedef struct oracle {
  mpz_t z[8], minor, lift, sum;
} oracle;

static void oracle_init(oracle *o)
{
  for (int i = 0; i < 8; i++)
    mpz_init(o->z[i]);
  mpz_inits(o->minor, o->lift, o->sum, NULL);
}

static void oracle_clear(oracle *o)
{
  for (int i = 0; i < 8; i++)
    mpz_clear(o->z[i]);
  mpz_clears(o->minor, o->lift, o->sum, NULL);
}

static int exact_orient2d(oracle *o, const double *p)
{
  differences(3, o->z, p);
  mpz_mul(o->sum, o->z[0], o->z[3]);
  mpz_submul(o->sum, o->z[1], o->z[2]);
  return mpz_sgn(o->sum);
}

static int exact_incircle(oracle *o, const double *p)
{
  differences(4, o->z, p);
  mpz_set_ui(o->sum, 0);
  for (int i = 0; i < 3; i++) {
    mpz_t *a = o->z + 2 * i, *b = o->z + 2 * ((i + 1) % 3), *c = o->z + 2 * ((i + 2) % 3);
    mpz_mul(o->minor, b[0], c[1]);
    mpz_submul(o->minor, b[1], c[0]);
    mpz_mul(o->lift, a[0], a[0]);
    mpz_addmul(o->lift, a[1], a[1]);
    mpz_addmul(o->sum, o->minor, o->lift);
  }
  return mpz_sgn(o->sum);
}

/* The stages in their order. A filter says 0 where it does not know. */
enum { orient2d_stages = 4, incircle_stages = 6 };

static void orient2d_by_stage(const double *p, int sign[orient2d_stages])
{
  sign[0] = gmds_orient2d_filter(p, p + 2, p + 4);
  if (sign[0] == 0)
    sign[0] = GMDS_UNDECIDED;
  sign[1] = gmds_orient2d_products(p, p + 2, p + 4);
  sign[2] = gmds_orient2d_expansion(p, p + 2, p + 4);
  sign[3] = gmds_orient2d_wide(p, p + 2, p + 4);
}

static void incircle_by_stage(const double *p, int sign[incircle_stages])
{
  sign[0] = gmds_incircle_bounded(p, p + 2, p + 4, p + 6, GMDS_INCIRCLE_BOUND, INFINITY);
  sign[1] = gmds_incircle_bounded(p, p + 2, p + 4, p + 6, INFINITY, GMDS_INCIRCLE_BOUND);
  for (int i = 0; i < 2; i++)
    if (sign[i] == 0)
      sign[i] = GMDS_UNDECIDED;
  sign[2] = gmds_incircle_lattice(p, p + 2, p + 4, p + 6);
  sign[3] = gmds_incircle_extended(p, p + 2, p + 4, p + 6);
  sign[4] = gmds_incircle_expansion(p, p + 2, p + 4, p + 6);
  sign[5] = gmds_incircle_wide(p, p + 2, p + 4, p + 6);
}

/* Every stage that decides says `exact`; the first that does is counted. */
static void check_stages(int n, const int *sign, int exact, long *ended, const char *family)
{
  int first = n;
  for (int stage = n - 1; stage >= 0; stage--) {
    if (sign[stage] == GMDS_UNDECIDED)
      continue;
    ck_assert_msg(sign[stage] == exact, "%s: stage %d says %d, GMP %d", family, stage, sign[stage], exact);
    first = stage;
  }
  ck_assert_msg(first < n, "%s: no stage decides", family);
  ended[first]++;
}

START_TEST(every_stage_of_orient2d_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 11;
  long ended[orient2d_stages] = {0}, signs[3] = {0};
  for (int family = 0; family < family_count; family++)
    for (int round = 0; round < 40000; round++) {
      double p[8];
      int sign[orient2d_stages];
      family_fill(family, &seed, p);
      int exact = exact_orient2d(&o, p);
      orient2d_by_stage(p, sign);
      check_stages(orient2d_stages, sign, exact, ended, family_name[family]);
      ck_assert_int_eq(gmds_orient2d(p, p + 2, p + 4), exact);
      signs[1 + exact]++;
    }
  oracle_clear(&o);
  printf("orient2d ends in: filter %ld, products %ld, expansion %ld, wide %ld\n", ended[0], ended[1], ended[2],
         ended[3]);
  for (int i = 0; i < orient2d_stages; i++)
    ck_assert_int_gt(ended[i], 10000);
  for (int i = 0; i < 3; i++)
    ck_assert_int_gt(signs[i], 10000);
}
END_TEST

START_TEST(every_stage_of_incircle_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 12;
  long ended[incircle_stages] = {0}, signs[3] = {0};
  for (int family = 0; family < family_count; family++)
    for (int round = 0; round < 20000; round++) {
      double p[8];
      int sign[incircle_stages];
      family_fill(family, &seed, p);
      int exact = exact_incircle(&o, p);
      incircle_by_stage(p, sign);
      check_stages(incircle_stages, sign, exact, ended, family_name[family]);
      ck_assert_int_eq(gmds_incircle(p, p + 2, p + 4, p + 6), exact);
      signs[1 + exact]++;
    }
  oracle_clear(&o);
  printf("incircle ends in: cheap filter %ld, tight filter %ld, lattice %ld, extended %ld, expansion %ld, wide %ld\n",
         ended[0], ended[1], ended[2], ended[3], ended[4], ended[5]);
  for (int i = 0; i < incircle_stages; i++)
    ck_assert(ended[i] > 4000 || (i == 3 && LDBL_MANT_DIG != 64));
  for (int i = 0; i < 3; i++)
    ck_assert_int_gt(signs[i], 10000);
}
END_TEST

/* What the filter decides of two triangles at a time is right for both, and it decides what the cheap filter does. */
START_TEST(the_filter_of_two_incircles_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 15;
  long decided = 0;
  for (int family = 0; family < family_count; family++)
    for (int round = 0; round < 4000; round++) {
      double p[8], q[8];
      unsigned undecided = 99;
      family_fill(family, &seed, p);
      family_fill(family, &seed, q);
      q[6] = p[6];
      q[7] = p[7];
      const int exact[2] = {exact_incircle(&o, p), exact_incircle(&o, q)};
      unsigned inside = gmds_incircle_filter_pair(p, p + 2, p + 4, q, q + 2, q + 4, p + 6, &undecided);
      ck_assert_uint_eq(inside & undecided, 0);
      ck_assert_uint_lt(inside | undecided, 4);
      for (int k = 0; k < 2; k++) {
        const double *r = k ? q : p;
        int alone = gmds_incircle_bounded(r, r + 2, r + 4, r + 6, GMDS_INCIRCLE_BOUND, INFINITY);
        ck_assert_int_eq(undecided >> k & 1, alone == 0);
        if (alone)
          ck_assert_int_eq(inside >> k & 1 ? 1 : -1, exact[k]);
        decided += alone != 0;
      }
      q[round % 6] = NAN;
      gmds_incircle_filter_pair(p, p + 2, p + 4, q, q + 2, q + 4, p + 6, &undecided);
      ck_assert_uint_eq(undecided & 2, 2);
    }
  ck_assert_int_gt(decided, 10000);
  oracle_clear(&o);
}
END_TEST

START_TEST(a_bound_of_orient2d_shrunk_16_times_is_caught)
{
  uint64_t seed = 13;
  int wrong = 0;
  for (int round = 0; round < 300000; round++) {
    double p[8];
    family_fill(round % 2 ? family_on_a_line : family_ulps_of_diagonal, &seed, p);
    int sign = gmds_orient2d_bounded(p, p + 2, p + 4, GMDS_ORIENT2D_BOUND / 16);
    wrong += sign && sign != gmds_orient2d_wide(p, p + 2, p + 4);
  }
  ck_assert_int_gt(wrong, 0);
}
END_TEST

/* How many of the decisions of the filters with these bounds are wrong on nearly cocircular points. */
static int wrong_incircles(double cheap, double tight)
{
  uint64_t seed = 14;
  int wrong = 0;
  for (int round = 0; round < 300000; round++) {
    double p[8];
    family_fill(family_on_a_circle, &seed, p);
    int sign = gmds_incircle_bounded(p, p + 2, p + 4, p + 6, cheap, tight);
    wrong += sign && sign != gmds_incircle_wide(p, p + 2, p + 4, p + 6);
  }
  return wrong;
}

START_TEST(either_bound_of_incircle_shrunk_16_times_is_caught)
{
  ck_assert_int_eq(wrong_incircles(GMDS_INCIRCLE_BOUND, GMDS_INCIRCLE_BOUND), 0);
  ck_assert_int_gt(wrong_incircles(GMDS_INCIRCLE_BOUND / 16, INFINITY), 0);
  ck_assert_int_gt(wrong_incircles(INFINITY, GMDS_INCIRCLE_BOUND / 16), 0);
}
END_TEST

/* CGAL's rule, step by step, over the exact signs. */
static int exact_perturbed(oracle *o, const double *p)
{
  int sign = exact_incircle(o, p);
  if (sign)
    return sign;
  int sorted[4] = {0, 1, 2, 3};
  for (int i = 0; i < 4; i++)
    for (int j = i + 1; j < 4; j++)
      if (gmds_compare_points(2, p + 2 * sorted[j], p + 2 * sorted[i]) < 0) {
        int swapped = sorted[i];
        sorted[i] = sorted[j];
        sorted[j] = swapped;
      }
  for (int i = 3; i > 0; i--) {
    if (sorted[i] == 3)
      return -1;
    double triangle[6];
    memcpy(triangle, p, sizeof triangle);
    memcpy(triangle + 2 * sorted[i], p + 6, 2 * sizeof *p);
    sign = exact_orient2d(o, triangle);
    if (sign)
      return sign;
  }
  return -1;
}

START_TEST(the_perturbation_follows_the_rule_of_cgal)
{
  static const int families[] = {family_square_grid, family_mirrored,   family_lattice_circle, family_decimal_grid,
                                 family_on_a_circle, family_subnormals, family_any_exponents};
  oracle o;
  oracle_init(&o);
  uint64_t seed = 15;
  long ties = 0;
  for (int round = 0; round < 140000; round++) {
    double p[8];
    family_fill(families[(size_t)round % (sizeof families / sizeof *families)], &seed, p);
    int distinct = 1;
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < i; j++)
        distinct &= gmds_compare_points(2, p + 2 * i, p + 2 * j) != 0;
    if (!distinct || exact_orient2d(&o, p) <= 0)
      continue;
    int sign = gmds_incircle_perturbed(p, p + 2, p + 4, p + 6);
    ck_assert_int_eq(sign, exact_perturbed(&o, p));
    ck_assert_int_ne(sign, 0);
    ties += exact_incircle(&o, p) == 0;
  }
  oracle_clear(&o);
  ck_assert_int_gt(ties, 10000);
}
END_TEST

RUN_SUITE("predicates against GMP", every_stage_of_orient2d_agrees_with_gmp, every_stage_of_incircle_agrees_with_gmp,
          the_filter_of_two_incircles_agrees_with_gmp, a_bound_of_orient2d_shrunk_16_times_is_caught,
          either_bound_of_incircle_shrunk_16_times_is_caught, the_perturbation_follows_the_rule_of_cgal)
