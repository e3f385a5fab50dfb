/* Medit's .meshb, the binary twin of .mesh: codes of keywords, each with the position of the next, a number of rows and
 * rows of a known width, in the order of bytes of the machine that wrote them. What is no cell is counted and left out.
 */
#include "readers.h"
#include <math.h>
#include <string.h>

enum { DIMENSION = 3, VERTICES = 4, END = 54 };

/* X(code, type) */
#define CELL_LIST(X)       \
  X(5, GMDS_SEGMENT)       \
  X(6, GMDS_TRIANGLE)      \
  X(7, GMDS_QUADRILATERAL) \
  X(8, GMDS_TETRAHEDRON)   \
  X(9, GMDS_PRISM)         \
  X(10, GMDS_HEXAHEDRON)   \
  X(49, GMDS_PYRAMID)

/* X(code, keyword): curved cells, which are not read */
#define CURVED_LIST(X)      \
  X(24, "TrianglesP2")      \
  X(25, "EdgesP2")          \
  X(27, "QuadrilateralsQ2") \
  X(30, "TetrahedraP2")     \
  X(33, "HexahedraQ2")

/* Version 1 has floats, 2 doubles; 3 has positions of 64 bits, 4 all whole numbers. */
typedef struct meshb {
  gmds_text *text;
  gmds_stage *stage;
  int little, dim;
  size_t real_bytes, position_bytes, int_bytes;
} meshb;

static gmds_status take_word(meshb *m, const char *what, size_t bytes, uint64_t *x)
{
  const unsigned char *at = (const unsigned char *)m->text->at;
  if (gmds_text_left(m->text) < bytes)
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "expected %s, found the end of the file", what);
  *x = 0;
  for (size_t k = 0; k < bytes; k++)
    *x = *x << 8 | at[m->little ? bytes - 1 - k : k];
  m->text->at += bytes;
  return GMDS_OK;
}

static gmds_status read_coordinate(meshb *m, size_t point, double *x)
{
  uint64_t word = 0;
  float f;
  GMDS_TRY(take_word(m, "a coordinate", m->real_bytes, &word));
  uint32_t half = (uint32_t)word;
  memcpy(&f, &half, sizeof f);
  memcpy(x, &word, sizeof *x);
  *x = m->real_bytes == 4 ? (double)f : *x;
  if (isfinite(*x))
    return GMDS_OK;
  m->text->at -= m->real_bytes;
  return gmds_text_fail(m->text, GMDS_ERR_COORDINATE, (long long)point,
                        "a coordinate of point %zu (from 0) is not a finite number: '%g'", point, *x);
}

static gmds_status read_reference(meshb *m, int *reference)
{
  uint64_t word = 0;
  GMDS_TRY(take_word(m, "a reference number", m->int_bytes, &word));
  int64_t x = m->int_bytes == 4 ? (int32_t)(uint32_t)word : (int64_t)word;
  if (x < INT32_MIN || x > INT32_MAX)
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "the reference number %lld is too large", (long long)x);
  *reference = (int)x;
  return GMDS_OK;
}

/* A number of rows of some words, held against the bytes that remain. */
static gmds_status read_rows(meshb *m, size_t reals, size_t ints, const char *what, size_t *n)
{
  uint64_t rows = 0;
  GMDS_TRY(take_word(m, "a number of rows", m->int_bytes, &rows));
  GMDS_TRY(gmds_text_bound(m->text, rows, reals * m->real_bytes + ints * m->int_bytes, what));
  *n = (size_t)rows;
  return GMDS_OK;
}

static gmds_status read_vertices(meshb *m)
{
  size_t n = 0;
  if (m->stage->soup.n_points)
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "Vertices are listed a second time");
  GMDS_TRY(read_rows(m, (size_t)m->dim, 1, "Vertices", &n));
  GMDS_TRY(gmds_stage_reserve(m->stage, m->text, n, 0, 0));
  for (size_t p = 0; p < n; p++) {
    double x[3] = {0};
    int reference = 0;
    for (int k = 0; k < m->dim; k++)
      GMDS_TRY(read_coordinate(m, p, &x[k]));
    GMDS_TRY(read_reference(m, &reference));
    GMDS_TRY(gmds_stage_point(m->stage, m->text, x));
    GMDS_TRY(gmds_stage_reference(m->stage, m->text, GMDS_OF_POINTS, "ref", p, reference));
  }
  return GMDS_OK;
}

static gmds_status read_corner(meshb *m, gmds_id *corner)
{
  uint64_t x = 0;
  size_t n = m->stage->soup.n_points;
  GMDS_TRY(take_word(m, "an index of a point", m->int_bytes, &x));
  if (!x || x > n) {
    m->text->at -= m->int_bytes;
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "expected an index from 1 to %zu, found %llu", n,
                          (unsigned long long)x);
  }
  *corner = (gmds_id)(x - 1);
  return GMDS_OK;
}

