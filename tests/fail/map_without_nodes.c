// expect: gmds: a map keeps nodes: add N to GMDS_MODEL
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL R
#include <gmds/mesh.h>
#include <gmds/end.h>
