/* Fills the table of the open model (volume.h): included by generated files between <gmds/mesh.h> and <gmds/end.h>. */
#ifndef TEST_DELAUNAY
#  define TEST_DELAUNAY (GMDS__TETRAHEDRA && GMDS_STARS && GMDS_CAN(3, 0) && GMDS_CAN(3, 3))
#endif
#if TEST_DELAUNAY
#  include <gmds/algorithms/delaunay.h>
#endif

static void GMDS_FN(do_init)(void *m, const gmds_allocator *allocator)
{
  mesh_init(m, allocator);
}

static void GMDS_FN(do_clear)(void *m)
{
  mesh_clear(m);
}

static gmds_cells *GMDS_FN(do_cells)(void *m)
{
  return ((mesh *)m)->cells;
}

static gmds_memory *GMDS_FN(do_memory)(void *m)
{
  return mesh_memory(m);
}

static const double *GMDS_FN(do_point)(const void *m, gmds_id v)
{
  return point(m, v);
}

static gmds_cell_type GMDS_FN(do_type)(const void *m, gmds_id r)
{
  return region_type(m, r);
}

#define TEST_PAIRS(X) \
  X(0, 0)             \
  X(0, 1)             \
  X(0, 2) X(0, 3) X(1, 0) X(1, 1) X(1, 2) X(1, 3) X(2, 0) X(2, 1) X(2, 2) X(2, 3) X(3, 0) X(3, 1) X(3, 2) X(3, 3)
static gmds_status GMDS_FN(do_query)(const void *m, int i, int j, gmds_id c, gmds_ids *out)
{
  switch (4 * i + j) {
#define TEST_A 0
#include "volumes/query.h"
#define TEST_A 1
#include "volumes/query.h"
#define TEST_A 2
#include "volumes/query.h"
#define TEST_A 3
#include "volumes/query.h"
  default:
    (void)m;
    (void)c;
    (void)out;
    return GMDS_ERR_UNSUPPORTED;
  }
}

static gmds_status GMDS_FN(do_bulk)(const void *m, int i, int j, gmds_csr *csr)
{
  switch (4 * i + j) {
#define TEST_A 0
#include "volumes/bulk.h"
#define TEST_A 1
#include "volumes/bulk.h"
#define TEST_A 2
#include "volumes/bulk.h"
#define TEST_A 3
#include "volumes/bulk.h"
  default:
    (void)m;
    (void)csr;
    return GMDS_ERR_UNSUPPORTED;
  }
}

static const gmds_id *GMDS_FN(do_view)(const void *m, int i, int j, gmds_id c, size_t *n)
{
  (void)m;
  (void)c;
  (void)n;
#define TEST_VIEW(a, b) GMDS__IF_##a##_##b(if (i == a && j == b) return row_##a##_##b(m, c, n);)
  TEST_PAIRS(TEST_VIEW)
#undef TEST_VIEW
  return NULL;
}
#undef TEST_PAIRS

static stored_relation GMDS_FN(do_stored)(void *m, int i, int j)
{
  mesh *own = m;
  stored_relation s = {NULL, NULL, NULL, 0, GMDS__CODED && i == 3 && j == 3};
  (void)own;
#define TEST_ROWS(a, b) \
  if (i == a && j == b) \
    s.rows = &own->r_##a##_##b;
#define TEST_PAIR(a, b) \
  if (i == a && j == b) \
    s.pairs = &own->r_##a##_##b;
#define TEST_COLUMN(a, b)            \
  if (i == a && j == b) {            \
    s.column = &own->r_##a##_##b;    \
    s.arity = GMDS__ARITY_##a##_##b; \
  }
  GMDS__EACH_POOLED(TEST_ROWS)
  GMDS__EACH_PAIRS(TEST_PAIR)
  GMDS__EACH_INLINE(TEST_COLUMN)
#undef TEST_ROWS
#undef TEST_PAIR
#undef TEST_COLUMN
  return s;
}

