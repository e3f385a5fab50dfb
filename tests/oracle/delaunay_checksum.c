/* The checksum of the Delaunay triangulation by one model, as the oracles print it: delaunay_checksum SPEC in the
 * plane, delaunay_checksum SPEC 3 in space. With MAPS it is compiled for combinatorial maps. */
#define GMDS_PREFIX tri
#ifdef MAPS
#  define GMDS_BACKEND GMDS_CMAP
#  define GMDS_DIM 2
#  define GMDS_MODEL (N | F)
#else
#  define GMDS_MODEL (N | F | F2N | F2F)
#  define GMDS_FACES TRIANGLE
#endif
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#define GMDS_PREFIX tet
#ifdef MAPS
#  define GMDS_BACKEND GMDS_CMAP
#  define GMDS_DIM 3
#  define GMDS_MODEL (N | R)
#else
#  define GMDS_MODEL (N | R | R2N | R2R)
#  define GMDS_REGIONS TETRAHEDRON
#endif
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#include <gmds/io.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static gmds_status plane(const gmds_soup *soup, gmds_memory *memory, gmds_error *error, uint64_t *sum)
{
  tri_mesh m;
  const gmds_delaunay_options options = {.error = error};
  tri_mesh_init(&m, NULL);
  gmds_status status = tri_delaunay(&m, soup->n_points, soup->points, &options, NULL);
  if (status == GMDS_OK)
    status = tri_check(&m, memory, error);
  if (status == GMDS_OK)
    status = tri_checksum(&m, memory, sum);
  tri_mesh_clear(&m);
  return status;
}

static gmds_status space(const gmds_soup *soup, gmds_memory *memory, gmds_error *error, uint64_t *sum)
{
  tet_mesh m;
  gmds_delaunay_result result;
  const gmds_delaunay_options options = {.error = error};
  tet_mesh_init(&m, NULL);
  gmds_delaunay_result_init(&result, NULL);
  gmds_status status = tet_delaunay(&m, soup->n_points, soup->points, &options, &result);
  if (status == GMDS_OK)
    status = tet_check(&m, memory, error);
  if (status == GMDS_OK)
    status = tet_checksum(&m, memory, sum);
  for (size_t t = 0; t < result.n_triangles && status == GMDS_OK; t++) { /* points of one plane */
    uint64_t h = 0;
    status = gmds_checksum_cell(3, tet_coordinates(&m), 3, result.triangles + 3 * t, &h);
    *sum += h;
  }
  gmds_delaunay_result_clear(&result);
  tet_mesh_clear(&m);
  return status;
}

int main(int argc, char **argv)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_error error = {.status = GMDS_OK};
  uint64_t sum = 0;
  const int dim = argc == 3 && strcmp(argv[2], "3") == 0 ? 3 : 2;
  if (argc < 2 || argc > 3 || (argc == 3 && dim == 2)) {
    fprintf(stderr, "usage: delaunay_checksum SPEC [3]\n");
    return 2;
  }
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, dim);
  gmds_status status = gmds_make_points(argv[1], dim, &error, &soup);
  if (status == GMDS_OK)
    status = dim == 3 ? space(&soup, &memory, &error, &sum) : plane(&soup, &memory, &error, &sum);
  if (status == GMDS_OK)
    printf("%016" PRIx64 "\n", sum);
  else
    fprintf(stderr, "delaunay_checksum: %s\n", error.text);
  gmds_soup_clear(&soup);
  return status != GMDS_OK;
}
