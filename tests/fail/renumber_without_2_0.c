// expect: gmds: renumber() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a relation will do)
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/end.h>
