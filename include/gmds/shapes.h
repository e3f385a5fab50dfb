/* The local numbering of cells: which nodes make edge k and face k of a tetrahedron, a pyramid, a prism, a hexahedron.
 *
 * Nodes, edges and faces are numbered as VTK numbers them (vtkTetra, vtkPyramid, vtkWedge, vtkHexahedron). A cell is
 * positively oriented when the nodes of each of its faces, as listed here, turn counter-clockwise seen from outside:
 *
 *   tetrahedron   nodes 0 1 2 counter-clockwise seen from 3
 *   pyramid       base 0 1 2 3 counter-clockwise seen from the apex 4
 *   prism         0 1 2 counter-clockwise seen from 3 4 5; k + 3 is joined with k. Its faces are VTK's, each turned:
 *                 VTK's drawing has the first triangle the other way round, the files that programs write have it so
 *   hexahedron    0 1 2 3 counter-clockwise seen from 4 5 6 7; k + 4 is joined with k
 *
 *                 edges                                       faces
 *   tetrahedron   01 12 20 03 13 23                           013 123 203 021
 *   pyramid       01 12 23 30 04 14 24 34                     0321 014 124 234 304
 *   prism         01 12 20 34 45 53 03 14 25                  021 345 0143 1254 2035
 *   hexahedron    01 12 32 03 45 56 76 47 04 15 37 26         0473 1265 0154 3762 0321 4567
 *
 * Face k of a tetrahedron lies opposite node 2, 0, 1, 3. A triangle, quadrilateral or polygon has edge k between nodes
 * k and k + 1. A polyhedron has the faces that it was made of, in that order. */
#ifndef GMDS_SHAPES_H
#define GMDS_SHAPES_H

#include <gmds/soup.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GMDS_SHAPE_NODES = 8, GMDS_SHAPE_EDGES = 12, GMDS_SHAPE_FACES = 6 };

typedef struct gmds_shape {
  uint8_t nodes, edges, faces;
  uint8_t edge[GMDS_SHAPE_EDGES][2];   /* local nodes of each edge */
  uint8_t sides[GMDS_SHAPE_FACES];     /* nodes of each face */
  uint8_t face[GMDS_SHAPE_FACES][4];   /* local nodes of each face */
  uint8_t border[GMDS_SHAPE_FACES][4]; /* local edges of each face: side k joins its nodes k and k + 1 */
} gmds_shape;

/* The shape of a type, or NULL for one that has none of its own: a polyhedron, and what is no region. */
const gmds_shape *gmds_shape_of(gmds_cell_type type);

/* Puts the nodes of a region whose faces are known by their nodes into the order of its type: `corners` from
 * faces[k] to faces[k + 1] - 1 are the nodes around face k. Which way the faces turn does not matter, nor does their
 * order; the result is one of the orders that the shape allows, turned the way in which its first face is given when
 * that is outwards. GMDS_OK or GMDS_ERR_INVARIANT (these are not the faces of a region of this type). */
gmds_status gmds_shape_from_faces(gmds_cell_type type, const size_t *faces, const gmds_id *corners, gmds_id *nodes);

/* Turns the nodes of a region, in one of the orders that its shape allows, so that it is positively oriented. points: 3
 * coordinates a node. Which way it is turned is the exact sign of a tetrahedron; of others that of most of their
 * corners, each exact, and where as many turn either way that of the volume within the faces, rounded. A region without
 * volume, or with coordinates that are not finite, stays as it is. Constant. */
void gmds_shape_turn_outwards(gmds_cell_type type, const double *points, gmds_id *nodes);

#ifdef __cplusplus
}
#endif
#endif
