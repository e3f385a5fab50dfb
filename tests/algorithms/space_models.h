/* The models of volumes on which the algorithms are tested: each reads, builds or goes without other relations, keeps
 * the order of regions or does not. X(prefix) */
#define RUN t_nodes
#define GMDS_MODEL (N | R | R2N)
#define GMDS_REGIONS TETRAHEDRON
#include "algorithms/space_model.h"

#define RUN t_beyond
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS TETRAHEDRON
#include "algorithms/space_model.h"

#define RUN t_around
#define GMDS_MODEL (N | R | N2R)
#define GMDS_REGIONS TETRAHEDRON
#include "algorithms/space_model.h"

#define RUN t_edges
#define GMDS_MODEL (N | E | R | E2N | R2E)
#define GMDS_REGIONS TETRAHEDRON
#include "algorithms/space_model.h"

#define RUN nodes
#define GMDS_MODEL (N | R | R2N)
#include "algorithms/space_model.h"

#define RUN beyond
#define GMDS_MODEL (N | R | R2N | R2R)
#include "algorithms/space_model.h"

#define RUN r2
#define GMDS_MODEL (N | R | N2N | N2R | R2N | R2R)
#include "algorithms/space_model.h"

#define RUN f1
#define GMDS_MODEL (N | E | F | R | N2E | E2N | E2F | F2E | F2R | R2F)
#include "algorithms/space_model.h"

#define RUN r3
#define GMDS_MODEL (N | F | R | N2F | F2N | F2R | R2F)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON | POLYHEDRON)
#include "algorithms/space_model.h"

#define RUN whole
#define GMDS_MODEL \
  (N | E | F | R | N2N | N2E | N2F | N2R | E2N | E2E | E2F | E2R | F2N | F2E | F2F | F2R | R2N | R2E | R2F | R2R)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON | POLYHEDRON)
#include "algorithms/space_model.h"

#define SPACE_MODELS(X) X(t_nodes) X(t_beyond) X(t_around) X(t_edges) X(nodes) X(beyond) X(r2) X(f1) X(r3) X(whole)
