// expect: gmds: a map holds cells of every type: GMDS_FACES and GMDS_REGIONS are for models of stored relations
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/end.h>
