// expect: gmds: model 'vol' stores no relation 0->3 to view: add N2R to GMDS_MODEL, or ask get_adj_0_3()
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N)
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n)
{
  return vol_view_0_3(m, c, n);
}
