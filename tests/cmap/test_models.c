/* Claims about maps as models: queries by orbits are those of the complex of their cells, soups come and go with their
 * attributes, what is no manifold is refused, and algorithms run. */
#include "brute.h"
#include "harness.h"
#include "models.h"
#include <gmds/io.h>
#include <math.h>

#define OK(call) ck_assert_int_eq(call, GMDS_OK)
static gmds_memory memory;

static void verify(const gmds_map *map)
{
  gmds_error error = {.text = ""};
  ck_assert_msg(gmds_map_check(map, &memory, NULL, &error) == GMDS_OK, "%s", error.text);
}

/* Whether two lists are the same set, each without repetition. */
static int same_set(size_t n, const gmds_id *a, size_t m, const gmds_id *b)
{
  for (size_t k = 0; k < n && n == m; k++) {
    size_t in_a = 0, in_b = 0;
    for (size_t q = 0; q < n; q++) {
      in_a += a[q] == a[k];
      in_b += b[q] == a[k];
    }
    if (in_a != 1 || in_b != 1)
      return 0;
  }
  return n == m;
}

/* get_adj_i_j of every cell, and all_adj_i_j, against the complex. */
static void compare(const gmds_map *map, int i, int j, gmds_complex *cells)
{
  gmds_csr expected, all;
  gmds_ids list = {.memory = &memory};
  gmds_csr_init(&expected, &memory);
  gmds_csr_init(&all, &memory);
  OK(gmds_complex_relation(cells, i, j, 0, &expected, NULL));
  OK(gmds_map_all_adjacent(map, i, j, &all));
  for (gmds_id c = 0; c < map->cells[i].end; c++) {
    const size_t n = expected.begin[c + 1] - expected.begin[c];
    if (!gmds_cells_has(&map->cells[i], c))
      continue;
    const gmds_status status = gmds_map_adjacent(map, i, j, c, &list);
    if (status != GMDS_OK || !same_set(n, expected.data + expected.begin[c], list.n, list.data))
      ck_abort_msg("%d -> %d of cell %lu: %zu cells instead of %zu", i, j, (unsigned long)c, list.n, n);
    if (!same_set(n, expected.data + expected.begin[c], all.begin[c + 1] - all.begin[c], all.data + all.begin[c]))
      ck_abort_msg("all %d -> %d: another row for cell %lu", i, j, (unsigned long)c);
  }
  ck_assert_int_eq(gmds_map_adjacent(map, i, j, (gmds_id)map->cells[i].end, &list), GMDS_ERR_CELL);
  gmds_ids_clear(&list);
  gmds_csr_clear(&expected);
  gmds_csr_clear(&all);
}

static void compare_all(const gmds_map *map)
{
  gmds_complex cells;
  gmds_error error = {.text = ""};
  gmds_complex_init(&cells, &memory, 0);
  ck_assert_msg(gmds_map_get_complex(map, &cells, &error) == GMDS_OK, "%s", error.text);
  for (int i = 0; i <= map->n; i++)
    for (int j = 0; j <= map->n; j++)
      compare(map, i, j, &cells);
  gmds_complex_clear(&cells);
}

static void soup_begin(gmds_soup *soup, int dim, size_t n, const double *x)
{
  gmds_soup_init(soup, &memory, dim);
  for (size_t k = 0; k < n; k++)
    OK(gmds_soup_add_point(soup, x + (size_t)dim * k));
}

