// expect: gmds: delaunay() makes tetrahedra: add TETRAHEDRON to GMDS_REGIONS
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS HEXAHEDRON
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
