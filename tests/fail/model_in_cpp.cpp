// expect: gmds: models are C: open them in a file that a C compiler reads
#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/end.h>
