/* The triangulation from its first triangle to its last. */

/* The first triangle (nodes 0, 1 and *third, the first that is not on their line) and the three infinite ones around
 * it. *third is GMDS_NONE when all nodes lie on one line. */
static inline gmds_status first_triangle(insertion *in, gmds_id *third)
{
  mesh *m = in->m;
  size_t n = count_0(m);
  int turn = 0;
  gmds_id c = 2;
  for (; c < n && !turn; c++)
    turn = turn_of(point(m, 0), point(m, 1), point(m, c));
  *third = turn ? c - 1 : GMDS_NONE;
  if (!turn)
    return GMDS_OK;
#if GMDS_COORDINATES == 3
  for (gmds_id v = c; v < n; v++)
    if (gmds_orient3d(point(m, 0), point(m, 1), point(m, *third), point(m, v)))
      return GMDS_ERR_COORDINATE;
#endif
  const double nowhere[3] = {NAN, NAN, NAN}; /* no filter decides anything by the ghost's coordinates */
  GMDS_TRY(reserve(m, n + 1, 3 * n, 2 * n));
  GMDS_TRY(add_node(m, nowhere, &in->ghost));
  const gmds_id v[3] = {turn > 0 ? 0 : 1, turn > 0 ? 1 : 0, *third};
  gmds_id f = 0, g = 0;
  GMDS_TRY(add_triangle(m, v[0], v[1], v[2], &f));
  for (int k = 0; k < 3; k++)
    GMDS_TRY(add_triangle(m, v[(k + 1) % 3], v[k], in->ghost, &g));
  in->last = (gmds_cavity_face){f, {v[0], v[1], v[2]}, 0};
#if GMDS_CONCURRENT_STARS
  size_t faces = 2 * (n - 3);
  GMDS_TRY(take_faces(m, faces, &in->fresh.first));
  in->fresh.end = in->fresh.first + (gmds_id)faces;
  return GMDS_OK;
#else
  return GMDS_OK;
#endif
}

static inline gmds_status insert_all(insertion *in, unsigned threads, const gmds_delaunay_options *options)
{
  enum { EVERY = 4096 };
  size_t n = count_0(in->m), alone = n;
  gmds_id third = GMDS_NONE;
  if (n < 3)
    return GMDS_OK;
  GMDS_TRY(first_triangle(in, &third));
  if (third == GMDS_NONE)
    return GMDS_OK;
  if (threads > 1)
    alone = first_part(n, threads);
  for (gmds_id v = 2; v < alone; v++) {
    if (v % EVERY == 0 && options && options->progress && options->progress(options->user, v, n))
      return GMDS_ERR_CANCELLED;
    if (v != third)
      GMDS_TRY(insert_alone(in, v));
  }
#if GMDS_CONCURRENT_STARS
  if (alone < n)
    GMDS_TRY(insert_by_threads(threads, in, (gmds_id)alone, (const gmds_id[2]){third, third}, options));
#endif
  return remove_node(in->m, in->ghost, GMDS_CASCADE);
}

static inline void clear_insertion(insertion *in)
{
  gmds_memory *memory = mesh_memory(in->m);
  size_t faces = in->capacity, sides = faces ? faces + 2 : 0;
  gmds_release(memory, in->faces, faces, sizeof *in->faces);
  gmds_release(memory, in->sides, sides, sizeof *in->sides);
  gmds_release(memory, in->ids, sides, sizeof *in->ids);
  gmds_release(memory, in->pending, faces, sizeof *in->pending);
  gmds_ids_clear(&in->near);
  gmds_ids_clear(&in->nodes);
}

/* Triangulates the nodes of a mesh that has no faces. */
static inline gmds_status triangulate_nodes(mesh *m, const gmds_delaunay_options *options, size_t *steps)
{
  unsigned threads = threads_for(count_0(m), options);
  void *block = NULL;
  if (!gmds_resize(mesh_memory(m), &block, 0, threads, sizeof(insertion)))
    return GMDS_ERR_MEMORY;
  insertion *in = block;
  for (unsigned t = 0; t < threads; t++) {
    in[t] = (insertion){.m = m, .ghost = GMDS_NONE};
    gmds_ids_init(&in[t].near, mesh_memory(m));
    gmds_ids_init(&in[t].nodes, mesh_memory(m));
  }
  gmds_status status = insert_all(in, threads, options);
  *steps = 0;
  for (unsigned t = 0; t < threads; t++) {
    *steps += in[t].steps;
    clear_insertion(&in[t]);
  }
  gmds_release(mesh_memory(m), block, threads, sizeof(insertion));
  return status;
}

static inline gmds_status delaunay(mesh *m, size_t n, const double *xy, const gmds_delaunay_options *options,
                                   gmds_delaunay_result *result)
{
  gmds_error *error = options ? options->error : NULL;
  void *order = NULL;
  if (result && !result->memory.allocator.resize) /* zero-initialised */
    gmds_delaunay_result_init(result, NULL);
  if (result)
    gmds_delaunay_result_clear(result);
  if (count_0(m) || count_1(m) || count_2(m))
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be triangulated is not empty");
  gmds_status status = gmds_predicates_check();
  if (status != GMDS_OK)
    return gmds_fail(error, status, "%s", gmds_status_text(status));
  if (n && !gmds_resize(mesh_memory(m), &order, 0, n, sizeof(gmds_id)))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the order of %zu points", n);
  status = place_nodes(m, threads_for(n, options), n, xy, error, result, order);
  if (status == GMDS_OK && result && number_nodes(m, order, result) != GMDS_OK)
    status = gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the nodes of %zu points", n);
  gmds_release(mesh_memory(m), order, order ? n : 0, sizeof(gmds_id));
  size_t nodes = count_0(m);
  if (status == GMDS_OK) {
    size_t steps = 0;
    status = triangulate_nodes(m, options, &steps);
    if (status == GMDS_OK)
      status = compact(m, NULL);
    if (status == GMDS_OK)
      status = trim(m);
    if (status == GMDS_OK && result) {
      result->steps = steps;
      result->dimension = count_2(m) ? 2 : nodes > 1 ? 1 : (int)nodes - 1;
      if (result->dimension == 0 || result->dimension == 1)
        status = sort_chain(m, result);
    }
    if (status != GMDS_OK)
      gmds_fail(error, status, "%zu points: %s", nodes, gmds_status_text(status));
  }
  if (status != GMDS_OK) {
    empty(m);
    if (result)
      gmds_delaunay_result_clear(result);
  }
  return status;
}
