// expect: gmds: define GMDS_PREFIX, the first part of the model's names, before including <gmds/mesh.h>
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
