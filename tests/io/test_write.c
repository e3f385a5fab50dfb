/* Writing that fails: refused in a sentence, and nothing is left behind. */
#include "soup_tools.h"
#include <math.h>
#include <signal.h>
#include <sys/resource.h>

static void add_points(gmds_soup *soup, size_t n)
{
  const double x[3] = {0.125, 1, 2};
  for (size_t p = 0; p < n; p++)
    ck_assert_int_eq(gmds_soup_add_point(soup, x), GMDS_OK);
}

START_TEST(cells_that_a_format_cannot_hold_are_refused_by_name)
{
  static const struct {
    const char *name;
    gmds_cell_type type;
    const char *sentence;
  } cases[] = {
      {"a.off", GMDS_TETRAHEDRON, ": OFF cannot hold cell 0 (from 0), whose type is tetrahedron"},
      {"a.off", GMDS_SEGMENT, ": OFF cannot hold cell 0 (from 0), whose type is edge"},
      {"a.mesh", GMDS_VERTEX, ": Medit cannot hold cell 0 (from 0), whose type is vertex"},
      {"a.msh", GMDS_POLYGON, ": Gmsh cannot hold cell 0 (from 0), whose type is polygon"},
      {"a.txt", GMDS_TRIANGLE, ": points as text cannot hold cell 0 (from 0), whose type is triangle"},
      {"a.node", GMDS_TRIANGLE, ": Triangle points cannot hold cell 0 (from 0), whose type is triangle"},
      {"a.f64", GMDS_HEXAHEDRON, ": raw little-endian doubles cannot hold cell 0 (from 0), whose type is hexahedron"},
  };
  const gmds_id corners[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const char *folder = fresh_folder();
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    held *h = held_new(3);
    add_points(&h->soup, 8);
    size_t n = cases[i].type == GMDS_POLYGON ? 5 : (size_t)gmds_cell_type_points(cases[i].type);
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, cases[i].type, n, corners), GMDS_OK);
    ck_assert_int_eq(gmds_write_soup(path_in(folder, cases[i].name), &h->soup, &h->error), GMDS_ERR_UNSUPPORTED);
    ck_assert_msg(strstr(h->error.text, cases[i].sentence) != NULL, "%s", h->error.text);
    ck_assert_int_eq(h->error.cell, 0);
    held_free(h);
  }
  ck_assert_uint_eq(files_in(folder), 0);
  rmdir(folder);
}
END_TEST

START_TEST(what_is_not_written_is_refused_by_name)
{
  static const struct {
    const char *name, *sentence;
    gmds_write_options options;
  } cases[] = {
      {"a.off", ": OFF is not written in binary", {GMDS_ENCODING_BINARY, 0}},
      {"a.f64", ": raw little-endian doubles is not written as text", {GMDS_ENCODING_TEXT, 0}},
      {"a.msh", ": Gmsh is not written in version 4.0", {GMDS_ENCODING_USUAL, 40}},
      {"a.vtk", ": VTK legacy is not written in version 2.2", {GMDS_ENCODING_BINARY, 22}},
  };
  const char *folder = fresh_folder();
  held *h = held_new(3);
  add_points(&h->soup, 2);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *path = path_in(folder, cases[i].name);
    ck_assert_int_eq(gmds_write_soup_as(path, &h->soup, &cases[i].options, &h->error), GMDS_ERR_UNSUPPORTED);
    ck_assert_msg(strstr(h->error.text, cases[i].sentence) != NULL, "%s", h->error.text);
  }
  ck_assert_uint_eq(files_in(folder), 0);
  rmdir(folder);
  held_free(h);
}
END_TEST

START_TEST(gmsh_has_one_physical_tag_for_each_entity)
{
  static const gmds_write_options fourth = {.version = 41};
  const gmds_id corners[] = {0, 1, 2};
  const char *folder = fresh_folder(), *path = path_in(folder, "a.msh");
  held *h = held_new(2), *back = held_new(2);
  gmds_attribute *physical = NULL, *geometrical = NULL;
  add_points(&h->soup, 3);
  for (int c = 0; c < 2; c++)
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_TRIANGLE, 3, corners), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "physical", GMDS_INT, 1, &physical), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "geometrical", GMDS_INT, 1, &geometrical), GMDS_OK);
  for (int c = 0; c < 2; c++) {
    ((int *)physical->data)[c] = c + 7;
    ((int *)geometrical->data)[c] = 4;
  }
  ck_assert_int_eq(gmds_write_soup_as(path, &h->soup, &fourth, &h->error), GMDS_ERR_UNSUPPORTED);
  ck_assert_msg(strstr(h->error.text, "cells of dimension 2 with the geometrical tag 4 have the physical tags 7 and 8"),
                "%s", h->error.text);
  ck_assert_uint_eq(files_in(folder), 0);
  ck_assert_int_eq(gmds_write_soup(path, &h->soup, &h->error), GMDS_OK);
  ck_assert_int_eq(gmds_read_soup(path, 2, &h->error, &back->soup), GMDS_OK);
  assert_same_attributes(GMDS_FORMAT_GMSH, &h->soup, &back->soup);
  unlink(path);
  rmdir(folder);
  held_free(back);
  held_free(h);
}
END_TEST

