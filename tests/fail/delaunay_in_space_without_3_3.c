// expect: gmds: delaunay() needs 3->3: add R2R, or N2R, or define GMDS_REGIONS TETRAHEDRON
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | N2R)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
