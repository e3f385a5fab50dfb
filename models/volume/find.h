/* Finding what is there before a cell is made or removed: the edge between two nodes, the face on some nodes, the faces
 * on an edge, the regions on a face. By the shortest way that the stored relations allow. */

#if GMDS__LINKED_0_1
/* The edge between nodes a and b, or GMDS_NONE. O(edges at a) with N2E, else a traversal of E2N. */
static inline gmds_id find_edge(const mesh *m, gmds_id a, gmds_id b)
{
#  if GMDS__S_0_1
  gmds_id from = m->r_0_1.length[a] < m->r_0_1.length[b] ? a : b, to = from == a ? b : a;
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(&m->r_0_1, from, &n);
  for (size_t k = 0; k < n; k++) {
#    if GMDS__S_1_0
    const gmds_id *ends = m->r_1_0.data + 2 * (size_t)row[k];
    if ((ends[0] == to) | (ends[1] == to))
      return row[k];
#    else
    if (gmds_rows_find(&m->r_0_1, to, row[k]) != GMDS_NONE)
      return row[k];
#    endif
  }
  return GMDS_NONE;
#  else
  return gmds_find_pair(m->r_1_0.data, &m->cells[1].alive, m->cells[1].end, a, b);
#  endif
}
#endif

/* Copies n cells into a list that is emptied first. */
static inline gmds_status start_with(gmds_ids *list, const gmds_id *cells, size_t n)
{
  list->n = 0;
  GMDS_TRY(gmds_ids_reserve(list, n));
  if (n)
    memcpy(list->data, cells, n * sizeof *cells);
  list->n = n;
  return GMDS_OK;
}

/* Whether one of n cells is none. */
static inline int lacks_one(const gmds_id *cells, size_t n)
{
  for (size_t k = 0; k < n; k++)
    if (cells[k] == GMDS_NONE)
      return 1;
  return 0;
}

#if GMDS__LINKED_0_2 || GMDS__LINKED_1_2
/* How many sides face f has. The list serves as a stack. */
static inline gmds_status count_sides(const mesh *m, gmds_id f, gmds_ids *list, size_t *sides)
{
  (void)m;
  (void)f;
  (void)list;
#  if GMDS__SIDES
  *sides = GMDS__SIDES;
#  elif GMDS__S_2_0
  *sides = m->r_2_0.length[f];
#  elif GMDS__S_2_1
  *sides = m->r_2_1.length[f];
#  else
  const size_t end = list->n;
  GMDS_TRY(gmds_ids_push(list, f));
#    if GMDS__LINKED_0_2
  GMDS_TRY(hop_2_0(m, list, end, end + 1));
#    else
  GMDS_TRY(hop_2_1(m, list, end, end + 1));
#    endif
  *sides = list->n - end - 1;
  list->n = end;
#  endif
  return GMDS_OK;
}
#endif

#if !GMDS__SIMPLICIAL && (GMDS__LINKED_0_2 || GMDS__LINKED_1_2)
/* GMDS_ERR_CONFLICT where face f, which has these n nodes, has others of them side by side. */
static inline gmds_status check_sides(const mesh *m, gmds_id f, size_t n, const gmds_id *nodes, const gmds_id *edges,
                                      gmds_ids *list)
{
  (void)m;
  (void)f;
  (void)nodes;
  (void)edges;
  (void)list;
  if (n < 4)
    return GMDS_OK;
#  if GMDS__S_2_0
  for (size_t k = 0; k < n; k++)
    if (!has_side(m, f, nodes[k], nodes[k + 1 < n ? k + 1 : 0]))
      return GMDS_ERR_CONFLICT;
#  elif GMDS__LINKED_0_1
  if (lacks_one(edges, n)) /* those of a face are there */
    return GMDS_ERR_CONFLICT;
#    if GMDS__LINKED_1_2
  list->n = 0;
  GMDS_TRY(gmds_ids_push(list, f));
  GMDS_TRY(hop_2_1(m, list, 0, 1));
  for (size_t k = 0; k < n; k++)
    if (!gmds_ids_has(list, edges[k]))
      return GMDS_ERR_CONFLICT;
#    endif
#  endif
  return GMDS_OK;
}

