/* The alphabet of mesh models: cells N, E, F, R (dimension 0 to 3), the 16 relations X2Y between them, and the number
 * of coordinates of a node. A mask is the union of such bits. */
#ifndef GMDS_RELATIONS_H
#define GMDS_RELATIONS_H

/* The rows are a table. */
/* clang-format off */

#define GMDS_CELL_BIT(i) (1 << (i))
#define GMDS_RELATION_BIT(i, j) (1 << (4 + 4 * (i) + (j)))

#define GMDS_N GMDS_CELL_BIT(0)
#define GMDS_E GMDS_CELL_BIT(1)
#define GMDS_F GMDS_CELL_BIT(2)
#define GMDS_R GMDS_CELL_BIT(3)
#define GMDS_DIM2 (1 << 20)
#define GMDS_DIM3 (1 << 21)

/* X(letter, i) */
#define GMDS_CELL_LIST(X) X(N, 0) X(E, 1) X(F, 2) X(R, 3)

/* X(name, i, j): name is stored when i-cells know their j-cells */
#define GMDS_RELATION_LIST(X)                                                                                          \
  X(N2N, 0, 0) X(N2E, 0, 1) X(N2F, 0, 2) X(N2R, 0, 3)                                                                  \
  X(E2N, 1, 0) X(E2E, 1, 1) X(E2F, 1, 2) X(E2R, 1, 3)                                                                  \
  X(F2N, 2, 0) X(F2E, 2, 1) X(F2F, 2, 2) X(F2R, 2, 3)                                                                  \
  X(R2N, 3, 0) X(R2E, 3, 1) X(R2F, 3, 2) X(R2R, 3, 3)

/* Which faces a model may hold: a model of one type stores its relations inline. X(name, bit) */
#define GMDS_FACE_TYPE_LIST(X) X(TRIANGLE, 1) X(QUADRILATERAL, 2) X(POLYGON, 4)

/* Which regions a model may hold, likewise. */
#define GMDS_REGION_TYPE_LIST(X) X(TETRAHEDRON, 1) X(PYRAMID, 2) X(PRISM, 4) X(HEXAHEDRON, 8) X(POLYHEDRON, 16)

#endif
