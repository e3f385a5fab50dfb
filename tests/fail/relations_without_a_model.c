// expect: gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/relations.h>
#include <gmds/algorithms/relations.h>
