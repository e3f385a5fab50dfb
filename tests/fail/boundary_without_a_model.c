// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/boundary.h>
#include <gmds/algorithms/boundary.h>
