/* What the predicates of space promise, without an oracle: known signs, symmetries, uniqueness of the perturbation. */
#include "draw.h"
#include <gmds/predicates.h>

#define TINY 0x1p-1074 /* the smallest double, 5e-324 */
#define HUGE_ONE 0x1.fffffffffffffp1023

typedef struct orient3d_case {
  double p[12];
  int sign;
} orient3d_case;

START_TEST(orient3d_knows_the_hard_cases)
{
  static const orient3d_case cases[] = {
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 1}, /* a tetrahedron in the order of VTK */
      {{0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1}, -1},
      {{0, 0, 0, TINY, 0, 0, 0, TINY, 0, 0, 0, TINY}, 1}, /* products underflow to 0 */
      {{0, 0, 0, TINY, 0, 0, 0, TINY, 0, TINY, TINY, 0}, 0},
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, TINY}, 1}, /* 5e-324 beside 1 */
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, -TINY}, -1},
      {{0, 0, 0, 1e-120, 0, 0, 0, 1e-120, 0, 0, 0, 1e-120}, 1}, /* the bound underflows before the sign is lost */
      {{-HUGE_ONE, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, 0, TINY}, 1}, /* differences overflow */
      {{-HUGE_ONE, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, -HUGE_ONE, 0}, 0},
      {{-HUGE_ONE, 0, TINY, HUGE_ONE, 0, TINY, 0, HUGE_ONE, TINY, 0, -HUGE_ONE, 0}, -1},
      {{-0.0, 0, 0, 0, -0.0, 0, 0, 0, -0.0, 0, 0, 0}, 0},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const double *p = cases[i].p;
    ck_assert_msg(gmds_orient3d(p, p + 3, p + 6, p + 9) == cases[i].sign, "case %zu", i);
  }
}
END_TEST

typedef struct insphere_case {
  double p[15];
  int sign;
} insphere_case;

START_TEST(insphere_knows_the_hard_cases)
{
  static const insphere_case cases[] = {
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, 0.5}, 1},
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, 0},
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1 + 0x1p-52}, -1},
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1 - 0x1p-53}, 1},
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, TINY, TINY, TINY}, 1}, /* 5e-324 beside 1 */
      {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -TINY, 0, 0}, -1},
      {{0, 0, 0, TINY, 0, 0, 0, TINY, 0, 0, 0, TINY, TINY, TINY, TINY}, 0}, /* every product underflows to 0 */
      {{0, 0, 0, 2 * TINY, 0, 0, 0, 2 * TINY, 0, 0, 0, 2 * TINY, TINY, TINY, TINY}, 1},
      {{0, 0, 0, 1e-100, 0, 0, 0, 1e-100, 0, 0, 0, 1e-100, 1e-100, 1e-100, 1e-100}, 0},
      {{-HUGE_ONE, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, -HUGE_ONE}, 0},
      {{-HUGE_ONE, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, TINY, 0, -HUGE_ONE}, -1},
      {{-HUGE_ONE, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, 0, HUGE_ONE, 0, 0, 0}, 1},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const double *p = cases[i].p;
    ck_assert_msg(gmds_insphere(p, p + 3, p + 6, p + 9, p + 12) == cases[i].sign, "case %zu", i);
  }
}
END_TEST

/* Calls visit for every permutation of order[0 .. n) that begins with its first `fixed` entries; parity is 1 or -1. */
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

static void orient3d_alternates(const int *order, int parity, const double *p, int sign)
{
  ck_assert_int_eq(gmds_orient3d(p + 3 * order[0], p + 3 * order[1], p + 3 * order[2], p + 3 * order[3]),
                   parity * sign);
}

static void insphere_alternates(const int *order, int parity, const double *p, int sign)
{
  ck_assert_int_eq(
      gmds_insphere(p + 3 * order[0], p + 3 * order[1], p + 3 * order[2], p + 3 * order[3], p + 3 * order[4]),
      parity * sign);
}

START_TEST(signs_alternate_under_every_permutation)
{
  uint64_t seed = 41;
  for (int round = 0; round < 3000; round++) {
    double p[15];
    int order[] = {0, 1, 2, 3, 4};
    size_t kind = random_below(&seed, 4);
    for (int i = 0; i < 15; i++) {
      double lattice = integer_in(&seed, 0, 3);
      p[i] = kind == 0 ? random_unit(&seed) : kind == 1 ? lattice : kind == 2 ? lattice * TINY : finite_bits(&seed);
    }
    permute(0, 4, order, 1, p, gmds_orient3d(p, p + 3, p + 6, p + 9), orient3d_alternates);
    permute(0, 5, order, 1, p, gmds_insphere(p, p + 3, p + 6, p + 9, p + 12), insphere_alternates);
  }
}
END_TEST

