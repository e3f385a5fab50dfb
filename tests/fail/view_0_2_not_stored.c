// expect: gmds: model 'tri' stores no relation 0->2 to view: add N2F to GMDS_MODEL, or ask get_adj_0_2()
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n)
{
  return tri_view_0_2(m, c, n);
}
