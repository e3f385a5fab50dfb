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
      {"a.txt", GMDS_TRIANGLE, ": points as text cannot hold cell 0 (from 0), whose type is triangle"},
      {"a.node", GMDS_TRIANGLE, ": Triangle points cannot hold cell 0 (from 0), whose type is triangle"},
      {"a.f64", GMDS_HEXAHEDRON, ": raw little-endian doubles cannot hold cell 0 (from 0), whose type is hexahedron"},
  };
  const gmds_id corners[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const char *folder = fresh_folder();
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    held *h = held_new(3);
    add_points(&h->soup, 8);
    size_t n = (size_t)gmds_cell_type_points(cases[i].type);
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

RUN_SUITE("writing", cells_that_a_format_cannot_hold_are_refused_by_name, what_no_reader_takes_is_not_written,
          a_missing_folder_is_named_with_the_reason, only_regular_files_are_replaced,
          a_write_that_fails_leaves_the_old_file)
