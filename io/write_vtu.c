/* Writer of VTU, VTK's unstructured grids in XML: one piece, its arrays as text or as little-endian words in base64
 * behind their length in 64 bits. A polyhedron lists its points once each and its faces in an array of their own. */
#include "value.h"
#include "writers.h"
#include <inttypes.h>
#include <string.h>

/* An array being written: bytes wait until there are three of them, which are four characters. */
typedef struct array {
  const gmds_sink *sink;
  unsigned char held[3];
  int n;
  int column; /* of the text */
} array;

static void put_group(array *a)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  unsigned bits = (unsigned)a->held[0] << 16 | (unsigned)a->held[1] << 8 | a->held[2];
  for (int k = 0; k < 4; k++)
    putc(k <= a->n ? digits[bits >> (18 - 6 * k) & 63] : '=', a->sink->file);
  memset(a->held, 0, sizeof a->held);
  a->n = 0;
}

static void put_word(array *a, uint64_t x, int bytes)
{
  for (int k = 0; k < bytes; k++) {
    a->held[a->n++] = (unsigned char)(x >> 8 * k);
    if (a->n == 3)
      put_group(a);
  }
}

static void put_whole(array *a, uint64_t x, int bytes)
{
  if (a->sink->binary)
    put_word(a, x, bytes);
  else
    fprintf(a->sink->file, "%" PRId64 "%c", (int64_t)x, ++a->column % 16 ? ' ' : '\n');
}

/* A text as the value of an attribute of XML. */
static void put_xml(FILE *file, const char *text)
{
  for (; *text; text++)
    switch (*text) {
    case '&':
      fputs("&amp;", file);
      break;
    case '<':
      fputs("&lt;", file);
      break;
    case '"':
      fputs("&quot;", file);
      break;
    default:
      putc(*text, file);
    }
}

/* The beginning of an array of `numbers` numbers of `bytes` bytes. */
static array begin(const gmds_sink *sink, const char *type, const char *name, size_t components, size_t numbers,
                   size_t bytes)
{
  array a = {.sink = sink};
  fprintf(sink->file, "<DataArray type=\"%s\" Name=\"", type);
  put_xml(sink->file, name);
  fprintf(sink->file, "\" NumberOfComponents=\"%zu\" format=\"%s\">\n", components, sink->binary ? "binary" : "ascii");
  if (sink->binary)
    put_word(&a, (uint64_t)numbers * bytes, 8);
  return a;
}

static void end(array *a)
{
  if (a->n)
    put_group(a);
  fputs("\n</DataArray>\n", a->sink->file);
}

static void write_points(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  fputs("<Points>\n", sink->file);
  array a = begin(sink, "Float64", "Points", 3, 3 * soup->n_points, 8);
  for (size_t p = 0; p < soup->n_points; p++) {
    for (int k = 0; sink->binary && k < 3; k++) {
      double x = gmds_coordinate(soup, p, k);
      uint64_t bits;
      memcpy(&bits, &x, sizeof bits);
      put_word(&a, bits, 8);
    }
    if (!sink->binary) {
      gmds_put_point(sink->file, soup, p, 3);
      putc('\n', sink->file);
    }
  }
  end(&a);
  fputs("</Points>\n", sink->file);
}

/* How many points the cells list in all. */
static gmds_status count_points(const gmds_soup *soup, gmds_ids *points, size_t *n)
{
  *n = 0;
  for (size_t c = 0; c < soup->n_cells; c++) {
    GMDS_TRY(gmds_soup_cell_points(soup, c, points));
    *n += points->n;
  }
  return GMDS_OK;
}

/* The arrays of cells. Polyhedra have their points counted before, so that lists of points cannot fail any more. */
static gmds_status write_connectivity(const gmds_sink *sink, gmds_ids *points)
{
  const gmds_soup *soup = sink->soup;
  size_t n = 0;
  uint64_t offset = 0;
  GMDS_TRY(count_points(soup, points, &n));
  array a = begin(sink, "Int64", "connectivity", 1, n, 8);
  for (size_t c = 0; c < soup->n_cells; c++) {
    GMDS_TRY(gmds_soup_cell_points(soup, c, points));
    for (size_t k = 0; k < points->n; k++)
      put_whole(&a, points->data[k], 8);
  }
  end(&a);
  a = begin(sink, "Int64", "offsets", 1, soup->n_cells, 8);
  for (size_t c = 0; c < soup->n_cells; c++) {
    GMDS_TRY(gmds_soup_cell_points(soup, c, points));
    put_whole(&a, offset += points->n, 8);
  }
  end(&a);
  return GMDS_OK;
}

