/* The simplification from its first step to its last. */
#include "simplify.h"

void gmds_homology_init(gmds_homology *h, gmds_memory *memory)
{
  *h = (gmds_homology){0};
  gmds_ids_init(&h->h0, memory);
  gmds_csr_init(&h->h1, memory);
  gmds_csr_init(&h->h2, memory);
}

void gmds_homology_clear(gmds_homology *h)
{
  gmds_memory *memory = h->h0.memory;
  gmds_ids_clear(&h->h0);
  gmds_csr_clear(&h->h1);
  gmds_csr_clear(&h->h2);
  gmds_homology_init(h, memory);
}

/* Whether the faces can be turned so that no two run the same way along an edge: each face that is reached from a first
 * one is turned as the one before it demands. *orientable. GMDS_OK or GMDS_ERR_MEMORY. O(darts). */
static gmds_status find_orientable(const gmds_surface *s, gmds_memory *memory, int *orientable)
{
  const size_t n = s->n_faces;
  void *block = NULL;
  gmds_bits seen, turned;
  *orientable = 1;
  if (!s->n_turned)
    return GMDS_OK;
  GMDS_TRY(gmds_bits_init(&seen, memory, n));
  gmds_status status = gmds_bits_init(&turned, memory, n);
  if (status == GMDS_OK && !gmds_resize(memory, &block, 0, n, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  gmds_id *queue = block;
  for (gmds_id root = 0; status == GMDS_OK && root < n; root++) {
    size_t head = 0, tail = 0;
    if (gmds_bits_get(&seen, root))
      continue;
    gmds_bits_set(&seen, root);
    for (queue[tail++] = root; head < tail; head++) {
      const gmds_id f = queue[head];
      for (gmds_id d = gmds_surface_first(s, f); d < gmds_surface_first(s, (size_t)f + 1); d++) {
        const gmds_id e = s->beta2[d];
        if (e == GMDS_NONE)
          continue;
        const gmds_id g = gmds_surface_face(s, e);
        const int turn = gmds_bits_get(&turned, f) != (s->origin[d] == s->origin[e]);
        if (gmds_bits_get(&seen, g)) {
          *orientable &= gmds_bits_get(&turned, g) == turn;
          continue;
        }
        gmds_bits_set(&seen, g);
        if (turn)
          gmds_bits_set(&turned, g);
        queue[tail++] = g;
      }
    }
  }
  gmds_release(memory, block, block ? n : 0, sizeof(gmds_id));
  gmds_bits_clear(&turned);
  gmds_bits_clear(&seen);
  return status;
}

static void done(const gmds_homology_options *o, gmds_homology_step step)
{
  if (o->after)
    o->after(o->user, step);
}

static gmds_status take_arrays(gmds_simplification *w)
{
  void *root = NULL, *edge = NULL;
  if (!gmds_resize(w->memory, &root, 0, w->s->n_faces + 1, sizeof *w->root))
    return GMDS_ERR_MEMORY;
  w->root = root;
  const size_t n = w->s->n_darts, n_edges = (n + GMDS_EDGES_AT_ONCE - 1) / GMDS_EDGES_AT_ONCE * GMDS_EDGES_AT_ONCE;
  if (!gmds_resize(w->memory, &edge, 0, n_edges, sizeof *w->edge))
    return GMDS_ERR_MEMORY;
  w->edge = edge;
  w->n_edges = n_edges;
  if (n_edges > n)
    memset(w->edge + n, GMDS_EDGE_GONE, n_edges - n);
  return GMDS_OK;
}

static void drop_clusters(gmds_simplification *w)
{
  gmds_release(w->memory, w->cluster, w->cluster ? w->s->n_faces : 0, sizeof *w->cluster);
  gmds_release(w->memory, w->worker, w->worker ? w->n_clusters : 0, sizeof *w->worker);
  w->cluster = NULL;
  w->worker = NULL;
}

static gmds_status simplify(gmds_simplification *w, const gmds_homology_options *o, gmds_homology *h)
{
  void *spoke = NULL;
  GMDS_TRY(gmds_homology_clusters(w, o));
  GMDS_TRY(take_arrays(w));
  done(o, GMDS_STEP_CLUSTERS);
  gmds_homology_inner(w, h);
  done(o, GMDS_STEP_INNER);
  gmds_homology_critical(w, h);
  drop_clusters(w);
  done(o, GMDS_STEP_CRITICAL);
  if (!gmds_resize(w->memory, &spoke, 0, w->s->n_vertices, sizeof *w->spoke))
    return GMDS_ERR_MEMORY;
  w->spoke = spoke;
  GMDS_TRY(gmds_homology_dangling(w, h));
  done(o, GMDS_STEP_DANGLING);
  GMDS_TRY(gmds_homology_contract(w, o->generators, h));
  done(o, GMDS_STEP_CONTRACT);
  return find_orientable(w->s, w->memory, &h->orientable);
}

gmds_status gmds_homology_of(const gmds_surface *surface, const gmds_homology_options *options, gmds_homology *homology)
{
  const gmds_homology_options o = options ? *options : (gmds_homology_options){0};
  gmds_memory *memory = homology->h0.memory;
  gmds_simplification w = {.s = surface, .memory = memory, .threads = o.threads ? o.threads : 1};
  gmds_homology h;
  if (w.threads > GMDS_MAX_THREADS)
    return gmds_fail(o.error, GMDS_ERR_ARGUMENT, "%u threads: there can be from 1 to %d", w.threads, GMDS_MAX_THREADS);
  gmds_homology_init(&h, memory);
  gmds_status status = simplify(&w, &o, &h);
  if (status == GMDS_ERR_MEMORY)
    gmds_fail(o.error, status, "out of memory for the homology of %zu faces", surface->n_faces);
  gmds_release(memory, w.spoke, w.spoke ? surface->n_vertices : 0, sizeof *w.spoke);
  gmds_release(memory, w.edge, w.n_edges, sizeof *w.edge);
  gmds_release(memory, w.root, w.root ? surface->n_faces + 1 : 0, sizeof *w.root);
  drop_clusters(&w);
  if (status != GMDS_OK) {
    gmds_homology_clear(&h);
    return status;
  }
  h.edges = surface->n_edges;
  h.faces = surface->n_faces;
  h.closed = surface->n_border == 0;
  *homology = h;
  return GMDS_OK;
}