/* A grid of cubes, each with one number `what` deciding what it is cut into: itself, or two prisms. */
static void grid_soup(gmds_soup *soup, size_t n, int prisms)
{
  gmds_soup_init(soup, &memory, 3);
  const size_t row = n + 1;
  for (size_t v = 0; v < row * row * row; v++)
    OK(gmds_soup_add_point(soup,
                           (const double[]){(double)(v % row), (double)(v / row % row), (double)(v / row / row)}));
  for (size_t c = 0; c < n * n * n; c++) {
    const gmds_id a = (gmds_id)(c % n + row * (c / n % n) + row * row * (c / n / n)), y = (gmds_id)row,
                  z = (gmds_id)(row * row);
    const gmds_id v[8] = {a, a + 1, a + 1 + y, a + y, a + z, a + 1 + z, a + 1 + y + z, a + y + z};
    if (!prisms) {
      OK(gmds_soup_add_cell(soup, GMDS_HEXAHEDRON, 8, v));
      continue;
    }
    OK(gmds_soup_add_cell(soup, GMDS_PRISM, 6, (const gmds_id[]){v[0], v[1], v[2], v[4], v[5], v[6]}));
    OK(gmds_soup_add_cell(soup, GMDS_PRISM, 6, (const gmds_id[]){v[0], v[2], v[3], v[4], v[6], v[7]}));
  }
}

START_TEST(queries_of_2_maps_are_those_of_their_cells)
{
  gmds_soup soup;
  whole2_mesh m;
  gmds_soup_init(&soup, &memory, 2);
  OK(gmds_make_points("random:300:4", 2, NULL, &soup));
  OK(whole2_mesh_init(&m, NULL));
  OK(whole2_delaunay(&m, soup.n_points, soup.points, NULL, NULL));
  verify(&m.map);
  compare_all(&m.map);
  ck_assert_uint_eq(whole2_count_0(&m) + whole2_count_2(&m), whole2_count_1(&m) + 1);
  whole2_mesh_clear(&m);
  gmds_soup_clear(&soup);
  /* polygons: a hexagon, squares around it, triangles between */
  double x[36];
  for (int k = 0; k < 6; k++) {
    const double t = acos(-1) / 3 * k, u = t + acos(-1) / 6;
    x[2 * k] = cos(t);
    x[2 * k + 1] = sin(t);
    for (int s = 0; s < 2; s++) { /* the square beyond side k */
      x[12 + 4 * k + 2 * s] = cos(t + s * acos(-1) / 3) + cos(u);
      x[12 + 4 * k + 2 * s + 1] = sin(t + s * acos(-1) / 3) + sin(u);
    }
  }
  soup_begin(&soup, 2, 18, x);
  OK(gmds_soup_add_cell(&soup, GMDS_POLYGON, 6, (const gmds_id[]){0, 1, 2, 3, 4, 5}));
  for (gmds_id k = 0; k < 6; k++) {
    const gmds_id next = (k + 1) % 6, out = 6 + 2 * k;
    OK(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, (const gmds_id[]){k, out, out + 1, next}));
    OK(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, (const gmds_id[]){next, out + 1, 6 + 2 * next}));
  }
  OK(whole2_mesh_init(&m, NULL));
  OK(whole2_from_soup(&m, &soup, NULL));
  verify(&m.map);
  compare_all(&m.map);
  brute_check_cells(&m.map);
  ck_assert_uint_eq(whole2_count_1(&m), 18 + 13 - 1);
  gmds_id side = whole2_face_node(&m, 1, 2);
  unsigned arrival = 9;
  ck_assert_uint_lt(side, 18);
  for (gmds_id f = 0; f < 13; f++)
    for (unsigned k = 0; k < whole2_face_sides(&m, f); k++) {
      const gmds_id g = whole2_across(&m, f, k, &arrival);
      ck_assert_uint_eq(g, whole2_face_beside(&m, f, k));
      if (g != GMDS_NONE)
        ck_assert_uint_eq(whole2_face_node(&m, g, arrival),
                          whole2_face_node(&m, f, (k + 1) % whole2_face_sides(&m, f)));
    }
  whole2_mesh_clear(&m);
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(queries_of_3_maps_are_those_of_their_cells)
{
  for (int what = 0; what < 3; what++) {
    gmds_soup soup;
    whole3_mesh m;
    gmds_error error = {.text = ""};
    OK(whole3_mesh_init(&m, NULL));
    if (what < 2)
      grid_soup(&soup, 3, what);
    else { /* tetrahedra of a triangulation */
      map3_mesh t;
      gmds_soup points;
      gmds_soup_init(&points, &memory, 3);
      gmds_soup_init(&soup, &memory, 3);
      OK(gmds_make_points("random:80:4", 3, NULL, &points));
      OK(map3_mesh_init(&t, NULL));
      OK(map3_delaunay(&t, points.n_points, points.points, NULL, NULL));
      OK(map3_to_soup(&t, &soup, NULL));
      map3_mesh_clear(&t);
      gmds_soup_clear(&points);
    }
    ck_assert_msg(whole3_from_soup(&m, &soup, &error) == GMDS_OK, "%s", error.text);
    verify(&m.map);
    compare_all(&m.map);
    gmds_soup back;
    gmds_soup_init(&back, &memory, 3);
    OK(whole3_to_soup(&m, &back, NULL));
    ck_assert_uint_eq(back.n_points, soup.n_points);
    ck_assert_uint_eq(back.n_cells, soup.n_cells);
    ck_assert_int_eq(memcmp(back.types, soup.types, soup.n_cells), 0);
    gmds_soup_clear(&back);
    gmds_soup_clear(&soup);
    whole3_mesh_clear(&m);
  }
}
END_TEST

