// expect: gmds: model 'tri' cannot answer 2->0: add F2N, or F2E with E2N to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out)
{
  return tri_get_adj_2_0(m, f, out);
}
