// expect: HEXAGON
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#define GMDS_FACES (TRIANGLE | HEXAGON)
#include <gmds/mesh.h>
#include <gmds/end.h>
