/* The cavity operator: the tetrahedra of a cavity are replaced by those that join its walls to a node. What a
 * Bowyer-Watson insertion does, in one operation; old identifiers are used again. Tetrahedron i has wall i as its face
 * 3, and on faces 0, 1, 2 the edges of the wall from node 0 to 1, 1 to 2 and 2 to 0. */

#if GMDS_STARS

/* Where nothing is kept of edges and faces, the rows of the regions and of their nodes are all that changes. */
#  define GMDS__STARS_OF_REGIONS (GMDS__TETRAHEDRA && GMDS__S_3_0 && !GMDS__K_1 && !GMDS__K_2)

/* Boundaries of so many nodes are linked by a table over pairs of them. */
#  define GMDS__STAR_WIDTH 64

#  if GMDS__STARS_OF_REGIONS && GMDS__S_3_3
/* Joins wall w to the apex. */
static inline void write_tetrahedron(gmds_id *nodes, gmds_id *beyond, gmds_id apex, const gmds_cavity_wall *w,
                                     gmds_id face)
{
  const gmds_id out = 4 * w->out + w->out_side;
  gmds_id *row = nodes + (size_t)face;
  row[0] = w->node[0];
  row[1] = w->node[1];
  row[2] = w->node[2];
  row[3] = apex;
  beyond[(size_t)face + 3] = out;
  beyond[out] = face + 3;
}

/* Writes the star, and links it: a directed edge leads to the face on it, its reverse asks for it. */
static inline void write_small_star(mesh *m, gmds_id apex, size_t n_walls, const gmds_cavity_wall *walls,
                                    const gmds_id *ids)
{
  gmds_id table[GMDS__STAR_WIDTH * GMDS__STAR_WIDTH];
  gmds_id *const nodes = m->r_3_0.data, *const beyond = m->r_3_3.data;
  for (size_t i = 0; i < n_walls; i++) {
    const gmds_cavity_wall w = walls[i];
    const gmds_id face = 4 * ids[i];
    write_tetrahedron(nodes, beyond, apex, &w, face);
    table[w.local[0] * GMDS__STAR_WIDTH + w.local[1]] = face;
    table[w.local[1] * GMDS__STAR_WIDTH + w.local[2]] = face + 1;
    table[w.local[2] * GMDS__STAR_WIDTH + w.local[0]] = face + 2;
  }
  for (size_t i = 0; i < n_walls; i++) {
    const unsigned *l = walls[i].local;
    gmds_id *row = beyond + 4 * (size_t)ids[i];
    row[0] = table[l[1] * GMDS__STAR_WIDTH + l[0]];
    row[1] = table[l[2] * GMDS__STAR_WIDTH + l[1]];
    row[2] = table[l[0] * GMDS__STAR_WIDTH + l[2]];
  }
}

/* The same for any number of nodes: around each node what leaves it is met by what comes to it. `room` has space for
 * 3 n_walls + 2 n_nodes + 1 entries. */
static inline void link_around_nodes(mesh *m, size_t n_walls, const gmds_cavity_wall *walls, size_t n_nodes,
                                     const gmds_id *ids, gmds_id *room)
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
      slot[walls[i].local[k < 2 ? k + 1 : 0]] = 4 * ids[i] + k; /* face k has the edge from node k to the next */
    }
    for (size_t q = first; q < last; q++) {
      const gmds_id i = at_node[q] >> 2, k = at_node[q] & 3, before = k > 0 ? k - 1 : 2;
      m->r_3_3.data[4 * (size_t)ids[i] + before] = slot[walls[i].local[before]];
    }
  }
}
#  endif

#  if GMDS__STARS_OF_REGIONS
/* Room for what the rows of nodes get. `room` has space for an entry a node of the boundary. */
static inline gmds_status reserve_star(mesh *m, gmds_id apex, size_t n_walls, const gmds_cavity_wall *walls,
                                       size_t n_nodes, gmds_id *room)
{
  (void)m;
  (void)apex;
  (void)n_walls;
  (void)walls;
  (void)n_nodes;
  (void)room;
#    if GMDS__S_0_3
  memset(room, 0, n_nodes * sizeof *room);
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++)
      room[walls[i].local[k]]++;
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++) {
      const gmds_id v = walls[i].node[k];
      GMDS_TRY(gmds_rows_reserve(&m->r_0_3, &m->memory, v, m->r_0_3.length[v] + (size_t)room[walls[i].local[k]]));
    }
  GMDS_TRY(gmds_rows_reserve(&m->r_0_3, &m->memory, apex, n_walls));
#    endif
#    if GMDS__S_0_0
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++) {
      const gmds_id v = walls[i].node[k];
      GMDS_TRY(gmds_rows_reserve(&m->r_0_0, &m->memory, v, m->r_0_0.length[v] + (size_t)1));
    }
  GMDS_TRY(gmds_rows_reserve(&m->r_0_0, &m->memory, apex, n_nodes));
#    endif
  return GMDS_OK;
}

#    if GMDS__S_0_0
/* Puts a pair of nodes into a table of mask + 1 pairs; whether it was not there. */
static inline int enter_pair(gmds_id *table, size_t mask, gmds_id a, gmds_id b)
{
  const gmds_id low = a < b ? a : b, high = a < b ? b : a;
  size_t h = (size_t)(((uint64_t)low << 32 | high) * 0x9e3779b97f4a7c15u >> 32) & mask;
  while (table[2 * h] != GMDS_NONE && (table[2 * h] != low || table[2 * h + 1] != high))
    h = (h + 1) & mask;
  const int is_new = table[2 * h] == GMDS_NONE;
  table[2 * h] = low;
  table[2 * h + 1] = high;
  return is_new;
}

