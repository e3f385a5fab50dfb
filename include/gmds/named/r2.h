/* Opens the model R2 of volumes (named.h): R1 with neighbours of both: walks, fronts and smoothing without a set
 * operation. */
#define GMDS_MODEL (N | R | N2N | N2R | R2N | R2R)
#include <gmds/mesh.h>
