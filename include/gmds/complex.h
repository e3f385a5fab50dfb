/* A cell complex: edges, faces and regions as lists of nodes, and from these every relation between cells of any two
 * dimensions, for a whole mesh at once and in linear time. What meshes of volumes are made from, converted through,
 * written out by and checked against (models/volume/convert.h). It stores no relation; it knows no model. */
#ifndef GMDS_COMPLEX_H
#define GMDS_COMPLEX_H

#include <gmds/edges.h>
#include <gmds/hops.h>
#include <gmds/shapes.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Owned by the caller, who fills the first part (initialised by gmds_complex_init) and clears it. Cells are told by
 * their nodes: edges by two, faces by the set of theirs. */
typedef struct gmds_complex {
  gmds_memory *memory;
  size_t n_nodes; /* nodes are numbered below */
  gmds_csr
      nodes[4]; /* [1], [2], [3]: the nodes of edges, faces and regions; the row of a cell that does not exist is empty.
                        Faces list them around, regions in the order of their type (shapes.h), polyhedra in any */
  uint8_t *types; /* of the regions: gmds_cell_type; room for `types_capacity` */
  size_t types_capacity;
  gmds_csr walls; /* of polyhedra, the faces; the rows of other regions are empty. No rows at all where none is one */

  /* what gmds_complex_join finds: rows of sides are the edges, the faces and then the faces of all regions */
  gmds_edge_table
      sides;          /* which numbers of edges are on each row; edges that are no cell of the complex have one too */
  gmds_id *edge_of;   /* sides.n: the edge of the complex with this number, or GMDS_NONE */
  size_t *first_wall; /* of region r the rows first_wall[r] to first_wall[r + 1] - 1; n regions + 1 */
  gmds_csr rows;      /* the nodes of all rows */
  gmds_id *group;     /* of each row from the first face on: the number of its set of nodes */
  size_t n_groups;
  gmds_id *face_of;  /* n_groups: the face of the complex with this number, or GMDS_NONE */
  size_t crossed[2]; /* two rows with the same nodes in different orders around, as in a quadrilateral and one that
                        crosses itself; both 0 where there are none */
} gmds_complex;

/* An empty complex. Allocates nothing. */
void gmds_complex_init(gmds_complex *complex, gmds_memory *memory, size_t n_nodes);
void gmds_complex_clear(gmds_complex *complex);

/* Finds which edges and faces are the same. After it the lists of nodes must not change.
 * GMDS_OK; GMDS_ERR_CELL (a face or region has a node that does not exist, or a polyhedron a face), GMDS_ERR_ARGUMENT
 * (an edge has not two nodes, a face fewer than three, a region not as many as its type, or the faces of a polyhedron
 * do not close: an edge is not on two of them, or one is there twice), both with a sentence; GMDS_ERR_MEMORY;
 * GMDS_ERR_TOO_MANY. O(entries), times a logarithm in polyhedra. */
gmds_status gmds_complex_join(gmds_complex *complex, gmds_error *error);

/* GMDS_OK where faces with the same nodes have these in the same order around, as every model needs that keeps faces or
 * what lies beyond them; else GMDS_ERR_CONFLICT and a sentence that names two. The complex is joined. O(regions). */
gmds_status gmds_complex_uncrossed(const gmds_complex *complex, gmds_error *error);

/* Forgets what gmds_complex_join found, so that the lists may change. */
void gmds_complex_part(gmds_complex *complex);

/* Adds the edges, or the faces, or both, that bound cells of the complex and are none yet, numbered from the end on,
 * and joins again: what was found before stays until that has succeeded. Status as gmds_complex_join; after a failure
 * the complex is as it was. O(entries). */
gmds_status gmds_complex_make(gmds_complex *complex, int edges, int faces, gmds_error *error);

/* The j-cells of every i-cell, for any i and j from 0 to 3: a set for each; 1 -> 0, 2 -> 0, 3 -> 0 as they are listed,
 * and aligned, 2 -> 1 by sides, 3 -> 1 and 3 -> 2 in local order. Only cells of the complex are answered; one that
 * lacks a cell leaves it out, or has GMDS_NONE in its place with `aligned`, which also makes 3 -> 3 have an entry a
 * face; with aligned 2 this is 4 times the region and the number of the face there (tetrahedra). The csr is initialised
 * and empty. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_CONFLICT (aligned 3 -> 3, and a face has more than two regions: one of
 * them is *where). O(entries and answer). */
gmds_status gmds_complex_relation(const gmds_complex *complex, int i, int j, int aligned, gmds_csr *csr, size_t *where);

/* 0 -> 0 by the edges of regions alone, and of the edges of the complex, or its faces, or both. Statuses as above. */
gmds_status gmds_complex_joined(const gmds_complex *complex, int edges, int faces, gmds_csr *csr);

/* A csr of n rows of lengths that are known: begin[r + 1] = length of row r on entry, begin[0] = 0; then `data` has
 * room for their sum. GMDS_OK or GMDS_ERR_MEMORY (it stays as it is). */
gmds_status gmds_csr_begin(gmds_csr *csr, size_t n); /* room for the lengths, all 0 */
gmds_status gmds_csr_finish(gmds_csr *csr);          /* sums them and makes room for the entries */

#ifdef __cplusplus
}
#endif
#endif
