/* Darts, links and sewing. */

static inline gmds_status add_dart(mesh *m, gmds_id *d)
{
  return gmds_map_add_dart(&m->map, d);
}

static inline gmds_status remove_dart(mesh *m, gmds_id d)
{
  return gmds_map_remove_dart(&m->map, d);
}

static inline gmds_status link(mesh *m, int i, gmds_id d, gmds_id e)
{
  return gmds_map_link(&m->map, i, d, e);
}

static inline gmds_status unlink(mesh *m, int i, gmds_id d)
{
  return gmds_map_unlink(&m->map, i, d);
}

static inline gmds_status restore_cells(mesh *m)
{
  return gmds_map_restore_cells(&m->map);
}

static inline gmds_status is_sewable(const mesh *m, int i, gmds_id d, gmds_id e, gmds_memory *memory, int *sewable)
{
  return gmds_map_is_sewable(&m->map, i, d, e, memory, sewable);
}

static inline gmds_status sew(mesh *m, int i, gmds_id d, gmds_id e)
{
  return gmds_map_sew(&m->map, i, d, e);
}

static inline gmds_status unsew(mesh *m, int i, gmds_id d)
{
  return gmds_map_unsew(&m->map, i, d);
}
