/* Named models of volumes: the full (F1 to F6) and reduced (R1 to R4) representations of Garimella (2002, "Mesh data
 * structure selection for mesh generation and FEA applications", reference 6 of [models]), of which [models] 2.2 shows
 * F1, R1 and R2. Each has a header of its own that opens it:
 *
 *     #define GMDS_PREFIX  vol
 *     #define GMDS_REGIONS TETRAHEDRON        optional, as with <gmds/mesh.h>
 *     #include <gmds/named/r2.h>
 *     #include <gmds/end.h>
 */
#ifndef GMDS_NAMED_H
#define GMDS_NAMED_H

/* The rows are a table. */
/* clang-format off */

/* X(name, mask, when to choose it) */
#define GMDS_NAMED_LIST(X) \
  X(F1, "N|E|F|R|N2E|E2N|E2F|F2E|F2R|R2F", "one level up and down: every query is local, edges and faces carry attributes; the largest of these") \
  X(F2, "N|E|F|R|N2R|E2N|F2E|R2F", "circular, down by one level and from nodes up to regions: every cell is kept for little, going up passes through the nodes") \
  X(F3, "N|E|F|R|N2F|E2N|F2E|F2R|R2F", "for faces that are asked for their regions, as in finite volumes: fluxes through faces, stencils around nodes") \
  X(F4, "N|E|F|R|N2E|E2N|E2R|F2E|R2F", "for work on edges: collapses and swaps ask an edge for its regions, a node for its edges") \
  X(F5, "N|E|F|R|N2E|N2F|N2R|E2N|F2E|R2F", "all that is around a node at once, for smoothing and local remeshing with every cell kept") \
  X(F6, "N|E|F|R|N2F|N2R|E2N|F2E|R2F", "F5 without the edges around a node") \
  X(R1, "N|R|N2R|R2N", "what finite elements need: the nodes of elements and the elements at nodes; the smallest that is local") \
  X(R2, "N|R|N2N|N2R|R2N|R2R", "R1 with neighbours of both: walks, fronts and smoothing without a set operation") \
  X(R3, "N|F|R|N2F|F2N|F2R|R2F", "faces between regions and nodes, no edges: finite volumes of any polyhedra") \
  X(R4, "N|F|R|N2N|N2F|F2N|F2F|F2R|R2F", "R3 with neighbours of nodes and faces")

#endif
