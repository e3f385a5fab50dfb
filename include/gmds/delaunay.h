/* Options and results of Delaunay triangulations, the same for every model. */
#ifndef GMDS_DELAUNAY_H
#define GMDS_DELAUNAY_H

#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct gmds_delaunay_options {
  /* Called now and then with how many of how many points are in; anything but 0 cancels. May be NULL. */
  int (*progress)(void *user, size_t done, size_t total);
  void *user;
  /* How many threads may work, 0 counts as 1. More than one where the model allows (GMDS_CONCURRENT_STARS) and there
   * are at least 4096 points a thread, in other models one; the triangles or tetrahedra are the same, their numbers
   * depend on the number of threads and on nothing else. `progress` is then called by any of them, one at a time. */
  int threads;
  gmds_error *error; /* receives the sentence of a failure; may be NULL */
} gmds_delaunay_options;

/* Zero-initialise it before the first use, or give it an allocator of its own by gmds_delaunay_result_init; clear it
 * after the last use. */
typedef struct gmds_delaunay_result {
  gmds_memory memory; /* the result's own: its arrays do not count as the mesh's */
  int dimension;      /* of the points: -1 (none), 0, 1 (on one line), 2, or 3 */
  size_t points;      /* how many were given */
  size_t distinct;    /* how many of them differ: the nodes of the mesh */
  size_t steps;       /* triangles that the walks to the points went through, some 2.3 a point */
  gmds_id *node_of;   /* `points` entries: the node of each point; of equal points the first gives the node */
  gmds_id *chain;     /* dimension 0 and 1: the `distinct` nodes in order along the line; else NULL */
  gmds_id *triangles; /* points in space of dimension 2: n_triangles × 3 nodes, all turning the same way; else NULL */
  size_t n_triangles;
} gmds_delaunay_result;

/* An empty result; allocator NULL stands for the C library's. */
void gmds_delaunay_result_init(gmds_delaunay_result *result, const gmds_allocator *allocator);

/* Triangulates n nodes of one plane in space, no two equal and not all on one line, xyz n × 3, into result->triangles:
 * what <prefix>_delaunay of a model of volumes does with such points. The Delaunay triangulation of the plane, by
 * coplanar predicates and with the tie rule of all others, so that it does not depend on the order. GMDS_OK;
 * GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (the result has no triangles). Expected O(n log n) for nodes in the order of
 * <gmds/order.h>. */
gmds_status gmds_delaunay_planar(size_t n, const double *xyz, gmds_delaunay_result *result);

/* Frees the arrays; the result is empty and usable again. */
void gmds_delaunay_result_clear(gmds_delaunay_result *result);

#ifdef __cplusplus
}
#endif
#endif
