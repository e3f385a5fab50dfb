/* Combinatorial maps of any dimension: what the opened models of models/cmap share, compiled once. The interface to use
 * is that of a model (models/cmap/interface.h); these functions are what stands behind it.
 *
 * An n-map is a set of darts with n functions: beta_1 is a partial permutation, beta_0 its inverse, beta_2 to beta_n
 * are partial involutions without fixed points, and beta_i o beta_j is an involution where j >= i + 2 (Damiand and
 * Lienhardt, Combinatorial Maps, 2014; [dmaps] 2.1). A dart that beta_i leads nowhere is i-free. The i-cell of a dart
 * is its orbit under all betas but beta_i, that of dimension 0 the orbit of what leads from dart to dart with the same
 * origin.
 *
 * A dart is a record of `stride` identifiers: beta_0 to beta_n, then its i-cell for each dimension that the map keeps.
 * All darts of an orbit have one cell, and no other dart has it. */
#ifndef GMDS_MAP_H
#define GMDS_MAP_H

#include <gmds/cells.h>
#include <gmds/topology.h>
#include <gmds/volume.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GMDS_MAP_MOST = 4, GMDS_MAP_KEPT = 4 }; /* the highest dimension; cells of dimension 0 to 3 may be kept */

/* Orbits: bit i stands for beta_i (bit 0 and bit 1 both stand for beta_1 and its inverse). */
#define GMDS_BETA(i) (1u << (i))
#define GMDS_SAME_ORIGIN (1u << 31) /* darts with the same origin: the orbit of a node */

/* What becomes of an attribute's values when two cells become one, and when one becomes two. `kept` already has its
 * value, `fresh` a copy of that of `old`. */
typedef void (*gmds_merge)(void *user, void *kept, const void *gone);
typedef void (*gmds_split)(void *user, void *old, void *fresh);

typedef struct gmds_map_rule {
  int cell;
  const gmds_attribute *attribute;
  gmds_merge merge; /* NULL: the value of the first stays */
  gmds_split split; /* NULL: both have it */
  void *user;
} gmds_map_rule;

typedef struct gmds_map {
  gmds_memory memory;          /* counts everything that the map holds; do not move the structure while it is in use */
  int n;                       /* dimension */
  int coordinates;             /* of a node: 2 or 3 */
  int stride;                  /* identifiers a dart */
  int slot[GMDS_MAP_MOST + 1]; /* where a dart's i-cell stands in its record, 0 where i-cells are not kept */
  gmds_cells darts;            /* which are alive, and their attributes */
  gmds_id *records;            /* stride a dart */
  size_t records_capacity;     /* in darts */
  gmds_cells cells[GMDS_MAP_KEPT];
  gmds_id *anchor[GMDS_MAP_KEPT]; /* a dart of each cell; GMDS_NONE of a node that is on none */
  size_t anchor_capacity[GMDS_MAP_KEPT];
  double *points; /* `coordinates` a node */
  size_t points_capacity;
  gmds_map_rule *rules;
  size_t n_rules;
  gmds_ids scratch; /* of the cavity operator */
} gmds_map;

/* ---- life. kept: bit i for i-cells; nodes are always kept. Statuses as those of a mesh. */
void gmds_map_init(gmds_map *map, int n, int coordinates, unsigned kept, const gmds_allocator *allocator);
void gmds_map_empty(gmds_map *map);
void gmds_map_clear(gmds_map *map);
gmds_status gmds_map_reserve(gmds_map *map, size_t darts, const size_t cells[GMDS_MAP_KEPT]); /* in all */
gmds_status gmds_map_grow(gmds_map *map, int i, size_t more);                                 /* i-cells; -1: darts */
gmds_status gmds_map_trim(gmds_map *map);

/* Closes the holes among darts and cells; maps and dart_map may be NULL and receive the new identifiers. GMDS_OK or
 * GMDS_ERR_MEMORY (nothing has changed). O(map). */
gmds_status gmds_map_compact(gmds_map *map, gmds_id *const maps[GMDS_MAP_KEPT], gmds_id *dart_map);

/* Gives every cell another identifier, without holes; darts stay. Statuses as compact. O(map). */
gmds_status gmds_map_permute(gmds_map *map, gmds_id *const maps[GMDS_MAP_KEPT]);

/* Makes `other`, of the same dimension and cells, the map's content, whose own is freed. Allocates nothing. */
void gmds_map_become(gmds_map *map, gmds_map *other);

static inline int gmds_map_has(const gmds_map *map, gmds_id d)
{
  return gmds_cells_has(&map->darts, d);
}

static inline gmds_id *gmds_map_record(const gmds_map *map, gmds_id d)
{
  return map->records + (size_t)d * (size_t)map->stride;
}

static inline gmds_id gmds_map_beta(const gmds_map *map, int i, gmds_id d)
{
  return gmds_map_record(map, d)[i];
}

/* beta_i of what may be no dart. */
static inline gmds_id gmds_map_next(const gmds_map *map, int i, gmds_id d)
{
  return d == GMDS_NONE ? GMDS_NONE : gmds_map_record(map, d)[i];
}

