/* New numbers for cells, and copies of cells, parts and volumes under them. */
#include "derive.h"
#include <gmds/order.h>
#include <gmds/renumber.h>
#include <gmds/volume.h>
#include <string.h>

/* ---- numbers */

/* Numbers the cells c of a map that are not GMDS_NONE in the order of their keys below n_keys, equal ones in their
 * order. */
static gmds_status number_by(gmds_memory *memory, const gmds_id *keys, size_t n_keys, size_t end, gmds_id *map)
{
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, n_keys + 1, sizeof(size_t)))
    return GMDS_ERR_MEMORY;
  size_t *first = block;
  memset(first, 0, (n_keys + 1) * sizeof *first);
  for (size_t c = 0; c < end; c++)
    if (map[c] != GMDS_NONE)
      first[keys[c] + 1]++;
  for (size_t k = 0; k < n_keys; k++)
    first[k + 1] += first[k];
  for (size_t c = 0; c < end; c++)
    if (map[c] != GMDS_NONE)
      map[c] = (gmds_id)first[keys[c]]++;
  gmds_release(memory, block, n_keys + 1, sizeof(size_t));
  return GMDS_OK;
}

typedef struct nodes_along {
  size_t n; /* live ones */
  double *points;
  gmds_id *order, *same_as, *keys; /* n, n; end */
} nodes_along;

static gmds_status key_nodes(gmds_memory *memory, int dim, const double *points, size_t end, const gmds_id *map,
                             nodes_along *w, gmds_error *error)
{
  size_t n = 0, distinct = 0;
  const size_t bytes = (size_t)dim * sizeof *points;
  for (size_t v = 0; v < end; v++)
    if (map[v] != GMDS_NONE)
      memcpy(w->points + (size_t)dim * n++, points + (size_t)dim * v, bytes);
  GMDS_TRY(gmds_order_along_curve(memory, dim, n, w->points, error, w->order, w->same_as, &distinct));
  for (size_t k = distinct; k-- > 0;) /* the rank of a point goes where its coordinates were */
    w->points[w->order[k]] = (double)k;
  n = 0;
  for (size_t v = 0; v < end; v++)
    if (map[v] != GMDS_NONE)
      w->keys[v] = (gmds_id)w->points[w->same_as[n++]];
  return GMDS_OK;
}

static gmds_status number_nodes(gmds_memory *memory, int dim, const double *points, size_t end, gmds_id *map,
                                gmds_error *error)
{
  nodes_along w = {.n = 0};
  void *block[4] = {NULL, NULL, NULL, NULL};
  for (size_t v = 0; v < end; v++)
    w.n += map[v] != GMDS_NONE;
  const size_t counts[4] = {w.n * (size_t)dim, w.n, w.n, end},
               sizes[4] = {sizeof(double), sizeof(gmds_id), sizeof(gmds_id), sizeof(gmds_id)};
  gmds_status status = GMDS_OK;
  for (int k = 0; k < 4 && status == GMDS_OK; k++)
    status = gmds_resize(memory, &block[k], 0, counts[k], sizes[k]) ? GMDS_OK : GMDS_ERR_MEMORY;
  w.points = block[0];
  w.order = block[1];
  w.same_as = block[2];
  w.keys = block[3];
  if (status == GMDS_OK)
    status = key_nodes(memory, dim, points, end, map, &w, error);
  if (status == GMDS_OK)
    status = number_by(memory, w.keys, w.n, end, map);
  for (int k = 0; k < 4; k++)
    gmds_release(memory, block[k], block[k] ? counts[k] : 0, sizes[k]);
  return status;
}

/* By the least number of a node; cells of which no node is known go last. */
static gmds_status number_cells(gmds_memory *memory, const gmds_csr *nodes, size_t n_nodes, const gmds_id *node_map,
                                size_t end, gmds_id *map)
{
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, end, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *keys = block;
  for (size_t c = 0; c < end; c++) {
    keys[c] = (gmds_id)n_nodes;
    for (size_t q = c < nodes->n ? nodes->begin[c] : 0; c < nodes->n && q < nodes->begin[c + 1]; q++)
      keys[c] = node_map[nodes->data[q]] < keys[c] ? node_map[nodes->data[q]] : keys[c];
  }
  gmds_status status = number_by(memory, keys, n_nodes + 1, end, map);
  gmds_release(memory, block, end, sizeof(gmds_id));
  return status;
}

