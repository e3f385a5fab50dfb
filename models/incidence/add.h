/* Creation. Everything that can fail comes first (looking up what is at each side, taking identifiers, room in every
 * row); then the cell is linked, which cannot fail. What was taken for a creation that fails is given back. */

static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id)
{
  GMDS_TRY(grow(m, 0, 1));
  gmds_id v = gmds_cells_take(&m->cells[0]);
  set_point(m, v, x);
  *id = v;
  return GMDS_OK;
}

static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first)
{
  const gmds_cells *nodes = &m->cells[0];
  if (n > nodes->limit || nodes->end > nodes->limit - n)
    return GMDS_ERR_TOO_MANY;
  if (nodes->end + n > nodes->capacity)
    GMDS_TRY(resize_columns(m, 0, nodes->end + n));
  *first = gmds_cells_take_many(&m->cells[0], n);
  if (n && x)
    memcpy(m->points + GMDS__DIM * (size_t)*first, x, n * GMDS__DIM * sizeof *x);
  return GMDS_OK;
}

/* ---- edges */

#if GMDS__K_1
/* Room in every row for an edge e between a and b, and for up to three more edges at the same nodes. */
static inline gmds_status reserve_edge(mesh *m, gmds_id e, gmds_id a, gmds_id b)
{
  const gmds_id ends[2] = {a, b};
  (void)ends;
  (void)e;
  (void)m;
#  if GMDS__S_0_1
  for (int k = 0; k < 2; k++)
    GMDS_TRY(gmds_rows_reserve(&m->r_0_1, &m->memory, ends[k], m->r_0_1.length[ends[k]] + (size_t)2));
#  endif
#  if GMDS__S_0_0
  for (int k = 0; k < 2; k++)
    GMDS_TRY(gmds_rows_reserve(&m->r_0_0, &m->memory, ends[k], m->r_0_0.length[ends[k]] + (size_t)2));
#  endif
#  if GMDS__S_1_1
  m->found.n = 0;
  GMDS_TRY(gmds_ids_push(&m->found, a));
  GMDS_TRY(gmds_ids_push(&m->found, b));
  GMDS_TRY(hop_0_1(m, &m->found, 0, 2));
  GMDS_TRY(gmds_ids_reserve(&m->found, m->found.n + 8));
  GMDS_TRY(gmds_rows_reserve(&m->r_1_1, &m->memory, e, m->found.n + 4));
  for (size_t i = 2; i < m->found.n; i++) {
    gmds_id x = m->found.data[i];
    GMDS_TRY(gmds_rows_reserve(&m->r_1_1, &m->memory, x, m->r_1_1.length[x] + (size_t)4));
  }
#  endif
  return GMDS_OK;
}

/* Links edge e, taken and reserved, with its nodes. */
static inline void link_edge(mesh *m, gmds_id e, gmds_id a, gmds_id b)
{
  (void)m;
  (void)e;
  (void)a;
  (void)b;
#  if GMDS__S_1_1
  m->found.n = 0;
  m->found.data[m->found.n++] = a;
  m->found.data[m->found.n++] = b;
  (void)hop_0_1(m, &m->found, 0, 2); /* reserve_edge made the room */
  for (size_t i = 2; i < m->found.n; i++)
    if (m->found.data[i] != e) {
      gmds_rows_push(&m->r_1_1, e, m->found.data[i]);
      gmds_rows_push(&m->r_1_1, m->found.data[i], e);
    }
#  endif
#  if GMDS__S_1_0
  m->r_1_0.data[2 * (size_t)e] = a;
  m->r_1_0.data[2 * (size_t)e + 1] = b;
#  endif
#  if GMDS__S_0_1
  gmds_rows_push(&m->r_0_1, a, e);
  gmds_rows_push(&m->r_0_1, b, e);
#  endif
#  if GMDS__S_0_0
  if (gmds_rows_find(&m->r_0_0, a, b) == GMDS_NONE) {
    gmds_rows_push(&m->r_0_0, a, b);
    gmds_rows_push(&m->r_0_0, b, a);
  }
#  endif
}

/* Frees the rows of edge e and its identifier. */
static inline void drop_edge(mesh *m, gmds_id e)
{
#  if GMDS__S_1_1
  gmds_rows_release(&m->r_1_1, e);
#  endif
#  if GMDS__S_1_2
  gmds_pairs_empty(&m->r_1_2, e);
#  endif
  gmds_cells_drop(&m->cells[1], e);
}

