/* Creation. Everything that can fail comes first (looking up what is there, taking identifiers, room in every row); then
 * the cells are linked, which cannot fail. What was taken for a creation that fails is given back. */

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
    memcpy(m->points + 3 * (size_t)*first, x, 3 * n * sizeof *x);
  return GMDS_OK;
}

/* Whether n nodes are alive and distinct. */
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
  GMDS_TRY(start_with(&m->found, nodes, n));
  gmds_ids_keep(&m->found, 0, 2, GMDS_NONE);
  return m->found.n ? GMDS_ERR_ARGUMENT : GMDS_OK;
}

/* ---- what a new cell is made of: its edges and faces, found or new. The arrays lie in m->plan. */

typedef struct cell_plan {
  size_t n_nodes, n_edges, n_faces, n_corners;
  const gmds_id *node;    /* the distinct nodes */
  gmds_id *ends;          /* 2 a edge: its nodes */
  gmds_id *edge, *fresh;  /* of each: its identifier, and whether it is new */
  gmds_id *begin;         /* n_faces + 1: face k has the corners begin[k] to begin[k + 1] - 1: */
  gmds_id *corner;        /* a node, and */
  gmds_id *border;        /* which of the edges leads to the next */
  gmds_id *face, *made;   /* of each face: its identifier, and whether it is new */
  gmds_id *beyond, *slot; /* the region beyond it, or GMDS_NONE, and where that keeps the new one in R2R */
} cell_plan;

static inline gmds_status begin_plan(mesh *m, size_t n_nodes, const gmds_id *nodes, size_t n_edges, size_t n_faces,
                                     size_t n_corners, cell_plan *p)
{
  size_t n = 4 * n_edges + 5 * n_faces + 1 + 2 * n_corners;
  m->plan.n = 0;
  GMDS_TRY(gmds_ids_reserve(&m->plan, n));
  m->plan.n = n;
  *p = (cell_plan){.n_nodes = n_nodes, .n_edges = n_edges, .n_faces = n_faces, .n_corners = n_corners, .node = nodes};
  p->ends = m->plan.data;
  p->edge = p->ends + 2 * n_edges;
  p->fresh = p->edge + n_edges;
  p->begin = p->fresh + n_edges;
  p->corner = p->begin + n_faces + 1;
  p->border = p->corner + n_corners;
  p->face = p->border + n_corners;
  p->made = p->face + n_faces;
  p->beyond = p->made + n_faces;
  p->slot = p->beyond + n_faces;
  return GMDS_OK;
}

static inline gmds_status plan_edge(mesh *m, gmds_id a, gmds_id b, cell_plan *p)
{
  GMDS_TRY(begin_plan(m, 2, NULL, 1, 0, 0, p));
  p->node = p->ends;
  p->ends[0] = a;
  p->ends[1] = b;
  p->begin[0] = 0;
  return GMDS_OK;
}

static inline gmds_status plan_polygon(mesh *m, size_t n, const gmds_id *nodes, cell_plan *p)
{
  GMDS_TRY(begin_plan(m, n, nodes, n, 1, n, p));
  p->begin[0] = 0;
  p->begin[1] = (gmds_id)n;
  for (size_t k = 0; k < n; k++) {
    p->ends[2 * k] = nodes[k];
    p->ends[2 * k + 1] = nodes[k + 1 < n ? k + 1 : 0];
    p->corner[k] = nodes[k];
    p->border[k] = (gmds_id)k;
  }
  return GMDS_OK;
}

static inline gmds_status plan_shape(mesh *m, const gmds_shape *s, const gmds_id *nodes, cell_plan *p)
{
  size_t corners = 0;
  for (size_t k = 0; k < s->faces; k++)
    corners += s->sides[k];
  GMDS_TRY(begin_plan(m, s->nodes, nodes, s->edges, s->faces, corners, p));
  for (size_t e = 0; e < s->edges; e++)
    for (size_t i = 0; i < 2; i++)
      p->ends[2 * e + i] = nodes[s->edge[e][i]];
  corners = 0;
  for (size_t k = 0; k < s->faces; k++) {
    p->begin[k] = (gmds_id)corners;
    for (size_t i = 0; i < s->sides[k]; i++) {
      p->corner[corners] = nodes[s->face[k][i]];
      p->border[corners++] = s->border[k][i];
    }
  }
  p->begin[s->faces] = (gmds_id)corners;
  return GMDS_OK;
}

