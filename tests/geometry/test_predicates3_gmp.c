/* The predicates of space, stage by stage, against the integers of GMP. */
#include "families3.h"
#include "harness.h"
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

/* z: five rows of x, y, z and the lift; two and three: minors. */
typedef struct oracle {
  mpz_t z[20], two, three, sum;
} oracle;

static void oracle_init(oracle *o)
{
  for (int i = 0; i < 20; i++)
    mpz_init(o->z[i]);
  mpz_inits(o->two, o->three, o->sum, NULL);
}

static void oracle_clear(oracle *o)
{
  for (int i = 0; i < 20; i++)
    mpz_clear(o->z[i]);
  mpz_clears(o->two, o->three, o->sum, NULL);
}

/* The rows of n points on a common grid, relative to the last point. */
static void set_rows(oracle *o, int n, const double *p)
{
  int grid = 1024;
  for (int i = 0; i < 3 * n; i++) {
    int exponent;
    (void)frexp(p[i], &exponent);
    if (p[i] != 0 && exponent - 53 < grid)
      grid = exponent - 53;
  }
  for (int i = 0; i < 3 * n; i++)
    set_scaled(o->z[4 * (i / 3) + i % 3], p[i], grid);
  for (int i = 0; i < n - 1; i++) {
    mpz_t *row = o->z + 4 * i;
    mpz_set_ui(row[3], 0);
    for (int k = 0; k < 3; k++) {
      mpz_sub(row[k], row[k], o->z[4 * (n - 1) + k]);
      mpz_addmul(row[3], row[k], row[k]);
    }
  }
}

/* o->three = the determinant of x, y, z of three rows. */
static void determinant(oracle *o, mpz_t *a, mpz_t *b, mpz_t *c)
{
  mpz_t *const rows[3] = {a, b, c};
  mpz_set_ui(o->three, 0);
  for (int i = 0; i < 3; i++) {
    mpz_t *p = rows[(i + 1) % 3], *q = rows[(i + 2) % 3];
    mpz_mul(o->two, p[1], q[2]);
    mpz_submul(o->two, p[2], q[1]);
    mpz_addmul(o->three, rows[i][0], o->two);
  }
}

static int exact_orient3d(oracle *o, const double *p)
{
  set_rows(o, 4, p);
  determinant(o, o->z, o->z + 4, o->z + 8);
  return -mpz_sgn(o->three);
}

/* The determinant of four rows, by the column of lifts from below. */
static int exact_rows(oracle *o)
{
  mpz_t *z = o->z;
  mpz_set_ui(o->sum, 0);
  for (int i = 0; i < 4; i++) {
    mpz_t *rows[3];
    for (int k = 0, n = 0; k < 4; k++)
      if (k != i)
        rows[n++] = z + 4 * k;
    determinant(o, rows[0], rows[1], rows[2]);
    mpz_mul(o->three, o->three, z[4 * i + 3]);
    if (i % 2)
      mpz_sub(o->sum, o->sum, o->three);
    else
      mpz_add(o->sum, o->sum, o->three);
  }
  return mpz_sgn(o->sum);
}

static int exact_insphere(oracle *o, const double *p)
{
  set_rows(o, 5, p);
  return exact_rows(o);
}

/* The stages in their order. A filter says 0 where it does not know. */
enum { orient3d_stages = 5, insphere_stages = 6, coplanar_stages = 4 };

#if defined __SIZEOF_INT128__
static const int has_words = 1;
#else
static const int has_words = 0;
#endif

static void filter_decides(int *sign)
{
  if (*sign == 0)
    *sign = GMDS_UNDECIDED;
}

static void orient3d_by_stage(const double *p, int sign[orient3d_stages])
{
  const double *a = p, *b = p + 3, *c = p + 6, *d = p + 9;
  sign[0] = gmds_orient3d_filter(a, b, c, d);
  filter_decides(&sign[0]);
  sign[1] = gmds_orient3d_lattice(a, b, c, d);
  sign[2] = gmds_orient3d_words(a, b, c, d);
  sign[3] = gmds_orient3d_extended(a, b, c, d);
  sign[4] = gmds_orient3d_wide(a, b, c, d);
}

