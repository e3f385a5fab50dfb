// expect: gmds: GMDS_MODEL is empty or misspelt: name what the model keeps and stores, for instance (N|F|F2N|F2F)
#define GMDS_PREFIX tri
#define GMDS_MODEL
#include <gmds/mesh.h>
#include <gmds/end.h>