gmds_status gmds_number_along_curve(gmds_memory *memory, int dim, const double *points, const gmds_complex *complex,
                                    int top, const size_t *end, gmds_id *const *maps, gmds_error *error)
{
  GMDS_TRY(number_nodes(memory, dim, points, end[0], maps[0], error));
  for (int i = 1; i <= top; i++)
    GMDS_TRY(number_cells(memory, &complex->nodes[i], end[0], maps[0], end[i], maps[i]));
  return GMDS_OK;
}

/* ---- copies */

gmds_status gmds_cells_copy_as(const gmds_cells *from, const gmds_id *map, gmds_cells *to)
{
  GMDS_TRY(gmds_cells_resize(to, from->count));
  (void)gmds_cells_take_many(to, from->count);
  for (const gmds_attribute *a = from->attributes; a; a = a->next) {
    gmds_attribute *b = NULL;
    GMDS_TRY(gmds_attribute_add(to, a->name, a->type, a->components, &b));
    for (gmds_id c = gmds_cells_next(from, 0); c != GMDS_NONE; c = gmds_cells_next(from, c + 1))
      memcpy((char *)b->data + map[c] * a->bytes, (const char *)a->data + c * a->bytes, a->bytes);
  }
  return GMDS_OK;
}

static gmds_status copy_points(gmds_memory *memory, const gmds_cells *nodes, int dim, const double *points,
                               const gmds_id *map, double **copy)
{
  const size_t d = (size_t)dim;
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, nodes->count, d * sizeof(double)))
    return GMDS_ERR_MEMORY;
  for (gmds_id v = gmds_cells_next(nodes, 0); v != GMDS_NONE; v = gmds_cells_next(nodes, v + 1))
    memcpy((double *)block + d * map[v], points + d * v, d * sizeof(double));
  *copy = block;
  return GMDS_OK;
}

/* Row c of `from` becomes row rows[c], entry x becomes entries[x]. The csr is initialised and empty. */
static gmds_status copy_rows(const view *from, size_t end, const gmds_cells *cells, const gmds_id *rows,
                             const gmds_id *entries, int coded, gmds_csr *to)
{
  size_t n = 0;
  GMDS_TRY(gmds_csr_begin(to, cells->count));
  for (size_t c = 0; c < end; c++)
    if (gmds_cells_has(cells, (gmds_id)c)) {
      (void)view_row(from, c, &n);
      to->begin[rows[c] + 1] = n;
    }
  GMDS_TRY(gmds_csr_finish(to));
  for (size_t c = 0; c < end; c++) {
    if (!gmds_cells_has(cells, (gmds_id)c))
      continue;
    const gmds_id *row = view_row(from, c, &n);
    gmds_id *copy = n ? to->data + to->begin[rows[c]] : NULL;
    for (size_t k = 0; k < n; k++)
      copy[k] = row[k] == GMDS_NONE ? GMDS_NONE : coded ? entries[row[k] >> 2] << 2 | (row[k] & 3) : entries[row[k]];
  }
  return GMDS_OK;
}

static gmds_status copy_complex(const gmds_volume *from, gmds_id *const maps[4], gmds_volume *to)
{
  const gmds_complex *c = &from->complex;
  gmds_complex *copy = &to->complex;
  copy->n_nodes = from->cells[0].count;
  for (int i = 1; i < 4; i++) {
    const view nodes = {.csr = c->nodes[i]};
    if (c->nodes[i].n)
      GMDS_TRY(copy_rows(&nodes, c->nodes[i].n, &from->cells[i], maps[i], maps[0], 0, &copy->nodes[i]));
  }
  const view walls = {.csr = c->walls};
  if (c->walls.begin)
    GMDS_TRY(copy_rows(&walls, c->walls.n, &from->cells[3], maps[3], maps[2], 0, &copy->walls));
  void *types = NULL;
  if (!gmds_resize(copy->memory, &types, 0, from->cells[3].count, 1))
    return GMDS_ERR_MEMORY;
  copy->types = types;
  copy->types_capacity = from->cells[3].count;
  for (gmds_id r = gmds_cells_next(&from->cells[3], 0); r != GMDS_NONE; r = gmds_cells_next(&from->cells[3], r + 1))
    copy->types[maps[3][r]] = c->types[r];
  return GMDS_OK;
}