/* The edges of face k of the plan, into m->more. */
static inline gmds_status edges_of_plan(mesh *m, const cell_plan *p, size_t k)
{
  m->more.n = 0;
  for (size_t c = p->begin[k]; c < p->begin[k + 1]; c++)
    GMDS_TRY(gmds_ids_push(&m->more, p->edge[p->border[c]]));
  return GMDS_OK;
}

/* Looks up the edges and faces of the plan: GMDS_NONE where there is none yet. */
static inline gmds_status find_planned(mesh *m, cell_plan *p)
{
  (void)m;
  for (size_t e = 0; e < p->n_edges; e++) {
    p->edge[e] = GMDS_NONE;
    p->fresh[e] = 0;
#if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
    p->edge[e] = find_edge(m, p->ends[2 * e], p->ends[2 * e + 1]);
#endif
  }
  for (size_t k = 0; k < p->n_faces; k++) {
    p->face[k] = p->beyond[k] = GMDS_NONE;
    p->made[k] = p->slot[k] = 0;
#if GMDS__MAKES_FACES
    GMDS_TRY(edges_of_plan(m, p, k));
    GMDS_TRY(find_face(m, p->begin[k + 1] - p->begin[k], p->corner + p->begin[k], m->more.data, &m->found,
                       &p->face[k]));
#endif
  }
  return GMDS_OK;
}

#if GMDS__S_3_3
/* Where R2R of region s keeps what lies beyond the face of n nodes: entry k for its face k where regions list their
 * faces, else any that is free, the `skip`-th. GMDS_NONE: there is none. */
static inline gmds_id free_slot(const mesh *m, gmds_id s, size_t n, const gmds_id *nodes, gmds_id face, size_t skip)
{
  size_t walls = 0;
  const gmds_id *row = row_3_3(m, s, &walls);
  (void)n;
  (void)nodes;
  (void)face;
  (void)skip;
#  if GMDS__LISTS_WALLS
  gmds_id k = find_wall(m, s, n, nodes);
  return k != GMDS_NONE && row[k] == GMDS_NONE ? k : GMDS_NONE;
#  elif GMDS__S_3_2
  const gmds_id *faces = row_3_2(m, s, &walls);
  for (size_t k = 0; k < walls; k++)
    if (faces[k] == face)
      return row[k] == GMDS_NONE ? (gmds_id)k : GMDS_NONE;
  return GMDS_NONE;
#  else
  for (size_t k = 0; k < walls; k++)
    if (row[k] == GMDS_NONE && skip-- == 0)
      return (gmds_id)k;
  return GMDS_NONE;
#  endif
}

/* Looks up the region beyond each face. GMDS_ERR_CONFLICT: there are two already. */
static inline gmds_status find_beyond(mesh *m, cell_plan *p)
{
#  if GMDS__LINKED_0_3 || GMDS__LINKED_1_3 || GMDS__LINKED_2_3
  for (size_t k = 0; k < p->n_faces; k++) {
    const size_t n = p->begin[k + 1] - p->begin[k];
    const gmds_id *nodes = p->corner + p->begin[k];
    GMDS_TRY(edges_of_plan(m, p, k));
    GMDS_TRY(regions_on(m, n, nodes, m->more.data, p->face[k], &m->found));
    if (!m->found.n)
      continue;
    if (m->found.n > 1)
      return GMDS_ERR_CONFLICT;
    size_t before = 0; /* faces of the new region beyond which the same one lies */
    for (size_t q = 0; q < k; q++)
      before += p->beyond[q] == m->found.data[0];
    p->beyond[k] = m->found.data[0];
    p->slot[k] = free_slot(m, p->beyond[k], n, nodes, p->face[k], before);
    if (p->slot[k] == GMDS_NONE)
      return GMDS_ERR_CONFLICT;
  }
#  endif
  return GMDS_OK;
}
#endif

/* ---- taking identifiers, and giving them back */

