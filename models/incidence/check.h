/* The check of a mesh: every stored relation is handed, as it is stored, to gmds_check_relations, which holds each
 * against all the others. */

static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error)
{
  gmds_relations all = {.mask = GMDS__MASK,
                        .triangles = GMDS__SIMPLICIAL,
                        .ordered = GMDS_ORDERED_2_0,
                        .aligned = GMDS_ORDERED_2_0 && GMDS__S_2_2};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 3; i++) {
    all.end[i] = m->cells[i].end;
    all.alive[i] = &m->cells[i].alive;
    for (int j = 0; j < 3; j++)
      gmds_csr_init(&all.relation[i][j], memory);
  }
#define GMDS__COPY_ROWS(i, j) \
  if (status == GMDS_OK)      \
    status = gmds_copy_rows(&m->r_##i##_##j, m->cells[i].end, &all.relation[i][j]);
#define GMDS__COPY_PAIRS(i, j) \
  if (status == GMDS_OK)       \
    status = gmds_copy_pairs(&m->r_##i##_##j, m->cells[i].end, &all.relation[i][j]);
#define GMDS__COPY_INLINE(i, j)                                                                          \
  if (status == GMDS_OK)                                                                                 \
    status = gmds_copy_inline(m->r_##i##_##j.data, GMDS__ARITY_##i, &m->cells[i].alive, m->cells[i].end, \
                              GMDS__CODED && i == 2 && j == 2 ? 2 : 0, &all.relation[i][j]);
  GMDS__EACH_POOLED(GMDS__COPY_ROWS)
  GMDS__EACH_PAIRS(GMDS__COPY_PAIRS)
  GMDS__EACH_INLINE(GMDS__COPY_INLINE)
#undef GMDS__COPY_ROWS
#undef GMDS__COPY_PAIRS
#undef GMDS__COPY_INLINE
  if (status == GMDS_OK)
    status = gmds_check_relations(&all, memory, error);
  else
    gmds_fail(error, status, "out of memory while checking");
#if GMDS__CODED
  for (gmds_id f = next_2(m, 0); status == GMDS_OK && f != GMDS_NONE; f = next_2(m, f + 1))
    for (unsigned k = 0; status == GMDS_OK && k < GMDS__SIDES; k++) {
      size_t n = 0;
      gmds_id entry = row_2_2(m, f, &n)[k];
      if (entry != GMDS_NONE && ((entry & 3) >= GMDS__SIDES || row_2_2(m, entry >> 2, &n)[entry & 3] != 4 * f + k))
        status = gmds_fail(error, GMDS_ERR_INVARIANT,
                           "F2F: side %u of face %lu leads to side %u of face %lu, which does not lead back", k,
                           (unsigned long)f, (unsigned)(entry & 3), (unsigned long)(entry >> 2));
    }
#endif
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      gmds_csr_clear(&all.relation[i][j]);
  return status;
}
