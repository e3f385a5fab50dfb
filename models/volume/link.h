/* Carrying a plan out: nothing fails any more. */

static inline void link_edge(mesh *m, gmds_id e, gmds_id a, gmds_id b)
{
  (void)m;
  (void)e;
  (void)a;
  (void)b;
#if GMDS__S_1_0
  m->r_1_0.data[2 * (size_t)e] = a;
  m->r_1_0.data[2 * (size_t)e + 1] = b;
#endif
#if GMDS__S_0_1
  gmds_rows_push(&m->r_0_1, a, e);
  gmds_rows_push(&m->r_0_1, b, e);
#endif
}

/* Writes entry k of a row that is inline or grows at its end. */
#if GMDS__INLINE
#  define GMDS__PUT_2(j, c, k, x) m->r_2_##j.data[GMDS__ARITY_2_##j * (size_t)(c) + (k)] = x
#else
#  define GMDS__PUT_2(j, c, k, x) gmds_rows_push(&m->r_2_##j, c, x)
#endif
#if GMDS__CORNERS
#  define GMDS__PUT_3(j, c, k, x) m->r_3_##j.data[GMDS__ARITY_3_##j * (size_t)(c) + (k)] = x
#else
#  define GMDS__PUT_3(j, c, k, x) gmds_rows_push(&m->r_3_##j, c, x)
#endif

static inline void link_face(mesh *m, const cell_plan *p, size_t k)
{
  const gmds_id f = p->face[k], *corner = p->corner + p->begin[k], *border = p->border + p->begin[k];
  const size_t n = p->begin[k + 1] - p->begin[k];
  (void)m;
  (void)f;
  (void)corner;
  (void)border;
  for (size_t i = 0; i < n; i++) {
#if GMDS__S_2_0
    GMDS__PUT_2(0, f, i, corner[i]);
#endif
#if GMDS__S_2_1
    GMDS__PUT_2(1, f, i, p->edge[border[i]]);
#endif
#if GMDS__S_0_2
    gmds_rows_push(&m->r_0_2, corner[i], f);
#endif
#if GMDS__S_1_2
    gmds_rows_push(&m->r_1_2, p->edge[border[i]], f);
#endif
  }
}

#if GMDS__S_1_1 || GMDS__S_2_2
/* Makes a cell and its neighbours know each other: those noted at `at`, behind which the next begin. */
static inline size_t link_neighbours(mesh *m, gmds_rows *rows, gmds_id c, size_t at)
{
  const size_t n = m->more.data[at++];
  for (size_t i = 0; i < n; i++) {
    gmds_rows_push(rows, c, m->more.data[at + i]);
    gmds_rows_push(rows, m->more.data[at + i], c);
  }
  return at + n;
}

static inline void link_beside(mesh *m, const cell_plan *p)
{
  size_t at = 0;
#  if GMDS__S_1_1
  for (size_t e = 0; e < p->n_edges; e++) {
    if (!p->fresh[e])
      continue;
    at = link_neighbours(m, &m->r_1_1, p->edge[e], at);
    for (size_t q = 0; q < e; q++)
      if (p->fresh[q] && edges_touch(p, e, q)) {
        gmds_rows_push(&m->r_1_1, p->edge[e], p->edge[q]);
        gmds_rows_push(&m->r_1_1, p->edge[q], p->edge[e]);
      }
  }
#  endif
#  if GMDS__S_2_2
  for (size_t k = 0; k < p->n_faces; k++) {
    if (!p->made[k])
      continue;
    at = link_neighbours(m, &m->r_2_2, p->face[k], at);
    for (size_t q = 0; q < k; q++)
      if (p->made[q] && faces_touch(p, k, q)) {
        gmds_rows_push(&m->r_2_2, p->face[k], p->face[q]);
        gmds_rows_push(&m->r_2_2, p->face[q], p->face[k]);
      }
  }
#  endif
}
#endif

static inline void link_planned(mesh *m, const cell_plan *p)
{
#if GMDS__S_1_1 || GMDS__S_2_2
  link_beside(m, p);
#endif
  for (size_t e = 0; e < p->n_edges; e++) {
    const gmds_id a = p->ends[2 * e], b = p->ends[2 * e + 1];
    (void)a;
    (void)b;
    if (p->fresh[e])
      link_edge(m, p->edge[e], a, b);
#if GMDS__S_0_0
    if (gmds_rows_find(&m->r_0_0, a, b) == GMDS_NONE) {
      gmds_rows_push(&m->r_0_0, a, b);
      gmds_rows_push(&m->r_0_0, b, a);
    }
#endif
  }
  for (size_t k = 0; k < p->n_faces; k++)
    if (p->made[k])
      link_face(m, p, k);
}

static inline void link_region(mesh *m, gmds_id r, gmds_cell_type type, const cell_plan *p)
{
  (void)m;
  (void)r;
  (void)type;
#if GMDS__TYPED
  m->types[r] = (uint8_t)type;
#endif
  for (size_t i = 0; i < p->n_nodes; i++) {
#if GMDS__S_3_0
    GMDS__PUT_3(0, r, i, p->node[i]);
#endif
#if GMDS__S_0_3
    gmds_rows_push(&m->r_0_3, p->node[i], r);
#endif
  }
  for (size_t e = 0; e < p->n_edges; e++) {
#if GMDS__S_3_1
    GMDS__PUT_3(1, r, e, p->edge[e]);
#endif
#if GMDS__S_1_3
    gmds_rows_push(&m->r_1_3, p->edge[e], r);
#endif
  }
  for (size_t k = 0; k < p->n_faces; k++) {
#if GMDS__S_3_2
    GMDS__PUT_3(2, r, k, p->face[k]);
#endif
#if GMDS__S_2_3
    gmds_pairs_push(&m->r_2_3, p->face[k], r);
#endif
#if GMDS__S_3_3
    const gmds_id s = p->beyond[k];
    size_t n = 0;
    GMDS__PUT_3(3, r, k, s != GMDS_NONE && GMDS__CODED ? 4 * s + p->slot[k] : s);
    if (s != GMDS_NONE)
      row_3_3(m, s, &n)[p->slot[k]] = GMDS__CODED ? 4 * r + (gmds_id)k : r;
#endif
  }
}
