/* Queries of the whole mesh. A stored relation is copied, the inverse of one is built by counting. Faces that share a
 * side, and edges of sides, are told by grouping the sides by their nodes. Otherwise the query of one cell runs for
 * each, and the traversals that it would make are made once for all: the inverse is lent to it. O(mesh) for every pair
 * and model. */

typedef gmds_status (*GMDS_FN(query))(const mesh *m, gmds_id id, gmds_ids *out);

/* Lends the view the relation a -> b, the inverse of a stored one. */
static inline gmds_status borrow(mesh *view, int a, int b, gmds_memory *memory)
{
  gmds_csr *csr = &view->borrowed[a][b];
  gmds_csr_init(csr, memory);
#define GMDS__BORROW_ROWS(i, j) \
  if (i == b && j == a)         \
    return gmds_invert_rows(&view->r_##i##_##j, view->cells[i].end, view->cells[j].end, csr);
#define GMDS__BORROW_PAIRS(i, j) \
  if (i == b && j == a)          \
    return gmds_invert_pairs(&view->r_##i##_##j, view->cells[i].end, view->cells[j].end, csr);
#define GMDS__BORROW_INLINE(i, j)                                                                                 \
  if (i == b && j == a)                                                                                           \
    return gmds_invert_inline(view->r_##i##_##j.data, GMDS__ARITY_##i, &view->cells[i].alive, view->cells[i].end, \
                              view->cells[j].end, csr);
  GMDS__EACH_POOLED(GMDS__BORROW_ROWS)
  GMDS__EACH_PAIRS(GMDS__BORROW_PAIRS)
  GMDS__EACH_INLINE(GMDS__BORROW_INLINE)
#undef GMDS__BORROW_ROWS
#undef GMDS__BORROW_PAIRS
#undef GMDS__BORROW_INLINE
  return GMDS_OK;
}

/* A stored relation whose entries are the answer as they are. */
static inline gmds_status copy_stored(const mesh *m, int i, int j, gmds_csr *csr)
{
  (void)m;
  (void)i;
  (void)j;
  (void)csr;
#define GMDS__COPY_ROWS(a, b) \
  if (i == a && j == b)       \
    return gmds_copy_rows(&m->r_##a##_##b, m->cells[a].end, csr);
#define GMDS__COPY_PAIRS(a, b) \
  if (i == a && j == b)        \
    return gmds_copy_pairs(&m->r_##a##_##b, m->cells[a].end, csr);
#define GMDS__COPY_INLINE(a, b) \
  if (i == a && j == b)         \
    return gmds_copy_inline(m->r_##a##_##b.data, GMDS__ARITY_##a, &m->cells[a].alive, m->cells[a].end, 0, csr);
  GMDS__EACH_POOLED(GMDS__COPY_ROWS)
  GMDS__EACH_PAIRS(GMDS__COPY_PAIRS)
  GMDS__EACH_INLINE(GMDS__COPY_INLINE)
#undef GMDS__COPY_ROWS
#undef GMDS__COPY_PAIRS
#undef GMDS__COPY_INLINE
  return GMDS_ERR_UNSUPPORTED;
}

/* Whether i -> j asks what is at the sides of faces, and no more than their nodes tells it. */
#define GMDS__OVER_SIDES(i, j)                                                                      \
  (GMDS__KNOWS_SIDES &&                                                                             \
   (((i) == 0 && (j) == 0 && GMDS__ROW_0_0 == 3) || ((i) == 2 && (j) == 2 && GMDS__ROW_2_2 == 3) || \
    ((i) == 2 && (j) == 1 && GMDS__ROW_2_1 == 2) || ((i) == 1 && (j) == 2 && GMDS__ROW_1_2 == 2)))

static inline gmds_status fill_csr(const mesh *view, int i, GMDS_FN(query) query, gmds_ids *list, gmds_csr *csr)
{
  size_t n = view->cells[i].end, used = 0;
  void *begin = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  csr->begin = begin;
  csr->n = n;
  for (size_t c = 0; c < n; c++) {
    csr->begin[c] = used;
    if (!gmds_cells_has(&view->cells[i], (gmds_id)c))
      continue;
    GMDS_TRY(query(view, (gmds_id)c, list));
    if (used + list->n > csr->capacity) {
      void *data = csr->data;
      size_t grown = gmds_grown(csr->capacity, used + list->n);
      if (!gmds_resize(csr->memory, &data, csr->capacity, grown, sizeof *csr->data))
        return GMDS_ERR_MEMORY;
      csr->data = data;
      csr->capacity = grown;
    }
    if (list->n)
      memcpy(csr->data + used, list->data, list->n * sizeof *list->data);
    used += list->n;
  }
  csr->begin[n] = used;
  return GMDS_OK;
}

static inline gmds_status all_adj(const mesh *m, int i, int j, GMDS_FN(query) query, gmds_csr *csr)
{
  const gmds_path path = gmds_path_of(GMDS__MASK, i, j);
  if (path.hops == 1 && !path.inverse && (i != 2 || j != 2))
    return copy_stored(m, i, j, csr);
  if (GMDS__OVER_SIDES(i, j)) {
    gmds_parts parts;
    view_parts(m, &parts);
    gmds_status answer = gmds_parts_over_sides(&parts, i, j, csr);
    if (answer == GMDS_OK || answer == GMDS_ERR_MEMORY)
      return answer;
  }
  mesh view = *m; /* shares every column; only the loans are its own */
  gmds_csr result;
  gmds_ids list = {.memory = csr->memory};
  gmds_csr_init(&result, csr->memory);
  gmds_status status = GMDS_OK;
  for (int s = 0; s < path.hops && status == GMDS_OK; s++)
    if (path.inverse >> s & 1 && !view.borrowed[path.cells[s]][path.cells[s + 1]].begin)
      status = borrow(&view, path.cells[s], path.cells[s + 1], csr->memory);
  if (status == GMDS_OK && path.hops == 1 && path.inverse) {
    result = view.borrowed[i][j];
    gmds_csr_init(&view.borrowed[i][j], csr->memory);
  } else if (status == GMDS_OK)
    status = fill_csr(&view, i, query, &list, &result);
  for (int s = 0; s < path.hops; s++)
    if (path.inverse >> s & 1 && !m->borrowed[path.cells[s]][path.cells[s + 1]].begin &&
        view.borrowed[path.cells[s]][path.cells[s + 1]].memory)
      gmds_csr_clear(&view.borrowed[path.cells[s]][path.cells[s + 1]]);
  gmds_ids_clear(&list);
  if (status == GMDS_OK)
    *csr = result;
  else
    gmds_csr_clear(&result);
  return status;
}

#if GMDS__CAN_0_0
static inline gmds_status all_adj_0_0(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 0, 0, get_adj_0_0, csr);
}
#endif

#if GMDS__CAN_0_1
static inline gmds_status all_adj_0_1(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 0, 1, get_adj_0_1, csr);
}
#endif

#if GMDS__CAN_0_2
static inline gmds_status all_adj_0_2(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 0, 2, get_adj_0_2, csr);
}
#endif

#if GMDS__CAN_1_0
static inline gmds_status all_adj_1_0(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 1, 0, get_adj_1_0, csr);
}
#endif

#if GMDS__CAN_1_1
static inline gmds_status all_adj_1_1(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 1, 1, get_adj_1_1, csr);
}
#endif

#if GMDS__CAN_1_2
static inline gmds_status all_adj_1_2(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 1, 2, get_adj_1_2, csr);
}
#endif

#if GMDS__CAN_2_0
static inline gmds_status all_adj_2_0(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 2, 0, get_adj_2_0, csr);
}
#endif

#if GMDS__CAN_2_1
static inline gmds_status all_adj_2_1(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 2, 1, get_adj_2_1, csr);
}
#endif

#if GMDS__CAN_2_2
static inline gmds_status all_adj_2_2(const mesh *m, gmds_csr *csr)
{
  return all_adj(m, 2, 2, get_adj_2_2, csr);
}
#endif
#undef GMDS__OVER_SIDES
