// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/renumber.h>
#include <gmds/algorithms/renumber.h>
