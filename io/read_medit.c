/* Medit's .mesh as text: keywords, each with a number of rows and rows of a known width. Reference numbers become the
 * attributes "ref" of points and cells, where one is not 0; what is no cell (corners, ridges, normals, what must be
 * kept) and what is not known here is counted and left out. */
#include "readers.h"
#include <limits.h>

/* X(keyword, type): rows of the cell's points and a reference */
#define CELL_LIST(X)                      \
  X("Edges", GMDS_SEGMENT)                \
  X("Triangles", GMDS_TRIANGLE)           \
  X("Quadrilaterals", GMDS_QUADRILATERAL) \
  X("Tetrahedra", GMDS_TETRAHEDRON)       \
  X("Pyramids", GMDS_PYRAMID)             \
  X("Prisms", GMDS_PRISM)                 \
  X("Pentahedra", GMDS_PRISM)             \
  X("Wedges", GMDS_PRISM)                 \
  X("Hexahedra", GMDS_HEXAHEDRON)         \
  X("Hexaedra", GMDS_HEXAHEDRON)

/* X(keyword, whether a number of rows comes first, numbers a row, and how many more a coordinate) */
#define SKIP_LIST(X)                          \
  X("Corners", 1, 1, 0)                       \
  X("Ridges", 1, 1, 0)                        \
  X("RequiredVertices", 1, 1, 0)              \
  X("RequiredEdges", 1, 1, 0)                 \
  X("RequiredTriangles", 1, 1, 0)             \
  X("RequiredQuadrilaterals", 1, 1, 0)        \
  X("ParallelVertices", 1, 1, 0)              \
  X("ParallelEdges", 1, 1, 0)                 \
  X("ParallelTriangles", 1, 1, 0)             \
  X("Normals", 1, 0, 1)                       \
  X("NormalAtVertices", 1, 2, 0)              \
  X("NormalAtTriangleVertices", 1, 3, 0)      \
  X("NormalAtQuadrilateralVertices", 1, 3, 0) \
  X("Tangents", 1, 0, 1)                      \
  X("TangentAtVertices", 1, 2, 0)             \
  X("TangentAtEdges", 1, 3, 0)                \
  X("TangentAtEdgeVertices", 1, 3, 0)         \
  X("SubDomainFromMesh", 1, 4, 0)             \
  X("SubDomainFromGeom", 1, 4, 0)             \
  X("VertexOnGeometricVertex", 1, 2, 0)       \
  X("VertexOnGeometricEdge", 1, 3, 0)         \
  X("EdgeOnGeometricEdge", 1, 2, 0)           \
  X("BoundingBox", 0, 0, 2)                   \
  X("AngleOfCornerBound", 0, 1, 0)

/* X(keyword): curved cells, which are not read */
#define CURVED_LIST(X)  \
  X("EdgesP2")          \
  X("TrianglesP2")      \
  X("QuadrilateralsQ2") \
  X("TetrahedraP2")     \
  X("PyramidsP2")       \
  X("PrismsP2")         \
  X("HexahedraQ2")      \
  X("EdgesP3")          \
  X("TrianglesP3")      \
  X("QuadrilateralsQ3") \
  X("TetrahedraP3")     \
  X("HexahedraQ3")

/* `MeshVersionFormatted V`, V being 1 to 4 (the width of numbers in the binary twin of the format). */
static gmds_status read_version(gmds_text *text)
{
  gmds_token token;
  uint64_t version;
  gmds_text_next(text, &token);
  if (gmds_token_is(token, "MFEM"))
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "this is a mesh of MFEM; only Medit's .mesh is read");
  if (!gmds_token_is_any_case(token, "MeshVersionFormatted"))
    return gmds_text_expected(text, "MeshVersionFormatted", token);
  GMDS_TRY(gmds_text_next_whole(text, "a version from 1 to 4", &version));
  if (version < 1 || version > 4)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "expected a version from 1 to 4, found %llu",
                          (unsigned long long)version);
  return GMDS_OK;
}

