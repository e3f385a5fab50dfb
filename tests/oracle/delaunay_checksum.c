/* The checksum of the Delaunay triangulation by one model, as the oracle prints it: delaunay_checksum SPEC */
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#include <gmds/io.h>
#include <inttypes.h>
#include <stdio.h>

int main(int argc, char **argv)
{
  gmds_memory memory;
  gmds_soup soup;
  tri_mesh m;
  gmds_error error = {.status = GMDS_OK};
  const gmds_delaunay_options options = {.error = &error};
  uint64_t sum = 0;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  tri_mesh_init(&m, NULL);
  if (argc != 2) {
    fprintf(stderr, "usage: delaunay_checksum SPEC\n");
    return 2;
  }
  gmds_status status = gmds_make_points(argv[1], 2, &error, &soup);
  if (status == GMDS_OK)
    status = tri_delaunay(&m, soup.n_points, soup.points, &options, NULL);
  if (status == GMDS_OK)
    status = tri_check(&m, &memory, &error);
  if (status == GMDS_OK)
    status = tri_checksum(&m, &memory, &sum);
  if (status == GMDS_OK)
    printf("%016" PRIx64 "\n", sum);
  else
    fprintf(stderr, "delaunay_checksum: %s\n", error.text);
  tri_mesh_clear(&m);
  gmds_soup_clear(&soup);
  return status != GMDS_OK;
}