START_TEST(polyhedra_come_and_go)
{
  /* a cube and on it a pyramid whose four walls are one node higher, as polyhedra */
  const double x[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 0.5, 0.5, 2};
  const gmds_id cube[] = {6, 4, 0, 3, 2, 1, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4, 4, 1, 2, 6, 5, 4, 2, 3, 7, 6, 4, 3, 0, 4, 7};
  const gmds_id roof[] = {5, 4, 4, 7, 6, 5, 3, 4, 5, 8, 3, 5, 6, 8, 3, 6, 7, 8, 3, 7, 4, 8};
  gmds_soup soup, back;
  gmds_error error = {.text = ""};
  soup_begin(&soup, 3, 9, x);
  OK(gmds_soup_add_cell(&soup, GMDS_POLYHEDRON, sizeof cube / sizeof *cube, cube));
  OK(gmds_soup_add_cell(&soup, GMDS_POLYHEDRON, sizeof roof / sizeof *roof, roof));
  whole3_mesh m;
  OK(whole3_mesh_init(&m, NULL));
  ck_assert_msg(whole3_from_soup(&m, &soup, &error) == GMDS_OK, "%s", error.text);
  verify(&m.map);
  ck_assert_uint_eq(whole3_count_2(&m), 10);
  ck_assert_uint_eq(whole3_count_1(&m), 16);
  compare_all(&m.map);
  gmds_soup_init(&back, &memory, 3);
  OK(whole3_to_soup(&m, &back, NULL));
  ck_assert_int_eq(back.types[0], GMDS_HEXAHEDRON); /* what has the faces of one is one */
  ck_assert_int_eq(back.types[1], GMDS_PYRAMID);
  gmds_id made = 0;
  OK(whole3_insert_vertex_in_edge(&m, 0, (const double[]){0.5, 0, 0}, &made));
  gmds_volume volume;
  gmds_volume_init(&volume, &memory);
  OK(whole3_get_volume(&m, &volume, &error));
  ck_assert_int_eq(volume.complex.types[0], GMDS_POLYHEDRON);
  map3_mesh other; /* which keeps no faces */
  OK(map3_mesh_init(&other, NULL));
  ck_assert_msg(map3_set_volume(&other, &volume, &error) == GMDS_OK, "%s", error.text);
  verify(&other.map);
  int same = 0;
  OK(gmds_map_isomorphic(&m.map, &other.map, 1, &memory, &same));
  ck_assert_int_eq(same, 1);
  gmds_soup again;
  gmds_soup_init(&again, &memory, 3);
  OK(map3_to_soup(&other, &again, &error));
  ck_assert_uint_eq(again.n_points, 10);
  gmds_soup_clear(&again);
  map3_mesh_clear(&other);
  gmds_volume_clear(&volume);
  gmds_soup_clear(&back);
  gmds_soup_clear(&soup);
  whole3_mesh_clear(&m);
}
END_TEST

