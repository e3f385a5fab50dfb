// expect: gmds: model 'tri' cannot answer 0->0: add N2N, or N2E with E2N, or N2F with F2N to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out)
{
  return tri_get_adj_0_0(m, v, out);
}
