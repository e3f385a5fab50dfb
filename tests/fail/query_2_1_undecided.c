// An edge may join two nodes of a polygon without being a side of it.
// expect: gmds: model 'tri' cannot decide 2->1 on faces that are no triangles: add F2N to GMDS_MODEL, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F | N2E | N2F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out)
{
  return tri_get_adj_2_1(m, f, out);
}
