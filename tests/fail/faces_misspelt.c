// expect: gmds: GMDS_FACES must be TRIANGLE, QUADRILATERAL, POLYGON, or several with | between them
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#define GMDS_FACES TRIANGEL
#include <gmds/mesh.h>
#include <gmds/end.h>
