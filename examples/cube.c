/* A cube of points in space: triangulated, then asked what is around its middle. */
#define GMDS_PREFIX  vol
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/named/r2.h>            /* N|R|N2N|N2R|R2N|R2R */
#include <gmds/algorithms/delaunay.h> /* vol_delaunay() */
#include <gmds/end.h>
#include <stdio.h>

int main(void)
{
  const double xyz[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 0.5, 0.5, 0.5};
  vol_mesh m;
  gmds_delaunay_result result = {0};
  gmds_status s = vol_mesh_init(&m, NULL);
  if (s == GMDS_OK)
    s = vol_delaunay(&m, 9, xyz, NULL, &result);
  gmds_ids around = {.memory = vol_mesh_memory(&m)};
  if (s == GMDS_OK)
    s = vol_get_adj_0_3(&m, result.node_of[8], &around);
  if (s == GMDS_OK)
    printf("%lu tetrahedra, %lu of them at the middle\n", (unsigned long)vol_count_3(&m), (unsigned long)around.n);
  gmds_ids_clear(&around);
  gmds_delaunay_result_clear(&result);
  vol_mesh_clear(&m);
  return s != GMDS_OK;
}
