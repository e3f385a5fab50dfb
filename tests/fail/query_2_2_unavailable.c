// expect: gmds: model 'tri' cannot answer 2->2: add F2F, or F2E with E2F, or F2N with N2F to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out);
gmds_status ask(const tri_mesh *m, gmds_id f, gmds_ids *out)
{
  return tri_get_adj_2_2(m, f, out);
}
