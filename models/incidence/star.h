/* The cavity operator: a tree of triangles is replaced by the triangles that join its boundary to a node. What a
 * Bowyer-Watson insertion does, in one elementary operation: since the caller knows the cavity, nothing needs to be
 * looked up where faces know their neighbours or edges, whatever the model; old identifiers are used again, so that a
 * million insertions leave no hole. */

#if GMDS__TRIANGLES && GMDS__CAN_2_0 && !GMDS__S_1_1
#  if GMDS__MAKES_EDGES
/* The edge at side `side` (from a to b) of face f, beyond which lies g. */
static inline gmds_status edge_at(mesh *m, gmds_id f, unsigned side, gmds_id a, gmds_id b, gmds_id g, gmds_id *edge)
{
  (void)f;
  (void)side;
  (void)a;
  (void)b;
  (void)g;
#    if GMDS_ORDERED_2_0 && GMDS__S_2_1
  size_t n = 0;
  *edge = row_2_1(m, f, &n)[side];
  return GMDS_OK;
#    elif GMDS__LINKED_EDGES
  *edge = find_edge(m, a, b);
  return *edge == GMDS_NONE ? GMDS_ERR_INVARIANT : GMDS_OK;
#    else
  /* edges that do not know their nodes: the one that bounds f and g */
  m->found.n = 0;
  GMDS_TRY(gmds_ids_push(&m->found, f));
  GMDS_TRY(hop_2_1(m, &m->found, 0, 1));
  size_t edges = m->found.n;
  for (size_t i = 1; i < edges; i++) {
    m->found.n = edges;
    GMDS_TRY(hop_1_2(m, &m->found, i, i + 1));
    int has_g = g == GMDS_NONE && m->found.n == edges + 1;
    for (size_t k = edges; k < m->found.n; k++)
      has_g |= m->found.data[k] == g;
    if (has_g) {
      *edge = m->found.data[i];
      return GMDS_OK;
    }
  }
  return GMDS_ERR_INVARIANT;
#    endif
}
#  endif

/* Whether rows or pairs hold faces: then it pays to let the new face on a side have the number of the old one there.
 * Two of its nodes and the edge between them know it already. Likewise an edge inside the cavity becomes a spoke of the
 * star, one that joins the apex to a node of the boundary, where possible at one of its ends. */
#  define GMDS__KEEPS_FACES (GMDS__S_0_2 || GMDS__S_1_2)

/* What a star uses again. The arrays lie in m->plan. */
typedef struct star_plan {
  gmds_id *boundary; /* the edge on each side */
  gmds_id *spoke;    /* the edge from sides[i].a to the apex; GMDS_NONE: one is taken later */
  gmds_id *inner;    /* the edge over which each face of the cavity was reached; the root's is GMDS_NONE */
  gmds_id *spoke_of; /* of which side each of them is the spoke that keeps its end there, or GMDS_NONE */
  gmds_id *side_of;  /* the side on which each number of a face of the cavity stays, or GMDS_NONE */
  gmds_id
      *keeps; /* for each side the face of the cavity whose inner edge is its spoke and keeps its end, or GMDS_NONE */
} star_plan;

#  if GMDS__MAKES_EDGES
/* The edge inside the cavity over which face j was reached. */
static inline gmds_status inner_edge(mesh *m, const gmds_cavity_face *faces, size_t j, gmds_id *edge)
{
  const gmds_cavity_face *c = &faces[j];
  *edge = GMDS_NONE;
#    if GMDS__LINKED_EDGES || (GMDS_ORDERED_2_0 && GMDS__S_2_1)
  return edge_at(m, c->face, c->side, c->node[0], c->node[1], GMDS_NONE, edge);
#    else
  /* the face on the other side is the one of the cavity that has both nodes */
  for (size_t q = 0; q < j && *edge == GMDS_NONE; q++) {
    int shared = 0;
    for (int k = 0; k < 3; k++)
      shared += faces[q].node[k] == c->node[0] || faces[q].node[k] == c->node[1];
    if (shared == 2)
      GMDS_TRY(edge_at(m, c->face, 0, c->node[0], c->node[1], faces[q].face, edge));
  }
  return GMDS_OK;
#    endif
}

/* Makes inner edge j the spoke of a side that begins at one of its ends. Of a large cavity none is looked for. */
static inline void keep_spoke(star_plan *plan, size_t j, const gmds_cavity_face *c, size_t n_sides,
                              const gmds_cavity_side *sides)
{
  enum { LARGE = 32 };
  for (size_t i = 0; i < n_sides && n_sides <= LARGE; i++)
    if ((sides[i].a == c->node[0] || sides[i].a == c->node[1]) && plan->spoke[i] == GMDS_NONE) {
      plan->spoke[i] = plan->inner[j];
      plan->keeps[i] = (gmds_id)j;
      plan->spoke_of[j] = (gmds_id)i;
      return;
    }
}
#  endif

