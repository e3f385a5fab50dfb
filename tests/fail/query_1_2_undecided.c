// An edge may join two nodes of a polygon without being a side of it.
// expect: gmds: model 'tri' cannot decide 1->2 on faces that are no triangles: add F2N to GMDS_MODEL, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F | E2N | N2F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id e, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id e, gmds_ids *out)
{
  return tri_get_adj_1_2(m, e, out);
}
