// expect: gmds: GMDS_MODEL stores a relation of edges but keeps none: add E
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N | R2E)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
