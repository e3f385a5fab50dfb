/* The maps on which the claims of this folder are tested. */
#ifndef GMDS_TESTS_CMAP_MODELS_H
#define GMDS_TESTS_CMAP_MODELS_H

/* Each file opens a subset: a map that is opened and not used costs compile time alone. */
#define GMDS_PREFIX map2
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | F)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
#include <gmds/end.h>

#define GMDS_PREFIX whole2
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>

#define GMDS_PREFIX map3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL (N | R)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
#include <gmds/end.h>

#define GMDS_PREFIX bare3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL N
#include <gmds/mesh.h>
#include <gmds/end.h>

#define GMDS_PREFIX whole3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL (N | E | F | R)
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/quality.h>
#include <gmds/end.h>

#define GMDS_PREFIX map4
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 4
#define GMDS_MODEL (N | E | F | R)
#include <gmds/mesh.h>
#include <gmds/end.h>

#endif
