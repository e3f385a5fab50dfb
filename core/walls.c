/* Walls of regions: which way those of polyhedra turn, and which are the boundary. */
#include "forest.h"
#include "solid.h"
#include <gmds/walls.h>
#include <string.h>

/* Joins the walls of polyhedra along their sides: two that run along one the same way differ. */
static gmds_status join_walls(const gmds_walls *walls, forest *f)
{
  const gmds_complex *c = walls->complex;
  void *block = NULL;
  if (!gmds_resize(c->memory, &block, 0, c->sides.n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *last = block; /* the last wall on each edge, twice, and 1 more where it goes along it from the lower node */
  if (c->sides.n)
    memset(last, 0xff, c->sides.n * sizeof *last);
  for (size_t r = 0; r < c->nodes[3].n; r++) {
    const size_t *begin = c->rows.begin + walls->first;
    if (c->types[r] != GMDS_POLYHEDRON)
      continue;
    for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++)
      for (size_t q = begin[w]; q < begin[w + 1]; q++) {
        const size_t e = c->sides.edges[q];
        const gmds_id seen = last[e], along = c->rows.data[q] == c->sides.nodes[2 * e];
        if (seen != GMDS_NONE && seen / 2 >= c->first_wall[r])
          (void)forest_join(f, seen / 2, (gmds_id)w, (seen & 1) == along);
        last[e] = (gmds_id)(2 * w + along);
      }
  }
  gmds_release(c->memory, last, c->sides.n, sizeof *last);
  return GMDS_OK;
}

static gmds_status turn_polyhedra(gmds_walls *walls, const double *points)
{
  const gmds_complex *c = walls->complex;
  const size_t n = c->first_wall[c->nodes[3].n];
  forest f;
  gmds_status status = forest_begin(&f, c->memory, n);
  if (status == GMDS_OK)
    status = join_walls(walls, &f);
  if (status == GMDS_OK)
    status = gmds_bits_init(&walls->inwards, c->memory, n);
  for (size_t r = 0; r < c->nodes[3].n && status == GMDS_OK; r++) {
    const size_t from = c->first_wall[r], to = c->first_wall[r + 1];
    if (c->types[r] != GMDS_POLYHEDRON || from == to)
      continue;
    for (size_t w = from; w < to; w++) {
      unsigned odd = 0;
      (void)forest_root(&f, (gmds_id)w, &odd);
      if (odd)
        gmds_bits_set(&walls->inwards, w);
    }
    if (solid_volume(walls, points, r) >= 0)
      continue;
    for (size_t w = from; w < to; w++)
      walls->inwards.words[w >> 6] ^= UINT64_C(1) << (w & 63);
  }
  forest_clear(&f);
  return status;
}

gmds_status gmds_walls_init(gmds_walls *walls, const gmds_complex *complex, const double *points)
{
  int polyhedra = 0;
  *walls = (gmds_walls){.complex = complex, .first = complex->nodes[1].n + complex->nodes[2].n};
  walls->inwards.memory = complex->memory;
  for (size_t r = 0; r < complex->nodes[3].n; r++)
    polyhedra |= complex->types[r] == GMDS_POLYHEDRON && complex->first_wall[r] < complex->first_wall[r + 1];
  gmds_status status = polyhedra ? turn_polyhedra(walls, points) : GMDS_OK;
  if (status != GMDS_OK)
    gmds_walls_clear(walls);
  return status;
}

void gmds_walls_clear(gmds_walls *walls)
{
  gmds_bits_clear(&walls->inwards);
}

gmds_status gmds_walls_count(const gmds_walls *walls, gmds_memory *memory, uint8_t **regions)
{
  const gmds_complex *c = walls->complex;
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, c->n_groups, 1))
    return GMDS_ERR_MEMORY;
  uint8_t *count = block;
  if (c->n_groups)
    memset(count, 0, c->n_groups);
  for (size_t w = 0; w < c->first_wall[c->nodes[3].n]; w++) {
    const gmds_id g = gmds_wall_group(walls, w);
    count[g] = (uint8_t)(count[g] + (count[g] < UINT8_MAX));
  }
  *regions = count;
  return GMDS_OK;
}

static gmds_status list_bare(const gmds_walls *walls, const uint8_t *count, gmds_csr *faces, gmds_ids *on)
{
  const gmds_complex *c = walls->complex;
  const size_t n = c->first_wall[c->nodes[3].n];
  size_t bare = 0, row = 0;
  for (size_t w = 0; w < n; w++)
    bare += count[gmds_wall_group(walls, w)] == 1;
  GMDS_TRY(gmds_csr_begin(faces, bare));
  GMDS_TRY(gmds_ids_reserve(on, 2 * bare));
  for (size_t w = 0; w < n; w++)
    if (count[gmds_wall_group(walls, w)] == 1)
      faces->begin[++row] = gmds_wall_sides(walls, w);
  GMDS_TRY(gmds_csr_finish(faces));
  gmds_id *to = faces->data;
  for (size_t r = 0; r < c->nodes[3].n; r++)
    for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
      const size_t sides = gmds_wall_sides(walls, w);
      if (count[gmds_wall_group(walls, w)] != 1)
        continue;
      for (size_t k = 0; k < sides; k++)
        *to++ = gmds_wall_node(walls, w, k);
      on->data[on->n++] = (gmds_id)r;
      on->data[on->n++] = (gmds_id)(w - c->first_wall[r]);
    }
  return GMDS_OK;
}

gmds_status gmds_walls_boundary(const gmds_walls *walls, gmds_csr *faces, gmds_ids *on)
{
  const gmds_complex *c = walls->complex;
  uint8_t *count = NULL;
  gmds_csr rows;
  gmds_ids found = {.memory = on->memory};
  gmds_csr_init(&rows, faces->memory);
  GMDS_TRY(gmds_walls_count(walls, c->memory, &count));
  gmds_status status = list_bare(walls, count, &rows, &found);
  gmds_release(c->memory, count, c->n_groups, 1);
  if (status == GMDS_OK) {
    *faces = rows;
    *on = found;
  } else {
    gmds_csr_clear(&rows);
    gmds_ids_clear(&found);
  }
  return status;
}
