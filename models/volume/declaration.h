/* What get_adj_a_b, all_adj_a_b and view_a_b are declared as (GMDS__A, GMDS__B), or the sentence that stands in their
 * place: included by interface.h once for each pair of dimensions. */
#define GMDS__AT(x) GMDS__JOIN(x, GMDS__A, GMDS__B)

#if GMDS__AT(GMDS__CAN)
static inline gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
static inline gmds_status GMDS__AT(all_adj)(const mesh *m, gmds_csr *csr);
#elif GMDS__AT(GMDS__PATH)
GMDS__UNDECIDED_AT(GMDS__A, GMDS__B) gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
#elif GMDS__A == 1 && GMDS__B == 1
GMDS__CANNOT(1, 1, "E2N or N2E") gmds_status get_adj_1_1(const mesh *m, gmds_id c, gmds_ids *out);
#else
GMDS__SORRY(GMDS__A, GMDS__B, GMDS__AT(GMDS_PATHS))
gmds_status GMDS__AT(get_adj)(const mesh *m, gmds_id c, gmds_ids *out);
#endif

#if GMDS__AT(GMDS__S) && !(GMDS__A == 3 && GMDS__B == 3)
static inline const gmds_id *GMDS__AT(view)(const mesh *m, gmds_id c, size_t *n);
#elif GMDS__A == 3 && GMDS__B == 3
GMDS__NO_VIEW_3 const gmds_id *view_3_3(const mesh *m, gmds_id c, size_t *n);
#else
GMDS__NOT_STORED_AT(GMDS__A, GMDS__B) const gmds_id *GMDS__AT(view)(const mesh *m, gmds_id c, size_t *n);
#endif

#undef GMDS__AT
#undef GMDS__A
#undef GMDS__B
