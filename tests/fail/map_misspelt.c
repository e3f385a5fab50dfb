// expect: gmds: GMDS_MODEL is empty or misspelt: name the cells that the map keeps, for instance (N|F)
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (Nodes)
#include <gmds/mesh.h>
#include <gmds/end.h>
