/* VTK legacy files, versions 1 to 5, ASCII and BINARY: the header, the points, and the order of the sections. */
#include "readers.h"
#include "vtk.h"

/* `# vtk DataFile Version 3.0`, a title that may be empty, ASCII or BINARY. */
static gmds_status read_header(gmds_vtk *vtk)
{
  static const char *const words[] = {"#", "vtk", "DataFile", "Version"};
  gmds_token token;
  gmds_text *text = vtk->text;
  for (int k = 0; k < 4; k++)
    GMDS_TRY(gmds_text_word(text, words[k]));
  double version;
  gmds_text_next_on_line(text, &token);
  if (gmds_parse_double(token.at, token.n, &version) != GMDS_NUMBER_OK)
    return gmds_text_expected(text, "a version", token);
  if (version < 1 || version >= 6)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "expected a version from 1 to 5, found %.*s",
                          token.n < 20 ? (int)token.n : 20, token.at);
  GMDS_TRY(gmds_text_end_of_line(text));
  gmds_text_skip_line(text);
  gmds_text_skip_line(text);
  gmds_text_next(text, &token);
  vtk->binary = gmds_token_is_any_case(token, "BINARY");
  if (vtk->binary || gmds_token_is_any_case(token, "ASCII"))
    return GMDS_OK;
  return gmds_text_expected(text, "ASCII or BINARY", token);
}

/* X(name): data sets that are known and not read */
#define OTHER_DATASET_LIST(X) \
  X("STRUCTURED_POINTS")      \
  X("STRUCTURED_GRID")        \
  X("RECTILINEAR_GRID")       \
  X("FIELD")

static gmds_status read_dataset(gmds_vtk *vtk)
{
#define NAME(name) name,
  static const char *const others[] = {OTHER_DATASET_LIST(NAME)};
#undef NAME
  gmds_token token;
  GMDS_TRY(gmds_text_word(vtk->text, "DATASET"));
  gmds_text_next(vtk->text, &token);
  vtk->polydata = gmds_token_is_any_case(token, "POLYDATA");
  if (vtk->polydata || gmds_token_is_any_case(token, "UNSTRUCTURED_GRID"))
    return GMDS_OK;
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (gmds_token_is_any_case(token, others[i]))
      return gmds_text_fail(vtk->text, GMDS_ERR_UNSUPPORTED, -1, "%s: only UNSTRUCTURED_GRID and POLYDATA are read",
                            others[i]);
  return gmds_text_expected(vtk->text, "UNSTRUCTURED_GRID or POLYDATA", token);
}

/* `POINTS n type` and three numbers a point. */
static gmds_status read_points(gmds_vtk *vtk)
{
  uint64_t n = 0;
  gmds_vtk_type type = {0};
  gmds_vtk_block block;
  if (vtk->has_points)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "POINTS are listed a second time");
  vtk->has_points = 1;
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of points", &n));
  GMDS_TRY(gmds_text_bound(vtk->text, n, 3, "points"));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  if (type.kind == GMDS_VTK_BIT || type.kind == GMDS_VTK_STRING)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "expected coordinates as numbers, found %s", type.name);
  GMDS_TRY(gmds_vtk_start(vtk, type, 3 * n, "coordinates", &block));
  GMDS_TRY(gmds_stage_reserve(vtk->stage, vtk->text, (size_t)n, 0, 0));
  for (size_t p = 0; p < (size_t)n; p++) {
    double x[3];
    for (int k = 0; k < 3; k++)
      GMDS_TRY(gmds_vtk_real(&block, p, &x[k]));
    GMDS_TRY(gmds_stage_point(vtk->stage, vtk->text, x));
  }
  *vtk->text = block.text;
  return GMDS_OK;
}

/* X(keyword, VTK's type of all its cells) */
#define POLYDATA_LIST(X) \
  X("VERTICES", 2)       \
  X("LINES", 4)          \
  X("POLYGONS", 7)       \
  X("TRIANGLE_STRIPS", 6)

static gmds_status read_section(gmds_vtk *vtk, gmds_token keyword)
{
#define ROW(keyword, type) {keyword, type},
  static const struct {
    const char *keyword;
    unsigned type;
  } rows[] = {POLYDATA_LIST(ROW)};
#undef ROW
  int known = 0;
  if (gmds_token_is_any_case(keyword, "POINTS"))
    return read_points(vtk);
  if (!vtk->polydata && gmds_token_is_any_case(keyword, "CELLS"))
    return gmds_vtk_find_cells(vtk);
  if (!vtk->polydata && gmds_token_is_any_case(keyword, "CELL_TYPES"))
    return gmds_vtk_read_types(vtk);
  for (size_t i = 0; vtk->polydata && i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is_any_case(keyword, rows[i].keyword)) {
      if (i < vtk->last_kind) /* CELL_DATA would have them in the other order */
        return gmds_text_fail(vtk->text, GMDS_ERR_UNSUPPORTED, -1, "%s behind %s: only the usual order is read",
                              rows[i].keyword, rows[vtk->last_kind].keyword);
      vtk->last_kind = i;
      return gmds_vtk_read_polydata(vtk, rows[i].type);
    }
  GMDS_TRY(gmds_vtk_read_data(vtk, keyword, &known));
  return known ? GMDS_OK : gmds_text_expected(vtk->text, "a section of VTK", keyword);
}

gmds_status gmds_read_vtk(gmds_text *text, gmds_stage *stage)
{
  gmds_vtk vtk = {.text = text, .stage = stage};
  gmds_token token;
  GMDS_TRY(read_header(&vtk));
  GMDS_TRY(read_dataset(&vtk));
  while (gmds_text_next(text, &token))
    GMDS_TRY(read_section(&vtk, token));
  if (!vtk.has_points)
    return gmds_text_expected(text, "POINTS", token);
  if (vtk.has_cells && !vtk.has_types)
    return gmds_text_expected(text, "CELL_TYPES", token);
  return GMDS_OK;
}
