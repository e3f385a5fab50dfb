/* The report on a surface: sides by their numbers in a table of edges, fans by joining corners. */
#include "finding.h"
#include "forest.h"
#include <string.h>

typedef struct look {
  const gmds_csr *faces;
  gmds_memory *memory;
  gmds_edge_table edges;
  uint8_t *count;     /* faces on each edge, at most 255 */
  size_t *first_side; /* of each edge the first side, as an entry of the faces */
  gmds_id *first_face;
  forest corners, whole; /* of entries; of faces, which differ when one has to be turned */
} look;

static size_t after(const gmds_csr *faces, size_t f, size_t q)
{
  return q + 1 < faces->begin[f + 1] ? q + 1 : faces->begin[f];
}

static gmds_status begin(look *l, size_t n_nodes)
{
  const gmds_csr *faces = l->faces;
  GMDS_TRY(gmds_edges_of_rows(n_nodes, faces->n, faces->begin, faces->data, &l->edges));
  void *count = NULL, *side = NULL, *face = NULL;
  if (!gmds_resize(l->memory, &count, 0, l->edges.n, 1))
    return GMDS_ERR_MEMORY;
  l->count = count;
  if (!gmds_resize(l->memory, &side, 0, l->edges.n, sizeof *l->first_side))
    return GMDS_ERR_MEMORY;
  l->first_side = side;
  if (!gmds_resize(l->memory, &face, 0, l->edges.n, sizeof *l->first_face))
    return GMDS_ERR_MEMORY;
  l->first_face = face;
  if (l->edges.n)
    memset(count, 0, l->edges.n);
  GMDS_TRY(forest_begin(&l->corners, l->memory, faces->begin[faces->n]));
  return forest_begin(&l->whole, l->memory, faces->n);
}

static void end(look *l)
{
  forest_clear(&l->corners);
  forest_clear(&l->whole);
  gmds_release(l->memory, l->count, l->count ? l->edges.n : 0, 1);
  gmds_release(l->memory, l->first_side, l->first_side ? l->edges.n : 0, sizeof *l->first_side);
  gmds_release(l->memory, l->first_face, l->first_face ? l->edges.n : 0, sizeof *l->first_face);
  gmds_edge_table_clear(&l->edges);
}

/* Counts the faces on each edge and remembers the first. */
static void count_faces(look *l)
{
  const gmds_csr *faces = l->faces;
  for (size_t f = 0; f < faces->n; f++)
    for (size_t q = faces->begin[f]; q < faces->begin[f + 1]; q++) {
      const gmds_id e = l->edges.edges[q];
      if (!l->count[e]) {
        l->first_side[e] = q;
        l->first_face[e] = (gmds_id)f;
      }
      l->count[e] = (uint8_t)(l->count[e] + (l->count[e] < UINT8_MAX));
    }
}

/* Joins the corners at both ends of each side with those of the first face there, and faces where they are two. */
static void join_faces(look *l, int ordered, gmds_surface_report *r)
{
  const gmds_csr *faces = l->faces;
  for (size_t f = 0; f < faces->n; f++)
    for (size_t q = faces->begin[f]; q < faces->begin[f + 1]; q++) {
      const gmds_id e = l->edges.edges[q], g = l->first_face[e];
      const size_t p = l->first_side[e], next = after(faces, f, q), beyond = after(faces, g, p);
      const unsigned same = faces->data[p] == faces->data[q];
      if (p == q)
        continue;
      (void)forest_join(&l->corners, (gmds_id)(same ? p : beyond), (gmds_id)q, 0);
      (void)forest_join(&l->corners, (gmds_id)(same ? beyond : p), (gmds_id)next, 0);
      if (l->count[e] != 2)
        continue;
      r->orientable &= forest_join(&l->whole, g, (gmds_id)f, same);
      if (same && ordered)
        found(&r->turned, l->edges.nodes[2 * (size_t)e], l->edges.nodes[2 * (size_t)e + 1]);
    }
}

static gmds_status count_fans(look *l, size_t n_nodes, gmds_surface_report *r)
{
  gmds_bits seen = {.memory = l->memory}, pinched = {.memory = l->memory};
  const gmds_csr *faces = l->faces;
  gmds_status status = gmds_bits_init(&seen, l->memory, n_nodes);
  if (status == GMDS_OK)
    status = gmds_bits_init(&pinched, l->memory, n_nodes);
  for (size_t q = 0; status == GMDS_OK && q < faces->begin[faces->n]; q++) {
    const gmds_id v = faces->data[q];
    if (l->corners.parent[q] != q)
      continue;
    r->nodes += !gmds_bits_get(&seen, v);
    if (gmds_bits_get(&seen, v) && !gmds_bits_get(&pinched, v)) {
      found(&r->pinched, v, GMDS_NONE);
      gmds_bits_set(&pinched, v);
    }
    gmds_bits_set(&seen, v);
  }
  gmds_bits_clear(&seen);
  gmds_bits_clear(&pinched);
  return status;
}

gmds_status gmds_look_at_faces(size_t n_nodes, const gmds_csr *faces, int ordered, gmds_memory *memory,
                               gmds_surface_report *report)
{
  look l = {.faces = faces, .memory = memory, .corners = {.memory = memory}, .whole = {.memory = memory}};
  gmds_surface_report r = {.border = nothing_found,
                           .crowded = nothing_found,
                           .turned = nothing_found,
                           .pinched = nothing_found,
                           .orientable = 1};
  gmds_edge_table_init(&l.edges, memory);
  if (!faces->n) {
    r.manifold = 1;
    *report = r;
    return GMDS_OK;
  }
  if (faces->begin[faces->n] >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  gmds_status status = begin(&l, n_nodes);
  if (status == GMDS_OK) {
    count_faces(&l);
    join_faces(&l, ordered, &r);
    status = count_fans(&l, n_nodes, &r);
  }
  for (size_t f = 0; f < faces->n; f++)
    r.faces += faces->begin[f] < faces->begin[f + 1];
  for (size_t e = 0; status == GMDS_OK && e < l.edges.n; e++)
    if (l.count[e] != 2)
      found(l.count[e] < 2 ? &r.border : &r.crowded, l.edges.nodes[2 * e], l.edges.nodes[2 * e + 1]);
  r.sides = l.edges.n;
  r.manifold = !r.crowded.count && !r.pinched.count;
  r.closed = r.manifold && !r.border.count && r.faces;
  end(&l);
  if (status == GMDS_OK)
    *report = r;
  return status;
}
