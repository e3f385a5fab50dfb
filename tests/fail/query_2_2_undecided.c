// Two quadrilaterals may share two nodes and no side.
// expect: gmds: model 'tri' cannot decide 2->2 on faces that are no triangles: add F2N to GMDS_MODEL, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | N2F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out)
{
  return tri_get_adj_2_2(m, f, out);
}
