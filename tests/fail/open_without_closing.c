// A second model where the first was never closed.
// expect: gmds: a model is still open; include <gmds/end.h> before the next <gmds/mesh.h>
#define GMDS_PREFIX one
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#undef GMDS_PREFIX
#undef GMDS_MODEL
#define GMDS_PREFIX two
#define GMDS_MODEL (N | F | N2F)
#include <gmds/mesh.h>
#include <gmds/end.h>
