// Two nodes of a region may be joined by an edge that is none of its own.
// expect: gmds: model 'vol' cannot decide 1->3 on cells that are no simplices: add R2N (where it asks for faces, F2N) to GMDS_MODEL, or define GMDS_REGIONS TETRAHEDRON
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | R | N2E | N2R)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out);
gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out)
{
  return vol_get_adj_1_3(m, c, out);
}
