/* OBJ: points, and faces, lines and single points as lists of indices, which may count back from the last point.
 * Texture coordinates, normals, and groups and materials are counted once each and left out, as what follows the
 * coordinates of a point is; free-form curves and surfaces are refused. A line may go on behind a backslash. */
#include "readers.h"
#include <string.h>

/* What a file has that a mesh has no place for, one bit each. */
enum { TEXTURES = 1, NORMALS = 2, GROUPS = 4, MORE = 8, KINDS = 4 };

/* X(keyword, what it is) */
#define LEFT_OUT_LIST(X) \
  X("vt", TEXTURES)      \
  X("vn", NORMALS)       \
  X("vp", MORE)          \
  X("g", GROUPS)         \
  X("o", GROUPS)         \
  X("s", GROUPS)         \
  X("mg", GROUPS)        \
  X("usemtl", GROUPS)    \
  X("mtllib", GROUPS)    \
  X("usemap", GROUPS)    \
  X("maplib", GROUPS)    \
  X("bevel", MORE)       \
  X("c_interp", MORE)    \
  X("d_interp", MORE)    \
  X("lod", MORE)         \
  X("shadow_obj", MORE)  \
  X("trace_obj", MORE)

/* X(keyword): free forms */
#define FREE_FORM_LIST(X) \
  X("cstype")             \
  X("deg")                \
  X("bmat")               \
  X("step")               \
  X("curv")               \
  X("curv2")              \
  X("surf")

/* The next token of a line that a backslash may part. */
static int next_on_line(gmds_text *text, gmds_token *token)
{
  while (gmds_text_next_on_line(text, token)) {
    if (!gmds_token_is(*token, "\\"))
      return 1;
    gmds_text_skip_line(text);
  }
  return 0;
}

static gmds_status read_point(gmds_text *text, gmds_stage *stage, unsigned *left_out)
{
  double x[3], ignored;
  gmds_token token;
  for (int k = 0; k < 3; k++) {
    next_on_line(text, &token);
    GMDS_TRY(gmds_text_real(text, token, stage->soup.n_points, &x[k]));
  }
  while (next_on_line(text, &token)) { /* a weight, or a colour */
    *left_out |= MORE;
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, "a number", token);
  }
  return gmds_stage_point(stage, text, x);
}

/* `7`, `7/1`, `7/1/2`, `7//2`: the first number, from 1, or below 0 from the last point back. */
static gmds_status read_index(const gmds_text *text, gmds_token token, size_t n, gmds_id *id)
{
  const char *slash = memchr(token.at, '/', token.n);
  gmds_token first = {token.at, slash ? (size_t)(slash - token.at) : token.n};
  uint64_t back;
  if (first.n < 2 || *first.at != '-' || gmds_parse_count(first.at + 1, first.n - 1, &back) != GMDS_NUMBER_OK)
    return gmds_text_index(text, first, 1, n, id);
  if (!back || back > n)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "an index %llu back of %zu points", (unsigned long long)back, n);
  *id = (gmds_id)(n - back);
  return GMDS_OK;
}

static gmds_status read_indices(gmds_text *text, gmds_stage *stage)
{
  gmds_token token;
  for (size_t n = 0;; n++) {
    gmds_id id = 0;
    if (!next_on_line(text, &token))
      return gmds_stage_corners(stage, text, n);
    GMDS_TRY(read_index(text, token, stage->soup.n_points, &id));
    GMDS_TRY(gmds_stage_corners(stage, text, n + 1));
    stage->corners.data[n] = id;
  }
}

static gmds_status read_face(gmds_text *text, gmds_stage *stage)
{
  GMDS_TRY(read_indices(text, stage));
  size_t n = stage->corners.n;
  if (n < 3)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells, "a face of %zu points", n);
  return gmds_stage_cell(stage, text,
                         n == 3   ? GMDS_TRIANGLE
                         : n == 4 ? GMDS_QUADRILATERAL
                                  : GMDS_POLYGON,
                         n, stage->corners.data);
}

/* A cell for every run of k points. */
static gmds_status read_runs(gmds_text *text, gmds_stage *stage, gmds_cell_type type, size_t k)
{
  GMDS_TRY(read_indices(text, stage));
  if (stage->corners.n < k)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells, "a %s of %zu points",
                          k == 2 ? "line" : "point", stage->corners.n);
  for (size_t i = 0; i + k <= stage->corners.n; i++)
    GMDS_TRY(gmds_stage_cell(stage, text, type, k, stage->corners.data + i));
  return GMDS_OK;
}

static gmds_status skip_line(gmds_text *text, gmds_token keyword, unsigned *left_out)
{
#define ROW(word, kind) {word, kind},
  static const struct {
    const char *word;
    unsigned kind;
  } rows[] = {LEFT_OUT_LIST(ROW)};
#undef ROW
#define NAME(word) word,
  static const char *const free_forms[] = {FREE_FORM_LIST(NAME)};
#undef NAME
  gmds_token token;
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is(keyword, rows[i].word)) {
      *left_out |= rows[i].kind;
      while (next_on_line(text, &token)) {
      }
      return GMDS_OK;
    }
  for (size_t i = 0; i < sizeof free_forms / sizeof *free_forms; i++)
    if (gmds_token_is(keyword, free_forms[i]))
      return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "%s: free-form curves and surfaces are not read",
                            free_forms[i]);
  return gmds_text_expected(text, "a keyword of OBJ", keyword);
}

gmds_status gmds_read_obj(gmds_text *text, gmds_stage *stage)
{
  gmds_token keyword;
  unsigned left_out = 0;
  while (gmds_text_next(text, &keyword)) {
    if (gmds_token_is(keyword, "v"))
      GMDS_TRY(read_point(text, stage, &left_out));
    else if (gmds_token_is(keyword, "f") || gmds_token_is(keyword, "fo"))
      GMDS_TRY(read_face(text, stage));
    else if (gmds_token_is(keyword, "l"))
      GMDS_TRY(read_runs(text, stage, GMDS_SEGMENT, 2));
    else if (gmds_token_is(keyword, "p"))
      GMDS_TRY(read_runs(text, stage, GMDS_VERTEX, 1));
    else
      GMDS_TRY(skip_line(text, keyword, &left_out));
  }
  for (int k = 0; k < KINDS; k++)
    stage->soup.unread += left_out >> k & 1;
  return GMDS_OK;
}