static inline void drop_edge(mesh *m, gmds_id e)
{
#define GMDS__RELEASE_OF_EDGE(i, j) \
  if (i == 1)                       \
    gmds_rows_release(&m->r_##i##_##j, e);
  GMDS__EACH_SET(GMDS__RELEASE_OF_EDGE)
#undef GMDS__RELEASE_OF_EDGE
  gmds_cells_drop(&m->cells[1], e);
}

static inline void drop_face(mesh *m, gmds_id f)
{
#define GMDS__RELEASE_OF_FACE(i, j) \
  if (i == 2)                       \
    gmds_rows_release(&m->r_##i##_##j, f);
#define GMDS__EMPTY_OF_FACE(i, j) gmds_pairs_empty(&m->r_##i##_##j, f);
  GMDS__EACH_POOLED(GMDS__RELEASE_OF_FACE)
  GMDS__EACH_PAIRS(GMDS__EMPTY_OF_FACE)
#undef GMDS__RELEASE_OF_FACE
#undef GMDS__EMPTY_OF_FACE
  gmds_cells_drop(&m->cells[2], f);
}

static inline void drop_region(mesh *m, gmds_id r)
{
#define GMDS__RELEASE_OF_REGION(i, j) \
  if (i == 3)                         \
    gmds_rows_release(&m->r_##i##_##j, r);
  GMDS__EACH_ORDERED(GMDS__RELEASE_OF_REGION)
#undef GMDS__RELEASE_OF_REGION
  gmds_cells_drop(&m->cells[3], r);
}

static inline void drop_planned(mesh *m, const cell_plan *p)
{
  for (size_t k = p->n_faces; k-- > 0;)
    if (p->made[k])
      drop_face(m, p->face[k]);
  for (size_t e = p->n_edges; e-- > 0;)
    if (p->fresh[e])
      drop_edge(m, p->edge[e]);
}

/* Takes what the plan lacks. On failure what was taken is marked as such. */
static inline gmds_status take_planned(mesh *m, cell_plan *p)
{
#if GMDS__MAKES_EDGES
  for (size_t e = 0; e < p->n_edges; e++)
    if (p->edge[e] == GMDS_NONE) {
      GMDS_TRY(grow(m, 1, 1));
      p->edge[e] = gmds_cells_take(&m->cells[1]);
      p->fresh[e] = 1;
#  if GMDS__S_1_0
      m->r_1_0.data[2 * (size_t)p->edge[e]] = m->r_1_0.data[2 * (size_t)p->edge[e] + 1] = GMDS_NONE;
#  endif
    }
#endif
#if GMDS__MAKES_FACES
  for (size_t k = 0; k < p->n_faces; k++)
    if (p->face[k] == GMDS_NONE) {
      GMDS_TRY(grow(m, 2, 1));
      p->face[k] = gmds_cells_take(&m->cells[2]);
      p->made[k] = 1;
#  define GMDS__CLEAR_FACE(i, j)                   \
    for (size_t q = 0; q < GMDS__ARITY_2_0; q++) \
      m->r_##i##_##j.data[GMDS__ARITY_2_0 * (size_t)p->face[k] + q] = GMDS_NONE;
      GMDS__INLINE_FACES(GMDS__CLEAR_FACE)
#  undef GMDS__CLEAR_FACE
    }
#endif
  (void)m;
  (void)p;
  return GMDS_OK;
}

/* ---- room in every row */

/* How many new edges of the plan end at a node, and how many new faces have it. */
static inline size_t new_edges_at(const cell_plan *p, gmds_id v)
{
  size_t n = 0;
  for (size_t e = 0; e < p->n_edges; e++)
    n += p->fresh[e] && (p->ends[2 * e] == v || p->ends[2 * e + 1] == v);
  return n;
}

static inline size_t new_faces_at(const cell_plan *p, gmds_id v)
{
  size_t n = 0;
  for (size_t k = 0; k < p->n_faces; k++)
    for (size_t c = p->begin[k]; p->made[k] && c < p->begin[k + 1]; c++)
      n += p->corner[c] == v;
  return n;
}

static inline size_t new_faces_on(const cell_plan *p, size_t e)
{
  size_t n = 0;
  for (size_t k = 0; k < p->n_faces; k++)
    for (size_t c = p->begin[k]; p->made[k] && c < p->begin[k + 1]; c++)
      n += p->border[c] == e;
  return n;
}

#define GMDS__ROOM(i, j, c, more) \
  GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, c, m->r_##i##_##j.length[c] + (size_t)(more)))

/* ---- new edges and faces beside those that are there (E2E, F2F): gathered before anything is linked, in m->more: for
 * each new edge and then for each new face the number of its neighbours and these. */

#if GMDS__S_1_1 || GMDS__S_2_2
/* Appends what m->found holds from `first` on as the neighbours of one cell, itself left out. */
static inline gmds_status note_neighbours(mesh *m, size_t first, gmds_id but)
{
  gmds_ids_keep(&m->found, first, 1, but);
  const size_t n = m->found.n - first;
  GMDS_TRY(gmds_ids_push(&m->more, (gmds_id)n));
  GMDS_TRY(gmds_ids_reserve(&m->more, m->more.n + n));
  if (n)
    memcpy(m->more.data + m->more.n, m->found.data + first, n * sizeof *m->found.data);
  m->more.n += n;
  return GMDS_OK;
}
#endif

#if GMDS__S_1_1
static inline int edges_touch(const cell_plan *p, size_t e, size_t q)
{
  const gmds_id *a = p->ends + 2 * e, *b = p->ends + 2 * q;
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

static inline gmds_status reserve_beside_edges(mesh *m, const cell_plan *p)
{
  for (size_t e = 0; e < p->n_edges; e++) {
    if (!p->fresh[e])
      continue;
    GMDS_TRY(start_with(&m->found, p->ends + 2 * e, 2));
    GMDS_TRY(hop_0_1(m, &m->found, 0, 2));
    GMDS_TRY(note_neighbours(m, 2, p->edge[e]));
    GMDS__ROOM(1, 1, p->edge[e], m->found.n + p->n_edges);
    for (size_t i = 2; i < m->found.n; i++)
      GMDS__ROOM(1, 1, m->found.data[i], p->n_edges);
  }
  return GMDS_OK;
}
#endif

#if GMDS__S_2_2
static inline int faces_touch(const cell_plan *p, size_t k, size_t q)
{
  for (size_t c = p->begin[k]; c < p->begin[k + 1]; c++)
    for (size_t d = p->begin[q]; d < p->begin[q + 1]; d++)
      if (p->border[c] == p->border[d])
        return 1;
  return 0;
}

static inline gmds_status reserve_beside_faces(mesh *m, const cell_plan *p)
{
  gmds_ids around = {.memory = &m->memory};
  gmds_status status = GMDS_OK;
  for (size_t k = 0; k < p->n_faces && status == GMDS_OK; k++) {
    if (!p->made[k])
      continue;
    around.n = 0;
#  if GMDS__LINKED_0_2 || GMDS__LINKED_1_2
    for (size_t c = p->begin[k]; c < p->begin[k + 1] && status == GMDS_OK; c++) {
      const size_t e = p->border[c];
      status = faces_at_side(m, p->ends[2 * e], p->ends[2 * e + 1], p->fresh[e] ? GMDS_NONE : p->edge[e], &m->found);
      for (size_t i = 0; i < m->found.n && status == GMDS_OK; i++)
        status = gmds_ids_push(&around, m->found.data[i]);
    }
#  endif
    if (status == GMDS_OK)
      status = start_with(&m->found, around.data, around.n);
    if (status == GMDS_OK)
      status = note_neighbours(m, 0, p->face[k]);
    if (status == GMDS_OK)
      status = gmds_rows_reserve(&m->r_2_2, &m->memory, p->face[k], m->found.n + p->n_faces);
    for (size_t i = 0; i < m->found.n && status == GMDS_OK; i++) {
      const gmds_id f = m->found.data[i];
      status = gmds_rows_reserve(&m->r_2_2, &m->memory, f, m->r_2_2.length[f] + p->n_faces);
    }
  }
  gmds_ids_clear(&around);
  return status;
}
#endif

static inline gmds_status reserve_planned(mesh *m, const cell_plan *p)
{
  for (size_t i = 0; i < p->n_nodes; i++) {
    const gmds_id v = p->node[i];
    (void)v;
#if GMDS__S_0_0
    GMDS__ROOM(0, 0, v, p->n_edges);
#endif
#if GMDS__S_0_1
    GMDS__ROOM(0, 1, v, new_edges_at(p, v));
#endif
#if GMDS__S_0_2
    GMDS__ROOM(0, 2, v, new_faces_at(p, v));
#endif
  }
#if GMDS__S_1_2
  for (size_t e = 0; e < p->n_edges; e++)
    GMDS__ROOM(1, 2, p->edge[e], new_faces_on(p, e));
#endif
#define GMDS__ROOM_OF_FACE(i, j) \
  if (p->made[k])                \
    GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, p->face[k], (size_t)(p->begin[k + 1] - p->begin[k])));
  for (size_t k = 0; k < p->n_faces; k++) {
    GMDS__ORDERED_FACES(GMDS__ROOM_OF_FACE)
  }
#undef GMDS__ROOM_OF_FACE
  m->more.n = 0;
#if GMDS__S_1_1
  GMDS_TRY(reserve_beside_edges(m, p));
#endif
#if GMDS__S_2_2
  GMDS_TRY(reserve_beside_faces(m, p));
#endif
  (void)m;
  return GMDS_OK;
}

static inline gmds_status reserve_region(mesh *m, gmds_id r, const cell_plan *p)
{
#if GMDS__S_0_3
  for (size_t i = 0; i < p->n_nodes; i++)
    GMDS__ROOM(0, 3, p->node[i], 1);
#endif
#if GMDS__S_1_3
  for (size_t e = 0; e < p->n_edges; e++)
    GMDS__ROOM(1, 3, p->edge[e], 1);
#endif
#if GMDS__S_2_3
  for (size_t k = 0; k < p->n_faces; k++) {
    size_t n = 0;
    (void)gmds_pairs_get(&m->r_2_3, p->face[k], &n);
    GMDS_TRY(gmds_pairs_reserve(&m->r_2_3, &m->memory, p->face[k], n + 1));
  }
#endif
  const size_t needed[4] = {p->n_nodes, p->n_edges, p->n_faces, p->n_faces};
  (void)needed;
#define GMDS__ROOM_OF_REGION(i, j) GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, r, needed[j]));
  GMDS__ORDERED_REGIONS(GMDS__ROOM_OF_REGION)
#undef GMDS__ROOM_OF_REGION
  (void)m;
  (void)r;
  return GMDS_OK;
}

/* ---- linking: nothing fails any more */

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

/* ---- cells */

/* Finds, takes and makes room for what the plan is made of. On failure nothing is left of it. */
static inline gmds_status prepare_plan(mesh *m, cell_plan *p)
{
  GMDS_TRY(find_planned(m, p));
  gmds_status status = take_planned(m, p);
  if (status == GMDS_OK)
    status = reserve_planned(m, p);
  if (status != GMDS_OK)
    drop_planned(m, p);
  return status;
}

#if GMDS__LINKED_0_1
static inline gmds_status add_edge(mesh *m, gmds_id a, gmds_id b, gmds_id *id)
{
  cell_plan p;
  if (!has_0(m, a) || !has_0(m, b))
    return GMDS_ERR_CELL;
  if (a == b)
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(plan_edge(m, a, b, &p));
  GMDS_TRY(prepare_plan(m, &p));
  link_planned(m, &p);
  *id = p.edge[0];
  return GMDS_OK;
}
#endif

#if GMDS_ADDS_FACES && GMDS__MAKES_FACES
static inline int allows_sides(size_t n)
{
  return (n == 3 && GMDS__TRIANGLES) || (n == 4 && GMDS__QUADRILATERALS) || (n >= 3 && GMDS__POLYGONS);
}

static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  cell_plan p;
  if (!allows_sides(n))
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(check_nodes(m, n, nodes));
  GMDS_TRY(plan_polygon(m, n, nodes, &p));
  GMDS_TRY(prepare_plan(m, &p));
  link_planned(m, &p);
  *id = p.face[0];
  return GMDS_OK;
}

static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id)
{
  const gmds_id nodes[3] = {a, b, c};
  return add_face(m, 3, nodes, id);
}

