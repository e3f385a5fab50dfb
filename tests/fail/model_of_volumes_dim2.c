// expect: gmds: a model of volumes has nodes of three coordinates: take DIM2 out of GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (DIM2 | N | R | R2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
