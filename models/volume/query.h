/* Queries. Along the rows of the tables, whose expansion in answer.h is their text; where cells are no simplices, what
 * a multiplicity lets through is held against the nodes that cells keep in order. */

#include <gmds/models/volume/relations.h>

/* ---- the nodes of cells */

/* Faces list their edges (F2E) and these their nodes: node k is what edges k - 1 and k share. */
#if !GMDS__S_2_0 && GMDS_ORDERED_2_0
static inline void chain_of_face(const gmds_id *edges, const gmds_id *ends, size_t n, gmds_id *nodes)
{
  for (size_t k = 0; k < n; k++) {
    const gmds_id *a = ends + 2 * (size_t)edges[k > 0 ? k - 1 : n - 1], *b = ends + 2 * (size_t)edges[k];
    nodes[k] = a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
  }
}
#endif

static inline gmds_cell_type region_type(const mesh *m, gmds_id r)
{
#if GMDS__TYPED
  return (gmds_cell_type)m->types[r];
#else
  (void)m;
  (void)r;
  return GMDS__CORNERS == 4   ? GMDS_TETRAHEDRON
         : GMDS__CORNERS == 5 ? GMDS_PYRAMID
         : GMDS__CORNERS == 6 ? GMDS_PRISM
                              : GMDS_HEXAHEDRON;
#endif
}

#if GMDS_ORDERED_3_0
/* The nodes of region r in the order of its type: stored, or what its edges (R2E with E2N) share. */
static inline const gmds_id *corners_of(const mesh *m, gmds_id r, gmds_id room[GMDS_SHAPE_NODES])
{
  size_t n = 0;
#  if GMDS__S_3_0
  (void)room;
  return row_3_0(m, r, &n);
#  else
  const gmds_shape *s = gmds_shape_of(region_type(m, r));
  const gmds_id *edges = row_3_1(m, r, &n), *ends = m->r_1_0.data;
  for (unsigned v = 0; v < s->nodes; v++) {
    const gmds_id *a = NULL, *b = NULL; /* two edges at local node v */
    for (unsigned e = 0; e < s->edges; e++)
      if (s->edge[e][0] == v || s->edge[e][1] == v) {
        b = a;
        a = ends + 2 * (size_t)edges[e];
      }
    room[v] = a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
  }
  return room;
#  endif
}
#endif

/* The nodes around local face k of region r can be listed, face by face. */
#define GMDS__LISTS_WALLS (GMDS_ORDERED_3_0 || (GMDS__S_3_2 && GMDS__S_2_0))

#if GMDS__LISTS_WALLS
static inline size_t region_walls(const mesh *m, gmds_id r)
{
#  if GMDS__WALLS
  (void)m;
  (void)r;
  return GMDS__WALLS;
#  elif GMDS__S_3_2
  return m->r_3_2.length[r];
#  else
  return gmds_shape_of(region_type(m, r))->faces;
#  endif
}

static inline const gmds_id *wall_nodes(const mesh *m, gmds_id r, size_t k, gmds_id room[4], size_t *n)
{
#  if GMDS_ORDERED_3_0
  gmds_id space[GMDS_SHAPE_NODES];
  const gmds_id *corners = corners_of(m, r, space);
  const gmds_shape *s = gmds_shape_of(region_type(m, r));
  *n = s->sides[k];
  for (size_t i = 0; i < *n; i++)
    room[i] = corners[s->face[k][i]];
  return room;
#  else
  size_t walls = 0;
  (void)room;
  return row_2_0(m, row_3_2(m, r, &walls)[k], n);
#  endif
}

/* The number of the face of region r with just these n nodes, or GMDS_NONE. */
static inline gmds_id find_wall(const mesh *m, gmds_id r, size_t n, const gmds_id *nodes)
{
  size_t walls = region_walls(m, r);
  for (size_t k = 0; k < walls; k++) {
    gmds_id room[4];
    size_t sides = 0, common = 0;
    const gmds_id *wall = wall_nodes(m, r, k, room, &sides);
    for (size_t i = 0; i < n && sides == n; i++)
      for (size_t j = 0; j < n; j++)
        common += nodes[i] == wall[j];
    if (sides == n && common == n)
      return (gmds_id)k;
  }
  return GMDS_NONE;
}
#endif

/* ---- is it, when shared nodes alone do not tell? The lists serve as a stack: what lies behind `n` is free. */

