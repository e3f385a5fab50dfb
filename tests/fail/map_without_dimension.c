// expect: gmds: define GMDS_DIM, the dimension of the map: 2, 3 or 4
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_MODEL (N | F)
#include <gmds/mesh.h>
#include <gmds/end.h>