static void insphere_by_stage(const double *p, int sign[insphere_stages])
{
  const double *a = p, *b = p + 3, *c = p + 6, *d = p + 9, *e = p + 12;
  sign[0] = gmds_insphere_filter(a, b, c, d, e);
  sign[2] = gmds_insphere_bounded(a, b, c, d, e, INFINITY, GMDS_INSPHERE_BOUND);
  filter_decides(&sign[0]);
  filter_decides(&sign[2]);
  sign[1] = gmds_insphere_lattice(a, b, c, d, e);
  sign[3] = gmds_insphere_words(a, b, c, d, e);
  sign[4] = gmds_insphere_extended(a, b, c, d, e);
  sign[5] = gmds_insphere_wide(a, b, c, d, e);
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

START_TEST(every_stage_of_orient3d_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 31;
  long ended[orient3d_stages] = {0}, signs[3] = {0};
  for (int family = 0; family < family3_count; family++)
    for (int round = 0; round < 20000; round++) {
      double p[15];
      int sign[orient3d_stages];
      family3_fill(family, &seed, p);
      int exact = exact_orient3d(&o, p);
      orient3d_by_stage(p, sign);
      check_stages(orient3d_stages, sign, exact, ended, family3_name[family]);
      ck_assert_int_eq(gmds_orient3d(p, p + 3, p + 6, p + 9), exact);
      signs[1 + exact]++;
    }
  oracle_clear(&o);
  printf("orient3d ends in: filter %ld, lattice %ld, words %ld, extended %ld, wide %ld\n", ended[0], ended[1], ended[2],
         ended[3], ended[4]);
  for (int i = 0; i < orient3d_stages; i++)
    ck_assert(ended[i] > 4000 || (i == 3 && LDBL_MANT_DIG != 64) || (i == 2 && !has_words));
  for (int i = 0; i < 3; i++)
    ck_assert_int_gt(signs[i], 10000);
}
END_TEST

START_TEST(every_stage_of_insphere_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 32;
  long ended[insphere_stages] = {0}, signs[3] = {0};
  for (int family = 0; family < family3_count; family++)
    for (int round = 0; round < 10000; round++) {
      double p[15];
      int sign[insphere_stages];
      family3_fill(family, &seed, p);
      int exact = exact_insphere(&o, p);
      insphere_by_stage(p, sign);
      check_stages(insphere_stages, sign, exact, ended, family3_name[family]);
      ck_assert_int_eq(gmds_insphere(p, p + 3, p + 6, p + 9, p + 12), exact);
      signs[1 + exact]++;
    }
  oracle_clear(&o);
  printf("insphere ends in: cheap filter %ld, lattice %ld, tight filter %ld, words %ld, extended %ld, wide %ld\n",
         ended[0], ended[1], ended[2], ended[3], ended[4], ended[5]);
  for (int i = 0; i < insphere_stages; i++)
    ck_assert(ended[i] > 2000 || (i == 4 && LDBL_MANT_DIG != 64) || (i == 3 && !has_words));
  for (int i = 0; i < 3; i++)
    ck_assert_int_gt(signs[i], 10000);
}
END_TEST

/* What the filter decides of two tetrahedra at a time is right for both, and it decides what the cheap filter does. */
START_TEST(the_filter_of_two_inspheres_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 33;
  long decided = 0;
  for (int family = 0; family < family3_count; family++)
    for (int round = 0; round < 3000; round++) {
      double p[15], q[15];
      unsigned undecided = 99;
      family3_fill(family, &seed, p);
      family3_fill(family, &seed, q);
      memcpy(q + 12, p + 12, 3 * sizeof *q);
      const int exact[2] = {exact_insphere(&o, p), exact_insphere(&o, q)};
      unsigned inside = gmds_insphere_filter_pair(p, p + 3, p + 6, p + 9, q, q + 3, q + 6, q + 9, p + 12, &undecided);
      ck_assert_uint_eq(inside & undecided, 0);
      ck_assert_uint_lt(inside | undecided, 4);
      for (int k = 0; k < 2; k++) {
        const double *r = k ? q : p;
        int alone = gmds_insphere_filter(r, r + 3, r + 6, r + 9, r + 12);
        ck_assert_int_eq(undecided >> k & 1, alone == 0);
        if (alone)
          ck_assert_int_eq(inside >> k & 1 ? 1 : -1, exact[k]);
        decided += alone != 0;
      }
      q[round % 12] = NAN;
      gmds_insphere_filter_pair(p, p + 3, p + 6, p + 9, q, q + 3, q + 6, q + 9, p + 12, &undecided);
      ck_assert_uint_eq(undecided & 2, 2);
    }
  ck_assert_int_gt(decided, 10000);
  oracle_clear(&o);
}
END_TEST

START_TEST(a_bound_of_orient3d_shrunk_16_times_is_caught)
{
  uint64_t seed = 34;
  int wrong = 0;
  for (int round = 0; round < 300000; round++) {
    double p[15];
    family3_fill(round % 2 ? family3_on_a_plane : family3_ulps_of_diagonal, &seed, p);
    int sign = gmds_orient3d_bounded(p, p + 3, p + 6, p + 9, GMDS_ORIENT3D_BOUND / 16);
    wrong += sign && sign != gmds_orient3d_wide(p, p + 3, p + 6, p + 9);
  }
  ck_assert_int_gt(wrong, 0);
}
END_TEST

/* How many of the decisions of the filters with these bounds are wrong on nearly cospherical points of a family. */
static int wrong_inspheres(int family, double square, double tight)
{
  uint64_t seed = 35;
  int wrong = 0;
  for (int round = 0; round < 300000; round++) {
    double p[15];
    family3_fill(family, &seed, p);
    int sign = gmds_insphere_bounded(p, p + 3, p + 6, p + 9, p + 12, square, tight);
    wrong += sign && sign != gmds_insphere_wide(p, p + 3, p + 6, p + 9, p + 12);
  }
  return wrong;
}

START_TEST(either_bound_of_insphere_shrunk_16_times_is_caught)
{
  static const int families[] = {family3_on_a_sphere, family3_on_a_circle, family3_above_a_circle};
  int cheap = 0, tight = 0;
  for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
    ck_assert_int_eq(wrong_inspheres(families[i], GMDS_INSPHERE_SQUARE, GMDS_INSPHERE_BOUND), 0);
    cheap += wrong_inspheres(families[i], GMDS_INSPHERE_SQUARE / 256, INFINITY);
    tight += wrong_inspheres(families[i], INFINITY, GMDS_INSPHERE_BOUND / 16);
  }
  ck_assert_int_gt(cheap, 0);
  ck_assert_int_gt(tight, 0);
}
END_TEST

