// expect: gmds: renumber() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or define GMDS_REGIONS TETRAHEDRON
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | N2R)
#include <gmds/mesh.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/end.h>