static gmds_status read_dimension(gmds_text *text, int *dim)
{
  uint64_t x;
  GMDS_TRY(gmds_text_word(text, "Dimension"));
  GMDS_TRY(gmds_text_next_whole(text, "the dimension, 2 or 3", &x));
  if (x != 2 && x != 3)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "expected the dimension, 2 or 3, found %llu",
                          (unsigned long long)x);
  *dim = (int)x;
  return GMDS_OK;
}

/* Numbers that mean nothing here, but must be numbers. */
static gmds_status skip_numbers(gmds_text *text, size_t n, const char *what)
{
  for (size_t k = 0; k < n; k++) {
    gmds_token token;
    double ignored;
    gmds_text_next(text, &token);
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, what, token);
  }
  return GMDS_OK;
}

/* A reference number; some programs write it as a real one. */
static gmds_status read_reference(const gmds_text *text, gmds_token token, int *reference)
{
  double x;
  if (gmds_parse_double(token.at, token.n, &x) != GMDS_NUMBER_OK || x < INT_MIN || x > INT_MAX || x != (double)(int)x)
    return gmds_text_expected(text, "a reference number", token);
  *reference = (int)x;
  return GMDS_OK;
}

/* `x y [z] reference`. In a plane, gmsh writes a third coordinate for some points; the line tells. */
static gmds_status read_vertex(gmds_text *text, size_t point, int dim, double x[3], int *reference)
{
  gmds_token last, more;
  x[2] = 0;
  for (int k = 0; k < dim; k++)
    GMDS_TRY(gmds_text_next_real(text, point, &x[k]));
  gmds_text_next(text, &last);
  if (dim == 2 && gmds_text_next_on_line(text, &more)) {
    GMDS_TRY(gmds_text_real(text, last, point, &x[2]));
    GMDS_TRY(gmds_text_end_of_line(text));
    last = more;
  }
  return read_reference(text, last, reference);
}

static gmds_status read_vertices(gmds_text *text, gmds_stage *stage, int dim)
{
  size_t n;
  if (stage->soup.n_points)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "Vertices are listed a second time");
  GMDS_TRY(gmds_text_next_count(text, (size_t)dim * 2 + 2, "Vertices", &n));
  GMDS_TRY(gmds_stage_reserve(stage, text, n, 0, 0));
  for (size_t p = 0; p < n; p++) {
    double x[3];
    int reference = 0;
    GMDS_TRY(read_vertex(text, p, dim, x, &reference));
    GMDS_TRY(gmds_stage_point(stage, text, x));
    GMDS_TRY(gmds_stage_reference(stage, text, GMDS_OF_POINTS, "ref", p, reference));
  }
  return GMDS_OK;
}

static gmds_status read_cells(gmds_text *text, gmds_stage *stage, const char *keyword, gmds_cell_type type)
{
  size_t n, corners = (size_t)gmds_cell_type_points(type);
  const gmds_soup *soup = &stage->soup;
  GMDS_TRY(gmds_text_next_count(text, 2 * corners + 2, keyword, &n));
  size_t used = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  GMDS_TRY(gmds_stage_reserve(stage, text, 0, soup->n_cells + n, used + n * corners));
  for (size_t c = 0; c < n; c++) {
    gmds_id corner[8];
    gmds_token token;
    int reference = 0;
    for (size_t k = 0; k < corners; k++)
      GMDS_TRY(gmds_text_next_index(text, 1, soup->n_points, &corner[k]));
    gmds_text_next(text, &token);
    GMDS_TRY(read_reference(text, token, &reference));
    size_t before = soup->n_cells;
    GMDS_TRY(gmds_stage_cell(stage, text, type, corners, corner));
    if (soup->n_cells > before)
      GMDS_TRY(gmds_stage_reference(stage, text, GMDS_OF_CELLS, "ref", before, reference));
  }
  return GMDS_OK;
}

