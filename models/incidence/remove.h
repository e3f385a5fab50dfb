/* Deletion. What a face is linked with is gathered first, by the queries of the model (which may run out of memory);
 * then everything that names the face forgets it, which cannot fail. */

#if GMDS__MAKES_EDGES
/* Unlinks edge e from its nodes ends[0], ends[1] (GMDS_NONE where the model does not say) and frees it. */
static inline void unlink_edge(mesh *m, gmds_id e, const gmds_id ends[2])
{
  (void)ends;
#  if GMDS__S_0_1
  for (int k = 0; k < 2; k++)
    if (ends[k] != GMDS_NONE)
      gmds_rows_remove(&m->r_0_1, ends[k], e);
#  endif
#  if GMDS__S_1_1
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(&m->r_1_1, e, &n);
  for (size_t k = 0; k < n; k++)
    gmds_rows_remove(&m->r_1_1, row[k], e);
#  endif
  drop_edge(m, e);
}
#endif

#if GMDS__S_0_0
static inline void unjoin(mesh *m, gmds_id a, gmds_id b)
{
  gmds_rows_remove(&m->r_0_0, a, b);
  gmds_rows_remove(&m->r_0_0, b, a);
}

/* Whether another face than `but` has the side from a to b. */
static inline gmds_status has_other_face(mesh *m, gmds_id a, gmds_id b, gmds_id but, int *has)
{
#  if GMDS__FINDS_FACES
  GMDS_TRY(faces_at_side(m, a, b, GMDS_NONE, &m->found));
  *has = m->found.n > (size_t)gmds_ids_has(&m->found, but);
  return GMDS_OK;
#  else
  (void)m;
  (void)a;
  (void)b;
  (void)but;
  (void)has;
  return GMDS_ERR_UNSUPPORTED;
#  endif
}
#endif

/* Where nodes know nodes and no edge tells them apart, the faces at a side must. */
#define GMDS__JOINED_BY_FACES (GMDS__S_0_0 && !GMDS__LINKED_EDGES)

/* Fills m->plan for the removal of face f: its n nodes (none where nothing about them is to be forgotten), for each 1
 * when it is no longer joined with the next, its edges, for each 1 when it is to go with the face. */
static inline gmds_status plan_removal(mesh *m, gmds_id f, gmds_edges edges, size_t *n, size_t *n_edges)
{
  *n = *n_edges = 0;
  m->plan.n = 0;
  GMDS_TRY(gmds_ids_reserve(&m->plan, 1)); /* an empty plan is a list too, not NULL */
  (void)f;
#if GMDS__S_0_2 || (GMDS__JOINED_BY_FACES && GMDS__CAN_2_0)
  GMDS_TRY(get_adj_2_0(m, f, &m->plan));
  *n = m->plan.n;
  GMDS_TRY(gmds_ids_reserve(&m->plan, 2 * *n));
  m->plan.n = 2 * *n;
#endif
#if GMDS__JOINED_BY_FACES
  if (!GMDS__CAN_2_0)
    return GMDS_ERR_UNSUPPORTED;
  for (size_t k = 0; k < *n; k++) {
    int joined = 1;
    if (!GMDS__MAKES_EDGES || edges == GMDS_DROP_BARE_EDGES)
      GMDS_TRY(has_other_face(m, m->plan.data[k], m->plan.data[(k + 1) % *n], f, &joined));
    m->plan.data[*n + k] = (gmds_id)!joined;
  }
#endif
#if GMDS__MAKES_EDGES
#  if GMDS__CAN_2_1
  if (GMDS__S_1_2 || edges == GMDS_DROP_BARE_EDGES) {
    GMDS_TRY(get_adj_2_1(m, f, &m->found));
    *n_edges = m->found.n;
    GMDS_TRY(gmds_ids_reserve(&m->plan, 2 * (*n + *n_edges)));
    if (*n_edges)
      memcpy(m->plan.data + 2 * *n, m->found.data, *n_edges * sizeof *m->found.data);
    m->plan.n = 2 * (*n + *n_edges);
  }
  gmds_id *edge = m->plan.data + 2 * *n;
  for (size_t k = 0; k < *n_edges; k++) {
    edge[*n_edges + k] = 0;
    if (edges == GMDS_KEEP_EDGES)
      continue;
#    if GMDS__CAN_1_2
    GMDS_TRY(get_adj_1_2(m, edge[k], &m->found));
    edge[*n_edges + k] = m->found.n == (size_t)gmds_ids_has(&m->found, f);
#    else
    return GMDS_ERR_UNSUPPORTED;
#    endif
  }
#  else
  if (edges == GMDS_DROP_BARE_EDGES)
    return GMDS_ERR_UNSUPPORTED;
#  endif
#else
  (void)edges;
#endif
  return GMDS_OK;
}

