/* Claims about maps through the interface of a model: what is made, sewn, matched, inserted and taken out, what a check
 * finds, what isomorphism, checksum and bytes depend on. */
#include "brute.h"
#include "harness.h"
#define GMDS_PREFIX map2
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 2
#define GMDS_MODEL (N | E | F)
#include <gmds/mesh.h>
#include <gmds/end.h>
#define GMDS_PREFIX map3
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL (N | E | F | R)
#include <gmds/mesh.h>
#include <gmds/end.h>
#define GMDS_PREFIX bare
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL N
#include <gmds/mesh.h>
#include <gmds/end.h>
#define GMDS_PREFIX map4
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 4
#define GMDS_MODEL (N | F)
#include <gmds/mesh.h>
#include <gmds/end.h>

#define OK(call) ck_assert_int_eq(call, GMDS_OK)

static gmds_memory memory;

/* Checks a map, and its cells by brute force. */
static void verify(const gmds_map *map)
{
  gmds_error error = {.text = ""};
  ck_assert_msg(gmds_map_check(map, &memory, NULL, &error) == GMDS_OK, "%s", error.text);
  brute_check_cells(map);
}

static void counts_are(const map3_mesh *m, size_t nodes, size_t edges, size_t faces, size_t regions)
{
  ck_assert_uint_eq(map3_count_0(m), nodes);
  ck_assert_uint_eq(map3_count_1(m), edges);
  ck_assert_uint_eq(map3_count_2(m), faces);
  ck_assert_uint_eq(map3_count_3(m), regions);
  const size_t expected[4] = {nodes, edges, faces, regions};
  for (int i = 0; i < 4; i++) {
    size_t n = 0;
    OK(map3_count_cells(m, i, &memory, &n));
    ck_assert_uint_eq(n, expected[i]);
  }
}

/* A cube with its least corner at (i, j, k). */
static gmds_id cube_at(map3_mesh *m, double i, double j, double k)
{
  double x[24];
  gmds_id d = GMDS_NONE;
  for (int v = 0; v < 8; v++) {
    x[3 * v] = i + (v == 1 || v == 2 || v == 5 || v == 6);
    x[3 * v + 1] = j + (v == 2 || v == 3 || v == 6 || v == 7);
    x[3 * v + 2] = k + (v > 3);
  }
  OK(map3_make_hexahedron(m, x, &d));
  return d;
}

START_TEST(the_stencils_are_the_shapes)
{
  for (int t = GMDS_TETRAHEDRON; t <= GMDS_HEXAHEDRON; t++) {
    const gmds_shape *shape = gmds_shape_of((gmds_cell_type)t);
    const gmds_map_stencil *s = gmds_map_stencil_of((gmds_cell_type)t);
    unsigned d = 0;
    for (unsigned k = 0; k < shape->faces; k++)
      for (unsigned q = 0; q < shape->sides[k]; q++, d++) {
        ck_assert_uint_eq(s->node[d], shape->face[k][q]);
        ck_assert_uint_eq(s->edge[d], shape->border[k][q]);
        ck_assert_uint_eq(s->face[d], k);
        ck_assert_uint_eq(s->node[s->next[d]], shape->face[k][(q + 1) % shape->sides[k]]);
        ck_assert_uint_eq(s->before[s->next[d]], d);
        ck_assert_uint_eq(s->beyond[s->beyond[d]], d);
        ck_assert_uint_eq(s->node[s->beyond[d]], s->node[s->next[d]]);
        ck_assert_uint_eq(s->node[s->next[s->beyond[d]]], s->node[d]);
      }
    ck_assert_uint_eq(d, s->darts);
    ck_assert_uint_eq(s->edges, shape->edges);
  }
  ck_assert_ptr_null(gmds_map_stencil_of(GMDS_POLYHEDRON));
  ck_assert_ptr_null(gmds_map_stencil_of(GMDS_TRIANGLE));
}
END_TEST

