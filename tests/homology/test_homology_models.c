/* One text of homology, in several models of surfaces, against ranks of boundary matrices. */
#include "surfaces.h"
#include <limits.h>

static void make_soup(const face_list *f, gmds_memory *memory, gmds_soup *soup)
{
  gmds_soup_init(soup, memory, 2);
  for (size_t v = 0; v < f->n_vertices; v++) {
    const double x[2] = {(double)v, (double)(v * v)};
    ck_assert_int_eq(gmds_soup_add_point(soup, x), GMDS_OK);
  }
  for (size_t k = 0; k < f->n; k++) {
    const size_t n = f->begin[k + 1] - f->begin[k];
    const gmds_cell_type type = n == 3 ? GMDS_TRIANGLE : n == 4 ? GMDS_QUADRILATERAL : GMDS_POLYGON;
    ck_assert_int_eq(gmds_soup_add_cell(soup, type, n, f->nodes + f->begin[k]), GMDS_OK);
  }
}

#define GMDS_PREFIX beside
#define GMDS_MODEL (N | F | F2N | F2F)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
#define RUN beside
#include "body.h"

#define GMDS_PREFIX around
#define GMDS_MODEL (N | F | N2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
#define RUN around
#include "body.h"

#define GMDS_PREFIX sides
#define GMDS_MODEL (N | E | F | F2E | E2N)
#define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
#define RUN sides
#include "body.h"

#define GMDS_PREFIX whole
#define GMDS_MODEL (N | E | F | N2E | N2F | E2N | E2F | F2N | F2E | F2F)
#define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
#define RUN whole
#include "body.h"

#define GMDS_PREFIX map
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | F)
#include <gmds/mesh.h>
#include <gmds/algorithms/homology.h>
#include <gmds/end.h>
#define RUN map
#include "body.h"

START_TEST(surfaces_of_meshes_have_their_homology)
{
  uint64_t seed = 31;
  for (int k = 0; k < N_SHAPES; k++)
    for (size_t n = 3; n < 6; n++) {
      face_list triangles = make_shape((shape)k, n, k != PROJECTIVE, 1);
      face_list squares = make_shape((shape)k, n, 0, 0);
      if (k != PROJECTIVE) {
        beside_run(&triangles, &seed);
        around_run(&triangles, &seed);
      }
      sides_run(&squares, &seed);
      whole_run(&squares, &seed);
      if (k != MOEBIUS && k != KLEIN && k != PROJECTIVE) { /* no map can turn those */
        map_run(&squares, &seed);
        map_run(&triangles, &seed);
      }
      free_faces(&triangles);
      free_faces(&squares);
    }
}
END_TEST

RUN_SUITE("homology of meshes", surfaces_of_meshes_have_their_homology)
