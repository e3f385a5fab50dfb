/* Deriving relations of a whole mesh from those that are stored, in linear time. */
#include "derive.h"
#include "sides.h"
#include <gmds/relations.h>
#include <string.h>

enum { NODES, ALIGNED, ENDS, GROUPS };

int derive_stores(const derived *d, int i, int j)
{
  return (d->from->layout.mask & (unsigned)GMDS_RELATION_BIT(i, j)) != 0;
}

int mask_links_edges(unsigned mask)
{
  const unsigned links = GMDS_RELATION_BIT(0, 1) | GMDS_RELATION_BIT(1, 0);
  return (mask & links) != 0;
}

int mask_makes_edges(unsigned mask)
{
  const unsigned bounds = GMDS_RELATION_BIT(1, 2) | GMDS_RELATION_BIT(2, 1);
  return mask_links_edges(mask) || (mask & bounds) != 0;
}

void derive_begin(derived *d, const gmds_parts *from, gmds_memory *memory, gmds_error *error)
{
  memset(d, 0, sizeof *d);
  d->from = from;
  d->memory = memory;
  d->error = error;
  d->end_edges = from->cells[1].end;
  gmds_csr_init(&d->nodes.csr, memory);
  gmds_csr_init(&d->aligned.csr, memory);
}

void derive_end(derived *d)
{
  gmds_memory *memory = d->memory;
  gmds_release(memory, d->edge_of_group, d->edge_of_group ? d->n_groups : 0, sizeof(gmds_id));
  gmds_release(memory, d->group, d->group ? d->n_grouped : 0, sizeof(gmds_id));
  gmds_column_clear(&d->ends.column, memory);
  gmds_csr_clear(&d->nodes.csr);
  gmds_csr_clear(&d->aligned.csr);
}

view derive_stored(const derived *d, int i, int j)
{
  view v = {.part = &d->from->relation[i][j]};
  return v;
}

gmds_status derive_inverse(const derived *d, int i, const view *v, size_t n, gmds_csr *csr)
{
  const gmds_cells *cells = &d->from->cells[i];
  if (!v->part)
    return gmds_invert_csr(&v->csr, n, csr);
  if (v->part->how.storage == GMDS_IN_ROWS)
    return gmds_invert_rows(&v->part->rows, cells->end, n, csr);
  if (v->part->how.storage == GMDS_IN_PAIRS)
    return gmds_invert_pairs(&v->part->pairs, cells->end, n, csr);
  return gmds_invert_inline(v->part->column.data, v->part->how.arity, &cells->alive, cells->end, n, csr);
}

static gmds_status no_memory(derived *d)
{
  return gmds_fail(d->error, GMDS_ERR_MEMORY, "out of memory while converting a mesh");
}

/* Room for n identifiers, each GMDS_NONE. */
static gmds_status take(derived *d, size_t n, gmds_id **ids)
{
  void *block = NULL;
  if (!gmds_resize(d->memory, &block, 0, n, sizeof **ids))
    return GMDS_ERR_MEMORY;
  if (n)
    memset(block, 0xff, n * sizeof **ids);
  *ids = block;
  return GMDS_OK;
}

/* ---- the nodes of edges */

static gmds_status ends_from_nodes(derived *d, gmds_id *ends)
{
  const gmds_rows *rows = &d->from->relation[0][1].rows;
  for (size_t v = 0; v < d->from->cells[0].end; v++) {
    size_t n = 0;
    const gmds_id *edges = gmds_rows_get(rows, v, &n);
    for (size_t k = 0; k < n; k++) {
      gmds_id *pair = ends + 2 * (size_t)edges[k];
      if (pair[1] != GMDS_NONE)
        return gmds_fail(d->error, GMDS_ERR_INVARIANT, "N2E: edge %lu has more than two nodes",
                         (unsigned long)edges[k]);
      pair[pair[0] != GMDS_NONE] = (gmds_id)v;
    }
  }
  return GMDS_OK;
}

static gmds_status ends_from_sides(derived *d, gmds_id *ends)
{
  const gmds_cells *faces = &d->from->cells[2];
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0;
    const gmds_id *nodes = view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++) {
      gmds_id *pair = ends + 2 * (size_t)side_edge(d, f, k);
      if (pair[0] == GMDS_NONE) {
        pair[0] = nodes[k];
        pair[1] = nodes[k + 1 < n ? k + 1 : 0];
      }
    }
  }
  return GMDS_OK;
}

