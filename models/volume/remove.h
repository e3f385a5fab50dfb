/* Deletion. What a cell is linked with is gathered first, by the queries of the model (which may run out of memory);
 * then everything that names the cell forgets it, which cannot fail. When several cells go, a first pass gathers for
 * each without carrying anything out, so that the lists have grown to what the second needs. */

#if GMDS__S_0_0
static inline void unjoin(mesh *m, gmds_id a, gmds_id b)
{
  gmds_rows_remove(&m->r_0_0, a, b);
  gmds_rows_remove(&m->r_0_0, b, a);
}
#endif

/* ---- edges */

#if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
/* Makes everything forget edge e, which bounds nothing any more, and frees it. `found` has room for its nodes. */
static inline gmds_status forget_edge(mesh *m, gmds_id e, int dry)
{
  GMDS_TRY(start_with(&m->found, &e, 1));
  GMDS_TRY(hop_1_0(m, &m->found, 0, 1));
  if (dry)
    return GMDS_OK;
#  if GMDS__S_0_1
  for (size_t k = 1; k < m->found.n; k++)
    gmds_rows_remove(&m->r_0_1, m->found.data[k], e);
#  endif
#  if GMDS__S_0_0
  unjoin(m, m->found.data[1], m->found.data[2]);
#  endif
#  if GMDS__S_1_1
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(&m->r_1_1, e, &n);
  for (size_t k = 0; k < n; k++)
    gmds_rows_remove(&m->r_1_1, row[k], e);
#  endif
  drop_edge(m, e);
  return GMDS_OK;
}

/* Whether edge e bounds a face or a region. */
static inline gmds_status is_bare_edge(mesh *m, gmds_id e, int *bare)
{
  *bare = 1;
  (void)m;
  (void)e;
#  if GMDS__CAN_1_2
  GMDS_TRY(get_adj_1_2(m, e, &m->found));
  *bare = !m->found.n;
#  endif
#  if GMDS__CAN_1_3
  if (*bare) {
    GMDS_TRY(get_adj_1_3(m, e, &m->found));
    *bare = !m->found.n;
  }
#  endif
  return GMDS_OK;
}

/* Removes the edges list[first .. last) that bound nothing. */
static inline gmds_status drop_bare_edges(mesh *m, const gmds_ids *list, size_t first, size_t last, int dry)
{
  for (size_t k = first; k < last; k++) {
    int bare = 0;
    GMDS_TRY(is_bare_edge(m, list->data[k], &bare));
    if (bare || dry)
      GMDS_TRY(forget_edge(m, list->data[k], dry));
  }
  return GMDS_OK;
}
#endif

/* ---- faces */

#if GMDS__MAKES_FACES
/* Makes everything but regions forget face f, which bounds none any more, and frees it; likewise its edges that are
 * left bare, where these go. */
static inline gmds_status forget_face(mesh *m, gmds_id f, gmds_bare bare, int dry)
{
  (void)bare;
  gmds_ids *list = &m->more; /* nodes, then edges */
  list->n = 0;
  size_t nodes = 0;
  (void)nodes;
#  if GMDS__CAN_2_0 && (GMDS__S_0_2 || GMDS__JOINED_BY_FACES)
  GMDS_TRY(get_adj_2_0(m, f, list));
  nodes = list->n;
#  endif
#  if GMDS__MAKES_EDGES && GMDS__CAN_2_1
  GMDS_TRY(get_adj_2_1(m, f, &m->found));
  GMDS_TRY(gmds_ids_reserve(list, nodes + m->found.n));
  if (m->found.n)
    memcpy(list->data + nodes, m->found.data, m->found.n * sizeof *m->found.data);
  list->n = nodes + m->found.n;
#  endif
#  if GMDS__JOINED_BY_FACES
  for (size_t k = 0; k < nodes; k++) {
    const gmds_id a = list->data[k], b = list->data[k + 1 < nodes ? k + 1 : 0];
    GMDS_TRY(faces_at_side(m, a, b, GMDS_NONE, &m->found));
    if (!dry && m->found.n == (size_t)gmds_ids_has(&m->found, f))
      unjoin(m, a, b);
  }
#  endif
  if (!dry) {
#  if GMDS__S_0_2
    for (size_t k = 0; k < nodes; k++)
      gmds_rows_remove(&m->r_0_2, list->data[k], f);
#  endif
#  if GMDS__S_1_2
    for (size_t k = nodes; k < list->n; k++)
      gmds_rows_remove(&m->r_1_2, list->data[k], f);
#  endif
#  if GMDS__S_2_2
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(&m->r_2_2, f, &n);
    for (size_t k = 0; k < n; k++)
      gmds_rows_remove(&m->r_2_2, row[k], f);
#  endif
    drop_face(m, f);
  }
#  if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
  if (bare == GMDS_DROP_BARE)
    GMDS_TRY(drop_bare_edges(m, list, nodes, list->n, dry));
#  endif
  return GMDS_OK;
}
#endif

