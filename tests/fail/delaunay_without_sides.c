// expect: gmds: delaunay() needs to find what is at a side: add F2N, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | N2F | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
