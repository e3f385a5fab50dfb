// expect: gmds: a model keeps nodes and faces, or nodes and regions: add N|F or N|R to GMDS_MODEL
#define GMDS_PREFIX tri
#define GMDS_MODEL (F | F2F)
#include <gmds/mesh.h>
#include <gmds/end.h>