START_TEST(formats_say_which_attributes_they_hold)
{
  held *h = held_new(2);
  gmds_attribute *a[5] = {NULL};
  add_points(&h->soup, 2);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "ref", GMDS_LONG, 1, &a[0]), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "v", GMDS_DOUBLE, 2, &a[1]), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "big", GMDS_LONG, 1, &a[2]), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "\"", GMDS_FLOAT, 3, &a[3]), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "\xff", GMDS_BYTE, 9, &a[4]), GMDS_OK);
  ((int64_t *)a[2]->data)[1] = -((int64_t)1 << 53) - 1;
  static const char held_by[][6] = {"OFF", "", "VTK", "11111", "VTU", "11110", "Medit", "10000", "Gmsh", "10001"};
  static const gmds_format formats[] = {GMDS_FORMAT_OFF, GMDS_FORMAT_VTK, GMDS_FORMAT_VTU, GMDS_FORMAT_MEDIT,
                                        GMDS_FORMAT_GMSH};
  for (size_t f = 0; f < 5; f++)
    for (size_t k = 0; k < 5; k++)
      ck_assert_msg(gmds_format_holds(formats[f], &h->soup, GMDS_OF_POINTS, a[k]) == (held_by[2 * f + 1][k] == '1'),
                    "%s, attribute %zu", held_by[2 * f], k);
  ((int64_t *)a[0]->data)[0] = (int64_t)1 << 31;
  ck_assert(!gmds_format_holds(GMDS_FORMAT_MEDIT, &h->soup, GMDS_OF_POINTS, a[0]));
  held_free(h);
}
END_TEST

START_TEST(what_no_reader_takes_is_not_written)
{
  held *h = held_new(2);
  const char *folder = fresh_folder();
  const double x[] = {0, (double)NAN};
  add_points(&h->soup, 3);
  ck_assert_int_eq(gmds_soup_add_point(&h->soup, x), GMDS_OK);
  ck_assert_int_eq(gmds_write_soup(path_in(folder, "a.f64"), &h->soup, &h->error), GMDS_ERR_COORDINATE);
  ck_assert_int_eq(h->error.cell, 3);
  ck_assert_uint_eq(files_in(folder), 0);
  rmdir(folder);
  held_free(h);
}
END_TEST

START_TEST(a_missing_folder_is_named_with_the_reason)
{
  held *h = held_new(2);
  ck_assert_int_eq(gmds_write_soup("no-such-folder/a.off", &h->soup, &h->error), GMDS_ERR_OPEN);
  ck_assert_str_eq(h->error.text, "no-such-folder/a.off: cannot be written: No such file or directory");
  ck_assert_int_eq(gmds_write_soup("a", &h->soup, &h->error), GMDS_ERR_UNSUPPORTED);
  held_free(h);
}
END_TEST

START_TEST(only_regular_files_are_replaced)
{
  held *h = held_new(2);
  const char *folder = fresh_folder();
  char path[512];
  snprintf(path, sizeof path, "%s", path_in(folder, "a.off"));
  ck_assert_int_eq(mkdir(path, 0700), 0);
  ck_assert_int_eq(gmds_write_soup(path, &h->soup, &h->error), GMDS_ERR_OPEN);
  ck_assert_int_eq(rmdir(path), 0);
  put_file(path, "old", 3);
  ck_assert_int_eq(gmds_write_soup(path, &h->soup, &h->error), GMDS_OK);
  ck_assert_int_eq(gmds_read_soup(path, 2, &h->error, &h->soup), GMDS_OK);
  ck_assert_uint_eq(files_in(folder), 1);
  unlink(path);
  rmdir(folder);
  held_free(h);
}
END_TEST

/* A limit on the size of files stands for a full disk. */
START_TEST(a_write_that_fails_leaves_the_old_file)
{
  held *h = held_new(2), *old = held_new(2);
  const char *folder = fresh_folder();
  struct rlimit before, small;
  add_points(&h->soup, 50000);
  put_file(path_in(folder, "a.txt"), "1 2\n", 4);
  ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
  small = before;
  small.rlim_cur = 8192;
  void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
  ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &small), 0);
  gmds_status status = gmds_write_soup(path_in(folder, "a.txt"), &h->soup, &h->error);
  ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &before), 0);
  signal(SIGXFSZ, handler);
  ck_assert_int_eq(status, GMDS_ERR_WRITE);
  ck_assert_ptr_nonnull(strstr(h->error.text, "a.txt: cannot be written: "));
  ck_assert_uint_eq(files_in(folder), 1);
  ck_assert_int_eq(gmds_read_soup(path_in(folder, "a.txt"), 2, &old->error, &old->soup), GMDS_OK);
  ck_assert_str_eq(soup_text(&old->soup), "1,2 ");
  unlink(path_in(folder, "a.txt"));
  rmdir(folder);
  held_free(old);
  held_free(h);
}
END_TEST

RUN_SUITE("writing", cells_that_a_format_cannot_hold_are_refused_by_name, what_is_not_written_is_refused_by_name,
          gmsh_has_one_physical_tag_for_each_entity, formats_say_which_attributes_they_hold,
          what_no_reader_takes_is_not_written, a_missing_folder_is_named_with_the_reason,
          only_regular_files_are_replaced, a_write_that_fails_leaves_the_old_file)
