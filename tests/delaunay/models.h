/* The models on which the claims about Delaunay triangulations are tested: each takes other paths. X(prefix) */
#define GMDS_PREFIX best
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* all types of faces: rows in a pool */
#define GMDS_PREFIX any
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* neighbours through nodes */
#define GMDS_PREFIX nodal
#define GMDS_MODEL (N | F | F2N | N2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* order through edges alone */
#define GMDS_PREFIX edged
#define GMDS_MODEL (N | E | F | F2E | E2N | E2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* no order, everything by traversal */
#define GMDS_PREFIX poor
#define GMDS_MODEL (N | F | N2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* edges that know no node, neighbours kept without order */
#define GMDS_PREFIX loose
#define GMDS_MODEL (N | E | F | N2F | E2F | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

/* every relation, and nodes joined with nodes */
#define GMDS_PREFIX whole
#define GMDS_MODEL (N | E | F | N2N | N2E | N2F | E2N | E2F | F2N | F2E | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#define TESTED_MODELS(X) X(best) X(any) X(nodal) X(edged) X(poor) X(loose) X(whole)