/* Published bounds, of Meyer and Pion's form, are references from above. */
START_TEST(the_bounds_are_below_published_ones)
{
  ck_assert(GMDS_ORIENT2D_BOUND <= 8.8872e-16);
  ck_assert(GMDS_INCIRCLE_BOUND <= 8.8879e-15);
  ck_assert(GMDS_ORIENT3D_BOUND <= 5.1108e-15);
  ck_assert(GMDS_INSPHERE_BOUND <= 1.2467e-13);
  ck_assert(fabs(32 * GMDS_INSPHERE_SQUARE / (GMDS_INSPHERE_BOUND * GMDS_INSPHERE_BOUND) - 1) < 0x1p-38);
}
END_TEST

/* CGAL's rule for n points of which the last is asked about, step by step, over an exact orientation of the others. */
static int perturbed(oracle *o, int n, const double *p, int (*orient)(oracle *, const double *))
{
  int sorted[] = {0, 1, 2, 3, 4};
  for (int i = 0; i < n; i++)
    for (int j = i + 1; j < n; j++)
      if (gmds_compare_points(3, p + 3 * sorted[j], p + 3 * sorted[i]) < 0) {
        int swapped = sorted[i];
        sorted[i] = sorted[j];
        sorted[j] = swapped;
      }
  for (int i = n - 1; i > 0; i--) {
    if (sorted[i] == n - 1)
      return -1;
    double simplex[12];
    memcpy(simplex, p, (size_t)(3 * n - 3) * sizeof *p);
    memcpy(simplex + 3 * sorted[i], p + 3 * n - 3, 3 * sizeof *p);
    int sign = orient(o, simplex);
    if (sign)
      return sign * orient(o, p);
  }
  return -1;
}

