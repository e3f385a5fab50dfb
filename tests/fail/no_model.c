// expect: gmds: define GMDS_MODEL, for instance (N|F|F2N|F2F), before including <gmds/mesh.h>
#define GMDS_PREFIX tri
#include <gmds/mesh.h>
#include <gmds/end.h>
