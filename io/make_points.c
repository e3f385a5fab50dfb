/* Points made up from a SPEC: the same ones on every machine that has the same cosine, and for `random` and `grid` on
 * every one. */
#include "mersenne.h"
#include "number.h"
#include "readers.h"
#include <math.h>
#include <string.h>

typedef struct spec {
  const char *text; /* the whole SPEC, for sentences */
  int dim;
  uint64_t n, seed;
  gmds_error *error;
} spec;

static gmds_status fail_spec(const spec *s, gmds_status status)
{
  return gmds_fail(s->error, status, "%.200s: %s", s->text, gmds_status_text(status));
}

/* Room for n points, in a soup that has none. */
static gmds_status reserve_points(const spec *s, uint64_t n, gmds_soup *soup)
{
  if (n > GMDS_NONE || n > SIZE_MAX)
    return fail_spec(s, GMDS_ERR_TOO_MANY);
  gmds_status status = gmds_soup_reserve(soup, (size_t)n, 0, 0);
  return status == GMDS_OK ? GMDS_OK : fail_spec(s, status);
}

static gmds_status make_random(const spec *s, gmds_soup *soup)
{
  GMDS_TRY(reserve_points(s, s->n, soup));
  gmds_mersenne random;
  gmds_mersenne_seed(&random, s->seed);
  soup->n_points = (size_t)s->n;
  for (size_t i = 0; i < soup->n_points * (size_t)s->dim; i++)
    soup->points[i] = gmds_mersenne_unit(&random);
  return GMDS_OK;
}

static gmds_status make_grid(const spec *s, gmds_soup *soup)
{
  uint64_t side = s->n, total = 1;
  for (int d = 0; d < s->dim; d++) {
    if (side && total > UINT64_MAX / side)
      return fail_spec(s, GMDS_ERR_TOO_MANY);
    total *= side;
  }
  GMDS_TRY(reserve_points(s, total, soup));
  for (double *x = soup->points; soup->n_points < (size_t)total; x += s->dim) {
    uint64_t rest = soup->n_points++;
    for (int d = s->dim; d-- > 0; rest /= side)
      x[d] = (double)(rest % side);
  }
  return GMDS_OK;
}

static gmds_status make_circle(const spec *s, gmds_soup *soup)
{
  GMDS_TRY(reserve_points(s, s->n, soup));
  const double turn = 6.283185307179586476925;
  soup->n_points = (size_t)s->n;
  for (size_t k = 0; k < soup->n_points; k++) {
    double *x = soup->points + k * (size_t)s->dim, angle = turn * ((double)k / (double)s->n);
    x[0] = cos(angle);
    x[1] = sin(angle);
    if (s->dim == 3)
      x[2] = 0;
  }
  return GMDS_OK;
}

/* Each cluster has a centre in the unit square and a radius from 0.1 to 1e-9; an offset is the sum of four uniform
 * variates, which looks much like a normal one. */
static gmds_status make_clusters(const spec *s, gmds_soup *soup)
{
  static const double radii[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  GMDS_TRY(reserve_points(s, s->n, soup));
  size_t clusters = (size_t)(sqrt((double)s->n) / 10) + 1, width = (size_t)s->dim + 1;
  void *block = NULL;
  if (!gmds_resize(soup->memory, &block, 0, clusters, width * sizeof(double)))
    return fail_spec(s, GMDS_ERR_MEMORY);
  double *cluster = block;
  gmds_mersenne random;
  gmds_mersenne_seed(&random, s->seed);
  for (size_t c = 0; c < clusters; c++) {
    for (size_t d = 0; d + 1 < width; d++)
      cluster[c * width + d] = gmds_mersenne_unit(&random);
    cluster[c * width + width - 1] = radii[gmds_mersenne_bits(&random) % (sizeof radii / sizeof *radii)];
  }
  soup->n_points = (size_t)s->n;
  for (size_t p = 0; p < soup->n_points; p++) {
    const uint64_t which =
        gmds_mersenne_bits(&random) % clusters; /* NOLINT(clang-analyzer-core.DivideZero): 1 at least */
    const double *centre = cluster + which * width;
    for (size_t d = 0; d + 1 < width; d++) {
      double offset = -2;
      for (int k = 0; k < 4; k++)
        offset += gmds_mersenne_unit(&random);
      soup->points[p * (width - 1) + d] = centre[d] + offset * centre[width - 1];
    }
  }
  gmds_release(soup->memory, block, clusters, width * sizeof(double));
  return GMDS_OK;
}

/* X(word, whether a seed follows, maker, form) */
#define SPEC_LIST(X)                           \
  X("random", 1, make_random, "random:N:SEED") \
  X("grid", 0, make_grid, "grid:N")            \
  X("circle", 0, make_circle, "circle:N")      \
  X("clusters", 1, make_clusters, "clusters:N:SEED")

/* Whole numbers and nothing else after the colon: N, and SEED where there is one. */
static int parse_spec(const char *numbers, int seed, spec *s)
{
  const char *colon = strchr(numbers, ':');
  if ((colon != NULL) != seed)
    return 0;
  size_t n = colon ? (size_t)(colon - numbers) : strlen(numbers);
  return gmds_parse_count(numbers, n, &s->n) == GMDS_NUMBER_OK &&
         (!seed || gmds_parse_count(colon + 1, strlen(colon + 1), &s->seed) == GMDS_NUMBER_OK);
}

gmds_status gmds_make_points(const char *text, int dim, gmds_error *error, gmds_soup *soup)
{
  static const struct {
    const char *word;
    int seed;
    gmds_status (*make)(const spec *, gmds_soup *);
    const char *form;
  } rows[] = {
#define ROW(word, seed, make, form) {word, seed, make, form},
      SPEC_LIST(ROW)
#undef ROW
  };
  spec s = {.text = text, .dim = dim, .error = error};
  if (dim != 2 && dim != 3)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: %d coordinates a point are asked for: neither 2 nor 3", text,
                     dim);
  if (soup->n_points || soup->n_cells)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: the soup to make points in is not empty", text);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    size_t n = strlen(rows[i].word);
    if (strncmp(text, rows[i].word, n) != 0 || text[n] != ':')
      continue;
    if (!parse_spec(text + n + 1, rows[i].seed, &s))
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "%.200s: expected %s with whole numbers from 0", text, rows[i].form);
    gmds_soup made;
    gmds_soup_init(&made, soup->memory, dim);
    gmds_status status = rows[i].make(&s, &made);
    if (status == GMDS_OK)
      gmds_soup_move(soup, &made);
    gmds_soup_clear(&made);
    return status;
  }
  return gmds_read_file(text, dim, 1, error, soup);
}
