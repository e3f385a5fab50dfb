/* Queries: hops along stored relations or by traversal, composed along the path that paths.h chose, with the operator
 * Keep of [models] 2.1 at the end. One function a pair; each body is the row of the table that the model takes. */

/* ---- rows of faces, however they are stored */

#if GMDS__S_2_0
static inline const gmds_id *row_2_0(const mesh *m, gmds_id f, size_t *n)
{
#  if GMDS__INLINE
  *n = GMDS__SIDES;
  return m->r_2_0.data + GMDS__SIDES * (size_t)f;
#  else
  return gmds_rows_get(&m->r_2_0, f, n);
#  endif
}
#endif

#if GMDS__S_2_1
static inline gmds_id *row_2_1(const mesh *m, gmds_id f, size_t *n)
{
#  if GMDS__INLINE
  *n = GMDS__SIDES;
  return m->r_2_1.data + GMDS__SIDES * (size_t)f;
#  else
  return gmds_rows_get(&m->r_2_1, f, n);
#  endif
}
#endif

#if GMDS__S_2_2
/* Entry k is the face beyond side k: read it with face_of. */
static inline gmds_id *row_2_2(const mesh *m, gmds_id f, size_t *n)
{
#  if GMDS__INLINE
  *n = GMDS__SIDES;
  return m->r_2_2.data + GMDS__SIDES * (size_t)f;
#  else
  return gmds_rows_get(&m->r_2_2, f, n);
#  endif
}

static inline gmds_id face_of(gmds_id entry)
{
  return GMDS__CODED && entry != GMDS_NONE ? entry >> 2 : entry;
}
#endif

/* ---- hops: from the cells list[first .. last) append those they are linked with */

