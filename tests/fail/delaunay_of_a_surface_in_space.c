// expect: gmds: delaunay() triangulates the plane: take DIM3 out of GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (DIM3 | N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
