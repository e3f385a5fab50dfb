// expect: gmds: GMDS_MODEL stores a relation of regions but keeps none: add R
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | F | F2N | R2R)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
