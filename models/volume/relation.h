/* What is done with the relation from a-cells to b-cells (GMDS__A, GMDS__B): included once for each pair of dimensions.
 *
 * hop_a_b    from the cells list[first .. last) append those they are linked with: along the relation where it is
 *            stored, else by a traversal of its inverse (the extended model of [models] 2.3.1), unless that is lent for
 *            a query of the whole mesh
 * meet_a_b   append those that at least `times` of these cells are linked with, once each
 * row_a_b    the entries of one cell, where they are stored */
#define GMDS__AT(x) GMDS__JOIN(x, GMDS__A, GMDS__B)
#define GMDS__BACK(x) GMDS__JOIN(x, GMDS__B, GMDS__A)

#if GMDS__AT(GMDS__S)
static inline gmds_id *GMDS__AT(row)(const mesh *m, gmds_id c, size_t *n)
{
#  if GMDS__AT(GMDS__KIND) == 1
  return gmds_rows_get(&m->GMDS__AT(r), c, n);
#  elif GMDS__AT(GMDS__KIND) == 2
  return gmds_pairs_get(&m->GMDS__AT(r), c, n);
#  else
  *n = GMDS__AT(GMDS__ARITY);
  return m->GMDS__AT(r).data + GMDS__AT(GMDS__ARITY) * (size_t)c;
#  endif
}
#endif

static inline gmds_status GMDS__AT(hop)(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#if GMDS__AT(GMDS__S)
#  if GMDS__AT(GMDS__KIND) == 1
  return gmds_hop_rows(&m->GMDS__AT(r), list, first, last);
#  elif GMDS__AT(GMDS__KIND) == 2
  return gmds_hop_pairs(&m->GMDS__AT(r), list, first, last);
#  else
  return gmds_hop_inline(m->GMDS__AT(r).data, GMDS__AT(GMDS__ARITY), list, first, last);
#  endif
#elif GMDS__BACK(GMDS__S)
  const gmds_csr *lent = &m->borrowed[GMDS__A][GMDS__B];
  if (lent->begin)
    return gmds_hop_csr(lent, list, first, last);
#  if GMDS__BACK(GMDS__KIND) == 1
  return gmds_scan_rows(&m->GMDS__BACK(r), m->cells[GMDS__B].end, list, first, last);
#  elif GMDS__BACK(GMDS__KIND) == 2
  return gmds_scan_pairs(&m->GMDS__BACK(r), m->cells[GMDS__B].end, list, first, last);
#  else
  return gmds_scan_inline(m->GMDS__BACK(r).data, GMDS__BACK(GMDS__ARITY), &m->cells[GMDS__B].alive,
                          m->cells[GMDS__B].end, list, first, last);
#  endif
#else
  (void)m;
  (void)list;
  (void)first;
  (void)last;
  return GMDS_ERR_UNSUPPORTED;
#endif
}

static inline gmds_status GMDS__AT(meet)(const mesh *m, gmds_ids *list, size_t first, size_t last, size_t times)
{
#if GMDS__AT(GMDS__S) && GMDS__AT(GMDS__KIND) == 1
  return gmds_rows_meet(&m->GMDS__AT(r), first, last, times, list);
#else
#  if !GMDS__AT(GMDS__S) && GMDS__BACK(GMDS__S) && GMDS__BACK(GMDS__KIND) == 1
  if (!m->borrowed[GMDS__A][GMDS__B].begin)
    return gmds_scan_meet_rows(&m->GMDS__BACK(r), m->cells[GMDS__B].end, list, first, last, times);
#  elif !GMDS__AT(GMDS__S) && GMDS__BACK(GMDS__S) && GMDS__BACK(GMDS__KIND) == 3
  if (!m->borrowed[GMDS__A][GMDS__B].begin)
    return gmds_scan_meet_inline(m->GMDS__BACK(r).data, GMDS__BACK(GMDS__ARITY), &m->cells[GMDS__B].alive,
                                 m->cells[GMDS__B].end, list, first, last, times);
#  endif
  size_t from = list->n;
  GMDS_TRY(GMDS__AT(hop)(m, list, first, last));
  gmds_ids_keep(list, from, times, GMDS_NONE);
  return GMDS_OK;
#endif
}

#undef GMDS__AT
#undef GMDS__BACK
#undef GMDS__A
#undef GMDS__B
