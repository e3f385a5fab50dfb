/* A mesh as a complex (complex.h), and back: what conversion between models, soups and the check are made of. */

#if GMDS_LISTS_CELLS
#  if !GMDS_ORDERED_3_0 && !GMDS__S_3_0 && !GMDS__TETRAHEDRA
/* The nodes of region r from its faces (one row of each csr). */
static inline gmds_status corners_from_faces(const mesh *m, gmds_id r, const gmds_csr *faces, const gmds_csr *around,
                                             gmds_ids *list)
{
  const gmds_cell_type type = region_type(m, r);
  const gmds_shape *s = gmds_shape_of(type);
  size_t begin[GMDS_SHAPE_FACES + 1] = {0}, n = faces->begin[r + 1] - faces->begin[r];
  const gmds_id *own = faces->data + faces->begin[r];
  list->n = 0;
  if (s && n != s->faces)
    return GMDS_ERR_INVARIANT;
  for (size_t k = 0; k < n; k++) {
    for (size_t q = around->begin[own[k]]; q < around->begin[own[k] + 1]; q++)
      GMDS_TRY(gmds_ids_push(list, around->data[q]));
    if (s)
      begin[k + 1] = list->n;
  }
  if (!s) {
    gmds_ids_keep(list, 0, 1, GMDS_NONE);
    return GMDS_OK;
  }
  gmds_id nodes[GMDS_SHAPE_NODES];
  GMDS_TRY(gmds_shape_from_faces(type, begin, list->data, nodes));
  gmds_shape_turn_outwards(type, m->points, nodes);
  return start_with(list, nodes, s->nodes);
}

static inline gmds_status list_corners(const mesh *m, gmds_complex *c)
{
  gmds_csr faces, *nodes = &c->nodes[3];
  gmds_ids list = {.memory = c->memory};
  gmds_csr_init(&faces, c->memory);
  gmds_status status = all_adj_3_2(m, &faces);
  if (status == GMDS_OK)
    status = gmds_csr_begin(nodes, end_3(m));
  for (int pass = 0; pass < 2 && status == GMDS_OK; pass++) {
    for (gmds_id r = next_3(m, 0); r != GMDS_NONE && status == GMDS_OK; r = next_3(m, r + 1)) {
      status = corners_from_faces(m, r, &faces, &c->nodes[2], &list);
      if (status == GMDS_OK && pass && list.n)
        memcpy(nodes->data + nodes->begin[r], list.data, list.n * sizeof *list.data);
      else
        nodes->begin[r + 1] = list.n;
    }
    if (!pass && status == GMDS_OK)
      status = gmds_csr_finish(nodes);
  }
  gmds_ids_clear(&list);
  gmds_csr_clear(&faces);
  return status;
}
#  endif

/* Lists the nodes of all cells in a complex that is initialised and empty. */
static inline gmds_status list_cells(const mesh *m, gmds_complex *c)
{
#  if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
  GMDS_TRY(all_adj_1_0(m, &c->nodes[1]));
#  endif
#  if GMDS__MAKES_FACES
  GMDS_TRY(all_adj_2_0(m, &c->nodes[2]));
#  endif
#  if GMDS_ORDERED_3_0 || GMDS__S_3_0 || GMDS__TETRAHEDRA
  GMDS_TRY(all_adj_3_0(m, &c->nodes[3]));
#    if !GMDS_ORDERED_3_0 && GMDS__TETRAHEDRA
  for (gmds_id r = next_3(m, 0); r != GMDS_NONE; r = next_3(m, r + 1))
    if (c->nodes[3].begin[r + 1] - c->nodes[3].begin[r] == 4) /* a mesh that is checked may lack one */
      gmds_shape_turn_outwards(GMDS_TETRAHEDRON, m->points, c->nodes[3].data + c->nodes[3].begin[r]);
#    endif
#  else
  GMDS_TRY(list_corners(m, c));
#  endif
  void *types = NULL;
  if (!gmds_resize(c->memory, &types, 0, end_3(m), 1))
    return GMDS_ERR_MEMORY;
  c->types = types;
  c->types_capacity = end_3(m);
  for (size_t r = 0; r < end_3(m); r++)
    c->types[r] = (uint8_t)(has_3(m, (gmds_id)r) ? region_type(m, (gmds_id)r) : GMDS_TETRAHEDRON);
#  if GMDS__POLYHEDRA
  GMDS_TRY(gmds_csr_begin(&c->walls, end_3(m)));
  for (gmds_id r = next_3(m, 0); r != GMDS_NONE; r = next_3(m, r + 1))
    c->walls.begin[r + 1] = c->types[r] == GMDS_POLYHEDRON ? m->r_3_2.length[r] : 0;
  GMDS_TRY(gmds_csr_finish(&c->walls));
  for (gmds_id r = next_3(m, 0); r != GMDS_NONE; r = next_3(m, r + 1)) {
    size_t n = 0;
    const gmds_id *row = row_3_2(m, r, &n);
    if (c->types[r] == GMDS_POLYHEDRON)
      memcpy(c->walls.data + c->walls.begin[r], row, n * sizeof *row);
  }
#  endif
  return GMDS_OK;
}