static inline int follow_each_other(const gmds_id *v, size_t n, gmds_id a, gmds_id b)
{
  for (size_t k = 0, next = n - 1; k < n; next = k++)
    if ((v[k] == a && v[next] == b) || (v[k] == b && v[next] == a))
      return 1;
  return 0;
}

#if !GMDS__SIMPLICIAL
/* Whether nodes a and b follow each other around face f. Where F2N is stored. */
static inline int has_side(const mesh *m, gmds_id f, gmds_id a, gmds_id b)
{
#  if GMDS__S_2_0
  size_t n = 0;
  const gmds_id *v = row_2_0(m, f, &n);
  return follow_each_other(v, n, a, b);
#  else
  (void)m;
  (void)f;
  (void)a;
  (void)b;
  return 1; /* triangles, or never asked */
#  endif
}

/* Whether region r has an edge from a to b. */
static inline gmds_status has_rim(const mesh *m, gmds_id r, gmds_id a, gmds_id b, gmds_ids *stack, int *has)
{
  *has = 0;
#  if GMDS__LISTS_WALLS
  (void)stack;
  size_t walls = region_walls(m, r);
  for (size_t k = 0; k < walls && !*has; k++) {
    gmds_id room[4];
    size_t n = 0;
    const gmds_id *v = wall_nodes(m, r, k, room, &n);
    *has = follow_each_other(v, n, a, b);
  }
#  else
  size_t mark = stack->n;
  GMDS_TRY(gmds_ids_push(stack, r));
  GMDS_TRY(hop_3_2(m, stack, mark, mark + 1));
  for (size_t k = mark + 1; k < stack->n && !*has; k++)
    *has = has_side(m, stack->data[k], a, b);
  stack->n = mark;
#  endif
  return GMDS_OK;
}

/* Whether two hops from x and y, by the same function, have a cell in common. */
GMDS_SPECIALISED gmds_status have_common(const mesh *m, gmds_id x, gmds_id y,
                                         gmds_status (*hop)(const mesh *, gmds_ids *, size_t, size_t), gmds_ids *stack,
                                         int *common)
{
  size_t mark = stack->n;
  *common = 0;
  GMDS_TRY(gmds_ids_push(stack, x));
  GMDS_TRY(gmds_ids_push(stack, y));
  GMDS_TRY(hop(m, stack, mark, mark + 1));
  size_t first = stack->n;
  GMDS_TRY(hop(m, stack, mark + 1, mark + 2));
  for (size_t i = mark + 2; i < first; i++)
    for (size_t j = first; j < stack->n; j++)
      *common |= stack->data[i] == stack->data[j];
  stack->n = mark;
  return GMDS_OK;
}

/* Whether faces f and g have a side in common. */
static inline gmds_status share_side(const mesh *m, gmds_id f, gmds_id g, gmds_ids *stack, int *share)
{
#  if GMDS__LINKED_1_2
  return have_common(m, f, g, hop_2_1, stack, share);
#  elif GMDS__S_2_0
  size_t n = 0;
  const gmds_id *v = row_2_0(m, f, &n);
  (void)stack;
  *share = 0;
  for (size_t k = 0; k < n && !*share; k++)
    *share = has_side(m, g, v[k], v[k + 1 < n ? k + 1 : 0]);
  return GMDS_OK;
#  else
  (void)m;
  (void)f;
  (void)g;
  (void)stack;
  *share = 1; /* triangles, or never asked */
  return GMDS_OK;
#  endif
}

/* Whether regions r and s have a face in common. */
static inline gmds_status share_wall(const mesh *m, gmds_id r, gmds_id s, gmds_ids *stack, int *share)
{
#  if GMDS__LISTS_WALLS
  size_t walls = region_walls(m, r);
  (void)stack;
  *share = 0;
  for (size_t k = 0; k < walls && !*share; k++) {
    gmds_id room[4];
    size_t n = 0;
    const gmds_id *v = wall_nodes(m, r, k, room, &n);
    *share = find_wall(m, s, n, v) != GMDS_NONE;
  }
  return GMDS_OK;
#  else
  return have_common(m, r, s, hop_3_2, stack, share);
#  endif
}

