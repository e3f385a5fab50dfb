/* Opens the model R4 of volumes (named.h): R3 with neighbours of nodes and faces. */
#define GMDS_MODEL (N | F | R | N2N | N2F | F2N | F2F | F2R | R2F)
#include <gmds/mesh.h>