static gmds_status skip_rows(gmds_text *text, gmds_stage *stage, const char *keyword, int counted, size_t width)
{
  size_t n = 1;
  stage->soup.unread++;
  if (counted)
    GMDS_TRY(gmds_text_next_count(text, 2 * width, keyword, &n));
  return skip_numbers(text, n * width, "a number");
}

/* `Identifier "..."` and the like: a text on this line or the next. */
static gmds_status skip_text(gmds_text *text, gmds_stage *stage)
{
  gmds_token token;
  stage->soup.unread++;
  if (!gmds_text_next(text, &token))
    return gmds_text_expected(text, "a text", token);
  gmds_text_skip_line(text);
  return GMDS_OK;
}

static int is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/* A keyword that is not known here: a number of rows, and numbers up to the next keyword, as many for each row. */
static gmds_status skip_unknown(gmds_text *text, gmds_stage *stage, gmds_token keyword)
{
  gmds_token token;
  double ignored;
  size_t rows, n = 0;
  if (!is_letter(*keyword.at))
    return gmds_text_expected(text, "a keyword of Medit", keyword);
  GMDS_TRY(gmds_text_next_count(text, 2, "rows", &rows));
  for (;;) {
    gmds_text before = *text;
    if (!gmds_text_next(text, &token) || is_letter(*token.at)) {
      *text = before;
      break;
    }
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, "a number", token);
    n++;
  }
  if (rows ? n % rows || !n : n)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "%.*s: %zu numbers are not %zu rows",
                          keyword.n < 40 ? (int)keyword.n : 40, keyword.at, n, rows);
  stage->soup.unread++;
  return GMDS_OK;
}

/* What follows a keyword. */
static gmds_status read_section(gmds_text *text, gmds_stage *stage, gmds_token keyword, int dim)
{
#define CELL(word, type) {word, type},
  static const struct {
    const char *keyword;
    gmds_cell_type type;
  } cells[] = {CELL_LIST(CELL)};
#undef CELL
#define CURVED(word) word,
  static const char *const curved[] = {CURVED_LIST(CURVED)};
#undef CURVED
#define SKIP(word, counted, fixed, coordinates) {word, counted, fixed, coordinates},
  static const struct {
    const char *keyword;
    int counted, fixed, coordinates;
  } skipped[] = {SKIP_LIST(SKIP)};
#undef SKIP
  if (gmds_token_is_any_case(keyword, "Vertices"))
    return read_vertices(text, stage, dim);
  for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
    if (gmds_token_is_any_case(keyword, cells[i].keyword))
      return read_cells(text, stage, cells[i].keyword, cells[i].type);
  for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
    if (gmds_token_is_any_case(keyword, skipped[i].keyword))
      return skip_rows(text, stage, skipped[i].keyword, skipped[i].counted,
                       (size_t)(skipped[i].fixed + skipped[i].coordinates * dim));
  for (size_t i = 0; i < sizeof curved / sizeof *curved; i++)
    if (gmds_token_is_any_case(keyword, curved[i]))
      return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "%s: only cells of the first order are read", curved[i]);
  if (gmds_token_is_any_case(keyword, "Identifier") || gmds_token_is_any_case(keyword, "Geometry"))
    return skip_text(text, stage);
  return skip_unknown(text, stage, keyword);
}

/* The file ends with `End`; without it, it may have been cut. */
gmds_status gmds_read_medit(gmds_text *text, gmds_stage *stage)
{
  int dim = 3;
  gmds_token keyword;
  GMDS_TRY(read_version(text));
  GMDS_TRY(read_dimension(text, &dim));
  while (gmds_text_next(text, &keyword)) {
    if (gmds_token_is_any_case(keyword, "End"))
      return gmds_text_end_of_file(text);
    GMDS_TRY(read_section(text, stage, keyword, dim));
  }
  return gmds_text_expected(text, "a keyword or End", keyword);
}