#  if GMDS__LINKED_EDGES
static inline gmds_status add_edge(mesh *m, gmds_id a, gmds_id b, gmds_id *id)
{
  if (!has_0(m, a) || !has_0(m, b))
    return GMDS_ERR_CELL;
  if (a == b)
    return GMDS_ERR_ARGUMENT;
  gmds_id e = find_edge(m, a, b);
  if (e == GMDS_NONE) {
    GMDS_TRY(grow(m, 1, 1));
    e = gmds_cells_take(&m->cells[1]);
#    if GMDS__S_1_0
    m->r_1_0.data[2 * (size_t)e] = m->r_1_0.data[2 * (size_t)e + 1] = GMDS_NONE;
#    endif
    gmds_status status = reserve_edge(m, e, a, b);
    if (status != GMDS_OK) {
      drop_edge(m, e);
      return status;
    }
    link_edge(m, e, a, b);
  }
  *id = e;
  return GMDS_OK;
}
#  endif
#endif

/* ---- faces */

/* Faces find or make their edges when something is stored about edges. */
#define GMDS__MAKES_EDGES (GMDS__LINKED_EDGES || GMDS__S_1_2 || GMDS__S_2_1 || GMDS__S_1_1)

/* add_face finds by itself what it has to link. */
#define GMDS_ADDS_FACES ((!GMDS__S_2_2 || GMDS__FINDS_FACES) && (!GMDS__MAKES_EDGES || GMDS__FINDS_EDGES))

/* ... and without a traversal of the mesh. */
#define GMDS__SEES_FACES ((GMDS__S_0_2 && GMDS__KNOWS_SIDES) || (GMDS__LINKED_EDGES && GMDS__S_1_2))
#define GMDS__SEES_EDGES \
  (GMDS__LINKED_EDGES ? GMDS__S_0_1 : GMDS__SEES_FACES && GMDS__S_2_1 && (GMDS__S_2_0 || GMDS__S_1_2))
#define GMDS_ADDS_LOCALLY \
  (GMDS_ADDS_FACES && (!GMDS__S_2_2 || GMDS__SEES_FACES) && (!GMDS__MAKES_EDGES || GMDS__SEES_EDGES))

static inline int allows_sides(size_t n)
{
  return (n == 3 && GMDS__TRIANGLES) || (n == 4 && GMDS__QUADRILATERALS) || (n >= 3 && GMDS__POLYGONS);
}

