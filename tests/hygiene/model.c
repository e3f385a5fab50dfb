/* A model and its algorithms, opened and closed; without MODEL only the headers that they rest on. */
#include <gmds/models/choice.h>
#include <gmds/models/tables.h>
#include "headers.h"
#include <string.h>
#ifdef MODEL
#  define GMDS_PREFIX some
#  define GMDS_MODEL MODEL
#  ifdef FACES
#    define GMDS_FACES FACES
#  endif
#  ifdef MAP
#    define GMDS_BACKEND GMDS_CMAP
#    define GMDS_DIM MAP
#  endif
#  ifdef REGIONS
#    define GMDS_REGIONS REGIONS
#  endif
#  include <gmds/mesh.h>
#  if GMDS_TOP == 2 || defined TRIANGULATES
#    include <gmds/algorithms/boundary.h>
#    include <gmds/algorithms/components.h>
#    include <gmds/algorithms/delaunay.h>
#    include <gmds/algorithms/manifold.h>
#    include <gmds/algorithms/quality.h>
#    include <gmds/algorithms/relations.h>
#    include <gmds/algorithms/renumber.h>
#    include <gmds/algorithms/smoothing.h>
#  endif
#  include <gmds/end.h>
#  undef MODEL
#  undef FACES
#  undef MAP
#  undef REGIONS
#  undef TRIANGULATES
#endif
