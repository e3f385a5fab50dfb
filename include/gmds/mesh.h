/* Opens a mesh model: a template, included once for each model (so without a guard).
 *
 *     #define GMDS_PREFIX tri                what the names begin with: tri_mesh, tri_get_adj_2_0(), ...
 *     #define GMDS_MODEL  (N|F|F2N|F2F)      cells kept and relations stored (relations.h)
 *     #define GMDS_FACES  TRIANGLE           optional: the only types of faces (TRIANGLE, QUADRILATERAL, POLYGON, with
 *     |) #define GMDS_REGIONS TETRAHEDRON       optional, where R is kept: the only types of regions (TETRAHEDRON,
 *     PYRAMID,
 *                                            PRISM, HEXAHEDRON: the four are the default; POLYHEDRON)
 *     #define GMDS_BACKEND GMDS_CMAP         optional: a combinatorial map instead of stored relations, with
 *     #define GMDS_DIM 3                     its dimension (models/cmap/interface.h)
 *     #include <gmds/mesh.h>
 *     #include <gmds/algorithms/delaunay.h>  algorithms written once over any model
 *     #include <gmds/end.h>                  closes the model: nothing leaks
 *
 * The path of every query is chosen here, by the preprocessor, from the composition tables (models/tables.h). The
 * functions are declared in models/incidence/interface.h, where regions are kept in models/volume/interface.h, which
 * are the places to read what a mesh can do. */
#if defined GMDS__OPEN
#  error "gmds: a model is still open; include <gmds/end.h> before the next <gmds/mesh.h>"
#elif defined __cplusplus
#  error "gmds: models are C: open them in a file that a C compiler reads"
#else
#  define GMDS__OPEN 1

#  ifndef GMDS_PREFIX
#    error "gmds: define GMDS_PREFIX, the first part of the model's names, before including <gmds/mesh.h>"
#  endif
#  ifndef GMDS_MODEL
#    error "gmds: define GMDS_MODEL, for instance (N|F|F2N|F2F), before including <gmds/mesh.h>"
#    define GMDS_MODEL (N | F) /* so that nothing more is said */
#  endif

#  include <gmds/cells.h>
#  include <gmds/census.h>
#  include <gmds/check.h>
#  include <gmds/check_volume.h>
#  include <gmds/checksum.h>
#  include <gmds/complex.h>
#  include <gmds/edges.h>
#  include <gmds/hops.h>
#  include <gmds/ids.h>
#  include <gmds/map.h>
#  include <gmds/models/choice.h>
#  include <gmds/parts.h>
#  include <gmds/relations.h>
#  include <gmds/rows.h>
#  include <gmds/shapes.h>
#  include <gmds/soup.h>
#  include <gmds/template.h>
#  include <gmds/topology.h>
#  include <gmds/volume.h>
#  include <string.h>

#  ifndef GMDS_BACKEND
#    define GMDS_BACKEND GMDS_INCIDENCE
#  endif
#  if GMDS_BACKEND != GMDS_INCIDENCE && GMDS_BACKEND != GMDS_CMAP
#    error "gmds: GMDS_BACKEND must be GMDS_INCIDENCE or GMDS_CMAP"
#    undef GMDS_BACKEND
#    define GMDS_BACKEND GMDS_INCIDENCE /* so that nothing more is said */
#  endif

#  if GMDS_BACKEND == GMDS_CMAP
#    include <gmds/models/cmap/mask.h>
#  else
#    ifdef GMDS_DIM
#      error "gmds: GMDS_DIM is the dimension of a map: define GMDS_BACKEND GMDS_CMAP, or leave it out"
#    endif
#    include <gmds/models/mask.h>
#    include <gmds/models/paths.h>
#    include <gmds/models/stored.h>
#  endif

#  if GMDS_BACKEND == GMDS_CMAP
#    include <gmds/models/cmap/names.h>
#    include <gmds/models/cmap/interface.h>
#    include <gmds/models/cmap/structure.h>
#    include <gmds/models/cmap/orbit.h>
#    include <gmds/models/cmap/sew.h>
#    include <gmds/models/cmap/make.h>
#    include <gmds/models/cmap/operations.h>
#    include <gmds/models/cmap/whole.h>
#    include <gmds/models/cmap/query.h>
#    include <gmds/models/cmap/add.h>
#    include <gmds/models/cmap/star.h>
#    include <gmds/models/cmap/convert.h>
#  elif GMDS__K_3
#    include <gmds/models/volume/names.h>
#    include <gmds/models/volume/interface.h>
#    include <gmds/models/volume/structure.h>
#    include <gmds/models/volume/query.h>
#    include <gmds/models/volume/bulk.h>
#    include <gmds/models/volume/queries.h>
#    include <gmds/models/volume/find.h>
#    include <gmds/models/volume/plan.h>
#    include <gmds/models/volume/link.h>
#    include <gmds/models/volume/add.h>
#    include <gmds/models/volume/remove.h>
#    include <gmds/models/volume/shape.h>
#    include <gmds/models/volume/star.h>
#    include <gmds/models/volume/compact.h>
#    include <gmds/models/volume/convert.h>
#    include <gmds/models/volume/exchange.h>
#    include <gmds/models/volume/check.h>
#  else
#    include <gmds/models/incidence/names.h>
#    include <gmds/models/incidence/interface.h>
#    include <gmds/models/incidence/structure.h>
#    include <gmds/models/incidence/query.h>
#    include <gmds/models/incidence/view.h>
#    include <gmds/models/incidence/side.h>
#    include <gmds/models/incidence/find.h>
#    include <gmds/models/incidence/add.h>
#    include <gmds/models/incidence/remove.h>
#    include <gmds/models/incidence/star.h>
#    include <gmds/models/incidence/convert.h>
#    include <gmds/models/incidence/bulk.h>
#    include <gmds/models/incidence/faces.h>
#    include <gmds/models/incidence/reading.h>
#    include <gmds/models/incidence/compact.h>
#    include <gmds/models/incidence/check.h>
#    include <gmds/models/incidence/exchange.h>
#  endif

#endif /* neither open nor C++ */
