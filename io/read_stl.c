/* STL, ASCII and binary: triangles, each with corners of its own, which are welded where all three coordinates are
 * equal. Normals are left out, as they follow from the corners; so are the two bytes behind a binary triangle, which
 * are counted where one is not 0. Triangles two corners of which are welded are left out and counted as degenerate. */
#include "readers.h"
#include <math.h>
#include <string.h>

enum { HEADER = 84, TRIANGLE = 50 };

/* The points by their coordinates: a table with open places, at least twice as many as points. */
typedef struct weld {
  gmds_id *places;
  size_t n; /* a power of two */
} weld;

static uint64_t hash(const double x[3])
{
  uint64_t h = 0;
  for (int k = 0; k < 3; k++) {
    double positive = x[k] + 0.0; /* -0 is 0 */
    uint64_t bits;
    memcpy(&bits, &positive, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

static size_t find_place(const weld *w, const gmds_soup *soup, const double x[3])
{
  size_t place = (size_t)hash(x) & (w->n - 1);
  while (w->places[place] != GMDS_NONE) {
    const double *y = soup->points + 3 * (size_t)w->places[place];
    if (x[0] == y[0] && x[1] == y[1] && x[2] == y[2])
      break;
    place = (place + 1) & (w->n - 1);
  }
  return place;
}

static gmds_status grow(gmds_text *text, weld *w, const gmds_soup *soup)
{
  weld larger = {.n = w->n ? 2 * w->n : 64};
  void *places = NULL;
  if (!gmds_resize(soup->memory, &places, 0, larger.n, sizeof *w->places))
    return gmds_text_failed(text, GMDS_ERR_MEMORY);
  larger.places = places;
  for (size_t k = 0; k < larger.n; k++)
    larger.places[k] = GMDS_NONE;
  for (size_t p = 0; p < soup->n_points; p++)
    larger.places[find_place(&larger, soup, soup->points + 3 * p)] = (gmds_id)p;
  gmds_release(soup->memory, w->places, w->n, sizeof *w->places);
  *w = larger;
  return GMDS_OK;
}

static gmds_status add_corner(gmds_text *text, gmds_stage *stage, weld *w, const double x[3], gmds_id *corner)
{
  if (stage->soup.n_points >= w->n / 2)
    GMDS_TRY(grow(text, w, &stage->soup));
  size_t place = find_place(w, &stage->soup, x);
  if (w->places[place] == GMDS_NONE) {
    gmds_id id = (gmds_id)stage->soup.n_points;
    GMDS_TRY(gmds_stage_point(stage, text, x));
    w->places[place] = id;
  }
  *corner = w->places[place];
  return GMDS_OK;
}

/* `facet normal x y z outer loop vertex x y z (three of them) endloop endfacet` */
static gmds_status read_facet(gmds_text *text, gmds_stage *stage, weld *w)
{
  gmds_id corners[3];
  gmds_token token;
  double ignored;
  GMDS_TRY(gmds_text_word(text, "normal"));
  for (int k = 0; k < 3; k++) {
    gmds_text_next(text, &token);
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE) /* which may be nan */
      return gmds_text_expected(text, "a number", token);
  }
  GMDS_TRY(gmds_text_word(text, "outer"));
  GMDS_TRY(gmds_text_word(text, "loop"));
  for (int c = 0; c < 3; c++) {
    double x[3];
    GMDS_TRY(gmds_text_word(text, "vertex"));
    for (int k = 0; k < 3; k++)
      GMDS_TRY(gmds_text_next_real(text, stage->soup.n_points, &x[k]));
    GMDS_TRY(add_corner(text, stage, w, x, &corners[c]));
  }
  GMDS_TRY(gmds_text_word(text, "endloop"));
  GMDS_TRY(gmds_text_word(text, "endfacet"));
  return gmds_stage_cell(stage, text, GMDS_TRIANGLE, 3, corners);
}

/* Solids one behind the other, their names to the end of the line. */
static gmds_status read_solids(gmds_text *text, gmds_stage *stage, weld *w)
{
  gmds_token token;
  do {
    GMDS_TRY(gmds_text_word(text, "solid"));
    gmds_text_skip_line(text);
    while (gmds_text_next(text, &token) && gmds_token_is_any_case(token, "facet"))
      GMDS_TRY(read_facet(text, stage, w));
    if (!gmds_token_is_any_case(token, "endsolid"))
      return gmds_text_expected(text, "facet or endsolid", token);
    gmds_text_skip_line(text);
    gmds_text ahead = *text;
    if (!gmds_text_next(&ahead, &token))
      return GMDS_OK;
  } while (1);
}

static uint32_t little_word(const char *at)
{
  uint32_t x = 0;
  for (int k = 4; k-- > 0;)
    x = x << 8 | (unsigned char)at[k];
  return x;
}

static gmds_status read_triangles(gmds_text *text, gmds_stage *stage, weld *w, size_t n)
{
  int more = 0;
  text->binary = 1;
  text->at = text->begin + HEADER;
  for (size_t t = 0; t < n; t++, text->at = text->begin + HEADER + t * TRIANGLE) {
    gmds_id corners[3];
    const char *at = text->at + 12; /* behind the normal */
    for (int c = 0; c < 3; c++) {
      double x[3];
      for (int k = 0; k < 3; k++, at += 4) {
        uint32_t bits = little_word(at);
        float f;
        memcpy(&f, &bits, sizeof f);
        x[k] = (double)f;
        if (!isfinite(x[k]))
          return gmds_text_fail(text, GMDS_ERR_COORDINATE, (long long)t,
                                "a coordinate of triangle %zu (from 0) is not a finite number: '%g'", t, x[k]);
      }
      GMDS_TRY(add_corner(text, stage, w, x, &corners[c]));
    }
    more |= at[0] || at[1];
    GMDS_TRY(gmds_stage_cell(stage, text, GMDS_TRIANGLE, 3, corners));
  }
  stage->soup.unread += (size_t)more;
  return GMDS_OK;
}

/* The length tells binary files, whose header may begin as a text does. */
gmds_status gmds_read_stl(gmds_text *text, gmds_stage *stage)
{
  weld w = {0};
  size_t bytes = (size_t)(text->end - text->begin);
  size_t n = bytes >= HEADER ? little_word(text->begin + HEADER - 4) : 0;
  int binary = bytes >= HEADER && bytes - HEADER == n * TRIANGLE;
  gmds_status status = binary ? read_triangles(text, stage, &w, n) : read_solids(text, stage, &w);
  gmds_release(stage->soup.memory, w.places, w.n, sizeof *w.places);
  return status;
}
