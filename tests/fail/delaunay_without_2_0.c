// expect: gmds: delaunay() needs 2->0: add F2N, or F2E with E2N, or N2F, to GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
