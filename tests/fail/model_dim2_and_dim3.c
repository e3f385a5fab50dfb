// expect: gmds: GMDS_MODEL has both DIM2 and DIM3: a node has two coordinates or three
#define GMDS_PREFIX tri
#define GMDS_MODEL (DIM2 | DIM3 | N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