static inline gmds_status to_complex(const mesh *m, gmds_complex *complex)
{
  gmds_complex result;
  gmds_complex_init(&result, complex->memory, end_0(m));
  gmds_status status = list_cells(m, &result);
  if (status == GMDS_OK)
    *complex = result;
  else
    gmds_complex_clear(&result);
  return status;
}
#endif

/* ---- from a complex */

/* Whether this model may hold the cells of the complex. */
static inline gmds_status check_types(const gmds_complex *c, gmds_error *error)
{
  for (size_t r = 0; r < c->nodes[3].n; r++) {
    const int type = c->types[r];
    if (c->nodes[3].begin[r] < c->nodes[3].begin[r + 1] &&
        !((unsigned)GMDS_FN(regions) >> (type - GMDS_TETRAHEDRON) & 1))
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "region %zu is a %s, which the model does not hold", r,
                       gmds_cell_type_text((gmds_cell_type)type));
  }
  for (size_t f = 0; f < c->nodes[2].n && GMDS__MAKES_FACES; f++) {
    const size_t n = c->nodes[2].begin[f + 1] - c->nodes[2].begin[f];
    if (n && !((n == 3 && GMDS__TRIANGLES) || (n == 4 && GMDS__QUADRILATERALS) || (n >= 3 && GMDS__POLYGONS)))
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "face %zu has %zu nodes, which the model does not hold", f, n);
  }
  return GMDS_OK;
}

/* Writes the rows of a csr, whose memory is the mesh's, into a column that is empty. */
static inline gmds_status fill_rows(mesh *m, gmds_rows *rows, size_t capacity, gmds_csr *csr)
{
  gmds_id *data = csr->data;
  gmds_status status = gmds_rows_adopt(rows, &m->memory, capacity, csr->begin, csr->n, &data, csr->capacity);
  if (!data) {
    csr->data = NULL;
    csr->capacity = 0;
  }
  return status;
}

static inline gmds_status fill_column(mesh *m, gmds_column *column, size_t arity, size_t capacity, const gmds_csr *csr)
{
  GMDS_TRY(gmds_column_resize(column, &m->memory, arity * capacity));
  for (size_t c = 0; c < csr->n; c++) {
    const size_t n = csr->begin[c + 1] - csr->begin[c];
    if (n)
      memcpy(column->data + arity * c, csr->data + csr->begin[c], n * sizeof *column->data);
  }
  return GMDS_OK;
}

