// expect: gmds: a model keeps nodes and faces, or nodes and regions: add N|F or N|R to GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (R | R2R)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
