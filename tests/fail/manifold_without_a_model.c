// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/manifold.h>
#include <gmds/algorithms/manifold.h>
