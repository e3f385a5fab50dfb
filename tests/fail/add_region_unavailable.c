// expect: gmds: model 'vol' cannot make regions: it does not tell their edges, faces or neighbours by nodes: add E2N where edges are kept, F2N where faces are, R2N where R2R is stored
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | R | R2E | R2N)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status add(vol_mesh *m, const gmds_id *v, gmds_id *id);
gmds_status add(vol_mesh *m, const gmds_id *v, gmds_id *id)
{
  return vol_add_region(m, GMDS_TETRAHEDRON, v, id);
}
