/* Whether cells make a manifold, and how they are turned: what manifold() of a mesh reports (algorithms/manifold.h). */
#ifndef GMDS_MANIFOLD_H
#define GMDS_MANIFOLD_H

#include <gmds/walls.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How many there are, and the first: an edge by its two nodes, a face by a region and the number of the face there, a
 * node or a region by itself, and GMDS_NONE in what is left. "First" are the lowest identifiers. */
typedef struct gmds_finding {
  size_t count;
  gmds_id first[2];
} gmds_finding;

/* Of faces. Sides are told by their nodes, whether edges are kept or not. */
typedef struct gmds_surface_report {
  size_t faces, sides, nodes; /* faces, and what is on them */
  gmds_finding border;        /* sides with one face */
  gmds_finding crowded;       /* sides with more than two */
  gmds_finding turned;  /* sides along which two faces run the same way: they turn against each other. None where no
                                 order is kept */
  gmds_finding pinched; /* nodes whose faces, joined where they share a side at the node, make more than one fan */
  int manifold;         /* nothing is crowded or pinched */
  int closed;           /* and no side has one face, and there are faces */
  int orientable;       /* the faces can be turned so that no two that share a side with no third turn against each
                                 other */
} gmds_surface_report;

/* Of regions, and of their walls as a surface. */
typedef struct gmds_volume_report {
  size_t regions, faces, edges, nodes; /* regions, and what is on them */
  gmds_finding border;                 /* faces with one region */
  gmds_finding crowded;                /* faces with more than two */
  gmds_finding turned;                 /* faces that two regions, by the order of their nodes, see from the same side */
  gmds_finding crossed;                /* faces that a region lists around in another order than one before it */
  gmds_finding repeated;               /* regions with the same nodes as one before them */
  gmds_finding pinched_edges;  /* edges whose regions, joined where they share a face at the edge, are not one fan */
  gmds_finding pinched_nodes;  /* the same of nodes */
  gmds_finding inverted;       /* regions of which a corner turns the wrong way: a tetrahedron of negative volume */
  gmds_finding degenerate;     /* others that have a flat corner (a tetrahedron without volume), a node twice, or,
                                          polyhedra, no volume */
  gmds_surface_report surface; /* of the faces with one region, turned outwards */
  int manifold;                /* nothing is crowded, crossed or pinched */
} gmds_volume_report;

/* Reports on faces whose nodes are listed around them, below n_nodes; ordered: which way they are listed means
 * something. Working space comes from `memory`. GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY. O(nodes + sides),
 * nearly. */
gmds_status gmds_look_at_faces(size_t n_nodes, const gmds_csr *faces, int ordered, gmds_memory *memory,
                               gmds_surface_report *report);

/* Reports on the regions of a joined complex; points: 3 coordinates a node. Corners are decided by the exact predicate.
 * GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY. O(complex), nearly. */
gmds_status gmds_look_at_regions(const gmds_complex *complex, const double *points, gmds_volume_report *report);

#ifdef __cplusplus
}
#endif
#endif