START_TEST(cells_that_are_made_have_their_nodes_edges_and_faces)
{
  map3_mesh m;
  gmds_id d = 0;
  OK(map3_mesh_init(&m, NULL));
  OK(map3_make_tetrahedron(&m, NULL, &d));
  counts_are(&m, 4, 6, 4, 1);
  OK(map3_make_pyramid(&m, NULL, &d));
  counts_are(&m, 9, 14, 9, 2);
  OK(map3_make_prism(&m, NULL, &d));
  counts_are(&m, 15, 23, 14, 3);
  OK(map3_make_hexahedron(&m, NULL, &d));
  counts_are(&m, 23, 35, 20, 4);
  OK(map3_make_polygon(&m, 5, NULL, &d));
  counts_are(&m, 28, 40, 21, 5);
  OK(map3_make_edge(&m, NULL, &d));
  counts_are(&m, 30, 41, 22, 6);
  ck_assert_int_eq(map3_make_polygon(&m, 2, NULL, &d), GMDS_ERR_ARGUMENT);
  const size_t begin[] = {0, 3, 6, 9, 12};
  const gmds_id closed[] = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1}, turned[] = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 1, 2};
  OK(map3_make_polyhedron(&m, 4, NULL, 4, begin, closed, &d));
  counts_are(&m, 34, 47, 26, 7);
  ck_assert_int_eq(map3_make_polyhedron(&m, 4, NULL, 4, begin, turned, &d), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(map3_make_polyhedron(&m, 5, NULL, 4, begin, closed, &d), GMDS_ERR_ARGUMENT);
  verify(&m.map);
  ck_assert_uint_eq(map3_bytes_per_dart(), 8 * sizeof(gmds_id));
  ck_assert_uint_eq(bare_bytes_per_dart(), 5 * sizeof(gmds_id));
  map3_mesh_clear(&m);
  ck_assert_uint_eq(m.map.memory.live, 0);
}
END_TEST