/* Whether face f has just the nodes of one of the faces of region r. */
static inline gmds_status is_wall(const mesh *m, gmds_id f, gmds_id r, gmds_ids *stack, int *is)
{
  *is = 0;
#  if GMDS__LISTS_WALLS
  size_t mark = stack->n;
  GMDS_TRY(gmds_ids_push(stack, f));
#    if GMDS__LINKED_0_2
  GMDS_TRY(hop_2_0(m, stack, mark, mark + 1));
  size_t first = mark + 1;
#    else
  GMDS_TRY(hop_2_1(m, stack, mark, mark + 1));
  size_t first = stack->n;
  GMDS_TRY(hop_1_0(m, stack, mark + 1, first));
  gmds_ids_keep(stack, first, 1, GMDS_NONE);
#    endif
  *is = find_wall(m, r, stack->n - first, stack->data + first) != GMDS_NONE;
  stack->n = mark;
#  else
  (void)m;
  (void)f;
  (void)r;
  (void)stack;
#  endif
  return GMDS_OK;
}

/* Whether one hop from x arrives at y. */
GMDS_SPECIALISED gmds_status arrives(const mesh *m, gmds_id x, gmds_id y,
                                     gmds_status (*hop)(const mesh *, gmds_ids *, size_t, size_t), gmds_ids *stack,
                                     int *does)
{
  size_t mark = stack->n;
  *does = 0;
  GMDS_TRY(gmds_ids_push(stack, x));
  GMDS_TRY(hop(m, stack, mark, mark + 1));
  for (size_t k = mark + 1; k < stack->n; k++)
    *does |= stack->data[k] == y;
  stack->n = mark;
  return GMDS_OK;
}

/* Whether edge e, from p to q, is a side of face f. */
static inline gmds_status is_side(const mesh *m, gmds_id e, gmds_id p, gmds_id q, gmds_id f, gmds_ids *stack, int *is)
{
  (void)p;
  (void)q;
#  if GMDS__S_1_2
  return arrives(m, e, f, hop_1_2, stack, is);
#  elif GMDS__S_2_1
  return arrives(m, f, e, hop_2_1, stack, is);
#  else
  (void)e;
  (void)stack;
  *is = has_side(m, f, p, q);
  return GMDS_OK;
#  endif
}

/* Whether edge e, from p to q, is one of region r. */
static inline gmds_status is_rim(const mesh *m, gmds_id e, gmds_id p, gmds_id q, gmds_id r, gmds_ids *stack, int *is)
{
  (void)e;
  (void)p;
  (void)q;
#  if GMDS__S_1_3
  return arrives(m, e, r, hop_1_3, stack, is);
#  elif GMDS__S_3_1
  return arrives(m, r, e, hop_3_1, stack, is);
#  elif GMDS__LISTS_WALLS
  return has_rim(m, r, p, q, stack, is);
#  else
  size_t mark = stack->n;
  *is = 0;
  GMDS_TRY(gmds_ids_push(stack, r));
  GMDS_TRY(hop_3_2(m, stack, mark, mark + 1));
  size_t last = stack->n;
  for (size_t k = mark + 1; k < last && !*is; k++)
    GMDS_TRY(is_side(m, e, p, q, stack->data[k], stack, is));
  stack->n = mark;
  return GMDS_OK;
#  endif
}

/* Whether node b, beside v around no more than some face or region, is joined with v by one of its edges. */
static inline gmds_status is_joined(const mesh *m, gmds_id v, gmds_id b, gmds_ids *stack, int *is)
{
  size_t mark = stack->n;
  *is = 0;
  (void)m;
  (void)b;
  GMDS_TRY(gmds_ids_push(stack, v));
#  if GMDS__LINKED_0_2
  GMDS_TRY(hop_0_2(m, stack, mark, mark + 1));
  for (size_t k = mark + 1; k < stack->n && !*is; k++)
    *is = has_side(m, stack->data[k], v, b);
#  elif GMDS__LINKED_0_3
  GMDS_TRY(hop_0_3(m, stack, mark, mark + 1));
  size_t last = stack->n;
  for (size_t k = mark + 1; k < last && !*is; k++)
    GMDS_TRY(has_rim(m, stack->data[k], v, b, stack, is));
#  endif
  stack->n = mark;
  return GMDS_OK;
}