/* The streams of the polyhedra, and for each cell where its stream ends, -1 where it has none. */
static void write_faces(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  uint64_t n = 0, offset = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    if (soup->types[c] == GMDS_POLYHEDRON)
      n += soup->begin[c + 1] - soup->begin[c];
  if (!n)
    return;
  array a = begin(sink, "Int64", "faces", 1, (size_t)n, 8);
  for (size_t c = 0; c < soup->n_cells; c++)
    for (size_t k = soup->begin[c]; soup->types[c] == GMDS_POLYHEDRON && k < soup->begin[c + 1]; k++)
      put_whole(&a, soup->corners[k], 8);
  end(&a);
  a = begin(sink, "Int64", "faceoffsets", 1, soup->n_cells, 8);
  for (size_t c = 0; c < soup->n_cells; c++) {
    int has_faces = soup->types[c] == GMDS_POLYHEDRON;
    offset += has_faces ? soup->begin[c + 1] - soup->begin[c] : 0;
    put_whole(&a, has_faces ? offset : UINT64_MAX, 8);
  }
  end(&a);
}

static gmds_status write_cells(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  gmds_ids points;
  gmds_ids_init(&points, soup->memory);
  fputs("<Cells>\n", sink->file);
  gmds_status status = write_connectivity(sink, &points);
  gmds_ids_clear(&points);
  if (status != GMDS_OK)
    return gmds_sink_fail(sink, status, "%s", gmds_status_text(status));
  array a = begin(sink, "UInt8", "types", 1, soup->n_cells, 1);
  for (size_t c = 0; c < soup->n_cells; c++)
    put_whole(&a, (uint64_t)gmds_vtk_number((gmds_cell_type)soup->types[c]), 1);
  end(&a);
  write_faces(sink);
  fputs("</Cells>\n", sink->file);
  return GMDS_OK;
}

/* X(type, VTU's name) */
#if GMDS_ID_BITS == 32
#  define ID_NAME "UInt32"
#else
#  define ID_NAME "UInt64"
#endif
#define TYPE_NAME_LIST(X)   \
  X(GMDS_DOUBLE, "Float64") \
  X(GMDS_FLOAT, "Float32")  \
  X(GMDS_INT, "Int32")      \
  X(GMDS_LONG, "Int64")     \
  X(GMDS_BYTE, "UInt8")     \
  X(GMDS_ID, ID_NAME)

static void write_attribute(const gmds_sink *sink, const gmds_attribute *attribute, size_t rows)
{
#define ROW(type, name) [type] = name,
  static const char *const names[GMDS_VALUE_COUNT] = {TYPE_NAME_LIST(ROW)};
#undef ROW
  size_t bytes = gmds_value_bytes(attribute->type), n = rows * attribute->components;
  array a = begin(sink, names[attribute->type], attribute->name, attribute->components, n, bytes);
  for (size_t k = 0; sink->binary && k < n; k++)
    put_word(&a, gmds_value_word(attribute, k), (int)bytes);
  for (size_t row = 0; !sink->binary && row < rows; row++) {
    gmds_put_row(sink->file, attribute, row);
    putc('\n', sink->file);
  }
  end(&a);
}

static void write_attributes(const gmds_sink *sink, gmds_place place, const char *element)
{
  const gmds_soup *soup = sink->soup;
  fprintf(sink->file, "<%s>\n", element);
  for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next)
    if (gmds_vtu_holds(soup, place, a))
      write_attribute(sink, a, gmds_rows_of(soup, place));
  fprintf(sink->file, "</%s>\n", element);
}

gmds_status gmds_write_vtu(const gmds_sink *sink)
{
  fprintf(sink->file,
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n",
          sink->soup->n_points, sink->soup->n_cells);
  write_attributes(sink, GMDS_OF_POINTS, "PointData");
  write_attributes(sink, GMDS_OF_CELLS, "CellData");
  write_points(sink);
  GMDS_TRY(write_cells(sink));
  fputs("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n", sink->file);
  return GMDS_OK;
}

/* The length of the character of UTF-8 that begins here, 0 where none does that XML would take. */
static size_t character(const unsigned char *s)
{
  static const unsigned least[] = {0, ' ', 0x80, 0x800, 0x10000};
  size_t n = *s < 0x80 ? 1 : *s >> 5 == 6 ? 2 : *s >> 4 == 14 ? 3 : *s >> 3 == 30 ? 4 : 0;
  unsigned c = n > 1 ? *s & (0x7fu >> n) : *s;
  for (size_t k = 1; k < n; k++) {
    if (s[k] >> 6 != 2)
      return 0;
    c = c << 6 | (s[k] & 0x3fu);
  }
  return !n || c < least[n] || c > 0x10ffff || c >> 11 == 27 || c == 0xfffe || c == 0xffff ? 0 : n;
}

int gmds_vtu_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  const unsigned char *s = (const unsigned char *)attribute->name;
  for (size_t n; *s; s += n)
    if (!(n = character(s)))
      return 0;
  return gmds_vtk_holds(soup, place, attribute);
}
