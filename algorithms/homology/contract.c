/* Step 3: contraction of edges between two vertices. What can be contracted is a spanning forest of what is left; each
 * edge that is left over is then a loop, and the path that was contracted closes it to a chain of the surface. */
#include "simplify.h"
#include <string.h>

/* The graph that is left. Its vertices are numbered anew, spoke.darts giving the number of each. */
typedef struct graph {
  gmds_simplification *w;
  size_t n, m;
  gmds_id *vertex;   /* n: in the surface */
  gmds_id *ends;     /* m × 2 */
  gmds_csr at;       /* the edges at each vertex */
  gmds_id *parent;   /* n: the edge towards the root of its tree, or GMDS_NONE */
  gmds_id *depth;    /* n: edges to the root */
  gmds_bits in_tree; /* edges */
} graph;

/* Numbers the vertices and collects the edges between them. */
static gmds_status collect(graph *g)
{
  const gmds_surface *s = g->w->s;
  gmds_spoke *spoke = g->w->spoke;
  size_t degrees = 0;
  void *vertex = NULL, *ends = NULL;
  for (size_t v = 0; v < s->n_vertices; v++) {
    g->n += spoke[v].degree > 0;
    degrees += spoke[v].degree;
  }
  if (!gmds_resize(g->w->memory, &vertex, 0, g->n, sizeof *g->vertex))
    return GMDS_ERR_MEMORY;
  g->vertex = vertex;
  if (!gmds_resize(g->w->memory, &ends, 0, degrees, sizeof *g->ends))
    return GMDS_ERR_MEMORY;
  g->ends = ends;
  g->m = degrees / 2;
  gmds_id next = 0;
  for (gmds_id v = 0; v < s->n_vertices; v++)
    if (spoke[v].degree) {
      spoke[v].darts = next;
      g->vertex[next++] = v;
    }
  size_t edge = 0;
  for (size_t at = 0; g->m && at < g->w->n_edges; at += GMDS_EDGES_AT_ONCE)
    for (uint64_t kept = gmds_homology_eight(g->w->edge, at, GMDS_EDGE_KEPT); kept; kept &= kept - 1) {
      const gmds_id d = gmds_homology_dart(at, kept), a = s->origin[d], b = s->origin[gmds_surface_beta1(s, d)];
      if (spoke[a].degree && spoke[b].degree) {
        g->ends[2 * edge] = spoke[a].darts;
        g->ends[2 * edge + 1] = spoke[b].darts;
        edge++;
      }
    }
  return GMDS_OK;
}

/* The edges at each vertex. */
static gmds_status list_edges(graph *g)
{
  GMDS_TRY(gmds_csr_begin(&g->at, g->n));
  size_t *begin = g->at.begin;
  for (size_t i = 0; i < 2 * g->m; i++)
    begin[g->ends[i] + 1]++;
  GMDS_TRY(gmds_csr_finish(&g->at));
  begin = g->at.begin;
  for (size_t i = 0; i < 2 * g->m; i++)
    g->at.data[begin[g->ends[i]]++] = (gmds_id)(i / 2);
  for (size_t v = g->n; v-- > 0;)
    begin[v + 1] = begin[v];
  begin[0] = 0;
  return GMDS_OK;
}

/* Grows a tree from every vertex that none has reached, breadth first; *roots: how many. */
static void grow_forest(graph *g, gmds_id *queue, size_t *roots)
{
  for (size_t v = 0; v < g->n; v++)
    g->depth[v] = GMDS_NONE;
  for (gmds_id root = 0; root < g->n; root++) {
    if (g->depth[root] != GMDS_NONE)
      continue;
    size_t head = 0, tail = 0;
    ++*roots;
    g->depth[root] = 0;
    g->parent[root] = GMDS_NONE;
    queue[tail++] = root;
    while (head < tail) {
      const gmds_id v = queue[head++];
      for (size_t k = g->at.begin[v]; k < g->at.begin[v + 1]; k++) {
        const gmds_id e = g->at.data[k], to = g->ends[2 * e] == v ? g->ends[2 * e + 1] : g->ends[2 * e];
        if (g->depth[to] != GMDS_NONE)
          continue;
        g->depth[to] = g->depth[v] + 1;
        g->parent[to] = e;
        gmds_bits_set(&g->in_tree, e);
        queue[tail++] = to;
      }
    }
  }
}

static gmds_id above(const graph *g, gmds_id v)
{
  const gmds_id e = g->parent[v];
  return g->ends[2 * (size_t)e] == v ? g->ends[2 * (size_t)e + 1] : g->ends[2 * (size_t)e];
}

/* The chain that edge e closes: from its first end up to where the ways to the root meet, and down to its second end.
 * Its length; vertices are written where `chain` is not NULL. */
static size_t close_chain(const graph *g, size_t e, gmds_id *chain)
{
  gmds_id a = g->ends[2 * e], b = g->ends[2 * e + 1];
  size_t up = 0, down = 0;
  while (a != b) {
    if (g->depth[a] >= g->depth[b]) {
      if (chain)
        chain[up] = g->vertex[a];
      up++;
      a = above(g, a);
    } else {
      down++;
      b = above(g, b);
    }
  }
  if (chain) {
    size_t k = up;
    chain[k] = g->vertex[a];
    k += down;
    for (b = g->ends[2 * e + 1]; b != a; b = above(g, b))
      chain[k--] = g->vertex[b];
  }
  return up + down + 1;
}

