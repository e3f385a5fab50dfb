/* Homology of a surface by simplification of its 2-map, in parallel ([homology], Algorithm 1).
 *
 * What is removed keeps the homology: an edge between two faces (they become one), an edge with an end that no other
 * edge has, and, by contraction, an edge between two vertices. What is left has a vertex for each component and a loop
 * for each generator of H1.
 *
 * Beyond the paper: a surface may have a border. There one border edge of each component is removed with the face that
 * is left of it, so that no face remains. It may be pinched at vertices and need not be orientable: Betti numbers are
 * those over Z/2, which are those over the integers where it is orientable. */
#ifndef GMDS_HOMOLOGY_H
#define GMDS_HOMOLOGY_H

#include <gmds/hops.h>
#include <gmds/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How faces are dealt to clusters, within which edges are removed in parallel. Counts of removed edges and generators
 * depend on the clusters, and on the number of threads in no way. */
typedef enum gmds_clustering {
  GMDS_BY_RANGES, /* as many faces in a row for each; one range is the sequential algorithm, by one thread */
  GMDS_BY_LABELS  /* a face belongs to the lowest of the labels of its vertices: gmds_grid_labels, or the caller's */
} gmds_clustering;

typedef enum gmds_homology_step {
  GMDS_STEP_CLUSTERS, /* the faces are dealt to clusters */
  GMDS_STEP_INNER,    /* 1a */
  GMDS_STEP_CRITICAL, /* 1b, and the border */
  GMDS_STEP_DANGLING, /* 2 */
  GMDS_STEP_CONTRACT, /* 3, and the generators */
  GMDS_STEP_COUNT
} gmds_homology_step;

typedef struct gmds_homology_options {
  unsigned threads; /* 0 counts as 1 */
  gmds_clustering clustering;
  unsigned ranges; /* GMDS_BY_RANGES: how many, up to 65536; 0: 64 */
  const uint16_t
      *labels;    /* GMDS_BY_LABELS: one for each vertex of the surface; may be freed when the clusters are dealt */
  int generators; /* whether they are wanted */
  void (*after)(void *user, gmds_homology_step step); /* called when a step is done, to time it; may be NULL */
  void *user;
  gmds_error *error; /* receives the sentence of a failure; may be NULL */
} gmds_homology_options;

/* Zero-initialise `memory` or give it an allocator; cleared by gmds_homology_clear. */
typedef struct gmds_homology {
  size_t vertices; /* of faces; others do not count */
  size_t edges, faces;
  size_t components;
  int closed;     /* every edge has two faces */
  int orientable; /* the faces can be turned so that no two run the same way along an edge */
  size_t betti[3];
  size_t inner;      /* edges removed inside clusters: step 1a (all inner edges with one range) */
  size_t critical;   /* between clusters: step 1b */
  size_t border;     /* one edge of each component that has a border */
  size_t dangling;   /* step 2 */
  size_t contracted; /* step 3 */
  /* The generators, where they are wanted: */
  gmds_ids h0; /* the lowest vertex of each component */
  gmds_csr h1; /* row k: the vertices of a closed chain of edges of the surface, each joined with the next and the last
                   with the first, none twice; betti[1] rows */
  gmds_csr h2; /* row k: faces that are joined across edges and have no border among them; betti[2] rows */
} gmds_homology;

/* An empty result, whose lists take their memory from `memory`. Allocates nothing. */
void gmds_homology_init(gmds_homology *homology, gmds_memory *memory);
void gmds_homology_clear(gmds_homology *homology);

/* The label of each of n points: its box in a grid of as many boxes along each axis over all of them ([homology] 4,
 * where it is 8). points: n × dim, row major; dim: 2 or 3; boxes: from 1 to 40, and 0 for 8; threads: from 1 to
 * GMDS_MAX_THREADS. GMDS_OK; GMDS_ERR_ARGUMENT (a number out of its range, or a coordinate that is not finite).
 * O(n). */
gmds_status gmds_grid_labels(size_t n, int dim, const double *points, unsigned boxes, unsigned threads,
                             uint16_t *labels, gmds_error *error);

/* Computes the homology of a surface into `homology` (initialised and empty), whose memory all working space comes
 * from. options: may be NULL: one thread, 64 ranges, no generators. GMDS_OK; GMDS_ERR_ARGUMENT (an option out of its
 * range); GMDS_ERR_MEMORY (the result stays empty). Nearly O(darts); H1 also takes the length of its chains. */
gmds_status gmds_homology_of(const gmds_surface *surface, const gmds_homology_options *options,
                             gmds_homology *homology);

/* The generators as a mesh over the points of the surface (n_vertices × 3, row major): vertices for H0, edges for H1,
 * faces for H2, with the attributes "dimension" and "generator", its number in its dimension. The soup is initialised,
 * empty and of dimension 3. GMDS_OK; GMDS_ERR_ARGUMENT (it is not); GMDS_ERR_TOO_MANY; GMDS_ERR_MEMORY (it stays
 * empty). */
gmds_status gmds_homology_to_soup(const gmds_surface *surface, const gmds_homology *homology, const double *points,
                                  gmds_soup *soup);

#ifdef __cplusplus
}
#endif
#endif
