/* Links and orbits. */

static inline gmds_id beta(const mesh *m, int i, gmds_id d)
{
  return m->map.records[(size_t)d * GMDS__STRIDE + (size_t)i];
}

static inline int is_free(const mesh *m, int i, gmds_id d)
{
  return beta(m, i, d) == GMDS_NONE;
}

static inline gmds_id cell_of(const mesh *m, int i, gmds_id d)
{
  return gmds_map_cell(&m->map, i, d);
}

static inline gmds_id dart_of(const mesh *m, int i, gmds_id c)
{
  return m->map.anchor[i][c];
}

static inline gmds_status orbit(const mesh *m, gmds_id d, unsigned betas, gmds_ids *list)
{
  if (!has_dart(m, d))
    return GMDS_ERR_CELL;
  if (betas != GMDS_SAME_ORIGIN && betas >> (GMDS__N + 1))
    return GMDS_ERR_ARGUMENT;
  return gmds_map_orbit(&m->map, d, betas, list);
}

static inline gmds_status cell_darts(const mesh *m, int i, gmds_id d, gmds_ids *list)
{
  return i < 0 || i > GMDS__N ? GMDS_ERR_ARGUMENT : orbit(m, d, gmds_map_cell_betas(&m->map, i), list);
}
