/* From and to other models, by way of soups, volumes and complexes (core/map_convert.c), and the checksum of cells. */

#if GMDS_LISTS_CELLS
static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error)
{
  return gmds_map_get_complex(&m->map, complex, error);
}

static inline gmds_status get_volume(const mesh *m, gmds_volume *volume, gmds_error *error)
{
  return gmds_map_get_volume(&m->map, volume, error);
}

static inline gmds_status set_volume(mesh *m, gmds_volume *volume, gmds_error *error)
{
  return gmds_map_set_volume(&m->map, volume, error);
}

static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error)
{
  gmds_volume volume;
  gmds_volume_init(&volume, &m->map.memory);
  gmds_status status = gmds_volume_from_soup(&volume, soup, error);
  if (status == GMDS_OK)
    status = set_volume(m, &volume, error);
  gmds_volume_clear(&volume);
  return status;
}

static inline gmds_status write_soup(const mesh *m, gmds_soup *soup, gmds_error *error)
{
  return gmds_map_to_soup(&m->map, soup, error);
}

#  if GMDS__N == 2
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup)
{
  return write_soup(m, soup, NULL);
}

static inline gmds_status add_faces(mesh *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed)
{
  return gmds_map_add_faces(&m->map, n, begin, nodes, failed);
}
#  else
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup, gmds_error *error)
{
  return write_soup(m, soup, error);
}
#  endif

static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum)
{
  return gmds_map_cells_checksum(&m->map, memory, sum);
}
#endif
