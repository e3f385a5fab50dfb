// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/delaunay.h>
#include <gmds/algorithms/delaunay.h>