static int all_distinct(int n, const double *p)
{
  int distinct = 1;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < i; j++)
      distinct &= gmds_compare_points(3, p + 3 * i, p + 3 * j) != 0;
  return distinct;
}

START_TEST(the_perturbation_follows_the_rule_of_cgal)
{
  static const int families[] = {family3_cubic_grid,  family3_mirrored,   family3_lattice_sphere, family3_decimal_grid,
                                 family3_on_a_sphere, family3_subnormals, family3_any_exponents};
  oracle o;
  oracle_init(&o);
  uint64_t seed = 36;
  long ties = 0;
  for (int round = 0; round < 140000; round++) {
    double p[15];
    family3_fill(families[(size_t)round % (sizeof families / sizeof *families)], &seed, p);
    if (!all_distinct(5, p) || exact_orient3d(&o, p) <= 0)
      continue;
    int sign = gmds_insphere_perturbed(p, p + 3, p + 6, p + 9, p + 12), exact = exact_insphere(&o, p);
    ck_assert_int_eq(sign, exact ? exact : perturbed(&o, 5, p, exact_orient3d));
    ck_assert_int_ne(sign, 0);
    ties += exact == 0;
  }
  oracle_clear(&o);
  ck_assert_int_gt(ties, 5000);
}
END_TEST