static gmds_status GMDS_FN(do_add_node)(void *m, const double *x, gmds_id *id)
{
  return add_node(m, x, id);
}

#if GMDS__LINKED_0_1
static gmds_status GMDS_FN(do_add_edge)(void *m, gmds_id a, gmds_id b, gmds_id *id)
{
  return add_edge(m, a, b, id);
}
#endif

#if GMDS_ADDS_FACES && GMDS__MAKES_FACES
static gmds_status GMDS_FN(do_add_face)(void *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  return add_face(m, n, nodes, id);
}
#endif

#if GMDS_ADDS_REGIONS
static gmds_status GMDS_FN(do_add_region)(void *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id)
{
  return add_region(m, type, nodes, id);
}

#  if GMDS__POLYHEDRA
static gmds_status GMDS_FN(do_add_polyhedron)(void *m, size_t n, const gmds_id *faces, gmds_id *id)
{
  return add_polyhedron(m, n, faces, id);
}
#  endif
#endif

static gmds_status GMDS_FN(do_remove_region)(void *m, gmds_id r, gmds_bare bare)
{
  return remove_region(m, r, bare);
}

#if GMDS__K_2
static gmds_status GMDS_FN(do_remove_face)(void *m, gmds_id f, gmds_around around, gmds_bare bare)
{
  return remove_face(m, f, around, bare);
}
#endif

#if GMDS__K_1
static gmds_status GMDS_FN(do_remove_edge)(void *m, gmds_id e, gmds_around around)
{
  return remove_edge(m, e, around);
}
#endif

static gmds_status GMDS_FN(do_remove_node)(void *m, gmds_id v, gmds_around around)
{
  return remove_node(m, v, around);
}

static gmds_status GMDS_FN(do_trim)(void *m)
{
  return trim(m);
}

static gmds_status GMDS_FN(do_compact)(void *m, gmds_id *maps[4])
{
  return compact(m, maps);
}

static gmds_status GMDS_FN(do_check)(const void *m, gmds_memory *memory, gmds_error *error)
{
  return check(m, memory, error);
}

static gmds_status GMDS_FN(do_set_volume)(void *m, gmds_volume *volume, gmds_error *error)
{
  return set_volume(m, volume, error);
}

static gmds_status GMDS_FN(do_from_soup)(void *m, const gmds_soup *soup, gmds_error *error)
{
  return from_soup(m, soup, error);
}

#if GMDS_LISTS_CELLS
static gmds_status GMDS_FN(do_get_volume)(const void *m, gmds_volume *volume, gmds_error *error)
{
  return get_volume(m, volume, error);
}

static gmds_status GMDS_FN(do_to_soup)(const void *m, gmds_soup *soup, gmds_error *error)
{
  return to_soup(m, soup, error);
}
#endif

#if TEST_DELAUNAY
static gmds_status GMDS_FN(do_delaunay)(void *m, size_t n, const double *xyz, const gmds_delaunay_options *options,
                                        gmds_delaunay_result *result)
{
  return GMDS_FN(delaunay)(m, n, xyz, options, result);
}
#endif

#if GMDS_STARS
static gmds_status GMDS_FN(do_star)(void *m, gmds_id apex, size_t n_regions, size_t n_walls,
                                    const gmds_cavity_wall *walls, gmds_id *ids)
{
  return star(m, apex, n_regions, n_walls, walls, ids);
}
#endif

#if GMDS_CAN(3, 0)
static gmds_status GMDS_FN(do_checksum)(const void *m, gmds_memory *memory, uint64_t *sum)
{
  return checksum(m, memory, sum);
}
#endif

