// expect: gmds: a model is still open; include <gmds/end.h> before the next <gmds/mesh.h>
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/mesh.h>
