// expect: gmds: GMDS_REGIONS must be TETRAHEDRON, PYRAMID, PRISM, HEXAHEDRON, POLYHEDRON, or several with | between them
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N)
#define GMDS_REGIONS TETRAHEDRA
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
