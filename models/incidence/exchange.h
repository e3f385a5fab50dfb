/* From and to soups, and the checksum of a mesh. */

static inline gmds_status add_soup_points(mesh *m, const gmds_soup *soup, gmds_error *error)
{
  gmds_id id = 0;
  GMDS_TRY(reserve(m, soup->n_points, 0, 0));
  for (size_t v = 0; v < soup->n_points; v++) {
    double x[3] = {0, 0, 0};
    memcpy(x, soup->points + v * (size_t)soup->dim, (size_t)soup->dim * sizeof *x);
    if (GMDS__DIM == 2 && soup->dim == 3 && x[2] != 0)
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "point %zu has a third coordinate, nodes of this model have two",
                       v);
    GMDS_TRY(add_node(m, x, &id));
  }
  return GMDS_OK;
}

/* Adds the faces of the soup, which has `n` of them with `n_corners` nodes in all; *failed is the cell to blame. */
static inline gmds_status add_soup_faces(mesh *m, const gmds_soup *soup, size_t n, size_t n_corners, size_t *failed)
{
  if (n == soup->n_cells)
    return n ? add_faces(m, n, soup->begin, soup->corners, failed) : GMDS_OK;
  size_t face = 0;
  void *begin_block = NULL, *nodes_block = NULL;
  if (!gmds_resize(&m->memory, &begin_block, 0, n + 1, sizeof(size_t)))
    return GMDS_ERR_MEMORY;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(&m->memory, &nodes_block, 0, n_corners, sizeof(gmds_id))) {
    size_t *begin = begin_block;
    gmds_id *nodes = nodes_block;
    begin[0] = 0;
    for (size_t c = 0; c < soup->n_cells; c++)
      if (gmds_cell_type_dimension((gmds_cell_type)soup->types[c]) == 2) {
        size_t sides = soup->begin[c + 1] - soup->begin[c];
        memcpy(nodes + begin[face], soup->corners + soup->begin[c], sides * sizeof *nodes);
        begin[face + 1] = begin[face] + sides;
        face++;
      }
    status = add_faces(m, n, begin, nodes, &face);
    gmds_release(&m->memory, nodes, n_corners, sizeof(gmds_id));
  }
  gmds_release(&m->memory, begin_block, n + 1, sizeof(size_t));
  for (size_t c = 0; status != GMDS_OK && c < soup->n_cells; c++)
    if (gmds_cell_type_dimension((gmds_cell_type)soup->types[c]) == 2 && face-- == 0)
      *failed = c;
  return status;
}

/* The mesh is empty, so that points and nodes have the same numbers. */
static inline gmds_status fill_from_soup(mesh *m, const gmds_soup *soup, size_t *failed, gmds_error *error)
{
  size_t n = 0, n_corners = 0;
  GMDS_TRY(add_soup_points(m, soup, error));
  for (size_t c = 0; c < soup->n_cells; c++) {
    int dim = gmds_cell_type_dimension((gmds_cell_type)soup->types[c]);
    *failed = c;
    if (dim == 3)
      return GMDS_ERR_UNSUPPORTED;
    n += dim == 2;
    n_corners += dim == 2 ? soup->begin[c + 1] - soup->begin[c] : 0;
  }
  *failed = soup->n_cells;
  GMDS_TRY(add_soup_faces(m, soup, n, n_corners, failed));
#if GMDS__LINKED_EDGES
  for (size_t c = 0; c < soup->n_cells; c++) {
    const gmds_id *ends = soup->corners + soup->begin[c];
    gmds_id id = 0;
    *failed = c;
    if (gmds_cell_type_dimension((gmds_cell_type)soup->types[c]) == 1)
      GMDS_TRY(add_edge(m, ends[0], ends[1], &id));
  }
#endif
  return GMDS_OK;
}

static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error)
{
  size_t failed = soup->n_cells;
  if (m->cells[0].count || m->cells[1].count || m->cells[2].count)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be filled is not empty");
  gmds_error first = {.status = GMDS_OK}; /* a sentence about a point, if there is one */
  gmds_status status = fill_from_soup(m, soup, &failed, &first);
  if (status == GMDS_OK)
    return GMDS_OK;
  empty(m);
  if (first.status != GMDS_OK) {
    if (error)
      *error = first;
  } else if (status == GMDS_ERR_MEMORY || status == GMDS_ERR_TOO_MANY || failed >= soup->n_cells)
    gmds_fail(error, status, "a mesh of %zu points and %zu cells: %s", soup->n_points, soup->n_cells,
              gmds_status_text(status));
  else
    gmds_fail(error, status, "cell %zu (%s): %s", failed, gmds_cell_type_text((gmds_cell_type)soup->types[failed]),
              gmds_status_text(status));
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

#if GMDS_LISTS_CELLS
static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error)
{
  gmds_complex result;
  gmds_complex_init(&result, complex->memory, end_0(m));
  gmds_status status = all_adj_2_0(m, &result.nodes[2]);
#  if GMDS__CAN_1_0
  if (status == GMDS_OK)
    status = all_adj_1_0(m, &result.nodes[1]);
#  endif
  if (status == GMDS_OK)
    status = gmds_complex_join(&result, error);
  if (status == GMDS_OK)
    *complex = result;
  else
    gmds_complex_clear(&result);
  if (status != GMDS_OK)
    gmds_fail(error, status, "listing the cells of a mesh: %s", gmds_status_text(status));
  return status;
}
#endif
