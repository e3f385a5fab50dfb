// expect: gmds: renumber() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | N2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/end.h>
