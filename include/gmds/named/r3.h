/* Opens the model R3 of volumes (named.h): faces between regions and nodes, no edges: finite volumes of any
 * polyhedra. */
#define GMDS_MODEL (N | F | R | N2F | F2N | F2R | R2F)
#include <gmds/mesh.h>
