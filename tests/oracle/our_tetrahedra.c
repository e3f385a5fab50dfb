/* Our Delaunay tetrahedra for the oracle programs, which are C++ and cannot open a model. */
#include "our_tetrahedra.h"

#define GMDS_PREFIX tet
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

gmds_status our_tetrahedra(const gmds_soup *points, gmds_soup *cells, gmds_error *error)
{
  tet_mesh m;
  const gmds_delaunay_options options = {.error = error};
  tet_mesh_init(&m, NULL);
  gmds_status status = tet_delaunay(&m, points->n_points, points->points, &options, NULL);
  if (status == GMDS_OK)
    status = tet_check(&m, cells->memory, error);
  if (status == GMDS_OK)
    status = tet_to_soup(&m, cells, error);
  tet_mesh_clear(&m);
  return status;
}