#  if GMDS__LINKED_0_1 && GMDS__LINKED_1_2 && !(GMDS__LINKED_0_2 && !(GMDS__S_1_2 && !GMDS__S_0_2))
/* Whether face f has these n nodes. */
static inline gmds_status has_nodes(const mesh *m, gmds_id f, size_t n, const gmds_id *nodes, gmds_ids *list, int *has)
{
  const size_t end = list->n;
  size_t sides = 0, found = 0;
  GMDS_TRY(count_sides(m, f, list, &sides));
  if (sides == n) {
    GMDS_TRY(gmds_ids_push(list, f));
    GMDS_TRY(hop_2_1(m, list, end, end + 1));
    const size_t first = list->n;
    GMDS_TRY(hop_1_0(m, list, end + 1, first));
    gmds_ids_keep(list, first, 1, GMDS_NONE);
    for (size_t k = first; k < list->n; k++)
      for (size_t q = 0; q < n; q++)
        found += list->data[k] == nodes[q];
  }
  list->n = end;
  *has = found == n;
  return GMDS_OK;
}

/* GMDS_ERR_CONFLICT where a face has these n nodes, but not these edges. Two quadrilaterals of the same nodes have two
 * sides in common, opposite ones; other polygons may have none. */
static inline gmds_status find_crossed(const mesh *m, size_t n, const gmds_id *nodes, const gmds_id *edges,
                                       gmds_ids *list)
{
  const size_t rounds = n > 4 ? 1 : n == 4 ? 2 : 0;
  for (size_t round = 0; round < rounds; round++) {
    const gmds_id opposite[2] = {edges[round], edges[round + 2]};
    size_t first = 2;
    if (n == 4 && lacks_one(opposite, 2))
      continue;
    GMDS_TRY(n == 4 ? start_with(list, opposite, 2) : start_with(list, nodes, 1));
    if (n == 4)
      GMDS_TRY(meet_1_2(m, list, 0, 2, 2));
    else {
      GMDS_TRY(hop_0_1(m, list, 0, 1));
      first = list->n;
      GMDS_TRY(hop_1_2(m, list, 1, first));
    }
    for (size_t k = first, end = list->n; k < end; k++) {
      int has = 0;
      GMDS_TRY(has_nodes(m, list->data[k], n, nodes, list, &has));
      if (has)
        return GMDS_ERR_CONFLICT;
    }
  }
  return GMDS_OK;
}
#    define GMDS__FINDS_CROSSED 1
#  endif
#endif

/* The face with just these n nodes, or GMDS_NONE. edges: those of its sides, where edges are kept. Also
 * GMDS_ERR_CONFLICT: one has these nodes in another order around. */
static inline gmds_status find_face(const mesh *m, size_t n, const gmds_id *nodes, const gmds_id *edges, gmds_ids *list,
                                    gmds_id *face)
{
  *face = GMDS_NONE;
  (void)m;
  (void)n;
  (void)nodes;
  (void)edges;
  (void)list;
#if GMDS__LINKED_0_2 || GMDS__LINKED_1_2
#  if GMDS__LINKED_0_2 && !(GMDS__S_1_2 && !GMDS__S_0_2)
  GMDS_TRY(start_with(list, nodes, n));
  GMDS_TRY(meet_0_2(m, list, 0, n, n));
#  else
  GMDS_TRY(start_with(list, edges, n));
  if (!lacks_one(edges, n))
    GMDS_TRY(meet_1_2(m, list, 0, n, n));
#  endif
  for (size_t k = n, end = list->n; k < end && *face == GMDS_NONE; k++) {
    size_t sides = 0;
    GMDS_TRY(count_sides(m, list->data[k], list, &sides));
    if (sides == n)
      *face = list->data[k];
  }
#  if defined GMDS__FINDS_CROSSED
  if (*face == GMDS_NONE)
    return find_crossed(m, n, nodes, edges, list);
#  elif !GMDS__SIMPLICIAL
  if (*face != GMDS_NONE)
    return check_sides(m, *face, n, nodes, edges, list);
#  endif
#endif
  return GMDS_OK;
}
#undef GMDS__FINDS_CROSSED

