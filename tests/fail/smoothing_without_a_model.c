// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/smoothing.h>
#include <gmds/algorithms/smoothing.h>
