// expect: gmds: model 'vol' stores no relation 3->0 to view: add R2N to GMDS_MODEL, or ask get_adj_3_0()
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | N2R)
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n)
{
  return vol_view_3_0(m, c, n);
}
