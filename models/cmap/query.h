/* A map as a model: queries by orbits, and the sides of faces. */

#include <gmds/models/cmap/queries.h>

#if GMDS__K_2
static inline size_t face_sides(const mesh *m, gmds_id f)
{
  const gmds_id first = dart_of(m, 2, f);
  size_t n = 0;
  gmds_id d = first;
  do {
    n++;
    d = beta(m, 1, d);
  } while (d != first && d != GMDS_NONE);
  return n;
}

/* The dart on side k of a face. */
static inline gmds_id side_dart(const mesh *m, gmds_id f, size_t k)
{
  gmds_id d = dart_of(m, 2, f);
  while (k--)
    d = beta(m, 1, d);
  return d;
}

static inline gmds_id face_node(const mesh *m, gmds_id f, size_t k)
{
  return m->map.records[(size_t)side_dart(m, f, k) * GMDS__STRIDE + GMDS__SLOT_0];
}

static inline void triangle_nodes(const mesh *m, gmds_id f, gmds_id v[3])
{
  for (size_t k = 0; k < 3; k++)
    v[k] = face_node(m, f, k);
}

static inline gmds_status prepare_2_0(const mesh *m, gmds_csr *csr)
{
  return gmds_map_all_adjacent(&m->map, 2, 0, csr);
}

static inline const gmds_id *read_2_0(const mesh *m, const gmds_csr *csr, gmds_id f, size_t *n)
{
  (void)m;
  *n = csr->begin[f + 1] - csr->begin[f];
  return *n ? csr->data + csr->begin[f] : NULL;
}

static inline gmds_status prepare_0_2(const mesh *m, gmds_csr *csr)
{
  return gmds_map_all_adjacent(&m->map, 0, 2, csr);
}

static inline const gmds_id *read_0_2(const mesh *m, const gmds_csr *csr, gmds_id v, size_t *n)
{
  (void)m;
  *n = csr->begin[v + 1] - csr->begin[v];
  return *n ? csr->data + csr->begin[v] : NULL;
}

static inline gmds_status all_edges(const mesh *m, gmds_edge_table *table)
{
  gmds_csr nodes;
  gmds_csr_init(&nodes, table->memory);
  GMDS_TRY(prepare_2_0(m, &nodes));
  gmds_status status = gmds_edges_of_rows(end_0(m), nodes.n, nodes.begin, nodes.data, table);
  gmds_csr_clear(&nodes);
  return status;
}
#endif

#if GMDS_ACROSS
static inline gmds_id face_beside(const mesh *m, gmds_id f, size_t k)
{
  const gmds_id d = beta(m, 2, side_dart(m, f, k));
  return d == GMDS_NONE ? GMDS_NONE : m->map.records[(size_t)d * GMDS__STRIDE + GMDS__SLOT_2];
}

static inline gmds_id across(const mesh *m, gmds_id f, unsigned k, unsigned *arrival)
{
  const gmds_id d = beta(m, 2, side_dart(m, f, k));
  unsigned at = 0;
  if (d == GMDS_NONE)
    return GMDS_NONE;
  const gmds_id g = m->map.records[(size_t)d * GMDS__STRIDE + GMDS__SLOT_2];
  for (gmds_id e = dart_of(m, 2, g); e != d; e = beta(m, 1, e))
    at++;
  *arrival = at;
  return g;
}
#endif

static inline void prefetch_3(const mesh *m, gmds_id r)
{
#if GMDS__K_3
  __builtin_prefetch(m->map.anchor[3] + r);
#else
  (void)m;
  (void)r;
#endif
}
