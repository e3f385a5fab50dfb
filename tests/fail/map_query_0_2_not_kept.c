// expect: gmds: map 'map3' cannot answer 0->2: keep faces: add F to GMDS_MODEL
#define GMDS_PREFIX map3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL (N | R)
#include <gmds/mesh.h>
#include <gmds/end.h>

gmds_status ask(const map3_mesh *m, gmds_id v, gmds_ids *out);
gmds_status ask(const map3_mesh *m, gmds_id v, gmds_ids *out)
{
  return map3_get_adj_0_2(m, v, out);
}
