/* Step 1: removal of edges between two faces. An edge is inner as long as its two faces have not become one, which the
 * union-find of faces tells in nearly constant time. Clusters share no face, so that threads never meet (1a); the edges
 * between clusters follow in one pass (1b). */
#include "simplify.h"

/* The faces of a cluster: a range, or among all those with a label. */
typedef struct part {
  gmds_id first, end;
  int labelled;
  uint16_t label;
} part;

static inline int is_in(const gmds_simplification *w, const part *p, gmds_id f)
{
  return p->labelled ? w->cluster[f] == p->label : f - p->first < p->end - p->first;
}

/* Deals with the edge of dart d of face f, if d is its lower dart. */
static inline size_t visit_edge(const gmds_simplification *w, const part *p, gmds_id d, gmds_id f)
{
  const gmds_surface *s = w->s;
  const gmds_id e = s->beta2[d];
  if (e <= d || e == GMDS_NONE) { /* met from the other side, or at the border */
    w->edge[d] = e == GMDS_NONE ? GMDS_EDGE_CRITICAL : GMDS_EDGE_GONE;
    return 0;
  }
  const gmds_id g = gmds_surface_face(s, e);
  if (!is_in(w, p, g)) {
    w->edge[d] = GMDS_EDGE_CRITICAL;
    return 0;
  }
  const int merged = gmds_homology_merge(w->root, f, g);
  w->edge[d] = merged ? GMDS_EDGE_GONE : GMDS_EDGE_KEPT;
  return (size_t)merged;
}

/* The edges of the faces of thread t, compiled for ranges and for labels, for triangles and for other faces. */
GMDS_SPECIALISED size_t visit_faces(const gmds_simplification *w, unsigned t, int labelled, int triangles)
{
  const gmds_surface *s = w->s;
  const size_t n = w->n_clusters;
  const size_t from = labelled ? 0 : GMDS_SHARE(n, t, w->threads), to = labelled ? 1 : GMDS_SHARE(n, t + 1, w->threads);
  size_t merged = 0;
  for (size_t c = from; c < to; c++) {
    const gmds_id begin = (gmds_id)(labelled ? 0 : GMDS_SHARE(s->n_faces, c, n));
    part p = {begin, (gmds_id)(labelled ? s->n_faces : GMDS_SHARE(s->n_faces, c + 1, n)), labelled, 0};
    for (gmds_id f = begin; f < p.end; f++) {
      if (labelled) {
        p.label = w->cluster[f];
        if (w->worker[p.label] != t)
          continue;
      }
      const gmds_id first = triangles ? 3 * f : s->begin[f], end = triangles ? first + 3 : s->begin[f + 1];
      for (gmds_id d = first; d < end; d++)
        merged += visit_edge(w, &p, d, f);
    }
  }
  return merged;
}

static void visit_part(void *work, unsigned t)
{
  gmds_simplification *w = work;
  if (!w->s->begin)
    w->merged[t] = w->cluster ? visit_faces(w, t, 1, 1) : visit_faces(w, t, 0, 1);
  else
    w->merged[t] = w->cluster ? visit_faces(w, t, 1, 0) : visit_faces(w, t, 0, 0);
}

void gmds_homology_inner(gmds_simplification *w, gmds_homology *h)
{
  for (size_t f = 0; f <= w->s->n_faces; f++)
    w->root[f] = (gmds_id)f;
  gmds_share(w->threads, visit_part, w);
  for (unsigned t = 0; t < w->threads; t++)
    h->inner += w->merged[t];
}

/* Merges the faces of the critical edges that have two, or one. How many it merged. */
static size_t merge_critical(gmds_simplification *w, int border)
{
  const gmds_surface *s = w->s;
  size_t n = 0;
  for (size_t at = 0; at < w->n_edges; at += GMDS_EDGES_AT_ONCE)
    for (uint64_t eight = gmds_homology_eight(w->edge, at, GMDS_EDGE_CRITICAL); eight; eight &= eight - 1) {
      const gmds_id d = gmds_homology_dart(at, eight), e = s->beta2[d];
      if ((e == GMDS_NONE) != border)
        continue;
      /* beyond the border is one face more; each component meets it once, and no two meet there: they share no edge */
      const gmds_id beyond = border ? (gmds_id)s->n_faces : gmds_surface_face(s, e);
      const int merged = gmds_homology_merge(w->root, gmds_surface_face(s, d), beyond);
      w->edge[d] = merged ? GMDS_EDGE_GONE : GMDS_EDGE_KEPT;
      n += (size_t)merged;
    }
  return n;
}

void gmds_homology_critical(gmds_simplification *w, gmds_homology *h)
{
  if (w->n_clusters > 1)
    h->critical = merge_critical(w, 0);
  if (w->s->n_border)
    h->border = merge_critical(w, 1);
}
