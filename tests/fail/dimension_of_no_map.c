// expect: gmds: GMDS_DIM is the dimension of a map: define GMDS_BACKEND GMDS_CMAP, or leave it out
#define GMDS_PREFIX tri
#define GMDS_DIM 2
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
