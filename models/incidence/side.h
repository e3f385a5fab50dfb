/* Sides: side k of a face joins its nodes k and k + 1, in models that keep the order (GMDS_ORDERED_2_0). */

/* How many sides a face has. */
#if GMDS__INLINE
static inline size_t face_sides(const mesh *m, gmds_id f)
{
  (void)m;
  (void)f;
  return GMDS__SIDES;
}
#elif GMDS__S_2_0 || GMDS__S_2_1 || GMDS__S_2_2
static inline size_t face_sides(const mesh *m, gmds_id f)
{
#  if GMDS__S_2_0
  return m->r_2_0.length[f];
#  elif GMDS__S_2_1
  return m->r_2_1.length[f];
#  else
  return m->r_2_2.length[f];
#  endif
}
#endif

#if GMDS__S_2_2
static inline gmds_id face_beside(const mesh *m, gmds_id f, size_t k)
{
  size_t n = 0;
  return face_of(row_2_2(m, f, &n)[k]);
}
#endif

#if GMDS_ORDERED_2_0
/* Node k of face f. */
static inline gmds_id face_node(const mesh *m, gmds_id f, size_t k)
{
  size_t n = 0;
#  if GMDS__S_2_0
  return row_2_0(m, f, &n)[k];
#  else
  const gmds_id *edges = row_2_1(m, f, &n);
  const gmds_id *a = m->r_1_0.data + 2 * (size_t)edges[(k + n - 1) % n];
  const gmds_id *b = m->r_1_0.data + 2 * (size_t)edges[k];
  return a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
#  endif
}

/* The number of the side of face f between nodes a and b, in either direction, or GMDS_NONE. */
static inline gmds_id find_side(const mesh *m, gmds_id f, gmds_id a, gmds_id b)
{
  size_t n = face_sides(m, f);
  for (size_t k = 0; k < n; k++) {
    gmds_id p = face_node(m, f, k), q = face_node(m, f, k + 1 < n ? k + 1 : 0);
    if ((p == a && q == b) || (p == b && q == a))
      return (gmds_id)k;
  }
  return GMDS_NONE;
}

static inline void triangle_nodes(const mesh *m, gmds_id f, gmds_id v[3])
{
#  if GMDS__S_2_0
  size_t n = 0;
  const gmds_id *row = row_2_0(m, f, &n);
  v[0] = row[0];
  v[1] = row[1];
  v[2] = row[2];
#  else
  for (size_t k = 0; k < 3; k++)
    v[k] = face_node(m, f, k);
#  endif
}
#endif
