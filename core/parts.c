/* The parts of a mesh, and their conversion from one layout to another: what both store is moved, what is missing is
 * built beside it, and only when all is there does anything change. */
#include "derive.h"
#include <gmds/parts.h>
#include <gmds/relations.h>
#include <string.h>

void gmds_parts_init(gmds_parts *parts)
{
  memset(parts, 0, sizeof *parts);
  gmds_memory_init(&parts->memory, NULL);
}

static void clear_part(gmds_part *part, gmds_memory *memory)
{
  if (part->how.storage == GMDS_IN_ROWS)
    gmds_rows_clear(&part->rows, memory);
  else if (part->how.storage == GMDS_IN_PAIRS)
    gmds_pairs_clear(&part->pairs, memory);
  else if (part->how.storage == GMDS_IN_COLUMN)
    gmds_column_clear(&part->column, memory);
  part->how = (gmds_stored){.storage = GMDS_NOWHERE};
}

void gmds_parts_clear(gmds_parts *parts)
{
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      clear_part(&parts->relation[i][j], &parts->memory);
  gmds_release(&parts->memory, parts->points, parts->points_capacity, (size_t)parts->layout.dim * sizeof(double));
  for (int i = 0; i < 3 && parts->layout.mask; i++)
    gmds_cells_clear(&parts->cells[i]);
  gmds_parts_init(parts);
}

/* ---- what is moved */

static int orders_faces(unsigned mask)
{
  const unsigned nodes = GMDS_RELATION_BIT(2, 0), edges = GMDS_RELATION_BIT(2, 1) | GMDS_RELATION_BIT(1, 0);
  return (mask & nodes) != 0 || (mask & edges) == edges;
}

/* Whether the stored relation i2j is what `to` stores. */
static int moves(const gmds_layout *from, const gmds_layout *to, int i, int j)
{
  const gmds_stored *had = &from->relation[i][j], *has = &to->relation[i][j];
  if (had->storage != has->storage || had->arity != has->arity || had->coded != has->coded)
    return 0;
  if (i == 0 && j == 0) /* joined by an edge that is kept, or by the side of a face */
    return mask_links_edges(from->mask) == mask_links_edges(to->mask);
  if (i == 2 && j > 0) /* in the order of the sides where the faces have one */
    return orders_faces(from->mask) || !orders_faces(to->mask);
  return 1;
}

/* ---- what is built */

static gmds_status no_memory(gmds_error *error, gmds_status status)
{
  return gmds_fail(error, status, "converting a mesh: %s", gmds_status_text(status));
}

/* Puts a csr of i-cells where and how `part` is stored, with room for n cells, and clears it. */
static gmds_status store_csr(derived *d, gmds_csr *csr, size_t n, gmds_part *part)
{
  gmds_status status = GMDS_OK;
  if (part->how.storage == GMDS_IN_PAIRS) {
    gmds_pairs_init(&part->pairs);
    status = gmds_pairs_fill(&part->pairs, d->memory, n, csr->begin, csr->n, csr->data);
  } else {
    gmds_rows_init(&part->rows, part->how.ordered);
    status = gmds_rows_adopt(&part->rows, d->memory, n, csr->begin, csr->n, &csr->data, csr->capacity);
  }
  if (!csr->data)
    csr->capacity = 0;
  gmds_csr_clear(csr);
  return status == GMDS_OK ? status : no_memory(d->error, status);
}

static gmds_status begin_csr(derived *d, size_t n, gmds_csr *csr)
{
  void *begin = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return no_memory(d->error, GMDS_ERR_MEMORY);
  csr->begin = begin;
  csr->n = n;
  memset(csr->begin, 0, (n + 1) * sizeof *csr->begin);
  return GMDS_OK;
}

/* Turns the counts in begin[c + 1] into where the entries of c go, and makes room for them. */
static gmds_status sum_csr(derived *d, gmds_csr *csr)
{
  size_t total = 0;
  void *data = NULL;
  for (size_t c = 0; c < csr->n; c++) {
    size_t count = csr->begin[c + 1];
    csr->begin[c + 1] = total;
    total += count;
  }
  if (!gmds_resize(csr->memory, &data, 0, total, sizeof *csr->data))
    return no_memory(d->error, GMDS_ERR_MEMORY);
  csr->data = data;
  csr->capacity = total;
  return GMDS_OK;
}

/* Counts, or places, one entry of c. */
static void enter(gmds_csr *csr, size_t c, gmds_id x)
{
  size_t *at = &csr->begin[c + 1];
  if (csr->data)
    csr->data[*at] = x;
  ++*at;
}

