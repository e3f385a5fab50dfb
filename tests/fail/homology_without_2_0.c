// expect: gmds: homology() needs 2->0
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | E | F | F2E)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
