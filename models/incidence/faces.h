/* Edges and faces of a whole mesh at once: every side is looked at once, whatever the model stores. */

#if GMDS_ORDERED_2_0 || (GMDS__CAN_2_0 && GMDS__SIMPLICIAL)
static inline gmds_status all_edges(const mesh *m, gmds_edge_table *table)
{
#  if GMDS__S_2_0 && GMDS__INLINE
  const gmds_cells *faces = &m->cells[2];
  const gmds_bits *alive = faces->count < faces->end ? &faces->alive : NULL;
  return gmds_edges_of_inline(m->cells[0].end, faces->end, GMDS__SIDES, m->r_2_0.data, alive, table);
#  else
  gmds_csr nodes;
  gmds_csr_init(&nodes, table->memory);
  GMDS_TRY(all_adj_2_0(m, &nodes));
  gmds_status status = gmds_edges_of_rows(m->cells[0].end, nodes.n, nodes.begin, nodes.data, table);
  gmds_csr_clear(&nodes);
  return status;
#  endif
}
#endif

/* Takes back all edges and faces: a mesh of nodes alone. Room that was made stays. */
static inline void remove_all_faces(mesh *m)
{
#define GMDS__RELEASE_ALL(i, j)                      \
  for (size_t c = 0; c < m->r_##i##_##j.n_rows; c++) \
    gmds_rows_release(&m->r_##i##_##j, c);
#define GMDS__EMPTY_ALL(i, j)                  \
  for (size_t c = 0; c < m->cells[i].end; c++) \
    gmds_pairs_empty(&m->r_##i##_##j, c);
  GMDS__EACH_POOLED(GMDS__RELEASE_ALL)
  GMDS__EACH_PAIRS(GMDS__EMPTY_ALL)
#undef GMDS__RELEASE_ALL
#undef GMDS__EMPTY_ALL
  for (int i = 1; i < 3; i++)
    while (m->cells[i].end)
      gmds_cells_drop(&m->cells[i], (gmds_id)(m->cells[i].end - 1));
}

/* Whether n faces may be added: the first that may not is *failed. */
static inline gmds_status check_faces(mesh *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed)
{
  for (size_t f = 0; f < n; f++) {
    size_t first = begin ? begin[f] : 3 * f, sides = 3;
    if (begin)
      sides = begin[f + 1] > first ? begin[f + 1] - first : 0;
    gmds_status status = allows_sides(sides) ? check_nodes(m, sides, nodes + first) : GMDS_ERR_ARGUMENT;
    if (status != GMDS_OK) {
      *failed = status == GMDS_ERR_MEMORY ? n : f;
      return status;
    }
  }
  *failed = n;
  return GMDS_OK;
}

/* Adds the faces one after the other. at_edge has, for each edge of the table, the edge of the mesh and the face there,
 * or GMDS_NONE while there is none: so nothing is looked up. */
static inline gmds_status add_known_faces(mesh *m, const gmds_edge_table *table, const gmds_id *nodes, gmds_id *at_edge,
                                          gmds_ids *list, size_t *failed)
{
  const gmds_id two = GMDS_NONE - 1; /* where F2F holds no third */
  for (*failed = 0; *failed < table->n_faces; ++*failed) {
    size_t n = 0;
    const gmds_id *row = gmds_edge_table_row(table, *failed, &n);
    gmds_id id = 0;
    GMDS_TRY(gmds_ids_reserve(list, 2 * n));
    gmds_id *edges = list->data, *faces = list->data + n;
    for (size_t k = 0; k < n; k++) {
      edges[k] = at_edge[2 * (size_t)row[k]];
      faces[k] = at_edge[2 * (size_t)row[k] + 1];
      if (faces[k] == two)
        return GMDS_ERR_CONFLICT;
    }
    const gmds_links links = {edges, faces};
    GMDS_TRY(add_face_linked(m, n, nodes + (row - table->edges), &links, &id));
    for (size_t k = 0; k < n; k++) {
#if GMDS__MAKES_EDGES
      at_edge[2 * (size_t)row[k]] = m->plan.data[k];
#endif
#if GMDS__S_2_2
      at_edge[2 * (size_t)row[k] + 1] = faces[k] == GMDS_NONE ? id : two;
#endif
    }
  }
  return GMDS_OK;
}

static inline gmds_status add_faces(mesh *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed)
{
  size_t at = n;
  void *at_edge = NULL;
  gmds_edge_table table;
  gmds_ids list = {.memory = &m->memory};
  gmds_edge_table_init(&table, &m->memory);
  gmds_status status = count_1(m) || count_2(m) ? GMDS_ERR_ARGUMENT : check_faces(m, n, begin, nodes, &at);
  if (status == GMDS_OK)
    status = begin ? gmds_edges_of_rows(end_0(m), n, begin, nodes, &table)
                   : gmds_edges_of_inline(end_0(m), n, 3, nodes, NULL, &table);
  if (status == GMDS_OK)
    status = reserve(m, 0, GMDS__MAKES_EDGES ? table.n : 0, n);
  if (status == GMDS_OK && !gmds_resize(&m->memory, &at_edge, 0, 2 * table.n, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  if (status == GMDS_OK) {
    if (n)
      memset(at_edge, 0xff, 2 * table.n * sizeof(gmds_id));
    status = add_known_faces(m, &table, nodes, at_edge, &list, &at);
    if (status != GMDS_OK)
      remove_all_faces(m);
  }
  gmds_release(&m->memory, at_edge, at_edge ? 2 * table.n : 0, sizeof(gmds_id));
  gmds_ids_clear(&list);
  gmds_edge_table_clear(&table);
  if (status != GMDS_OK && failed)
    *failed = at;
  return status;
}