START_TEST(sewing_two_cubes_makes_their_face_one)
{
  map3_mesh m;
  int sewable = 0;
  OK(map3_mesh_init(&m, NULL));
  const gmds_id a = cube_at(&m, 0, 0, 0), b = cube_at(&m, 1, 0, 0);
  counts_are(&m, 16, 24, 12, 2);
  gmds_id x = GMDS_NONE, y = GMDS_NONE; /* the darts of the face between them, told by coordinates */
  for (gmds_id d = 0; d < map3_end_darts(&m); d++) {
    const double *from = map3_point(&m, map3_cell_of(&m, 0, d)),
                 *to = map3_point(&m, map3_cell_of(&m, 0, map3_beta(&m, 1, d))),
                 *before = map3_point(&m, map3_cell_of(&m, 0, map3_beta(&m, 0, d)));
    if (from[0] != 1 || to[0] != 1 || before[0] != 1)
      continue;
    if (d < 24 && from[1] == 0 && to[1] == 1 && from[2] == 0)
      x = d;
    if (d >= 24 && from[1] == 1 && to[1] == 0 && from[2] == 0)
      y = d;
  }
  ck_assert(x != GMDS_NONE && y != GMDS_NONE);
  OK(map3_is_sewable(&m, 3, x, y, &memory, &sewable));
  ck_assert_int_eq(sewable, 1);
  OK(map3_sew(&m, 3, x, y));
  counts_are(&m, 12, 20, 11, 2);
  verify(&m.map);
  ck_assert_int_eq(map3_sew(&m, 3, x, y), GMDS_ERR_CONFLICT);
  OK(map3_unsew(&m, 3, map3_beta(&m, 1, y)));
  counts_are(&m, 16, 24, 12, 2);
  verify(&m.map);
  ck_assert_int_eq(map3_unsew(&m, 3, x), GMDS_ERR_CONFLICT);
  ck_assert_int_eq(map3_sew(&m, 4, x, y), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(map3_sew(&m, 3, x, x), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(map3_sew(&m, 3, x, 4711), GMDS_ERR_CELL);
  (void)a;
  (void)b;
  map3_mesh_clear(&m);
}
END_TEST

START_TEST(sew_with_unequal_faces_is_refused)
{
  map3_mesh m;
  gmds_id a = 0, b = 0;
  int sewable = 1;
  OK(map3_mesh_init(&m, NULL));
  OK(map3_make_tetrahedron(&m, NULL, &a));
  OK(map3_make_hexahedron(&m, NULL, &b));
  OK(map3_is_sewable(&m, 3, a, b, &memory, &sewable));
  ck_assert_int_eq(sewable, 0);
  ck_assert_int_eq(map3_sew(&m, 3, a, b), GMDS_ERR_CONFLICT);
  counts_are(&m, 12, 18, 10, 2);
  verify(&m.map);
  map3_mesh_clear(&m);
}
END_TEST

static void add_up(void *user, void *kept, const void *gone)
{
  ++*(int *)user;
  *(double *)kept += *(const double *)gone;
}

static void halve(void *user, void *old, void *fresh)
{
  ++*(int *)user;
  *(double *)old /= 2;
  *(double *)fresh /= 2;
}

START_TEST(attributes_are_merged_and_split_by_their_functions)
{
  map2_mesh m;
  gmds_id a = 0, b = 0, made = 0;
  gmds_attribute *mass = NULL, *colour = NULL;
  int calls = 0;
  OK(map2_mesh_init(&m, NULL));
  OK(map2_add_attribute(&m, 0, "mass", GMDS_DOUBLE, 1, &mass));
  OK(map2_add_attribute(&m, 2, "colour", GMDS_INT, 1, &colour));
  OK(map2_on_change(&m, 0, mass, add_up, halve, &calls));
  ck_assert_int_eq(map2_add_attribute(&m, 3, "none", GMDS_INT, 1, &colour), GMDS_ERR_ARGUMENT);
  OK(map2_make_polygon(&m, 3, NULL, &a));
  OK(map2_make_polygon(&m, 4, NULL, &b));
  for (gmds_id v = 0; v < 7; v++)
    ((double *)mass->data)[v] = 1 << v;
  ((int *)colour->data)[map2_cell_of(&m, 2, a)] = 5;
  OK(map2_sew(&m, 2, a, b)); /* from node 0 to 1, and from 3 to 4: 0 meets 4, 1 meets 3 */
  ck_assert_int_eq(calls, 2);
  ck_assert_uint_eq(map2_count_0(&m), 5);
  ck_assert_double_eq(((double *)mass->data)[map2_cell_of(&m, 0, a)], 1 + 16);
  ck_assert_double_eq(((double *)mass->data)[map2_cell_of(&m, 0, b)], 2 + 8);
  OK(map2_unsew(&m, 2, a));
  ck_assert_int_eq(calls, 4);
  ck_assert_double_eq(((double *)mass->data)[map2_cell_of(&m, 0, a)], 8.5);
  ck_assert_double_eq(((double *)mass->data)[map2_cell_of(&m, 0, map2_beta(&m, 1, b))], 8.5);
  OK(map2_insert_edge_in_face(&m, b, map2_beta(&m, 1, map2_beta(&m, 1, b)), &made));
  ((int *)colour->data)[map2_cell_of(&m, 2, b)] = 7; /* and the face a keeps its colour */
  ck_assert_int_eq(((int *)colour->data)[map2_cell_of(&m, 2, a)], 5);
  ck_assert_uint_eq(map2_count_2(&m), 3);
  OK(map2_remove_cell(&m, 1, made));
  ck_assert_uint_eq(map2_count_2(&m), 2);
  verify(&m.map);
  map2_remove_attribute(&m, 0, mass); /* takes its functions along */
  OK(map2_sew(&m, 2, a, b));
  ck_assert_int_eq(calls, 4);
  map2_mesh_clear(&m);
  ck_assert_uint_eq(m.map.memory.live, 0);
}
END_TEST

START_TEST(links_break_cells_and_restore_cells_repairs_them)
{
  map2_mesh m, sewn;
  gmds_id a = 0, b = 0;
  gmds_map_report report;
  int same = 0;
  OK(map2_mesh_init(&m, NULL));
  OK(map2_mesh_init(&sewn, NULL));
  for (int k = 0; k < 2; k++) {
    OK(map2_make_polygon(k ? &sewn : &m, 3, NULL, &a));
    OK(map2_make_polygon(k ? &sewn : &m, 3, NULL, &b));
  }
  OK(map2_link(&m, 2, a, b));
  ck_assert_int_eq(map2_check_map(&m, &memory, &report, NULL), GMDS_ERR_INVARIANT);
  ck_assert_int_eq(report.rule, GMDS_MAP_TWO_CELLS);
  OK(map2_restore_cells(&m));
  verify(&m.map);
  OK(map2_sew(&sewn, 2, a, b));
  OK(map2_is_isomorphic(&m, &sewn, 0, &memory, &same));
  ck_assert_int_eq(same, 1);
  ck_assert_uint_eq(map2_count_0(&m), 4);
  ck_assert_uint_eq(map2_count_1(&m), 5);
  OK(map2_unlink(&m, 2, a));
  ck_assert_int_eq(map2_unlink(&m, 2, a), GMDS_ERR_CONFLICT);
  OK(map2_restore_cells(&m));
  verify(&m.map);
  ck_assert_uint_eq(map2_count_0(&m), 6);
  map2_mesh_clear(&m);
  map2_mesh_clear(&sewn);
}
END_TEST

/* A grid of cubes matched by coordinates; its numbers are those of a grid. */
static void make_grid(map3_mesh *m, size_t n)
{
  size_t sewn = 0;
  OK(map3_mesh_init(m, NULL));
  for (size_t c = 0; c < n * n * n; c++)
    (void)cube_at(m, (double)(c % n), (double)(c / n % n), (double)(c / n / n));
  OK(map3_match_points(m, &sewn));
  ck_assert_uint_eq(sewn, 3 * n * n * (n - 1));
  OK(map3_compact(m, NULL));
}

START_TEST(a_grid_of_cubes_is_matched_by_coordinates)
{
  map3_mesh m;
  const size_t n = 3;
  make_grid(&m, n);
  counts_are(&m, 64, 144, 108, 27);
  verify(&m.map);
  ck_assert_uint_eq(map3_end_0(&m), 64);
  size_t again = 1, pieces = 0;
  OK(map3_match_points(&m, &again));
  ck_assert_uint_eq(again, 0);
  OK(map3_components_of_darts(&m, &memory, &pieces));
  ck_assert_uint_eq(pieces, 1);
  map3_mesh_clear(&m);
}
END_TEST

START_TEST(faces_are_matched_by_nodes_and_a_third_stays_free)
{
  map2_mesh m;
  gmds_id v = 0, d[3];
  size_t sewn = 0;
  OK(map2_mesh_init(&m, NULL));
  for (int k = 0; k < 5; k++)
    OK(map2_add_node(&m, (const double[]){k, -k}, &v));
  OK(map2_place_polygon(&m, 3, (const gmds_id[]){0, 1, 2}, &d[0]));
  OK(map2_place_polygon(&m, 3, (const gmds_id[]){1, 0, 3}, &d[1]));
  OK(map2_place_polygon(&m, 3, (const gmds_id[]){1, 0, 4}, &d[2]));
  ck_assert_int_eq(map2_place_polygon(&m, 3, (const gmds_id[]){1, 0, 9}, &v), GMDS_ERR_CELL);
  ck_assert_int_eq(map2_place_polygon(&m, 3, (const gmds_id[]){1, 0, 1}, &v), GMDS_ERR_ARGUMENT);
  OK(map2_match_nodes(&m, &sewn));
  ck_assert_uint_eq(sewn, 1);
  ck_assert_uint_eq(map2_beta(&m, 2, d[0]), d[1]);
  ck_assert(map2_is_free(&m, 2, d[2]));
  OK(map2_restore_cells(&m)); /* the third face gets nodes of its own, where the others are */
  verify(&m.map);
  ck_assert_uint_eq(map2_count_0(&m), 7);
  ck_assert_double_eq(map2_point(&m, map2_cell_of(&m, 0, d[2]))[0], 1);
  map2_mesh_clear(&m);
}
END_TEST

START_TEST(every_failing_allocation_of_a_match_changes_nothing)
{
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = 100000};
    gmds_allocator allocator = failing_allocator(&f);
    map3_mesh m;
    size_t sewn = 7;
    OK(map3_mesh_init(&m, &allocator));
    (void)cube_at(&m, 0, 0, 0);
    (void)cube_at(&m, 1, 0, 0);
    f.until = k;
    gmds_status status = map3_match_points(&m, &sewn);
    done = status == GMDS_OK;
    ck_assert(done || (status == GMDS_ERR_MEMORY && sewn == 7));
    f.until = 100000;
    verify(&m.map);
    ck_assert_uint_eq(map3_count_0(&m), done ? 12 : 16);
    map3_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
}
END_TEST

START_TEST(removal_undoes_insertion)
{
  map3_mesh m, was;
  gmds_id made = 0;
  int same = 0;
  make_grid(&m, 2);
  make_grid(&was, 2);
  for (gmds_id d = 0; d < 192; d += 17) {
    OK(map3_insert_vertex_in_edge(&m, d, NULL, &made));
    verify(&m.map);
    OK(map3_is_isomorphic(&m, &was, 0, &memory, &same));
    ck_assert_int_eq(same, 0);
    OK(map3_remove_cell(&m, 0, made));
    OK(map3_is_isomorphic(&m, &was, 0, &memory, &same));
    ck_assert_int_eq(same, 1);
    OK(map3_insert_edge_in_face(&m, d, map3_beta(&m, 1, map3_beta(&m, 1, d)), &made));
    verify(&m.map);
    OK(map3_remove_cell(&m, 1, made));
    OK(map3_insert_dangling_edge(&m, d, NULL, &made));
    verify(&m.map);
    OK(map3_remove_cell(&m, 1, made));
    OK(map3_is_isomorphic(&m, &was, 1, &memory, &same));
    ck_assert_int_eq(same, 1);
  }
  counts_are(&m, 27, 54, 36, 8);
  OK(map3_insert_vertex_in_face(&m, 0, (const double[]){9, 8, 7}, &made));
  counts_are(&m, 28, 58, 39, 8);
  ck_assert_double_eq(map3_point(&m, map3_cell_of(&m, 0, made))[1], 8);
  verify(&m.map);
  ck_assert_int_eq(map3_remove_cell(&m, 0, made), GMDS_ERR_CONFLICT);
  ck_assert_int_eq(map3_remove_cell(&m, 3, made), GMDS_ERR_ARGUMENT);
  map3_mesh_clear(&m);
  map3_mesh_clear(&was);
}
END_TEST

START_TEST(a_face_divides_a_cube_into_prisms)
{
  map3_mesh m, prism;
  gmds_id path[4], made = 0, p = 0;
  int same = 0;
  OK(map3_mesh_init(&m, NULL));
  path[0] = cube_at(&m, 0, 0, 0);
  /* diagonals of two opposite faces, and the edges between their ends */
  OK(map3_insert_edge_in_face(&m, path[0], map3_beta(&m, 1, map3_beta(&m, 1, path[0])), &path[0]));
  for (gmds_id d = map3_next_dart(&m, 0), done = 0; d != GMDS_NONE && !done; d = map3_next_dart(&m, d + 1)) {
    const double *a = map3_point(&m, map3_cell_of(&m, 0, d));
    const gmds_id c = map3_beta(&m, 1, map3_beta(&m, 1, d));
    const double *b = map3_point(&m, map3_cell_of(&m, 0, c));
    const double *from = map3_point(&m, map3_cell_of(&m, 0, path[0]));
    const double *to = map3_point(&m, map3_cell_of(&m, 0, map3_beta(&m, 1, path[0])));
    if (a[0] == 1 && b[0] == 1 && from[1] == b[1] && from[2] == b[2] && to[1] == a[1] && to[2] == a[2] &&
        map3_point(&m, map3_cell_of(&m, 0, map3_beta(&m, 1, d)))[0] == 1) {
      OK(map3_insert_edge_in_face(&m, d, c, &path[2]));
      done = 1;
    }
  }
  for (int k = 0; k < 2; k++) { /* the dart that leads from the end of one diagonal to the beginning of the other */
    const gmds_id from = map3_cell_of(&m, 0, map3_beta(&m, 1, path[2 * k])), to = map3_cell_of(&m, 0, path[2 - 2 * k]);
    for (gmds_id d = map3_next_dart(&m, 0); d != GMDS_NONE; d = map3_next_dart(&m, d + 1))
      if (map3_cell_of(&m, 0, d) == from && map3_cell_of(&m, 0, map3_beta(&m, 1, d)) == to)
        path[2 * k + 1] = d;
  }
  counts_are(&m, 8, 14, 8, 1);
  ck_assert_int_eq(map3_insert_face_in_volume(&m, 3, path, &made), GMDS_ERR_CONFLICT);
  OK(map3_insert_face_in_volume(&m, 4, path, &made));
  counts_are(&m, 8, 14, 9, 2);
  verify(&m.map);
  OK(map3_unsew(&m, 3, made));
  OK(map3_mesh_init(&prism, NULL));
  OK(map3_make_prism(&prism, NULL, &p));
  OK(map3_make_prism(&prism, NULL, &p));
  OK(map3_is_isomorphic(&m, &prism, 0, &memory, &same));
  ck_assert_int_eq(same, 1);
  map3_mesh_clear(&m);
  map3_mesh_clear(&prism);
}
END_TEST

START_TEST(contracting_the_edges_of_a_triangle_leaves_nothing)
{
  map2_mesh m;
  gmds_id d = 0;
  int can = 0;
  OK(map2_mesh_init(&m, NULL));
  OK(map2_make_polygon(&m, 3, NULL, &d));
  OK(map2_is_contractible(&m, 2, d, &memory, &can));
  ck_assert_int_eq(can, 0);
  ck_assert_int_eq(map2_contract_cell(&m, 2, d), GMDS_ERR_CONFLICT);
  OK(map2_contract_cell(&m, 1, d));
  ck_assert_uint_eq(map2_count_0(&m), 2);
  d = map2_next_dart(&m, 0);
  OK(map2_is_contractible(&m, 2, d, &memory, &can));
  ck_assert_int_eq(can, 1);
  OK(map2_contract_cell(&m, 1, d));
  OK(map2_contract_cell(&m, 1, map2_next_dart(&m, 0)));
  ck_assert_uint_eq(map2_count_darts(&m) + map2_count_0(&m) + map2_count_1(&m) + map2_count_2(&m), 0);
  map2_mesh_clear(&m);
}
END_TEST

START_TEST(closing_adds_what_is_outside)
{
  map3_mesh m;
  size_t made = 0;
  make_grid(&m, 2);
  OK(map3_close(&m, 3, &made));
  ck_assert_uint_eq(made, 24 * 4);
  counts_are(&m, 27, 54, 36, 9);
  verify(&m.map);
  for (gmds_id d = 0; d < map3_end_darts(&m); d++)
    ck_assert(!map3_is_free(&m, 3, d));
  OK(map3_close(&m, 3, &made));
  ck_assert_uint_eq(made, 0);
  map3_mesh_clear(&m);
  gmds_id d = 0;
  OK(map3_mesh_init(&m, NULL));
  OK(map3_add_dart(&m, &d));
  ck_assert_int_eq(map3_close(&m, 3, &made), GMDS_ERR_CONFLICT);
  ck_assert_int_eq(map3_close(&m, 1, &made), GMDS_ERR_ARGUMENT);
  OK(map3_remove_dart(&m, d));
  ck_assert_int_eq(map3_remove_dart(&m, d), GMDS_ERR_CELL);
  map3_mesh_clear(&m);
}
END_TEST

/* Breaks one thing at a time: the check names it. */
START_TEST(a_check_names_what_is_wrong)
{
  for (int what = 0; what < 10; what++) {
    map3_mesh m;
    gmds_map_report r;
    gmds_error error = {.text = ""};
    make_grid(&m, 2);
    const gmds_id d = 5, e = map3_beta(&m, 2, d);
    gmds_id *record = gmds_map_record(&m.map, d), *other = gmds_map_record(&m.map, e);
    gmds_id s = 0; /* a dart that is 3-sewn */
    while (map3_is_free(&m, 3, s))
      s++;
    const gmds_map_fault expected[] = {
        GMDS_MAP_LINK_TO_NONE, GMDS_MAP_NO_INVERSE, GMDS_MAP_NO_INVOLUTION, GMDS_MAP_FIXED_POINT, GMDS_MAP_NO_MAP,
        GMDS_MAP_DEAD_CELL,    GMDS_MAP_TWO_CELLS,  GMDS_MAP_TWO_ORBITS,    GMDS_MAP_WRONG_DART,  GMDS_MAP_NO_DART};
    switch (what) {
    case 0:
      record[2] = 9999;
      break;
    case 1:
      record[1] = e;
      break;
    case 2:
      record[2] = map3_beta(&m, 1, e);
      break;
    case 3:
      record[2] = d;
      other[2] = e;
      break;
    case 4:
      OK(map3_unlink(&m, 3, s));
      break;
    case 5:
      for (size_t k = 0; k < map3_end_darts(&m); k++)
        gmds_map_record(&m.map, (gmds_id)k)[m.map.slot[0]] = 4711;
      break;
    case 6:
      record[m.map.slot[1]]++;
      break;
    case 7:
      for (gmds_id k = 0; k < map3_end_darts(&m); k++)
        if (map3_cell_of(&m, 3, k) == 3)
          gmds_map_record(&m.map, k)[m.map.slot[3]] = 2;
      break;
    case 8:
      m.map.anchor[2][3] = m.map.anchor[2][4];
      break;
    default:
      (void)gmds_map_grow(&m.map, 1, 1);
      m.map.anchor[1][gmds_cells_take(&m.map.cells[1])] = 0;
    }
    ck_assert_int_eq(map3_check_map(&m, &memory, &r, &error), GMDS_ERR_INVARIANT);
    ck_assert_msg(r.rule == expected[what], "%d: rule %d, %s", what, r.rule, error.text);
    ck_assert_uint_gt(strlen(error.text), 20);
    map3_mesh_clear(&m);
  }
}
END_TEST

START_TEST(checksum_and_isomorphism_do_not_depend_on_the_numbering)
{
  map3_mesh a, b;
  uint64_t one[2] = {0, 0}, other[2] = {0, 0};
  size_t sewn = 0;
  int same = 0;
  make_grid(&a, 3);
  OK(map3_mesh_init(&b, NULL));
  for (size_t c = 27; c-- > 0;) /* the other way round, with holes */
    (void)cube_at(&b, (double)(c / 9), (double)(c % 3), (double)(c / 3 % 3));
  OK(map3_match_points(&b, &sewn));
  for (int points = 0; points < 2; points++) {
    OK(map3_dart_checksum(&a, points, &memory, &one[points]));
    OK(map3_dart_checksum(&b, points, &memory, &other[points]));
    ck_assert_uint_eq(one[points], other[points]);
    OK(map3_is_isomorphic(&a, &b, points, &memory, &same));
    ck_assert_int_eq(same, 1);
  }
  map3_set_point(&b, map3_next_0(&b, 0), (const double[]){0.5, 0, 0});
  OK(map3_dart_checksum(&b, 1, &memory, &other[1]));
  ck_assert_uint_ne(one[1], other[1]);
  OK(map3_is_isomorphic(&a, &b, 1, &memory, &same));
  ck_assert_int_eq(same, 0);
  OK(map3_is_isomorphic(&a, &b, 0, &memory, &same));
  ck_assert_int_eq(same, 1);
  gmds_id s = 0;
  while (map3_is_free(&b, 3, s))
    s++;
  OK(map3_unsew(&b, 3, s));
  OK(map3_dart_checksum(&b, 0, &memory, &other[0]));
  ck_assert_uint_ne(one[0], other[0]);
  OK(map3_is_isomorphic(&a, &b, 0, &memory, &same));
  ck_assert_int_eq(same, 0);
  map3_mesh_clear(&a);
  map3_mesh_clear(&b);
}
END_TEST

START_TEST(bytes_bring_a_map_back)
{
  map3_mesh m, back;
  gmds_map_bytes bytes = {.memory = &memory}, again = {.memory = &memory};
  gmds_attribute *a = NULL;
  gmds_error error = {.text = ""};
  int same = 0;
  make_grid(&m, 2);
  OK(map3_add_attribute(&m, 0, "heat", GMDS_DOUBLE, 2, &a));
  for (size_t k = 0; k < 54; k++)
    ((double *)a->data)[k] = 0.1 * (double)k;
  OK(map3_add_attribute(&m, 2, "flag", GMDS_BYTE, 1, &a));
  OK(map3_add_attribute(&m, 3, "next", GMDS_ID, 1, &a));
  ((gmds_id *)a->data)[3] = GMDS_NONE;
  gmds_id lone = 0;
  OK(map3_add_node(&m, (const double[]){-1, -2, -3}, &lone));
  OK(map3_write_bytes(&m, &bytes));
  OK(map3_mesh_init(&back, NULL));
  OK(map3_read_bytes(&back, bytes.n, bytes.data, &error));
  verify(&back.map);
  OK(map3_is_isomorphic(&m, &back, 1, &memory, &same));
  ck_assert_int_eq(same, 1);
  OK(map3_write_bytes(&back, &again));
  ck_assert_uint_eq(bytes.n, again.n);
  ck_assert_int_eq(memcmp(bytes.data, again.data, bytes.n), 0);
  ck_assert_double_eq(((double *)map3_find_attribute(&back, 0, "heat")->data)[7], 0.7000000000000001);
  ck_assert_uint_eq(((gmds_id *)map3_find_attribute(&back, 3, "next")->data)[3], GMDS_NONE);
  ck_assert_int_eq(map3_read_bytes(&back, bytes.n, bytes.data, &error), GMDS_ERR_ARGUMENT);
  map2_mesh flat;
  OK(map2_mesh_init(&flat, NULL));
  ck_assert_int_eq(map2_read_bytes(&flat, bytes.n, bytes.data, &error), GMDS_ERR_UNSUPPORTED);
  map2_mesh_clear(&flat);
  map3_mesh_clear(&back);
  map3_mesh_clear(&m);
  gmds_map_bytes_clear(&bytes);
  gmds_map_bytes_clear(&again);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(bytes_that_are_broken_are_refused_and_nothing_is_half_read)
{
  map3_mesh m;
  gmds_map_bytes bytes = {.memory = &memory};
  gmds_attribute *a = NULL;
  uint64_t seed = 4;
  size_t refused = 0, taken = 0;
  make_grid(&m, 2);
  OK(map3_add_attribute(&m, 1, "length", GMDS_FLOAT, 1, &a));
  OK(map3_write_bytes(&m, &bytes));
  for (size_t round = 0; round < 6000; round++) {
    map3_mesh back;
    gmds_error error = {.text = ""};
    OK(map3_mesh_init(&back, NULL));
    const size_t at = random_below(&seed, round % 3 ? bytes.n : 80),
                 n = round % 5 ? bytes.n : random_below(&seed, bytes.n);
    const unsigned char was = bytes.data[at];
    bytes.data[at] = (unsigned char)random_bits(&seed);
    gmds_status status = map3_read_bytes(&back, n, bytes.data, &error);
    bytes.data[at] = was;
    if (status == GMDS_OK) {
      taken++;
      if (map3_check(&back, &memory, &error) != GMDS_OK)
        ck_abort_msg("round %zu: %s", round, error.text);
    } else {
      refused++;
      if (map3_count_darts(&back) || map3_count_0(&back) || map3_find_attribute(&back, 1, "length") || !error.text[0] ||
          error.status != status)
        ck_abort_msg("round %zu: status %d leaves something", round, status);
    }
    map3_mesh_clear(&back);
    if (back.map.memory.live)
      ck_abort_msg("round %zu: memory is lost", round);
  }
  ck_assert_uint_gt(refused, 1000); /* a coordinate or an attribute may be anything */
  ck_assert_uint_gt(taken, 100);
  map3_mesh_clear(&m);
  gmds_map_bytes_clear(&bytes);
}
END_TEST

START_TEST(cells_that_are_not_kept_are_counted_by_orbits)
{
  bare_mesh m;
  map4_mesh four;
  gmds_id d = 0;
  size_t n = 0;
  gmds_ids list = {.memory = &memory};
  OK(bare_mesh_init(&m, NULL));
  OK(bare_make_prism(&m, NULL, &d));
  OK(bare_count_cells(&m, 1, &memory, &n));
  ck_assert_uint_eq(n, 9);
  OK(bare_count_cells(&m, 2, &memory, &n));
  ck_assert_uint_eq(n, 5);
  OK(bare_cell_darts(&m, 2, d, &list));
  ck_assert_uint_eq(list.n, 3);
  OK(bare_orbit(&m, d, GMDS_BETA(1) | GMDS_BETA(2), &list));
  ck_assert_uint_eq(list.n, 18);
  ck_assert_int_eq(bare_orbit(&m, d, GMDS_BETA(4), &list), GMDS_ERR_ARGUMENT);
  ck_assert_uint_eq(bare_cell_of(&m, 2, d), GMDS_NONE);
  bare_mesh_clear(&m);
  OK(map4_mesh_init(&four, NULL));
  gmds_id e = 0;
  OK(map4_make_tetrahedron(&four, NULL, &d));
  OK(map4_make_tetrahedron(&four, NULL, &e));
  OK(map4_sew(&four, 4, d, map4_beta(&four, 0, e)));
  OK(map4_count_cells(&four, 3, &memory, &n));
  ck_assert_uint_eq(n, 1); /* beta 4 does not divide 3-cells */
  OK(map4_count_cells(&four, 4, &memory, &n));
  ck_assert_uint_eq(n, 2);
  ck_assert_uint_eq(map4_count_0(&four), 4);
  ck_assert_uint_eq(map4_count_2(&four), 4);
  map4_mesh_clear(&four);
  gmds_ids_clear(&list);
}
END_TEST

int main(void)
{
  const TTest *const tests[] = {the_stencils_are_the_shapes,
                                cells_that_are_made_have_their_nodes_edges_and_faces,
                                sewing_two_cubes_makes_their_face_one,
                                sew_with_unequal_faces_is_refused,
                                attributes_are_merged_and_split_by_their_functions,
                                links_break_cells_and_restore_cells_repairs_them,
                                a_grid_of_cubes_is_matched_by_coordinates,
                                faces_are_matched_by_nodes_and_a_third_stays_free,
                                every_failing_allocation_of_a_match_changes_nothing,
                                removal_undoes_insertion,
                                a_face_divides_a_cube_into_prisms,
                                contracting_the_edges_of_a_triangle_leaves_nothing,
                                closing_adds_what_is_outside,
                                a_check_names_what_is_wrong,
                                checksum_and_isomorphism_do_not_depend_on_the_numbering,
                                bytes_bring_a_map_back,
                                bytes_that_are_broken_are_refused_and_nothing_is_half_read,
                                cells_that_are_not_kept_are_counted_by_orbits};
  gmds_memory_init(&memory, NULL);
  return run_suite("maps", tests, sizeof tests / sizeof *tests);
}
