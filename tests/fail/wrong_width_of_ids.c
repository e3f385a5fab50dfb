// expect: gmds: GMDS_ID_BITS must be 32 or 64
#define GMDS_CONFIG_H
#define GMDS_ID_BITS 16
#include <gmds/ids.h>
