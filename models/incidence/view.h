/* Views: the rows of stored relations where they lie. */

#if GMDS_VIEW(0, 0)
static inline const gmds_id *view_0_0(const mesh *m, gmds_id v, size_t *n)
{
  return gmds_rows_get(&m->r_0_0, v, n);
}
#endif

#if GMDS_VIEW(0, 1)
static inline const gmds_id *view_0_1(const mesh *m, gmds_id v, size_t *n)
{
  return gmds_rows_get(&m->r_0_1, v, n);
}
#endif

#if GMDS_VIEW(0, 2)
static inline const gmds_id *view_0_2(const mesh *m, gmds_id v, size_t *n)
{
  return gmds_rows_get(&m->r_0_2, v, n);
}
#endif

#if GMDS_VIEW(1, 0)
static inline const gmds_id *view_1_0(const mesh *m, gmds_id e, size_t *n)
{
  *n = 2;
  return m->r_1_0.data + 2 * (size_t)e;
}
#endif

#if GMDS_VIEW(1, 1)
static inline const gmds_id *view_1_1(const mesh *m, gmds_id e, size_t *n)
{
  return gmds_rows_get(&m->r_1_1, e, n);
}
#endif

#if GMDS_VIEW(1, 2)
static inline const gmds_id *view_1_2(const mesh *m, gmds_id e, size_t *n)
{
  return gmds_pairs_get(&m->r_1_2, e, n);
}
#endif

#if GMDS_VIEW(2, 0)
static inline const gmds_id *view_2_0(const mesh *m, gmds_id f, size_t *n)
{
  return row_2_0(m, f, n);
}
#endif

#if GMDS_VIEW(2, 1)
static inline const gmds_id *view_2_1(const mesh *m, gmds_id f, size_t *n)
{
  return row_2_1(m, f, n);
}
#endif
