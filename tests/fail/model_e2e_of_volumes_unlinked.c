// expect: gmds: E2E can be kept true only where edges and nodes are linked: add E2N or N2E to GMDS_MODEL
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | E | R | E2E | R2N | R2E)
#include <gmds/mesh.h>
#include <gmds/end.h>
#include "use_volume.h"
