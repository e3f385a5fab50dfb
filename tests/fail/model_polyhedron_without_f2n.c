// expect: gmds: a polyhedron is known by its faces and their nodes: add R2F|F2N to GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | F | R | E2N | F2E | R2F)
#define GMDS_REGIONS POLYHEDRON
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