START_TEST(faces_that_turn_otherwise_are_turned)
{
  gmds_soup soup;
  uint64_t seed = 3;
  gmds_soup_init(&soup, &memory, 3);
  enum { ROW = 9 };
  for (int v = 0; v < ROW * ROW; v++) /* a torus in space */
    OK(gmds_soup_add_point(
        &soup, (const double[]){cos(v % ROW) * (3 + cos(v / ROW)), sin(v % ROW) * (3 + cos(v / ROW)), sin(v / ROW)}));
  for (gmds_id f = 0; f < ROW * ROW; f++) {
    const gmds_id i = f % ROW, j = f / ROW, k = (i + 1) % ROW, l = (j + 1) % ROW;
    gmds_id v[4] = {i + ROW * j, k + ROW * j, k + ROW * l, i + ROW * l};
    if (random_below(&seed, 2)) {
      v[1] = i + ROW * l;
      v[3] = k + ROW * j;
    }
    OK(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, v));
  }

  whole2_mesh flat;
  OK(whole2_mesh_init(&flat, NULL));
  gmds_error error = {.text = ""};
  ck_assert_int_eq(whole2_from_soup(&flat, &soup, &error), GMDS_ERR_UNSUPPORTED); /* nodes of the plane */
  whole2_mesh_clear(&flat);
  gmds_map m;
  gmds_volume volume;
  gmds_volume_init(&volume, &memory);
  OK(gmds_volume_from_soup(&volume, &soup, NULL));
  gmds_map_init(&m, 2, 3, 15, NULL);
  ck_assert_msg(gmds_map_set_volume(&m, &volume, &error) == GMDS_OK, "%s", error.text);
  verify(&m);
  ck_assert_uint_eq(m.cells[1].count, 2 * ROW * ROW);
  for (gmds_id d = 0; d < m.darts.end; d++)
    ck_assert(gmds_map_beta(&m, 2, d) != GMDS_NONE);
  gmds_map_clear(&m);
  gmds_volume_clear(&volume);
  gmds_soup_clear(&soup);
}
END_TEST

/* Fills a 2-map with triangles; the status, and what is said. */
static gmds_status fill(whole2_mesh *m, size_t n_points, size_t n, gmds_id v[][3], gmds_error *error)
{
  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 2);
  for (size_t k = 0; k < n_points; k++)
    OK(gmds_soup_add_point(&soup, (const double[]){(double)k, (double)(k * k)}));
  for (size_t k = 0; k < n; k++)
    OK(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, v[k]));
  OK(whole2_mesh_init(m, NULL));
  gmds_status status = whole2_from_soup(m, &soup, error);
  gmds_soup_clear(&soup);
  return status;
}

