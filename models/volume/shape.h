/* Nodes of faces and tetrahedra without a list, and what lies beyond a face. */

#if GMDS_ORDERED_2_0
static inline size_t face_sides(const mesh *m, gmds_id f)
{
  size_t n = 0;
#  if GMDS__S_2_0
  (void)row_2_0(m, f, &n);
#  else
  (void)row_2_1(m, f, &n);
#  endif
  return n;
}
#endif

#if GMDS__HAS_TETRAHEDRA && GMDS_ORDERED_3_0
static inline void tetrahedron_nodes(const mesh *m, gmds_id r, gmds_id v[4])
{
  gmds_id room[GMDS_SHAPE_NODES];
  const gmds_id *corners = corners_of(m, r, room);
  for (int k = 0; k < 4; k++)
    v[k] = corners[k];
}
#endif

#if GMDS_ACROSS
static inline gmds_id across(const mesh *m, gmds_id r, unsigned k, unsigned *arrival)
{
  gmds_id entry = m->r_3_3.data[4 * (size_t)r + k];
  *arrival = entry & 3;
  return entry == GMDS_NONE ? GMDS_NONE : entry >> 2;
}

static inline void across_all(const mesh *m, gmds_id r, gmds_id beyond[4])
{
  memcpy(beyond, m->r_3_3.data + 4 * (size_t)r, 4 * sizeof *beyond);
}
#endif

static inline void prefetch_3(const mesh *m, gmds_id r)
{
  (void)m;
  (void)r;
#if GMDS__S_3_0 && GMDS__CORNERS
  __builtin_prefetch(m->r_3_0.data + GMDS__CORNERS * (size_t)r);
#endif
#if GMDS__S_3_3 && GMDS__CORNERS
  __builtin_prefetch(m->r_3_3.data + GMDS__WALLS * (size_t)r);
#endif
}