static gmds_status make_chains(const graph *g, gmds_csr *h1)
{
  size_t rows = 0;
  for (size_t e = 0; e < g->m; e++)
    rows += !gmds_bits_get(&g->in_tree, e);
  GMDS_TRY(gmds_csr_begin(h1, rows));
  size_t row = 0;
  for (size_t e = 0; e < g->m; e++)
    if (!gmds_bits_get(&g->in_tree, e))
      h1->begin[++row] = close_chain(g, e, NULL);
  GMDS_TRY(gmds_csr_finish(h1));
  row = 0;
  for (size_t e = 0; e < g->m; e++)
    if (!gmds_bits_get(&g->in_tree, e))
      (void)close_chain(g, e, h1->data + h1->begin[row++]);
  return GMDS_OK;
}

/* The faces of each component that met no border. A set stands under its lowest face. */
static gmds_status make_cycles(const gmds_simplification *w, gmds_csr *h2)
{
  const size_t n = w->s->n_faces;
  gmds_id *root = w->root;
  const gmds_id outside = gmds_homology_find(root, (gmds_id)n);
  size_t rows = 0, row = 0;
  void *number = NULL;
  for (gmds_id f = 0; f < n; f++)
    rows += root[f] == f && f != outside;
  GMDS_TRY(gmds_csr_begin(h2, rows));
  if (!gmds_resize(w->memory, &number, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *of = number;
  for (gmds_id f = 0; f < n; f++) {
    const gmds_id r = gmds_homology_find(root, f);
    of[f] = r == outside ? GMDS_NONE : r == f ? (gmds_id)row++ : of[r];
    if (of[f] != GMDS_NONE)
      h2->begin[of[f] + 1]++;
  }
  gmds_status status = gmds_csr_finish(h2);
  for (gmds_id f = 0; status == GMDS_OK && f < n; f++)
    if (of[f] != GMDS_NONE)
      h2->data[h2->begin[of[f]]++] = f;
  for (row = rows; status == GMDS_OK && row-- > 0;)
    h2->begin[row + 1] = h2->begin[row];
  if (status == GMDS_OK && rows)
    h2->begin[0] = 0;
  gmds_release(w->memory, number, n, sizeof(gmds_id));
  return status;
}

/* The lowest vertex of each component, by a union-find over all edges: what is left by chance depends on the
 * threads. */
static gmds_status make_points(const gmds_simplification *w, gmds_ids *h0)
{
  const gmds_surface *s = w->s;
  void *block = NULL;
  if (!gmds_resize(w->memory, &block, 0, s->n_vertices, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *root = block;
  for (gmds_id v = 0; v < s->n_vertices; v++)
    root[v] = GMDS_NONE;
  for (gmds_id d = 0; d < s->n_darts; d++)
    root[s->origin[d]] = s->origin[d];
  for (gmds_id d = 0; d < s->n_darts; d++)
    (void)gmds_homology_merge(root, s->origin[d], s->origin[gmds_surface_beta1(s, d)]);
  gmds_status status = GMDS_OK;
  for (gmds_id v = 0; v < s->n_vertices && status == GMDS_OK; v++)
    if (root[v] == v)
      status = gmds_ids_push(h0, v);
  gmds_release(w->memory, block, s->n_vertices, sizeof(gmds_id));
  return status;
}

static size_t count_alone(const gmds_simplification *w)
{
  size_t alone = 0;
  for (size_t v = 0; v < w->s->n_vertices; v++)
    alone += !w->spoke[v].degree && w->spoke[v].darts == 0;
  return alone;
}

/* Contracts what is left in g, of which nothing but `w` is set. Its arrays are the caller's to free. */
static gmds_status contract(graph *g, int generators, gmds_homology *h)
{
  gmds_simplification *w = g->w;
  size_t roots = 0;
  void *parent = NULL, *depth = NULL, *queue = NULL;
  const size_t alone = count_alone(w);
  GMDS_TRY(collect(g));
  GMDS_TRY(gmds_bits_init(&g->in_tree, w->memory, g->m));
  GMDS_TRY(list_edges(g));
  if (!gmds_resize(w->memory, &parent, 0, g->n, sizeof *g->parent))
    return GMDS_ERR_MEMORY;
  g->parent = parent;
  if (!gmds_resize(w->memory, &depth, 0, g->n, sizeof *g->depth))
    return GMDS_ERR_MEMORY;
  g->depth = depth;
  if (!gmds_resize(w->memory, &queue, 0, g->n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  grow_forest(g, queue, &roots);
  gmds_release(w->memory, queue, g->n, sizeof(gmds_id));
  h->contracted = g->n - roots;
  h->components = h->betti[0] = alone + roots;
  h->betti[1] = g->m - h->contracted;
  h->betti[2] = w->s->n_faces - h->inner - h->critical - h->border;
  if (!generators)
    return GMDS_OK;
  GMDS_TRY(make_points(w, &h->h0));
  GMDS_TRY(make_chains(g, &h->h1));
  return make_cycles(w, &h->h2);
}

gmds_status gmds_homology_contract(gmds_simplification *w, int generators, gmds_homology *h)
{
  graph g = {.w = w};
  gmds_csr_init(&g.at, w->memory);
  gmds_status status = contract(&g, generators, h);
  gmds_release(w->memory, g.vertex, g.vertex ? g.n : 0, sizeof *g.vertex);
  gmds_release(w->memory, g.ends, g.ends ? 2 * g.m : 0, sizeof *g.ends);
  gmds_release(w->memory, g.parent, g.parent ? g.n : 0, sizeof *g.parent);
  gmds_release(w->memory, g.depth, g.depth ? g.n : 0, sizeof *g.depth);
  gmds_bits_clear(&g.in_tree);
  gmds_csr_clear(&g.at);
  return status;
}
