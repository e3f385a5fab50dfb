// expect: gmds: homology() is of surfaces
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | R | R2N)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
