/* Reading 2 -> 0 and 0 -> 2 of a whole mesh: where the relation is stored, in place; else from a csr that is built
 * once. */

#if GMDS__CAN_2_0
static inline gmds_status prepare_2_0(const mesh *m, gmds_csr *csr)
{
#  if GMDS__S_2_0
  (void)m;
  (void)csr;
  return GMDS_OK;
#  else
  return all_adj_2_0(m, csr);
#  endif
}

static inline const gmds_id *read_2_0(const mesh *m, const gmds_csr *csr, gmds_id f, size_t *n)
{
#  if GMDS__S_2_0
  (void)csr;
  return row_2_0(m, f, n);
#  else
  (void)m;
  *n = csr->begin[f + 1] - csr->begin[f];
  return csr->data + csr->begin[f];
#  endif
}
#endif

#if GMDS__CAN_0_2
static inline gmds_status prepare_0_2(const mesh *m, gmds_csr *csr)
{
#  if GMDS__S_0_2
  (void)m;
  (void)csr;
  return GMDS_OK;
#  else
  return all_adj_0_2(m, csr);
#  endif
}

static inline const gmds_id *read_0_2(const mesh *m, const gmds_csr *csr, gmds_id v, size_t *n)
{
#  if GMDS__S_0_2
  (void)csr;
  return gmds_rows_get(&m->r_0_2, v, n);
#  else
  (void)m;
  *n = csr->begin[v + 1] - csr->begin[v];
  return *n ? csr->data + csr->begin[v] : NULL;
#  endif
}
#endif
