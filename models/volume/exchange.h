/* Conversion between models of volumes, from and to soups, and the checksum. */

#if GMDS_LISTS_CELLS
static inline gmds_status get_volume(const mesh *m, gmds_volume *volume, gmds_error *error)
{
  gmds_volume result;
  void *points = NULL;
  gmds_volume_init(&result, volume->memory);
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 4 && status == GMDS_OK; i++)
    status = gmds_cells_copy(&m->cells[i], &result.cells[i]);
  if (status == GMDS_OK && !gmds_resize(volume->memory, &points, 0, end_0(m), 3 * sizeof(double)))
    status = GMDS_ERR_MEMORY;
  result.points = points;
  if (status == GMDS_OK) {
    if (end_0(m))
      memcpy(points, m->points, 3 * end_0(m) * sizeof(double));
    status = to_complex(m, &result.complex);
  }
  if (status != GMDS_OK) {
    gmds_volume_clear(&result);
    return gmds_fail(error, status, "listing the cells of a mesh: %s", gmds_status_text(status));
  }
  gmds_volume_clear(volume);
  *volume = result;
  return GMDS_OK;
}

static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error)
{
  gmds_status status = to_complex(m, complex);
  if (status != GMDS_OK)
    return gmds_fail(error, status, "listing the cells of a mesh: %s", gmds_status_text(status));
  status = gmds_complex_join(complex, error);
  if (status != GMDS_OK)
    gmds_complex_clear(complex);
  return status;
}

static inline gmds_status to_soup(const mesh *m, gmds_soup *soup, gmds_error *error)
{
  gmds_volume volume;
  gmds_volume_init(&volume, soup->memory);
  gmds_status status = get_volume(m, &volume, error);
  if (status == GMDS_OK)
    status = gmds_volume_to_soup(&volume, soup, error);
  gmds_volume_clear(&volume);
  return status;
}
#endif

static inline gmds_status fill_volume(mesh *m, gmds_volume *volume, gmds_error *error)
{
  const int keeps[4] = {1, GMDS__MAKES_EDGES, GMDS__MAKES_FACES, 1};
  gmds_status status = GMDS_OK;
  GMDS_TRY(check_types(&volume->complex, error));
  for (int i = 0; i < 4 && status == GMDS_OK; i++)
    if (keeps[i])
      status = gmds_cells_copy(&volume->cells[i], &m->cells[i]);
  void *points = NULL;
  const size_t n = m->cells[0].capacity;
  if (status == GMDS_OK && !gmds_resize(&m->memory, &points, 0, n, 3 * sizeof(double)))
    status = GMDS_ERR_MEMORY;
  if (status != GMDS_OK)
    return gmds_fail(error, status, "a mesh of %zu nodes and %zu regions: %s", volume->cells[0].count,
                     volume->cells[3].count, gmds_status_text(status));
  m->points = points;
  m->points_capacity = n;
  if (n)
    memcpy(points, volume->points, 3 * n * sizeof(double));
  return fill_from_complex(m, &volume->complex, error);
}

static inline gmds_status set_volume(mesh *m, gmds_volume *volume, gmds_error *error)
{
  if (count_0(m) || count_1(m) || count_2(m) || count_3(m))
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be filled is not empty");
  for (int i = 0; i < 4; i++)
    if (m->cells[i].attributes)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh to be filled has attributes");
  empty(m);
  gmds_status status = fill_volume(m, volume, error);
  if (status != GMDS_OK)
    mesh_clear(m);
  return status;
}

static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error)
{
  gmds_volume volume;
  gmds_volume_init(&volume, &m->memory);
  gmds_status status = gmds_volume_from_soup(&volume, soup, error);
  if (status == GMDS_OK)
    status = set_volume(m, &volume, error);
  gmds_volume_clear(&volume);
  return status;
}

#if GMDS_LISTS_CELLS
/* Makes what `other` holds the mesh's, whose own goes. */
static inline void become(mesh *m, mesh *other)
{
  const size_t limit = m->memory.limit, peak = m->memory.live + other->memory.peak, had = m->memory.peak;
  mesh_clear(m);
  clear_scratch(other);
  *m = *other;
  m->memory.limit = limit;
  m->memory.peak = peak > had ? peak : had;
  for (int i = 0; i < 4; i++)
    m->cells[i].alive.memory = &m->memory;
  gmds_ids_init(&m->plan, &m->memory);
  gmds_ids_init(&m->found, &m->memory);
  gmds_ids_init(&m->more, &m->memory);
}

static inline gmds_status permute(mesh *m, gmds_id *const maps[4])
{
  gmds_volume volume, renumbered;
  mesh other;
  mesh_init(&other, &m->memory.allocator);
  gmds_volume_init(&volume, &m->memory);
  gmds_volume_init(&renumbered, &m->memory);
  gmds_status status = get_volume(m, &volume, NULL);
  if (status == GMDS_OK)
    status = gmds_volume_copy_as(&volume, maps, &renumbered);
  gmds_volume_clear(&volume);
  other.memory.limit = m->memory.limit - m->memory.live;
  if (status == GMDS_OK)
    status = set_volume(&other, &renumbered, NULL);
  gmds_volume_clear(&renumbered);
  if (status == GMDS_OK)
    become(m, &other);
  else
    mesh_clear(&other);
  return status;
}
#endif

#if GMDS__CAN_3_0
static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum)
{
  gmds_csr nodes;
  gmds_csr_init(&nodes, memory);
  GMDS_TRY(all_adj_3_0(m, &nodes));
  uint64_t total = 0;
  gmds_status status = GMDS_OK;
  for (gmds_id r = next_3(m, 0); r != GMDS_NONE && status == GMDS_OK; r = next_3(m, r + 1)) {
    uint64_t h = 0;
    size_t begin = nodes.begin[r], n = nodes.begin[r + 1] - begin;
    status = gmds_checksum_cell(3, m->points, n, nodes.data + begin, &h);
    total += h;
  }
  gmds_csr_clear(&nodes);
  if (status == GMDS_OK)
    *sum = total;
  return status;
}
#endif