START_TEST(what_is_no_manifold_is_refused_and_pinched_nodes_are_split)
{
  gmds_error error = {.text = ""};
  whole2_mesh m;
  gmds_id fins[3][3] = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  ck_assert_int_eq(fill(&m, 5, 3, fins, &error), GMDS_ERR_CONFLICT);
  ck_assert_ptr_nonnull(strstr(error.text, "face 2"));
  ck_assert_uint_eq(whole2_count_0(&m) + whole2_count_darts(&m), 0);
  whole2_mesh_clear(&m);
  gmds_id moebius[5][3] = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  ck_assert_int_eq(fill(&m, 5, 5, moebius, &error), GMDS_ERR_CONFLICT);
  ck_assert_ptr_nonnull(strstr(error.text, "orientable"));
  whole2_mesh_clear(&m);
  gmds_id bow[2][3] = {{0, 1, 2}, {0, 3, 4}};
  OK(fill(&m, 5, 2, bow, &error));
  verify(&m.map);
  ck_assert_uint_eq(whole2_count_0(&m), 6);
  ck_assert_uint_eq(whole2_count_2(&m), 2);
  whole2_mesh_clear(&m);
  gmds_soup soup;
  whole3_mesh t;
  const double x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 1, 1, 1};
  soup_begin(&soup, 3, 6, x);
  OK(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, (const gmds_id[]){0, 1, 2, 3}));
  OK(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, (const gmds_id[]){0, 1, 2, 4})); /* turned the other way */
  OK(whole3_mesh_init(&t, NULL));
  OK(whole3_from_soup(&t, &soup, &error));
  verify(&t.map);
  ck_assert_uint_eq(whole3_count_2(&t), 7);
  whole3_mesh_clear(&t);
  OK(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, (const gmds_id[]){0, 1, 2, 5}));
  ck_assert_int_eq(whole3_from_soup(&t, &soup, &error), GMDS_ERR_CONFLICT);
  ck_assert_ptr_nonnull(strstr(error.text, "region 2"));
  whole3_mesh_clear(&t);
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(attributes_go_along_both_ways)
{
  gmds_soup soup, back;
  whole3_mesh m;
  gmds_attribute *a = NULL;
  grid_soup(&soup, 2, 1);
  OK(gmds_soup_add_attribute(&soup, GMDS_OF_POINTS, "heat", GMDS_DOUBLE, 1, &a));
  for (size_t k = 0; k < soup.n_points; k++)
    ((double *)a->data)[k] = 0.5 + (double)k;
  OK(gmds_soup_add_attribute(&soup, GMDS_OF_CELLS, "ref", GMDS_INT, 1, &a));
  for (size_t k = 0; k < soup.n_cells; k++)
    ((int *)a->data)[k] = (int)(100 + k);
  OK(whole3_mesh_init(&m, NULL));
  OK(whole3_from_soup(&m, &soup, NULL));
  verify(&m.map);
  for (gmds_id v = 0; v < whole3_end_0(&m); v++)
    ck_assert_double_eq(((double *)whole3_find_attribute(&m, 0, "heat")->data)[v], 0.5 + v);
  gmds_soup_init(&back, &memory, 3);
  OK(whole3_to_soup(&m, &back, NULL));
  const gmds_attribute *ref = gmds_soup_find_attribute(&back, GMDS_OF_CELLS, "ref");
  ck_assert_ptr_nonnull(ref);
  ck_assert_uint_eq(back.n_cells, soup.n_cells);
  for (size_t k = 0; k < back.n_cells; k++) {
    ck_assert_int_eq(((int *)ref->data)[k], (int)(100 + k));
    for (size_t q = 0; q < 6; q++) /* the same nodes, in an order of a prism */
      ck_assert(same_set(6, back.corners + back.begin[k], 6, soup.corners + soup.begin[k]));
  }
  gmds_soup_clear(&back);
  whole3_mesh_clear(&m);
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    OK(whole3_mesh_init(&m, &allocator));
    gmds_status status = whole3_from_soup(&m, &soup, NULL);
    done = status == GMDS_OK;
    if (!done && (status != GMDS_ERR_MEMORY || whole3_count_darts(&m) || whole3_count_0(&m) || f.live))
      ck_abort_msg("allocation %ld: status %d leaves something", k, status);
    whole3_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(faces_and_regions_are_added_where_their_neighbours_are)
{
  whole2_mesh m;
  gmds_id v = 0, f = 0;
  OK(whole2_mesh_init(&m, NULL));
  for (int k = 0; k < 6; k++)
    OK(whole2_add_node(&m, (const double[]){k, k * k}, &v));
  OK(whole2_add_triangle(&m, 0, 1, 2, &f));
  ck_assert_int_eq(whole2_add_triangle(&m, 0, 1, 3, &f), GMDS_ERR_CONFLICT); /* turned */
  ck_assert_int_eq(whole2_add_triangle(&m, 0, 3, 4, &f), GMDS_ERR_CONFLICT); /* pinched */
  ck_assert_int_eq(whole2_add_triangle(&m, 0, 3, 9, &f), GMDS_ERR_CELL);
  ck_assert_int_eq(whole2_add_triangle(&m, 0, 3, 3, &f), GMDS_ERR_ARGUMENT);
  OK(whole2_add_quadrilateral(&m, 1, 0, 3, 4, &f));
  ck_assert_int_eq(whole2_add_triangle(&m, 1, 0, 5, &f), GMDS_ERR_CONFLICT); /* a third */
  verify(&m.map);
  brute_check_cells(&m.map);
  ck_assert_uint_eq(whole2_count_1(&m), 6);
  OK(whole2_remove_face(&m, f, GMDS_DROP_BARE_EDGES));
  ck_assert_uint_eq(whole2_count_0(&m), 6);
  ck_assert_uint_eq(whole2_count_1(&m), 3);
  ck_assert_int_eq(whole2_remove_node(&m, 0, GMDS_REFUSE), GMDS_ERR_CONFLICT);
  OK(whole2_remove_node(&m, 0, GMDS_CASCADE));
  ck_assert_uint_eq(whole2_count_2(&m) + whole2_count_darts(&m), 0);
  ck_assert_uint_eq(whole2_count_0(&m), 5);
  whole2_mesh_clear(&m);
  whole3_mesh t;
  OK(whole3_mesh_init(&t, NULL));
  for (int k = 0; k < 8; k++)
    OK(whole3_add_node(&t, (const double[]){k & 1, k / 2 & 1, k / 4}, &v));
  OK(whole3_add_tetrahedron(&t, 0, 1, 2, 4, &f));
  OK(whole3_add_tetrahedron(&t, 1, 3, 2, 4, &f));
  ck_assert_int_eq(whole3_add_tetrahedron(&t, 1, 2, 4, 7, &f), GMDS_ERR_CONFLICT); /* a third on 1 2 4 */
  ck_assert_int_eq(whole3_add_tetrahedron(&t, 4, 5, 6, 7, &f), GMDS_ERR_CONFLICT); /* pinched at 4 */
  verify(&t.map);
  brute_check_cells(&t.map);
  ck_assert_uint_eq(whole3_count_2(&t), 7);
  OK(whole3_remove_region(&t, 1, GMDS_DROP_BARE));
  ck_assert_uint_eq(whole3_count_2(&t), 4);
  ck_assert_uint_eq(whole3_count_0(&t), 8);
  verify(&t.map);
  whole3_mesh_clear(&t);
}
END_TEST

START_TEST(algorithms_run_over_maps)
{
  gmds_soup soup;
  map2_mesh m;
  gmds_csr chains;
  gmds_quality quality;
  gmds_surface_report report;
  size_t open = 9, count = 0, moved = 0;
  gmds_soup_init(&soup, &memory, 2);
  OK(gmds_make_points("grid:9", 2, NULL, &soup));
  OK(map2_mesh_init(&m, NULL));
  OK(map2_delaunay(&m, soup.n_points, soup.points, NULL, NULL));
  gmds_csr_init(&chains, &memory);
  OK(map2_boundary(&m, &chains, &open));
  ck_assert_uint_eq(chains.n, 1);
  ck_assert_uint_eq(chains.begin[1], 32);
  ck_assert_uint_eq(open, 0);
  gmds_csr_clear(&chains);
  gmds_id *component = malloc(map2_end_2(&m) * sizeof *component);
  OK(map2_components(&m, component, &count));
  ck_assert_uint_eq(count, 1);
  free(component);
  OK(map2_quality(&m, NULL, NULL, &quality));
  ck_assert_double_eq_tol(quality.size, 64, 1e-12);
  OK(map2_manifold(&m, &report));
  ck_assert_int_eq(report.manifold && report.orientable && !report.turned.count, 1);
  uint64_t sum = 0, after = 1;
  OK(map2_checksum(&m, &memory, &sum));
  OK(map2_renumber(&m, NULL, NULL));
  verify(&m.map);
  OK(map2_checksum(&m, &memory, &after));
  ck_assert_uint_eq(sum, after);
  OK(map2_smooth(&m, 2, &moved));
  map2_mesh_clear(&m);
  gmds_soup_clear(&soup);

  map3_mesh t;
  gmds_volume_report solid;
  grid_soup(&soup, 3, 0);
  OK(map3_mesh_init(&t, NULL));
  OK(map3_from_soup(&t, &soup, NULL));
  OK(map3_quality(&t, NULL, NULL, &quality));
  ck_assert_double_eq_tol(quality.size, 27, 1e-12);
  ck_assert_double_eq_tol(quality.min, 1, 1e-12);
  OK(map3_manifold(&t, &solid));
  ck_assert_int_eq(solid.manifold, 1);
  ck_assert_uint_eq(solid.border.count, 54);
  ck_assert_uint_eq(solid.inverted.count, 0);
  gmds_csr walls;
  gmds_csr_init(&walls, &memory);
  OK(map3_boundary(&t, &walls, NULL));
  ck_assert_uint_eq(walls.n, 54);
  gmds_csr_clear(&walls);
  OK(map3_renumber(&t, NULL, NULL));
  verify(&t.map);
  OK(map3_smooth(&t, 1, &moved));
  gmds_id parts[27];
  OK(map3_components(&t, parts, &count));
  ck_assert_uint_eq(count, 1);
  map3_mesh_clear(&t);
  gmds_soup_clear(&soup);
}
END_TEST

/* A star of every failing allocation: nothing has changed, or all. */
START_TEST(a_star_that_fails_changes_nothing)
{
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = 100000};
    gmds_allocator allocator = failing_allocator(&f);
    whole2_mesh m;
    gmds_id v = 0, face = 0, ids[3] = {7, 7, 7};
    OK(whole2_mesh_init(&m, &allocator));
    for (int i = 0; i < 4; i++)
      OK(whole2_add_node(&m, (const double[]){i % 2, i / 2}, &v));
    OK(whole2_add_triangle(&m, 0, 1, 2, &face));
    OK(whole2_trim(&m));
    const gmds_cavity_face cavity = {face, {0, 1, 2}, 0};
    gmds_cavity_side sides[3];
    for (unsigned i = 0; i < 3; i++)
      sides[i] = (gmds_cavity_side){i, (i + 1) % 3, GMDS_NONE, 0, 0, i};
    f.until = k;
    gmds_status status = whole2_star(&m, 3, 1, &cavity, 3, sides, ids);
    done = status == GMDS_OK;
    f.until = 100000;
    ck_assert(done || (status == GMDS_ERR_MEMORY && ids[0] == 7));
    ck_assert_uint_eq(whole2_count_2(&m), done ? 3 : 1);
    ck_assert_uint_eq(whole2_count_1(&m), done ? 6 : 3);
    verify(&m.map);
    brute_check_cells(&m.map);
    whole2_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
}
END_TEST

