/* What a closed model leaves behind: its functions, and nothing of its letters, short names and macros. Here what a
 * user has called like a letter keeps its meaning, and models stand side by side; leftovers.cmake looks for the
 * rest. */
#include "harness.h"

#define N 11
#define E "an E of the user"
#define F(x) ((x) + 12)
#define R 1.5
#define DIM2 13
#define F2N struct user
#define N2E
#define R2R 14
#define TRIANGLE \
  {              \
    15, 16, 17   \
  }
#define POLYGON 18

#define GMDS_PREFIX plain
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
#include <gmds/end.h>

#define GMDS_PREFIX full
#define GMDS_MODEL (N | E | F | N2N | N2E | N2F | E2N | E2E | E2F | F2N | F2E | F2F)
#include <gmds/mesh.h>
#include <gmds/end.h>

#define GMDS_PREFIX only_triangles
#define GMDS_MODEL (N | E | F | E2N | F2E)
#define GMDS_FACES TRIANGLE
#define GMDS_BACKEND GMDS_INCIDENCE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#define GMDS_PREFIX in_space
#define GMDS_MODEL (DIM3 | N | F | N2F)
#define GMDS_FACES (TRIANGLE | POLYGON)
#include <gmds/mesh.h>
#include <gmds/end.h>

/* The values of the user's macros, seen by the preprocessor and by the compiler. */
#if N != 11 || F(1) != 13 || DIM2 != 13 || R2R != 14 || POLYGON != 18
#  error "a letter has lost the meaning that the user gave it"
#endif
#if defined F2F || defined E2E || defined DIM3 || defined QUADRILATERAL || defined GMDS_MODEL || \
    defined GMDS_PREFIX || defined GMDS_FACES || defined GMDS_BACKEND || defined GMDS_CAN
#  error "a closed model has left a macro behind"
#endif
_Static_assert(sizeof E == sizeof "an E of the user", "E is the user's");
F2N
{
  double x;
};

/* Short names are free: as variables, functions, members and types. */
typedef struct mesh {
  int point, star, check, count_2, empty;
} mesh;

static int across(int delaunay, int add_triangle)
{
  return delaunay + add_triangle;
}

START_TEST(letters_keep_what_the_user_called_so)
{
  const int triangle[] = TRIANGLE;
  F2N user = {R};
  ck_assert_int_eq(N N2E, 11);
  ck_assert_int_eq(F(N), 23);
  ck_assert_int_eq(triangle[1], 16);
  ck_assert(user.x * 2 == 3);
  ck_assert_str_eq(E, "an E of the user");
}
END_TEST

START_TEST(short_names_are_free_after_the_end)
{
  mesh grow = {.point = 1, .star = 2, .check = 3, .count_2 = 4, .empty = 5};
  ck_assert_int_eq(across(grow.point, grow.empty), 6);
}
END_TEST

START_TEST(models_stand_side_by_side)
{
  const double xy[] = {0, 0, 1, 0, 1, 1, 0, 1}, xyz[] = {0, 0, 2};
  plain_mesh a;
  full_mesh b;
  only_triangles_mesh c;
  in_space_mesh d;
  gmds_id v = 0;
  gmds_soup soup;
  plain_mesh_init(&a, NULL);
  full_mesh_init(&b, NULL);
  only_triangles_mesh_init(&c, NULL);
  in_space_mesh_init(&d, NULL);
  gmds_soup_init(&soup, &a.memory, 2);
  ck_assert_int_eq(plain_delaunay(&a, 4, xy, NULL, NULL), GMDS_OK);
  ck_assert_int_eq(only_triangles_delaunay(&c, 4, xy, NULL, NULL), GMDS_OK);
  ck_assert_int_eq(plain_to_soup(&a, &soup), GMDS_OK);
  ck_assert_int_eq(full_from_soup(&b, &soup, NULL), GMDS_OK);
  ck_assert_int_eq(in_space_add_node(&d, xyz, &v), GMDS_OK);
  ck_assert_uint_eq(plain_count_2(&a), 2);
  ck_assert_uint_eq(full_count_1(&b), 5);
  ck_assert_uint_eq(only_triangles_count_1(&c), 5);
  ck_assert(in_space_point(&d, v)[2] == 2);
  gmds_soup_clear(&soup);
  plain_mesh_clear(&a);
  full_mesh_clear(&b);
  only_triangles_mesh_clear(&c);
  in_space_mesh_clear(&d);
}
END_TEST

RUN_SUITE("hygiene", letters_keep_what_the_user_called_so, short_names_are_free_after_the_end,
          models_stand_side_by_side)