#if GMDS__K_2 && (GMDS__LINKED_0_2 || GMDS__LINKED_1_2)
/* Fills the list with the faces on the side from a to b; e is the edge there where edges and nodes are linked. */
static inline gmds_status faces_at_side(const mesh *m, gmds_id a, gmds_id b, gmds_id e, gmds_ids *list)
{
  list->n = 0;
#  if GMDS__LINKED_1_2 && (GMDS__S_1_2 || !(GMDS__LINKED_0_2 && GMDS__KNOWS_SIDES))
  (void)a;
  (void)b;
  if (e == GMDS_NONE)
    return GMDS_OK;
  GMDS_TRY(gmds_ids_push(list, e));
  GMDS_TRY(hop_1_2(m, list, 0, 1));
  return end_answer(list, 1);
#  else
  (void)e;
  GMDS_TRY(gmds_ids_push(list, a));
  GMDS_TRY(gmds_ids_push(list, b));
  GMDS_TRY(meet_0_2(m, list, 0, 2, 2));
#    if !GMDS__SIMPLICIAL
  size_t kept = 2;
  for (size_t k = 2; k < list->n; k++)
    if (has_side(m, list->data[k], a, b))
      list->data[kept++] = list->data[k];
  list->n = kept;
#    endif
  return end_answer(list, 2);
#  endif
}
#endif

#if GMDS__LINKED_0_3 || GMDS__LINKED_1_3 || GMDS__LINKED_2_3
/* Fills the list with the regions that have the face of n nodes; its edges and itself where they are kept. */
static inline gmds_status regions_on(const mesh *m, size_t n, const gmds_id *nodes, const gmds_id *edges, gmds_id face,
                                     gmds_ids *list)
{
  list->n = 0;
  (void)n;
  (void)nodes;
  (void)edges;
  (void)face;
#  if GMDS__LINKED_2_3 && (GMDS__S_2_3 || !(GMDS__S_0_3 && GMDS__KNOWS_WALLS))
  if (face == GMDS_NONE)
    return GMDS_OK;
  GMDS_TRY(gmds_ids_push(list, face));
  GMDS_TRY(hop_2_3(m, list, 0, 1));
  return end_answer(list, 1);
#  else
#    if GMDS__LINKED_0_3
  GMDS_TRY(start_with(list, nodes, n));
  GMDS_TRY(meet_0_3(m, list, 0, n, n));
#    else
  if (lacks_one(edges, n))
    return GMDS_OK;
  GMDS_TRY(start_with(list, edges, n));
  GMDS_TRY(meet_1_3(m, list, 0, n, n));
#    endif
#    if !GMDS__SIMPLICIAL && GMDS__LISTS_WALLS
  size_t kept = n;
  for (size_t k = n; k < list->n; k++)
    if (find_wall(m, list->data[k], n, nodes) != GMDS_NONE)
      list->data[kept++] = list->data[k];
  list->n = kept;
#    endif
  return end_answer(list, n);
#  endif
}
#endif

/* Fills the list with the regions that have an edge from a to b. In models that store N2N without edges and faces. */
#if GMDS__S_0_0 && !GMDS__LINKED_0_1 && !GMDS__LINKED_0_2 && GMDS__LINKED_0_3
static inline gmds_status regions_at_rim(const mesh *m, gmds_id a, gmds_id b, gmds_ids *list)
{
  const gmds_id ends[2] = {a, b};
  GMDS_TRY(start_with(list, ends, 2));
  GMDS_TRY(meet_0_3(m, list, 0, 2, 2));
#  if !GMDS__SIMPLICIAL && GMDS__LISTS_WALLS
  size_t kept = 2;
  for (size_t k = 2; k < list->n; k++) {
    int has = 0;
    GMDS_TRY(has_rim(m, list->data[k], a, b, list, &has));
    if (has)
      list->data[kept++] = list->data[k];
  }
  list->n = kept;
#  endif
  return end_answer(list, 2);
}
#endif
