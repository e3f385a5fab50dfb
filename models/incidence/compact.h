/* Closing the holes that deletions left: the cells with the largest identifiers move into them. */

/* Where the cells that know a face, or an edge, are found from it without a traversal, it moves by itself: the cost is
 * that of the holes. */
#define GMDS__MOVES_FACES                                                            \
  (GMDS__INLINE && (!GMDS__S_0_2 || GMDS__S_2_0) && (!GMDS__S_2_2 || GMDS__CODED) && \
   (!GMDS__S_1_2 || GMDS__S_2_1 || (GMDS__S_2_0 && GMDS__S_0_1)))
#define GMDS__MOVES_EDGES (GMDS__K_1 && !GMDS__S_1_1 && (!GMDS__S_0_1 || GMDS__S_1_0) && (!GMDS__S_2_1 || GMDS__S_1_2))

#if GMDS__MOVES_FACES
static inline void move_face(mesh *m, gmds_id from, gmds_id to)
{
#  define GMDS__MOVE_ROW(i, j)                                                                               \
    memcpy(m->r_##i##_##j.data + GMDS__SIDES * (size_t)to, m->r_##i##_##j.data + GMDS__SIDES * (size_t)from, \
           GMDS__SIDES * sizeof(gmds_id));
  GMDS__EACH_OF_FACES(GMDS__MOVE_ROW)
#  undef GMDS__MOVE_ROW
  for (gmds_id k = 0; k < GMDS__SIDES; k++) {
    size_t n = 0;
    (void)n;
#  if GMDS__S_0_2
    gmds_rows_replace(&m->r_0_2, row_2_0(m, to, &n)[k], from, to);
#  endif
#  if GMDS__S_1_2 && GMDS__S_2_1
    gmds_pairs_replace(&m->r_1_2, row_2_1(m, to, &n)[k], from, to);
#  elif GMDS__S_1_2
    const gmds_id *node = row_2_0(m, to, &n);
    gmds_pairs_replace(&m->r_1_2, find_edge(m, node[k], node[k + 1 < GMDS__SIDES ? k + 1 : 0]), from, to);
#  endif
#  if GMDS__S_2_2
    gmds_id entry = row_2_2(m, to, &n)[k];
    if (entry != GMDS_NONE)
      row_2_2(m, entry >> 2, &n)[entry & 3] = 4 * to + k;
#  endif
  }
  gmds_cells_move(&m->cells[2], from, to);
}
#endif

#if GMDS__MOVES_EDGES
static inline void move_edge(mesh *m, gmds_id from, gmds_id to)
{
  size_t n = 0;
  (void)n;
#  if GMDS__S_1_0
  memcpy(m->r_1_0.data + 2 * (size_t)to, m->r_1_0.data + 2 * (size_t)from, 2 * sizeof(gmds_id));
#    if GMDS__S_0_1
  for (size_t k = 0; k < 2; k++)
    gmds_rows_replace(&m->r_0_1, m->r_1_0.data[2 * (size_t)to + k], from, to);
#    endif
#  endif
#  if GMDS__S_1_2
  gmds_pairs_move(&m->r_1_2, from, to);
#    if GMDS__S_2_1
  const gmds_id *faces = gmds_pairs_get(&m->r_1_2, to, &n);
  for (size_t i = 0; i < n; i++) {
    size_t sides = 0;
    gmds_id *row = row_2_1(m, faces[i], &sides);
    for (size_t k = 0; k < sides; k++)
      row[k] = row[k] == from ? to : row[k];
  }
#    endif
#  endif
  gmds_cells_move(&m->cells[1], from, to);
}
#endif

static inline gmds_status compact(mesh *m, gmds_id *maps[3])
{
  gmds_id *map[3] = {NULL, NULL, NULL};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 3 && status == GMDS_OK; i++) {
    void *block = NULL;
    if (m->cells[i].count == m->cells[i].end || (GMDS__MOVES_FACES && i == 2) || (GMDS__MOVES_EDGES && i == 1))
      continue; /* no hole: identifiers stay */
    if (!gmds_resize(&m->memory, &block, 0, m->cells[i].end, sizeof *map[i]))
      status = GMDS_ERR_MEMORY;
    map[i] = block;
    if (map[i])
      gmds_cells_plan(&m->cells[i], map[i]);
  }
  for (int i = 0; i < 3 && status == GMDS_OK; i++)
    if (maps && maps[i])
      gmds_cells_plan(&m->cells[i], maps[i]);
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
    for (gmds_id v = map[0] ? next_0(m, (gmds_id)m->cells[0].count) : GMDS_NONE; v != GMDS_NONE; v = next_0(m, v + 1))
      memcpy(m->points + GMDS__DIM * (size_t)map[0][v], point(m, v), GMDS__DIM * sizeof *m->points);
  }
  for (int i = 0; i < 3; i++) {
    size_t end = m->cells[i].end;
    if (status == GMDS_OK && map[i])
      gmds_cells_renumber(&m->cells[i], map[i]);
    gmds_release(&m->memory, map[i], map[i] ? end : 0, sizeof *map[i]);
  }
#if GMDS__MOVES_EDGES
  gmds_id hole = 0;
  for (gmds_id e = next_1(m, (gmds_id)count_1(m)); status == GMDS_OK && e != GMDS_NONE; e = next_1(m, e + 1)) {
    hole = (gmds_id)gmds_bits_next_unset(&m->cells[1].alive, hole, e);
    move_edge(m, e, hole);
  }
  if (status == GMDS_OK)
    gmds_cells_close(&m->cells[1]);
#endif
#if GMDS__MOVES_FACES
  gmds_id to = 0;
  for (gmds_id f = next_2(m, (gmds_id)count_2(m)); status == GMDS_OK && f != GMDS_NONE; f = next_2(m, f + 1)) {
    to = (gmds_id)gmds_bits_next_unset(&m->cells[2].alive, to, f);
    move_face(m, f, to);
  }
  if (status == GMDS_OK)
    gmds_cells_close(&m->cells[2]);
#endif
  return status;
}