/* Parts the nodes that only edges inside the cavity joined, and joins those of its boundary to the apex. */
static inline void join_star(mesh *m, gmds_id apex, size_t n_regions, const gmds_id *regions, size_t n_walls,
                             const gmds_cavity_wall *walls, gmds_id *table, size_t mask)
{
  memset(table, 0xff, 2 * (mask + 1) * sizeof *table);
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 3; k++) {
      const gmds_id v = walls[i].node[k];
      (void)enter_pair(table, mask, v, walls[i].node[k < 2 ? k + 1 : 0]);
      if (enter_pair(table, mask, v, apex)) {
        gmds_rows_push(&m->r_0_0, v, apex);
        gmds_rows_push(&m->r_0_0, apex, v);
      }
    }
  for (size_t i = 0; i < n_regions; i++) {
    const gmds_id *v = m->r_3_0.data + 4 * (size_t)regions[i];
    for (int k = 0; k < 3; k++)
      for (int l = k + 1; l < 4; l++)
        if (enter_pair(table, mask, v[k], v[l]))
          unjoin(m, v[k], v[l]);
  }
}
#    endif

/* How many pairs of nodes the table of a star has room for: a power of two. */
static inline size_t pairs_of_star(size_t n_regions, size_t n_walls)
{
  size_t n = 1;
  while (GMDS__S_0_0 && n < 2 * (6 * n_regions + 2 * n_walls + 4))
    n *= 2;
  return n;
}

static inline void write_star(mesh *m, gmds_id apex, size_t n_walls, const gmds_cavity_wall *walls, size_t n_nodes,
                              const gmds_id *ids, gmds_id *room)
{
#    if GMDS__S_3_3
  if (n_nodes <= GMDS__STAR_WIDTH) {
    write_small_star(m, apex, n_walls, walls, ids);
    return;
  }
  for (size_t i = 0; i < n_walls; i++)
    write_tetrahedron(m->r_3_0.data, m->r_3_3.data, apex, &walls[i], 4 * ids[i]);
  link_around_nodes(m, n_walls, walls, n_nodes, ids, room);
#    else
  (void)n_nodes;
  (void)room;
  for (size_t i = 0; i < n_walls; i++) {
    gmds_id *row = m->r_3_0.data + 4 * (size_t)ids[i];
    memcpy(row, walls[i].node, sizeof walls[i].node);
    row[3] = apex;
  }
#    endif
}

static inline gmds_status star(mesh *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                               gmds_id *ids)
{
  const size_t n_nodes = n_walls / 2 + 2, pairs = pairs_of_star(n_regions, n_walls);
  if (n_walls > n_regions)
    GMDS_TRY(grow(m, 3, n_walls - n_regions));
  if (!GMDS_CONCURRENT_STARS || n_nodes > GMDS__STAR_WIDTH)
    GMDS_TRY(gmds_ids_reserve(&m->plan, 3 * n_walls + 2 * n_nodes + 1 + 2 * pairs));
  GMDS_TRY(reserve_star(m, apex, n_walls, walls, n_nodes, m->plan.data));
#    if GMDS__S_0_0
  join_star(m, apex, n_regions, ids, n_walls, walls, m->plan.data, pairs - 1);
#    endif
#    if GMDS__S_0_3
  for (size_t i = 0; i < n_regions; i++)
    for (int k = 0; k < 4; k++)
      gmds_rows_remove(&m->r_0_3, m->r_3_0.data[4 * (size_t)ids[i] + (size_t)k], ids[i]);
#    endif
  for (size_t i = n_regions; i < n_walls; i++)
    ids[i] = gmds_cells_take(&m->cells[3]);
  write_star(m, apex, n_walls, walls, n_nodes, ids, m->plan.data);
#    if GMDS__S_0_3
  for (size_t i = 0; i < n_walls; i++)
    for (int k = 0; k < 4; k++)
      gmds_rows_push(&m->r_0_3, m->r_3_0.data[4 * (size_t)ids[i] + (size_t)k], ids[i]);
#    endif
  for (size_t i = n_walls; i < n_regions; i++)
    gmds_cells_drop(&m->cells[3], ids[i]);
  return GMDS_OK;
}

#    if GMDS_CONCURRENT_STARS
_Static_assert(GMDS_STAR_OF_WALLS / 2 + 2 <= GMDS__STAR_WIDTH, "a star of several threads needs no room of the mesh");

static inline size_t take_regions(mesh *m, size_t n, gmds_id *first)
{
  const gmds_cells *cells = &m->cells[3];
  const size_t room = (cells->capacity < cells->limit ? cells->capacity : cells->limit) - cells->end;
  n = n < room ? n : room;
  *first = gmds_cells_take_many(&m->cells[3], n);
  return n;
}

static inline void drop_regions(mesh *m, gmds_id first, size_t n)
{
  for (size_t k = n; k-- > 0;)
    gmds_cells_drop(&m->cells[3], first + (gmds_id)k);
}

static inline void star_of(mesh *m, gmds_id apex, size_t n_walls, const gmds_cavity_wall *walls, const gmds_id *ids)
{
  write_small_star(m, apex, n_walls, walls, ids);
}
#    endif
#  else
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                               gmds_id *ids)
{
  const gmds_ids list = {.data = ids, .n = n_regions};
  GMDS_TRY(forget_regions(m, &list, GMDS_DROP_BARE));
  for (size_t i = 0; i < n_walls; i++)
    GMDS_TRY(add_tetrahedron(m, walls[i].node[0], walls[i].node[1], walls[i].node[2], apex, &ids[i]));
  return GMDS_OK;
}
#  endif
#endif
