// expect: gmds: a polyhedron is known by its faces and their nodes: add R2F|F2N to GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | F | R | F2N | R2N)
#define GMDS_REGIONS (HEXAHEDRON | POLYHEDRON)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
