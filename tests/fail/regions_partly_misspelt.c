// expect: OCTAHEDRON
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N)
#define GMDS_REGIONS (TETRAHEDRON | OCTAHEDRON)
#include <gmds/mesh.h>
#include <gmds/end.h>