/* Fills the plan. */
static inline gmds_status plan_star(mesh *m, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                                    const gmds_cavity_side *sides, star_plan *plan)
{
  (void)faces;
  (void)sides;
#  if GMDS__MAKES_EDGES || GMDS__KEEPS_FACES
  size_t n = 3 * n_sides + 3 * n_faces;
  m->plan.n = 0;
  GMDS_TRY(gmds_ids_reserve(&m->plan, n));
  for (size_t k = 0; k < n; k++)
    m->plan.data[k] = GMDS_NONE;
  plan->boundary = m->plan.data;
  plan->spoke = plan->boundary + n_sides;
  plan->keeps = plan->spoke + n_sides;
  plan->inner = plan->keeps + n_sides;
  plan->spoke_of = plan->inner + n_faces;
  plan->side_of = plan->spoke_of + n_faces;
#  else
  (void)m;
  (void)n_faces;
  (void)n_sides;
  (void)plan;
#  endif
#  if GMDS__KEEPS_FACES
  for (size_t i = 0; i < n_sides; i++)
    if (plan->side_of[sides[i].in] == GMDS_NONE)
      plan->side_of[sides[i].in] = (gmds_id)i;
#  endif
#  if GMDS__MAKES_EDGES
#    if GMDS__S_1_2 || GMDS__S_2_1 /* else no relation of the edges on the boundary changes */
  for (size_t i = 0; i < n_sides; i++) {
    const gmds_cavity_side *s = &sides[i];
    if (!GMDS__S_2_1 && plan->side_of[s->in] == i)
      continue; /* the edge knows the face already, and no face knows the edge */
    GMDS_TRY(
        edge_at(m, faces[s->in].face, (faces[s->in].side + s->in_side) % 3, s->a, s->b, s->out, &plan->boundary[i]));
  }
#    endif
  for (size_t j = 1; j < n_faces; j++) {
    GMDS_TRY(inner_edge(m, faces, j, &plan->inner[j]));
    keep_spoke(plan, j, &faces[j], n_sides, sides);
  }
  GMDS_TRY(grow(m, 1, 3));
#  endif
  return GMDS_OK;
}

