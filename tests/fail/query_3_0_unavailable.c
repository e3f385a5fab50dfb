// expect: gmds: model 'vol' cannot answer 3->0: add R2N, or R2F with F2N, or R2E with E2N to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | F | R)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out);
gmds_status ask(const vol_mesh *m, gmds_id c, gmds_ids *out)
{
  return vol_get_adj_3_0(m, c, out);
}
