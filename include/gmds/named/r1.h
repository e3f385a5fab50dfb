/* Opens the model R1 of volumes (named.h): what finite elements need: the nodes of elements and the elements at
 * nodes; the smallest that is local. */
#define GMDS_MODEL (N | R | N2R | R2N)
#include <gmds/mesh.h>
