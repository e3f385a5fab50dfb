/* Sides of faces grouped by their two nodes, by counting: what tables of edges (edges.c) and conversions (derive.c) are
 * made of. Private to the library. */
#ifndef GMDS_CORE_SIDES_H
#define GMDS_CORE_SIDES_H

#include <gmds/rows.h>

/* Faces, whose nodes are below n_nodes, in one of three forms; and pairs of nodes that are grouped with their sides. */
typedef struct gmds_sides {
  size_t n_nodes, n_faces;
  size_t arity;          /* every face has so many nodes, face f those from nodes[arity * f] on; */
  const gmds_rows *rows; /* or face f has a row, that of a hole is empty; */
  const size_t *begin;   /* or its nodes are those from nodes[begin[f]] to nodes[begin[f + 1] - 1] */
  const gmds_id *nodes;
  const gmds_bits *alive; /* which of the faces of one arity are read; NULL: all */
  size_t n_pairs;
  const gmds_id *pairs;
  const gmds_bits *pair_alive; /* which of the pairs are read */
  size_t first_pair;           /* the number of the first pair; a side is numbered by where its first node lies */
} gmds_sides;

/* Writes to group[s] the group of each side and pair s, less than GMDS_NONE of them; groups are numbered in the order
 * of their lower nodes. *nodes receives the lower and the higher node of each of *n groups, in room for *capacity
 * identifiers from `memory`, which is the caller's. How: edges.h.
 * GMDS_OK or GMDS_ERR_MEMORY (only `group` may have changed). */
gmds_status gmds_group_sides(const gmds_sides *sides, gmds_memory *memory, gmds_id *group, size_t *n, gmds_id **nodes,
                             size_t *capacity);

#endif