static int edge_lives(const derived *d, size_t e)
{
  return d->makes_edges || gmds_cells_has(&d->from->cells[1], (gmds_id)e);
}

/* N2E, N2N and E2E from the nodes of edges; N2N, where no edge says what is joined, from sides. */
static gmds_status enter_ends(derived *d, int i, int j, const gmds_csr *edges_of_node, gmds_csr *csr)
{
  for (size_t e = 0; e < d->end_edges; e++) {
    const gmds_id *ends = d->end_of_edge + 2 * e;
    if (!edge_lives(d, e))
      continue;
    for (int q = 0; q < 2; q++)
      if (i == 0)
        enter(csr, ends[q], j == 0 ? ends[!q] : (gmds_id)e);
      else
        for (size_t k = edges_of_node->begin[ends[q]]; k < edges_of_node->begin[ends[q] + 1]; k++)
          if (edges_of_node->data[k] != e)
            enter(csr, e, edges_of_node->data[k]);
  }
  return GMDS_OK;
}

static gmds_status enter_sides(derived *d, gmds_csr *csr)
{
  const gmds_cells *faces = &d->from->cells[2];
  gmds_bits met;
  GMDS_TRY(gmds_bits_init(&met, csr->memory, d->n_groups));
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0, side = view_base(&d->nodes, f);
    const gmds_id *nodes = view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++) {
      gmds_id g = d->group[side + k], a = nodes[k], b = nodes[k + 1 < n ? k + 1 : 0];
      if (gmds_bits_get(&met, g))
        continue;
      gmds_bits_set(&met, g);
      enter(csr, a, b);
      enter(csr, b, a);
    }
  }
  gmds_bits_clear(&met);
  return GMDS_OK;
}

/* E2F and N2F by what is at the sides of faces. */
static gmds_status enter_faces(derived *d, int i, gmds_csr *csr)
{
  const gmds_cells *faces = &d->from->cells[2];
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0;
    const gmds_id *nodes = view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++)
      enter(csr, i == 0 ? nodes[k] : side_edge(d, f, k), f);
  }
  return GMDS_OK;
}

/* Two passes of `enter`: count and place. */
static gmds_status fill_set(derived *d, int i, int j, int by_ends, const gmds_csr *edges_of_node, gmds_csr *csr)
{
  GMDS_TRY(begin_csr(d, i == 1 ? d->end_edges : d->from->cells[i].end, csr));
  for (int pass = 0; pass < 2; pass++) {
    gmds_status status = j == 2    ? enter_faces(d, i, csr)
                         : by_ends ? enter_ends(d, i, j, edges_of_node, csr)
                                   : enter_sides(d, csr);
    if (status != GMDS_OK)
      return no_memory(d->error, status);
    if (pass == 0)
      GMDS_TRY(sum_csr(d, csr));
    if (!csr->data)
      return GMDS_OK;
  }
  return GMDS_OK;
}

/* A set: N2N, N2E, N2F, E2E, E2F. */
static gmds_status build_set(derived *d, int i, int j, int to_links, size_t n, gmds_part *part)
{
  gmds_csr csr, edges_of_node;
  gmds_csr_init(&csr, d->memory);
  gmds_csr_init(&edges_of_node, csr.memory);
  gmds_status status = GMDS_OK;
  if (j == 2 && derive_stores(d, 2, i)) { /* the inverse of what is stored, whatever its order */
    view stored = derive_stored(d, 2, i);
    status = derive_inverse(d, 2, &stored, d->from->cells[i].end, &csr);
    return status == GMDS_OK ? store_csr(d, &csr, n, part) : no_memory(d->error, status);
  }
  int by_ends = j < 2 && (i + j > 0 || to_links);
  if (by_ends)
    status = derive_ends(d);
  else {
    status = derive_nodes_of_faces(d);
    if (status == GMDS_OK && i == 0 && j == 0)
      status = derive_groups(d);
    if (status == GMDS_OK && i == 1)
      status = derive_edges_of_sides(d);
  }
  if (status == GMDS_OK && i == 1 && j == 1)
    status = fill_set(d, 0, 1, 1, NULL, &edges_of_node);
  if (status == GMDS_OK)
    status = fill_set(d, i, j, by_ends, &edges_of_node, &csr);
  gmds_csr_clear(&edges_of_node);
  if (status == GMDS_OK)
    return store_csr(d, &csr, n, part);
  gmds_csr_clear(&csr);
  return status;
}

