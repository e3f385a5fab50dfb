/* From and to soups, and the checksum of a mesh. */

static inline gmds_status add_soup_face(mesh *m, const gmds_soup *soup, size_t c, const gmds_id *node_of,
                                        gmds_ids *list)
{
  gmds_id id = 0;
  list->n = 0;
  for (size_t k = soup->begin[c]; k < soup->begin[c + 1]; k++)
    GMDS_TRY(gmds_ids_push(list, node_of[soup->corners[k]]));
  return add_face(m, list->n, list->data, &id);
}

static inline gmds_status fill_from_soup(mesh *m, const gmds_soup *soup, gmds_id *node_of, gmds_ids *list,
                                         gmds_error *error)
{
  GMDS_TRY(reserve(m, soup->n_points, 0, 0));
  for (size_t v = 0; v < soup->n_points; v++) {
    double x[3] = {0, 0, 0};
    memcpy(x, soup->points + v * (size_t)soup->dim, (size_t)soup->dim * sizeof *x);
    if (GMDS__DIM == 2 && soup->dim == 3 && x[2] != 0)
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "point %zu has a third coordinate, nodes of this model have two",
                       v);
    GMDS_TRY(add_node(m, x, &node_of[v]));
  }
  for (size_t c = 0; c < soup->n_cells; c++) {
    int dim = gmds_cell_type_dimension((gmds_cell_type)soup->types[c]);
    gmds_status status = GMDS_OK;
    if (dim == 2)
      status = add_soup_face(m, soup, c, node_of, list);
#if GMDS__LINKED_EDGES
    gmds_id id = 0;
    const gmds_id *ends = soup->corners + soup->begin[c];
    if (dim == 1)
      status = add_edge(m, node_of[ends[0]], node_of[ends[1]], &id);
#endif
    if (dim == 3)
      status = GMDS_ERR_UNSUPPORTED;
    if (status != GMDS_OK)
      return gmds_fail(error, status, "cell %zu (%s): %s", c, gmds_cell_type_text((gmds_cell_type)soup->types[c]),
                       gmds_status_text(status));
  }
  return GMDS_OK;
}

static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error)
{
  if (m->cells[0].count || m->cells[1].count || m->cells[2].count)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be filled is not empty");
  void *node_of = NULL;
  gmds_ids list = {.memory = &m->memory};
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(&m->memory, &node_of, 0, soup->n_points, sizeof(gmds_id)))
    status = fill_from_soup(m, soup, node_of, &list, error);
  if (status == GMDS_ERR_MEMORY || status == GMDS_ERR_TOO_MANY)
    gmds_fail(error, status, "a mesh of %zu points and %zu cells: %s", soup->n_points, soup->n_cells,
              gmds_status_text(status));
  gmds_ids_clear(&list);
  gmds_release(&m->memory, node_of, node_of ? soup->n_points : 0, sizeof(gmds_id));
  if (status != GMDS_OK)
    empty(m);
  return status;
}

#if GMDS_ORDERED_2_0 || (GMDS__CAN_2_0 && GMDS__SIMPLICIAL)
static inline gmds_status fill_soup(const mesh *m, gmds_id *number, const gmds_csr *nodes, gmds_soup *soup)
{
  gmds_id fresh = 0;
  GMDS_TRY(gmds_soup_reserve(soup, m->cells[0].count, m->cells[2].count, nodes->begin[nodes->n]));
  for (gmds_id v = next_0(m, 0); v != GMDS_NONE; v = next_0(m, v + 1)) {
    number[v] = fresh++;
    GMDS_TRY(gmds_soup_add_point(soup, point(m, v)));
  }
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1)) {
    gmds_id *row = nodes->data + nodes->begin[f];
    size_t n = nodes->begin[f + 1] - nodes->begin[f];
    for (size_t k = 0; k < n; k++)
      row[k] = number[row[k]];
    GMDS_TRY(gmds_soup_add_cell(soup, n == 3 ? GMDS_TRIANGLE : n == 4 ? GMDS_QUADRILATERAL : GMDS_POLYGON, n, row));
  }
  return GMDS_OK;
}

static inline gmds_status to_soup(const mesh *m, gmds_soup *soup)
{
  gmds_soup result;
  gmds_csr nodes;
  void *number = NULL;
  size_t n = m->cells[0].end;
  gmds_soup_init(&result, soup->memory, GMDS__DIM);
  gmds_csr_init(&nodes, soup->memory);
  gmds_status status = all_adj_2_0(m, &nodes);
  if (status == GMDS_OK && !gmds_resize(soup->memory, &number, 0, n, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  if (status == GMDS_OK)
    status = fill_soup(m, number, &nodes, &result);
  gmds_release(soup->memory, number, number ? n : 0, sizeof(gmds_id));
  gmds_csr_clear(&nodes);
  if (status == GMDS_OK) {
    gmds_soup_clear(soup);
    *soup = result;
  } else
    gmds_soup_clear(&result);
  return status;
}
#endif

#if GMDS__CAN_2_0
static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum)
{
  gmds_csr nodes;
  gmds_csr_init(&nodes, memory);
  GMDS_TRY(all_adj_2_0(m, &nodes));
  uint64_t total = 0;
  gmds_status status = GMDS_OK;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE && status == GMDS_OK; f = next_2(m, f + 1)) {
    uint64_t h = 0;
    size_t begin = nodes.begin[f], n = nodes.begin[f + 1] - begin;
    status = gmds_checksum_cell(GMDS__DIM, m->points, n, nodes.data + begin, &h);
    total += h;
  }
  gmds_csr_clear(&nodes);
  if (status == GMDS_OK)
    *sum = total;
  return status;
}
#endif
