/* Files of points alone: numbers in lines, Triangle's .node, raw doubles. */
#include "readers.h"
#include <math.h>
#include <string.h>

/* Two or three numbers a line, the first line says how many; blank lines and comments between. */
gmds_status gmds_read_text(gmds_text *text, gmds_stage *stage)
{
  gmds_token token;
  int columns = 0;
  while (gmds_text_next(text, &token)) {
    text->at = token.at;
    double x[3];
    int n;
    size_t point = stage->soup.n_points;
    GMDS_TRY(gmds_text_point_line(text, point, 3, 1, x, &n));
    if (!columns)
      columns = n;
    if (n != columns)
      return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected %d coordinates, found %d", columns, n);
    GMDS_TRY(gmds_stage_point(stage, text, x));
  }
  return GMDS_OK;
}

/* A .node file's first line: points, coordinates (2; TetGen's have 3), and perhaps attributes and markers a point. */
static gmds_status read_node_header(gmds_text *text, size_t *n, int *dim, size_t *extra)
{
  gmds_token token;
  uint64_t x[3] = {2, 0, 0};
  GMDS_TRY(gmds_text_next_count(text, 5, "points", n));
  for (int k = 0; k < 3 && gmds_text_next_on_line(text, &token); k++) {
    static const char *const what[] = {"2 or 3 coordinates a point", "a number of attributes", "0 or 1 markers"};
    GMDS_TRY(gmds_text_whole(text, token, what[k], &x[k]));
    if ((k == 0 && x[0] != 2 && x[0] != 3) || (k == 2 && x[2] > 1))
      return gmds_text_expected(text, what[k], token);
  }
  GMDS_TRY(gmds_text_end_of_line(text));
  *dim = (int)x[0];
  if (*n && x[1])
    GMDS_TRY(gmds_text_bound(text, x[1], 2, "attributes a point"));
  *extra = (size_t)(x[1] + x[2]);
  return GMDS_OK;
}

/* `index x y [attributes] [marker]`; the first index, 0 or 1, says where counting starts. */
static gmds_status read_node_point(gmds_text *text, size_t point, int dim, size_t extra, uint64_t *base, double x[3])
{
  gmds_token token;
  uint64_t index;
  GMDS_TRY(gmds_text_next_whole(text, "the number of a point", &index));
  if (!point)
    *base = index;
  if (*base > 1 || index != *base + point)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected point %llu, found %llu",
                          (unsigned long long)(point ? *base + point : 0), (unsigned long long)index);
  x[2] = 0;
  for (int k = 0; k < dim; k++) {
    if (!gmds_text_next_on_line(text, &token))
      return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected %d coordinates, found %d", dim, k);
    GMDS_TRY(gmds_text_real(text, token, point, &x[k]));
  }
  for (size_t k = 0; k < extra; k++) {
    double ignored;
    gmds_text_next_on_line(text, &token);
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, "an attribute or marker", token);
  }
  return gmds_text_end_of_line(text);
}

gmds_status gmds_read_node(gmds_text *text, gmds_stage *stage)
{
  size_t n = 0, extra = 0;
  int dim = 2;
  uint64_t base = 0;
  GMDS_TRY(read_node_header(text, &n, &dim, &extra));
  stage->soup.unread += extra;
  GMDS_TRY(gmds_stage_reserve(stage, text, n, 0, 0));
  for (size_t p = 0; p < n; p++) {
    double x[3];
    GMDS_TRY(read_node_point(text, p, dim, extra, &base, x));
    GMDS_TRY(gmds_stage_point(stage, text, x));
  }
  return gmds_text_end_of_file(text);
}

static double little_endian_double(const char *bytes)
{
  uint64_t bits = 0;
  for (int k = 8; k-- > 0;)
    bits = bits << 8 | (unsigned char)bytes[k];
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

gmds_status gmds_read_f64(gmds_text *text, gmds_stage *stage)
{
  text->binary = 1;
  text->at = text->begin; /* what a text would have for a byte-order mark is part of a number here */
  size_t size = (size_t)stage->dim * 8, left = gmds_text_left(text);
  if (!stage->dim)
    return gmds_text_fail(text, GMDS_ERR_ARGUMENT, -1, "raw doubles need a number of coordinates a point: 2 or 3");
  if (left % size)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected a multiple of %zu bytes (%d doubles a point), found %zu",
                          size, stage->dim, left);
  GMDS_TRY(gmds_stage_reserve(stage, text, left / size, 0, 0));
  for (size_t p = 0; p < left / size; p++) {
    double x[3] = {0};
    for (int k = 0; k < stage->dim; k++, text->at += 8) {
      x[k] = little_endian_double(text->at);
      if (!isfinite(x[k]))
        return gmds_text_fail(text, GMDS_ERR_COORDINATE, (long long)p,
                              "a coordinate of point %zu (from 0) is not a finite number: '%g'", p, x[k]);
    }
    GMDS_TRY(gmds_stage_point(stage, text, x));
  }
  return GMDS_OK;
}
