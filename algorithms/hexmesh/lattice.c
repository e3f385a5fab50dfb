/* Snapping a surface to the lattice. */
#include "sides.h"
#include <gmds/lattice.h>
#include <float.h>
#include <inttypes.h>
#include <math.h>

static const char axis_name[] = "xyz";

void gmds_lattice_init(gmds_lattice *lattice, gmds_memory *memory)
{
  *lattice = (gmds_lattice){.memory = memory};
}

void gmds_lattice_clear(gmds_lattice *lattice)
{
  gmds_release(lattice->memory, lattice->triangles, lattice->n_triangles, 9 * sizeof *lattice->triangles);
  gmds_lattice_init(lattice, lattice->memory);
}

void gmds_lattice_point(const gmds_lattice *lattice, const uint32_t at[3], double x[3])
{
  for (int a = 0; a < 3; a++) {
    const double along = (double)at[a] * lattice->step[a];
    x[a] = lattice->low[a] + along;
  }
}

/* Options with what 0 stands for. */
static gmds_status read_options(const gmds_lattice_options *given, gmds_lattice_options *o)
{
  *o = given ? *given : (gmds_lattice_options){.threads = 1};
  for (int a = 0; a < 3; a++) {
    o->base[a] = o->base[a] ? o->base[a] : 1;
    if (o->base[a] > GMDS_LATTICE_MAX_BASE)
      return gmds_fail(o->error, GMDS_ERR_ARGUMENT, "%" PRIu32 " base cells along %c: there can be from 1 to %d",
                       o->base[a], axis_name[a], (int)GMDS_LATTICE_MAX_BASE);
  }
  o->margin = o->margin == 0 ? 0x1p-7 : o->margin;
  if (!(o->margin > 0 && o->margin <= 1))
    return gmds_fail(o->error, GMDS_ERR_ARGUMENT, "a margin of %g: it can be up to 1", o->margin);
  o->threads = o->threads ? o->threads : 1;
  return GMDS_OK;
}

/* Every edge must have two faces. */
static gmds_status check_closed(const gmds_surface *s, gmds_error *error)
{
  if (!s->n_faces)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "a surface of no faces has no inside");
  for (gmds_id d = 0; s->n_border && d < s->n_darts; d++) {
    if (s->beta2[d] != GMDS_NONE)
      continue;
    const gmds_id f = gmds_surface_listed(s, gmds_surface_face(s, d));
    gmds_fail(error, GMDS_ERR_ARGUMENT,
              "the surface is open: the edge of vertices %" GMDS_PRIid " and %" GMDS_PRIid
              " has one face, %" GMDS_PRIid,
              s->origin[d], s->origin[gmds_surface_beta1(s, d)], f);
    if (error)
      error->cell = (long long)f;
    return GMDS_ERR_ARGUMENT;
  }
  return GMDS_OK;
}

/* The bounding box of what faces have, all of it finite. */
static gmds_status find_box(const gmds_surface *s, const double *points, double low[3], double high[3],
                            gmds_error *error)
{
  for (int a = 0; a < 3; a++)
    low[a] = INFINITY, high[a] = -INFINITY;
  for (size_t d = 0; d < s->n_darts; d++) {
    const double *x = points + 3 * (size_t)s->origin[d];
    if (!isfinite(x[0]) || !isfinite(x[1]) || !isfinite(x[2])) {
      gmds_fail(error, GMDS_ERR_COORDINATE, "vertex %" GMDS_PRIid " has a coordinate that is not a finite number",
                s->origin[d]);
      if (error)
        error->cell = (long long)s->origin[d];
      return GMDS_ERR_COORDINATE;
    }
    for (int a = 0; a < 3; a++) {
      low[a] = x[a] < low[a] ? x[a] : low[a];
      high[a] = x[a] > high[a] ? x[a] : high[a];
    }
  }
  return GMDS_OK;
}

