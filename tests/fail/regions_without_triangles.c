// expect: gmds: GMDS_FACES leaves out a type of face that the regions of the model have
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | F | R | F2N | R2F)
#define GMDS_REGIONS TETRAHEDRON
#define GMDS_FACES QUADRILATERAL
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
