// expect: gmds: homology() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX quad
#define GMDS_MODEL (N | F | N2F)
#define GMDS_FACES QUADRILATERAL
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
