// expect: gmds: delaunay() does not keep E2E true: take it out of GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F | F2N | E2N | E2E)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
