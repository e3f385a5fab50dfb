/* Cells of a combinatorial map from points or nodes. */
#include "map_inside.h"
#include <string.h>

/* What a cell is made of. */
typedef struct making {
  gmds_map *map;
  size_t n_darts, n_nodes, n_edges, n_faces;
} making;

static gmds_status make_room(const making *k, int has_nodes)
{
  gmds_map *map = k->map;
  const size_t more[GMDS_MAP_KEPT] = {has_nodes ? 0 : k->n_nodes, k->n_edges, k->n_faces, 1};
  if (map->darts.end + k->n_darts > map->darts.capacity || map->darts.count < map->darts.end)
    GMDS_TRY(gmds_map_grow(map, -1, k->n_darts));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i])
      GMDS_TRY(gmds_map_grow(map, i, more[i]));
  return GMDS_OK;
}

/* n identifiers, which follow each other where there are no holes. */
static void take(gmds_cells *cells, size_t n, gmds_id *ids)
{
  if (cells->count == cells->end) {
    const gmds_id first = gmds_cells_take_many(cells, n);
    for (size_t k = 0; k < n; k++)
      ids[k] = first + (gmds_id)k;
  } else
    for (size_t k = 0; k < n; k++)
      ids[k] = gmds_cells_take(cells);
}

static gmds_status check_nodes(const gmds_map *map, size_t n, const gmds_id *nodes)
{
  for (size_t k = 0; k < n; k++) {
    if (!gmds_cells_has(&map->cells[0], nodes[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; q < k && n <= 64; q++)
      if (nodes[q] == nodes[k])
        return GMDS_ERR_ARGUMENT;
  }
  return GMDS_OK;
}

static void place_points(gmds_map *map, size_t n, const gmds_id *nodes, const double *x)
{
  const size_t dim = (size_t)map->coordinates;
  for (size_t k = 0; k < n; k++) {
    double *to = map->points + dim * nodes[k];
    if (x)
      for (size_t q = 0; q < dim; q++)
        to[q] = x[dim * k + q];
    else
      memset(to, 0, dim * sizeof *to);
  }
}

static gmds_status make_stencil(gmds_map *map, const gmds_map_stencil *s, size_t n_nodes, size_t n_faces,
                                const double *x, const gmds_id *nodes, gmds_id *d)
{
  gmds_id dart[24], cell[GMDS_MAP_KEPT][12];
  const uint8_t *const local[3] = {s->node, s->edge, s->face};
  const size_t n[GMDS_MAP_KEPT] = {n_nodes, s->edges, n_faces, 1};
  const making room = {.map = map, .n_darts = s->darts, .n_nodes = n_nodes, .n_edges = s->edges, .n_faces = n_faces};
  if (nodes)
    GMDS_TRY(check_nodes(map, n_nodes, nodes));
  GMDS_TRY(make_room(&room, nodes != NULL));
  take(&map->darts, s->darts, dart);
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i] && (i || !nodes))
      take(&map->cells[i], n[i], cell[i]);
  if (nodes)
    memcpy(cell[0], nodes, n_nodes * sizeof *nodes);
  else
    place_points(map, n_nodes, cell[0], x);
  for (unsigned k = 0; k < s->darts; k++) {
    gmds_id *record = gmds_map_record(map, dart[k]);
    record[0] = dart[s->before[k]];
    record[1] = dart[s->next[k]];
    record[2] = dart[s->beyond[k]];
    for (int i = 3; i <= map->n; i++)
      record[i] = GMDS_NONE;
    const gmds_id v = cell[0][s->node[k]];
    record[map->n + 1] = v;
    if (!nodes || map->anchor[0][v] == GMDS_NONE)
      map->anchor[0][v] = dart[k];
  }
  for (int i = 1; i < GMDS_MAP_KEPT; i++)
    for (unsigned k = 0; k < s->darts && map->slot[i]; k++) {
      const gmds_id c = cell[i][i < 3 ? local[i][k] : 0];
      gmds_map_record(map, dart[k])[map->slot[i]] = c;
      map->anchor[i][c] = dart[k];
    }
  if (map->slot[3])
    map->anchor[3][cell[3][0]] = dart[0];
  *d = dart[0];
  return GMDS_OK;
}

gmds_status gmds_map_make_shape(gmds_map *map, gmds_cell_type type, const double *x, const gmds_id *nodes, gmds_id *d)
{
  const gmds_map_stencil *s = gmds_map_stencil_of(type);
  const gmds_shape *shape = gmds_shape_of(type);
  if (!s || map->n < 3)
    return GMDS_ERR_ARGUMENT;
  return make_stencil(map, s, shape->nodes, shape->faces, x, nodes, d);
}

