/* Closes the model that <gmds/mesh.h> opened: every short name and every macro of it is gone. */
#ifndef GMDS__OPEN
#  error "gmds: <gmds/end.h> without <gmds/mesh.h>"
#endif
#if GMDS_BACKEND == GMDS_CMAP
#  include <gmds/models/cmap/names_end.h>
#  include <gmds/models/cmap/mask_end.h>
#else
#  if GMDS__K_3
#    include <gmds/models/volume/names_end.h>
#  else
#    include <gmds/models/incidence/names_end.h>
#  endif
#  include <gmds/models/paths_end.h>
#  include <gmds/models/mask_end.h>
#endif
#undef GMDS__OPEN
#undef GMDS_PREFIX
#undef GMDS_MODEL
#undef GMDS_FACES
#undef GMDS_REGIONS
#undef GMDS_BACKEND
#undef GMDS_DIM
