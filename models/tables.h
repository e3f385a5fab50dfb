/* The composition tables of [models] (de Bellabre, Ledoux, Weill 2012), once, as data.
 *
 * For each pair (i, j) the paths by which j-cells are reached from an i-cell, in the paper's order:
 *   P1(id, i, j)                         the relation itself (2.3.1)
 *   P2(id, table, i, k, j, keep)         Keep_keep o Adj_kj                                 Tables 1 and 3
 *   P3(id, table, i, k, l, j, inner, keep)      Keep_keep o Adj_j o Keep_inner o Adj_kl     Tables 2 and 3
 *   P4(id, table, i, k, l, m, j, inner, third, keep)  one hop more; `third` is kept after the third hop   Table 3
 * When i = j the cell itself is left out of the answer. A hop a -> b is taken from a2b where it is stored, else by a
 * traversal of all b-cells where b2a is stored (the extended model M_e). Table 0 marks the four rows that the paper
 * leaves unwritten and its matrices use (I^F1 in 2.2): 0 -> 0 is being joined by an edge, 1 -> 1 is sharing a node.
 *
 * Four rows differ from the print, which keeps one copy after a hop up from nodes (3-0-1-2 and 2-0-1-3 and 1-0-2-3 in
 * Table 2, 3-0-1-2-3 in Table 3): a cell that merely touches x then counts as often as one inside it. The intermediate
 * cells must lie in x, so the inner multiplicity is that of the two-hop row (2 nodes for an edge, 2 for a face at an
 * edge).
 *
 * Priority among paths ([models] 2.3.1): stored; all hops stored; the inverse of the relation; fewest traversals.
 * The preprocessor (choice.h), the census (census.c), the documentation and the tests all read this one list. */
#ifndef GMDS_MODELS_TABLES_H
#define GMDS_MODELS_TABLES_H

/* The rows are a table. */
/* clang-format off */

/* The first list is for models that link edges and nodes: an edge that bounds no face is known there alone. The second
 * is for others that link faces and nodes: a face may bound no region. */
#define GMDS_PATHS_0_0_BY_EDGES(P1, P2, P3, P4) P1(1, 0, 0) P2(2, 0, 0, 1, 0, 1)
#define GMDS_PATHS_0_0_BY_FACES(P1, P2, P3, P4) P1(1, 0, 0) P2(3, 0, 0, 2, 0, 1)
#define GMDS_PATHS_0_0(P1, P2, P3, P4)                                                                                 \
  P1(1, 0, 0) P2(2, 0, 0, 1, 0, 1) P2(3, 0, 0, 2, 0, 1) P2(4, 0, 0, 3, 0, 1)
#define GMDS_PATHS_0_1(P1, P2, P3, P4) P1(1, 0, 1)
#define GMDS_PATHS_0_2(P1, P2, P3, P4) P1(1, 0, 2) P2(2, 1, 0, 1, 2, 1)
#define GMDS_PATHS_0_3(P1, P2, P3, P4)                                                                                 \
  P1(1, 0, 3) P2(2, 1, 0, 1, 3, 1) P2(3, 1, 0, 2, 3, 1) P3(4, 2, 0, 1, 2, 3, 1, 1)
#define GMDS_PATHS_1_0(P1, P2, P3, P4) P1(1, 1, 0)
#define GMDS_PATHS_1_1(P1, P2, P3, P4) P1(1, 1, 1) P2(2, 0, 1, 0, 1, 1)
#define GMDS_PATHS_1_2(P1, P2, P3, P4) P1(1, 1, 2) P2(2, 1, 1, 0, 2, 2)
#define GMDS_PATHS_1_3(P1, P2, P3, P4)                                                                                 \
  P1(1, 1, 3) P2(2, 1, 1, 2, 3, 1) P2(3, 1, 1, 0, 3, 2) P3(4, 2, 1, 0, 2, 3, 2, 1)
#define GMDS_PATHS_2_0(P1, P2, P3, P4) P1(1, 2, 0) P2(2, 1, 2, 1, 0, 1)
#define GMDS_PATHS_2_1(P1, P2, P3, P4) P1(1, 2, 1) P2(2, 1, 2, 0, 1, 2)
#define GMDS_PATHS_2_2(P1, P2, P3, P4)                                                                                 \
  P1(1, 2, 2) P2(2, 3, 2, 1, 2, 1) P2(3, 3, 2, 0, 2, 2) P3(4, 3, 2, 1, 0, 2, 1, 2) P3(5, 3, 2, 0, 1, 2, 2, 1)
#define GMDS_PATHS_2_3(P1, P2, P3, P4)                                                                                 \
  P1(1, 2, 3) P2(2, 1, 2, 0, 3, 3) P2(3, 1, 2, 1, 3, 3) P3(4, 2, 2, 1, 0, 3, 1, 3) P3(5, 2, 2, 0, 1, 3, 2, 3)
#define GMDS_PATHS_3_0(P1, P2, P3, P4)                                                                                 \
  P1(1, 3, 0) P2(2, 1, 3, 2, 0, 1) P2(3, 1, 3, 1, 0, 1) P3(4, 2, 3, 2, 1, 0, 1, 1)
#define GMDS_PATHS_3_1(P1, P2, P3, P4)                                                                                 \
  P1(1, 3, 1) P2(2, 1, 3, 2, 1, 1) P2(3, 1, 3, 0, 1, 2) P3(4, 2, 3, 2, 0, 1, 1, 2)
#define GMDS_PATHS_3_2(P1, P2, P3, P4)                                                                                 \
  P1(1, 3, 2) P2(2, 1, 3, 0, 2, 3) P2(3, 1, 3, 1, 2, 3) P3(4, 2, 3, 1, 0, 2, 1, 3) P3(5, 2, 3, 0, 1, 2, 2, 3)
#define GMDS_PATHS_3_3(P1, P2, P3, P4)                                                                                 \
  P1(1, 3, 3) P2(2, 3, 3, 2, 3, 1) P2(3, 3, 3, 1, 3, 2) P2(4, 3, 3, 0, 3, 3)                                           \
  P3(5, 3, 3, 2, 1, 3, 1, 2) P3(6, 3, 3, 1, 2, 3, 3, 1) P3(7, 3, 3, 2, 0, 3, 1, 3) P3(8, 3, 3, 0, 2, 3, 3, 1)          \
  P3(9, 3, 3, 1, 0, 3, 1, 3) P4(10, 3, 3, 2, 1, 0, 3, 1, 1, 3) P4(11, 3, 3, 1, 0, 2, 3, 1, 3, 1)                       \
  P4(12, 3, 3, 0, 1, 2, 3, 2, 3, 1)

/* X(i, j, the list of its paths) for every pair */
#define GMDS_PAIR_LIST(X)                                                                                              \
  X(0, 0, GMDS_PATHS_0_0) X(0, 1, GMDS_PATHS_0_1) X(0, 2, GMDS_PATHS_0_2) X(0, 3, GMDS_PATHS_0_3)                      \
  X(1, 0, GMDS_PATHS_1_0) X(1, 1, GMDS_PATHS_1_1) X(1, 2, GMDS_PATHS_1_2) X(1, 3, GMDS_PATHS_1_3)                      \
  X(2, 0, GMDS_PATHS_2_0) X(2, 1, GMDS_PATHS_2_1) X(2, 2, GMDS_PATHS_2_2) X(2, 3, GMDS_PATHS_2_3)                      \
  X(3, 0, GMDS_PATHS_3_0) X(3, 1, GMDS_PATHS_3_1) X(3, 2, GMDS_PATHS_3_2) X(3, 3, GMDS_PATHS_3_3)

#endif
