/* The check of a mesh: every stored relation is handed, as it is stored, to check_volume.h, which holds it against the
 * nodes of the cells. */

static inline gmds_status check_relations(const mesh *m, gmds_stored_relations *all, gmds_memory *memory,
                                          gmds_error *error)
{
#define GMDS__COPY(i, j) GMDS_TRY(copy_stored(m, i, j, &all->relation[i][j]));
  GMDS__EACH_POOLED(GMDS__COPY)
  GMDS__EACH_PAIRS(GMDS__COPY)
  GMDS__EACH_INLINE(GMDS__COPY)
#undef GMDS__COPY
  GMDS_TRY(gmds_check_entries(all, memory, error));
#if GMDS_LISTS_CELLS
  gmds_complex complex;
  gmds_complex_init(&complex, memory, end_0(m));
  gmds_status status = to_complex(m, &complex);
  if (status == GMDS_ERR_INVARIANT)
    gmds_fail(error, status, "the faces of a region do not make a region of its type");
  if (status == GMDS_OK)
    status = gmds_check_complex(all, &complex, error);
  gmds_complex_clear(&complex);
  return status;
#else
  return gmds_check_inverses(all, memory, error);
#endif
}

static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error)
{
  gmds_stored_relations all = {.mask = GMDS__MASK,
                               .keeps_edges = GMDS__MAKES_EDGES,
                               .keeps_faces = GMDS__MAKES_FACES,
                               .sides = GMDS_ORDERED_2_0,
                               .local = GMDS__S_3_0 && !GMDS__POLYHEDRA,
                               .aligned = GMDS_ORDERED_3_0};
  for (int i = 0; i < 4; i++) {
    all.end[i] = m->cells[i].end;
    all.alive[i] = &m->cells[i].alive;
    for (int j = 0; j < 4; j++)
      gmds_csr_init(&all.relation[i][j], memory);
  }
  gmds_status status = check_relations(m, &all, memory, error);
#if GMDS__CODED
  for (gmds_id r = next_3(m, 0); status == GMDS_OK && r != GMDS_NONE; r = next_3(m, r + 1))
    for (gmds_id k = 0; status == GMDS_OK && k < 4; k++) {
      const gmds_id entry = m->r_3_3.data[4 * (size_t)r + k];
      if (entry != GMDS_NONE && m->r_3_3.data[entry] != 4 * r + k)
        status = gmds_fail(error, GMDS_ERR_INVARIANT,
                           "R2R: face %lu of region %lu leads to face %lu of region %lu, which does not lead back",
                           (unsigned long)k, (unsigned long)r, (unsigned long)(entry & 3), (unsigned long)(entry >> 2));
    }
#endif
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++)
      gmds_csr_clear(&all.relation[i][j]);
  if (status == GMDS_ERR_MEMORY)
    gmds_fail(error, status, "out of memory while checking");
  return status;
}