/* The lattice over the box, widened by the margin. */
static gmds_status lay_lattice(gmds_lattice *l, const gmds_lattice_options *o, const double low[3],
                               const double high[3])
{
  uint32_t most = 1;
  for (int a = 0; a < 3; a++)
    most = o->base[a] > most ? o->base[a] : most;
  while (((uint64_t)most << (l->bits + 1)) <= (uint64_t)1 << GMDS_LATTICE_BITS)
    l->bits++;
  for (int a = 0; a < 3; a++) {
    const double extent = high[a] - low[a], wide = extent * (1 + 2 * o->margin);
    l->base[a] = o->base[a];
    l->low[a] = low[a] - extent * o->margin;
    l->step[a] = wide / (double)((uint64_t)o->base[a] << l->bits);
    if (extent == 0)
      return gmds_fail(o->error, GMDS_ERR_ARGUMENT, "the surface has no extent along %c", axis_name[a]);
    if (!(l->step[a] >= DBL_MIN && isfinite(wide) && isfinite(l->low[a]) && isfinite(l->low[a] + wide)))
      return gmds_fail(o->error, GMDS_ERR_ARGUMENT, "an extent of %g along %c cannot be divided in doubles", extent,
                       axis_name[a]);
  }
  return GMDS_OK;
}

/* The lattice point nearest to a vertex. */
static void snap(gmds_lattice *l, const double *x, int32_t at[3])
{
  for (int a = 0; a < 3; a++) {
    const double end = (double)((uint64_t)l->base[a] << l->bits);
    double steps = floor((x[a] - l->low[a]) / l->step[a] + 0.5);
    steps = steps < 0 ? 0 : steps > end ? end : steps;
    at[a] = (int32_t)steps;
  }
  double to[3];
  gmds_lattice_point(l, (const uint32_t[3]){(uint32_t)at[0], (uint32_t)at[1], (uint32_t)at[2]}, to);
  for (int a = 0; a < 3; a++)
    l->snap_error[a] = fmax(l->snap_error[a], fabs(x[a] - to[a]));
}

static int is_flat(const int32_t *triangle)
{
  const int64_t zero[3] = {0, 0, 0};
  placed t;
  place(&t, triangle, zero);
  find_normal(&t);
  return !t.normal[0] && !t.normal[1] && !t.normal[2];
}

/* The fans of all faces. */
static gmds_status snap_faces(gmds_lattice *l, const gmds_surface *s, const double *points)
{
  const size_t n = s->n_darts - 2 * s->n_faces;
  void *triangles = NULL;
  if (!gmds_resize(l->memory, &triangles, 0, n, 9 * sizeof *l->triangles))
    return GMDS_ERR_MEMORY;
  l->triangles = triangles;
  l->n_triangles = n;
  int32_t *to = triangles;
  for (size_t f = 0; f < s->n_faces; f++) {
    const size_t first = gmds_surface_first(s, f), end = gmds_surface_first(s, f + 1);
    for (size_t d = first + 1; d + 1 < end; d++, to += 9) {
      snap(l, points + 3 * (size_t)s->origin[first], to);
      snap(l, points + 3 * (size_t)s->origin[d], to + 3);
      snap(l, points + 3 * (size_t)s->origin[d + 1], to + 6);
      l->n_degenerate += (size_t)is_flat(to);
    }
  }
  l->n_turned = s->n_turned;
  return GMDS_OK;
}

gmds_status gmds_lattice_of_surface(gmds_lattice *lattice, const gmds_surface *surface, const double *points,
                                    const gmds_lattice_options *options)
{
  gmds_lattice_options o;
  double low[3], high[3];
  GMDS_TRY(read_options(options, &o));
  GMDS_TRY(check_closed(surface, o.error));
  GMDS_TRY(find_box(surface, points, low, high, o.error));
  gmds_status status = lay_lattice(lattice, &o, low, high);
  if (status == GMDS_OK && (status = snap_faces(lattice, surface, points)) != GMDS_OK)
    gmds_fail(o.error, status, "out of memory for the triangles of %zu faces", surface->n_faces);
  if (status != GMDS_OK)
    gmds_lattice_clear(lattice);
  return status;
}

gmds_status gmds_lattice_of_soup(gmds_lattice *lattice, const gmds_soup *soup, const gmds_lattice_options *options)
{
  gmds_lattice_options o;
  gmds_surface surface;
  GMDS_TRY(read_options(options, &o));
  if (soup->dim != 3)
    return gmds_fail(o.error, GMDS_ERR_ARGUMENT, "points of %d coordinates: a closed surface lies in space", soup->dim);
  gmds_surface_init(&surface, lattice->memory);
  gmds_status status = gmds_surface_from_soup(&surface, soup, o.threads, o.error);
  if (status == GMDS_OK)
    status = gmds_lattice_of_surface(lattice, &surface, soup->points, options);
  gmds_surface_clear(&surface);
  return status;
}