/* Room in the rows of nodes for what the star adds at most. */
static inline gmds_status reserve_star(mesh *m, gmds_id apex, size_t n_sides, const gmds_cavity_side *sides)
{
  (void)m;
  (void)apex;
  (void)sides;
  (void)n_sides;
#  define GMDS__RESERVE_STAR(i, j)                                                                           \
    if (i == 0) {                                                                                            \
      GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, apex, m->r_##i##_##j.length[apex] + n_sides)); \
      for (size_t k = 0; k < n_sides; k++)                                                                   \
        GMDS_TRY(gmds_rows_reserve(&m->r_##i##_##j, &m->memory, sides[k].a,                                  \
                                   m->r_##i##_##j.length[sides[k].a] + (size_t)1));                          \
    }
  GMDS__EACH_SET(GMDS__RESERVE_STAR)
#  undef GMDS__RESERVE_STAR
  return GMDS_OK;
}

/* Takes what the star has more than the cavity, two faces and three edges, with room in their rows. On failure nothing
 * is taken. */
static inline gmds_status take_star(mesh *m, size_t n_faces, size_t n_sides, star_plan *plan, gmds_id fresh[2])
{
  gmds_status status = GMDS_OK;
  (void)n_faces;
  (void)n_sides;
  (void)plan;
  for (int i = 0; i < 2; i++)
    fresh[i] = gmds_cells_take(&m->cells[2]);
#  define GMDS__RESERVE_NEW(a, b)                    \
    for (int i = 0; i < 2 && status == GMDS_OK; i++) \
      status = gmds_rows_reserve(&m->r_##a##_##b, &m->memory, fresh[i], 3);
  GMDS__EACH_ORDERED(GMDS__RESERVE_NEW)
#  undef GMDS__RESERVE_NEW
  if (status != GMDS_OK) {
    for (int i = 2; i-- > 0;)
      drop_face(m, fresh[i]);
    return status;
  }
#  define GMDS__FILL_NEW(a, b)    \
    for (int i = 0; i < 2; i++)   \
      for (int k = 0; k < 3; k++) \
        gmds_rows_push(&m->r_##a##_##b, fresh[i], GMDS_NONE);
  GMDS__EACH_ORDERED(GMDS__FILL_NEW)
#  undef GMDS__FILL_NEW
#  if GMDS__MAKES_EDGES
  size_t j = 1;
  for (size_t i = 0; i < n_sides; i++) {
    if (plan->spoke[i] != GMDS_NONE)
      continue;
    while (j < n_faces && plan->spoke_of[j] != GMDS_NONE)
      j++;
    plan->spoke[i] = j < n_faces ? plan->inner[j++] : gmds_cells_take(&m->cells[1]);
  }
#  endif
  return GMDS_OK;
}

/* The numbers of the star's faces: where a number stays on a side, it; else one of a face without a side, or a fresh
 * one. */
static inline void number_star(const star_plan *plan, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                               const gmds_cavity_side *sides, const gmds_id fresh[2], gmds_id *ids)
{
  (void)plan;
  (void)sides;
#  if GMDS__KEEPS_FACES
  size_t j = 0, used = 0;
  for (size_t i = 0; i < n_sides; i++) {
    if (plan->side_of[sides[i].in] == i) {
      ids[i] = faces[sides[i].in].face;
      continue;
    }
    while (j < n_faces && plan->side_of[j] != GMDS_NONE)
      j++;
    ids[i] = j < n_faces ? faces[j++].face : fresh[used++];
  }
#  else
  for (size_t i = 0; i < n_faces; i++)
    ids[i] = faces[i].face;
  ids[n_sides - 2] = fresh[0];
  ids[n_sides - 1] = fresh[1];
#  endif
}

/* Makes nodes and faces outside forget the cavity. */
static inline void forget_cavity(mesh *m, const star_plan *plan, size_t n_faces, const gmds_cavity_face *faces,
                                 size_t n_sides, const gmds_cavity_side *sides)
{
  (void)m;
  (void)plan;
  (void)n_faces;
  (void)faces;
  (void)n_sides;
  (void)sides;
#  if GMDS__S_0_2
  for (size_t j = 0; j < n_faces; j++) {
    const gmds_id kept = plan->side_of[j]; /* its side's nodes keep the face */
    for (unsigned k = 0; k < 3; k++)
      if (kept == GMDS_NONE || k == (sides[kept].in_side + 2) % 3)
        gmds_rows_remove(&m->r_0_2, faces[j].node[k], faces[j].face);
  }
#  endif
#  if GMDS__S_0_1
  for (size_t j = 1; j < n_faces; j++)
    for (int k = 0; k < 2; k++)
      if (plan->spoke_of[j] == GMDS_NONE || sides[plan->spoke_of[j]].a != faces[j].node[k])
        gmds_rows_remove(&m->r_0_1, faces[j].node[k], plan->inner[j]);
#  endif
#  if GMDS__S_0_0
  for (size_t j = 1; j < n_faces; j++)
    unjoin(m, faces[j].node[0], faces[j].node[1]);
#  endif
#  if GMDS__S_2_2 && !GMDS_ORDERED_2_0
  /* identifiers are used again: the entries to change are marked before any is changed */
  for (size_t i = 0; i < n_sides; i++) {
    size_t n = 0;
    if (sides[i].out == GMDS_NONE)
      continue;
    gmds_id *row = row_2_2(m, sides[i].out, &n);
    size_t k = 0;
    while (k < n && row[k] != faces[sides[i].in].face)
      k++;
    if (k < n)
      row[k] = GMDS_NONE - 1 - (gmds_id)i;
  }
#  endif
}

/* Links the nodes with the edges of the star, and these with their nodes and faces. */
static inline void star_edge(mesh *m, const star_plan *plan, gmds_id apex, size_t i, size_t n_sides,
                             const gmds_cavity_side *sides, const gmds_cavity_face *faces, const gmds_id *ids)
{
  gmds_id a = sides[i].a;
  (void)m;
  (void)plan;
  (void)apex;
  (void)n_sides;
  (void)faces;
  (void)ids;
  (void)a;
#  if GMDS__S_0_0
  gmds_rows_push(&m->r_0_0, a, apex);
  gmds_rows_push(&m->r_0_0, apex, a);
#  endif
#  if GMDS__MAKES_EDGES
  gmds_id e = plan->spoke[i], on_boundary = plan->boundary[i];
  (void)e;
  (void)on_boundary;
#    if GMDS__S_1_0
  m->r_1_0.data[2 * (size_t)e] = a;
  m->r_1_0.data[2 * (size_t)e + 1] = apex;
#    endif
#    if GMDS__S_0_1
  if (plan->keeps[i] == GMDS_NONE)
    gmds_rows_push(&m->r_0_1, a, e);
  gmds_rows_push(&m->r_0_1, apex, e);
#    endif
#    if GMDS__S_1_2
  gmds_pairs_empty(&m->r_1_2, e);
  gmds_pairs_push(&m->r_1_2, e, ids[i > 0 ? i - 1 : n_sides - 1]);
  gmds_pairs_push(&m->r_1_2, e, ids[i]);
  if (ids[i] != faces[sides[i].in].face)
    gmds_pairs_replace(&m->r_1_2, on_boundary, faces[sides[i].in].face, ids[i]);
#    endif
#  endif
}

/* Writes the rows of face i of the star, whose nodes are sides[i].a, sides[i].b and the apex. */
static inline void star_face(mesh *m, const star_plan *plan, gmds_id apex, size_t i, size_t n_sides,
                             const gmds_cavity_side *sides, const gmds_id *ids)
{
  const gmds_cavity_side *s = &sides[i];
  gmds_id f = ids[i];
  size_t next = i + 1 < n_sides ? i + 1 : 0, before = i > 0 ? i - 1 : n_sides - 1, n = 0;
  (void)apex;
  (void)plan;
  (void)m;
  (void)f;
  (void)next;
  (void)before;
  (void)n;
  (void)s;
#  if GMDS__S_2_0
  gmds_id *node = (gmds_id *)row_2_0(m, f, &n);
  node[0] = s->a;
  node[1] = s->b;
  node[2] = apex;
#  endif
#  if GMDS__S_2_1
  gmds_id *edge = row_2_1(m, f, &n);
  edge[0] = plan->boundary[i];
  edge[1] = plan->spoke[next];
  edge[2] = plan->spoke[i];
#  endif
#  if GMDS__S_2_2
  gmds_id *face = row_2_2(m, f, &n);
  face[0] = GMDS__CODED && s->out != GMDS_NONE ? 4 * s->out + s->out_side : s->out;
  face[1] = GMDS__CODED ? 4 * ids[next] + 2 : ids[next];
  face[2] = GMDS__CODED ? 4 * ids[before] + 1 : ids[before];
#  endif
#  if GMDS__S_0_2
  if (plan->side_of[s->in] != i) {
    gmds_rows_push(&m->r_0_2, s->a, f);
    gmds_rows_push(&m->r_0_2, s->b, f);
  }
  gmds_rows_push(&m->r_0_2, apex, f);
#  endif
}

#  if GMDS__S_2_2
/* Points the face beyond side i to the new face there. */
static inline void relink_outside(mesh *m, size_t i, const gmds_cavity_side *s, gmds_id f)
{
  size_t n = 0;
  (void)i;
  if (s->out == GMDS_NONE)
    return;
  gmds_id *row = row_2_2(m, s->out, &n);
#    if GMDS_ORDERED_2_0
  row[s->out_side] = GMDS__CODED ? 4 * f : f;
#    else
  for (size_t k = 0; k < n; k++)
    if (row[k] == GMDS_NONE - 1 - (gmds_id)i)
      row[k] = f;
#    endif
}
#  endif

static inline void write_star(mesh *m, const star_plan *plan, gmds_id apex, size_t n_faces,
                              const gmds_cavity_face *faces, size_t n_sides, const gmds_cavity_side *sides,
                              const gmds_id *ids)
{
  forget_cavity(m, plan, n_faces, faces, n_sides, sides);
  for (size_t i = 0; i < n_sides; i++) {
    star_edge(m, plan, apex, i, n_sides, sides, faces, ids);
    star_face(m, plan, apex, i, n_sides, sides, ids);
#  if GMDS__S_2_2
    relink_outside(m, i, &sides[i], ids[i]);
#  endif
  }
}

static inline gmds_status star(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                               const gmds_cavity_side *sides, gmds_id *ids)
{
  star_plan plan;
  gmds_id fresh[2];
  if (!n_faces || n_sides != n_faces + 2)
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(grow(m, 2, 2));
  GMDS_TRY(plan_star(m, n_faces, faces, n_sides, sides, &plan));
  GMDS_TRY(reserve_star(m, apex, n_sides, sides));
  GMDS_TRY(take_star(m, n_faces, n_sides, &plan, fresh));
  number_star(&plan, n_faces, faces, n_sides, sides, fresh, ids);
  write_star(m, &plan, apex, n_faces, faces, n_sides, sides, ids);
  return GMDS_OK;
}

#  if GMDS_CONCURRENT_STARS
static inline gmds_status take_faces(mesh *m, size_t n, gmds_id *first)
{
  size_t end = m->cells[2].end;
  if (n > m->cells[2].limit || end > m->cells[2].limit - n)
    return GMDS_ERR_TOO_MANY;
  if (end + n > m->cells[2].capacity)
    GMDS_TRY(resize_columns(m, 2, end + n));
  *first = gmds_cells_take_many(&m->cells[2], n);
  return GMDS_OK;
}

static inline void drop_faces(mesh *m, gmds_id first, size_t n)
{
  for (size_t k = n; k-- > 0;)
    gmds_cells_drop(&m->cells[2], first + (gmds_id)k);
}

static inline void star_of(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                           const gmds_cavity_side *sides, gmds_id *ids)
{
  for (size_t i = 0; i < n_faces; i++)
    ids[i] = faces[i].face;
  write_star(m, NULL, apex, n_faces, faces, n_sides, sides, ids);
}
#  endif
#endif
