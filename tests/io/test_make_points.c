/* Points made up from a SPEC. */
#include "soup_tools.h"
#include <math.h>

static gmds_status make(held *h, const char *spec, int dim)
{
  return gmds_make_points(spec, dim, &h->error, &h->soup);
}

#if GMDS_HAVE_CXX
/* oracle_random.cpp: the C++ library's own numbers */
void oracle_random(uint64_t seed, size_t n, double *x);

START_TEST(random_points_are_those_of_the_cpp_library)
{
  static const unsigned long seeds[] = {0, 1, 42, 5489, 4294967295u};
  for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
    for (int dim = 2; dim <= 3; dim++) {
      char spec[64];
      size_t n = 100000;
      held *h = held_new(2);
      double *expected = malloc(n * (size_t)dim * sizeof *expected);
      ck_assert_ptr_nonnull(expected);
      snprintf(spec, sizeof spec, "random:%zu:%lu", n, seeds[i]);
      ck_assert_int_eq(make(h, spec, dim), GMDS_OK);
      oracle_random(seeds[i], n * (size_t)dim, expected);
      ck_assert_uint_eq(h->soup.n_points, n);
      ck_assert_int_eq(h->soup.dim, dim);
      ck_assert_mem_eq(h->soup.points, expected, n * (size_t)dim * sizeof *expected);
      free(expected);
      held_free(h);
    }
}
END_TEST
#else
START_TEST(random_points_are_those_of_the_cpp_library)
{
  printf("skipped, no C++ compiler: random points against the C++ library\n");
}
END_TEST
#endif

START_TEST(grids_are_in_rows)
{
  held *h = held_new(2);
  ck_assert_int_eq(make(h, "grid:2", 2), GMDS_OK);
  ck_assert_str_eq(soup_text(&h->soup), "0,0 0,1 1,0 1,1 ");
  gmds_soup_clear(&h->soup);
  ck_assert_int_eq(make(h, "grid:2", 3), GMDS_OK);
  ck_assert_str_eq(soup_text(&h->soup), "0,0,0 0,0,1 0,1,0 0,1,1 1,0,0 1,0,1 1,1,0 1,1,1 ");
  held_free(h);
}
END_TEST

START_TEST(nothing_asked_for_is_nothing_made)
{
  static const char *const specs[] = {"grid:0", "random:0:1", "circle:0", "clusters:0:3"};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
    held *h = held_new(2);
    ck_assert_int_eq(make(h, specs[i], 3), GMDS_OK);
    ck_assert_uint_eq(h->soup.n_points, 0);
    ck_assert_int_eq(h->soup.dim, 3);
    held_free(h);
  }
}
END_TEST

START_TEST(points_of_a_circle_are_on_it)
{
  held *h = held_new(2);
  ck_assert_int_eq(make(h, "circle:1000", 3), GMDS_OK);
  ck_assert_uint_eq(h->soup.n_points, 1000);
  for (size_t p = 0; p < 1000; p++) {
    const double *x = h->soup.points + 3 * p;
    ck_assert_double_le(fabs(x[0] * x[0] + x[1] * x[1] - 1), 4e-16);
    ck_assert_double_eq(x[2], 0);
  }
  held_free(h);
}
END_TEST

START_TEST(clusters_are_made_again_by_the_same_seed)
{
  held *a = held_new(2), *b = held_new(2);
  ck_assert_int_eq(make(a, "clusters:10000:5", 2), GMDS_OK);
  ck_assert_int_eq(make(b, "clusters:10000:5", 2), GMDS_OK);
  assert_same_soup(&a->soup, &b->soup);
  for (size_t i = 0; i < 20000; i++)
    ck_assert(a->soup.points[i] > -0.2 && a->soup.points[i] < 1.2);
  held_free(b);
  held_free(a);
}
END_TEST

START_TEST(wrong_specs_are_refused_in_a_sentence)
{
  static const char *const wrong[] = {"random:abc",  "random:",    "random:5",     "random:5:", "random:5:1:2",
                                      "random:-5:1", "random:5:x", "random:1e3:1", "grid:",     "grid:x",
                                      "grid:1:1",    "circle:-1",  "clusters:10",  "grid: 3",   "random:5:-1"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    held *h = held_new(2);
    ck_assert_msg(make(h, wrong[i], 2) == GMDS_ERR_ARGUMENT, "%s", wrong[i]);
    ck_assert_ptr_nonnull(strstr(h->error.text, wrong[i]));
    ck_assert_ptr_nonnull(strstr(h->error.text, "expected"));
    held_free(h);
  }
}
END_TEST

START_TEST(too_many_points_are_refused)
{
  held *h = held_new(2);
  ck_assert_int_eq(make(h, "grid:18446744073709551615", 2), GMDS_ERR_TOO_MANY);
  ck_assert_int_eq(make(h, "random:18446744073709551615:1", 2),
                   GMDS_ID_BITS == 32 ? GMDS_ERR_TOO_MANY : GMDS_ERR_MEMORY);
  ck_assert_int_eq(make(h, "random:18446744073709551616:1", 2), GMDS_ERR_ARGUMENT);
  h->memory.limit = 1000;
  ck_assert_int_eq(make(h, "grid:100", 2), GMDS_ERR_MEMORY);
  ck_assert_int_eq(make(h, "clusters:62:1", 2), GMDS_ERR_MEMORY);
  ck_assert_uint_eq(h->memory.live, 0);
  ck_assert_int_eq(make(h, "grid:2", 4), GMDS_ERR_ARGUMENT);
  held_free(h);
}
END_TEST

START_TEST(a_mesh_file_gives_its_points)
{
  held *h = held_new(2);
  const char *folder = fresh_folder();
  static const char off[] = "OFF\n3 1 0\n0 0 1\n1 0 2\n0 1 3\n3 0 1 2\n";
  put_file(path_in(folder, "a.off"), off, sizeof off - 1);
  ck_assert_int_eq(make(h, path_in(folder, "a.off"), 2), GMDS_OK);
  ck_assert_str_eq(soup_text(&h->soup), "0,0 1,0 0,1 ");
  unlink(path_in(folder, "a.off"));
  rmdir(folder);
  held_free(h);
}
END_TEST

RUN_SUITE("made-up points", random_points_are_those_of_the_cpp_library, grids_are_in_rows,
          nothing_asked_for_is_nothing_made, points_of_a_circle_are_on_it, clusters_are_made_again_by_the_same_seed,
          wrong_specs_are_refused_in_a_sentence, too_many_points_are_refused, a_mesh_file_gives_its_points)
