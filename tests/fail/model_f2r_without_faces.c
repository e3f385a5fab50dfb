// expect: gmds: GMDS_MODEL stores a relation of faces but keeps none: add F
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2N | F2R)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
