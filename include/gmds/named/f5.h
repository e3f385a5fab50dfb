/* Opens the model F5 of volumes (named.h): all that is around a node at once, for smoothing and local remeshing
 * with every cell kept. */
#define GMDS_MODEL (N | E | F | R | N2E | N2F | N2R | E2N | F2E | R2F)
#include <gmds/mesh.h>
