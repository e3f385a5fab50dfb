/* Closing the holes that deletions left. */

static inline gmds_status compact(mesh *m, gmds_id *maps[3])
{
  gmds_id *map[3] = {NULL, NULL, NULL};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 3 && status == GMDS_OK; i++) {
    void *block = NULL;
    if (m->cells[i].count == m->cells[i].end)
      continue; /* no hole: identifiers stay */
    if (!gmds_resize(&m->memory, &block, 0, m->cells[i].end, sizeof *map[i]))
      status = GMDS_ERR_MEMORY;
    map[i] = block;
    gmds_id fresh = 0;
    for (size_t c = 0; map[i] && c < m->cells[i].end; c++)
      map[i][c] = gmds_cells_has(&m->cells[i], (gmds_id)c) ? fresh++ : GMDS_NONE;
  }
  if (status == GMDS_OK) {
#define GMDS__RENUMBER_ROWS(i, j) \
  if (map[i] || map[j])           \
    gmds_rows_renumber(&m->r_##i##_##j, m->cells[i].end, map[i], map[j]);
#define GMDS__RENUMBER_PAIRS(i, j) \
  if (map[i] || map[j])            \
    gmds_pairs_renumber(&m->r_##i##_##j, m->cells[i].end, map[i], map[j]);
#define GMDS__RENUMBER_INLINE(i, j)                                                                             \
  if (map[i] || map[j])                                                                                         \
    gmds_column_renumber(&m->r_##i##_##j, GMDS__ARITY_##i, &m->cells[i].alive, m->cells[i].end, map[i], map[j], \
                         GMDS__CODED &&i == 2 && j == 2);
    GMDS__EACH_POOLED(GMDS__RENUMBER_ROWS)
    GMDS__EACH_PAIRS(GMDS__RENUMBER_PAIRS)
    GMDS__EACH_INLINE(GMDS__RENUMBER_INLINE)
#undef GMDS__RENUMBER_ROWS
#undef GMDS__RENUMBER_PAIRS
#undef GMDS__RENUMBER_INLINE
    for (gmds_id v = next_0(m, 0); map[0] && v != GMDS_NONE; v = next_0(m, v + 1))
      if (map[0][v] != v)
        memcpy(m->points + GMDS__DIM * (size_t)map[0][v], point(m, v), GMDS__DIM * sizeof *m->points);
  }
  for (int i = 0; i < 3; i++) {
    size_t end = m->cells[i].end;
    for (size_t c = 0; status == GMDS_OK && maps && maps[i] && c < end; c++)
      maps[i][c] = map[i] ? map[i][c] : (gmds_id)c;
    if (status == GMDS_OK && map[i])
      gmds_cells_renumber(&m->cells[i], map[i]);
    gmds_release(&m->memory, map[i], map[i] ? end : 0, sizeof *map[i]);
  }
  return status;
}
