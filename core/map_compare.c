/* What a combinatorial map is apart from its numbering: checksum and isomorphism. */
#include "map_inside.h"
#include <string.h>

/* A number for each dart that depends on what is `rounds` links around it: refinement, as of Weisfeiler and Leman
 * (1968). Two arrays of darts.end entries; the value is the one that holds the result. */
static uint64_t *refine(const gmds_map *map, int with_points, int rounds, uint64_t *now, uint64_t *next)
{
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    now[d] = 0x243f6a8885a308d3u;
    const double *x = gmds_map_point(map, gmds_map_cell(map, 0, d));
    for (int k = 0; k < map->coordinates && with_points; k++) {
      const double positive = x[k] + 0.0;
      uint64_t w = 0;
      memcpy(&w, &positive, sizeof w);
      now[d] = mix64((now[d] ^ w) + 0x9e3779b97f4a7c15u);
    }
  }
  for (int r = 0; r < rounds; r++) {
    for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
      uint64_t h = now[d];
      for (int i = 0; i <= map->n; i++) {
        const gmds_id e = gmds_map_beta(map, i, d);
        h = mix64((h ^ (e == GMDS_NONE ? 1 : now[e])) + 0x9e3779b97f4a7c15u);
      }
      next[d] = h;
    }
    uint64_t *swap = now;
    now = next;
    next = swap;
  }
  return now;
}

/* Two arrays for refine. */
static uint64_t *take_arrays(const gmds_map *map, gmds_memory *memory)
{
  void *block = NULL;
  return gmds_resize(memory, &block, 0, map->darts.end + 1, 2 * sizeof(uint64_t)) ? block : NULL;
}

gmds_status gmds_map_checksum(const gmds_map *map, int with_points, gmds_memory *memory, uint64_t *sum)
{
  uint64_t *arrays = take_arrays(map, memory), total = mix64(map->darts.count + (uint64_t)map->n * 31);
  if (!arrays)
    return GMDS_ERR_MEMORY;
  const uint64_t *h = refine(map, with_points, with_points ? 2 : 16, arrays, arrays + map->darts.end);
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1))
    total += h[d];
  gmds_release(memory, arrays, map->darts.end + 1, 2 * sizeof(uint64_t));
  *sum = total;
  return GMDS_OK;
}

/* A bijection of darts that grows. */
typedef struct comparison {
  const gmds_map *a, *b;
  const uint64_t *hash_a, *hash_b;
  int with_points;
  gmds_id *image, *origin; /* of each dart of a in b, and back */
  gmds_id *queue;
} comparison;

static int same_place(const comparison *c, gmds_id d, gmds_id e)
{
  if (c->hash_a[d] != c->hash_b[e])
    return 0;
  const double *x = gmds_map_point(c->a, gmds_map_cell(c->a, 0, d)),
               *y = gmds_map_point(c->b, gmds_map_cell(c->b, 0, e));
  for (int k = 0; k < c->a->coordinates && c->with_points; k++)
    if (x[k] != y[k])
      return 0;
  return 1;
}

/* Whether the component of d is that of e, d going to e: the images stay if so. */
static int extend(comparison *c, gmds_id d, gmds_id e)
{
  size_t n = 1;
  int same = same_place(c, d, e);
  c->queue[0] = d;
  c->image[d] = e;
  c->origin[e] = d;
  for (size_t k = 0; k < n && same; k++)
    for (int i = 0; i <= c->a->n && same; i++) {
      const gmds_id p = gmds_map_beta(c->a, i, c->queue[k]), q = gmds_map_beta(c->b, i, c->image[c->queue[k]]);
      if (p == GMDS_NONE || q == GMDS_NONE)
        same = p == q;
      else if (c->image[p] != GMDS_NONE || c->origin[q] != GMDS_NONE)
        same = c->image[p] == q && c->origin[q] == p;
      else if (same_place(c, p, q)) {
        c->image[p] = q;
        c->origin[q] = p;
        c->queue[n++] = p;
      } else
        same = 0;
    }
  while (!same && n > 0) {
    n--;
    c->origin[c->image[c->queue[n]]] = GMDS_NONE;
    c->image[c->queue[n]] = GMDS_NONE;
  }
  return same;
}

static int compare(comparison *c)
{
  for (size_t k = 0; k < c->a->darts.end; k++)
    c->image[k] = GMDS_NONE;
  for (size_t k = 0; k < c->b->darts.end; k++)
    c->origin[k] = GMDS_NONE;
  const gmds_cells *a = &c->a->darts, *b = &c->b->darts;
  for (gmds_id d = gmds_cells_next(a, 0); d != GMDS_NONE; d = gmds_cells_next(a, d + 1)) {
    if (c->image[d] != GMDS_NONE)
      continue;
    gmds_id e = gmds_cells_next(b, 0);
    while (e != GMDS_NONE && (c->origin[e] != GMDS_NONE || !extend(c, d, e)))
      e = gmds_cells_next(b, e + 1);
    if (e == GMDS_NONE)
      return 0;
  }
  return 1;
}

gmds_status gmds_map_isomorphic(const gmds_map *a, const gmds_map *b, int with_points, gmds_memory *memory, int *same)
{
  if (a->n != b->n || a->darts.count != b->darts.count || (with_points && a->coordinates != b->coordinates)) {
    *same = 0;
    return GMDS_OK;
  }
  void *lists = NULL;
  const size_t n = 2 * a->darts.end + b->darts.end + 1;
  uint64_t *arrays_a = take_arrays(a, memory), *arrays_b = take_arrays(b, memory);
  gmds_status status =
      arrays_a && arrays_b && gmds_resize(memory, &lists, 0, n, sizeof(gmds_id)) ? GMDS_OK : GMDS_ERR_MEMORY;
  if (status == GMDS_OK) {
    gmds_id *image = lists;
    comparison c = {.a = a, .b = b, .with_points = with_points, .image = image};
    c.queue = image + a->darts.end;
    c.origin = c.queue + a->darts.end;
    c.hash_a = refine(a, with_points, 8, arrays_a, arrays_a + a->darts.end);
    c.hash_b = refine(b, with_points, 8, arrays_b, arrays_b + b->darts.end);
    *same = compare(&c);
  }
  gmds_release(memory, arrays_a, arrays_a ? a->darts.end + 1 : 0, 2 * sizeof(uint64_t));
  gmds_release(memory, arrays_b, arrays_b ? b->darts.end + 1 : 0, 2 * sizeof(uint64_t));
  gmds_release(memory, lists, lists ? n : 0, sizeof(gmds_id));
  return status;
}
