/* The models on which the algorithms are tested: each reads, builds or goes without other relations. X(prefix) */
#define GMDS_PREFIX t_nodes
#define GMDS_MODEL (N | F | F2N)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_nodes
#include "algorithms/body.h"

#define GMDS_PREFIX t_around
#define GMDS_MODEL (N | F | N2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_around
#include "algorithms/body.h"

#define GMDS_PREFIX t_beyond
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_beyond
#include "algorithms/body.h"

#define GMDS_PREFIX t_loose
#define GMDS_MODEL (N | F | N2F | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_loose
#include "algorithms/body.h"

#define GMDS_PREFIX t_edges
#define GMDS_MODEL (N | E | F | N2E | E2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_edges
#include "algorithms/body.h"

#define GMDS_PREFIX t_order
#define GMDS_MODEL (N | E | F | E2N | F2E | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN t_order
#include "algorithms/body.h"

#define GMDS_PREFIX nodes
#define GMDS_MODEL (N | F | F2N)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN nodes
#include "algorithms/body.h"

#define GMDS_PREFIX beyond
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN beyond
#include "algorithms/body.h"

#define GMDS_PREFIX order
#define GMDS_MODEL (N | E | F | E2N | F2E)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN order
#include "algorithms/body.h"

#define GMDS_PREFIX both
#define GMDS_MODEL (N | F | F2N | N2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN both
#include "algorithms/body.h"

#define GMDS_PREFIX whole
#define GMDS_MODEL (N | E | F | N2N | N2E | N2F | E2N | E2E | E2F | F2N | F2E | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_2_0 };
#include <gmds/end.h>
#define RUN whole
#include "algorithms/body.h"

#define TRIANGLE_MODELS(X) X(t_nodes) X(t_around) X(t_beyond) X(t_loose) X(t_edges) X(t_order)
#define ALL_MODELS(X) X(nodes) X(beyond) X(order) X(both) X(whole)
