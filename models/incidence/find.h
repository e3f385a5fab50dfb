/* Finding what is at a side before a cell is made or removed: the edge between two nodes, the faces on it. By the
 * shortest way that the stored relations allow. */

/* Edges know nodes, or nodes edges. */
#define GMDS__LINKED_EDGES (GMDS__S_0_1 || GMDS__S_1_0)
/* The faces on a side can be found: through their nodes, or through the edge there. */
#define GMDS__FINDS_FACES \
  (((GMDS__S_0_2 || GMDS__S_2_0) && GMDS__KNOWS_SIDES) || (GMDS__LINKED_EDGES && (GMDS__S_1_2 || GMDS__S_2_1)))
/* The edge at a side can be found: by its nodes, or by the faces there. */
#define GMDS__FINDS_EDGES (GMDS__LINKED_EDGES || (GMDS__FINDS_FACES && (GMDS__S_1_2 || GMDS__S_2_1)))

#if GMDS__LINKED_EDGES
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

#if GMDS__FINDS_FACES
/* Puts the faces on the side from a to b into `out`; e is the edge there where edges and nodes are linked (GMDS_NONE:
 * there is none). */
static inline gmds_status faces_at_side(const mesh *m, gmds_id a, gmds_id b, gmds_id e, gmds_ids *out)
{
  out->n = 0;
  (void)a;
  (void)b;
  (void)e;
#  if GMDS__LINKED_EDGES && (GMDS__S_1_2 || !((GMDS__S_0_2 || GMDS__S_2_0) && GMDS__KNOWS_SIDES))
  if (e == GMDS_NONE)
    return GMDS_OK;
  GMDS_TRY(gmds_ids_push(out, e));
  GMDS_TRY(hop_1_2(m, out, 0, 1));
  out->n--;
  memmove(out->data, out->data + 1, out->n * sizeof *out->data);
#  elif GMDS__S_0_2
  gmds_id from = m->r_0_2.length[a] < m->r_0_2.length[b] ? a : b, to = from == a ? b : a;
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(&m->r_0_2, from, &n);
  (void)to;
  for (size_t k = 0; k < n; k++)
#    if GMDS__SIMPLICIAL
    if (gmds_rows_find(&m->r_0_2, to, row[k]) != GMDS_NONE)
#    else
    if (has_side(m, row[k], a, b))
#    endif
      GMDS_TRY(gmds_ids_push(out, row[k]));
#  else
  GMDS_TRY(gmds_ids_push(out, a));
  GMDS_TRY(gmds_ids_push(out, b));
  GMDS_TRY(meet_0_2(m, out, 0, 2, 2));
  size_t kept = 0;
  for (size_t i = 2; i < out->n; i++) {
#    if !GMDS__SIMPLICIAL
    if (!has_side(m, out->data[i], a, b))
      continue;
#    endif
    out->data[kept++] = out->data[i];
  }
  out->n = kept;
#  endif
  return GMDS_OK;
}
#endif

#if GMDS__FINDS_EDGES && !GMDS__LINKED_EDGES
/* The edge on the side from a to b through the faces there (faces[0 .. n)), or GMDS_NONE. Where faces keep nodes and
 * edges in order it is the edge of that side; else an edge that bounds these faces and no others, and is not among
 * taken[0 .. n_taken): a new face may share several sides with the same faces. */
static inline gmds_status edge_of_faces(const mesh *m, gmds_id a, gmds_id b, const gmds_id *faces, size_t n,
                                        const gmds_id *taken, size_t n_taken, gmds_ids *scratch, gmds_id *edge)
{
  (void)scratch;
  (void)taken;
  (void)n_taken;
  *edge = GMDS_NONE;
  if (!n)
    return GMDS_OK;
#  if GMDS__S_2_0 && GMDS__S_2_1
  size_t sides = 0;
  *edge = row_2_1(m, faces[0], &sides)[find_side(m, faces[0], a, b)];
#  else
  (void)a;
  (void)b;
  scratch->n = 0;
  GMDS_TRY(gmds_ids_push(scratch, faces[0]));
  GMDS_TRY(hop_2_1(m, scratch, 0, 1));
  size_t edges = scratch->n;
  for (size_t i = 1; i < edges && *edge == GMDS_NONE; i++) {
    scratch->n = edges;
    GMDS_TRY(hop_1_2(m, scratch, i, i + 1));
    int same = scratch->n - edges == n;
    for (size_t k = 0; k < n_taken; k++)
      same &= taken[k] != scratch->data[i];
    for (size_t k = 0; k < n; k++) {
      int has = 0;
      for (size_t j = edges; j < scratch->n; j++)
        has |= scratch->data[j] == faces[k];
      same &= has;
    }
    if (same)
      *edge = scratch->data[i];
  }
#  endif
  return GMDS_OK;
}
#endif

