// expect: gmds: models of this version end at faces: take R and its relations out of GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | N2R)
#include <gmds/mesh.h>
#include <gmds/end.h>
