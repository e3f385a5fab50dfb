/* Opens the model F2 of volumes (named.h): circular, down by one level and from nodes up to regions: every cell is
 * kept for little, going up passes through the nodes. */
#define GMDS_MODEL (N | E | F | R | N2R | E2N | F2E | R2F)
#include <gmds/mesh.h>
