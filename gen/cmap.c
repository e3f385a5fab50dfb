/* Combinatorial maps as models of the command: `cmap` in the plane and in space. */
#define GMDS_PREFIX cmap2
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | F)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include "cells_entry.h"
#include "cmap_entry.h"
#include <gmds/end.h>

#define GMDS_PREFIX cmap3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL (N | R)
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include "cmap_entry.h"
#include <gmds/end.h>