#define GMDS__SCAN_ROWS(i, j)                                                   \
  m->borrowed[j][i].begin ? gmds_hop_csr(&m->borrowed[j][i], list, first, last) \
                          : gmds_scan_rows(&m->r_##i##_##j, m->cells[i].end, list, first, last)
#define GMDS__SCAN_PAIRS(i, j)                                                  \
  m->borrowed[j][i].begin ? gmds_hop_csr(&m->borrowed[j][i], list, first, last) \
                          : gmds_scan_pairs(&m->r_##i##_##j, m->cells[i].end, list, first, last)
#define GMDS__SCAN_INLINE(i, j)                             \
  m->borrowed[j][i].begin                                   \
      ? gmds_hop_csr(&m->borrowed[j][i], list, first, last) \
      : gmds_scan_inline(m->r_##i##_##j.data, GMDS__ARITY_##i, &m->cells[i].alive, m->cells[i].end, list, first, last)
#if GMDS__INLINE
#  define GMDS__HOP_OF_FACE(j) gmds_hop_inline(m->r_2_##j.data, GMDS__SIDES, list, first, last)
#  define GMDS__SCAN_FACES(j) GMDS__SCAN_INLINE(2, j)
#else
#  define GMDS__HOP_OF_FACE(j) gmds_hop_rows(&m->r_2_##j, list, first, last)
#  define GMDS__SCAN_FACES(j) GMDS__SCAN_ROWS(2, j)
#endif

#if GMDS__S_0_1 || GMDS__S_1_0
static inline gmds_status hop_0_1(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_0_1
  return gmds_hop_rows(&m->r_0_1, list, first, last);
#  else
  return GMDS__SCAN_INLINE(1, 0);
#  endif
}

static inline gmds_status hop_1_0(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_1_0
  return gmds_hop_inline(m->r_1_0.data, 2, list, first, last);
#  else
  return GMDS__SCAN_ROWS(0, 1);
#  endif
}
#endif

#if GMDS__S_0_2 || GMDS__S_2_0
static inline gmds_status hop_0_2(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_0_2
  return gmds_hop_rows(&m->r_0_2, list, first, last);
#  else
  return GMDS__SCAN_FACES(0);
#  endif
}

static inline gmds_status hop_2_0(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_2_0
  return GMDS__HOP_OF_FACE(0);
#  else
  return GMDS__SCAN_ROWS(0, 2);
#  endif
}
#endif

#if GMDS__S_1_2 || GMDS__S_2_1
static inline gmds_status hop_1_2(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_1_2
  return gmds_hop_pairs(&m->r_1_2, list, first, last);
#  else
  return GMDS__SCAN_FACES(1);
#  endif
}

static inline gmds_status hop_2_1(const mesh *m, gmds_ids *list, size_t first, size_t last)
{
#  if GMDS__S_2_1
  return GMDS__HOP_OF_FACE(1);
#  else
  return GMDS__SCAN_PAIRS(1, 2);
#  endif
}
#endif
#undef GMDS__SCAN_ROWS
#undef GMDS__SCAN_PAIRS
#undef GMDS__SCAN_INLINE
#undef GMDS__HOP_OF_FACE
#undef GMDS__SCAN_FACES

/* ---- answers */

/* The list holds the cell alone: the path starts from it. */
static inline gmds_status begin_answer(const gmds_cells *cells, gmds_id id, gmds_ids *out)
{
  if (!gmds_cells_has(cells, id))
    return GMDS_ERR_CELL;
  out->n = 0;
  return gmds_ids_push(out, id);
}

/* What lies from `first` on, kept as often as it must occur, becomes the answer. */
static inline gmds_status end_answer(gmds_ids *out, size_t first, size_t times, gmds_id but)
{
  gmds_ids_keep(out, first, times, but);
  memmove(out->data, out->data + first, (out->n - first) * sizeof *out->data);
  out->n -= first;
  return GMDS_OK;
}

/* Appends what at least `times` of the nodes list[first .. last) have in common. */
#if GMDS__S_0_1 || GMDS__S_1_0
static inline gmds_status meet_0_1(const mesh *m, gmds_ids *list, size_t first, size_t last, size_t times)
{
#  if GMDS__S_0_1
  return gmds_rows_meet(&m->r_0_1, first, last, times, list);
#  else
  if (!m->borrowed[0][1].begin)
    return gmds_scan_meet_inline(m->r_1_0.data, 2, &m->cells[1].alive, m->cells[1].end, list, first, last, times);
  size_t from = list->n;
  GMDS_TRY(hop_0_1(m, list, first, last));
  gmds_ids_keep(list, from, times, GMDS_NONE);
  return GMDS_OK;
#  endif
}
#endif

#if GMDS__S_0_2 || GMDS__S_2_0
static inline gmds_status meet_0_2(const mesh *m, gmds_ids *list, size_t first, size_t last, size_t times)
{
#  if GMDS__S_0_2
  return gmds_rows_meet(&m->r_0_2, first, last, times, list);
#  else
#    if GMDS__INLINE
  if (!m->borrowed[0][2].begin)
    return gmds_scan_meet_inline(m->r_2_0.data, GMDS__SIDES, &m->cells[2].alive, m->cells[2].end, list, first, last,
                                 times);
#    else
  if (!m->borrowed[0][2].begin)
    return gmds_scan_meet_rows(&m->r_2_0, m->cells[2].end, list, first, last, times);
#    endif
  size_t from = list->n;
  GMDS_TRY(hop_0_2(m, list, first, last));
  gmds_ids_keep(list, from, times, GMDS_NONE);
  return GMDS_OK;
#  endif
}
#endif

#if !GMDS__SIMPLICIAL && GMDS__S_2_0
/* Whether nodes a and b follow each other around face f. */
static inline int has_side(const mesh *m, gmds_id f, gmds_id a, gmds_id b)
{
  size_t n = 0;
  const gmds_id *v = row_2_0(m, f, &n);
  for (size_t k = 0, next = n - 1; k < n; next = k++)
    if ((v[k] == a && v[next] == b) || (v[k] == b && v[next] == a))
      return 1;
  return 0;
}

/* Keeps of the faces from `first` on those that share a side with f. */
static inline void keep_sharing_side(const mesh *m, gmds_id f, gmds_ids *list, size_t first)
{
  size_t kept = first, n = 0;
  const gmds_id *v = row_2_0(m, f, &n);
  for (size_t i = first; i < list->n; i++) {
    int shares = 0;
    for (size_t k = 0; k < n && !shares; k++)
      shares = has_side(m, list->data[i], v[k], v[(k + 1) % n]);
    if (shares)
      list->data[kept++] = list->data[i];
  }
  list->n = kept;
}
#endif

#if GMDS__CAN_0_0
static inline gmds_status get_adj_0_0(const mesh *m, gmds_id v, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[0], v, out));
#  if GMDS__ROW_0_0 == 1
  GMDS_TRY(gmds_hop_rows(&m->r_0_0, out, 0, 1));
  return end_answer(out, 1, 1, v);
#  elif GMDS__ROW_0_0 == 2
  GMDS_TRY(hop_0_1(m, out, 0, 1));
  size_t edges = out->n;
  GMDS_TRY(hop_1_0(m, out, 1, edges));
  return end_answer(out, edges, 1, v);
#  else
  GMDS_TRY(hop_0_2(m, out, 0, 1));
  size_t faces = out->n;
#    if GMDS__SIMPLICIAL
  GMDS_TRY(hop_2_0(m, out, 1, faces));
#    else
  for (size_t i = 1; i < faces; i++) {
    size_t n = 0;
    const gmds_id *around = row_2_0(m, out->data[i], &n);
    for (size_t k = 0; k < n; k++)
      if (around[k] == v) {
        GMDS_TRY(gmds_ids_push(out, around[(k + 1) % n]));
        GMDS_TRY(gmds_ids_push(out, around[(k + n - 1) % n]));
      }
  }
#    endif
  return end_answer(out, faces, 1, v);
#  endif
}
#endif

#if GMDS__CAN_0_1
static inline gmds_status get_adj_0_1(const mesh *m, gmds_id v, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[0], v, out));
  GMDS_TRY(hop_0_1(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
}
#endif

#if GMDS__CAN_0_2
static inline gmds_status get_adj_0_2(const mesh *m, gmds_id v, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[0], v, out));
#  if GMDS__ROW_0_2 == 1
  GMDS_TRY(hop_0_2(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
#  else
  GMDS_TRY(hop_0_1(m, out, 0, 1));
  size_t edges = out->n;
  GMDS_TRY(hop_1_2(m, out, 1, edges));
  return end_answer(out, edges, 1, GMDS_NONE);
#  endif
}
#endif

#if GMDS__CAN_1_0
static inline gmds_status get_adj_1_0(const mesh *m, gmds_id e, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[1], e, out));
  GMDS_TRY(hop_1_0(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
}
#endif

#if GMDS__CAN_1_1
static inline gmds_status get_adj_1_1(const mesh *m, gmds_id e, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[1], e, out));
#  if GMDS__ROW_1_1 == 1
  GMDS_TRY(gmds_hop_rows(&m->r_1_1, out, 0, 1));
  return end_answer(out, 1, 1, e);
