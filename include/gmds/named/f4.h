/* Opens the model F4 of volumes (named.h): for work on edges: collapses and swaps ask an edge for its regions, a
 * node for its edges. */
#define GMDS_MODEL (N | E | F | R | N2E | E2N | E2R | F2E | R2F)
#include <gmds/mesh.h>
