/* Opens the model F1 of volumes (named.h): one level up and down: every query is local, edges and faces carry
 * attributes; the largest of these. */
#define GMDS_MODEL (N | E | F | R | N2E | E2N | E2F | F2E | F2R | R2F)
#include <gmds/mesh.h>