static gmds_status build_ends(derived *d, size_t n, gmds_part *part)
{
  GMDS_TRY(derive_ends(d));
  if (gmds_column_resize(&part->column, d->memory, 2 * n) != GMDS_OK)
    return no_memory(d->error, GMDS_ERR_MEMORY);
  if (d->end_edges)
    memcpy(part->column.data, d->end_of_edge, 2 * d->end_edges * sizeof *d->end_of_edge);
  return GMDS_OK;
}

/* The two sides of each group, GMDS_NONE where there is one: as numbers of sides, or as faces. */
typedef struct opposite {
  gmds_id *side, *face; /* two of each group */
  size_t n;
} opposite;

static void clear_opposite(derived *d, opposite *o)
{
  gmds_release(d->memory, o->side, o->side ? o->n : 0, sizeof *o->side);
  gmds_release(d->memory, o->face, o->face ? o->n : 0, sizeof *o->face);
}

static gmds_status find_opposite(derived *d, opposite *o)
{
  const gmds_cells *faces = &d->from->cells[2];
  void *side = NULL, *face = NULL;
  GMDS_TRY(derive_groups(d));
  o->n = 2 * d->n_groups;
  if (gmds_resize(d->memory, &side, 0, o->n, sizeof *o->side))
    o->side = side;
  if (gmds_resize(d->memory, &face, 0, o->n, sizeof *o->face))
    o->face = face;
  if (o->n && (!side || !face))
    return no_memory(d->error, GMDS_ERR_MEMORY);
  if (o->n)
    memset(face, 0xff, o->n * sizeof *o->face);
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    size_t n = 0, base = view_base(&d->nodes, f);
    view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++) {
      size_t at = 2 * (size_t)d->group[base + k];
      at += o->face[at] != GMDS_NONE;
      if (o->face[at] != GMDS_NONE)
        return gmds_fail(d->error, GMDS_ERR_CONFLICT, "F2F holds two faces a side: face %lu is the third on one",
                         (unsigned long)f);
      o->face[at] = f;
      o->side[at] = (gmds_id)k;
    }
  }
  return GMDS_OK;
}

/* What face f has at its side k: a node, an edge, or the face beyond. */
static gmds_id at_side(const derived *d, const opposite *o, int j, int coded, size_t f, size_t k)
{
  size_t n = 0;
  if (j == 0)
    return view_row(&d->nodes, f, &n)[k];
  if (j == 1)
    return side_edge(d, f, k);
  size_t at = 2 * (size_t)d->group[view_base(&d->nodes, f) + k];
  at += o->face[at] == f;
  return coded && o->face[at] != GMDS_NONE ? 4 * o->face[at] + o->side[at] : o->face[at];
}

static gmds_status fill_column(derived *d, const opposite *o, int j, size_t n, gmds_part *part)
{
  const gmds_cells *faces = &d->from->cells[2];
  size_t arity = part->how.arity;
  if (gmds_column_resize(&part->column, d->memory, arity * n) != GMDS_OK)
    return no_memory(d->error, GMDS_ERR_MEMORY);
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1))
    for (size_t k = 0; k < arity; k++)
      part->column.data[arity * f + k] = at_side(d, o, j, part->how.coded, f, k);
  return GMDS_OK;
}

static gmds_status fill_rows(derived *d, const opposite *o, int j, size_t n, gmds_part *part)
{
  const gmds_cells *faces = &d->from->cells[2];
  gmds_csr csr;
  gmds_csr_init(&csr, d->memory);
  gmds_status status = begin_csr(d, faces->end, &csr);
  for (int pass = 0; pass < 2 && status == GMDS_OK; pass++) {
    for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
      size_t sides = 0;
      view_row(&d->nodes, f, &sides);
      for (size_t k = 0; k < sides; k++)
        enter(&csr, f, pass ? at_side(d, o, j, part->how.coded, f, k) : GMDS_NONE);
    }
    if (pass == 0)
      status = sum_csr(d, &csr);
    if (!csr.data)
      break;
  }
  if (status == GMDS_OK)
    return store_csr(d, &csr, n, part);
  gmds_csr_clear(&csr);
  return status;
}

/* F2N, F2E, F2F. */
static gmds_status build_of_faces(derived *d, int j, size_t n, gmds_part *part)
{
  opposite o = {NULL, NULL, 0};
  gmds_status status = derive_nodes_of_faces(d);
  if (status == GMDS_OK && j == 1)
    status = derive_edges_of_sides(d);
  if (status == GMDS_OK && j == 2)
    status = find_opposite(d, &o);
  if (status == GMDS_OK)
    status = part->how.storage == GMDS_IN_COLUMN ? fill_column(d, &o, j, n, part) : fill_rows(d, &o, j, n, part);
  clear_opposite(d, &o);
  return status;
}

/* ---- the conversion */

