/* Results of Delaunay triangulations. */
#include <gmds/delaunay.h>

void gmds_delaunay_result_init(gmds_delaunay_result *result, const gmds_allocator *allocator)
{
  *result = (gmds_delaunay_result){.dimension = -1};
  gmds_memory_init(&result->memory, allocator);
}

void gmds_delaunay_result_clear(gmds_delaunay_result *result)
{
  gmds_release(&result->memory, result->node_of, result->node_of ? result->points : 0, sizeof *result->node_of);
  gmds_release(&result->memory, result->chain, result->chain ? result->distinct : 0, sizeof *result->chain);
  gmds_release(&result->memory, result->triangles, 3 * result->n_triangles, sizeof *result->triangles);
  gmds_memory memory = result->memory;
  *result = (gmds_delaunay_result){.memory = memory, .dimension = -1};
}