static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_face(m, 4, nodes, id);
}
#endif

#if GMDS_ADDS_REGIONS
static inline int allows_type(gmds_cell_type type)
{
  return type >= GMDS_TETRAHEDRON && type <= GMDS_HEXAHEDRON &&
         ((unsigned)GMDS_FN(regions) >> (type - GMDS_TETRAHEDRON) & 1);
}

/* Makes the region of a plan whose edges and faces are ready. On failure they are given back. */
static inline gmds_status finish_region(mesh *m, gmds_cell_type type, cell_plan *p, gmds_id *id)
{
  gmds_status status = grow(m, 3, 1);
  if (status == GMDS_OK) {
    gmds_id r = gmds_cells_take(&m->cells[3]);
    status = reserve_region(m, r, p);
    if (status == GMDS_OK) {
      link_planned(m, p);
      link_region(m, r, type, p);
      *id = r;
      return GMDS_OK;
    }
    drop_region(m, r);
  }
  drop_planned(m, p);
  return status;
}

static inline gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id)
{
  cell_plan p;
  if (!allows_type(type))
    return GMDS_ERR_ARGUMENT;
  const gmds_shape *s = gmds_shape_of(type);
  GMDS_TRY(check_nodes(m, s->nodes, nodes));
  GMDS_TRY(plan_shape(m, s, nodes, &p));
  GMDS_TRY(find_planned(m, &p));
#  if GMDS__S_3_3
  GMDS_TRY(find_beyond(m, &p));
#  endif
  gmds_status status = take_planned(m, &p);
  if (status == GMDS_OK)
    status = reserve_planned(m, &p);
  if (status != GMDS_OK) {
    drop_planned(m, &p);
    return status;
  }
  return finish_region(m, type, &p, id);
}