/* Whether the new layout holds what there is. */
static gmds_status check_cells(derived *d, const gmds_layout *to)
{
  const gmds_parts *from = d->from;
  static const char *const word[3] = {"nodes", "edges", "faces"};
  if (!from->layout.mask)
    return gmds_fail(d->error, GMDS_ERR_ARGUMENT, "there are no parts to be taken");
  if (from->layout.dim != to->dim)
    return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED, "nodes have %d coordinates, those of the model %d",
                     from->layout.dim, to->dim);
  for (int i = 0; i < 3; i++)
    if (from->cells[i].end > to->limit[i] && (i != 1 || to->mask & GMDS_E))
      return gmds_fail(d->error, GMDS_ERR_TOO_MANY, "%zu %s are more than the model may have", from->cells[i].end,
                       word[i]);
  if (mask_makes_edges(to->mask) && !mask_makes_edges(from->layout.mask) && from->cells[1].count)
    return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED, "nothing tells where the %zu edges are", from->cells[1].count);
  if (!(from->layout.faces & ~to->faces))
    return GMDS_OK;
  GMDS_TRY(derive_nodes_of_faces(d));
  for (gmds_id f = gmds_cells_next(&from->cells[2], 0); f != GMDS_NONE; f = gmds_cells_next(&from->cells[2], f + 1)) {
    size_t n = 0;
    view_row(&d->nodes, f, &n);
    if (!((n == 3 && to->faces & 1) || (n == 4 && to->faces & 2) || to->faces & 4))
      return gmds_fail(d->error, GMDS_ERR_UNSUPPORTED, "face %lu has %zu sides: the model holds no such face",
                       (unsigned long)f, n);
  }
  return GMDS_OK;
}

static gmds_status build(derived *d, gmds_parts *parts, const gmds_layout *to, gmds_part fresh[3][3])
{
  const gmds_cells *cells = d->from->cells;
  GMDS_TRY(check_cells(d, to));
  if (d->makes_edges)
    GMDS_TRY(derive_edges_of_sides(d));
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      if (to->relation[i][j].storage == GMDS_NOWHERE || moves(&d->from->layout, to, i, j))
        continue;
      fresh[i][j].how = to->relation[i][j];
      size_t n = i == 1 && d->end_edges > cells[1].capacity ? d->end_edges : cells[i].capacity;
      if (i == 2)
        GMDS_TRY(build_of_faces(d, j, n, &fresh[i][j]));
      else if (i == 1 && j == 0)
        GMDS_TRY(build_ends(d, n, &fresh[i][j]));
      else
        GMDS_TRY(build_set(d, i, j, mask_links_edges(to->mask), n, &fresh[i][j]));
    }
  if (d->makes_edges && d->end_edges > cells[1].capacity) {
    gmds_status status = gmds_cells_resize(&parts->cells[1], d->end_edges);
    if (status != GMDS_OK)
      return no_memory(d->error, status);
  }
  return GMDS_OK;
}

/* Cannot fail. */
static void commit(const derived *d, gmds_parts *parts, const gmds_layout *to, gmds_part fresh[3][3])
{
  gmds_cells *edges = &parts->cells[1];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (to->relation[i][j].storage == GMDS_NOWHERE || fresh[i][j].how.storage != GMDS_NOWHERE) {
        clear_part(&parts->relation[i][j], &parts->memory);
        parts->relation[i][j] = fresh[i][j];
      }
  if (d->makes_edges) {
    edges->end = edges->count = edges->hole = d->end_edges;
    gmds_bits_fill(&edges->alive, d->end_edges);
    for (gmds_attribute *a = edges->attributes; a && d->end_edges; a = a->next)
      memset(a->data, 0, d->end_edges * a->bytes);
  } else if (!(to->mask & GMDS_E))
    gmds_cells_empty(edges);
  for (int i = 0; i < 3; i++)
    parts->cells[i].limit = to->limit[i];
  parts->layout = *to;
}

gmds_status gmds_parts_convert(gmds_parts *parts, const gmds_layout *to, gmds_error *error)
{
  gmds_part fresh[3][3];
  derived d;
  memset(fresh, 0, sizeof fresh);
  derive_begin(&d, parts, &parts->memory, error);
  d.makes_edges = mask_makes_edges(to->mask) && !mask_makes_edges(parts->layout.mask);
  d.limit = to->limit[1];
  gmds_status status = build(&d, parts, to, fresh);
  if (status == GMDS_OK)
    commit(&d, parts, to, fresh);
  else
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        clear_part(&fresh[i][j], &parts->memory);
  derive_end(&d);
  return status;
}
