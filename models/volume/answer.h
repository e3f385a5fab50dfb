/* get_adj_a_b, view_a_b and all_adj_a_b (GMDS__A, GMDS__B): included once for each pair of dimensions. */
#define GMDS__AT(x) GMDS__JOIN(x, GMDS__A, GMDS__B)

#if GMDS__AT(GMDS__CAN)
static inline gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out)
{
  gmds_status status = begin_answer(&m->cells[GMDS__A], c, out);
  if (status != GMDS_OK)
    return status;
#  if GMDS__A == 2 && GMDS__B == 0 && GMDS_ORDERED_2_0 && !GMDS__S_2_0
  size_t n = 0;
  const gmds_id *edges = row_2_1(m, c, &n);
  GMDS_TRY(gmds_ids_reserve(out, n));
  chain_of_face(edges, m->r_1_0.data, n, out->data);
  out->n = n;
  return GMDS_OK;
#  elif GMDS__A == 3 && GMDS__B == 0 && GMDS_ORDERED_3_0 && !GMDS__S_3_0
  GMDS_TRY(gmds_ids_reserve(out, GMDS_SHAPE_NODES));
  (void)corners_of(m, c, out->data);
  out->n = gmds_shape_of(region_type(m, c))->nodes;
  return GMDS_OK;
#  elif GMDS__A == 3 && GMDS__B == 3 && GMDS__S_3_3
  size_t n = 0;
  const gmds_id *row = row_3_3(m, c, &n);
  GMDS_TRY(gmds_ids_reserve(out, n));
  out->n = 0;
  for (size_t k = 0; k < n; k++)
    if (row[k] != GMDS_NONE && !gmds_ids_has(out, region_of(row[k])))
      out->data[out->n++] = region_of(row[k]);
  return GMDS_OK;
#  else
  size_t first = 0;
  switch (GMDS__AT(GMDS__ROW)) {
    GMDS__AT(GMDS_PATHS)(GMDS__ROW1, GMDS__ROW2, GMDS__ROW3, GMDS__ROW4)
  }
  return status == GMDS_OK ? end_answer(out, first) : status;
#  endif
}
#endif

#if GMDS__AT(GMDS__S) && !(GMDS__A == 3 && GMDS__B == 3)
static inline const gmds_id *GMDS__AT(view)(const mesh *m, gmds_id c, size_t *n)
{
  return GMDS__AT(row)(m, c, n);
}
#endif

#if GMDS__AT(GMDS__CAN)
static inline gmds_status GMDS__AT(all_adj)(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, GMDS__A, GMDS__B, GMDS__AT(get_adj), csr);
}
#endif

#undef GMDS__AT
#undef GMDS__A
#undef GMDS__B