static inline gmds_status fill_relations(mesh *m, const gmds_complex *c, gmds_error *error)
{
  gmds_status status = GMDS_OK;
  size_t where = 0;
  gmds_csr csr;
  gmds_csr_init(&csr, &m->memory);
#define GMDS__FILL(i, j, aligned, how)                                                   \
  if (status == GMDS_OK) {                                                               \
    status = i + j ? gmds_complex_relation(c, i, j, aligned, &csr, &where)               \
                   : gmds_complex_joined(c, GMDS__MAKES_EDGES, GMDS__MAKES_FACES, &csr); \
    if (status == GMDS_OK)                                                               \
      status = how;                                                                      \
    gmds_csr_clear(&csr);                                                                \
  }
#define GMDS__FILL_SET(i, j) GMDS__FILL(i, j, 0, fill_rows(m, &m->r_##i##_##j, m->cells[i].capacity, &csr))
#define GMDS__FILL_ORDERED(i, j) GMDS__FILL(i, j, 1, fill_rows(m, &m->r_##i##_##j, m->cells[i].capacity, &csr))
#define GMDS__FILL_PAIRS(i, j) \
  GMDS__FILL(i, j, 0, gmds_pairs_fill(&m->r_##i##_##j, &m->memory, m->cells[i].capacity, csr.begin, csr.n, csr.data))
#define GMDS__FILL_INLINE(i, j)                            \
  GMDS__FILL(i, j, GMDS__CODED &&i == 3 && j == 3 ? 2 : 1, \
             fill_column(m, &m->r_##i##_##j, GMDS__ARITY_##i##_##j, m->cells[i].capacity, &csr))
  GMDS__EACH_SET(GMDS__FILL_SET)
  GMDS__EACH_ORDERED(GMDS__FILL_ORDERED)
  GMDS__EACH_PAIRS(GMDS__FILL_PAIRS)
  GMDS__EACH_INLINE(GMDS__FILL_INLINE)
#undef GMDS__FILL
#undef GMDS__FILL_SET
#undef GMDS__FILL_ORDERED
#undef GMDS__FILL_PAIRS
#undef GMDS__FILL_INLINE
  if (status == GMDS_ERR_CONFLICT)
    gmds_fail(error, status, "region %zu has a face that two others have too: R2R holds two regions a face", where);
  else if (status != GMDS_OK)
    gmds_fail(error, status, "filling a mesh of volumes: %s", gmds_status_text(status));
  return status;
}

/* Makes the cells of one dimension those of the complex, beside the attributes that they have. */
static inline gmds_status take_cells(gmds_cells *cells, const gmds_csr *nodes)
{
  if (nodes->n > cells->limit)
    return GMDS_ERR_TOO_MANY;
  if (nodes->n <= cells->end)
    return GMDS_OK;
  const size_t had = cells->end;
  GMDS_TRY(gmds_cells_resize(cells, nodes->n > cells->capacity ? nodes->n : cells->capacity));
  (void)gmds_cells_take_many(cells, nodes->n - had);
  for (size_t c = nodes->n; c-- > had;)
    if (nodes->begin[c] == nodes->begin[c + 1])
      gmds_cells_drop(cells, (gmds_id)c);
  return GMDS_OK;
}

/* Joins the complex, adds the edges and faces that this model keeps, and fills a mesh whose nodes, and cells with
 * attributes, are there. After a failure it has to be emptied. */
static inline gmds_status fill_from_complex(mesh *m, gmds_complex *c, gmds_error *error)
{
  GMDS_TRY(check_types(c, error));
  if (!c->sides.begin)
    GMDS_TRY(gmds_complex_join(c, error));
#if GMDS__MAKES_FACES || GMDS__S_3_3
  GMDS_TRY(gmds_complex_uncrossed(c, error));
#endif
  GMDS_TRY(gmds_complex_make(c, GMDS__MAKES_EDGES, GMDS__MAKES_FACES, error));
  for (int i = 1; i < 4; i++) {
    const int keeps = i == 1 ? GMDS__MAKES_EDGES : i == 2 ? GMDS__MAKES_FACES : 1;
    gmds_status status = keeps ? take_cells(&m->cells[i], &c->nodes[i]) : GMDS_OK;
    if (status != GMDS_OK)
      return gmds_fail(error, status, "%zu cells of dimension %d: %s", c->nodes[i].n, i, gmds_status_text(status));
  }
#if GMDS__TYPED
  void *types = m->types;
  if (!gmds_resize(&m->memory, &types, m->types_capacity, m->cells[3].capacity, 1))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the types of %zu regions", c->nodes[3].n);
  m->types = types;
  m->types_capacity = m->cells[3].capacity;
  if (c->nodes[3].n)
    memcpy(m->types, c->types, c->nodes[3].n);
#endif
  return fill_relations(m, c, error);
}