static inline gmds_id gmds_map_cell(const gmds_map *map, int i, gmds_id d)
{
  return map->slot[i] ? gmds_map_record(map, d)[map->slot[i]] : GMDS_NONE;
}

static inline const double *gmds_map_point(const gmds_map *map, gmds_id v)
{
  return map->points + (size_t)map->coordinates * (size_t)v;
}

/* A dart without links and cells; room was provided. */
gmds_id gmds_map_take_dart(gmds_map *map);

/* A node without darts, at x (NULL: the origin). */
gmds_status gmds_map_add_node(gmds_map *map, const double *x, gmds_id *id);
gmds_status gmds_map_add_nodes(gmds_map *map, size_t n, const double *x, gmds_id *first);

/* Removes all darts and all cells but nodes; room and attributes stay. */
void gmds_map_drop_darts(gmds_map *map);

/* ---- orbits. The list receives the darts of an orbit, d first, breadth first; the room behind them is scratch space.
 * GMDS_OK; GMDS_ERR_MEMORY (the content is lost). O(orbit). */
unsigned gmds_map_cell_betas(const gmds_map *map, int i); /* those of the i-cells */
gmds_status gmds_map_orbit(const gmds_map *map, gmds_id d, unsigned betas, gmds_ids *list);

/* The j-cells incident or adjacent to i-cell c (mesh queries), and for all. Both are kept. */
gmds_status gmds_map_adjacent(const gmds_map *map, int i, int j, gmds_id c, gmds_ids *list);
gmds_status gmds_map_all_adjacent(const gmds_map *map, int i, int j, gmds_csr *csr);

/* How many i-cells there are, kept or not. Working space from `memory`. GMDS_OK or GMDS_ERR_MEMORY. O(map). */
gmds_status gmds_map_count_orbits(const gmds_map *map, unsigned betas, gmds_memory *memory, size_t *count);

/* ---- links, sewing: see models/cmap/interface.h */
gmds_status gmds_map_link(gmds_map *map, int i, gmds_id d, gmds_id e);
gmds_status gmds_map_unlink(gmds_map *map, int i, gmds_id d);
gmds_status gmds_map_restore_cells(gmds_map *map);
gmds_status gmds_map_is_sewable(const gmds_map *map, int i, gmds_id d, gmds_id e, gmds_memory *memory, int *sewable);
gmds_status gmds_map_sew(gmds_map *map, int i, gmds_id d, gmds_id e);
gmds_status gmds_map_unsew(gmds_map *map, int i, gmds_id d);
void gmds_map_remove_attribute(gmds_map *map, int i, gmds_attribute *attribute); /* and its rule */
gmds_status gmds_map_set_rule(gmds_map *map, int i, const gmds_attribute *attribute, gmds_merge merge, gmds_split split,
                              void *user);
gmds_status gmds_map_add_dart(gmds_map *map, gmds_id *d);
gmds_status gmds_map_remove_dart(gmds_map *map, gmds_id d);

/* ---- making cells */

/* The darts of a cell: `n_faces` cycles, cycle k visiting the local nodes corners[begin[k]] to corners[begin[k + 1] -
 * 1]; every edge is on two cycles, once each way, or (n_faces 1) on one. nodes: identifiers of its nodes, which keep
 * their darts, or NULL: they are made, at x (n_nodes rows, may be NULL). Kept edges, faces and the region are made. */
typedef struct gmds_map_frame {
  size_t n_nodes, n_faces;
  const size_t *begin;
  const gmds_id *corners;
} gmds_map_frame;
gmds_status gmds_map_make_frame(gmds_map *map, const gmds_map_frame *frame, const double *x, const gmds_id *nodes,
                                gmds_id *d);
gmds_status gmds_map_make_shape(gmds_map *map, gmds_cell_type type, const double *x, const gmds_id *nodes, gmds_id *d);
gmds_status gmds_map_make_polygon(gmds_map *map, size_t n, const double *x, const gmds_id *nodes, gmds_id *d);
gmds_status gmds_map_make_edge(gmds_map *map, const double *x, gmds_id *d);

/* What make_frame writes for a shape: the links of its darts among themselves, one face after the other, from 0. */
typedef struct gmds_map_stencil {
  uint8_t darts, edges;
  uint8_t next[24], before[24], beyond[24]; /* beta_1, beta_0, beta_2 */
  uint8_t node[24], edge[24], face[24];
} gmds_map_stencil;
const gmds_map_stencil *gmds_map_stencil_of(gmds_cell_type type);

/* Sews all (n-1)-cells that two n-cells have in common, n being 2 or 3. */
typedef enum gmds_map_by { GMDS_BY_NODES, GMDS_BY_COORDINATES } gmds_map_by;
gmds_status gmds_map_match(gmds_map *map, gmds_map_by by, size_t *sewn);

