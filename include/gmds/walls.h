/* The walls of a complex: the faces of all its regions, each once for every region that has it, turned outwards. */
#ifndef GMDS_WALLS_H
#define GMDS_WALLS_H

#include <gmds/complex.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Wall w of a joined complex is local face w - first_wall[r] of the region r that has it. Owned by the caller. */
typedef struct gmds_walls {
  const gmds_complex *complex;
  size_t first;      /* the row of wall 0 among the rows of the complex */
  gmds_bits inwards; /* walls of polyhedra that are listed the other way round; no words where there is none */
} gmds_walls;

/* Finds which walls of polyhedra are listed inwards: those of one polyhedron are turned alike, and so that it encloses
 * a positive volume. Walls of other regions are outwards by their order (shapes.h). The complex is joined; points: 3
 * coordinates a node. GMDS_OK or GMDS_ERR_MEMORY (the walls are empty). O(entries). */
gmds_status gmds_walls_init(gmds_walls *walls, const gmds_complex *complex, const double *points);
void gmds_walls_clear(gmds_walls *walls);

/* How many nodes wall w has, and node k of these counter-clockwise seen from outside. */
static inline size_t gmds_wall_sides(const gmds_walls *walls, size_t w)
{
  const size_t *begin = walls->complex->rows.begin + walls->first + w;
  return begin[1] - begin[0];
}

static inline gmds_id gmds_wall_node(const gmds_walls *walls, size_t w, size_t k)
{
  const size_t *begin = walls->complex->rows.begin + walls->first + w;
  const int turned = walls->inwards.n_words && gmds_bits_get(&walls->inwards, w);
  return walls->complex->rows.data[turned ? begin[1] - 1 - k : begin[0] + k];
}

/* The number of the set of nodes of wall w: walls with the same are on one face. */
static inline gmds_id gmds_wall_group(const gmds_walls *walls, size_t w)
{
  return walls->complex->group[walls->complex->nodes[2].n + w];
}

/* How many regions each group of walls has, at most 255: n_groups entries. GMDS_OK or GMDS_ERR_MEMORY. O(walls). */
gmds_status gmds_walls_count(const gmds_walls *walls, gmds_memory *memory, uint8_t **regions);

/* The walls that no other region has, in the order of regions and local faces: row k of `faces` (initialised and empty)
 * has the nodes around one, outwards; on->data[2k] is its region and on->data[2k + 1] its number there. GMDS_OK or
 * GMDS_ERR_MEMORY (both stay empty). O(entries). */
gmds_status gmds_walls_boundary(const gmds_walls *walls, gmds_csr *faces, gmds_ids *on);

#ifdef __cplusplus
}
#endif
#endif
