/* Homology over the integers modulo 2 as its definition says: ranks of boundary matrices. Slow, and nothing of the
 * simplification is in it. */
#ifndef GMDS_TESTS_RANK_H
#define GMDS_TESTS_RANK_H

#include <gmds/homology.h>

/* A list of faces: face f has vertices nodes[begin[f]] to nodes[begin[f + 1] - 1]. */
typedef struct face_list {
  size_t n_vertices, n;
  size_t *begin;
  gmds_id *nodes;
} face_list;

typedef struct truth {
  size_t vertices, edges; /* of faces */
  size_t border;          /* edges of one face */
  size_t betti[3];
  int orientable;
} truth;

truth find_truth(const face_list *list);

/* Whether the rows of h1 are closed chains of edges of faces, without a vertex twice, that together with the boundaries
 * of faces have the rank they should: none is a sum of others and of boundaries. */
int are_generators(const face_list *list, const gmds_csr *h1);

/* Whether every row of h2 is a set of faces without boundary, and no two have one in common. */
int are_closed(const face_list *list, const gmds_csr *h2);

/* Whether no two of these vertices are joined by edges, and all vertices of faces are joined with one. */
int are_components(const face_list *list, const gmds_ids *h0);

#endif
