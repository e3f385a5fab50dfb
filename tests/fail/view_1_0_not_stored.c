// expect: gmds: model 'tri' stores no relation 1->0 to view: add E2N to GMDS_MODEL, or ask get_adj_1_0()
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F | N2E | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n)
{
  return tri_view_1_0(m, c, n);
}