/* ---- regions */

/* Makes everything forget region r and frees it; likewise its faces and edges that are left bare, where these go. Its
 * nodes, edges and faces are put into m->plan first. */
static inline gmds_status forget_region(mesh *m, gmds_id r, gmds_bare bare, int dry)
{
  gmds_ids *list = &m->plan;
  size_t nodes = 0, edges = 0;
  list->n = 0;
  (void)bare;
  (void)edges;
#if GMDS__ASKS_NODES
  GMDS_TRY(get_adj_3_0(m, r, list));
  nodes = list->n;
#endif
  edges = nodes;
#if GMDS__MAKES_EDGES && GMDS__CAN_3_1
  if (GMDS__S_1_3 || bare == GMDS_DROP_BARE) {
    GMDS_TRY(get_adj_3_1(m, r, &m->found));
    edges = nodes + m->found.n;
    GMDS_TRY(gmds_ids_reserve(list, edges));
    if (m->found.n)
      memcpy(list->data + nodes, m->found.data, m->found.n * sizeof *m->found.data);
    list->n = edges;
  }
#endif
#if GMDS__MAKES_FACES && GMDS__CAN_3_2
  if (GMDS__S_2_3 || bare == GMDS_DROP_BARE) {
    GMDS_TRY(get_adj_3_2(m, r, &m->found));
    GMDS_TRY(gmds_ids_reserve(list, edges + m->found.n));
    if (m->found.n)
      memcpy(list->data + edges, m->found.data, m->found.n * sizeof *m->found.data);
    list->n = edges + m->found.n;
  }
#endif
#if GMDS__JOINED_BY_REGIONS
  for (size_t i = 0; i < nodes; i++)
    for (size_t j = i + 1; j < nodes; j++) {
      const gmds_id a = list->data[i], b = list->data[j];
      GMDS_TRY(regions_at_rim(m, a, b, &m->found));
      if (!dry && m->found.n == 1 && m->found.data[0] == r)
        unjoin(m, a, b);
    }
#endif
  if (!dry) {
#if GMDS__S_0_3
    for (size_t k = 0; k < nodes; k++)
      gmds_rows_remove(&m->r_0_3, list->data[k], r);
#endif
#if GMDS__S_1_3
    for (size_t k = nodes; k < edges; k++)
      gmds_rows_remove(&m->r_1_3, list->data[k], r);
#endif
#if GMDS__S_2_3
    for (size_t k = edges; k < list->n; k++)
      gmds_pairs_remove(&m->r_2_3, list->data[k], r);
#endif
#if GMDS__S_3_3
    size_t walls = 0;
    const gmds_id *row = row_3_3(m, r, &walls);
    for (size_t k = 0; k < walls; k++) {
      size_t n = 0;
      if (row[k] == GMDS_NONE)
        continue;
      gmds_id *back = row_3_3(m, region_of(row[k]), &n);
      for (size_t q = 0; q < n; q++)
        if (back[q] != GMDS_NONE && region_of(back[q]) == r)
          back[q] = GMDS_NONE;
    }
#endif
    drop_region(m, r);
  }
#if GMDS__MAKES_FACES && GMDS__CAN_3_2 && GMDS__CAN_2_3
  for (size_t k = edges; k < list->n && bare == GMDS_DROP_BARE; k++) {
    GMDS_TRY(get_adj_2_3(m, list->data[k], &m->found));
    if (!m->found.n || dry)
      GMDS_TRY(forget_face(m, list->data[k], bare, dry));
  }
#endif
#if GMDS__MAKES_EDGES && GMDS__LINKED_0_1 && GMDS__CAN_3_1
  for (size_t k = nodes; k < edges && bare == GMDS_DROP_BARE; k++)
    if (has_1(m, list->data[k])) /* it may have gone with a face */
      GMDS_TRY(drop_bare_edges(m, list, k, k + 1, dry));
#endif
  return GMDS_OK;
}

