/* Surfaces made up from a SPEC: a torus and a sphere of triangles. */
#include "number.h"
#include "readers.h"
#include <math.h>
#include <string.h>

static const double turn = 6.283185307179586476925;

typedef struct spec {
  const char *text; /* the whole SPEC, for sentences */
  gmds_error *error;
} spec;

static gmds_status fail_spec(const spec *s, gmds_status status)
{
  return gmds_fail(s->error, status, "%.200s: %s", s->text, gmds_status_text(status));
}

/* Room for a surface of so many points and triangles, in a soup that has none. */
static gmds_status reserve_surface(const spec *s, uint64_t points, uint64_t triangles, gmds_soup *soup)
{
  if (triangles > GMDS_NONE / 3 || points > GMDS_NONE || triangles > SIZE_MAX / 3)
    return fail_spec(s, GMDS_ERR_TOO_MANY);
  gmds_status status = gmds_soup_reserve(soup, (size_t)points, (size_t)triangles, 3 * (size_t)triangles);
  return status == GMDS_OK ? GMDS_OK : fail_spec(s, status);
}

static void put_point(gmds_soup *soup, double x, double y, double z)
{
  double *to = soup->points + 3 * soup->n_points++;
  to[0] = x;
  to[1] = y;
  to[2] = z;
}

/* A triangle, in room that is there. */
static void put_triangle(gmds_soup *soup, uint64_t a, uint64_t b, uint64_t c)
{
  gmds_id *to = soup->corners + soup->begin[soup->n_cells];
  to[0] = (gmds_id)a;
  to[1] = (gmds_id)b;
  to[2] = (gmds_id)c;
  soup->types[soup->n_cells] = GMDS_TRIANGLE;
  soup->begin[soup->n_cells + 1] = soup->begin[soup->n_cells] + 3;
  soup->n_cells++;
}

/* n points around the tube at each of n places around the torus, whose radii are 1 and 3. */
static gmds_status make_torus(const spec *s, uint64_t n, gmds_soup *soup)
{
  if (n > UINT32_MAX)
    return fail_spec(s, GMDS_ERR_TOO_MANY);
  GMDS_TRY(reserve_surface(s, n * n, 2 * n * n, soup));
  for (uint64_t i = 0; i < n; i++) {
    const double around = turn * ((double)i / (double)n), x = cos(around), y = sin(around);
    for (uint64_t j = 0; j < n; j++) {
      const double tube = turn * ((double)j / (double)n), radius = 3 + cos(tube);
      put_point(soup, radius * x, radius * y, sin(tube));
    }
  }
  for (uint64_t i = 0; i < n; i++)
    for (uint64_t j = 0; j < n; j++) {
      const uint64_t next_i = (i + 1) % n, next_j = (j + 1) % n;
      put_triangle(soup, i * n + j, next_i * n + j, next_i * n + next_j);
      put_triangle(soup, i * n + j, next_i * n + next_j, i * n + next_j);
    }
  return GMDS_OK;
}

/* Two poles, and n - 1 parallels of 2n points each. */
static gmds_status make_sphere(const spec *s, uint64_t n, gmds_soup *soup)
{
  if (n > UINT32_MAX)
    return fail_spec(s, GMDS_ERR_TOO_MANY);
  const uint64_t around = 2 * n, south = around * (n - 1), north = south + 1;
  GMDS_TRY(reserve_surface(s, north + 1, 4 * n * (n - 1), soup));
  for (uint64_t i = 1; i < n; i++) {
    const double down = turn / 2 * ((double)i / (double)n), radius = sin(down), z = -cos(down);
    for (uint64_t j = 0; j < around; j++) {
      const double angle = turn * ((double)j / (double)around);
      put_point(soup, radius * cos(angle), radius * sin(angle), z);
    }
  }
  put_point(soup, 0, 0, -1);
  put_point(soup, 0, 0, 1);
  for (uint64_t j = 0; j < around; j++)
    put_triangle(soup, south, (j + 1) % around, j);
  for (uint64_t i = 0; i + 2 < n; i++)
    for (uint64_t j = 0; j < around; j++) {
      const uint64_t a = i * around + j, b = i * around + (j + 1) % around;
      put_triangle(soup, a, b, b + around);
      put_triangle(soup, a, b + around, a + around);
    }
  for (uint64_t j = 0, last = south - around; j < around; j++)
    put_triangle(soup, last + j, last + (j + 1) % around, north);
  return GMDS_OK;
}

gmds_status gmds_make_surface(const char *text, gmds_error *error, gmds_soup *soup)
{
  static const struct {
    const char *word;
    uint64_t least;
    gmds_status (*make)(const spec *, uint64_t, gmds_soup *);
  } rows[] = {{"torus", 3, make_torus}, {"sphere", 2, make_sphere}};
  const spec s = {text, error};
  if (soup->n_points || soup->n_cells)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: the soup to make a surface in is not empty", text);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    const size_t n = strlen(rows[i].word);
    uint64_t size = 0;
    if (strncmp(text, rows[i].word, n) != 0 || text[n] != ':')
      continue;
    if (gmds_parse_count(text + n + 1, strlen(text + n + 1), &size) != GMDS_NUMBER_OK || size < rows[i].least)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: expected %s:N with a whole number from %llu", text,
                       rows[i].word, (unsigned long long)rows[i].least);
    gmds_soup made;
    gmds_soup_init(&made, soup->memory, 3);
    gmds_status status = rows[i].make(&s, size, &made);
    if (status == GMDS_OK)
      gmds_soup_move(soup, &made);
    gmds_soup_clear(&made);
    return status;
  }
  return gmds_read_soup(text, 3, error, soup);
}
