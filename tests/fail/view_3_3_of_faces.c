// expect: gmds: 3->3 has no view: an entry of R2R may be empty and carry a face: ask across() or get_adj_3_3()
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const vol_mesh *m, gmds_id c, size_t *n)
{
  return vol_view_3_3(m, c, n);
}
