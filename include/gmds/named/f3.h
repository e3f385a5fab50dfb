/* Opens the model F3 of volumes (named.h): for faces that are asked for their regions, as in finite volumes:
 * fluxes through faces, stencils around nodes. */
#define GMDS_MODEL (N | E | F | R | N2F | E2N | F2E | F2R | R2F)
#include <gmds/mesh.h>
