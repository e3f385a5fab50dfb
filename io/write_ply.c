/* Writer of PLY, ASCII and binary_little_endian: vertices of doubles and faces, an attribute of one component as a
 * number of each. */
#include "value.h"
#include "writers.h"
#include <inttypes.h>
#include <string.h>

/* X(type, PLY's name) */
#define TYPE_NAME_LIST(X)  \
  X(GMDS_DOUBLE, "double") \
  X(GMDS_FLOAT, "float")   \
  X(GMDS_INT, "int")       \
  X(GMDS_BYTE, "uchar")    \
  X(GMDS_ID, "uint")

static void write_properties(const gmds_sink *sink, gmds_place place)
{
#define ROW(type, name) [type] = name,
  static const char *const names[GMDS_VALUE_COUNT] = {TYPE_NAME_LIST(ROW)};
#undef ROW
  for (const gmds_attribute *a = sink->soup->attributes[place]; a; a = a->next)
    if (gmds_ply_holds(sink->soup, place, a))
      fprintf(sink->file, "property %s %s\n", names[a->type], a->name);
}

/* The attributes of one row, and the end of its line. */
static void write_values(const gmds_sink *sink, gmds_place place, size_t row)
{
  for (const gmds_attribute *a = sink->soup->attributes[place]; a; a = a->next) {
    if (!gmds_ply_holds(sink->soup, place, a))
      continue;
    if (sink->binary) {
      gmds_put_word(sink->file, gmds_value_word(a, row), (int)gmds_value_bytes(a->type), 1);
    } else {
      putc(' ', sink->file);
      gmds_put_row(sink->file, a, row);
    }
  }
  if (!sink->binary)
    putc('\n', sink->file);
}

static void write_face(const gmds_sink *sink, size_t cell)
{
  const gmds_soup *soup = sink->soup;
  size_t n = soup->begin[cell + 1] - soup->begin[cell];
  if (!sink->binary) {
    fprintf(sink->file, "%zu", n);
    gmds_put_corners(sink->file, soup, cell, 0);
    return;
  }
  gmds_put_word(sink->file, n, 4, 1);
  for (size_t k = soup->begin[cell]; k < soup->begin[cell + 1]; k++)
    gmds_put_word(sink->file, soup->corners[k], 4, 1);
}

gmds_status gmds_write_ply(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  if (soup->n_points > INT32_MAX)
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "PLY has indices of 32 bits, which are too few");
  fprintf(sink->file,
          "ply\nformat %s 1.0\nelement vertex %zu\nproperty double x\nproperty double y\nproperty double z\n",
          sink->binary ? "binary_little_endian" : "ascii", soup->n_points);
  write_properties(sink, GMDS_OF_POINTS);
  fprintf(sink->file, "element face %zu\nproperty list int int vertex_indices\n", soup->n_cells);
  write_properties(sink, GMDS_OF_CELLS);
  fputs("end_header\n", sink->file);
  for (size_t p = 0; p < soup->n_points; p++) {
    if (!sink->binary)
      gmds_put_point(sink->file, soup, p, 3);
    for (int k = 0; sink->binary && k < 3; k++)
      gmds_put_double(sink->file, gmds_coordinate(soup, p, k), 1);
    write_values(sink, GMDS_OF_POINTS, p);
  }
  for (size_t c = 0; c < soup->n_cells; c++) {
    write_face(sink, c);
    write_values(sink, GMDS_OF_CELLS, c);
  }
  return GMDS_OK;
}

int gmds_ply_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  static const char *const taken[] = {"x", "y", "z"};
  (void)soup;
  if (attribute->components != 1 || attribute->type == GMDS_LONG || (attribute->type == GMDS_ID && GMDS_ID_BITS != 32))
    return 0;
  for (const char *s = attribute->name; *s; s++)
    if (*s <= ' ' || *s > '~')
      return 0;
  for (size_t k = 0; place == GMDS_OF_POINTS && k < sizeof taken / sizeof *taken; k++)
    if (strcmp(attribute->name, taken[k]) == 0)
      return 0;
  return strlen(attribute->name) < 256;
}
