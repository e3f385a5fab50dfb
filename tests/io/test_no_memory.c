/* Every allocation of every reader fails in its turn: an error each time, the soup as it was, nothing leaked. */
#include "samples.h"

/* Reads with the k-th request for memory refused; from a file where `path` is not NULL. */
static gmds_status read_with(const sample *s, const char *path, long k)
{
  failing f = {.until = k};
  gmds_allocator allocator = failing_allocator(&f);
  gmds_memory memory;
  gmds_memory_init(&memory, &allocator);
  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 2);
  gmds_error error = {0};
  gmds_status status = path ? gmds_make_points(path, 2, &error, &soup)
                            : gmds_read_soup_from_memory(s->format, s->text, s->bytes, s->n, s->dim, &error, &soup);
  if (status != GMDS_OK) {
    ck_assert_int_eq(status, GMDS_ERR_MEMORY);
    ck_assert_int_eq(error.status, GMDS_ERR_MEMORY);
    ck_assert_ptr_nonnull(strstr(error.text, path ? path : s->text));
    ck_assert(soup.n_points == 0 && soup.n_cells == 0 && soup.dim == 2 && !soup.points && !soup.corners);
    ck_assert(!soup.attributes[GMDS_OF_POINTS] && !soup.attributes[GMDS_OF_CELLS]);
    ck_assert_uint_eq(f.live, 0);
  }
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(f.live, 0);
  return status;
}

START_TEST(every_reader_survives_every_refusal)
{
  for (size_t i = 0; i < N_SAMPLES; i++) {
    sample s = sample_at(i);
    long k = 0;
    while (read_with(&s, NULL, k) != GMDS_OK)
      k++;
    ck_assert_int_gt(k, 0);
  }
}
END_TEST

START_TEST(files_and_specs_survive_every_refusal)
{
  const char *folder = fresh_folder();
  char path[512];
  snprintf(path, sizeof path, "%s", path_in(folder, "a.off"));
  sample s = sample_at(0);
  put_file(path, s.bytes, s.n);
  const char *specs[] = {path, "random:10:1", "clusters:1000:1", "grid:4", "circle:9"};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
    long k = 0;
    while (read_with(NULL, specs[i], k) != GMDS_OK)
      k++;
    ck_assert_int_gt(k, 0);
  }
  unlink(path);
  rmdir(folder);
}
END_TEST

START_TEST(a_limit_on_memory_holds_for_readers)
{
  static const char bytes[] = "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n";
  for (size_t limit = 0; limit < 200; limit++) {
    held *h = held_new(2);
    h->memory.limit = limit;
    gmds_status status = read_bytes(h, GMDS_FORMAT_OFF, bytes, sizeof bytes - 1, 0);
    ck_assert(status == GMDS_OK || status == GMDS_ERR_MEMORY);
    ck_assert_uint_le(h->memory.peak, limit);
    held_free(h);
  }
}
END_TEST

START_TEST(writers_that_need_memory_leave_no_file)
{
  static const char *const names[] = {"a.vtu", "a.msh"};
  const double x[] = {0, 0, 0};
  const gmds_id corners[] = {0, 1, 2};
  const char *folder = fresh_folder();
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    held *h = held_new(3);
    for (int p = 0; p < 3; p++)
      ck_assert_int_eq(gmds_soup_add_point(&h->soup, x), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_TRIANGLE, 3, corners), GMDS_OK);
    size_t live = h->memory.live;
    h->memory.limit = live;
    ck_assert_int_eq(gmds_write_soup(path_in(folder, names[i]), &h->soup, &h->error), GMDS_ERR_MEMORY);
    ck_assert_msg(strstr(h->error.text, names[i]) && strstr(h->error.text, "out of memory"), "%s", h->error.text);
    ck_assert_uint_eq(files_in(folder), 0);
    ck_assert_uint_eq(h->memory.live, live);
    held_free(h);
  }
  rmdir(folder);
}
END_TEST

RUN_SUITE("readers without memory", every_reader_survives_every_refusal, files_and_specs_survive_every_refusal,
          a_limit_on_memory_holds_for_readers, writers_that_need_memory_leave_no_file)
