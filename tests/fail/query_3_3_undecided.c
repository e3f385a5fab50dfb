// Two hexahedra may share four nodes and no face.
// expect: gmds: model 'vol' cannot decide 3->3 on cells that are no simplices: add R2N (where it asks for faces, F2N) to GMDS_MODEL, or define GMDS_REGIONS TETRAHEDRON
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | N2R)
#define GMDS_REGIONS HEXAHEDRON
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out);
gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out)
{
  return vol_get_adj_3_3(m, c, out);
}