/* Perturbed spheres of five points, none of four in a plane: a triangulation of the five is chosen by all tetrahedra of
 * it alike, so the perturbed signs alternate as the exact ones do. */
static void perturbed_alternates(const int *order, int parity, const double *p, int sign)
{
  const double *a = p + 3 * order[0], *b = p + 3 * order[1], *c = p + 3 * order[2], *d = p + 3 * order[3];
  const double *e = p + 3 * order[4];
  int turn = gmds_orient3d(a, b, c, d);
  if (turn > 0)
    ck_assert_int_eq(gmds_insphere_perturbed(a, b, c, d, e), parity * sign);
  else
    ck_assert_int_eq(gmds_insphere_perturbed(b, a, c, d, e), -parity * sign);
}

START_TEST(the_perturbation_is_the_same_for_every_tetrahedron_of_five_cospherical_points)
{
  uint64_t seed = 42;
  int ties = 0;
  while (ties < 2000) {
    double p[15];
    int order[] = {0, 1, 2, 3, 4}, general = 1;
    for (int i = 0; i < 15; i++)
      p[i] = integer_in(&seed, 0, 4);
    if (gmds_insphere(p, p + 3, p + 6, p + 9, p + 12) != 0)
      continue;
    for (int i = 0; i < 5 && general; i++)
      general =
          gmds_orient3d(p + 3 * (i == 0), p + 3 * (1 + (i <= 1)), p + 3 * (2 + (i <= 2)), p + 3 * (3 + (i <= 3))) != 0;
    if (!general)
      continue;
    int turn = gmds_orient3d(p, p + 3, p + 6, p + 9);
    int sign = turn > 0 ? gmds_insphere_perturbed(p, p + 3, p + 6, p + 9, p + 12)
                        : -gmds_insphere_perturbed(p + 3, p, p + 6, p + 9, p + 12);
    ck_assert_int_ne(sign, 0);
    permute(0, 5, order, 1, p, sign, perturbed_alternates);
    ties++;
  }
}
END_TEST

START_TEST(a_corner_is_outside_its_own_perturbed_sphere_and_circle)
{
  static const double p[] = {0, 0, 0, 2, 1, 0, -1, 3, 1, 0, 1, 4};
  for (int i = 0; i < 4; i++)
    ck_assert_int_eq(gmds_insphere_perturbed(p, p + 3, p + 6, p + 9, p + 3 * i), -1);
  for (int i = 0; i < 3; i++)
    ck_assert_int_eq(gmds_coplanar_incircle_perturbed(p, p + 3, p + 6, p + 3 * i), -1);
}
END_TEST

START_TEST(a_circle_in_a_slanted_plane_is_not_that_of_its_projection)
{
  /* x + z = 1: inside the circle in the plane, outside that of the projection to x and y. */
  static const double a[] = {0, 0, 1}, b[] = {1, 0, 0}, c[] = {0, 2, 1}, d[] = {1, 1.5, 0}, e[] = {1, 2, 0};
  ck_assert_int_eq(gmds_orient3d(a, b, c, d), 0);
  ck_assert_int_eq(gmds_coplanar_incircle(a, b, c, d), 1);
  ck_assert_int_eq(gmds_coplanar_incircle(a, b, c, e), 0);
  ck_assert_int_eq(gmds_coplanar_incircle_perturbed(a, b, c, e), -1);
  ck_assert_int_eq(gmds_coplanar_side(a, b, c, d), 1);
  ck_assert_int_eq(gmds_coplanar_side(c, b, a, d), -1);
  static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
  /* Three points of a circle of the projection, whose plane is steep: the fourth is inside in the plane. */
  double p[12];
  for (int i = 0; i < 4; i++) {
    p[3 * i] = square[2 * i];
    p[3 * i + 1] = square[2 * i + 1];
    p[3 * i + 2] = 5 * (square[2 * i] - square[2 * i + 1]);
  }
  ck_assert_int_eq(gmds_coplanar_incircle(p, p + 3, p + 9, p + 6), 1);
}
END_TEST

RUN_SUITE("predicates of space", orient3d_knows_the_hard_cases, insphere_knows_the_hard_cases,
          signs_alternate_under_every_permutation,
          the_perturbation_is_the_same_for_every_tetrahedron_of_five_cospherical_points,
          a_corner_is_outside_its_own_perturbed_sphere_and_circle,
          a_circle_in_a_slanted_plane_is_not_that_of_its_projection)
