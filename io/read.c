/* Reading: from an extension to a format, from a format to its reader, and the soup handed over at the end. */
#define _POSIX_C_SOURCE 200809L
#include "file.h"
#include "numeric.h"
#include "readers.h"
#include <string.h>

/* X(format, extension): what else stands for a format beside the extension of GMDS_FORMAT_LIST */
#define OTHER_EXTENSION_LIST(X) \
  X(GMDS_FORMAT_TEXT, ".xy")    \
  X(GMDS_FORMAT_TEXT, ".xyz")   \
  X(GMDS_FORMAT_TEXT, ".csv")

gmds_status gmds_format_of_path(const char *path, gmds_error *error, gmds_format *format)
{
#define MAIN_ROW(name, extension, text) {extension, name},
#define OTHER_ROW(name, extension) {extension, name},
  static const struct {
    const char *extension;
    gmds_format format;
  } rows[] = {GMDS_FORMAT_LIST(MAIN_ROW) OTHER_EXTENSION_LIST(OTHER_ROW)};
#undef MAIN_ROW
#undef OTHER_ROW
#define MAIN_TEXT(name, extension, text) " " extension
#define OTHER_TEXT(name, extension) " " extension
  static const char known[] = GMDS_FORMAT_LIST(MAIN_TEXT) OTHER_EXTENSION_LIST(OTHER_TEXT);
#undef MAIN_TEXT
#undef OTHER_TEXT
  size_t n = strlen(path), most = 200;
  const char *dot = strrchr(path, '.');
  gmds_token extension = {dot ? dot : path, dot ? strlen(dot) : 0};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is_any_case(extension, rows[i].extension)) {
      *format = rows[i].format;
      return GMDS_OK;
    }
  return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "%s: the extension says no format; known are%s",
                   n > most ? path + (n - most) : path, known);
}

/* X(format, reader, what begins a comment or 0) */
#define READER_LIST(X)                       \
  X(GMDS_FORMAT_OFF, gmds_read_off, '#')     \
  X(GMDS_FORMAT_OBJ, gmds_read_obj, '#')     \
  X(GMDS_FORMAT_PLY, gmds_read_ply, 0)       \
  X(GMDS_FORMAT_STL, gmds_read_stl, 0)       \
  X(GMDS_FORMAT_VTK, gmds_read_vtk, 0)       \
  X(GMDS_FORMAT_VTU, gmds_read_vtu, 0)       \
  X(GMDS_FORMAT_MEDIT, gmds_read_medit, '#') \
  X(GMDS_FORMAT_MESHB, gmds_read_meshb, 0)   \
  X(GMDS_FORMAT_GMSH, gmds_read_gmsh, 0)     \
  X(GMDS_FORMAT_NODE, gmds_read_node, '#')   \
  X(GMDS_FORMAT_F64, gmds_read_f64, 0)       \
  X(GMDS_FORMAT_TEXT, gmds_read_text, '#')

static gmds_status read_format(gmds_format format, gmds_text *text, gmds_stage *stage)
{
#define ROW(name, reader, comment) [name] = {reader, comment},
  static const struct {
    gmds_status (*read)(gmds_text *, gmds_stage *);
    char comment;
  } rows[GMDS_FORMAT_COUNT] = {READER_LIST(ROW)};
#undef ROW
  text->comment = rows[format].comment;
  return rows[format].read(text, stage);
}

static gmds_status read_bytes(gmds_format format, gmds_text *text, gmds_stage *stage, gmds_soup *soup)
{
  gmds_numeric numeric;
  if (!gmds_numeric_enter(&numeric))
    return gmds_text_failed(text, GMDS_ERR_MEMORY);
  gmds_status status = read_format(format, text, stage);
  gmds_numeric_leave(&numeric);
  return status == GMDS_OK ? gmds_stage_commit(stage, text, soup) : status;
}

static gmds_status check_arguments(const char *name, int dim, const gmds_soup *soup, gmds_error *error)
{
  if (dim != 0 && dim != 2 && dim != 3)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: %d coordinates a point are asked for: neither 2 nor 3", name,
                     dim);
  if (soup->n_points || soup->n_cells)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: the soup to read into is not empty", name);
  return GMDS_OK;
}

gmds_status gmds_read_soup_from_memory(gmds_format format, const char *name, const void *bytes, size_t n, int dim,
                                       gmds_error *error, gmds_soup *soup)
{
  GMDS_TRY(check_arguments(name, dim, soup, error));
  if ((unsigned)format >= GMDS_FORMAT_COUNT)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: no such format", name);
  gmds_text text;
  gmds_text_init(&text, name, bytes, n, 0, error);
  gmds_stage stage;
  gmds_stage_init(&stage, soup->memory, dim, 0);
  gmds_status status = read_bytes(format, &text, &stage, soup);
  gmds_stage_clear(&stage);
  return status;
}

gmds_status gmds_read_file(const char *path, int dim, int points_only, gmds_error *error, gmds_soup *soup)
{
  gmds_format format;
  gmds_bytes bytes;
  GMDS_TRY(check_arguments(path, dim, soup, error));
  GMDS_TRY(gmds_format_of_path(path, error, &format));
  GMDS_TRY(gmds_bytes_read(path, soup->memory, error, &bytes));
  gmds_text text;
  gmds_text_init(&text, path, bytes.data, bytes.n, 0, error);
  gmds_stage stage;
  gmds_stage_init(&stage, soup->memory, dim, points_only);
  gmds_status status = read_bytes(format, &text, &stage, soup);
  gmds_stage_clear(&stage);
  gmds_bytes_clear(&bytes);
  return status;
}

gmds_status gmds_read_soup(const char *path, int dim, gmds_error *error, gmds_soup *soup)
{
  return gmds_read_file(path, dim, 0, error, soup);
}
