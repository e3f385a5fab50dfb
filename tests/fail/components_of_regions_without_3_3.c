// expect: gmds: components() of regions needs 3->3: add R2R, or R2N, or R2F with F2N
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | N2R)
#include <gmds/mesh.h>
#include <gmds/algorithms/components.h>
#include <gmds/end.h>