/* ---- operations */
gmds_status gmds_map_insert_vertex_in_edge(gmds_map *map, gmds_id d, const double *x, gmds_id *made);
gmds_status gmds_map_insert_vertex_in_face(gmds_map *map, gmds_id d, const double *x, gmds_id *made);
gmds_status gmds_map_insert_edge_in_face(gmds_map *map, gmds_id d, gmds_id e, gmds_id *made);
gmds_status gmds_map_insert_dangling_edge(gmds_map *map, gmds_id d, const double *x, gmds_id *made);
gmds_status gmds_map_insert_face_in_volume(gmds_map *map, size_t n, const gmds_id *path, gmds_id *made);
gmds_status gmds_map_is_removable(const gmds_map *map, int i, gmds_id d, gmds_memory *memory, int *removable);
gmds_status gmds_map_remove_cell(gmds_map *map, int i, gmds_id d);
gmds_status gmds_map_is_contractible(const gmds_map *map, int i, gmds_id d, gmds_memory *memory, int *contractible);
gmds_status gmds_map_contract_cell(gmds_map *map, int i, gmds_id d);
gmds_status gmds_map_close(gmds_map *map, int i, size_t *made);

/* As a model: cells upon nodes, sewn with what is there; a node with the n-cells at it. */
gmds_status gmds_map_add_face(gmds_map *map, size_t n, const gmds_id *nodes, gmds_id *d);
gmds_status gmds_map_add_region(gmds_map *map, gmds_cell_type type, const gmds_id *nodes, gmds_id *d);
gmds_status gmds_map_add_faces(gmds_map *map, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed);
gmds_status gmds_map_remove_node(gmds_map *map, gmds_id v, gmds_around around);
gmds_status gmds_map_star(gmds_map *map, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                          gmds_id *ids);

/* An n-cell with all its darts; nodes stay where `keep_nodes`, without darts where no other dart has them. */
gmds_status gmds_map_delete_cells(gmds_map *map, size_t n, const gmds_id *darts, int keep_nodes);

/* ---- the whole map */

/* X(name, what is wrong) */
#define GMDS_MAP_RULE_LIST(X)                                               \
  X(GMDS_MAP_SOUND, "nothing")                                              \
  X(GMDS_MAP_LINK_TO_NONE, "a link leads to a dart that does not exist")    \
  X(GMDS_MAP_NO_INVERSE, "beta_0 and beta_1 are not inverse to each other") \
  X(GMDS_MAP_NO_INVOLUTION, "a beta is no involution")                      \
  X(GMDS_MAP_FIXED_POINT, "an involution has a fixed point")                \
  X(GMDS_MAP_NO_MAP, "beta_j after beta_i is no involution, j >= i + 2")    \
  X(GMDS_MAP_DEAD_CELL, "a dart has a cell that does not exist")            \
  X(GMDS_MAP_TWO_CELLS, "two darts of one orbit have different cells")      \
  X(GMDS_MAP_TWO_ORBITS, "two orbits have one cell")                        \
  X(GMDS_MAP_WRONG_DART, "the dart of a cell is not on it")                 \
  X(GMDS_MAP_NO_DART, "a cell is on no dart")
#define GMDS_MAP_RULE_ENUM_(name, text) name,
typedef enum gmds_map_fault { GMDS_MAP_RULE_LIST(GMDS_MAP_RULE_ENUM_) GMDS_MAP_FAULTS } gmds_map_fault;
#undef GMDS_MAP_RULE_ENUM_

/* The first violation that a check meets. */
typedef struct gmds_map_report {
  gmds_map_fault rule;
  int i, j;                /* which beta, betas, or dimension of cell; -1 where there is none */
  gmds_id dart;            /* of which dart, or cell where there is no dart */
  gmds_id expected, found; /* what should be there, and what is */
} gmds_map_report;

gmds_status gmds_map_check(const gmds_map *map, gmds_memory *memory, gmds_map_report *report, gmds_error *error);
gmds_status gmds_map_isomorphic(const gmds_map *a, const gmds_map *b, int with_points, gmds_memory *memory, int *same);
gmds_status gmds_map_checksum(const gmds_map *map, int with_points, gmds_memory *memory, uint64_t *sum);
gmds_status gmds_map_components(const gmds_map *map, gmds_memory *memory, size_t *count);

/* Bytes that any machine reads: `bytes` is a list of the caller's. */
typedef struct gmds_map_bytes {
  unsigned char *data;
  size_t n, capacity;
  gmds_memory *memory;
} gmds_map_bytes;
void gmds_map_bytes_clear(gmds_map_bytes *bytes);
gmds_status gmds_map_write(const gmds_map *map, gmds_map_bytes *bytes);
gmds_status gmds_map_read(gmds_map *map, size_t n, const unsigned char *data, gmds_error *error);

/* Meshes: see models/cmap/interface.h */
gmds_status gmds_map_get_complex(const gmds_map *map, gmds_complex *complex, gmds_error *error);
gmds_status gmds_map_get_volume(const gmds_map *map, gmds_volume *volume, gmds_error *error);
gmds_status gmds_map_set_volume(gmds_map *map, gmds_volume *volume, gmds_error *error);
gmds_status gmds_map_to_soup(const gmds_map *map, gmds_soup *soup, gmds_error *error);
gmds_status gmds_map_cells_checksum(const gmds_map *map, gmds_memory *memory, uint64_t *sum); /* of n-cells */

#ifdef __cplusplus
}
#endif
#endif
