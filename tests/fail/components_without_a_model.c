// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/components.h>
#include <gmds/algorithms/components.h>
