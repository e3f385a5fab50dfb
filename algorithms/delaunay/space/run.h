/* The triangulation from its first tetrahedron to its last. */

/* The first four nodes that are not in one plane, positively oriented: the value is 0 when there are none. */
static inline int first_four(const mesh *m, gmds_id v[4])
{
  const gmds_id n = (gmds_id)count_0(m);
  gmds_id c = 2, d = 3;
  int turn = 0;
  while (c < n && !gmds_coplanar_orientation(point(m, 0), point(m, 1), point(m, c)))
    c++;
  for (d = c + 1; c < n && d < n && !turn; d++)
    turn = gmds_orient3d(point(m, 0), point(m, 1), point(m, c), point(m, d));
  v[0] = turn < 0;
  v[1] = turn > 0;
  v[2] = c;
  v[3] = d - 1;
  return turn;
}

/* The first tetrahedron and the four infinite ones around it. */
static inline gmds_status begin_with(insertion *in, unsigned threads, const gmds_id v[4])
{
  mesh *m = in->m;
  const size_t n = count_0(m), numbered = n + 1 + (threads > 1 ? GMDS__OF_GHOST * (size_t)threads : 0);
  const double nowhere[3] = {NAN, NAN, NAN}; /* no filter decides anything by the ghost's coordinates */
  void *local = NULL;
  GMDS_TRY(reserve(m, n + 1, 0, 0, 7 * n + 8)); /* of uniform points a node has 6.8 tetrahedra */
  GMDS_TRY(add_node(m, nowhere, &in->ghost));
  gmds_id r = 0, g = 0;
  GMDS_TRY(add_tetrahedron(m, v[0], v[1], v[2], v[3], &r));
  for (int k = 0; k < 4; k++)
    GMDS_TRY(add_tetrahedron(m, v[face_nodes[k][0]], v[face_nodes[k][1]], v[face_nodes[k][2]], in->ghost, &g));
  if (!gmds_resize(mesh_memory(m), &local, 0, numbered, sizeof *in->local))
    return GMDS_ERR_MEMORY;
  in->local = local;
  in->numbered = numbered;
  memset(in->local, 0, numbered * sizeof *in->local);
  in->base = 1;
  GMDS_TRY(reserve_marks(in, 7 * n + 8));
  GMDS_TRY(reserve_cavity(in, 64));
  in->last = candidate_of(r, v);
  return GMDS_OK;
}

static inline gmds_status insert_all(insertion *in, unsigned threads, const gmds_delaunay_options *options)
{
  enum { EVERY = 4096 };
  const size_t n = count_0(in->m);
  gmds_id first[4];
  if (n < 4 || !first_four(in->m, first))
    return GMDS_OK;
  GMDS_TRY(begin_with(in, threads, first));
  const size_t alone = threads > 1 ? first_part(n, threads) : n;
  for (gmds_id v = 2; v < alone; v++) {
    if (v % EVERY == 0 && options && options->progress && options->progress(options->user, v, n))
      return GMDS_ERR_CANCELLED;
    if (v != first[2] && v != first[3])
      GMDS_TRY(insert_alone(in, v));
  }
#if GMDS_CONCURRENT_STARS
  if (alone < n)
    GMDS_TRY(insert_by_threads(threads, in, (gmds_id)alone, first + 2, options));
#endif
  return GMDS_OK;
}

static inline void clear_insertion(insertion *in)
{
  gmds_memory *memory = mesh_memory(in->m);
  const size_t n = in->capacity;
  gmds_release(memory, in->cavity, n, sizeof *in->cavity);
  gmds_release(memory, in->tested, n, 4 * sizeof *in->tested);
  gmds_release(memory, in->walls, n, 4 * sizeof *in->walls);
  gmds_release(memory, in->sides, n, 4 * sizeof *in->sides);
  gmds_release(memory, in->ids, n, 4 * sizeof *in->ids);
  gmds_ids_clear(&in->near);
  gmds_ids_clear(&in->nodes);
}

/* Triangulates the nodes of a mesh that has no regions. */
static inline gmds_status triangulate_nodes(mesh *m, const gmds_delaunay_options *options, size_t *steps)
{
  gmds_memory *memory = mesh_memory(m);
  const unsigned threads = threads_for(count_0(m), options);
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, threads, sizeof(insertion)))
    return GMDS_ERR_MEMORY;
  insertion *in = block;
  for (unsigned t = 0; t < threads; t++) {
    in[t] = (insertion){.m = m, .ghost = GMDS_NONE};
    gmds_ids_init(&in[t].near, memory);
    gmds_ids_init(&in[t].nodes, memory);
  }
  gmds_status status = insert_all(in, threads, options);
  const gmds_id ghost = in->ghost;
  gmds_release(memory, in->marks, in->marked, sizeof *in->marks);
  gmds_release(memory, in->local, in->numbered, sizeof *in->local);
  *steps = 0;
  for (unsigned t = 0; t < threads; t++) {
    *steps += in[t].steps;
    clear_insertion(&in[t]);
  }
  gmds_release(memory, block, threads, sizeof(insertion));
  if (status == GMDS_OK && ghost != GMDS_NONE)
    status = remove_node(m, ghost, GMDS_CASCADE);
  return status;
}

/* What the points are when they span no volume. */
static inline gmds_status finish_flat(mesh *m, gmds_delaunay_result *result)
{
  const size_t n = count_0(m);
  gmds_id c = 2;
  while (c < n && !gmds_coplanar_orientation(point(m, 0), point(m, 1), point(m, c)))
    c++;
  result->dimension = n < 2 ? (int)n - 1 : c >= n ? 1 : 2;
  if (result->dimension == 2)
    return gmds_delaunay_planar(n, coordinates(m), result);
  return result->dimension >= 0 ? sort_chain(m, result) : GMDS_OK;
}

static inline gmds_status delaunay(mesh *m, size_t n, const double *xyz, const gmds_delaunay_options *options,
                                   gmds_delaunay_result *result)
{
  gmds_error *error = options ? options->error : NULL;
  void *order = NULL;
  if (result && !result->memory.allocator.resize) /* zero-initialised */
    gmds_delaunay_result_init(result, NULL);
  if (result)
    gmds_delaunay_result_clear(result);
  if (count_0(m) || count_1(m) || count_2(m) || count_3(m))
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be triangulated is not empty");
  gmds_status status = gmds_predicates_check();
  if (status != GMDS_OK)
    return gmds_fail(error, status, "%s", gmds_status_text(status));
  if (n && !gmds_resize(mesh_memory(m), &order, 0, n, sizeof(gmds_id)))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the order of %zu points", n);
  status = place_nodes(m, threads_for(n, options), n, xyz, error, result, order);
  if (status == GMDS_OK && result && number_nodes(m, order, result) != GMDS_OK)
    status = gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the nodes of %zu points", n);
  gmds_release(mesh_memory(m), order, order ? n : 0, sizeof(gmds_id));
  const size_t nodes = count_0(m);
  if (status == GMDS_OK) {
    size_t steps = 0;
    status = triangulate_nodes(m, options, &steps);
    if (status == GMDS_OK)
      status = compact(m, NULL);
    if (status == GMDS_OK)
      status = trim(m);
    if (status == GMDS_OK && result) {
      result->steps = steps;
      result->dimension = 3;
      if (!count_3(m))
        status = finish_flat(m, result);
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
