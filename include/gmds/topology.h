/* Small types of the operations on meshes, the same for every model. */
#ifndef GMDS_TOPOLOGY_H
#define GMDS_TOPOLOGY_H

#include <gmds/ids.h>

/* What becomes of the edges that bound a face, when the face is removed. */
typedef enum gmds_edges { GMDS_KEEP_EDGES, GMDS_DROP_BARE_EDGES } gmds_edges;

/* What becomes of faces that bound no region, and of edges that bound no face and no region, when a cell of higher
 * dimension is removed from a mesh of volumes. */
typedef enum gmds_bare { GMDS_KEEP_BARE, GMDS_DROP_BARE } gmds_bare;

/* What becomes of the cells around a cell that is to be removed: removal is refused, or they go first. */
typedef enum gmds_around { GMDS_REFUSE, GMDS_CASCADE } gmds_around;

/* What the caller knows about the sides of a face that it adds: for each side k, between nodes k and k + 1, the edge
 * there (GMDS_NONE: there is none yet) and the face beyond (GMDS_NONE: none). Either may be NULL: not known. */
typedef struct gmds_links {
  const gmds_id *edges;
  const gmds_id *faces;
} gmds_links;

/* A cavity: a tree of triangles. Face 0 is its root; every other face was reached over its side (node[0], node[1]) from
 * one before it. All turn the same way. `side` is the number that the model gives to that side in models with
 * GMDS_ORDERED_2_0 (so that node[q] is number (side + q) % 3), else 0. */
typedef struct gmds_cavity_face {
  gmds_id face;
  gmds_id node[3];
  unsigned side;
} gmds_cavity_face;

/* A side of the boundary of a cavity, which lies to the left of a -> b. */
typedef struct gmds_cavity_side {
  gmds_id a, b;
  gmds_id out;       /* the face beyond, or GMDS_NONE */
  unsigned out_side; /* the number that the model gives to the side there (GMDS_ORDERED_2_0), else 0 */
  unsigned in;       /* the face of the cavity on it: its index among the cavity's faces */
  unsigned in_side;  /* a is node[in_side] of that face */
} gmds_cavity_side;

/* A wall of a cavity in space: a triangle of its boundary, node[0], node[1], node[2] turning counter-clockwise seen
 * from inside, so that they make a positive tetrahedron with a node inside. */
typedef struct gmds_cavity_wall {
  gmds_id node[3];
  gmds_id out;       /* the region beyond */
  unsigned out_side; /* which of its faces the wall is, in models with GMDS_ACROSS, else 0 */
  unsigned local[3]; /* the nodes as numbered among those of the boundary, from 0 without a gap */
} gmds_cavity_wall;

#endif