const volume_model GMDS_FN(table) = {
    .name = GMDS_TEXT(GMDS_MODEL) " " GMDS_TEXT(GMDS_REGIONS),
    .mask = GMDS__MASK,
    .faces = GMDS__TRIANGLES | GMDS__QUADRILATERALS << 1 | GMDS__POLYGONS << 2,
    .regions = GMDS_FN(regions),
    .bytes = sizeof(mesh),
    .path = {{GMDS__PATH_0_0, GMDS__PATH_0_1, GMDS__PATH_0_2, GMDS__PATH_0_3},
             {GMDS__PATH_1_0, GMDS__PATH_1_1, GMDS__PATH_1_2, GMDS__PATH_1_3},
             {GMDS__PATH_2_0, GMDS__PATH_2_1, GMDS__PATH_2_2, GMDS__PATH_2_3},
             {GMDS__PATH_3_0, GMDS__PATH_3_1, GMDS__PATH_3_2, GMDS__PATH_3_3}},
    .can = {{GMDS_CAN(0, 0), GMDS_CAN(0, 1), GMDS_CAN(0, 2), GMDS_CAN(0, 3)},
            {GMDS_CAN(1, 0), GMDS_CAN(1, 1), GMDS_CAN(1, 2), GMDS_CAN(1, 3)},
            {GMDS_CAN(2, 0), GMDS_CAN(2, 1), GMDS_CAN(2, 2), GMDS_CAN(2, 3)},
            {GMDS_CAN(3, 0), GMDS_CAN(3, 1), GMDS_CAN(3, 2), GMDS_CAN(3, 3)}},
    .adds_regions = GMDS_ADDS_REGIONS,
    .makes_edges = GMDS__MAKES_EDGES,
    .makes_faces = GMDS__MAKES_FACES,
    .ordered_2_0 = GMDS_ORDERED_2_0,
    .ordered_3_0 = GMDS_ORDERED_3_0,
    .do_init = GMDS_FN(do_init),
    .do_clear = GMDS_FN(do_clear),
    .do_cells = GMDS_FN(do_cells),
    .do_memory = GMDS_FN(do_memory),
    .do_point = GMDS_FN(do_point),
    .do_type = GMDS_FN(do_type),
    .do_query = GMDS_FN(do_query),
    .do_bulk = GMDS_FN(do_bulk),
    .do_view = GMDS_FN(do_view),
    .do_stored = GMDS_FN(do_stored),
    .do_add_node = GMDS_FN(do_add_node),
#if GMDS__LINKED_0_1
    .do_add_edge = GMDS_FN(do_add_edge),
#endif
#if GMDS_ADDS_FACES && GMDS__MAKES_FACES
    .do_add_face = GMDS_FN(do_add_face),
#endif
#if GMDS_ADDS_REGIONS
    .do_add_region = GMDS_FN(do_add_region),
#  if GMDS__POLYHEDRA
    .do_add_polyhedron = GMDS_FN(do_add_polyhedron),
#  endif
#endif
    .do_remove_region = GMDS_FN(do_remove_region),
#if GMDS__K_2
    .do_remove_face = GMDS_FN(do_remove_face),
#endif
#if GMDS__K_1
    .do_remove_edge = GMDS_FN(do_remove_edge),
#endif
    .do_remove_node = GMDS_FN(do_remove_node),
    .do_trim = GMDS_FN(do_trim),
    .do_compact = GMDS_FN(do_compact),
    .do_check = GMDS_FN(do_check),
    .do_set_volume = GMDS_FN(do_set_volume),
    .do_from_soup = GMDS_FN(do_from_soup),
#if GMDS_LISTS_CELLS
    .do_get_volume = GMDS_FN(do_get_volume),
    .do_to_soup = GMDS_FN(do_to_soup),
#endif
#if TEST_DELAUNAY
    .do_delaunay = GMDS_FN(do_delaunay),
#endif
#if GMDS_STARS
    .do_star = GMDS_FN(do_star),
    .stars_or_nothing = GMDS__STARS_OF_REGIONS,
#endif
#if GMDS_CAN(3, 0)
    .do_checksum = GMDS_FN(do_checksum),
#endif
};
#undef TEST_DELAUNAY