gmds_status derive_ends(derived *d)
{
  if (d->knows[ENDS])
    return GMDS_OK;
  if (derive_stores(d, 1, 0))
    d->end_of_edge = d->from->relation[1][0].column.data;
  else {
    int by_sides = !derive_stores(d, 0, 1);
    if (by_sides) {
      GMDS_TRY(derive_nodes_of_faces(d));
      GMDS_TRY(derive_edges_of_sides(d));
    }
    if (take(d, 2 * d->end_edges, &d->ends.column.data) != GMDS_OK)
      return no_memory(d);
    d->ends.column.capacity = 2 * d->end_edges;
    gmds_id *ends = d->ends.column.data;
    GMDS_TRY(by_sides ? ends_from_sides(d, ends) : ends_from_nodes(d, ends));
    for (size_t e = 0; e < d->end_edges; e++)
      if ((d->makes_edges || gmds_cells_has(&d->from->cells[1], (gmds_id)e)) && ends[2 * e + 1] == GMDS_NONE)
        return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED,
                         "the nodes of edge %zu are not known: it is linked with none and bounds no face", e);
    d->end_of_edge = ends;
  }
  d->knows[ENDS] = 1;
  return GMDS_OK;
}

/* ---- the nodes of faces */

/* Writes the nodes along a cycle of n edges: node k is the one before edge k. Edges that are not `fixed` are put in the
 * order of the cycle. 0 when they form none. */
static int chain(const gmds_id *ends, gmds_id *edges, size_t n, int fixed, gmds_id *nodes)
{
  if (n < 3)
    return 0;
  const gmds_id *first = ends + 2 * (size_t)edges[0], *last = ends + 2 * (size_t)edges[n - 1];
  int turned = fixed && first[0] != last[0] && first[0] != last[1];
  gmds_id at = first[!turned];
  nodes[0] = first[turned];
  for (size_t k = 1; k < n; k++) {
    size_t next = k;
    while (next < n && ends[2 * (size_t)edges[next]] != at && ends[2 * (size_t)edges[next] + 1] != at)
      next = fixed ? n : next + 1;
    if (next == n)
      return 0;
    gmds_id swap = edges[next];
    if (next != k) {
      edges[next] = edges[k];
      edges[k] = swap;
    }
    nodes[k] = at;
    at = ends[2 * (size_t)swap] == at ? ends[2 * (size_t)swap + 1] : ends[2 * (size_t)swap];
  }
  return at == nodes[0];
}

/* A csr with as many entries for each face as the view of its edges. */
static gmds_status begin_nodes(derived *d, const view *edges, gmds_csr *nodes)
{
  const gmds_cells *faces = &d->from->cells[2];
  void *begin = NULL, *data = NULL;
  size_t used = 0, n = 0;
  if (!gmds_resize(nodes->memory, &begin, 0, faces->end + 1, sizeof *nodes->begin))
    return no_memory(d);
  nodes->begin = begin;
  nodes->n = faces->end;
  for (size_t f = 0; f < faces->end; f++) {
    nodes->begin[f] = used;
    if (gmds_bits_get(&faces->alive, f)) {
      view_row(edges, f, &n);
      used += n;
    }
  }
  nodes->begin[faces->end] = used;
  if (!gmds_resize(nodes->memory, &data, 0, used, sizeof *nodes->data))
    return no_memory(d);
  nodes->data = data;
  nodes->capacity = used;
  return GMDS_OK;
}

static gmds_status nodes_from_edges(derived *d)
{
  const gmds_cells *faces = &d->from->cells[2];
  GMDS_TRY(derive_ends(d));
  int fixed = derive_stores(d, 2, 1);
  if (fixed)
    d->aligned = derive_stored(d, 2, 1);
  else {
    view bounds = derive_stored(d, 1, 2);
    if (derive_inverse(d, 1, &bounds, faces->end, &d->aligned.csr) != GMDS_OK)
      return no_memory(d);
  }
  GMDS_TRY(begin_nodes(d, &d->aligned, &d->nodes.csr));
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0;
    gmds_id *edges = view_row(&d->aligned, f, &n);
    if (!chain(d->end_of_edge, edges, n, fixed, d->nodes.csr.data + d->nodes.csr.begin[f]))
      return gmds_fail(d->error, GMDS_ERR_INVARIANT, "the edges of face %lu do not form a cycle", (unsigned long)f);
  }
  d->has_aligned = 1;
  return GMDS_OK;
}

/* Nodes without an order make a triangle, and nothing else. */
static gmds_status nodes_from_nodes(derived *d)
{
  const gmds_cells *faces = &d->from->cells[2];
  view stored = derive_stored(d, 0, 2);
  if (derive_inverse(d, 0, &stored, faces->end, &d->nodes.csr) != GMDS_OK)
    return no_memory(d);
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = d->nodes.csr.begin[f + 1] - d->nodes.csr.begin[f];
    if (n != 3)
      return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED,
                       "the order of the %zu nodes of face %lu is not known: neither F2N nor its edges keep it", n,
                       (unsigned long)f);
  }
  return GMDS_OK;
}

