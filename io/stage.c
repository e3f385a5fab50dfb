/* Building aside and committing at the end. */
#include "stage.h"
#include <string.h>

void gmds_stage_init(gmds_stage *stage, gmds_memory *memory, int dim, int points_only)
{
  *stage = (gmds_stage){.dim = dim, .points_only = points_only};
  gmds_soup_init(&stage->soup, memory, 3);
  gmds_ids_init(&stage->corners, memory);
  gmds_ids_init(&stage->sorted, memory);
}

void gmds_stage_clear(gmds_stage *stage)
{
  gmds_soup_clear(&stage->soup);
  gmds_ids_clear(&stage->corners);
  gmds_ids_clear(&stage->sorted);
}

static gmds_status said(const gmds_text *text, gmds_status status)
{
  return status == GMDS_OK ? GMDS_OK : gmds_text_failed(text, status);
}

/* Exactly what is needed at first; in steps where a file adds section after section, which would be quadratic. */
static size_t room(size_t capacity, size_t needed)
{
  return capacity && needed > capacity ? gmds_grown(capacity, needed) : needed;
}

gmds_status gmds_stage_reserve(gmds_stage *stage, const gmds_text *text, size_t points, size_t cells, size_t corners)
{
  const gmds_soup *soup = &stage->soup;
  if (points > GMDS_NONE || cells > GMDS_NONE)
    return gmds_text_failed(text, GMDS_ERR_TOO_MANY);
  return said(text, gmds_soup_reserve(&stage->soup, room(soup->point_capacity, points),
                                      room(soup->cell_capacity, cells), room(soup->corner_capacity, corners)));
}

gmds_status gmds_stage_point(gmds_stage *stage, const gmds_text *text, const double x[3])
{
  return said(text, gmds_soup_add_point(&stage->soup, x));
}

gmds_status gmds_stage_corners(gmds_stage *stage, const gmds_text *text, size_t n)
{
  GMDS_TRY(said(text, gmds_ids_reserve(&stage->corners, n)));
  stage->corners.n = n;
  return GMDS_OK;
}

/* Quadratic for the few corners of a usual cell; a polygon of many is sorted. */
static gmds_status repeats(gmds_stage *stage, size_t n, const gmds_id *corners, int *repeated)
{
  *repeated = 0;
  if (n > 16) {
    gmds_ids *sorted = &stage->sorted;
    GMDS_TRY(gmds_ids_reserve(sorted, n));
    memcpy(sorted->data, corners, n * sizeof *corners);
    sorted->n = n;
    gmds_ids_keep(sorted, 0, 2, GMDS_NONE);
    *repeated = sorted->n > 0;
    return GMDS_OK;
  }
  for (size_t i = 1; i < n; i++)
    for (size_t j = 0; j < i; j++)
      *repeated |= corners[i] == corners[j];
  return GMDS_OK;
}

gmds_status gmds_stage_cell(gmds_stage *stage, const gmds_text *text, gmds_cell_type type, size_t n,
                            const gmds_id *corners)
{
  int repeated;
  GMDS_TRY(said(text, repeats(stage, n, corners, &repeated)));
  if (!repeated)
    return said(text, gmds_soup_add_cell(&stage->soup, type, n, corners));
  stage->soup.degenerate++;
  return GMDS_OK;
}

/* The first point whose third coordinate is not 0, or n_points. */
static size_t first_off_the_plane(const gmds_soup *soup)
{
  size_t p = 0;
  while (p < soup->n_points && soup->points[3 * p + 2] == 0)
    p++;
  return p;
}

/* Drops the third coordinates, in place. */
static gmds_status flatten(gmds_soup *soup)
{
  for (size_t p = 0; p < soup->n_points; p++) {
    soup->points[2 * p] = soup->points[3 * p];
    soup->points[2 * p + 1] = soup->points[3 * p + 1];
  }
  void *points = soup->points;
  if (!gmds_resize(soup->memory, &points, 3 * soup->point_capacity, 2 * soup->n_points, sizeof *soup->points))
    return GMDS_ERR_MEMORY;
  soup->points = points;
  soup->point_capacity = soup->n_points;
  soup->dim = 2;
  return GMDS_OK;
}

static gmds_status refuse_to_flatten(const gmds_text *text, const gmds_soup *soup, size_t point)
{
  gmds_status status = GMDS_ERR_UNSUPPORTED;
  if (point < soup->n_points)
    return gmds_text_fail(text, status, (long long)point,
                          "two coordinates a point are asked for, but the third one of point %zu (from 0) is %g", point,
                          soup->points[3 * point + 2]);
  return gmds_text_fail(text, status, -1, "two coordinates a point are asked for, but the file holds volumes");
}

gmds_status gmds_stage_commit(gmds_stage *stage, const gmds_text *text, gmds_soup *soup)
{
  gmds_soup *made = &stage->soup;
  gmds_text whole = *text; /* no line is at fault now */
  whole.binary = 0;
  whole.line = 0;
  if (stage->points_only)
    made->n_cells = made->degenerate = 0;
  size_t count[4], off = first_off_the_plane(made);
  gmds_soup_count(made, count);
  int flat = off == made->n_points && !count[3];
  int dim = stage->dim ? stage->dim : flat ? 2 : 3;
  int dropped = !made->n_cells && !made->degenerate; /* points alone may lose their third coordinate */
  if (dim == 2 && !flat && !dropped)
    return refuse_to_flatten(&whole, made, off);
  if (dim == 2)
    GMDS_TRY(said(&whole, flatten(made)));
  gmds_soup_trim(made);
  gmds_soup_move(soup, made);
  return GMDS_OK;
}