static inline gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_region(m, GMDS_TETRAHEDRON, nodes, id);
}

#  if GMDS__POLYHEDRA
/* Lists the sides of the faces of a polyhedron: each of its edges once, with how many faces have it in p->fresh. */
static inline void plan_sides(const mesh *m, cell_plan *p)
{
  size_t corners = 0, edges = 0, nodes = 0;
  gmds_id *own = p->slot + p->n_faces;
  for (size_t k = 0; k < p->n_faces; k++) {
    size_t n = 0;
    const gmds_id *row = row_2_0(m, p->face[k], &n);
    p->begin[k] = (gmds_id)corners;
    for (size_t i = 0; i < n; i++) {
      const gmds_id a = row[i], b = row[i + 1 < n ? i + 1 : 0];
      size_t e = 0, v = 0;
      while (e < edges && !(p->ends[2 * e] == a && p->ends[2 * e + 1] == b) &&
             !(p->ends[2 * e] == b && p->ends[2 * e + 1] == a))
        e++;
      if (e == edges) {
        p->ends[2 * e] = a;
        p->ends[2 * e + 1] = b;
        p->fresh[edges++] = 0;
      }
      p->fresh[e]++;
      while (v < nodes && own[v] != a)
        v++;
      if (v == nodes)
        own[nodes++] = a;
      p->corner[corners] = a;
      p->border[corners++] = (gmds_id)e;
    }
  }
  p->begin[p->n_faces] = (gmds_id)corners;
  p->n_edges = edges;
  p->n_nodes = nodes;
  p->node = own;
}