/* Whether i-cell c is incident or adjacent to l-cell x, which was found by nodes or edges that they share. */
GMDS_SPECIALISED gmds_status is_answer(const mesh *m, int i, gmds_id c, int l, gmds_id x, gmds_ids *stack, int *is)
{
  const int low = i < l ? i : l, high = i < l ? l : i;
  const gmds_id a = i < l ? c : x, b = i < l ? x : c;
  if (low == 0 && high == 0)
    return is_joined(m, c, x, stack, is);
  if (low == 2 && high == 2)
    return share_side(m, c, x, stack, is);
  if (low == 3 && high == 3)
    return share_wall(m, c, x, stack, is);
  if (low == 2 && high == 3)
#  if GMDS__S_2_3
    return arrives(m, a, b, hop_2_3, stack, is);
#  elif GMDS__S_3_2
    return arrives(m, b, a, hop_3_2, stack, is);
#  else
    return is_wall(m, a, b, stack, is);
#  endif
  *is = 1;
  if (low != 1)
    return GMDS_OK;
  size_t mark = stack->n; /* the nodes of edge a */
  GMDS_TRY(gmds_ids_push(stack, a));
  GMDS_TRY(hop_1_0(m, stack, mark, mark + 1));
  gmds_id p = stack->data[mark + 1], q = stack->data[mark + 2];
  stack->n = mark;
  return high == 3 ? is_rim(m, a, p, q, b, stack, is) : is_side(m, a, p, q, b, stack, is);
}
#endif

/* ---- walking along a row of the tables */

/* The list holds the cell alone: the path starts from it. */
static inline gmds_status begin_answer(const gmds_cells *cells, gmds_id id, gmds_ids *out)
{
  if (!gmds_cells_has(cells, id))
    return GMDS_ERR_CELL;
  out->n = 0;
  return gmds_ids_push(out, id);
}

/* What lies from `first` on becomes the answer. */
static inline gmds_status end_answer(gmds_ids *out, size_t first)
{
  memmove(out->data, out->data + first, (out->n - first) * sizeof *out->data);
  out->n -= first;
  return GMDS_OK;
}

typedef gmds_status (*GMDS_FN(hop))(const mesh *m, gmds_ids *list, size_t first, size_t last);
typedef gmds_status (*GMDS_FN(meet))(const mesh *m, gmds_ids *list, size_t first, size_t last, size_t times);

/* One hop from the cells out[*first ..) of a path that began at the i-cell out[0] and arrives at l-cells: what lies
 * from the new *first on. `told`: what is kept need not be looked at again. */
GMDS_SPECIALISED gmds_status step(const mesh *m, int i, int l, GMDS_FN(hop) hop, GMDS_FN(meet) meet, size_t keep,
                                  int told, gmds_ids *out, size_t *first)
{
  const gmds_id from = out->data[0];
  const size_t last = out->n;
  const int alone = *first + 1 == last;
  if (keep > 1) {
    GMDS_TRY(meet(m, out, *first, last, keep));
    if (i == l)
      gmds_ids_keep(out, last, 1, from);
  } else {
    GMDS_TRY(hop(m, out, *first, last));
    if (i == l || !alone) /* one row is a set already, in an order that is kept */
      gmds_ids_keep(out, last, 1, i == l ? from : GMDS_NONE);
  }
  *first = last;
#if !GMDS__SIMPLICIAL
  size_t kept = last, end = out->n;
  for (size_t k = last; k < end && !told; k++) {
    int is = 0;
    const gmds_id x = out->data[k];
    GMDS_TRY(is_answer(m, i, from, l, x, out, &is));
    if (is)
      out->data[kept++] = x;
  }
  if (!told)
    out->n = kept;
#else
  (void)told;
#endif
  return GMDS_OK;
}

/* What each row of the tables becomes. */
#define GMDS__STEP(i, k, l, n, told) \
  status = status != GMDS_OK ? status : step(m, i, l, hop_##k##_##l, meet_##k##_##l, n, told, out, &first);
#define GMDS__ROW1(id, i, j) \
  case id:                   \
    GMDS__STEP(i, i, j, 1, 1) break;
#define GMDS__ROW2(id, t, i, k, j, n) \
  case id:                            \
    GMDS__STEP(i, i, k, 1, 1) GMDS__STEP(i, k, j, n, (n) == 1 && ((i) + (j) > 0 || (k) == 1)) break;
#define GMDS__ROW3(id, t, i, k, l, j, o, n) \
  case id:                                  \
    GMDS__STEP(i, i, k, 1, 1) GMDS__STEP(i, k, l, o, (o) == 1) GMDS__STEP(i, l, j, n, (n) == 1) break;
#define GMDS__ROW4(id, t, i, k, l, p, j, o, q, n) \
  case id:                                        \
    GMDS__STEP(i, i, k, 1, 1)                     \
    GMDS__STEP(i, k, l, o, (o) == 1) GMDS__STEP(i, l, p, q, (q) == 1) GMDS__STEP(i, p, j, n, (n) == 1) break;

#if GMDS__S_3_3
static inline gmds_id region_of(gmds_id entry)
{
  return GMDS__CODED && entry != GMDS_NONE ? entry >> 2 : entry;
}
#endif