/* The nodes of an edge that is about to go, GMDS_NONE where no relation links edges and nodes. */
static inline gmds_status ends_of(mesh *m, gmds_id e, gmds_id ends[2])
{
  ends[0] = ends[1] = GMDS_NONE;
#if GMDS__LINKED_EDGES
  m->found.n = 0;
  GMDS_TRY(gmds_ids_push(&m->found, e));
  GMDS_TRY(hop_1_0(m, &m->found, 0, 1));
  for (size_t k = 0; k < 2 && k + 1 < m->found.n; k++)
    ends[k] = m->found.data[k + 1];
#else
  (void)m;
  (void)e;
#endif
  return GMDS_OK;
}

/* Makes everything forget face f, along the plan. */
static inline void unlink_face(mesh *m, gmds_id f, size_t n, size_t n_edges)
{
  const gmds_id *nodes = m->plan.data, *unjoined = nodes + n, *edges = unjoined + n, *goes = edges + n_edges;
  (void)nodes;
  (void)unjoined;
  (void)edges;
  (void)goes;
#if GMDS__S_0_2
  for (size_t k = 0; k < n; k++)
    gmds_rows_remove(&m->r_0_2, nodes[k], f);
#endif
#if GMDS__JOINED_BY_FACES
  for (size_t k = 0; k < n; k++)
    if (unjoined[k])
      unjoin(m, nodes[k], nodes[(k + 1) % n]);
#endif
#if GMDS__S_2_2
  size_t sides = 0;
  const gmds_id *row = row_2_2(m, f, &sides);
  for (size_t k = 0; k < sides; k++) {
    size_t count = 0;
    if (row[k] == GMDS_NONE)
      continue;
    gmds_id *back = row_2_2(m, face_of(row[k]), &count);
    for (size_t q = 0; q < count; q++)
      if (back[q] != GMDS_NONE && face_of(back[q]) == f)
        back[q] = GMDS_NONE;
  }
#endif
#if GMDS__MAKES_EDGES
  for (size_t k = 0; k < n_edges; k++) {
#  if GMDS__S_1_2
    gmds_pairs_remove(&m->r_1_2, edges[k], f);
#  endif
    if (goes[k]) {
      gmds_id ends[2] = {GMDS_NONE, GMDS_NONE};
      (void)ends_of(m, edges[k], ends); /* the list has its room from the plan */
#  if GMDS__S_0_0
      if (ends[0] != GMDS_NONE)
        unjoin(m, ends[0], ends[1]);
#  endif
      unlink_edge(m, edges[k], ends);
    }
  }
#endif
  drop_face(m, f);
}

static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_edges edges)
{
  size_t n = 0, n_edges = 0;
  if (!has_2(m, f))
    return GMDS_ERR_CELL;
  GMDS_TRY(plan_removal(m, f, edges, &n, &n_edges));
  GMDS_TRY(gmds_ids_reserve(&m->found, 4));
  unlink_face(m, f, n, n_edges);
  return GMDS_OK;
}

/* Removes the faces of a list that the caller owns. The first pass walks every plan without carrying it out, so that
 * the lists have grown to what the second needs: then nothing can fail any more. */
