/* Opens the model F6 of volumes (named.h): F5 without the edges around a node. */
#define GMDS_MODEL (N | E | F | R | N2F | N2R | E2N | F2E | R2F)
#include <gmds/mesh.h>
