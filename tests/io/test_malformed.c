/* Malformed files: refused with a status and a sentence that names file and line, the soup as it was. */
#include "malformed/cases.h"
#include "samples.h"

static const struct {
  gmds_format format;
  gmds_status status;
  const char *bytes;
  size_t n;
  const char *sentence;
} cases[] = {
#define ROW(format, status, bytes, sentence) \
  {GMDS_FORMAT_##format, GMDS_ERR_##status, bytes, sizeof(bytes) - 1, sentence},
    MALFORMED_LIST(ROW)
#if GMDS_HAVE_EXPAT
        MALFORMED_VTU_LIST(ROW)
#endif
#undef ROW
};

START_TEST(every_malformed_file_is_refused_with_its_sentence)
{
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    held *h = held_new(2);
    gmds_status status =
        read_bytes(h, cases[i].format, cases[i].bytes, cases[i].n, cases[i].format == GMDS_FORMAT_F64 ? 2 : 0);
    ck_assert_msg(status == cases[i].status && !strcmp(h->error.text, cases[i].sentence),
                  "case %zu: expected %d '%s', got %d '%s'", i, (int)cases[i].status, cases[i].sentence, (int)status,
                  h->error.text);
    ck_assert_int_eq(h->error.status, status);
    ck_assert_uint_eq(h->memory.live, 0);
    ck_assert_int_eq(h->soup.dim, 2);
    ck_assert_int_eq(gmds_read_soup_from_memory(cases[i].format, "name", cases[i].bytes, cases[i].n,
                                                cases[i].format == GMDS_FORMAT_F64 ? 2 : 0, NULL, &h->soup),
                     status);
    held_free(h);
  }
}
END_TEST

/* The last byte of a sample is the end of a line, which may be missing. */
START_TEST(a_file_that_is_cut_is_refused)
{
  for (size_t i = 0; i < N_SAMPLES; i++) {
    sample s = sample_at(i);
    for (size_t n = 0; n < s.n - 1; n++) {
      held *h = held_new(2);
      char *cut = malloc(n ? n : 1);
      ck_assert_ptr_nonnull(cut);
      memcpy(cut, s.bytes, n);
      gmds_status status = read_bytes(h, s.format, cut, n, s.dim);
      ck_assert_msg(status != GMDS_OK || !s.counted, "%s cut after %zu bytes", s.text, n);
      if (status != GMDS_OK) {
        ck_assert_int_eq(strncmp(h->error.text, "name:", 5), 0);
        ck_assert_uint_eq(h->memory.live, 0);
      }
      free(cut);
      held_free(h);
    }
  }
}
END_TEST

/* Sections end where the next begins: cut between, a file of VTK is whole, but it has no cells too many. */
START_TEST(a_vtk_file_that_is_cut_loses_all_cells_or_none)
{
  for (size_t i = 0; i < N_SAMPLES; i++) {
    sample s = sample_at(i);
    if (s.format != GMDS_FORMAT_VTK)
      continue;
    held *whole = held_new(2);
    ck_assert_int_eq(read_bytes(whole, s.format, s.bytes, s.n, 0), GMDS_OK);
    for (size_t n = 0; n < s.n; n++) {
      held *h = held_new(2);
      if (read_bytes(h, s.format, s.bytes, n, 0) == GMDS_OK)
        ck_assert(h->soup.n_cells == 0 || h->soup.n_cells == whole->soup.n_cells);
      held_free(h);
    }
    held_free(whole);
  }
}
END_TEST

START_TEST(a_very_long_line_is_no_trouble)
{
  size_t n = 4000000;
  char *line = malloc(n + 1);
  ck_assert_ptr_nonnull(line);
  for (int kind = 0; kind < 3; kind++) {
    held *h = held_new(2);
    memset(line, kind == 0 ? ' ' : kind == 1 ? '1' : '#', n);
    memcpy(line, "1 2 ", 4);
    gmds_status status = read_bytes(h, GMDS_FORMAT_TEXT, line, n, 0);
    ck_assert_int_eq(status, kind == 1 ? GMDS_ERR_FORMAT : GMDS_OK);
    if (kind == 1)
      ck_assert_uint_lt(strlen(h->error.text), 120);
    held_free(h);
  }
  free(line);
}
END_TEST

START_TEST(a_long_name_leaves_room_for_the_sentence)
{
  char name[3000];
  memset(name, 'x', sizeof name);
  memcpy(name + sizeof name - 5, ".off", 5);
  held *h = held_new(2);
  ck_assert_int_eq(gmds_read_soup_from_memory(GMDS_FORMAT_OFF, name, "OFF", 3, 0, &h->error, &h->soup),
                   GMDS_ERR_FORMAT);
  ck_assert_ptr_nonnull(strstr(h->error.text, ".off:1: expected a number of points, found the end of the file"));
  ck_assert_int_ne(gmds_read_soup(name, 0, &h->error, &h->soup), GMDS_OK);
  ck_assert_ptr_nonnull(strstr(h->error.text, ".off: cannot be opened: "));
  ck_assert_int_ne(gmds_write_soup(name, &h->soup, &h->error), GMDS_OK);
  ck_assert_ptr_nonnull(strstr(h->error.text, ".off: cannot be written: "));
  held_free(h);
}
END_TEST

START_TEST(what_is_no_file_is_refused)
{
  held *h = held_new(2);
  const char *folder = fresh_folder();
  char path[512];
  snprintf(path, sizeof path, "%s", path_in(folder, "a.off"));
  ck_assert_int_eq(gmds_read_soup(path, 0, &h->error, &h->soup), GMDS_ERR_OPEN);
  ck_assert_ptr_nonnull(strstr(h->error.text, "a.off: cannot be opened: "));
  ck_assert_int_eq(mkdir(path, 0700), 0);
  ck_assert_int_eq(gmds_read_soup(path, 0, &h->error, &h->soup), GMDS_ERR_READ);
  ck_assert_ptr_nonnull(strstr(h->error.text, "a.off: cannot be read: "));
  rmdir(path);
  rmdir(folder);
  ck_assert_int_eq(gmds_read_soup("a.xyzw", 0, &h->error, &h->soup), GMDS_ERR_UNSUPPORTED);
  held_free(h);
}
END_TEST

RUN_SUITE("malformed files", every_malformed_file_is_refused_with_its_sentence, a_file_that_is_cut_is_refused,
          a_vtk_file_that_is_cut_loses_all_cells_or_none, a_very_long_line_is_no_trouble,
          a_long_name_leaves_room_for_the_sentence, what_is_no_file_is_refused)
