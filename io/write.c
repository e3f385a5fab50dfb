/* Writing: what the format cannot hold is refused before a file is touched; the file takes its name when it is whole.
 */
#define _POSIX_C_SOURCE 200809L
#include "file.h"
#include "number.h"
#include "numeric.h"
#include "writers.h"
#include <gmds/io.h>
#include <inttypes.h>
#include <math.h>

void gmds_put_point(FILE *file, const gmds_soup *soup, size_t point, int dim)
{
  for (int k = 0; k < dim; k++) {
    char text[GMDS_DOUBLE_TEXT];
    double x = k < soup->dim ? soup->points[point * (size_t)soup->dim + (size_t)k] : 0;
    size_t n = gmds_print_double(text, x);
    if (k)
      putc(' ', file);
    fwrite(text, 1, n, file);
  }
}

void gmds_put_corners(FILE *file, const gmds_soup *soup, size_t cell, unsigned base)
{
  for (size_t k = soup->begin[cell]; k < soup->begin[cell + 1]; k++)
    fprintf(file, " %" PRIu64, (uint64_t)soup->corners[k] + base);
}

enum {
  FACES = 1 << GMDS_TRIANGLE | 1 << GMDS_QUADRILATERAL | 1 << GMDS_POLYGON,
  ALL = (1 << GMDS_CELL_TYPE_COUNT) - 1,
  NOT_POLYGON = ALL & ~(1 << GMDS_POLYGON) & ~(1 << GMDS_VERTEX)
};

/* X(format, writer, types of cells that it holds) */
#define WRITER_LIST(X)                                \
  X(GMDS_FORMAT_OFF, gmds_write_off, FACES)           \
  X(GMDS_FORMAT_VTK, gmds_write_vtk, ALL)             \
  X(GMDS_FORMAT_MEDIT, gmds_write_medit, NOT_POLYGON) \
  X(GMDS_FORMAT_NODE, gmds_write_node, 0)             \
  X(GMDS_FORMAT_F64, gmds_write_f64, 0)               \
  X(GMDS_FORMAT_TEXT, gmds_write_text, 0)

typedef struct writer {
  void (*write)(FILE *, const gmds_soup *);
  int types;
  const char *text;
} writer;

static writer writer_of(gmds_format format)
{
#define ROW(name, write, types) [name] = {write, types, NULL},
  static const writer rows[GMDS_FORMAT_COUNT] = {WRITER_LIST(ROW)};
#undef ROW
#define TEXT(name, extension, text) text,
  static const char *const texts[] = {GMDS_FORMAT_LIST(TEXT)};
#undef TEXT
  writer w = rows[format];
  w.text = texts[format];
  return w;
}

static gmds_status check_content(const char *path, const writer *w, const gmds_soup *soup, gmds_error *error)
{
  for (size_t c = 0; c < soup->n_cells; c++)
    if (!(w->types >> soup->types[c] & 1)) {
      gmds_fail(error, GMDS_ERR_UNSUPPORTED, "%.200s: %s cannot hold cell %zu (from 0), whose type is %s", path,
                w->text, c, gmds_cell_type_text((gmds_cell_type)soup->types[c]));
      if (error)
        error->cell = (long long)c;
      return GMDS_ERR_UNSUPPORTED;
    }
  for (size_t i = 0; i < soup->n_points * (size_t)soup->dim; i++)
    if (!isfinite(soup->points[i])) {
      size_t point = i / (size_t)soup->dim;
      gmds_fail(error, GMDS_ERR_COORDINATE, "%.200s: a coordinate of point %zu (from 0) is not a finite number", path,
                point);
      if (error)
        error->cell = (long long)point;
      return GMDS_ERR_COORDINATE;
    }
  return GMDS_OK;
}

gmds_status gmds_write_soup(const char *path, const gmds_soup *soup, gmds_error *error)
{
  gmds_format format;
  gmds_output output;
  gmds_numeric numeric;
  GMDS_TRY(gmds_format_of_path(path, error, &format));
  writer w = writer_of(format);
  GMDS_TRY(check_content(path, &w, soup, error));
  GMDS_TRY(gmds_output_open(&output, path, error));
  gmds_status status = GMDS_OK;
  if (gmds_numeric_enter(&numeric)) {
    w.write(output.file, soup);
    gmds_numeric_leave(&numeric);
  } else {
    status = gmds_fail(error, GMDS_ERR_MEMORY, "%.200s: %s", path, gmds_status_text(GMDS_ERR_MEMORY));
  }
  return gmds_output_close(&output, status, error);
}
