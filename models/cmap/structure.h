/* The structure of a map: what all dimensions share (map.h), and what is known of it at compile time. */

struct mesh {
  gmds_map map; /* map.memory counts everything; do not move the structure while it is in use */
};

static inline gmds_status mesh_init(mesh *m, const gmds_allocator *allocator)
{
  gmds_map_init(&m->map, GMDS__N, GMDS__DIM, GMDS__MASK, allocator);
  return GMDS_OK;
}

static inline void mesh_clear(mesh *m)
{
  gmds_map_clear(&m->map);
}

static inline void empty(mesh *m)
{
  gmds_map_empty(&m->map);
}

#if GMDS__N == 2
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces)
{
  const size_t cells[GMDS_MAP_KEPT] = {nodes, edges, faces, 0};
  return faces > SIZE_MAX / 3 ? GMDS_ERR_TOO_MANY : gmds_map_reserve(&m->map, 3 * faces, cells);
}
#else
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces, size_t regions)
{
  const size_t cells[GMDS_MAP_KEPT] = {nodes, edges, faces, regions};
  return regions > SIZE_MAX / 12 ? GMDS_ERR_TOO_MANY : gmds_map_reserve(&m->map, 12 * regions, cells);
}
#endif

static inline gmds_status reserve_darts(mesh *m, size_t darts)
{
  const size_t cells[GMDS_MAP_KEPT] = {0, 0, 0, 0};
  return gmds_map_reserve(&m->map, darts, cells);
}

static inline gmds_status trim(mesh *m)
{
  return gmds_map_trim(&m->map);
}

static inline gmds_status compact_darts(mesh *m, gmds_id **maps, gmds_id *dart_map)
{
  gmds_id *all[GMDS_MAP_KEPT] = {NULL, NULL, NULL, NULL};
  for (int i = 0; i <= GMDS_TOP && maps; i++)
    all[i] = maps[i];
  return gmds_map_compact(&m->map, all, dart_map);
}

static inline gmds_status compact(mesh *m, gmds_id **maps)
{
  return compact_darts(m, maps, NULL);
}

static inline gmds_status permute(mesh *m, gmds_id *const *maps)
{
  gmds_id *all[GMDS_MAP_KEPT] = {NULL, NULL, NULL, NULL};
  for (int i = 0; i <= GMDS_TOP; i++)
    all[i] = maps[i];
  return gmds_map_permute(&m->map, all);
}

static inline gmds_memory *mesh_memory(mesh *m)
{
  return &m->map.memory;
}

static inline size_t bytes_per_dart(void)
{
  return GMDS__STRIDE * sizeof(gmds_id);
}

static inline size_t count_darts(const mesh *m)
{
  return m->map.darts.count;
}

static inline int has_dart(const mesh *m, gmds_id d)
{
  return gmds_cells_has(&m->map.darts, d);
}

static inline gmds_id next_dart(const mesh *m, gmds_id d)
{
  return gmds_cells_next(&m->map.darts, d);
}

static inline size_t end_darts(const mesh *m)
{
  return m->map.darts.end;
}

static inline size_t count_0(const mesh *m)
{
  return m->map.cells[0].count;
}

static inline int has_0(const mesh *m, gmds_id v)
{
  return gmds_cells_has(&m->map.cells[0], v);
}

static inline gmds_id next_0(const mesh *m, gmds_id v)
{
  return gmds_cells_next(&m->map.cells[0], v);
}

static inline size_t end_0(const mesh *m)
{
  return m->map.cells[0].end;
}

static inline size_t count_1(const mesh *m)
{
  return m->map.cells[1].count;
}

static inline int has_1(const mesh *m, gmds_id e)
{
  return gmds_cells_has(&m->map.cells[1], e);
}

static inline gmds_id next_1(const mesh *m, gmds_id e)
{
  return gmds_cells_next(&m->map.cells[1], e);
}

static inline size_t end_1(const mesh *m)
{
  return m->map.cells[1].end;
}

static inline size_t count_2(const mesh *m)
{
  return m->map.cells[2].count;
}

static inline int has_2(const mesh *m, gmds_id f)
{
  return gmds_cells_has(&m->map.cells[2], f);
}

static inline gmds_id next_2(const mesh *m, gmds_id f)
{
  return gmds_cells_next(&m->map.cells[2], f);
}

static inline size_t end_2(const mesh *m)
{
  return m->map.cells[2].end;
}

static inline size_t count_3(const mesh *m)
{
  return m->map.cells[3].count;
}

static inline int has_3(const mesh *m, gmds_id r)
{
  return gmds_cells_has(&m->map.cells[3], r);
}

static inline gmds_id next_3(const mesh *m, gmds_id r)
{
  return gmds_cells_next(&m->map.cells[3], r);
}

static inline size_t end_3(const mesh *m)
{
  return m->map.cells[3].end;
}

static inline gmds_status count_cells(const mesh *m, int i, gmds_memory *memory, size_t *count)
{
  if (i < 0 || i > GMDS__N)
    return GMDS_ERR_ARGUMENT;
  return gmds_map_count_orbits(&m->map, gmds_map_cell_betas(&m->map, i), memory, count);
}

static inline const double *point(const mesh *m, gmds_id v)
{
  return m->map.points + GMDS__DIM * (size_t)v;
}

static inline void set_point(mesh *m, gmds_id v, const double *x)
{
  memcpy(m->map.points + GMDS__DIM * (size_t)v, x, GMDS__DIM * sizeof *x);
}

static inline double *coordinates(mesh *m)
{
  return m->map.points;
}

static inline gmds_status add_attribute(mesh *m, int i, const char *name, gmds_value type, size_t components,
                                        gmds_attribute **attribute)
{
  if (i < 0 || i >= GMDS_MAP_KEPT || !m->map.slot[i])
    return GMDS_ERR_ARGUMENT;
  return gmds_attribute_add(&m->map.cells[i], name, type, components, attribute);
}

static inline gmds_attribute *find_attribute(const mesh *m, int i, const char *name)
{
  return i < 0 || i >= GMDS_MAP_KEPT ? NULL : gmds_attribute_find(&m->map.cells[i], name);
}

static inline void remove_attribute(mesh *m, int i, gmds_attribute *attribute)
{
  if (i >= 0 && i < GMDS_MAP_KEPT)
    gmds_map_remove_attribute(&m->map, i, attribute);
}

static inline gmds_status on_change(mesh *m, int i, const gmds_attribute *attribute, gmds_merge merge, gmds_split split,
                                    void *user)
{
  return gmds_map_set_rule(&m->map, i, attribute, merge, split, user);
}