/* Removes regions that are alive, each named once. */
static inline gmds_status forget_regions(mesh *m, const gmds_ids *regions, gmds_bare bare)
{
  if (!GMDS__FORGETS_REGIONS || (bare == GMDS_DROP_BARE && !GMDS__KNOWS_BARE))
    return regions->n ? GMDS_ERR_UNSUPPORTED : GMDS_OK;
  for (size_t i = 0; i < regions->n; i++)
    GMDS_TRY(forget_region(m, regions->data[i], bare, 1));
  for (size_t i = 0; i < regions->n; i++)
    (void)forget_region(m, regions->data[i], bare, 0);
  return GMDS_OK;
}

static inline gmds_status remove_regions(mesh *m, const gmds_ids *regions, gmds_bare bare)
{
  for (size_t i = 0; i < regions->n; i++)
    if (!has_3(m, regions->data[i]))
      return GMDS_ERR_CELL;
  GMDS_TRY(start_with(&m->found, regions->data, regions->n));
  gmds_ids_keep(&m->found, 0, 2, GMDS_NONE);
  return m->found.n ? GMDS_ERR_ARGUMENT : forget_regions(m, regions, bare);
}

static inline gmds_status remove_region(mesh *m, gmds_id r, gmds_bare bare)
{
  if (!has_3(m, r))
    return GMDS_ERR_CELL;
  const gmds_ids one = {.data = &r, .n = 1};
  return forget_regions(m, &one, bare);
}

#if GMDS__K_2
static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_around around, gmds_bare bare)
{
  if (!has_2(m, f))
    return GMDS_ERR_CELL;
#  if GMDS__MAKES_FACES
#    if GMDS__CAN_2_3
  gmds_ids regions = {.memory = &m->memory};
  gmds_status status = get_adj_2_3(m, f, &regions);
  if (status == GMDS_OK && (!GMDS__FORGETS_FACES || (bare == GMDS_DROP_BARE && !GMDS__KNOWS_BARE)))
    status = GMDS_ERR_UNSUPPORTED;
  if (status == GMDS_OK)
    status = forget_face(m, f, bare, 1);
  if (status == GMDS_OK && regions.n)
    status = around == GMDS_REFUSE ? GMDS_ERR_CONFLICT : forget_regions(m, &regions, GMDS_KEEP_BARE);
  if (status == GMDS_OK)
    (void)forget_face(m, f, bare, 0);
  gmds_ids_clear(&regions);
  return status;
#    else
  (void)around;
  (void)bare;
  return GMDS_ERR_UNSUPPORTED;
#    endif
#  else
  (void)around;
  (void)bare;
  drop_face(m, f);
  return GMDS_OK;
#  endif
}
#endif

