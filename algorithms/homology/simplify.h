/* What the steps of a simplification share. */
#ifndef GMDS_ALGORITHMS_HOMOLOGY_SIMPLIFY_H
#define GMDS_ALGORITHMS_HOMOLOGY_SIMPLIFY_H

#include <gmds/complex.h>
#include <gmds/homology.h>
#include <gmds/template.h>
#include <gmds/threads.h>
#include <string.h>

/* What is known of an edge, beside the lower one of its darts: a byte, of which eight are looked at at once. */
enum { GMDS_EDGE_GONE, GMDS_EDGE_KEPT, GMDS_EDGE_CRITICAL, GMDS_EDGES_AT_ONCE = 8 };

/* A vertex in the graph of the edges that are kept: how many ends of edges it has, and their darts, added up by
 * exclusive or: of a vertex with one edge that is the edge, and no list of edges is needed. */
typedef struct gmds_spoke {
  gmds_id degree, darts;
} gmds_spoke;

/* A vertex of another thread's share that has lost the edge of a dart. */
typedef struct gmds_loss {
  gmds_id vertex, dart;
} gmds_loss;

typedef struct gmds_simplification {
  const gmds_surface *s;
  gmds_memory *memory;
  unsigned threads;
  size_t n_clusters;
  uint16_t *cluster; /* of each face; NULL: clusters are ranges of faces */
  uint16_t *worker;  /* of each cluster the thread that has it; NULL where clusters are ranges */
  gmds_id *root;     /* union-find of faces, then of one that stands for what is beyond the border */
  uint8_t *edge;     /* n_edges: what is known of the edge whose lower dart this is */
  size_t n_edges;    /* n_darts, and what lacks to eight; those are gone */
  gmds_spoke *spoke; /* n_vertices */
  size_t merged[GMDS_MAX_THREADS], dangling[GMDS_MAX_THREADS];
} gmds_simplification;

/* Deals the faces to clusters and the clusters to threads. GMDS_OK; GMDS_ERR_ARGUMENT; GMDS_ERR_MEMORY. */
gmds_status gmds_homology_clusters(gmds_simplification *w, const gmds_homology_options *options);

/* Steps 1a and 1b: nothing fails. The border after it: one edge for each component that has one. */
void gmds_homology_inner(gmds_simplification *w, gmds_homology *h);
void gmds_homology_critical(gmds_simplification *w, gmds_homology *h);

/* Step 2, and how many vertices have faces. Afterwards a vertex that has edges left has a degree; the last one of a
 * tree has none, and no darts; the others have none, and GMDS_NONE for darts. GMDS_OK or GMDS_ERR_MEMORY. */
gmds_status gmds_homology_dangling(gmds_simplification *w, gmds_homology *h);

/* Step 3 and the generators. */
gmds_status gmds_homology_contract(gmds_simplification *w, int generators, gmds_homology *h);

/* Of eight edges from that of dart d on, those in a state: bits that gmds_homology_dart tells, lowest first. */
static inline uint64_t gmds_homology_eight(const uint8_t *edge, size_t d, unsigned state)
{
  uint64_t eight;
  memcpy(&eight, edge + d, GMDS_EDGES_AT_ONCE);
#if defined __BYTE_ORDER__ && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  eight = __builtin_bswap64(eight);
#endif
  return eight & state * UINT64_C(0x0101010101010101);
}

static inline gmds_id gmds_homology_dart(size_t d, uint64_t eight)
{
  return (gmds_id)(d + (size_t)__builtin_ctzll(eight) / 8);
}

/* The face (or vertex) that stands for those merged with f. Paths are halved on the way. */
static inline gmds_id gmds_homology_find(gmds_id *root, gmds_id f)
{
  while (root[f] != f) {
    root[f] = root[root[f]];
    f = root[f];
  }
  return f;
}

/* Merges what two stand for, the smaller number standing for both: what is near in memory stays near. */
static inline int gmds_homology_merge(gmds_id *root, gmds_id f, gmds_id g)
{
  f = gmds_homology_find(root, f);
  g = gmds_homology_find(root, g);
  if (f == g)
    return 0;
  if (f < g)
    root[g] = f;
  else
    root[f] = g;
  return 1;
}

#endif
