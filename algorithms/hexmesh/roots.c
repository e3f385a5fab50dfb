/* The base cells: their triangles, and the windings of their centres. */
#include "sides.h"
#include <gmds/lattice.h>
#include <string.h>

void gmds_lattice_roots_init(gmds_lattice_roots *roots, gmds_memory *memory)
{
  *roots = (gmds_lattice_roots){.first = 0};
  gmds_csr_init(&roots->triangles, memory);
}

void gmds_lattice_roots_clear(gmds_lattice_roots *roots)
{
  const size_t n = roots->winding ? roots->triangles.n : 0;
  gmds_release(roots->triangles.memory, roots->winding, n, sizeof *roots->winding);
  gmds_csr_clear(&roots->triangles);
  gmds_lattice_roots_init(roots, roots->triangles.memory);
}

typedef struct filling {
  const gmds_lattice *lattice;
  gmds_lattice_roots *roots;
  size_t first, end;
} filling;

static int base_meets(const gmds_lattice *l, const uint32_t at[3], const int32_t *triangle)
{
  const gmds_lattice_cell cell = {{at[0], at[1], at[2]}, 0};
  int32_t low[3], high[3];
  gmds_lattice_bounds(l, cell, low, high);
  return gmds_lattice_meets(low, high, triangle);
}

/* Every base cell of the range that triangle t meets: counts it, or, where there is room for entries, enters it. */
static void enter_triangle(filling *f, size_t t)
{
  const gmds_lattice *l = f->lattice;
  const int32_t *triangle = l->triangles + 9 * t;
  const int64_t zero[3] = {0, 0, 0};
  uint32_t from[3], to[3], at[3];
  int within = 1; /* one cell */
  placed p;
  place(&p, triangle, zero);
  for (int a = 0; a < 3; a++) {
    from[a] = (uint32_t)((p.least[a] ? p.least[a] - 1 : 0) >> l->bits);
    to[a] = (uint32_t)(p.most[a] >> l->bits);
    to[a] -= to[a] == l->base[a];
    within &= from[a] == to[a];
  }
  gmds_csr *csr = &f->roots->triangles;
  for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
    for (at[1] = from[1]; at[1] <= to[1]; at[1]++)
      for (at[0] = from[0]; at[0] <= to[0]; at[0]++) {
        const size_t c = at[0] + l->base[0] * (at[1] + (size_t)l->base[1] * at[2]);
        if (c < f->first || c >= f->end || !(within || base_meets(l, at, triangle)))
          continue;
        if (csr->data)
          csr->data[csr->begin[c - f->first]++] = (gmds_id)t;
        else
          csr->begin[c - f->first + 1]++;
      }
}

/* The rows of triangles: counted, then entered. */
static gmds_status fill_rows(filling *f)
{
  gmds_csr *csr = &f->roots->triangles;
  void *data = NULL;
  for (size_t t = 0; t < f->lattice->n_triangles; t++)
    enter_triangle(f, t);
  for (size_t c = 0; c < csr->n; c++)
    csr->begin[c + 1] += csr->begin[c];
  const size_t sum = csr->begin[csr->n];
  if (!sum)
    return GMDS_OK;
  if (!gmds_resize(csr->memory, &data, 0, sum, sizeof *csr->data))
    return GMDS_ERR_MEMORY;
  csr->data = data;
  csr->capacity = sum;
  for (size_t t = 0; t < f->lattice->n_triangles; t++)
    enter_triangle(f, t);
  memmove(csr->begin + 1, csr->begin, csr->n * sizeof *csr->begin);
  csr->begin[0] = 0;
  return GMDS_OK;
}

/* The line along x through the centres of base cells (., j, k), and triangle t, whose bounds are given. The centres
 * before the crossing, a beginning of the row, see the triangle in front of them: the last of them in the range is
 * noted. */
static void cross_line(filling *f, const placed *t, size_t row, int64_t y, int64_t z, uint32_t from, uint32_t to)
{
  const gmds_lattice *l = f->lattice;
  const int64_t w = gmds_lattice_width(l, 0);
  if (!line_meets(t, 1, 2, y, z))
    return;
  const int beyond = sign_of(t->normal[0]);
  while (from < to && moved_side_of(t, from * w + w / 2, y, z) != beyond)
    from++;
  size_t end = row + from;
  end = end < f->end ? end : f->end;
  if (end > row && end > f->first)
    f->roots->winding[end - 1 - f->first] += beyond;
}

/* The first base cell along an axis whose centre, moved beyond its lattice point, lies beyond a place. */
static uint32_t first_centre(const gmds_lattice *l, int64_t from)
{
  return (uint32_t)((from + gmds_lattice_width(l, 0) / 2 - 1) >> l->bits);
}

/* The windings: a ray from each centre in the direction of x. */
static void wind(filling *f)
{
  const gmds_lattice *l = f->lattice;
  const int64_t w = gmds_lattice_width(l, 0), zero[3] = {0, 0, 0};
  for (size_t n = 0; n < l->n_triangles; n++) {
    placed t;
    uint32_t from[3], to[3];
    place(&t, l->triangles + 9 * n, zero);
    find_normal(&t);
    for (int a = 0; a < 3; a++) {
      from[a] = first_centre(l, t.least[a]);
      to[a] = first_centre(l, t.most[a]);
    }
    for (uint32_t k = from[2]; k < to[2]; k++)
      for (uint32_t j = from[1]; j < to[1]; j++)
        cross_line(f, &t, l->base[0] * (j + (size_t)l->base[1] * k), j * w + w / 2, k * w + w / 2, from[0], to[0]);
  }
  int32_t *winding = f->roots->winding;
  for (size_t c = f->end - f->first - 1; c > 0; c--)
    if ((f->first + c) % l->base[0])
      winding[c - 1] += winding[c];
}

/* Rows and windings of the range, all 0. */
static gmds_status make_room(filling *f)
{
  gmds_csr *csr = &f->roots->triangles;
  const size_t n = f->end - f->first;
  void *begin = NULL, *winding = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  csr->begin = begin;
  csr->n = n;
  memset(begin, 0, (n + 1) * sizeof *csr->begin);
  if (!gmds_resize(csr->memory, &winding, 0, n, sizeof *f->roots->winding))
    return GMDS_ERR_MEMORY;
  f->roots->winding = winding;
  memset(winding, 0, n * sizeof *f->roots->winding);
  return GMDS_OK;
}

gmds_status gmds_lattice_find_roots(const gmds_lattice *lattice, size_t first, size_t end, gmds_lattice_roots *roots)
{
  const uint64_t all = (uint64_t)lattice->base[0] * lattice->base[1] * lattice->base[2];
  if (first >= end || end > all)
    return GMDS_ERR_ARGUMENT;
  filling f = {lattice, roots, first, end};
  gmds_status status = make_room(&f);
  if (status == GMDS_OK)
    status = fill_rows(&f);
  if (status == GMDS_OK) {
    wind(&f);
    roots->first = first;
  } else
    gmds_lattice_roots_clear(roots);
  return status;
}
