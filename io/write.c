/* Writing: what the format cannot hold is refused before a file is touched; the file takes its name when it is whole.
 */
#define _POSIX_C_SOURCE 200809L
#include "file.h"
#include "numeric.h"
#include "writers.h"
#include <math.h>
#include <stdarg.h>

enum {
  FACES = 1 << GMDS_TRIANGLE | 1 << GMDS_QUADRILATERAL | 1 << GMDS_POLYGON,
  FLAT = FACES | 1 << GMDS_VERTEX | 1 << GMDS_SEGMENT,
  ALL = (1 << GMDS_CELL_TYPE_COUNT) - 1,
  GMSH = ALL & ~(1 << GMDS_POLYGON) & ~(1 << GMDS_POLYHEDRON),
  MEDIT = GMSH & ~(1 << GMDS_VERTEX)
};

static int holds_none(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  (void)soup, (void)place, (void)attribute;
  return 0;
}

enum { TEXT = 1, BINARY = 2, BOTH = 3 };

/* X(format, writer, types of cells that it holds, what holds attributes, encodings, that unless asked, versions, that
 * unless asked first) */
#define WRITER_LIST(X)                                                                   \
  X(GMDS_FORMAT_OFF, gmds_write_off, FACES, holds_none, TEXT, TEXT, 0, 0)                \
  X(GMDS_FORMAT_OBJ, gmds_write_obj, FLAT, holds_none, TEXT, TEXT, 0, 0)                 \
  X(GMDS_FORMAT_PLY, gmds_write_ply, FACES, gmds_ply_holds, BOTH, TEXT, 10, 0)           \
  X(GMDS_FORMAT_STL, gmds_write_stl, 1 << GMDS_TRIANGLE, holds_none, BOTH, TEXT, 0, 0)   \
  X(GMDS_FORMAT_VTK, gmds_write_vtk, ALL, gmds_vtk_holds, BOTH, TEXT, 30, 51)            \
  X(GMDS_FORMAT_VTU, gmds_write_vtu, ALL, gmds_vtu_holds, BOTH, BINARY, 10, 0)           \
  X(GMDS_FORMAT_MEDIT, gmds_write_medit, MEDIT, gmds_medit_holds, TEXT, TEXT, 20, 0)     \
  X(GMDS_FORMAT_MESHB, gmds_write_meshb, MEDIT, gmds_medit_holds, BINARY, BINARY, 30, 0) \
  X(GMDS_FORMAT_GMSH, gmds_write_gmsh, GMSH, gmds_gmsh_holds, BOTH, TEXT, 41, 22)        \
  X(GMDS_FORMAT_NODE, gmds_write_node, 0, holds_none, TEXT, TEXT, 0, 0)                  \
  X(GMDS_FORMAT_F64, gmds_write_f64, 0, holds_none, BINARY, BINARY, 0, 0)                \
  X(GMDS_FORMAT_TEXT, gmds_write_text, 0, holds_none, TEXT, TEXT, 0, 0)

typedef struct writer {
  gmds_status (*write)(const gmds_sink *);
  int types;
  int (*holds)(const gmds_soup *, gmds_place, const gmds_attribute *);
  int encodings, encoding;
  int versions[2];
  const char *text;
} writer;

static writer writer_of(gmds_format format)
{
#define ROW(name, write, types, holds, encodings, encoding, version, other) \
  [name] = {write, types, holds, encodings, encoding, {version, other}, NULL},
  static const writer rows[GMDS_FORMAT_COUNT] = {WRITER_LIST(ROW)};
#undef ROW
#define NAME(name, extension, text) text,
  static const char *const texts[] = {GMDS_FORMAT_LIST(NAME)};
#undef NAME
  writer w = rows[format];
  w.text = texts[format];
  return w;
}

int gmds_format_holds(gmds_format format, const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  return (unsigned)format < GMDS_FORMAT_COUNT && writer_of(format).holds(soup, place, attribute);
}

gmds_status gmds_sink_fail(const gmds_sink *sink, gmds_status status, const char *format, ...)
{
  char sentence[280];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(sentence, sizeof sentence, format, arguments);
  va_end(arguments);
  return gmds_fail(sink->error, status, "%.200s: %s", sink->path, sentence);
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

/* What the options ask for, or what is usual. */
static gmds_status choose(const writer *w, const gmds_write_options *options, gmds_sink *sink)
{
  int encoding = w->encoding, version = w->versions[0];
  if (options && options->encoding != GMDS_ENCODING_USUAL)
    encoding = options->encoding == GMDS_ENCODING_TEXT ? TEXT : BINARY;
  if (!(w->encodings & encoding))
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "%s is not written %s", w->text,
                          encoding == TEXT ? "as text" : "in binary");
  sink->asked = options && options->version;
  if (sink->asked)
    version = options->version;
  if (version != w->versions[0] && version != w->versions[1])
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "%s is not written in version %d.%d", w->text, version / 10,
                          version % 10);
  sink->binary = encoding == BINARY;
  sink->version = version;
  return GMDS_OK;
}

gmds_status gmds_write_soup_as(const char *path, const gmds_soup *soup, const gmds_write_options *options,
                               gmds_error *error)
{
  gmds_format format;
  gmds_output output;
  gmds_numeric numeric;
  gmds_sink sink = {.soup = soup, .path = path, .error = error};
  GMDS_TRY(gmds_format_of_path(path, error, &format));
  writer w = writer_of(format);
  GMDS_TRY(choose(&w, options, &sink));
  GMDS_TRY(check_content(path, &w, soup, error));
  GMDS_TRY(gmds_output_open(&output, path, error));
  gmds_status status = GMDS_OK;
  sink.file = output.file;
  if (gmds_numeric_enter(&numeric)) {
    status = w.write(&sink);
    gmds_numeric_leave(&numeric);
  } else {
    status = gmds_sink_fail(&sink, GMDS_ERR_MEMORY, "%s", gmds_status_text(GMDS_ERR_MEMORY));
  }
  return gmds_output_close(&output, status, error);
}

gmds_status gmds_write_soup(const char *path, const gmds_soup *soup, gmds_error *error)
{
  return gmds_write_soup_as(path, soup, NULL, error);
}
