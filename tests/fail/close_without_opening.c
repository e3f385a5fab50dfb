// expect: gmds: <gmds/end.h> without <gmds/mesh.h>
#include <gmds/end.h>