/* The turn of three points as CGAL projects them, with GMP. */
static int exact_turn(oracle *o, const double *p)
{
  static const int kept[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  set_rows(o, 3, p);
  for (int i = 0; i < 3; i++) {
    int u = kept[i][0], v = kept[i][1];
    mpz_mul(o->two, o->z[u], o->z[4 + v]);
    mpz_submul(o->two, o->z[v], o->z[4 + u]);
    if (mpz_sgn(o->two))
      return mpz_sgn(o->two);
  }
  return 0;
}

/* CGAL's way: the sphere through a, b, c and d + v, v = (b - a) x (c - a), of which d is asked. */
static int exact_circle(oracle *o, const double *p)
{
  set_rows(o, 4, p);
  mpz_t *a = o->z, *b = o->z + 4, *c = o->z + 8, *v = o->z + 12, u[6];
  for (int k = 0; k < 3; k++) {
    mpz_init(u[k]);
    mpz_init(u[3 + k]);
    mpz_sub(u[k], b[k], a[k]);
    mpz_sub(u[3 + k], c[k], a[k]);
  }
  mpz_set_ui(v[3], 0);
  for (int k = 0; k < 3; k++) {
    mpz_mul(v[k], u[(k + 1) % 3], u[3 + (k + 2) % 3]);
    mpz_submul(v[k], u[(k + 2) % 3], u[3 + (k + 1) % 3]);
    mpz_addmul(v[3], v[k], v[k]);
  }
  for (int k = 0; k < 6; k++)
    mpz_clear(u[k]);
  /* a, b, c, d + v are positively oriented: d is inside where the determinant is positive. */
  return exact_rows(o);
}

/* Four points of one plane: of a lattice in it, flat in some axis, cocircular or nearly so, with any exponents. */
static void fill_plane(uint64_t *seed, double p[12])
{
  int kind = (int)random_below(seed, 6), axis = (int)random_below(seed, 3), side = 1 << random_below(seed, 26);
  double u[3], v[3], q[15];
  for (int k = 0; k < 3; k++) {
    u[k] = (double)random_below(seed, 5) - 2;
    v[k] = (double)random_below(seed, 5) - 2;
  }
  family3_fill(kind < 4 ? family3_uniform : kind == 4 ? family3_any_bits : family3_mirrored, seed, q);
  for (int i = 0; i < 4; i++) {
    double s = (double)random_below(seed, kind ? (size_t)side : 4),
           t = (double)random_below(seed, kind ? (size_t)side : 4);
    for (int k = 0; k < 3; k++)
      p[3 * i + k] = kind < 2 ? s * u[k] + t * v[k] : k == axis ? q[0] : kind == 2 ? s + t * (k & 1) : q[3 * i + k];
  }
}

START_TEST(the_circle_in_a_plane_agrees_with_gmp)
{
  oracle o;
  oracle_init(&o);
  uint64_t seed = 37;
  long signs[3] = {0}, ended[coplanar_stages] = {0};
  for (int round = 0; round < 200000; round++) {
    double p[12], swapped[12];
    fill_plane(&seed, p);
    ck_assert_int_eq(exact_orient3d(&o, p), 0);
    const double *a = p, *b = p + 3, *c = p + 6, *d = p + 9;
    int turn = exact_turn(&o, p);
    ck_assert_int_eq(gmds_coplanar_orientation(a, b, c), turn);
    memcpy(swapped, p, sizeof swapped);
    memcpy(swapped + 6, d, 3 * sizeof *p);
    ck_assert_int_eq(gmds_coplanar_side(a, b, c, d), turn * exact_turn(&o, swapped));
    if (turn == 0)
      continue;
    int exact = exact_circle(&o, p);
    ck_assert_int_eq(gmds_coplanar_incircle(a, b, c, d), exact);
    ck_assert_int_eq(gmds_coplanar_incircle(b, a, c, d), exact);
    signs[1 + exact]++;
    if (all_distinct(4, p)) {
      int rule = exact ? exact : perturbed(&o, 4, p, exact_turn);
      ck_assert_int_eq(gmds_coplanar_incircle_perturbed(a, b, c, d), rule);
      ck_assert_int_eq(gmds_coplanar_incircle_perturbed(c, b, a, d), rule);
    }
    for (int u = 0; u < 3; u++) {
      int v = (u + 1) % 3, sign[coplanar_stages];
      const double pa[2] = {a[u], a[v]}, pb[2] = {b[u], b[v]}, pc[2] = {c[u], c[v]};
      int projected = gmds_orient2d(pa, pb, pc);
      sign[0] = gmds_coplanar_filter(u, v, a, b, c, d);
      filter_decides(&sign[0]);
      sign[1] = gmds_coplanar_lattice(u, v, a, b, c, d);
      sign[2] = gmds_coplanar_words(u, v, a, b, c, d);
      sign[3] = gmds_coplanar_wide(u, v, a, b, c, d);
      check_stages(coplanar_stages, sign, exact * projected, ended, "plane");
    }
  }
  oracle_clear(&o);
  printf("coplanar_incircle ends in: filter %ld, lattice %ld, words %ld, wide %ld\n", ended[0], ended[1], ended[2],
         ended[3]);
  for (int i = 0; i < coplanar_stages; i++)
    ck_assert(ended[i] > 10000 || (i == 2 && !has_words));
  for (int i = 0; i < 3; i++)
    ck_assert_int_gt(signs[i], 4000);
}
END_TEST

RUN_SUITE("predicates of space against GMP", every_stage_of_orient3d_agrees_with_gmp,
          every_stage_of_insphere_agrees_with_gmp, the_filter_of_two_inspheres_agrees_with_gmp,
          a_bound_of_orient3d_shrunk_16_times_is_caught, either_bound_of_insphere_shrunk_16_times_is_caught,
          the_bounds_are_below_published_ones, the_perturbation_follows_the_rule_of_cgal,
          the_circle_in_a_plane_agrees_with_gmp)
