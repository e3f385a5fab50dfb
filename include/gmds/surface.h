/* A surface as a 2-map at rest ([homology] 2.1): its darts are the corners of its faces, in the order in which the
 * faces list them. Beta 1 of a dart is the next corner of its face, beta 2 is stored: 8 bytes a dart where all faces
 * are triangles, else 12, and 4 a face. It is built in linear time and does not change; what homology works on. */
#ifndef GMDS_SURFACE_H
#define GMDS_SURFACE_H

#include <gmds/soup.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Owned by its maker, who clears it. Every edge has one or two faces; an edge is told by its two vertices. */
typedef struct gmds_surface {
  gmds_memory *memory;
  size_t n_vertices; /* vertices are numbered below, also those that no face has */
  size_t n_faces, n_darts;
  gmds_id *listed; /* n_faces: the number of each face in the list it was made from; NULL where they are the same */
  gmds_id *begin;  /* n_faces + 1: face f has darts begin[f] to begin[f + 1] - 1; NULL: darts 3 f to 3 f + 2 */
  gmds_id *face;   /* n_darts: the face of each; NULL where begin is */
  gmds_id *origin; /* n_darts: the vertex that it leaves */
  gmds_id *beta2;  /* n_darts: the dart of the other face on its edge, or GMDS_NONE at the border */
  size_t n_edges;
  size_t n_border; /* edges of one face */
  size_t n_turned; /* edges along which both faces run the same way: none where all are turned alike */
} gmds_surface;

/* No face. Allocates nothing. */
void gmds_surface_init(gmds_surface *surface, gmds_memory *memory);
void gmds_surface_clear(gmds_surface *surface);

/* The faces of a list: face f has the vertices nodes[begin[f]] to nodes[begin[f + 1] - 1] around it, or three of them
 * where begin is NULL. Faces that come in no order are sorted by their lowest
 * vertices (listed). threads: from 1 to GMDS_MAX_THREADS; the result does not depend on it. The surface is initialised
 * and empty.
 * GMDS_OK; GMDS_ERR_ARGUMENT (a face of fewer than three vertices, or a side that joins a vertex with itself);
 * GMDS_ERR_CELL (a vertex that does not exist); GMDS_ERR_CONFLICT (a third face on an edge): the sentence names the
 * face and the vertices; GMDS_ERR_TOO_MANY; GMDS_ERR_MEMORY. The surface stays empty. O(vertices + darts), times the
 * faces at an edge. */
gmds_status gmds_surface_from_faces(gmds_surface *surface, size_t n_vertices, size_t n_faces, const size_t *begin,
                                    const gmds_id *nodes, unsigned threads, gmds_error *error);

/* The faces among the cells of a soup, listed in its order; edges and vertices among them are passed over. Also
 * GMDS_ERR_UNSUPPORTED: a cell of a volume. */
gmds_status gmds_surface_from_soup(gmds_surface *surface, const gmds_soup *soup, unsigned threads, gmds_error *error);

/* The same, and clears the soup, also after a failure. Where it holds triangles alone and takes its memory from where
 * the surface does, their corners are moved, and the rest is freed before anything is allocated. */
gmds_status gmds_surface_take_soup(gmds_surface *surface, gmds_soup *soup, unsigned threads, gmds_error *error);

/* Beta 1: the next dart around the face. */
static inline gmds_id gmds_surface_beta1(const gmds_surface *s, gmds_id d)
{
  if (!s->begin)
    return d % 3 == 2 ? d - 2 : d + 1;
  gmds_id f = s->face[d];
  return d + 1 == s->begin[f + 1] ? s->begin[f] : d + 1;
}

/* The number of a face in the list that the surface was made from. */
static inline gmds_id gmds_surface_listed(const gmds_surface *s, gmds_id f)
{
  return s->listed ? s->listed[f] : f;
}

/* The face of a dart, and the first dart of a face (one past the last, f being n_faces). */
static inline gmds_id gmds_surface_face(const gmds_surface *s, gmds_id d)
{
  return s->begin ? s->face[d] : d / 3;
}

static inline gmds_id gmds_surface_first(const gmds_surface *s, size_t f)
{
  return s->begin ? s->begin[f] : (gmds_id)(3 * f);
}

#ifdef __cplusplus
}
#endif
#endif
