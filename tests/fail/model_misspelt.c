// expect: F2Q
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2Q)
#include <gmds/mesh.h>
#include <gmds/end.h>
