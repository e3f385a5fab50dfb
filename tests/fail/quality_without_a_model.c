// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/quality.h>
#include <gmds/algorithms/quality.h>