static gmds_status read_cells(meshb *m, gmds_cell_type type)
{
  const gmds_soup *soup = &m->stage->soup;
  size_t n = 0, corners = (size_t)gmds_cell_type_points(type);
  GMDS_TRY(read_rows(m, 0, corners + 1, "cells", &n));
  size_t used = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  GMDS_TRY(gmds_stage_reserve(m->stage, m->text, 0, soup->n_cells + n, used + n * corners));
  for (size_t c = 0; c < n; c++) {
    gmds_id corner[8];
    int reference = 0;
    size_t before = soup->n_cells;
    for (size_t k = 0; k < corners; k++)
      GMDS_TRY(read_corner(m, &corner[k]));
    GMDS_TRY(read_reference(m, &reference));
    GMDS_TRY(gmds_stage_cell(m->stage, m->text, type, corners, corner));
    if (soup->n_cells > before)
      GMDS_TRY(gmds_stage_reference(m->stage, m->text, GMDS_OF_CELLS, "ref", before, reference));
  }
  return GMDS_OK;
}

/* What follows a code and the position of the next. */
static gmds_status read_section(meshb *m, uint64_t code, uint64_t next)
{
#define ROW(code, value) {code, value},
  static const struct {
    unsigned code;
    gmds_cell_type type;
  } cells[] = {CELL_LIST(ROW)};
  static const struct {
    unsigned code;
    const char *keyword;
  } curved[] = {CURVED_LIST(ROW)};
#undef ROW
  if (code == VERTICES)
    return read_vertices(m);
  for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
    if (cells[i].code == code)
      return read_cells(m, cells[i].type);
  for (size_t i = 0; i < sizeof curved / sizeof *curved; i++)
    if (curved[i].code == code)
      return gmds_text_fail(m->text, GMDS_ERR_UNSUPPORTED, -1, "%s: only cells of the first order are read",
                            curved[i].keyword);
  if (!next)
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "the keyword %llu is not known and does not say where it ends",
                          (unsigned long long)code);
  m->stage->soup.unread++;
  return GMDS_OK;
}

/* `1 version 3 position dimension`, the 1 telling the order of bytes. */
static gmds_status read_header(meshb *m)
{
  uint64_t x = 0, version = 0, dim = 0;
  if (gmds_text_left(m->text) < 4 ||
      (memcmp(m->text->at, "\1\0\0\0", 4) != 0 && memcmp(m->text->at, "\0\0\0\1", 4) != 0))
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "expected the number 1 as an int");
  m->little = *m->text->at;
  GMDS_TRY(take_word(m, "1", 4, &x));
  GMDS_TRY(take_word(m, "a version", 4, &version));
  if (version < 1 || version > 4)
    return gmds_text_fail(m->text, GMDS_ERR_UNSUPPORTED, -1, "expected a version from 1 to 4, found %llu",
                          (unsigned long long)version);
  m->real_bytes = version > 1 ? 8 : 4;
  m->position_bytes = version > 2 ? 8 : 4;
  m->int_bytes = version > 3 ? 8 : 4;
  GMDS_TRY(take_word(m, "the keyword of the dimension", 4, &x));
  if (x != DIMENSION)
    return gmds_text_fail(m->text, GMDS_ERR_FORMAT, -1, "expected the dimension, found the keyword %llu",
                          (unsigned long long)x);
  GMDS_TRY(take_word(m, "a position", m->position_bytes, &x));
  GMDS_TRY(take_word(m, "the dimension", 4, &dim));
  if (dim != 2 && dim != 3)
    return gmds_text_fail(m->text, GMDS_ERR_UNSUPPORTED, -1, "expected the dimension, 2 or 3, found %llu",
                          (unsigned long long)dim);
  m->dim = (int)dim;
  return GMDS_OK;
}

gmds_status gmds_read_meshb(gmds_text *text, gmds_stage *stage)
{
  meshb m = {.text = text, .stage = stage};
  text->binary = 1;
  text->at = text->begin;
  GMDS_TRY(read_header(&m));
  for (;;) {
    uint64_t code = 0, next = 0;
    GMDS_TRY(take_word(&m, "a keyword", 4, &code));
    if (code == END)
      return GMDS_OK; /* it may have a position, which means nothing */
    GMDS_TRY(take_word(&m, "a position", m.position_bytes, &next));
    GMDS_TRY(read_section(&m, code, next));
    uint64_t here = (uint64_t)(text->at - text->begin);
    if (next && (next < here || next - here > gmds_text_left(text)))
      return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected a position from here to the end, found %llu",
                            (unsigned long long)next);
    text->at += next ? next - here : 0;
  }
}
