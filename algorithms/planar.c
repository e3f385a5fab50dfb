/* Points of one plane in space, for Delaunay triangulations of volumes: the text of the plane over a surface in
 * space. */
#include <gmds/delaunay.h>
#include <string.h>

#define GMDS_PREFIX gmds_planar
#define GMDS_MODEL (DIM3 | N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

gmds_status gmds_delaunay_planar(size_t n, const double *xyz, gmds_delaunay_result *result)
{
  gmds_planar_mesh m;
  gmds_delaunay_result flat;
  gmds_id *node = NULL; /* of each node of the mesh the one that was given */
  void *block = NULL, *triangles = NULL;
  (void)gmds_planar_mesh_init(&m, &result->memory.allocator);
  gmds_delaunay_result_init(&flat, &result->memory.allocator);
  gmds_status status = gmds_planar_delaunay(&m, n, xyz, NULL, &flat);
  const size_t count = gmds_planar_count_2(&m);
  if (status == GMDS_OK && !(gmds_resize(&flat.memory, &block, 0, n, sizeof *node) &&
                             gmds_resize(&result->memory, &triangles, 0, 3 * count, sizeof *node)))
    status = GMDS_ERR_MEMORY;
  node = block;
  if (status == GMDS_OK) {
    for (size_t i = 0; i < n; i++)
      node[flat.node_of[i]] = (gmds_id)i;
    gmds_id *to = triangles;
    for (gmds_id f = 0; f < count; f++, to += 3)
      for (size_t k = 0; k < 3; k++)
        to[k] = node[gmds_planar_face_node(&m, f, k)];
    result->triangles = triangles;
    result->n_triangles = count;
  }
  gmds_release(&flat.memory, block, block ? n : 0, sizeof *node);
  gmds_delaunay_result_clear(&flat);
  gmds_planar_mesh_clear(&m);
  return status;
}