gmds_status derive_nodes_of_faces(derived *d)
{
  if (d->knows[NODES])
    return GMDS_OK;
  int by_edges = derive_stores(d, 2, 1) || derive_stores(d, 1, 2);
  if (derive_stores(d, 2, 0)) {
    d->nodes = derive_stored(d, 2, 0);
    if (derive_stores(d, 2, 1)) {
      d->aligned = derive_stored(d, 2, 1);
      d->has_aligned = 1;
    }
  } else if (mask_links_edges(d->from->layout.mask) && by_edges)
    GMDS_TRY(nodes_from_edges(d));
  else if (derive_stores(d, 0, 2))
    GMDS_TRY(nodes_from_nodes(d));
  else if (!d->from->cells[2].count) {
    view none = {.csr = {.memory = d->memory}};
    GMDS_TRY(begin_nodes(d, &none, &d->nodes.csr));
  } else
    return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED,
                     "the nodes of faces cannot be told from what is stored: add F2N, or N2F, or F2E with E2N");
  d->knows[NODES] = 1;
  return GMDS_OK;
}

/* ---- sides between the same two nodes */

gmds_status derive_groups(derived *d)
{
  if (d->knows[GROUPS])
    return GMDS_OK;
  const gmds_cells *cells = d->from->cells;
  int linked = mask_links_edges(d->from->layout.mask);
  GMDS_TRY(derive_nodes_of_faces(d));
  if (linked)
    GMDS_TRY(derive_ends(d));
  d->n_sides = view_extent(&d->nodes);
  d->n_grouped = d->n_sides + (linked ? d->end_edges : 0);
  if (d->n_grouped >= GMDS_NONE)
    return gmds_fail(d->error, GMDS_ERR_TOO_MANY, "%zu sides are more than identifiers", d->n_grouped);
  gmds_sides sides = {.n_nodes = cells[0].end,
                      .n_faces = cells[2].end,
                      .n_pairs = linked ? d->end_edges : 0,
                      .pairs = d->end_of_edge,
                      .pair_alive = &cells[1].alive,
                      .first_pair = d->n_sides};
  const gmds_part *part = d->nodes.part;
  if (!part) {
    sides.begin = d->nodes.csr.begin;
    sides.nodes = d->nodes.csr.data;
  } else if (part->how.storage == GMDS_IN_ROWS)
    sides.rows = &part->rows;
  else {
    sides.arity = part->how.arity;
    sides.nodes = part->column.data;
    sides.alive = &cells[2].alive;
  }
  gmds_id *nodes = NULL;
  size_t capacity = 0;
  if (take(d, d->n_grouped, &d->group) != GMDS_OK ||
      gmds_group_sides(&sides, d->memory, d->group, &d->n_groups, &nodes, &capacity) != GMDS_OK)
    return no_memory(d);
  gmds_release(d->memory, nodes, capacity, sizeof *nodes);
  d->knows[GROUPS] = 1;
  return GMDS_OK;
}

/* ---- the edges of sides */

static int same_set(const gmds_id *a, size_t n_a, const gmds_id *b, size_t n_b)
{
  size_t common = 0;
  for (size_t i = 0; i < n_a && n_a == n_b; i++)
    for (size_t j = 0; j < n_b; j++)
      common += a[i] == b[j];
  return n_a == n_b && common == n_a;
}

/* The relation from cells of dimension 1 to 2, or 2 to 1: stored, or the inverse of the stored one. */
static gmds_status between(derived *d, int i, int j, view *v)
{
  *v = (view){.csr = {.memory = d->memory}};
  if (derive_stores(d, i, j)) {
    *v = derive_stored(d, i, j);
    return GMDS_OK;
  }
  view inverse = derive_stored(d, j, i);
  return derive_inverse(d, j, &inverse, d->from->cells[i].end, &v->csr);
}

gmds_status derive_faces_of_groups(derived *d, gmds_csr *csr)
{
  const gmds_cells *faces = &d->from->cells[2];
  gmds_csr groups;
  gmds_status status = GMDS_OK;
  GMDS_TRY(derive_groups(d));
  const gmds_part *part = d->nodes.part;
  if (part && part->how.storage == GMDS_IN_COLUMN) /* the groups lie as the nodes do */
    status = gmds_invert_inline(d->group, part->how.arity, &faces->alive, faces->end, d->n_groups, csr);
  else if (!part) {
    groups = (gmds_csr){.n = d->nodes.csr.n, .begin = d->nodes.csr.begin, .data = d->group};
    status = gmds_invert_csr(&groups, d->n_groups, csr);
  } else {
    gmds_csr_init(&groups, d->memory);
    status = begin_nodes(d, &d->nodes, &groups);
    for (gmds_id f = 0; status == GMDS_OK && f < faces->end; f++)
      for (size_t k = groups.begin[f], side = view_base(&d->nodes, f); k < groups.begin[f + 1]; k++)
        groups.data[k] = d->group[side++];
    if (status == GMDS_OK)
      status = gmds_invert_csr(&groups, d->n_groups, csr);
    gmds_csr_clear(&groups);
  }
  return status == GMDS_OK ? status : no_memory(d);
}

