/* get_adj_a_b and all_adj_a_b (GMDS__A, GMDS__B): included once for each pair of dimensions. */
#define GMDS__AT(x) GMDS__JOIN(x, GMDS__A, GMDS__B)
#define GMDS__HAS(i) GMDS__HAS_(i)
#define GMDS__HAS_(i) GMDS__K_##i

#if GMDS__HAS(GMDS__A) && GMDS__HAS(GMDS__B)
static inline gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out)
{
  return gmds_map_adjacent(&m->map, GMDS__A, GMDS__B, c, out);
}

static inline gmds_status GMDS__AT(all_adj)(const mesh *m, gmds_csr *csr)
{
  return gmds_map_all_adjacent(&m->map, GMDS__A, GMDS__B, csr);
}
#endif

#undef GMDS__AT
#undef GMDS__HAS
#undef GMDS__HAS_
#undef GMDS__A
#undef GMDS__B
