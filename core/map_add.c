/* A combinatorial map as a model: faces of 2-maps and regions of 3-maps upon nodes that exist, sewn with what is there;
 * their deletion; the cavity operator of 3-maps. */
#include "map_inside.h"
#include <string.h>

/* A cell that is to be added: its darts by local numbers, their nodes, and the darts that they will be sewn with. */
typedef struct addition {
  gmds_map *map;
  size_t n;                        /* darts */
  const gmds_id *nodes;            /* of the cell */
  const gmds_map_stencil *stencil; /* NULL: a polygon */
  gmds_ids opposite;               /* of each dart, or GMDS_NONE */
  gmds_ids orbit;
} addition;

static size_t next_of(const addition *a, size_t k)
{
  return a->stencil ? a->stencil->next[k] : k + 1 < a->n ? k + 1 : 0;
}

static gmds_id node_at(const addition *a, size_t k)
{
  return a->nodes[a->stencil ? a->stencil->node[k] : k];
}

static gmds_id origin(const gmds_map *map, gmds_id d)
{
  return d == GMDS_NONE ? GMDS_NONE : gmds_map_cell(map, 0, d);
}

/* Whether the border of k, a face of a region or a side, runs along that of x: against it, or (same) the same way. */
static int runs_along(const addition *a, size_t k, gmds_id x, int same)
{
  const gmds_map *map = a->map;
  size_t c = k;
  gmds_id y = x;
  do {
    const gmds_id from = origin(map, y), to = origin(map, gmds_map_next(map, 1, y));
    if (from != node_at(a, same ? c : next_of(a, c)) || to != node_at(a, same ? next_of(a, c) : c))
      return 0;
    c = next_of(a, c);
    y = gmds_map_next(map, same ? 1 : 0, y);
  } while (a->stencil && c != k && y != GMDS_NONE);
  return !a->stencil || (c == k && y == x);
}

/* Finds what the border that begins at dart k will be sewn with. */
static gmds_status find_opposite(addition *a, size_t k)
{
  const gmds_map *map = a->map;
  const int n = map->n;
  gmds_id found = GMDS_NONE;
  int used = 0;
  for (int same = 0; same < 2; same++) {
    const gmds_id at = map->anchor[0][node_at(a, same ? k : next_of(a, k))];
    if (at == GMDS_NONE)
      continue;
    GMDS_TRY(gmds_map_orbit(map, at, GMDS_SAME_ORIGIN, &a->orbit));
    for (size_t q = 0; q < a->orbit.n; q++) {
      const gmds_id x = a->orbit.data[q];
      if (!runs_along(a, k, x, same))
        continue;
      if (same || gmds_map_beta(map, n, x) != GMDS_NONE)
        used = 1;
      else
        found = x;
    }
  }
  if (used)
    return GMDS_ERR_CONFLICT;
  size_t c = k;
  do {
    a->opposite.data[c] = found;
    c = next_of(a, c);
    found = gmds_map_next(map, 0, found);
  } while (a->stencil && c != k);
  return GMDS_OK;
}

/* Finds all of them. A node that has darts must be on a border that is sewn: else it would have two orbits. */
static gmds_status find_neighbours(addition *a, size_t n_nodes)
{
  for (size_t k = 0; k < a->n; k++)
    if (!a->stencil || k == 0 || a->stencil->face[k] != a->stencil->face[k - 1])
      GMDS_TRY(find_opposite(a, k));
  for (size_t v = 0; v < n_nodes; v++) {
    int sewn = a->map->anchor[0][a->nodes[v]] == GMDS_NONE;
    for (size_t k = 0; k < a->n && !sewn; k++)
      sewn = a->opposite.data[k] != GMDS_NONE &&
             (node_at(a, k) == a->nodes[v] || node_at(a, next_of(a, k)) == a->nodes[v]);
    if (!sewn)
      return GMDS_ERR_CONFLICT;
  }
  return GMDS_OK;
}