static inline gmds_status add_polyhedron(mesh *m, size_t n, const gmds_id *faces, gmds_id *id)
{
  size_t corners = 0;
  cell_plan p;
  for (size_t k = 0; k < n; k++) {
    if (!has_2(m, faces[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; q < k; q++)
      if (faces[q] == faces[k])
        return GMDS_ERR_ARGUMENT;
    corners += m->r_2_0.length[faces[k]];
  }
  GMDS_TRY(n < 4 ? GMDS_ERR_ARGUMENT : begin_plan(m, corners, NULL, corners, n, corners, &p));
  GMDS_TRY(gmds_ids_reserve(&m->plan, m->plan.n + corners));
  GMDS_TRY(begin_plan(m, corners, NULL, corners, n, corners, &p)); /* where the list is now */
  for (size_t k = 0; k < n; k++) {
    p.face[k] = faces[k];
    p.made[k] = p.slot[k] = 0;
    p.beyond[k] = GMDS_NONE;
  }
  plan_sides(m, &p);
  for (size_t e = 0; e < p.n_edges; e++) {
    if (p.fresh[e] != 2) /* the faces do not close */
      return GMDS_ERR_ARGUMENT;
    p.fresh[e] = 0;
    p.edge[e] = GMDS_NONE;
#    if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
    p.edge[e] = find_edge(m, p.ends[2 * e], p.ends[2 * e + 1]);
    if (p.edge[e] == GMDS_NONE)
      return GMDS_ERR_INVARIANT;
#    endif
  }
#    if GMDS__S_3_3
  GMDS_TRY(find_beyond(m, &p));
#    endif
#    if GMDS__S_0_0
  GMDS_TRY(reserve_planned(m, &p));
#    endif
  return finish_region(m, GMDS_POLYHEDRON, &p, id);
}
#  endif
#endif
