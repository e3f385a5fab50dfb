// Two nodes of a quadrilateral need not be joined by a side of it.
// expect: gmds: model 'tri' cannot decide 0->0 on faces that are no triangles: add F2N to GMDS_MODEL, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | N2F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out)
{
  return tri_get_adj_0_0(m, v, out);
}
