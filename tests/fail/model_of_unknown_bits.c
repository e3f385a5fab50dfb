// expect: gmds: GMDS_MODEL holds something that is neither a cell, a relation, DIM2 nor DIM3
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | (1 << 25))
#include <gmds/mesh.h>
#include <gmds/end.h>
