// expect: gmds: GMDS_MODEL stores a relation of edges but keeps none: add E
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | E2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
