// expect: gmds: delaunay() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a relation will do)
#define GMDS_PREFIX map2
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | E)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
