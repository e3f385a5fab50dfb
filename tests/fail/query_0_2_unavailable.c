// expect: gmds: model 'tri' cannot answer 0->2: add N2F, or N2E with E2F to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id v, gmds_ids *out)
{
  return tri_get_adj_0_2(m, v, out);
}
