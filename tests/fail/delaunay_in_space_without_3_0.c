// expect: gmds: delaunay() needs 3->0: add R2N, or R2F with F2N, to GMDS_MODEL (the inverse of a relation will do)
#define GMDS_PREFIX vol
#define GMDS_MODEL (N | R | R2R)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
#include <gmds/end.h>
