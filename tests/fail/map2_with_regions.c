// expect: gmds: a 2-map has no regions: define GMDS_DIM 3, or take R out of GMDS_MODEL
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | R)
#include <gmds/mesh.h>
#include <gmds/end.h>