/* For each corner of a frame the one on the other side of its edge, or GMDS_NONE where it has one face only.
 * GMDS_ERR_ARGUMENT: an edge is not on two faces, once each way. `room` has space for n_nodes + 2 corners. */
static gmds_status pair_corners(const gmds_map_frame *f, gmds_id *room, gmds_id *beyond)
{
  const size_t n = f->begin[f->n_faces];
  gmds_id *head = room, *next = head + f->n_nodes, *end = next + n; /* corners by node, and where each leads */
  for (size_t v = 0; v < f->n_nodes; v++)
    head[v] = GMDS_NONE;
  for (size_t k = 0; k < f->n_faces; k++) {
    if (f->begin[k + 1] < f->begin[k] + 3)
      return GMDS_ERR_ARGUMENT;
    for (size_t c = f->begin[k]; c < f->begin[k + 1]; c++) {
      if (f->corners[c] >= f->n_nodes)
        return GMDS_ERR_ARGUMENT;
      end[c] = f->corners[c + 1 < f->begin[k + 1] ? c + 1 : f->begin[k]];
      next[c] = head[f->corners[c]];
      head[f->corners[c]] = (gmds_id)c;
    }
  }
  for (size_t c = 0; c < n; c++) {
    size_t same = 0, found = 0;
    beyond[c] = GMDS_NONE;
    for (gmds_id q = head[f->corners[c]]; q != GMDS_NONE; q = next[q])
      same += end[q] == end[c];
    for (gmds_id q = head[end[c]]; q != GMDS_NONE; q = next[q])
      if (end[q] == f->corners[c]) {
        found++;
        beyond[c] = q;
      }
    if (same != 1 || found != (f->n_faces > 1))
      return GMDS_ERR_ARGUMENT;
  }
  for (size_t v = 0; v < f->n_nodes; v++)
    if (head[v] == GMDS_NONE)
      return GMDS_ERR_ARGUMENT; /* a node on no face */
  return GMDS_OK;
}

/* Joins the trees of a and b in a forest; 1 when they were two. */
static size_t join_trees(gmds_id *parent, gmds_id a, gmds_id b)
{
  while (parent[a] != a)
    a = parent[a] = parent[parent[a]];
  while (parent[b] != b)
    b = parent[b] = parent[parent[b]];
  parent[a] = b;
  return a != b;
}

/* Whether the corners of a frame are one cell, and those at each node one orbit: both are counted by joining trees. */
static int is_one(const gmds_map_frame *f, const gmds_id *beyond, gmds_id *parent)
{
  const size_t n = f->begin[f->n_faces];
  for (int around = 0; around < 2 && f->n_faces > 1; around++) {
    size_t trees = n;
    for (size_t c = 0; c < n; c++)
      parent[c] = (gmds_id)c;
    for (size_t k = 0; k < f->n_faces; k++)
      for (size_t c = f->begin[k]; c < f->begin[k + 1]; c++) {
        const gmds_id next = (gmds_id)(c + 1 < f->begin[k + 1] ? c + 1 : f->begin[k]);
        if (around) /* both begin where c ends */
          trees -= join_trees(parent, next, beyond[c]);
        else
          trees -= join_trees(parent, (gmds_id)c, next) + join_trees(parent, (gmds_id)c, beyond[c]);
      }
    if (trees != (around ? f->n_nodes : 1))
      return 0;
  }
  return 1;
}

/* Writes the darts, which are taken, and the edges and faces. */
static void write_frame(gmds_map *map, const gmds_map_frame *f, const gmds_id *dart, const gmds_id *beyond,
                        const gmds_id *node)
{
  for (size_t k = 0; k < f->n_faces; k++) {
    const size_t from = f->begin[k], to = f->begin[k + 1];
    const gmds_id face = map->slot[2] ? gmds_cells_take(&map->cells[2]) : GMDS_NONE;
    for (size_t c = from; c < to; c++) {
      gmds_id *record = gmds_map_record(map, dart[c]);
      const gmds_id v = node[f->corners[c]];
      for (int i = 2; i < map->stride; i++)
        record[i] = GMDS_NONE;
      record[0] = dart[c > from ? c - 1 : to - 1];
      record[1] = dart[c + 1 < to ? c + 1 : from];
      if (beyond[c] != GMDS_NONE)
        record[2] = dart[beyond[c]];
      record[map->slot[0]] = v;
      if (map->anchor[0][v] == GMDS_NONE)
        map->anchor[0][v] = dart[c];
      if (map->slot[2])
        record[map->slot[2]] = face;
    }
    if (map->slot[2])
      map->anchor[2][face] = dart[from];
  }
  const size_t n = f->begin[f->n_faces];
  for (size_t c = 0; c < n && map->slot[1]; c++) {
    const int known = beyond[c] < c;
    const gmds_id e = known ? gmds_map_cell(map, 1, dart[beyond[c]]) : gmds_cells_take(&map->cells[1]);
    gmds_map_record(map, dart[c])[map->slot[1]] = e;
    if (!known)
      map->anchor[1][e] = dart[c];
  }
  if (!map->slot[3])
    return;
  const gmds_id r = gmds_cells_take(&map->cells[3]);
  map->anchor[3][r] = dart[0];
  for (size_t c = 0; c < n; c++)
    gmds_map_record(map, dart[c])[map->slot[3]] = r;
}