#  else
  GMDS_TRY(hop_1_0(m, out, 0, 1));
  size_t nodes = out->n;
  GMDS_TRY(hop_0_1(m, out, 1, nodes));
  return end_answer(out, nodes, 1, e);
#  endif
}
#endif

#if GMDS__CAN_1_2
static inline gmds_status get_adj_1_2(const mesh *m, gmds_id e, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[1], e, out));
#  if GMDS__ROW_1_2 == 1
  GMDS_TRY(hop_1_2(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
#  else
  GMDS_TRY(hop_1_0(m, out, 0, 1));
  size_t nodes = out->n;
  GMDS_TRY(meet_0_2(m, out, 1, nodes, 2));
#    if !GMDS__SIMPLICIAL
  size_t kept = nodes;
  for (size_t i = nodes; i < out->n; i++)
    if (has_side(m, out->data[i], out->data[1], out->data[2]))
      out->data[kept++] = out->data[i];
  out->n = kept;
#    endif
  return end_answer(out, nodes, 1, GMDS_NONE);
#  endif
}
#endif

#if GMDS__CAN_2_0
static inline gmds_status get_adj_2_0(const mesh *m, gmds_id f, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[2], f, out));
#  if GMDS__S_2_0
  size_t n = 0;
  const gmds_id *v = row_2_0(m, f, &n);
  GMDS_TRY(gmds_ids_reserve(out, n));
  memcpy(out->data, v, n * sizeof *v);
  out->n = n;
  return GMDS_OK;
#  elif GMDS_ORDERED_2_0
  /* node k is what edges k - 1 and k share: faces keep their edges in the order of their sides */
  size_t n = 0;
  const gmds_id *edges = row_2_1(m, f, &n), *ends = m->r_1_0.data;
  GMDS_TRY(gmds_ids_reserve(out, n));
  for (size_t k = 0; k < n; k++) {
    const gmds_id *a = ends + 2 * (size_t)edges[(k + n - 1) % n], *b = ends + 2 * (size_t)edges[k];
    out->data[k] = a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
  }
  out->n = n;
  return GMDS_OK;
