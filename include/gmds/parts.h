/* The parts of a mesh without its model: cells with their attributes, points, and every stored relation as it lies in
 * memory. Meshes of different models are converted through them: one mesh gives its parts, another takes them
 * (<prefix>_give_parts and <prefix>_take_parts, models/incidence/interface.h). What both models store is moved, not
 * copied; what only the taker stores is built in linear time; the rest is freed. */
#ifndef GMDS_PARTS_H
#define GMDS_PARTS_H

#include <gmds/cells.h>
#include <gmds/hops.h>
#include <gmds/pairs.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a relation lies in memory. */
typedef enum gmds_storage { GMDS_NOWHERE, GMDS_IN_ROWS, GMDS_IN_PAIRS, GMDS_IN_COLUMN } gmds_storage;

typedef struct gmds_stored {
  gmds_storage storage;
  size_t arity; /* in a column: entries of a cell */
  int ordered;  /* in rows: entries have positions (rows.h) */
  int coded;    /* entries are 4 * face + side */
} gmds_stored;

/* What a model says of its meshes. */
typedef struct gmds_layout {
  unsigned mask;   /* cells and relations; 0: no model */
  unsigned faces;  /* types of faces: bits of GMDS_FACE_TYPE_LIST */
  int dim;         /* coordinates of a node */
  size_t limit[3]; /* how many nodes, edges, faces it may have */
  gmds_stored relation[3][3];
} gmds_layout;

typedef struct gmds_part {
  gmds_stored how;
  gmds_rows rows;
  gmds_pairs pairs;
  gmds_column column;
} gmds_part;

/* Owned by the caller. `memory` is the mesh's own, with its allocator and its counts: do not move the structure while
 * it holds parts. */
typedef struct gmds_parts {
  gmds_memory memory;
  gmds_layout layout; /* of the model that gave them */
  gmds_cells cells[3];
  double *points; /* layout.dim a node */
  size_t points_capacity;
  gmds_part relation[3][3];
} gmds_parts;

/* No parts. Allocates nothing. */
void gmds_parts_init(gmds_parts *parts);

/* Frees what the parts hold; none are left. */
void gmds_parts_clear(gmds_parts *parts);

/* Makes the parts what a mesh of another layout holds. Identifiers of cells stay, save that edges go where `to` keeps
 * none and are made, one for each two nodes that a face joins, where `to` links edges and the parts do not. Faces keep
 * the order of their nodes if F2N, or edges linked with nodes, are stored; a triangle may be turned otherwise.
 * GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY (more cells than `to` may have); GMDS_ERR_CONFLICT (F2F holds two faces a
 * side, there are more); GMDS_ERR_INVARIANT (the relations contradict each other); GMDS_ERR_UNSUPPORTED (another number
 * of coordinates; faces of a type that `to` does not hold; a relation that the stored ones do not determine: the order
 * of the nodes of a polygon from N2F, the nodes of an edge that is linked with none and bounds no face). On failure the
 * parts are as they were and `error`, which may be NULL, has a sentence. O(cells and entries); where edges know no node
 * also the squares of the numbers of sides. */
gmds_status gmds_parts_convert(gmds_parts *parts, const gmds_layout *to, gmds_error *error);

/* Makes `to`, which has none, the parts of the same mesh under other identifiers: maps[i] gives each live i-cell its
 * own, from 0 to the count, each once (not checked); no hole is left. Its memory is another one, with the allocator and
 * what is left of the limit. GMDS_OK; GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (`to` has none). O(cells and entries). */
gmds_status gmds_parts_copy_as(const gmds_parts *from, gmds_id *const maps[3], gmds_parts *to);

/* Reads parts (which may be a mesh's own, looked at and not owned) by the sides of faces: 2 -> 2, or 0 -> 0 where no
 * edge is linked with nodes, or 2 -> 1 or 1 -> 2 where edges are, of all cells at once. The csr is initialised and
 * empty. GMDS_OK or any status of gmds_parts_convert (the csr stays empty). O(cells and entries). */
gmds_status gmds_parts_over_sides(const gmds_parts *parts, int i, int j, gmds_csr *csr);

#ifdef __cplusplus
}
#endif
#endif