static inline gmds_status remove_faces(mesh *m, const gmds_ids *faces, gmds_edges edges)
{
  size_t n = 0, n_edges = 0;
  for (size_t i = 0; i < faces->n; i++)
    GMDS_TRY(plan_removal(m, faces->data[i], edges, &n, &n_edges));
  GMDS_TRY(gmds_ids_reserve(&m->found, 4));
  for (size_t i = 0; i < faces->n; i++) {
    (void)plan_removal(m, faces->data[i], edges, &n, &n_edges);
    unlink_face(m, faces->data[i], n, n_edges);
  }
  return GMDS_OK;
}

#if GMDS__K_1
static inline gmds_status remove_edge(mesh *m, gmds_id e, gmds_around around)
{
  if (!has_1(m, e))
    return GMDS_ERR_CELL;
#  if GMDS__CAN_1_2
  gmds_ids faces = {.memory = &m->memory};
  gmds_status status = get_adj_1_2(m, e, &faces);
  if (status == GMDS_OK && faces.n)
    status = around == GMDS_REFUSE ? GMDS_ERR_CONFLICT : remove_faces(m, &faces, GMDS_KEEP_EDGES);
  gmds_ids_clear(&faces);
  GMDS_TRY(status);
#  elif GMDS__PATH_1_2
  (void)around;
  return GMDS_ERR_UNSUPPORTED;
#  else
  (void)around;
#  endif
  gmds_id ends[2] = {GMDS_NONE, GMDS_NONE};
  GMDS_TRY(ends_of(m, e, ends));
#  if GMDS__S_0_0
  if (ends[0] != GMDS_NONE)
    unjoin(m, ends[0], ends[1]);
#  endif
#  if GMDS__MAKES_EDGES
  unlink_edge(m, e, ends);
#  else
  drop_edge(m, e);
#  endif
  return GMDS_OK;
}
#endif

/* Gathers the faces and edges at node v and makes sure that their removal can be planned without more memory. */
static inline gmds_status plan_node_removal(mesh *m, gmds_id v, gmds_around around, gmds_ids *faces, gmds_ids *edges)
{
  (void)m;
  (void)v;
#if GMDS__CAN_0_2
  GMDS_TRY(get_adj_0_2(m, v, faces));
#endif
#if GMDS__CAN_0_1
  GMDS_TRY(get_adj_0_1(m, v, edges));
  for (size_t i = 0; i < edges->n; i++) {
    gmds_id ends[2];
    GMDS_TRY(ends_of(m, edges->data[i], ends));
  }
#endif
  return around == GMDS_REFUSE && faces->n + edges->n ? GMDS_ERR_CONFLICT : GMDS_OK;
}

static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around)
{
  if (!has_0(m, v))
    return GMDS_ERR_CELL;
  gmds_ids faces = {.memory = &m->memory}, edges = {.memory = &m->memory};
  gmds_status status = plan_node_removal(m, v, around, &faces, &edges);
  if (status == GMDS_OK) /* edges that do not know their nodes go when they bound nothing else */
    status = remove_faces(m, &faces, GMDS__LINKED_EDGES ? GMDS_KEEP_EDGES : GMDS_DROP_BARE_EDGES);
#if GMDS__LINKED_EDGES
  for (size_t i = 0; i < edges.n && status == GMDS_OK; i++) {
    gmds_id ends[2];
    (void)ends_of(m, edges.data[i], ends);
#  if GMDS__S_0_0
    unjoin(m, ends[0], ends[1]);
#  endif
    unlink_edge(m, edges.data[i], ends);
  }
#endif
  gmds_ids_clear(&faces);
  gmds_ids_clear(&edges);
  GMDS_TRY(status);
#define GMDS__RELEASE_OF_NODE(i, j) \
  if (i == 0)                       \
    gmds_rows_release(&m->r_##i##_##j, v);
#if GMDS__S_0_0
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(&m->r_0_0, v, &n);
  for (size_t k = 0; k < n; k++)
    gmds_rows_remove(&m->r_0_0, row[k], v);
#endif
  GMDS__EACH_SET(GMDS__RELEASE_OF_NODE)
#undef GMDS__RELEASE_OF_NODE
  gmds_cells_drop(&m->cells[0], v);
  return GMDS_OK;
}
