// expect: gmds: components() needs 2->2: add F2F, or F2N, or define GMDS_FACES TRIANGLE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | N2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/components.h>
#include <gmds/end.h>
