/* The plan of a creation: what the new cell is made of is looked up, identifiers are taken, room is made in every row.
 * All of this may fail, and then what was taken is given back; nothing is linked yet. */

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

/* Looks up the edges and faces of the plan: GMDS_NONE where there is none yet. Also GMDS_ERR_CONFLICT (find_face). */
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
    GMDS_TRY(
        find_face(m, p->begin[k + 1] - p->begin[k], p->corner + p->begin[k], m->more.data, &m->found, &p->face[k]));
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

/* GMDS_ERR_CONFLICT where region s has the face of n nodes with others of them side by side. */
static inline gmds_status check_wall(const mesh *m, gmds_id s, size_t n, const gmds_id *nodes)
{
  (void)m;
  (void)s;
  (void)n;
  (void)nodes;
#  if !GMDS__SIMPLICIAL && GMDS__LISTS_WALLS
  const gmds_id k = n > 3 ? find_wall(m, s, n, nodes) : GMDS_NONE;
  if (k == GMDS_NONE)
    return GMDS_OK;
  gmds_id room[4];
  size_t sides = 0;
  const gmds_id *wall = wall_nodes(m, s, k, room, &sides);
  for (size_t i = 0; i < n; i++)
    if (!follow_each_other(wall, n, nodes[i], nodes[i + 1 < n ? i + 1 : 0]))
      return GMDS_ERR_CONFLICT;
#  endif
  return GMDS_OK;
}

/* Looks up the region beyond each face. GMDS_ERR_CONFLICT: there are two already, or it has the nodes in another
 * order. */
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
    GMDS_TRY(check_wall(m, p->beyond[k], n, nodes));
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
#  define GMDS__CLEAR_FACE(i, j)                 \
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
