// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/delaunay.h>
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include <gmds/algorithms/delaunay.h>
