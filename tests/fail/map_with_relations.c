// expect: gmds: a combinatorial map stores betas, which answer every query: take the relations out of GMDS_MODEL
#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
