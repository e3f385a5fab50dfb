// flags: -ffast-math
// expect: gmds: exact predicates cannot be compiled with -ffast-math: leave the flag out for files that include this
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
