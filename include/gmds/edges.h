/* The edges of all faces of a mesh at once, as a table of its own: what joins two nodes that follow each other around a
 * face, numbered in the order of their lower nodes. For models that keep no edges, and to build them in bulk. */
#ifndef GMDS_EDGES_H
#define GMDS_EDGES_H

#include <gmds/bits.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Owned by the caller. Edge e joins nodes[2e] < nodes[2e + 1]. A face's row has an edge for each of its sides, side k
 * joining its nodes k and k + 1. */
typedef struct gmds_edge_table {
  size_t n;        /* edges */
  gmds_id *nodes;  /* E2N, n × 2 */
  size_t n_faces;  /* rows, holes included */
  size_t arity;    /* sides of every face, the row of face f beginning at arity * f; 0 where faces differ */
  size_t *begin;   /* then row f goes from begin[f] to begin[f + 1] - 1; else NULL */
  gmds_id *edges;  /* F2E; the row of a hole has GMDS_NONE, or is empty */
  size_t capacity; /* of `nodes`, in identifiers */
  gmds_memory *memory;
} gmds_edge_table;

void gmds_edge_table_init(gmds_edge_table *table, gmds_memory *memory);
void gmds_edge_table_clear(gmds_edge_table *table);

/* The edges of face f, in the order of its sides. */
static inline const gmds_id *gmds_edge_table_row(const gmds_edge_table *table, size_t f, size_t *n)
{
  size_t begin = table->begin ? table->begin[f] : table->arity * f;
  *n = table->begin ? table->begin[f + 1] - begin : table->arity;
  return *n ? table->edges + begin : NULL;
}

/* Fill a table that is initialised and empty from the nodes of faces, below n_nodes each: rows of `arity` nodes, of
 * which only those of live faces are read (alive NULL: all); or rows from begin[f] to begin[f + 1] - 1, where one of
 * two nodes counts as an edge.
 *
 * Sides are sorted into buckets by their lower node, by counting; within a bucket the edge to a node is remembered at
 * that node, so that neither a long bucket nor a long face costs more than its length: O(nodes + sides), no hash.
 * GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (the table stays empty). */
gmds_status gmds_edges_of_inline(size_t n_nodes, size_t n_faces, size_t arity, const gmds_id *nodes,
                                 const gmds_bits *alive, gmds_edge_table *table);
gmds_status gmds_edges_of_rows(size_t n_nodes, size_t n_faces, const size_t *begin, const gmds_id *nodes,
                               gmds_edge_table *table);

#ifdef __cplusplus
}
#endif
#endif
