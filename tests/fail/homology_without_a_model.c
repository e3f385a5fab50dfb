// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/homology.h>
#include <gmds/algorithms/homology.h>
