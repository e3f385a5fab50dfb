/* Laplacian smoothing of regions, guarded by the orientation of their corners. */
#include "solid.h"
#include <gmds/predicates.h>
#include <gmds/smooth.h>
#include <string.h>

typedef struct smoother {
  const gmds_complex *c;
  double *points;
  gmds_bits inner;
  gmds_csr joined, regions; /* of each node: the nodes joined with it, in ascending order, and its regions */
} smoother;

/* Unsets the nodes around faces that have one region or more than two, of polyhedra, and those without a region. */
static gmds_status find_inner(smoother *s)
{
  const gmds_complex *c = s->c;
  const gmds_walls walls = {.complex = c, .first = c->nodes[1].n + c->nodes[2].n};
  uint8_t *count = NULL;
  GMDS_TRY(gmds_bits_init(&s->inner, c->memory, c->n_nodes));
  GMDS_TRY(gmds_walls_count(&walls, c->memory, &count));
  for (size_t v = 0; v < c->n_nodes; v++)
    if (s->regions.begin[v] < s->regions.begin[v + 1])
      gmds_bits_set(&s->inner, v);
  for (size_t r = 0; r < c->nodes[3].n; r++)
    for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
      const size_t n = gmds_wall_sides(&walls, w);
      for (size_t k = 0; k < n; k++)
        if (c->types[r] == GMDS_POLYHEDRON || count[gmds_wall_group(&walls, w)] != 2)
          gmds_bits_unset(&s->inner, gmds_wall_node(&walls, w, k));
    }
  gmds_release(c->memory, count, c->n_groups, 1);
  return GMDS_OK;
}

/* The ends of the edges of regions, of each node in ascending order. */
static gmds_status join_nodes(smoother *s)
{
  const gmds_complex *c = s->c;
  gmds_bits on = {.memory = c->memory};
  const size_t n_walls = c->first_wall[c->nodes[3].n], first = c->nodes[1].n + c->nodes[2].n;
  GMDS_TRY(gmds_bits_init(&on, c->memory, c->sides.n));
  for (size_t q = c->rows.begin[first]; q < c->rows.begin[first + n_walls]; q++)
    gmds_bits_set(&on, c->sides.edges[q]);
  gmds_status status = gmds_csr_begin(&s->joined, c->n_nodes);
  for (size_t e = 0; status == GMDS_OK && e < 2 * c->sides.n; e++)
    s->joined.begin[c->sides.nodes[e] + 1] += (size_t)gmds_bits_get(&on, e / 2);
  if (status == GMDS_OK)
    status = gmds_csr_finish(&s->joined);
  for (size_t e = 0; status == GMDS_OK && e < 2 * c->sides.n; e++) /* each row's beginning moves to its end, and back */
    if (gmds_bits_get(&on, e / 2))
      s->joined.data[s->joined.begin[c->sides.nodes[e]]++] = c->sides.nodes[e ^ 1];
  for (size_t v = c->n_nodes; status == GMDS_OK && v-- > 0;)
    s->joined.begin[v + 1] = s->joined.begin[v];
  gmds_bits_clear(&on);
  if (status != GMDS_OK)
    return status;
  s->joined.begin[0] = 0;
  for (size_t v = 0; v < c->n_nodes; v++) {
    const size_t begin = s->joined.begin[v], n = s->joined.begin[v + 1] - begin;
    gmds_ids list = {.data = n ? s->joined.data + begin : NULL, .n = n, .capacity = n};
    gmds_ids_keep(&list, 0, 1, GMDS_NONE); /* sorts */
  }
  return GMDS_OK;
}

static int turn(const double *points, const gmds_id *nodes, const uint8_t *corner, gmds_id v, const double *x)
{
  const double *p[4];
  for (int i = 0; i < 4; i++)
    p[i] = nodes[corner[i]] == v ? x : points + 3 * (size_t)nodes[corner[i]];
  return gmds_orient3d(p[0], p[1], p[2], p[3]);
}

/* Whether every corner that v takes part in turns as before with v at x. */
static int keeps_turns(const smoother *s, gmds_id v, const double *x)
{
  const gmds_complex *c = s->c;
  for (size_t q = s->regions.begin[v]; q < s->regions.begin[v + 1]; q++) {
    const gmds_id r = s->regions.data[q], *nodes = c->nodes[3].data + c->nodes[3].begin[r];
    uint8_t corner[SOLID_CORNERS][4];
    const size_t n = solid_corners((gmds_cell_type)c->types[r], corner);
    for (size_t k = 0; k < n; k++) {
      const int before = turn(s->points, nodes, corner[k], v, s->points + 3 * (size_t)v);
      if (before && turn(s->points, nodes, corner[k], v, x) != before)
        return 0;
    }
  }
  return 1;
}

static size_t smooth_node(smoother *s, gmds_id v)
{
  double x[3] = {0, 0, 0}, *old = s->points + 3 * (size_t)v;
  const size_t n = s->joined.begin[v + 1] - s->joined.begin[v];
  for (size_t k = 0; k < n; k++)
    for (int d = 0; d < 3; d++)
      x[d] += s->points[3 * (size_t)s->joined.data[s->joined.begin[v] + k] + (size_t)d] / (double)n;
  if ((x[0] == old[0] && x[1] == old[1] && x[2] == old[2]) || !keeps_turns(s, v, x))
    return 0;
  memcpy(old, x, sizeof x);
  return 1;
}

gmds_status gmds_smooth_regions(const gmds_complex *c, double *points, size_t sweeps, size_t *moved)
{
  smoother s = {.c = c, .points = points, .inner = {.memory = c->memory}};
  size_t last = 0;
  gmds_csr_init(&s.joined, c->memory);
  gmds_csr_init(&s.regions, c->memory);
  gmds_status status = gmds_invert_csr(&c->nodes[3], c->n_nodes, &s.regions);
  if (status == GMDS_OK)
    status = find_inner(&s);
  if (status == GMDS_OK)
    status = join_nodes(&s);
  for (size_t k = 0; k < sweeps && status == GMDS_OK; k++) {
    last = 0;
    for (size_t v = gmds_bits_next(&s.inner, 0, c->n_nodes); v < c->n_nodes;
         v = gmds_bits_next(&s.inner, v + 1, c->n_nodes))
      last += smooth_node(&s, (gmds_id)v);
  }
  gmds_bits_clear(&s.inner);
  gmds_csr_clear(&s.joined);
  gmds_csr_clear(&s.regions);
  if (status == GMDS_OK)
    *moved = last;
  return status;
}
