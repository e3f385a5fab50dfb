/* OFF: points, then faces as lists of points. A face of one or two points is a vertex or an edge, as Geomview has it;
 * colours, normals and texture coordinates are checked to be numbers and left out. */
#include "readers.h"

/* X(header, whether numbers may follow the coordinates of a point) */
#define HEADER_LIST(X) \
  X("OFF", 0)          \
  X("COFF", 1)         \
  X("NOFF", 1)         \
  X("CNOFF", 1)        \
  X("STOFF", 1)        \
  X("STCOFF", 1)       \
  X("STNOFF", 1)       \
  X("STCNOFF", 1)

/* X(header): known, but not read */
#define REFUSED_LIST(X) \
  X("4OFF")             \
  X("nOFF")             \
  X("C4OFF")            \
  X("CnOFF")

static gmds_status read_header(gmds_text *text, int *decorated)
{
#define ROW(header, more) {header, more},
  static const struct {
    const char *header;
    int decorated;
  } rows[] = {HEADER_LIST(ROW)};
#undef ROW
#define NAME(header) header,
  static const char *const refused[] = {REFUSED_LIST(NAME)};
#undef NAME
  gmds_token token;
  gmds_text_next(text, &token);
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
    if (gmds_token_is(token, refused[i]))
      return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "%s: only points in space are read, OFF", refused[i]);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is(token, rows[i].header)) {
      *decorated = rows[i].decorated;
      return GMDS_OK;
    }
  return gmds_text_expected(text, "OFF", token);
}

/* Points and faces; the number of edges that follows on the same line is read past, and may be missing. */
static gmds_status read_counts(gmds_text *text, size_t *points, size_t *faces)
{
  gmds_token token;
  uint64_t edges;
  gmds_text_next(text, &token);
  if (gmds_token_is(token, "BINARY"))
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "OFF BINARY: only OFF as text is read");
  text->at = token.at;
  GMDS_TRY(gmds_text_next_count(text, 4, "points", points));
  GMDS_TRY(gmds_text_next_count(text, 2, "faces", faces));
  if (gmds_text_next_on_line(text, &token))
    GMDS_TRY(gmds_text_whole(text, token, "a number of edges", &edges));
  return gmds_text_end_of_line(text);
}

/* Numbers to the end of the line, where they are allowed; that a file has them counts once. */
static gmds_status skip_numbers(gmds_text *text, gmds_stage *stage, const char *what)
{
  gmds_token token;
  while (gmds_text_next_on_line(text, &token)) {
    double ignored;
    stage->soup.unread = 1;
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, what, token);
  }
  return GMDS_OK;
}

/* Points with colours have three coordinates, then other numbers. Others have as many as the first: two or three. */
static gmds_status read_point(gmds_text *text, gmds_stage *stage, size_t point, int decorated, int *columns,
                              double x[3])
{
  gmds_token token;
  if (!gmds_text_next(text, &token))
    return gmds_text_expected(text, "a point", token);
  text->at = token.at;
  if (decorated) {
    for (int k = 0; k < 3; k++) {
      gmds_text_next_on_line(text, &token);
      GMDS_TRY(gmds_text_real(text, token, point, &x[k]));
    }
    return skip_numbers(text, stage, "a colour, normal or texture coordinate");
  }
  int n;
  GMDS_TRY(gmds_text_point_line(text, point, 3, 0, x, &n));
  if (!point)
    *columns = n;
  if (n == *columns)
    return GMDS_OK;
  return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected %d coordinates, found %d", *columns, n);
}

static gmds_cell_type type_of_face(size_t n)
{
  static const gmds_cell_type small[] = {GMDS_VERTEX, GMDS_VERTEX, GMDS_SEGMENT, GMDS_TRIANGLE, GMDS_QUADRILATERAL};
  return n < sizeof small / sizeof *small ? small[n] : GMDS_POLYGON;
}

static gmds_status read_face(gmds_text *text, gmds_stage *stage)
{
  size_t n;
  GMDS_TRY(gmds_text_next_count(text, 2, "points of a face", &n));
  if (!n)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells, "a face without points");
  GMDS_TRY(gmds_stage_corners(stage, text, n));
  for (size_t k = 0; k < n; k++) {
    gmds_token token;
    gmds_text_next_on_line(text, &token);
    GMDS_TRY(gmds_text_index(text, token, 0, stage->soup.n_points, &stage->corners.data[k]));
  }
  GMDS_TRY(skip_numbers(text, stage, "a colour"));
  return gmds_stage_cell(stage, text, type_of_face(n), n, stage->corners.data);
}

gmds_status gmds_read_off(gmds_text *text, gmds_stage *stage)
{
  size_t points = 0, faces = 0;
  int decorated = 0, columns = 3;
  GMDS_TRY(read_header(text, &decorated));
  GMDS_TRY(read_counts(text, &points, &faces));
  GMDS_TRY(gmds_stage_reserve(stage, text, points, 0, 0));
  for (size_t p = 0; p < points; p++) {
    double x[3];
    GMDS_TRY(read_point(text, stage, p, decorated, &columns, x));
    GMDS_TRY(gmds_stage_point(stage, text, x));
  }
  GMDS_TRY(gmds_text_bound(text, faces, 4, "faces"));
  GMDS_TRY(gmds_stage_reserve(stage, text, points, faces, 0));
  for (size_t f = 0; f < faces; f++)
    GMDS_TRY(read_face(text, stage));
  return gmds_text_end_of_file(text);
}