#if GMDS_ACROSS && !GMDS__CODED
/* The number of the side of face g that face f has as its side k, from a to b; g has it. By the edge where faces keep
 * edges and no nodes. */
static inline unsigned arrival_at(const mesh *m, gmds_id f, unsigned k, gmds_id a, gmds_id b, gmds_id g)
{
  size_t n = 0;
  (void)n;
  (void)f;
  (void)k;
  (void)a;
  (void)b;
#  if !GMDS__S_2_0
  const gmds_id edge = row_2_1(m, f, &n)[k], *row = row_2_1(m, g, &n);
  unsigned side = 0;
  while (row[side] != edge)
    side++;
  return side;
#  elif GMDS__SIMPLICIAL && GMDS__INLINE
  const gmds_id *v = row_2_0(m, g, &n); /* the side after the node that is neither a nor b */
  return v[1] != a && v[1] != b ? 2 : v[2] != a && v[2] != b ? 0 : 1;
#  else
  return (unsigned)find_side(m, g, a, b);
#  endif
}

#  if !GMDS__S_2_2 && !(GMDS__S_1_2 && (GMDS__S_2_1 || GMDS__S_0_1))
/* Whether face g, one of those at one end of side k of face f, has that side: the other end is `to`. */
static inline int has_side_to(const mesh *m, gmds_id f, unsigned k, gmds_id from, gmds_id to, gmds_id g)
{
  size_t n = 0;
  (void)n;
  (void)f;
  (void)k;
  (void)from;
  (void)to;
#    if GMDS__INLINE && !GMDS__S_2_0
  const gmds_id edge = row_2_1(m, f, &n)[k], *row = row_2_1(m, g, &n);
  int has = 0;
  for (size_t i = 0; i < GMDS__SIDES; i++)
    has |= row[i] == edge;
  return has;
#    elif GMDS__SIMPLICIAL && GMDS__INLINE
  const gmds_id *v = row_2_0(m, g, &n);
  return (v[0] == to) | (v[1] == to) | (v[2] == to);
#    else
  return find_side(m, g, from, to) != GMDS_NONE;
#    endif
}
#  endif
#endif

#if GMDS_ACROSS
static inline gmds_id across(const mesh *m, gmds_id f, unsigned k, unsigned *arrival)
{
  size_t n = 0;
#  if GMDS__CODED
  gmds_id entry = row_2_2(m, f, &n)[k];
  *arrival = entry & 3;
  return entry == GMDS_NONE ? GMDS_NONE : entry >> 2;
#  else
#    if GMDS__S_2_0
  gmds_id a = face_node(m, f, k), b = face_node(m, f, k + 1 < face_sides(m, f) ? k + 1 : 0);
#    else
  const gmds_id *ends = m->r_1_0.data + 2 * (size_t)row_2_1(m, f, &n)[k];
  gmds_id a = ends[0], b = ends[1];
#    endif
  gmds_id g = GMDS_NONE;
  (void)n;
#    if GMDS__S_2_2
  g = row_2_2(m, f, &n)[k];
#    elif GMDS__S_1_2 && (GMDS__S_2_1 || GMDS__S_0_1)
#      if GMDS__S_2_1
  gmds_id edge = row_2_1(m, f, &n)[k];
#      else
  gmds_id edge = find_edge(m, a, b);
#      endif
  const gmds_id *faces = gmds_pairs_get(&m->r_1_2, edge, &n);
  if (n == 2)
    g = faces[faces[0] == f];
#    else
  /* the shorter of the rows of a and b: the node that stands for infinity has one as long as the hull */
  gmds_id from = m->r_0_2.length[a] < m->r_0_2.length[b] ? a : b, to = from == a ? b : a;
  const gmds_id *faces = gmds_rows_get(&m->r_0_2, from, &n);
  gmds_id found = 0;
  for (size_t i = 0; i < n;
       i++) { /* to the end: there may be more than one; no branch, which one cannot be predicted */
    gmds_id has = (gmds_id)((faces[i] != f) & has_side_to(m, f, k, from, to, faces[i]));
    g ^= (g ^ faces[i]) & (0 - has);
    found += has;
  }
  if (found != 1)
    g = GMDS_NONE;
#    endif
  *arrival = g == GMDS_NONE ? 0 : arrival_at(m, f, k, a, b, g);
  return g;
#  endif
}
#endif
