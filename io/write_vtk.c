/* Writer of VTK's legacy format: ASCII or BINARY, version 3.0 (counts and indices in turn) or 5.1 (OFFSETS and
 * CONNECTIVITY). Attributes are arrays of a field. */
#include "writers.h"
#include <inttypes.h>
#include <string.h>

/* X(type, VTK's number for it) */
#define VTK_NUMBER_LIST(X) \
  X(GMDS_VERTEX, 1)        \
  X(GMDS_SEGMENT, 3)       \
  X(GMDS_TRIANGLE, 5)      \
  X(GMDS_QUADRILATERAL, 9) \
  X(GMDS_POLYGON, 7)       \
  X(GMDS_TETRAHEDRON, 10)  \
  X(GMDS_PYRAMID, 14)      \
  X(GMDS_PRISM, 13)        \
  X(GMDS_HEXAHEDRON, 12)   \
  X(GMDS_POLYHEDRON, 42)

int gmds_vtk_number(gmds_cell_type type)
{
#define ROW(type, number) [type] = number,
  static const int numbers[GMDS_CELL_TYPE_COUNT] = {VTK_NUMBER_LIST(ROW)};
#undef ROW
  return numbers[type];
}

/* X(type, VTK's name) */
#if GMDS_ID_BITS == 32
#  define ID_NAME "unsigned_int"
#else
#  define ID_NAME "unsigned_long"
#endif
#define TYPE_NAME_LIST(X)       \
  X(GMDS_DOUBLE, "double")      \
  X(GMDS_FLOAT, "float")        \
  X(GMDS_INT, "int")            \
  X(GMDS_LONG, "long")          \
  X(GMDS_BYTE, "unsigned_char") \
  X(GMDS_ID, ID_NAME)

/* A whole number in a block of its own, or a word. */
static void put_whole(const gmds_sink *sink, uint64_t x, int bytes, char behind)
{
  if (sink->binary)
    gmds_put_word(sink->file, x, bytes, 0);
  else
    fprintf(sink->file, "%" PRIu64 "%c", x, behind);
}

static void write_points(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  fprintf(sink->file, "POINTS %zu double\n", soup->n_points);
  for (size_t p = 0; p < soup->n_points; p++) {
    if (!sink->binary) {
      gmds_put_point(sink->file, soup, p, 3);
      putc('\n', sink->file);
    }
    for (int k = 0; sink->binary && k < 3; k++)
      gmds_put_double(sink->file, gmds_coordinate(soup, p, k), 0);
  }
  if (sink->binary)
    putc('\n', sink->file);
}

/* Counts and indices in turn, in 32 bits where they are words. */
static void write_cells(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  size_t corners = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  fprintf(sink->file, "CELLS %zu %zu\n", soup->n_cells, soup->n_cells + corners);
  for (size_t c = 0; c < soup->n_cells; c++) {
    if (!sink->binary) {
      fprintf(sink->file, "%zu", soup->begin[c + 1] - soup->begin[c]);
      gmds_put_corners(sink->file, soup, c, 0);
      putc('\n', sink->file);
      continue;
    }
    gmds_put_word(sink->file, soup->begin[c + 1] - soup->begin[c], 4, 0);
    for (size_t k = soup->begin[c]; k < soup->begin[c + 1]; k++)
      gmds_put_word(sink->file, soup->corners[k], 4, 0);
  }
  if (sink->binary)
    putc('\n', sink->file);
}

static void write_offsets(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  size_t corners = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  fprintf(sink->file, "CELLS %zu %zu\nOFFSETS vtktypeint64\n", soup->n_cells + 1, corners);
  for (size_t c = 0; c <= soup->n_cells; c++)
    put_whole(sink, soup->n_cells ? soup->begin[c] : 0, 8, '\n');
  fprintf(sink->file, "%sCONNECTIVITY vtktypeint64\n", sink->binary ? "\n" : "");
  for (size_t k = 0; k < corners; k++)
    put_whole(sink, soup->corners[k], 8, '\n');
  if (sink->binary)
    putc('\n', sink->file);
}

/* A name with what would end it, or stand for something else, as `%` and two digits. */
static void put_name(FILE *file, const char *name)
{
  for (; *name; name++)
    if (*name > ' ' && *name <= '~' && *name != '%' && *name != '"')
      putc(*name, file);
    else
      fprintf(file, "%%%02X", (unsigned)(unsigned char)*name);
}

static void write_attribute(const gmds_sink *sink, const gmds_attribute *a, size_t rows)
{
#define ROW(type, name) [type] = name,
  static const char *const names[GMDS_VALUE_COUNT] = {TYPE_NAME_LIST(ROW)};
#undef ROW
  put_name(sink->file, a->name);
  fprintf(sink->file, " %zu %zu %s\n", a->components, rows, names[a->type]);
  for (size_t k = 0; sink->binary && k < rows * a->components; k++)
    gmds_put_word(sink->file, gmds_value_word(a, k), (int)gmds_value_bytes(a->type), 0);
  for (size_t row = 0; !sink->binary && row < rows; row++) {
    gmds_put_row(sink->file, a, row);
    putc('\n', sink->file);
  }
  if (sink->binary)
    putc('\n', sink->file);
}

static void write_attributes(const gmds_sink *sink, gmds_place place, const char *keyword)
{
  size_t n = 0, rows = gmds_rows_of(sink->soup, place);
  for (const gmds_attribute *a = sink->soup->attributes[place]; a; a = a->next)
    n++;
  if (!n)
    return;
  fprintf(sink->file, "%s %zu\nFIELD FieldData %zu\n", keyword, rows, n);
  for (const gmds_attribute *a = sink->soup->attributes[place]; a; a = a->next)
    write_attribute(sink, a, rows);
}

gmds_status gmds_write_vtk(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  int offsets = sink->version > 50;
  size_t numbers = soup->n_cells + (soup->n_cells ? soup->begin[soup->n_cells] : 0);
  if (sink->binary && !offsets && (numbers > INT32_MAX || soup->n_points > INT32_MAX))
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED,
                          "binary VTK 3.0 has indices of 32 bits, which are too few; 5.1 has 64");
  fprintf(sink->file, "# vtk DataFile Version %s\ngmds\n%s\nDATASET UNSTRUCTURED_GRID\n", offsets ? "5.1" : "3.0",
          sink->binary ? "BINARY" : "ASCII");
  write_points(sink);
  (offsets ? write_offsets : write_cells)(sink);
  fprintf(sink->file, "CELL_TYPES %zu\n", soup->n_cells);
  for (size_t c = 0; c < soup->n_cells; c++)
    put_whole(sink, (uint64_t)gmds_vtk_number((gmds_cell_type)soup->types[c]), 4, '\n');
  if (sink->binary)
    putc('\n', sink->file);
  write_attributes(sink, GMDS_OF_POINTS, "POINT_DATA");
  write_attributes(sink, GMDS_OF_CELLS, "CELL_DATA");
  return GMDS_OK;
}

int gmds_vtk_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  (void)soup, (void)place;
  return attribute->components <= 1000 && strlen(attribute->name) < 256;
}