#  elif GMDS__ROW_2_0 == 1
  GMDS_TRY(hop_2_0(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
#  else
  GMDS_TRY(hop_2_1(m, out, 0, 1));
  size_t edges = out->n;
  GMDS_TRY(hop_1_0(m, out, 1, edges - 1)); /* each node is on two of the edges: one may be left out */
  return end_answer(out, edges, 1, GMDS_NONE);
#  endif
}
#endif

#if GMDS__CAN_2_1
static inline gmds_status get_adj_2_1(const mesh *m, gmds_id f, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[2], f, out));
#  if GMDS__S_2_1
  size_t n = 0;
  const gmds_id *e = row_2_1(m, f, &n);
  GMDS_TRY(gmds_ids_reserve(out, n));
  memcpy(out->data, e, n * sizeof *e);
  out->n = n;
  return GMDS_OK;
#  elif GMDS__ROW_2_1 == 1
  GMDS_TRY(hop_2_1(m, out, 0, 1));
  return end_answer(out, 1, 1, GMDS_NONE);
#  elif GMDS__SIMPLICIAL
  GMDS_TRY(hop_2_0(m, out, 0, 1));
  size_t nodes = out->n;
  GMDS_TRY(meet_0_1(m, out, 1, nodes, 2));
  return end_answer(out, nodes, 1, GMDS_NONE);
#  else
  /* side by side: two nodes of a face may be joined by an edge that is none of its sides */
  GMDS_TRY(hop_2_0(m, out, 0, 1));
  size_t n = out->n - 1, nodes = out->n;
  GMDS_TRY(gmds_ids_push(out, out->data[1]));
  for (size_t k = 1; k <= n; k++)
    GMDS_TRY(meet_0_1(m, out, k, k + 2, 2));
  return end_answer(out, nodes + 1, 1, GMDS_NONE);
#  endif
}
#endif

#if GMDS__CAN_2_2
static inline gmds_status get_adj_2_2(const mesh *m, gmds_id f, gmds_ids *out)
{
  GMDS_TRY(begin_answer(&m->cells[2], f, out));
#  if GMDS__ROW_2_2 == 1
  size_t n = 0;
  const gmds_id *row = row_2_2(m, f, &n);
  GMDS_TRY(gmds_ids_reserve(out, n));
  out->n = 0;
  for (size_t k = 0; k < n; k++)
    if (row[k] != GMDS_NONE && !gmds_ids_has(out, face_of(row[k])))
      out->data[out->n++] = face_of(row[k]);
  return GMDS_OK;
#  elif GMDS__ROW_2_2 == 2
  GMDS_TRY(hop_2_1(m, out, 0, 1));
  size_t edges = out->n;
  GMDS_TRY(hop_1_2(m, out, 1, edges));
  return end_answer(out, edges, 1, f);
#  elif GMDS__ROW_2_2 == 3 || GMDS__ROW_2_2 == 4
#    if GMDS__ROW_2_2 == 3
  GMDS_TRY(hop_2_0(m, out, 0, 1));
  size_t first = 1;
#    else
  GMDS_TRY(hop_2_1(m, out, 0, 1));
  size_t first = out->n;
  GMDS_TRY(hop_1_0(m, out, 1, first - 1)); /* each node is on two of the edges: one may be left out */
  gmds_ids_keep(out, first, 1, GMDS_NONE);
#    endif
  size_t nodes = out->n;
  GMDS_TRY(meet_0_2(m, out, first, nodes, 2));
#    if GMDS__SIMPLICIAL
  return end_answer(out, nodes, 1, f);
#    elif GMDS__S_2_0
  keep_sharing_side(m, f, out, nodes);
  return end_answer(out, nodes, 1, f);
#    else
  size_t kept = nodes;
  for (size_t i = nodes; i < out->n; i++) { /* sharing an edge, which both faces keep */
    size_t n = 0;
    const gmds_id *e = row_2_1(m, out->data[i], &n);
    int shares = 0;
    for (size_t a = 1; a < first; a++)
      for (size_t b = 0; b < n; b++)
        shares |= out->data[a] == e[b];
    if (shares)
      out->data[kept++] = out->data[i];
  }
  out->n = kept;
  return end_answer(out, nodes, 1, f);
#    endif
#  else
  GMDS_TRY(get_adj_2_1(m, f, out));
  size_t edges = out->n;
  GMDS_TRY(hop_1_2(m, out, 0, edges));
  return end_answer(out, edges, 1, f);
#  endif
}
#endif