/* Whether n nodes are alive and distinct: compared in pairs while that is the shortest. */
static inline gmds_status check_nodes(mesh *m, size_t n, const gmds_id *nodes)
{
  enum { FEW = 32 };
  for (size_t k = 0; k < n; k++) {
    if (!has_0(m, nodes[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; n <= FEW && q < k; q++)
      if (nodes[q] == nodes[k])
        return GMDS_ERR_ARGUMENT;
  }
  if (n <= FEW)
    return GMDS_OK;
  m->found.n = 0;
  GMDS_TRY(gmds_ids_reserve(&m->found, n));
  memcpy(m->found.data, nodes, n * sizeof *nodes);
  m->found.n = n;
  gmds_ids_keep(&m->found, 0, 2, GMDS_NONE);
  return m->found.n ? GMDS_ERR_ARGUMENT : GMDS_OK;
}

#if GMDS__S_2_2
/* The free entry of face g for its side between a and b, or GMDS_NONE: the entry of that side where the order is kept,
 * any free one else, the `skip`-th. */
static inline gmds_id free_entry(const mesh *m, gmds_id g, gmds_id a, gmds_id b, size_t skip)
{
  size_t n = 0;
  const gmds_id *row = row_2_2(m, g, &n);
#  if GMDS_ORDERED_2_0
  (void)skip;
  gmds_id k = find_side(m, g, a, b);
  return k != GMDS_NONE && row[k] == GMDS_NONE ? k : GMDS_NONE;
#  else
  (void)a;
  (void)b;
  for (size_t k = 0; k < n; k++)
    if (row[k] == GMDS_NONE && skip-- == 0)
      return (gmds_id)k;
  return GMDS_NONE;
#  endif
}
#endif

/* Fills m->plan for a face of n nodes: entry k the edge at side k or GMDS_NONE, entry n + k the face beyond it or
 * GMDS_NONE, entry 2n + k is 0. From what the caller knows, else looked up. */
static inline gmds_status plan_links(mesh *m, size_t n, const gmds_id *nodes, const gmds_links *links)
{
  const gmds_id *known_edges = links ? links->edges : NULL, *known_faces = links ? links->faces : NULL;
  m->plan.n = 0;
  GMDS_TRY(gmds_ids_reserve(&m->plan, 3 * n));
  m->plan.n = 3 * n;
  for (size_t k = 0; k < n; k++) {
    gmds_id a = nodes[k], b = nodes[(k + 1) % n], edge = GMDS_NONE, face = GMDS_NONE;
    (void)a;
    (void)b;
#if GMDS__MAKES_EDGES
    if (known_edges) {
      edge = known_edges[k];
      if (edge != GMDS_NONE && !has_1(m, edge))
        return GMDS_ERR_CELL;
    }
#  if GMDS__LINKED_EDGES
    else
      edge = find_edge(m, a, b);
#  elif !GMDS__FINDS_EDGES
    else
      return GMDS_ERR_UNSUPPORTED;
#  endif
#endif
    int looks_faces = GMDS__S_2_2 && !known_faces;
#if GMDS__MAKES_EDGES && !GMDS__LINKED_EDGES
    looks_faces |= !known_edges;
#endif
    if (looks_faces) {
#if GMDS__FINDS_FACES
      GMDS_TRY(faces_at_side(m, a, b, edge, &m->found));
      if (GMDS__S_2_2 && m->found.n > 1)
        return GMDS_ERR_CONFLICT;
      if (m->found.n)
        face = m->found.data[0];
#  if GMDS__MAKES_EDGES && !GMDS__LINKED_EDGES
      if (!known_edges) {
        size_t on_side = m->found.n;
        gmds_ids scratch = {.memory = &m->memory};
        gmds_status status = edge_of_faces(m, a, b, m->found.data, on_side, m->plan.data, k, &scratch, &edge);
        gmds_ids_clear(&scratch);
        GMDS_TRY(status);
      }
#  endif
#else
      return GMDS_ERR_UNSUPPORTED;
#endif
    }
    if (known_faces)
      face = known_faces[k];
#if GMDS__S_2_2
    if (face != GMDS_NONE) {
      size_t before = 0; /* sides of the new face that meet the same face */
      for (size_t q = 0; !GMDS_ORDERED_2_0 && q < k; q++)
        before += m->plan.data[n + q] == face;
      if (!has_2(m, face))
        return GMDS_ERR_CELL;
      if (free_entry(m, face, a, b, before) == GMDS_NONE)
        return GMDS_ERR_CONFLICT;
    }
#endif
    m->plan.data[k] = edge;
    m->plan.data[n + k] = face;
    m->plan.data[2 * n + k] = 0;
  }
  (void)known_edges;
  (void)known_faces;
  return GMDS_OK;
}

/* Takes the edges that the plan lacks and makes room in every row for face f. */
static inline gmds_status reserve_face(mesh *m, gmds_id f, size_t n, const gmds_id *nodes)
{
  (void)f;
  (void)nodes;
  gmds_id *edges = m->plan.data, *is_new = m->plan.data + 2 * n;
  (void)edges;
  (void)is_new;
#if GMDS__MAKES_EDGES
  for (size_t k = 0; k < n; k++)
    if (edges[k] == GMDS_NONE) {
      GMDS_TRY(grow(m, 1, 1));
      edges[k] = gmds_cells_take(&m->cells[1]);
      is_new[k] = 1;
#  if GMDS__S_1_0
      m->r_1_0.data[2 * (size_t)edges[k]] = m->r_1_0.data[2 * (size_t)edges[k] + 1] = GMDS_NONE;
#  endif
    }
  for (size_t k = 0; k < n; k++)
    if (is_new[k])
      GMDS_TRY(reserve_edge(m, edges[k], nodes[k], nodes[(k + 1) % n]));
#endif
  for (size_t k = 0; k < n; k++) {
#if GMDS__S_1_2
    size_t on_edge = 0;
    (void)gmds_pairs_get(&m->r_1_2, edges[k], &on_edge);
    GMDS_TRY(gmds_pairs_reserve(&m->r_1_2, &m->memory, edges[k], on_edge + 1));
#endif
#if GMDS__S_0_2
    GMDS_TRY(gmds_rows_reserve(&m->r_0_2, &m->memory, nodes[k], m->r_0_2.length[nodes[k]] + (size_t)1));
#endif
#if GMDS__S_0_0
    GMDS_TRY(gmds_rows_reserve(&m->r_0_0, &m->memory, nodes[k], m->r_0_0.length[nodes[k]] + (size_t)2));
#endif
  }
#define GMDS__RESERVE_ORDERED(i, j) GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, f, n));
  GMDS__EACH_ORDERED(GMDS__RESERVE_ORDERED)
#undef GMDS__RESERVE_ORDERED
  return GMDS_OK;
}

/* Frees the rows of face f and its identifier. */
static inline void drop_face(mesh *m, gmds_id f)
{
#define GMDS__RELEASE_ORDERED(i, j) gmds_rows_release(&m->r_##i##_##j, f);
  GMDS__EACH_ORDERED(GMDS__RELEASE_ORDERED)
#undef GMDS__RELEASE_ORDERED
  gmds_cells_drop(&m->cells[2], f);
}

#if GMDS__S_2_0
static inline void set_row_2_0(mesh *m, gmds_id f, size_t n, const gmds_id *row)
{
#  if GMDS__INLINE
  memcpy(m->r_2_0.data + GMDS__SIDES * (size_t)f, row, n * sizeof *row);
#  else
  for (size_t k = 0; k < n; k++)
    gmds_rows_push(&m->r_2_0, f, row[k]);
#  endif
}
#endif

#if GMDS__S_2_1
static inline void set_row_2_1(mesh *m, gmds_id f, size_t n, const gmds_id *row)
{
#  if GMDS__INLINE
  memcpy(m->r_2_1.data + GMDS__SIDES * (size_t)f, row, n * sizeof *row);
#  else
  for (size_t k = 0; k < n; k++)
    gmds_rows_push(&m->r_2_1, f, row[k]);
#  endif
}
#endif

/* Links face f, taken and reserved, along the plan. */
static inline void link_face(mesh *m, gmds_id f, size_t n, const gmds_id *nodes)
{
  const gmds_id *edges = m->plan.data, *faces = m->plan.data + n, *is_new = m->plan.data + 2 * n;
  (void)m;
  (void)f;
  (void)edges;
  (void)faces;
  (void)is_new;
#if GMDS__MAKES_EDGES
  for (size_t k = 0; k < n; k++)
    if (is_new[k])
      link_edge(m, edges[k], nodes[k], nodes[(k + 1) % n]);
#endif
#if GMDS__S_2_0
  set_row_2_0(m, f, n, nodes);
#endif
#if GMDS__S_2_1
  set_row_2_1(m, f, n, edges);
#endif
  for (size_t k = 0; k < n; k++) {
    gmds_id a = nodes[k], b = nodes[(k + 1) % n];
    (void)a;
    (void)b;
#if GMDS__S_1_2
    gmds_pairs_push(&m->r_1_2, edges[k], f);
#endif
#if GMDS__S_0_2
    gmds_rows_push(&m->r_0_2, a, f);
#endif
#if GMDS__S_0_0
    if (gmds_rows_find(&m->r_0_0, a, b) == GMDS_NONE) {
      gmds_rows_push(&m->r_0_0, a, b);
      gmds_rows_push(&m->r_0_0, b, a);
    }
#endif
#if GMDS__S_2_2
    size_t count = 0;
    gmds_id entry = GMDS_NONE, g = faces[k];
    if (g != GMDS_NONE) {
      gmds_id slot = free_entry(m, g, a, b, 0);
      row_2_2(m, g, &count)[slot] = GMDS__CODED ? 4 * f + (gmds_id)k : f;
      entry = GMDS__CODED ? 4 * g + slot : g;
    }
#  if GMDS__INLINE
    row_2_2(m, f, &count)[k] = entry;
#  else
    gmds_rows_push(&m->r_2_2, f, entry);
#  endif
#endif
  }
}

static inline gmds_status add_face_linked(mesh *m, size_t n, const gmds_id *nodes, const gmds_links *links, gmds_id *id)
{
  if (!allows_sides(n))
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(check_nodes(m, n, nodes));
  GMDS_TRY(plan_links(m, n, nodes, links));
  GMDS_TRY(grow(m, 2, 1));
  gmds_id f = gmds_cells_take(&m->cells[2]);
  gmds_status status = reserve_face(m, f, n, nodes);
  if (status != GMDS_OK) {
#if GMDS__MAKES_EDGES
    for (size_t k = 0; k < n; k++)
      if (m->plan.data[2 * n + k])
        drop_edge(m, m->plan.data[k]);
#endif
    drop_face(m, f);
    return status;
  }
  link_face(m, f, n, nodes);
  *id = f;
  return GMDS_OK;
}

static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  return add_face_linked(m, n, nodes, NULL, id);
}

static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id)
{
  const gmds_id nodes[3] = {a, b, c};
  return add_face_linked(m, 3, nodes, NULL, id);
}

static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_face_linked(m, 4, nodes, NULL, id);
}
