/* Building aside and committing at the end. */
#include "stage.h"
#include <string.h>

void gmds_stage_init(gmds_stage *stage, gmds_memory *memory, int dim, int points_only)
{
  *stage = (gmds_stage){.dim = dim, .points_only = points_only};
  gmds_soup_init(&stage->soup, memory, 3);
  gmds_ids_init(&stage->corners, memory);
  gmds_ids_init(&stage->sorted, memory);
  gmds_ids_init(&stage->first, memory);
}

void gmds_stage_clear(gmds_stage *stage)
{
  gmds_soup_clear(&stage->soup);
  gmds_ids_clear(&stage->corners);
  gmds_ids_clear(&stage->sorted);
  gmds_ids_clear(&stage->first);
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

/* A polyhedron is degenerate where one of its faces is. */
static gmds_status faces_repeat(gmds_stage *stage, size_t n, const gmds_id *stream, int *repeated)
{
  *repeated = 0;
  for (size_t at = 1; at < n && stream[at] < n - at && !*repeated; at += 1 + (size_t)stream[at])
    GMDS_TRY(repeats(stage, stream[at], stream + at + 1, repeated));
  return GMDS_OK;
}

gmds_status gmds_stage_cell(gmds_stage *stage, const gmds_text *text, gmds_cell_type type, size_t n,
                            const gmds_id *corners)
{
  int repeated;
  GMDS_TRY(said(text, (type == GMDS_POLYHEDRON ? faces_repeat : repeats)(stage, n, corners, &repeated)));
  if (repeated) {
    stage->soup.degenerate++;
    stage->soup.degenerate_regions += gmds_cell_type_dimension(type) == 3;
    return GMDS_OK;
  }
  gmds_status status = gmds_soup_add_cell(&stage->soup, type, n, corners);
  if (type != GMDS_POLYHEDRON || status == GMDS_OK)
    return said(text, status);
  if (status == GMDS_ERR_ARGUMENT)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells,
                          "expected a polyhedron of 4 faces or more, each of 3 points or more");
  if (status == GMDS_ERR_CELL)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells,
                          "a polyhedron with an index beyond the %zu points", stage->soup.n_points);
  return said(text, status);
}

gmds_status gmds_stage_mark(gmds_stage *stage, const gmds_text *text)
{
  return said(text, gmds_ids_push(&stage->first, (gmds_id)stage->soup.n_cells));
}

gmds_status gmds_stage_column(gmds_stage *stage, const gmds_text *text, gmds_place place, gmds_token name,
                              gmds_value type, size_t components, gmds_attribute **attribute)
{
  char copy[256];
  if (!name.n || name.n >= sizeof copy || memchr(name.at, 0, name.n))
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "the name of an attribute has 1 to %zu bytes and no 0",
                          sizeof copy - 1);
  if (!components || components > GMDS_MOST_COMPONENTS)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "expected an attribute of 1 to %d components, found %zu",
                          GMDS_MOST_COMPONENTS, components);
  if (++stage->columns > GMDS_MOST_COLUMNS)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "more than %d attributes", GMDS_MOST_COLUMNS);
  memcpy(copy, name.at, name.n);
  copy[name.n] = 0;
  gmds_status status = gmds_soup_add_attribute(&stage->soup, place, copy, type, components, attribute);
  if (status == GMDS_ERR_CONFLICT)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "the attribute '%.60s' of %s is there a second time", copy,
                          place == GMDS_OF_POINTS ? "points" : "cells");
  return said(text, status);
}

void gmds_stage_row(gmds_stage *stage, gmds_place place, gmds_attribute *attribute, size_t row, const void *values)
{
  size_t from = row, to = row + 1;
  if (place == GMDS_OF_CELLS) {
    from = stage->first.data[row];
    to = row + 1 < stage->first.n ? stage->first.data[row + 1] : stage->soup.n_cells;
  }
  for (; from < to; from++)
    memcpy((char *)attribute->data + from * attribute->bytes, values, attribute->bytes);
}

gmds_status gmds_stage_reference(gmds_stage *stage, const gmds_text *text, gmds_place place, const char *name,
                                 size_t item, int value)
{
  gmds_attribute *a = gmds_soup_find_attribute(&stage->soup, place, name);
  if (!value)
    return GMDS_OK; /* as columns begin */
  if (!a)
    GMDS_TRY(gmds_stage_column(stage, text, place, (gmds_token){name, strlen(name)}, GMDS_INT, 1, &a));
  ((int *)a->data)[item] = value;
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
  gmds_soup_trim(soup); /* attributes too have room for the points and no more */
  void *points = soup->points;
  if (!gmds_resize(soup->memory, &points, 3 * soup->n_points, 2 * soup->n_points, sizeof *soup->points))
    return GMDS_ERR_MEMORY;
  soup->points = points;
  soup->dim = 2;
  return GMDS_OK;
}

static void keep_points(gmds_soup *soup)
{
  soup->n_cells = soup->degenerate = soup->degenerate_regions = soup->unread = 0;
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    while (soup->attributes[place])
      gmds_soup_remove_attribute(soup, (gmds_place)place, soup->attributes[place]);
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
    keep_points(made);
  size_t count[4], off = first_off_the_plane(made);
  gmds_soup_count(made, count);
  int flat = off == made->n_points && !count[3] && !made->degenerate_regions;
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
