/* Closing the holes that deletions left: the cells with the largest identifiers move into them. */

/* Tetrahedra that only know their nodes and neighbours move by themselves: the cost is that of the holes. */
#define GMDS__MOVES_REGIONS GMDS_CONCURRENT_STARS

#if GMDS__MOVES_REGIONS
static inline void move_region(mesh *m, gmds_id from, gmds_id to)
{
  memcpy(m->r_3_0.data + 4 * (size_t)to, m->r_3_0.data + 4 * (size_t)from, 4 * sizeof(gmds_id));
  for (gmds_id k = 0; k < 4; k++) {
    gmds_id entry = m->r_3_3.data[4 * (size_t)from + k];
    m->r_3_3.data[4 * (size_t)to + k] = entry;
    if (entry != GMDS_NONE)
      m->r_3_3.data[entry] = 4 * to + k;
  }
  gmds_cells_move(&m->cells[3], from, to);
}
#endif

static inline void renumber_relations(mesh *m, gmds_id *const map[4])
{
#define GMDS__RENUMBER_ROWS(i, j) \
  if (map[i] || map[j])           \
    gmds_rows_renumber(&m->r_##i##_##j, m->cells[i].end, map[i], map[j]);
#define GMDS__RENUMBER_PAIRS(i, j) \
  if (map[i] || map[j])            \
    gmds_pairs_renumber(&m->r_##i##_##j, m->cells[i].end, map[i], map[j]);
#define GMDS__RENUMBER_INLINE(i, j)                                                                                   \
  if (map[i] || map[j])                                                                                               \
    gmds_column_renumber(&m->r_##i##_##j, GMDS__ARITY_##i##_##j, &m->cells[i].alive, m->cells[i].end, map[i], map[j], \
                         GMDS__CODED &&i == 3 && j == 3);
  GMDS__EACH_POOLED(GMDS__RENUMBER_ROWS)
  GMDS__EACH_PAIRS(GMDS__RENUMBER_PAIRS)
  GMDS__EACH_INLINE(GMDS__RENUMBER_INLINE)
#undef GMDS__RENUMBER_ROWS
#undef GMDS__RENUMBER_PAIRS
#undef GMDS__RENUMBER_INLINE
  for (gmds_id v = map[0] ? next_0(m, (gmds_id)m->cells[0].count) : GMDS_NONE; v != GMDS_NONE; v = next_0(m, v + 1))
    memcpy(m->points + 3 * (size_t)map[0][v], point(m, v), 3 * sizeof *m->points);
#if GMDS__TYPED
  for (gmds_id r = map[3] ? next_3(m, (gmds_id)m->cells[3].count) : GMDS_NONE; r != GMDS_NONE; r = next_3(m, r + 1))
    m->types[map[3][r]] = m->types[r];
#endif
}

static inline gmds_status compact(mesh *m, gmds_id *maps[4])
{
  gmds_id *map[4] = {NULL, NULL, NULL, NULL};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 4 && status == GMDS_OK; i++) {
    void *block = NULL;
    if (m->cells[i].count == m->cells[i].end || (GMDS__MOVES_REGIONS && i == 3))
      continue; /* no hole: identifiers stay */
    if (!gmds_resize(&m->memory, &block, 0, m->cells[i].end, sizeof *map[i]))
      status = GMDS_ERR_MEMORY;
    map[i] = block;
    if (map[i])
      gmds_cells_plan(&m->cells[i], map[i]);
  }
  for (int i = 0; i < 4 && status == GMDS_OK; i++)
    if (maps && maps[i])
      gmds_cells_plan(&m->cells[i], maps[i]);
  if (status == GMDS_OK)
    renumber_relations(m, map);
  for (int i = 0; i < 4; i++) {
    size_t end = m->cells[i].end;
    if (status == GMDS_OK && map[i])
      gmds_cells_renumber(&m->cells[i], map[i]);
    gmds_release(&m->memory, map[i], map[i] ? end : 0, sizeof *map[i]);
  }
#if GMDS__MOVES_REGIONS
  gmds_id to = 0;
  for (gmds_id r = next_3(m, (gmds_id)count_3(m)); status == GMDS_OK && r != GMDS_NONE; r = next_3(m, r + 1)) {
    to = (gmds_id)gmds_bits_next_unset(&m->cells[3].alive, to, r);
    move_region(m, r, to);
  }
  if (status == GMDS_OK)
    gmds_cells_close(&m->cells[3]);
#endif
  return status;
}