#if GMDS__K_1
static inline gmds_status remove_edge(mesh *m, gmds_id e, gmds_around around)
{
  if (!has_1(m, e))
    return GMDS_ERR_CELL;
#  if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
#    if GMDS__CAN_1_3 && (!GMDS__MAKES_FACES || GMDS__CAN_1_2)
  gmds_ids regions = {.memory = &m->memory}, faces = {.memory = &m->memory};
  gmds_status status = get_adj_1_3(m, e, &regions);
#      if GMDS__MAKES_FACES
  if (status == GMDS_OK)
    status = get_adj_1_2(m, e, &faces);
  if (status == GMDS_OK && faces.n && !GMDS__FORGETS_FACES)
    status = GMDS_ERR_UNSUPPORTED;
  for (size_t k = 0; k < faces.n && status == GMDS_OK; k++)
    status = forget_face(m, faces.data[k], GMDS_KEEP_BARE, 1);
#      endif
  if (status == GMDS_OK)
    status = forget_edge(m, e, 1);
  if (status == GMDS_OK && regions.n + faces.n && around == GMDS_REFUSE)
    status = GMDS_ERR_CONFLICT;
  if (status == GMDS_OK)
    status = forget_regions(m, &regions, GMDS_KEEP_BARE);
#      if GMDS__MAKES_FACES
  for (size_t k = 0; k < faces.n && status == GMDS_OK; k++)
    (void)forget_face(m, faces.data[k], GMDS_KEEP_BARE, 0);
#      endif
  if (status == GMDS_OK)
    (void)forget_edge(m, e, 0);
  gmds_ids_clear(&regions);
  gmds_ids_clear(&faces);
  return status;
#    else
  (void)around;
  return GMDS_ERR_UNSUPPORTED;
#    endif
#  elif GMDS__MAKES_EDGES
  (void)around;
  return GMDS_ERR_UNSUPPORTED;
#  else
  (void)around;
  drop_edge(m, e);
  return GMDS_OK;
#  endif
}
#endif

/* What is at a node. */
typedef struct surroundings {
  gmds_ids regions, faces, edges;
} surroundings;

static inline gmds_status gather_around(mesh *m, gmds_id v, gmds_around around, surroundings *s)
{
  (void)m;
  (void)v;
#if GMDS__CAN_0_3
  GMDS_TRY(get_adj_0_3(m, v, &s->regions));
#endif
#if GMDS__MAKES_FACES && GMDS__CAN_0_2
  GMDS_TRY(get_adj_0_2(m, v, &s->faces));
  if (s->faces.n && !GMDS__FORGETS_FACES)
    return GMDS_ERR_UNSUPPORTED;
  for (size_t k = 0; k < s->faces.n; k++)
    GMDS_TRY(forget_face(m, s->faces.data[k], GMDS_KEEP_BARE, 1));
#endif
#if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
  GMDS_TRY(get_adj_0_1(m, v, &s->edges));
  for (size_t k = 0; k < s->edges.n; k++)
    GMDS_TRY(forget_edge(m, s->edges.data[k], 1));
#endif
  return around == GMDS_REFUSE && s->regions.n + s->faces.n + s->edges.n ? GMDS_ERR_CONFLICT : GMDS_OK;
}

static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around)
{
  if (!has_0(m, v))
    return GMDS_ERR_CELL;
  surroundings s = {{.memory = &m->memory}, {.memory = &m->memory}, {.memory = &m->memory}};
  gmds_status status = gather_around(m, v, around, &s);
  if (status == GMDS_OK)
    status = forget_regions(m, &s.regions, GMDS_KEEP_BARE);
#if GMDS__MAKES_FACES
  for (size_t k = 0; k < s.faces.n && status == GMDS_OK; k++)
    (void)forget_face(m, s.faces.data[k], GMDS_KEEP_BARE, 0);
#endif
#if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
  for (size_t k = 0; k < s.edges.n && status == GMDS_OK; k++)
    (void)forget_edge(m, s.edges.data[k], 0);
#endif
  gmds_ids_clear(&s.regions);
  gmds_ids_clear(&s.faces);
  gmds_ids_clear(&s.edges);
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