/* beyond, dart, node and room lie in `work`, in this order. */
static gmds_status fill_frame(gmds_map *map, const gmds_map_frame *f, const double *x, const gmds_id *nodes,
                              gmds_id *work, gmds_id *d)
{
  const size_t n = f->begin[f->n_faces];
  gmds_id *beyond = work, *dart = beyond + n, *node = dart + n, *room = node + f->n_nodes;
  GMDS_TRY(pair_corners(f, room, beyond));
  if (!is_one(f, beyond, room))
    return GMDS_ERR_ARGUMENT;
  if (nodes)
    GMDS_TRY(check_nodes(map, f->n_nodes, nodes));
  const size_t edges = f->n_faces > 1 ? n / 2 : n;
  const making k = {.map = map, .n_darts = n, .n_nodes = f->n_nodes, .n_edges = edges, .n_faces = f->n_faces};
  GMDS_TRY(make_room(&k, nodes != NULL));
  take(&map->darts, n, dart);
  if (nodes)
    memcpy(node, nodes, f->n_nodes * sizeof *nodes);
  else {
    take(&map->cells[0], f->n_nodes, node);
    place_points(map, f->n_nodes, node, x);
    for (size_t v = 0; v < f->n_nodes; v++)
      map->anchor[0][node[v]] = GMDS_NONE;
  }
  write_frame(map, f, dart, beyond, node);
  *d = dart[0];
  return GMDS_OK;
}

gmds_status gmds_map_make_frame(gmds_map *map, const gmds_map_frame *f, const double *x, const gmds_id *nodes,
                                gmds_id *d)
{
  void *work = NULL;
  if (!f->n_faces || (f->n_faces > 1 && (map->n < 3 || f->n_faces < 3)))
    return GMDS_ERR_ARGUMENT;
  for (size_t k = 0; k < f->n_faces; k++)
    if (f->begin[k + 1] < f->begin[k] || f->begin[0])
      return GMDS_ERR_ARGUMENT;
  const size_t n = f->begin[f->n_faces], room = 4 * n + 2 * f->n_nodes;
  if (!gmds_resize(&map->memory, &work, 0, room, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_status status = fill_frame(map, f, x, nodes, work, d);
  gmds_release(&map->memory, work, room, sizeof(gmds_id));
  return status;
}

gmds_status gmds_map_make_polygon(gmds_map *map, size_t n, const double *x, const gmds_id *nodes, gmds_id *d)
{
  gmds_id few[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  void *corners = NULL;
  const size_t begin[2] = {0, n};
  if (n < 3)
    return GMDS_ERR_ARGUMENT;
  if (n > 8 && !gmds_resize(&map->memory, &corners, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  for (size_t k = 0; k < n && corners; k++)
    ((gmds_id *)corners)[k] = (gmds_id)k;
  const gmds_map_frame frame = {n, 1, begin, corners ? corners : few};
  gmds_status status = gmds_map_make_frame(map, &frame, x, nodes, d);
  gmds_release(&map->memory, corners, corners ? n : 0, sizeof(gmds_id));
  return status;
}

/* Two darts on both sides of an edge whose ends lead into each other: a polygon of two sides, folded. */
gmds_status gmds_map_make_edge(gmds_map *map, const double *x, gmds_id *d)
{
  const size_t dim = (size_t)map->coordinates;
  gmds_id a = GMDS_NONE, b = GMDS_NONE;
  edit e;
  edit_begin(&e, map);
  gmds_status status = edit_make(&e, &a);
  if (status == GMDS_OK)
    status = edit_make(&e, &b);
  if (status == GMDS_OK)
    status = edit_join(&e, 1, a, b);
  if (status == GMDS_OK)
    status = edit_join(&e, 1, b, a);
  if (status == GMDS_OK)
    status = edit_join(&e, 2, a, b);
  status = edit_end(&e, status);
  if (status != GMDS_OK)
    return status;
  for (int k = 0; k < 2 && x; k++)
    memcpy(map->points + dim * gmds_map_cell(map, 0, k ? b : a), x + dim * (size_t)k, dim * sizeof *x);
  *d = a;
  return GMDS_OK;
}