/* Edges that know no node are told by their faces alone: each group of sides takes an edge that bounds just its faces.
 * Edges with the same faces are alike. */
static gmds_status match_edges(derived *d, const view *edges_of_face, const view *faces_of_edge,
                               const gmds_csr *faces_of_group, gmds_bits *taken)
{
  const gmds_cells *faces = &d->from->cells[2];
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0, n_edges = 0, side = view_base(&d->nodes, f);
    view_row(&d->nodes, f, &n);
    const gmds_id *edges = view_row(edges_of_face, f, &n_edges);
    for (size_t k = 0; k < n; k++) {
      gmds_id g = d->group[side + k], *match = &d->edge_of_group[g];
      const gmds_id *around = faces_of_group->data + faces_of_group->begin[g];
      size_t n_around = faces_of_group->begin[g + 1] - faces_of_group->begin[g], n_faces = 0;
      for (size_t q = 0; q < n_edges && *match == GMDS_NONE; q++) {
        const gmds_id *bounded = view_row(faces_of_edge, edges[q], &n_faces);
        if (!gmds_bits_get(taken, edges[q]) && same_set(around, n_around, bounded, n_faces))
          *match = edges[q];
      }
      if (*match == GMDS_NONE)
        return gmds_fail(d->error, GMDS_ERR_INVARIANT, "face %lu has a side without an edge", (unsigned long)f);
      gmds_bits_set(taken, *match);
    }
  }
  return GMDS_OK;
}

static gmds_status edges_from_faces(derived *d)
{
  gmds_memory *memory = d->memory;
  view edges_of_face = {.csr = {.memory = memory}}, faces_of_edge = edges_of_face;
  gmds_csr faces_of_group;
  gmds_bits taken = {.memory = memory};
  gmds_csr_init(&faces_of_group, memory);
  gmds_status status = between(d, 2, 1, &edges_of_face);
  if (status == GMDS_OK)
    status = between(d, 1, 2, &faces_of_edge);
  if (status == GMDS_OK)
    status = derive_faces_of_groups(d, &faces_of_group);
  if (status == GMDS_OK)
    status = gmds_bits_init(&taken, memory, d->end_edges);
  status = status == GMDS_OK ? match_edges(d, &edges_of_face, &faces_of_edge, &faces_of_group, &taken) : no_memory(d);
  gmds_csr_clear(&edges_of_face.csr);
  gmds_csr_clear(&faces_of_edge.csr);
  gmds_csr_clear(&faces_of_group);
  gmds_bits_clear(&taken);
  return status;
}

static gmds_status make_edges(derived *d)
{
  if (d->n_groups > d->limit)
    return gmds_fail(d->error, GMDS_ERR_TOO_MANY, "%zu edges are more than the model may have", d->n_groups);
  d->end_edges = d->n_groups;
  for (size_t g = 0; g < d->n_groups; g++)
    d->edge_of_group[g] = (gmds_id)g;
  return GMDS_OK;
}

gmds_status derive_edges_of_sides(derived *d)
{
  if (d->knows[ALIGNED])
    return GMDS_OK;
  GMDS_TRY(derive_nodes_of_faces(d));
  if (!d->has_aligned) {
    GMDS_TRY(derive_groups(d));
    if (take(d, d->n_groups, &d->edge_of_group) != GMDS_OK)
      return no_memory(d);
    if (d->makes_edges)
      GMDS_TRY(make_edges(d));
    else if (!mask_links_edges(d->from->layout.mask))
      GMDS_TRY(edges_from_faces(d));
    for (size_t e = 0; d->n_grouped > d->n_sides && e < d->end_edges; e++)
      if (gmds_cells_has(&d->from->cells[1], (gmds_id)e))
        d->edge_of_group[d->group[d->n_sides + e]] = (gmds_id)e;
    for (size_t g = 0; g < d->n_groups; g++)
      if (d->edge_of_group[g] == GMDS_NONE)
        return gmds_fail(d->error, GMDS_ERR_INVARIANT, "two nodes are joined by a face and by no edge");
  }
  d->knows[ALIGNED] = 1;
  return GMDS_OK;
}
