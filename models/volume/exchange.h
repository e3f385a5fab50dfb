/* The checksum of a mesh. */

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
