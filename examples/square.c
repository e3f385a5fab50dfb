#define GMDS_PREFIX tri
#define GMDS_MODEL  (N|F|F2N|F2F)
#include <gmds/mesh.h>                           /* tri_mesh, tri_get_adj_2_0(), tri_add_triangle(), ... */
#include <gmds/algorithms/delaunay.h>            /* tri_delaunay() */
#include <gmds/end.h>                            /* closes it: nothing of N, F, F2N leaks */
#include <stdio.h>

int main(void)
{
  const double xy[] = {0, 0, 1, 0, 1, 1, 0, 1};
  tri_mesh m;
  gmds_status s = tri_mesh_init(&m, NULL);                                  /* NULL: the default allocator */
  if (s == GMDS_OK) s = tri_delaunay(&m, 4, xy, NULL, NULL);                /* options, result: both may be NULL */
  if (s == GMDS_OK) printf("%lu triangles\n", (unsigned long)tri_count_2(&m));
  tri_mesh_clear(&m);
  return s != GMDS_OK;
}