gmds_status gmds_volume_copy_as(const gmds_volume *from, gmds_id *const maps[4], gmds_volume *to)
{
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 4 && status == GMDS_OK; i++)
    status = gmds_cells_copy_as(&from->cells[i], maps[i], &to->cells[i]);
  if (status == GMDS_OK)
    status = copy_points(to->memory, &from->cells[0], 3, from->points, maps[0], &to->points);
  if (status == GMDS_OK)
    status = copy_complex(from, maps, to);
  if (status != GMDS_OK)
    gmds_volume_clear(to);
  return status;
}

static gmds_status copy_part(const gmds_parts *from, int i, int j, gmds_id *const maps[3], gmds_parts *to)
{
  const gmds_part *p = &from->relation[i][j];
  const view rows = {.part = p};
  const size_t n = from->cells[i].count;
  gmds_part *copy = &to->relation[i][j];
  gmds_csr csr;
  gmds_csr_init(&csr, &to->memory);
  gmds_status status = copy_rows(&rows, from->cells[i].end, &from->cells[i], maps[i], maps[j], p->how.coded, &csr);
  if (status == GMDS_OK && p->how.storage == GMDS_IN_ROWS) {
    gmds_id *data = csr.data;
    status = gmds_rows_adopt(&copy->rows, &to->memory, n, csr.begin, n, &data, csr.capacity);
    if (!data)
      csr.capacity = 0;
    csr.data = data;
  } else if (status == GMDS_OK && p->how.storage == GMDS_IN_PAIRS)
    status = gmds_pairs_fill(&copy->pairs, &to->memory, n, csr.begin, n, csr.data);
  else if (status == GMDS_OK) {
    status = gmds_column_resize(&copy->column, &to->memory, p->how.arity * n);
    if (status == GMDS_OK && n)
      memcpy(copy->column.data, csr.data, p->how.arity * n * sizeof *csr.data);
  }
  gmds_csr_clear(&csr);
  return status;
}

gmds_status gmds_parts_copy_as(const gmds_parts *from, gmds_id *const maps[3], gmds_parts *to)
{
  gmds_status status = GMDS_OK;
  gmds_parts_init(to);
  gmds_memory_init(&to->memory, &from->memory.allocator);
  to->memory.limit = from->memory.limit - from->memory.live;
  to->layout = from->layout;
  for (int i = 0; i < 3; i++) {
    gmds_cells_init(&to->cells[i], &to->memory, from->layout.limit[i]);
    for (int j = 0; j < 3; j++) {
      gmds_part *part = &to->relation[i][j];
      part->how = from->relation[i][j].how;
      gmds_rows_init(&part->rows, part->how.ordered);
      gmds_pairs_init(&part->pairs);
    }
  }
  for (int i = 0; i < 3 && status == GMDS_OK; i++)
    status = gmds_cells_copy_as(&from->cells[i], maps[i], &to->cells[i]);
  if (status == GMDS_OK)
    status = copy_points(&to->memory, &from->cells[0], from->layout.dim, from->points, maps[0], &to->points);
  if (status == GMDS_OK)
    to->points_capacity = from->cells[0].count;
  for (int ij = 0; ij < 9 && status == GMDS_OK; ij++)
    if (from->relation[ij / 3][ij % 3].how.storage != GMDS_NOWHERE)
      status = copy_part(from, ij / 3, ij % 3, maps, to);
  if (status != GMDS_OK)
    gmds_parts_clear(to);
  return status;
}
