// expect: gmds: <gmds/end.h> without <gmds/mesh.h>
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include <gmds/end.h>
