/* Queries of the whole mesh: the query of one cell runs for each, and the traversals that it would make are made once
 * for all: the inverse is lent to it. A stored relation is copied, the inverse of one is built by counting. O(mesh). */

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
#define GMDS__BORROW_INLINE(i, j)                                                                   \
  if (i == b && j == a)                                                                             \
    return gmds_invert_inline(view->r_##i##_##j.data, GMDS__ARITY_##i##_##j, &view->cells[i].alive, \
                              view->cells[i].end, view->cells[j].end, csr);
  GMDS__EACH_POOLED(GMDS__BORROW_ROWS)
  GMDS__EACH_PAIRS(GMDS__BORROW_PAIRS)
  GMDS__EACH_INLINE(GMDS__BORROW_INLINE)
#undef GMDS__BORROW_ROWS
#undef GMDS__BORROW_PAIRS
#undef GMDS__BORROW_INLINE
  return GMDS_OK;
}

/* A stored relation as it lies, GMDS_NONE included; codes without their faces. */
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
#define GMDS__COPY_INLINE(a, b)                                                                              \
  if (i == a && j == b)                                                                                      \
    return gmds_copy_inline(m->r_##a##_##b.data, GMDS__ARITY_##a##_##b, &m->cells[a].alive, m->cells[a].end, \
                            GMDS__CODED && a == 3 && b == 3 ? 2 : 0, csr);
  GMDS__EACH_POOLED(GMDS__COPY_ROWS)
  GMDS__EACH_PAIRS(GMDS__COPY_PAIRS)
  GMDS__EACH_INLINE(GMDS__COPY_INLINE)
#undef GMDS__COPY_ROWS
#undef GMDS__COPY_PAIRS
#undef GMDS__COPY_INLINE
  return GMDS_ERR_UNSUPPORTED;
}

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

/* Lends the view what the extended model has and the model has not, all of it: what a query asks of cells on its way is
 * more than the hops of its path. */
static inline gmds_status borrow_all(mesh *view, const gmds_path *path, gmds_memory *memory)
{
  for (int s = 0; s < path->hops; s++)
    if (path->inverse >> s & 1 && !view->borrowed[path->cells[s]][path->cells[s + 1]].begin)
      GMDS_TRY(borrow(view, path->cells[s], path->cells[s + 1], memory));
#if !GMDS__SIMPLICIAL
  static const int asked[][2] = {{1, 0}, {2, 0}, {2, 1}, {3, 2}};
  for (size_t k = 0; k < sizeof asked / sizeof *asked; k++) {
    const int a = asked[k][0], b = asked[k][1];
    const unsigned has = GMDS__MASK & (unsigned)GMDS_RELATION_BIT(a, b),
                   inverse = GMDS__MASK & (unsigned)GMDS_RELATION_BIT(b, a);
    if (!has && inverse && !view->borrowed[a][b].begin)
      GMDS_TRY(borrow(view, a, b, memory));
  }
#endif
  return GMDS_OK;
}

static inline gmds_status all_adj(const mesh *m, int i, int j, GMDS_FN(query) query, gmds_csr *csr)
{
  const gmds_path path = gmds_path_of(GMDS__MASK, i, j);
  if (path.hops == 1 && !path.inverse && (i != 3 || j != 3))
    return copy_stored(m, i, j, csr);
  mesh view = *m; /* shares every column; only the loans are its own */
  gmds_csr result;
  gmds_ids list = {.memory = csr->memory};
  gmds_csr_init(&result, csr->memory);
  gmds_status status = borrow_all(&view, &path, csr->memory);
  if (status == GMDS_OK && path.hops == 1 && path.inverse && !(i == 3 && j == 0 && GMDS_ORDERED_3_0) &&
      !(i == 2 && j == 0 && GMDS_ORDERED_2_0)) {
    result = view.borrowed[i][j];
    gmds_csr_init(&view.borrowed[i][j], csr->memory);
  } else if (status == GMDS_OK)
    status = fill_csr(&view, i, query, &list, &result);
  for (int a = 0; a < 4; a++)
    for (int b = 0; b < 4; b++)
      if (view.borrowed[a][b].memory && !m->borrowed[a][b].begin)
        gmds_csr_clear(&view.borrowed[a][b]);
  gmds_ids_clear(&list);
  if (status == GMDS_OK)
    *csr = result;
  else
    gmds_csr_clear(&result);
  return status;
}