/* Makes the darts, with links and nodes. */
static gmds_status add_darts(edit *e, addition *a, gmds_id *first)
{
  gmds_map *map = a->map;
  for (size_t k = 0; k < a->n; k++) {
    gmds_id d = GMDS_NONE;
    GMDS_TRY(edit_make(e, &d));
    gmds_map_record(map, d)[map->slot[0]] = node_at(a, k);
  }
  const gmds_id *dart = e->made.data;
  for (size_t k = 0; k < a->n; k++) {
    GMDS_TRY(edit_join(e, 1, dart[k], dart[next_of(a, k)]));
    if (a->stencil)
      GMDS_TRY(edit_join(e, 2, dart[k], dart[a->stencil->beyond[k]]));
    if (a->opposite.data[k] != GMDS_NONE)
      GMDS_TRY(edit_join(e, map->n, dart[k], a->opposite.data[k]));
  }
  *first = dart[0];
  return GMDS_OK;
}

static gmds_status add_cell(addition *a, size_t n_nodes, gmds_id *d)
{
  gmds_map *map = a->map;
  for (size_t k = 0; k < n_nodes; k++) {
    if (!gmds_cells_has(&map->cells[0], a->nodes[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; q < k; q++)
      if (a->nodes[q] == a->nodes[k])
        return GMDS_ERR_ARGUMENT;
  }
  gmds_id first = GMDS_NONE;
  a->opposite.memory = a->orbit.memory = &map->memory;
  gmds_status status = gmds_ids_reserve(&a->opposite, a->n);
  if (status == GMDS_OK)
    status = find_neighbours(a, n_nodes);
  if (status == GMDS_OK) {
    edit e;
    edit_begin(&e, map);
    status = edit_end(&e, add_darts(&e, a, &first));
  }
  gmds_ids_clear(&a->opposite);
  gmds_ids_clear(&a->orbit);
  if (status == GMDS_OK)
    *d = first;
  return status;
}

gmds_status gmds_map_add_face(gmds_map *map, size_t n, const gmds_id *nodes, gmds_id *d)
{
  addition a = {.map = map, .n = n, .nodes = nodes};
  return n < 3 || map->n != 2 ? GMDS_ERR_ARGUMENT : add_cell(&a, n, d);
}

gmds_status gmds_map_add_region(gmds_map *map, gmds_cell_type type, const gmds_id *nodes, gmds_id *d)
{
  const gmds_map_stencil *stencil = gmds_map_stencil_of(type);
  if (!stencil || map->n != 3)
    return GMDS_ERR_ARGUMENT;
  addition a = {.map = map, .n = stencil->darts, .nodes = nodes, .stencil = stencil};
  return add_cell(&a, gmds_shape_of(type)->nodes, d);
}

/* ---- deletion */

gmds_status gmds_map_delete_cells(gmds_map *map, size_t n, const gmds_id *darts, int keep_nodes)
{
  edit e;
  gmds_ids orbit = {.memory = &map->memory};
  gmds_status status = GMDS_OK;
  for (size_t k = 0; k < n; k++)
    if (!gmds_map_has(map, darts[k]))
      return GMDS_ERR_CELL;
  edit_begin(&e, map);
  e.keep_nodes = keep_nodes;
  for (size_t k = 0; k < n && status == GMDS_OK; k++) {
    if (id_table_find(&e.goes, darts[k]))
      continue;
    status = gmds_map_orbit(map, darts[k], gmds_map_cell_betas(map, map->n), &orbit);
    for (size_t q = 0; q < orbit.n && status == GMDS_OK; q++)
      status = edit_drop(&e, orbit.data[q]);
  }
  gmds_ids_clear(&orbit);
  return edit_end(&e, status);
}

gmds_status gmds_map_remove_node(gmds_map *map, gmds_id v, gmds_around around)
{
  if (!gmds_cells_has(&map->cells[0], v))
    return GMDS_ERR_CELL;
  const gmds_id d = map->anchor[0][v];
  if (d != GMDS_NONE) {
    if (around == GMDS_REFUSE)
      return GMDS_ERR_CONFLICT;
    gmds_ids orbit = {.memory = &map->memory};
    gmds_status status = gmds_map_orbit(map, d, GMDS_SAME_ORIGIN, &orbit);
    if (status == GMDS_OK)
      status = gmds_map_delete_cells(map, orbit.n, orbit.data, 1);
    gmds_ids_clear(&orbit);
    if (status != GMDS_OK)
      return status;
  }
  gmds_cells_drop(&map->cells[0], v);
  return GMDS_OK;
}

/* ---- the cavity operator: tetrahedra are 12 darts in the order of their stencil, which are used again as they are
 * linked; only their nodes and what is beyond their faces change. Tetrahedron i has wall i as its face 3 (shapes.h). */

enum { TET = 12 };

/* The darts of the tetrahedron of d, which is the first. */
static void darts_of(const gmds_map *map, gmds_id d, gmds_id dart[TET])
{
  const gmds_map_stencil *s = gmds_map_stencil_of(GMDS_TETRAHEDRON);
  dart[0] = d;
  dart[1] = gmds_map_beta(map, 1, d);
  dart[2] = gmds_map_beta(map, 0, d);
  for (int k = 0; k < 3; k++) {
    const unsigned j = s->beyond[k];
    const gmds_id *record = gmds_map_record(map, dart[k]);
    dart[j] = record[2];
    record = gmds_map_record(map, record[2]);
    dart[s->next[j]] = record[1];
    dart[s->before[j]] = record[0];
  }
}

/* The dart of region `out` on a wall, from its node 0 to its node 1. */
static gmds_id dart_on_wall(const gmds_map *map, const gmds_cavity_wall *w)
{
  gmds_id dart[TET];
  const int node = map->slot[0];
  darts_of(map, map->anchor[3][w->out], dart);
  for (int k = 0; k < TET; k++) {
    const gmds_id *record = gmds_map_record(map, dart[k]);
    if (record[node] == w->node[0] && gmds_map_record(map, record[1])[node] == w->node[1] &&
        gmds_map_record(map, record[0])[node] == w->node[2])
      return dart[k];
  }
  return GMDS_NONE;
}

static void link_faces(gmds_map *map, gmds_id d, gmds_id e)
{
  for (int k = 0; k < 3; k++) {
    gmds_map_record(map, d)[3] = e;
    gmds_map_record(map, e)[3] = d;
    d = gmds_map_beta(map, 1, d);
    e = gmds_map_beta(map, 0, e);
  }
}

/* A fresh tetrahedron, linked in itself. */
static void make_fresh(gmds_map *map, gmds_id dart[TET])
{
  const gmds_map_stencil *s = gmds_map_stencil_of(GMDS_TETRAHEDRON);
  for (int k = 0; k < TET; k++)
    dart[k] = gmds_map_take_dart(map);
  for (int k = 0; k < TET; k++) {
    gmds_id *record = gmds_map_record(map, dart[k]);
    record[0] = dart[s->before[k]];
    record[1] = dart[s->next[k]];
    record[2] = dart[s->beyond[k]];
  }
}

/* Joins wall w to the apex: the nodes, the region, and what is beyond face 3. */
static void write_tetrahedron(gmds_map *map, const gmds_id dart[TET], gmds_id apex, gmds_id region,
                              const gmds_cavity_wall *w, gmds_id outside)
{
  const gmds_map_stencil *s = gmds_map_stencil_of(GMDS_TETRAHEDRON);
  const gmds_id node[4] = {w->node[0], w->node[1], w->node[2], apex};
  for (int k = 0; k < TET; k++) {
    gmds_id *record = gmds_map_record(map, dart[k]);
    record[map->slot[0]] = node[s->node[k]];
    record[map->slot[3]] = region;
    map->anchor[0][node[s->node[k]]] = dart[k];
  }
  map->anchor[3][region] = dart[0];
  link_faces(map, dart[11], outside); /* dart 11 leads from node 1 to node 0 of face 0 2 1 */
}

/* Links what meets at the edges of the walls: around each node what leaves it is met by what comes to it. `room` has
 * space for 3 n_walls + 2 n_nodes + 1 entries; dart has the 12 of each tetrahedron. */
static void link_spokes(gmds_map *map, size_t n_walls, const gmds_cavity_wall *walls, size_t n_nodes,
                        const gmds_id *dart, gmds_id *room)
{
  gmds_id *begin = room, *at_node = begin + n_nodes + 1, *slot = at_node + 3 * n_walls;
  memset(begin, 0, (n_nodes + 1) * sizeof *begin);
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++)
      begin[walls[i].local[k] + 1]++;
  for (size_t v = 0; v < n_nodes; v++)
    begin[v + 1] += begin[v];
  for (size_t i = n_walls; i-- > 0;)
    for (gmds_id k = 0; k < 3; k++)
      at_node[--begin[walls[i].local[k] + 1]] = 4 * (gmds_id)i + k;
  for (size_t v = 0; v < n_nodes; v++) { /* the row of v begins at begin[v + 1] now */
    const size_t first = begin[v + 1], last = v + 1 < n_nodes ? begin[v + 2] : 3 * n_walls;
    for (size_t q = first; q < last; q++) {
      const gmds_id i = at_node[q] >> 2, k = at_node[q] & 3;
      slot[walls[i].local[k < 2 ? k + 1 : 0]] =
          dart[TET * (size_t)i + 3 * k]; /* face k begins with the edge k, k + 1 */
    }
    for (size_t q = first; q < last; q++) {
      const gmds_id i = at_node[q] >> 2, k = at_node[q] & 3, before = k > 0 ? k - 1 : 2;
      link_faces(map, dart[TET * (size_t)i + 3 * before], slot[walls[i].local[before]]);
    }
  }
}

gmds_status gmds_map_star(gmds_map *map, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                          gmds_id *ids)
{
  size_t n_nodes = 0;
  const size_t more = n_walls > n_regions ? n_walls - n_regions : 0, most = n_regions + more;
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++)
      n_nodes = walls[i].local[k] >= n_nodes ? walls[i].local[k] + (size_t)1 : n_nodes;
  GMDS_TRY(gmds_map_grow(map, 3, more));
  GMDS_TRY(gmds_map_grow(map, -1, TET * more));
  GMDS_TRY(gmds_ids_reserve(&map->scratch, TET * most + 4 * n_walls + 2 * n_nodes + 1));
  gmds_id *dart = map->scratch.data, *outside = dart + TET * most, *room = outside + n_walls;
  for (size_t i = 0; i < n_walls; i++) {
    outside[i] = dart_on_wall(map, &walls[i]);
    if (outside[i] == GMDS_NONE)
      return GMDS_ERR_INVARIANT;
  }
  for (size_t i = 0; i < n_regions; i++)
    darts_of(map, map->anchor[3][ids[i]], dart + TET * i);
  for (size_t i = n_regions; i < n_walls; i++) {
    ids[i] = gmds_cells_take(&map->cells[3]);
    make_fresh(map, dart + TET * i);
  }
  for (size_t i = 0; i < n_walls; i++)
    write_tetrahedron(map, dart + TET * i, apex, ids[i], &walls[i], outside[i]);
  link_spokes(map, n_walls, walls, n_nodes, dart, room);
  for (size_t i = n_walls; i < n_regions; i++) {
    for (size_t k = 0; k < TET; k++)
      gmds_cells_drop(&map->darts, dart[TET * i + k]);
    gmds_cells_drop(&map->cells[3], ids[i]);
  }
  return GMDS_OK;
}
