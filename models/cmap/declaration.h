/* What get_adj_a_b and all_adj_a_b are declared as (GMDS__A, GMDS__B), or the sentence that stands in their place:
 * included by interface.h once for each pair of dimensions. */
#define GMDS__AT(x) GMDS__JOIN(x, GMDS__A, GMDS__B)
#define GMDS__HAS(i) GMDS__HAS_(i)
#define GMDS__HAS_(i) GMDS__K_##i
#define GMDS__SORRY(missing) GMDS__SORRY_(GMDS__A, GMDS__B, missing)
#define GMDS__SORRY_(i, j, missing) GMDS__NOT_KEPT(i, j, missing)

#if GMDS__HAS(GMDS__A) && GMDS__HAS(GMDS__B)
static inline gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
static inline gmds_status GMDS__AT(all_adj)(const mesh *m, gmds_csr *csr);
#elif !GMDS__HAS(GMDS__A)
GMDS__SORRY(GMDS__KEEP(GMDS__A)) gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
#else
GMDS__SORRY(GMDS__KEEP(GMDS__B)) gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
#endif

#undef GMDS__AT
#undef GMDS__HAS
#undef GMDS__HAS_
#undef GMDS__SORRY
#undef GMDS__SORRY_
#undef GMDS__A
#undef GMDS__B
