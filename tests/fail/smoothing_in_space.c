// expect: gmds: smooth() moves nodes of the plane: take DIM3 out of GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (DIM3 | N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/algorithms/smoothing.h>
#include <gmds/end.h>
