/* From points to nodes: how many threads, order, duplicates, the map from one to the other, and what is left when all
 * lie on a line. */

/* How many threads work on n points: as many as the options ask for, where the model lets several and each has enough
 * to do. */
static inline unsigned threads_for(size_t n, const gmds_delaunay_options *options)
{
  size_t threads = GMDS_CONCURRENT_STARS && options && options->threads > 1 ? (size_t)options->threads : 1;
  size_t most = n / 4096 < GMDS_MAX_THREADS ? n / 4096 : GMDS_MAX_THREADS;
  return (unsigned)(threads <= most ? threads : most > 1 ? most : 1);
}

/* How many of n points go in before the threads begin: a few rounds of the order. */
static inline size_t first_part(size_t n, unsigned threads)
{
  while (n > 1024 * (size_t)threads)
    n = (n + 7) / 8;
  return n;
}

typedef struct placing {
  mesh *m;
  unsigned threads;
  size_t n;
  const double *xy;
  const gmds_id *order;
} placing;

static inline void place_part(void *work, unsigned t)
{
  const placing *p = work;
  double *x = coordinates(p->m);
  size_t end = GMDS_SHARE(p->n, t + 1, p->threads);
  for (size_t k = GMDS_SHARE(p->n, t, p->threads); k < end; k++) {
    const double *from = p->xy + GMDS_COORDINATES * (size_t)p->order[k];
    for (size_t i = 0; i < GMDS_COORDINATES; i++)
      x[GMDS_COORDINATES * k + i] = from[i] + 0.0; /* -0 becomes +0 */
  }
}

/* Fills an empty mesh with the distinct points as nodes in insertion order, and result->node_of. */
static inline gmds_status place_nodes(mesh *m, unsigned threads, size_t n, const double *xy, gmds_error *error,
                                      gmds_delaunay_result *result, gmds_id *order)
{
  void *same = NULL;
  size_t distinct = 0;
  if (result && n && !gmds_resize(&result->memory, &same, 0, n, sizeof(gmds_id)))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the nodes of %zu points", n);
  if (result) {
    result->node_of = same;
    result->points = n;
  }
  gmds_id first = 0;
#if GMDS_TOP == 3
  gmds_status status = n < GMDS_NONE ? reserve(m, n + 1, 0, 0, 0) : GMDS_ERR_TOO_MANY;
#else
  gmds_status status = n < GMDS_NONE ? reserve(m, n + 1, 0, 0) : GMDS_ERR_TOO_MANY;
#endif
  if (status != GMDS_OK)
    return gmds_fail(error, status, "%zu nodes: %s", n, gmds_status_text(status));
  /* the room for the coordinates serves as working space before they are there */
  void *room = gmds_order_scratch(n) <= GMDS_COORDINATES * sizeof(double) * n ? coordinates(m) : NULL;
  GMDS_TRY(gmds_order_points(mesh_memory(m), room, threads, GMDS_COORDINATES, n, xy, error, order, same, &distinct));
  if (result)
    result->distinct = distinct;
  status = add_nodes(m, distinct, NULL, &first);
  if (status != GMDS_OK)
    return gmds_fail(error, status, "%zu nodes: %s", distinct, gmds_status_text(status));
  placing all = {m, threads, distinct, xy, order};
  gmds_share(threads, place_part, &all);
  return GMDS_OK;
}

/* Turns result->node_of, for each point the index of the one that stands for it, into nodes. Those that stand for
 * themselves are in `order`, node k being order[k]. */
static inline gmds_status number_nodes(mesh *m, const gmds_id *order, gmds_delaunay_result *result)
{
  gmds_bits stands;
  GMDS_TRY(gmds_bits_init(&stands, mesh_memory(m), result->points));
  for (size_t k = 0; k < result->distinct; k++)
    gmds_bits_set(&stands, order[k]);
  for (size_t k = 0; k < result->distinct; k++)
    result->node_of[order[k]] = (gmds_id)k;
  for (size_t i = 0; i < result->points; i++)
    if (!gmds_bits_get(&stands, i))
      result->node_of[i] = result->node_of[result->node_of[i]];
  gmds_bits_clear(&stands);
  return GMDS_OK;
}

/* result->chain: the nodes in lexicographic order, that is, along their line. Heap sort: no worst case, no stack. */
static inline gmds_status sort_chain(const mesh *m, gmds_delaunay_result *result)
{
  size_t n = result->distinct;
  void *block = NULL;
  if (!gmds_resize(&result->memory, &block, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *chain = result->chain = block;
  for (size_t k = 0; k < n; k++)
    chain[k] = (gmds_id)k;
  for (size_t start = n / 2, end = n; end > 1;) {
    if (start > 0)
      start--;
    else {
      gmds_id top = chain[0];
      chain[0] = chain[--end];
      chain[end] = top;
    }
    for (size_t root = start, child; (child = 2 * root + 1) < end; root = child) {
      if (child + 1 < end &&
          gmds_compare_points(GMDS_COORDINATES, point(m, chain[child]), point(m, chain[child + 1])) < 0)
        child++;
      if (gmds_compare_points(GMDS_COORDINATES, point(m, chain[root]), point(m, chain[child])) >= 0)
        break;
      gmds_id swap = chain[root];
      chain[root] = chain[child];
      chain[child] = swap;
    }
  }
  return GMDS_OK;
}
