/* Shared by the tests of this folder: a soup with its memory and error, comparison bit for bit, and files in a folder
 * of their own. */
#ifndef GMDS_TESTS_SOUP_TOOLS_H
#define GMDS_TESTS_SOUP_TOOLS_H

#ifndef _POSIX_C_SOURCE
#  define _POSIX_C_SOURCE 200809L /* folders, symbolic permissions, pipes; so include this first */
#endif
#include "harness.h"
#include <dirent.h>
#include <gmds/io.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct held {
  gmds_memory memory;
  gmds_soup soup;
  gmds_error error;
} held;

static inline held *held_new(int dim)
{
  held *h = calloc(1, sizeof *h);
  ck_assert_ptr_nonnull(h);
  gmds_memory_init(&h->memory, NULL);
  gmds_soup_init(&h->soup, &h->memory, dim);
  return h;
}

/* Nothing may be left in the memory of a soup that was cleared. */
static inline void held_free(held *h)
{
  gmds_soup_clear(&h->soup);
  ck_assert_uint_eq(h->memory.live, 0);
  free(h);
}

static inline gmds_status read_bytes(held *h, gmds_format format, const void *bytes, size_t n, int dim)
{
  return gmds_read_soup_from_memory(format, "name", bytes, n, dim, &h->error, &h->soup);
}

/* A soup as one line of text: points, then cells by type and corners. Short soups only. */
static inline const char *soup_text(const gmds_soup *soup)
{
  static char text[4096];
  size_t at = 0;
  for (size_t p = 0; p < soup->n_points; p++)
    for (int k = 0; k < soup->dim; k++)
      at += (size_t)snprintf(text + at, sizeof text - at, "%g%s", soup->points[p * (size_t)soup->dim + (size_t)k],
                             k + 1 < soup->dim ? "," : " ");
  for (size_t c = 0; c < soup->n_cells; c++) {
    at += (size_t)snprintf(text + at, sizeof text - at, "%s", gmds_cell_type_text((gmds_cell_type)soup->types[c]));
    for (size_t k = soup->begin[c]; k < soup->begin[c + 1]; k++)
      at += (size_t)snprintf(text + at, sizeof text - at, " %lu", (unsigned long)soup->corners[k]);
    at += (size_t)snprintf(text + at, sizeof text - at, "; ");
  }
  text[at] = 0;
  return text;
}

static inline void assert_same_soup(const gmds_soup *a, const gmds_soup *b)
{
  ck_assert_int_eq(a->dim, b->dim);
  ck_assert_uint_eq(a->n_points, b->n_points);
  ck_assert_uint_eq(a->n_cells, b->n_cells);
  if (a->n_points)
    ck_assert_mem_eq(a->points, b->points, a->n_points * (size_t)a->dim * sizeof *a->points);
  if (a->n_cells) {
    ck_assert_mem_eq(a->types, b->types, a->n_cells);
    ck_assert_mem_eq(a->begin, b->begin, (a->n_cells + 1) * sizeof *a->begin);
    ck_assert_mem_eq(a->corners, b->corners, a->begin[a->n_cells] * sizeof *a->corners);
  }
}

/* A value of a column as a double. */
static inline double attribute_value(const gmds_attribute *a, size_t k)
{
#define ROW(name, ctype, text) \
  if (a->type == name)         \
    return (double)((const ctype *)a->data)[k];
  GMDS_VALUE_LIST(ROW)
#undef ROW
  return 0;
}

/* The attributes of a short soup as one line of text: place, name, type, values. */
static inline const char *attributes_text(const gmds_soup *soup)
{
  static char text[4096];
  size_t at = 0;
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next) {
      size_t n = (place == GMDS_OF_POINTS ? soup->n_points : soup->n_cells) * a->components;
      at += (size_t)snprintf(text + at, sizeof text - at, "%s %s %s:", place == GMDS_OF_POINTS ? "points" : "cells",
                             a->name, gmds_value_text(a->type));
      for (size_t k = 0; k < n; k++)
        at +=
            (size_t)snprintf(text + at, sizeof text - at, "%s%g", k % a->components ? "," : " ", attribute_value(a, k));
      at += (size_t)snprintf(text + at, sizeof text - at, "; ");
    }
  text[at] = 0;
  return text;
}

/* Every attribute of `a` that a format holds is in `b`: in VTK's formats and PLY it is the same bit for bit, in Gmsh's
 * the same numbers. */
static inline void assert_same_attributes(gmds_format format, const gmds_soup *a, const gmds_soup *b)
{
  int exact = format == GMDS_FORMAT_VTK || format == GMDS_FORMAT_VTU || format == GMDS_FORMAT_PLY;
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *x = a->attributes[place]; x; x = x->next) {
      size_t rows = place == GMDS_OF_POINTS ? a->n_points : a->n_cells;
      const gmds_attribute *y = gmds_soup_find_attribute(b, (gmds_place)place, x->name);
      if (!gmds_format_holds(format, a, (gmds_place)place, x))
        continue;
      if (!y && rows == 0) /* tags that are all 0 make no attribute */
        continue;
      ck_assert_msg(y != NULL, "the attribute '%s' is lost", x->name);
      ck_assert_uint_eq(x->components, y->components);
      if (exact) {
        ck_assert_int_eq(x->type, y->type);
        ck_assert(!rows || memcmp(x->data, y->data, rows * x->bytes) == 0);
      }
      for (size_t k = 0; k < rows * x->components; k++) {
        double u = attribute_value(x, k), v = attribute_value(y, k);
        if (u != v && (u == u || v == v)) /* an assertion for each value would take most of the time */
          ck_abort_msg("%s: %.17g is not %.17g", x->name, v, u);
      }
    }
}

/* A new empty folder, and a file name in it; both live until the next call. */
static inline const char *fresh_folder(void)
{
  static char folder[256];
  const char *base = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/gmds-test-XXXXXX", base && *base ? base : ".");
  ck_assert_ptr_nonnull(mkdtemp(folder));
  return folder;
}

static inline const char *path_in(const char *folder, const char *name)
{
  static char path[512];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static inline size_t files_in(const char *folder)
{
  size_t n = 0;
  DIR *directory = opendir(folder);
  ck_assert_ptr_nonnull(directory);
  while (readdir(directory))
    n++;
  closedir(directory);
  return n - 2;
}

static inline void put_file(const char *path, const void *bytes, size_t n)
{
  FILE *file = fopen(path, "wb");
  ck_assert_ptr_nonnull(file);
  ck_assert_uint_eq(fwrite(bytes, 1, n, file), n);
  ck_assert_int_eq(fclose(file), 0);
}
#endif
