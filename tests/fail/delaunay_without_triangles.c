// expect: gmds: delaunay() makes triangles: add TRIANGLE to GMDS_FACES
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES QUADRILATERAL
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
