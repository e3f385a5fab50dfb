/* Insertion, removal, contraction, closing. */

static inline gmds_status insert_vertex_in_edge(mesh *m, gmds_id d, const double *x, gmds_id *made)
{
  return gmds_map_insert_vertex_in_edge(&m->map, d, x, made);
}

static inline gmds_status insert_vertex_in_face(mesh *m, gmds_id d, const double *x, gmds_id *made)
{
  return gmds_map_insert_vertex_in_face(&m->map, d, x, made);
}

static inline gmds_status insert_edge_in_face(mesh *m, gmds_id d, gmds_id e, gmds_id *made)
{
  return gmds_map_insert_edge_in_face(&m->map, d, e, made);
}

static inline gmds_status insert_dangling_edge(mesh *m, gmds_id d, const double *x, gmds_id *made)
{
  return gmds_map_insert_dangling_edge(&m->map, d, x, made);
}

#if GMDS__N == 3
static inline gmds_status insert_face_in_volume(mesh *m, size_t n, const gmds_id *path, gmds_id *made)
{
  return gmds_map_insert_face_in_volume(&m->map, n, path, made);
}
#endif

static inline gmds_status is_removable(const mesh *m, int i, gmds_id d, gmds_memory *memory, int *removable)
{
  return gmds_map_is_removable(&m->map, i, d, memory, removable);
}

static inline gmds_status remove_cell(mesh *m, int i, gmds_id d)
{
  return gmds_map_remove_cell(&m->map, i, d);
}

static inline gmds_status is_contractible(const mesh *m, int i, gmds_id d, gmds_memory *memory, int *contractible)
{
  return gmds_map_is_contractible(&m->map, i, d, memory, contractible);
}

static inline gmds_status contract_cell(mesh *m, int i, gmds_id d)
{
  return gmds_map_contract_cell(&m->map, i, d);
}

static inline gmds_status close(mesh *m, int i, size_t *made)
{
  return gmds_map_close(&m->map, i, made);
}
