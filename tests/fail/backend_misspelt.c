// expect: gmds: GMDS_BACKEND must be GMDS_INCIDENCE
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#define GMDS_BACKEND GMDS_INCIDENT
#include <gmds/mesh.h>
#include <gmds/end.h>
