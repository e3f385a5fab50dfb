// expect: gmds: 2->2 has no view: an entry of F2F may be empty and carry a side: ask across() or get_adj_2_2()
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/end.h>

const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n);
const gmds_id *see(const tri_mesh *m, gmds_id c, size_t *n)
{
  return tri_view_2_2(m, c, n);
}