START_TEST(a_triangulation_without_memory_leaves_the_map_empty)
{
  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 3);
  OK(gmds_make_points("random:40:5", 3, NULL, &soup));
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    map3_mesh m;
    OK(map3_mesh_init(&m, &allocator));
    gmds_status status = map3_delaunay(&m, soup.n_points, soup.points, NULL, NULL);
    done = status == GMDS_OK;
    if (!done && (status != GMDS_ERR_MEMORY || map3_count_darts(&m) || map3_count_0(&m)))
      ck_abort_msg("allocation %ld: status %d leaves something", k, status);
    map3_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
  gmds_soup_clear(&soup);
}
END_TEST

int main(void)
{
  const TTest *const tests[] = {queries_of_2_maps_are_those_of_their_cells,
                                queries_of_3_maps_are_those_of_their_cells,
                                polyhedra_come_and_go,
                                faces_that_turn_otherwise_are_turned,
                                what_is_no_manifold_is_refused_and_pinched_nodes_are_split,
                                attributes_go_along_both_ways,
                                faces_and_regions_are_added_where_their_neighbours_are,
                                algorithms_run_over_maps,
                                a_star_that_fails_changes_nothing,
                                a_triangulation_without_memory_leaves_the_map_empty};
  gmds_memory_init(&memory, NULL);
  return run_suite("maps as models", tests, sizeof tests / sizeof *tests);
}
