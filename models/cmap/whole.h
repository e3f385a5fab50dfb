/* The whole map: its check, what it is apart from its numbering, and its bytes. */

static inline gmds_status check_map(const mesh *m, gmds_memory *memory, gmds_map_report *report, gmds_error *error)
{
  return gmds_map_check(&m->map, memory, report, error);
}

static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error)
{
  return gmds_map_check(&m->map, memory, NULL, error);
}

static inline gmds_status is_isomorphic(const mesh *m, const mesh *other, int with_points, gmds_memory *memory,
                                        int *same)
{
  return gmds_map_isomorphic(&m->map, &other->map, with_points, memory, same);
}

static inline gmds_status components_of_darts(const mesh *m, gmds_memory *memory, size_t *count)
{
  return gmds_map_components(&m->map, memory, count);
}

static inline gmds_status dart_checksum(const mesh *m, int with_points, gmds_memory *memory, uint64_t *sum)
{
  return gmds_map_checksum(&m->map, with_points, memory, sum);
}

static inline gmds_status write_bytes(const mesh *m, gmds_map_bytes *bytes)
{
  return gmds_map_write(&m->map, bytes);
}

static inline gmds_status read_bytes(mesh *m, size_t n, const unsigned char *data, gmds_error *error)
{
  return gmds_map_read(&m->map, n, data, error);
}
