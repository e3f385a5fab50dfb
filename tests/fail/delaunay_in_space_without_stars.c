// expect: gmds: delaunay() needs to tell edges and faces by their nodes: add E2N where edges are kept, F2N where faces are, to GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | F | R | N2R | F2E | R2F)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
