/* What a failing call leaves behind, in the models that are compiled with algorithms: for every k, the k-th allocation
 * of an operation fails; there is no room for more cells; the caller cancels; an argument is wrong. */
#include "models/script.h"
#include <gmds/checksum.h>
#include <limits.h>
#include <math.h>

static subject one;

static const model *with_algorithms(size_t k)
{
  return all_models[k]->algorithms ? all_models[k] : NULL;
}

/* A model that can triangulate: its first triangles are looked up. */
static const model *with_delaunay(size_t k)
{
  const model *m = with_algorithms(k);
  return m && m->algorithms->do_delaunay && !needs_links(m) ? m : NULL;
}

/* ---- elementary operations */

static void trim(subject *s)
{
  gmds_status status;
  begin_attempts(s);
  do
    status = s->m->do_trim(s->mesh);
  while (again(s, status));
  ck_assert_int_eq(status, GMDS_OK);
}

START_TEST(an_operation_without_memory_changes_nothing)
{
  size_t models = 0;
  for (size_t k = 0; k < n_models; k++) {
    if (!with_algorithms(k))
      continue;
    models++;
    subject_begin(&one, all_models[k], 500 + k);
    one.inject = 1;
    script_grid(&one, 2, 2, 2);
    for (int i = 0; i < 60; i++) {
      trim(&one); /* no room is left: everything must be asked for */
      script_step(&one);
      if (i % 20 == 19)
        subject_compact(&one);
    }
    subject_compare(&one);
    subject_end(&one);
  }
  ck_assert_uint_ge(models, 30);
}
END_TEST

START_TEST(faces_at_once_without_memory_change_nothing)
{
  static subject like;
  static face_list list;
  for (size_t k = 0; k < n_models; k++) {
    if (!with_algorithms(k))
      continue;
    subject_begin(&like, all_models[k], 9);
    subject_begin(&one, all_models[k], 9);
    script_grid(&like, 2, 2, 2);
    script_nodes(&one, like.ref.end[0]);
    script_list(&like, &list);
    one.inject = 1;
    ck_assert_int_eq(script_at_once(&one, &like, &list, NULL), GMDS_OK);
    ck_assert_int_ge(one.attempt, 2);
    subject_compare(&one);
    subject_end(&one);
    subject_end(&like);
  }
}
END_TEST

START_TEST(a_table_of_edges_without_memory_stays_empty)
{
  for (size_t k = 0; k < n_models; k++) {
    if (!with_algorithms(k) || !all_models[k]->do_all_edges)
      continue;
    subject_begin(&one, all_models[k], 1);
    script_grid(&one, 2, 2, 2);
    failing f = {.until = 0};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    gmds_status status = GMDS_ERR_MEMORY;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      gmds_edge_table table;
      gmds_edge_table_init(&table, &memory);
      f.until = n;
      status = one.m->do_all_edges(one.mesh, &table);
      ck_assert(status == GMDS_OK || (!table.n && !table.nodes && !table.edges && !table.begin));
      gmds_edge_table_clear(&table);
      ck_assert_uint_eq(f.live, 0);
    }
    ck_assert_int_eq(status, GMDS_OK);
    subject_end(&one);
  }
}
END_TEST

START_TEST(a_query_without_memory_fails_and_the_next_is_right)
{
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_algorithms(k);
    if (!m)
      continue;
    subject_begin(&one, m, 1);
    script_grid(&one, 2, 2, 2);
    failing f = {.until = 0};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        gmds_status status = m->can[i][j] ? GMDS_ERR_MEMORY : GMDS_OK;
        for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
          gmds_ids list = {.memory = &memory};
          f.until = n;
          status = m->do_query(one.mesh, i, j, reference_pick(&one.ref, i, &one.seed), &list);
          gmds_ids_clear(&list);
          ck_assert_uint_eq(f.live, 0);
          ck_assert(n > 0 || status == GMDS_ERR_MEMORY);
        }
        ck_assert_int_eq(status, GMDS_OK);
        status = m->can[i][j] ? GMDS_ERR_MEMORY : GMDS_OK;
        for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
          gmds_csr csr;
          gmds_csr_init(&csr, &memory);
          f.until = n;
          status = m->do_bulk(one.mesh, i, j, &csr);
          ck_assert(status == GMDS_OK || (!csr.begin && !csr.data));
          gmds_csr_clear(&csr);
          ck_assert_uint_eq(f.live, 0);
        }
        ck_assert_int_eq(status, GMDS_OK);
      }
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

START_TEST(a_check_without_memory_says_so)
{
  for (size_t k = 0; k < n_models; k++) {
    if (!with_algorithms(k))
      continue;
    subject_begin(&one, all_models[k], 1);
    script_grid(&one, 2, 2, 2);
    failing f = {.until = 0};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    gmds_status status = GMDS_ERR_MEMORY;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      gmds_error error = {0};
      f.until = n;
      status = one.m->do_check(one.mesh, &memory, &error);
      ck_assert(status == GMDS_OK || strstr(error.text, "memory"));
      ck_assert_uint_eq(f.live, 0);
    }
    ck_assert_int_eq(status, GMDS_OK);
    subject_end(&one);
  }
}
END_TEST

/* ---- whole meshes */

static void is_empty_with_its_attributes(subject *s)
{
  for (int i = 0; i < 3; i++) {
    gmds_cells *cells = &s->m->do_cells(s->mesh)[i];
    if (cells->count || cells->end || !gmds_attribute_find(cells, "tag"))
      subject_fail(s, "a failure left cells of dimension %d, or took their attribute", i);
  }
}

enum { POINTS = 60 };

/* Points on a coarse lattice, so that some occur twice, a few anywhere. */
static void make_points(double *xy)
{
  uint64_t seed = 7;
  for (size_t i = 0; i < POINTS; i++)
    for (size_t k = 0; k < 2; k++)
      xy[2 * i + k] = i % 3 ? (double)random_below(&seed, 8) / 8 : random_unit(&seed);
}

START_TEST(a_triangulation_without_memory_leaves_the_mesh_empty)
{
  double xy[2 * POINTS];
  uint64_t first = 0;
  make_points(xy);
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_delaunay(k);
    if (!m)
      continue;
    subject_begin(&one, m, 1);
    gmds_allocator allocator = failing_allocator(&one.from);
    gmds_delaunay_result result;
    gmds_delaunay_result_init(&result, &allocator);
    gmds_status status = GMDS_ERR_MEMORY;
    size_t before = one.from.live;
    for (one.attempt = 0; status == GMDS_ERR_MEMORY; one.attempt++) {
      gmds_error error = {0};
      const gmds_delaunay_options options = {.error = &error};
      one.from.until = one.attempt;
      status = m->algorithms->do_delaunay(one.mesh, POINTS, xy, &options, &result);
      one.from.until = LONG_MAX;
      if (status == GMDS_OK)
        break;
      if (status != GMDS_ERR_MEMORY || (error.text[0] && !strstr(error.text, "memory")))
        subject_fail(&one, "'%s' and '%s'", gmds_status_text(status), error.text);
      is_empty_with_its_attributes(&one);
      if (one.from.live != before || result.node_of || result.chain || result.points)
        subject_fail(&one, "%zu bytes are held after a failure", one.from.live - before);
    }
    ck_assert_int_gt(one.attempt, 10);
    uint64_t sum = 0;
    gmds_error error = {0};
    if (m->do_check(one.mesh, &one.memory, &error) != GMDS_OK)
      subject_fail(&one, "%s", error.text);
    ck_assert_int_eq(m->algorithms->do_checksum(one.mesh, &one.memory, &sum), GMDS_OK);
    first = first ? first : sum;
    ck_assert_uint_eq(sum, first);
    gmds_delaunay_result_clear(&result);
    subject_end(&one);
  }
}
END_TEST

/* The grid of a subject as a soup, with an edge in it. */
static void make_soup(gmds_soup *soup, gmds_memory *memory, const model *m)
{
  gmds_soup_init(soup, memory, 2);
  for (int i = 0; i < 9; i++) {
    const double x[2] = {i % 3, i / 3};
    ck_assert_int_eq(gmds_soup_add_point(soup, x), GMDS_OK);
  }
  for (gmds_id i = 0; i < 4; i++) {
    gmds_id a = i % 2 + i / 2 * 3;
    const gmds_id corners[4] = {a, a + 1, a + 4, a + 3}, half[3] = {a, a + 1, a + 4};
    if (allows(m, 4))
      ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_QUADRILATERAL, 4, corners), GMDS_OK);
    else
      ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_TRIANGLE, 3, half), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_SEGMENT, 2, corners), GMDS_OK);
  }
}

START_TEST(a_conversion_without_memory_leaves_both_sides_as_they_were)
{
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_algorithms(k);
    if (!m)
      continue;
    gmds_soup soup, back;
    subject_begin(&one, m, 1);
    make_soup(&soup, &one.memory, m);
    gmds_status status = GMDS_ERR_MEMORY;
    gmds_error error = {0};
    size_t before = one.from.live;
    for (one.attempt = 0; status == GMDS_ERR_MEMORY; one.attempt++) {
      one.from.until = one.attempt;
      status = m->algorithms->do_from_soup(one.mesh, &soup, &error);
      one.from.until = LONG_MAX;
      if (status == GMDS_OK)
        break;
      is_empty_with_its_attributes(&one);
      ck_assert_uint_eq(one.from.live, before);
    }
    ck_assert_int_eq(status, GMDS_OK);
    ck_assert_int_eq(m->algorithms->do_from_soup(one.mesh, &soup, &error), GMDS_ERR_ARGUMENT);
    ck_assert_uint_eq(m->do_cells(one.mesh)[0].count, 9);
    ck_assert_uint_eq(m->do_cells(one.mesh)[2].count, 4);
    failing f = {.until = LONG_MAX};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    gmds_soup_init(&back, &memory, 2);
    const double alone[2] = {3, 4};
    ck_assert_int_eq(gmds_soup_add_point(&back, alone), GMDS_OK);
    status = m->algorithms->do_to_soup ? GMDS_ERR_MEMORY : GMDS_OK;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      f.until = n;
      status = m->algorithms->do_to_soup(one.mesh, &back);
      ck_assert(status == GMDS_OK || (back.n_points == 1 && back.points[1] == 4));
    }
    ck_assert_int_eq(status, GMDS_OK);
    ck_assert(!m->algorithms->do_to_soup || back.n_cells == m->do_cells(one.mesh)[2].count);
    status = m->algorithms->do_checksum ? GMDS_ERR_MEMORY : GMDS_OK;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      uint64_t sum = 11;
      f.until = n;
      status = m->algorithms->do_checksum(one.mesh, &memory, &sum);
      ck_assert(status == GMDS_OK || sum == 11);
    }
    ck_assert_int_eq(status, GMDS_OK);
    gmds_soup_clear(&back);
    gmds_soup_clear(&soup);
    ck_assert_uint_eq(f.live, 0);
    subject_end(&one);
  }
}
END_TEST

/* ---- too many cells, and cancelling */

START_TEST(a_cell_beyond_the_limit_is_refused)
{
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_algorithms(k);
    if (!m)
      continue;
    subject_begin(&one, m, 1);
    script_grid(&one, 2, 2, 2);
    trim(&one);
    gmds_cells *cells = m->do_cells(one.mesh);
    const double x[3] = {0, 0, 0};
    const gmds_id fresh[4] = {0, 8, 9, 10}; /* new edges all around: 9 and 10 are on no face */
    const gmds_id none[4] = {GMDS_NONE, GMDS_NONE, GMDS_NONE, GMDS_NONE};
    const gmds_links links = {none, none};
    gmds_id id = 77;
    for (int i = 0; i < 3; i++) {
      size_t limit = cells[i].limit;
      cells[i].limit = cells[i].end;
      gmds_status status = i == 0 ? m->do_add_node(one.mesh, x, &id)
                           : i == 1 && !makes_edges(m)
                               ? GMDS_ERR_TOO_MANY
                               : m->do_add_face(one.mesh, allows(m, 3) ? 3 : 4, fresh, &links, &id);
      if (status != GMDS_ERR_TOO_MANY || id != 77)
        subject_fail(&one, "a cell of dimension %d beyond the limit: %s", i, gmds_status_text(status));
      subject_compare(&one);
      cells[i].limit = limit;
    }
    if (m->do_add_edge) {
      cells[1].limit = cells[1].end;
      ck_assert_int_eq(m->do_add_edge(one.mesh, 9, 10, &id), GMDS_ERR_TOO_MANY);
      subject_compare(&one);
    }
    subject_end(&one);
  }
}
END_TEST

START_TEST(a_triangulation_beyond_the_limit_leaves_the_mesh_empty)
{
  double xy[2 * POINTS];
  make_points(xy);
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_delaunay(k);
    if (!m)
      continue;
    for (int i = 0; i < (makes_edges(m) ? 3 : 2); i++) {
      static const int dimensions[] = {0, 2, 1};
      subject_begin(&one, m, 1);
      gmds_cells *cells = &m->do_cells(one.mesh)[dimensions[i]];
      cells->limit = 30;
      ck_assert_int_eq(m->algorithms->do_delaunay(one.mesh, POINTS, xy, NULL, NULL), GMDS_ERR_TOO_MANY);
      is_empty_with_its_attributes(&one);
      ck_assert_uint_eq(cells->limit, 30);
      subject_end(&one);
    }
  }
}
END_TEST

static int stop(void *user, size_t done, size_t total)
{
  size_t *calls = user;
  ck_assert_uint_lt(done, total);
  return ++*calls == 2;
}

START_TEST(a_cancelled_triangulation_leaves_the_mesh_empty)
{
  enum { MANY = 10000 };
  uint64_t seed = 3;
  double *xy = malloc(2 * MANY * sizeof *xy);
  ck_assert_ptr_nonnull(xy);
  for (size_t i = 0; i < 2 * (size_t)MANY; i++)
    xy[i] = random_unit(&seed);
  size_t cancelled = 0;
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_delaunay(k);
    if (!m || !m->crosses)
      continue; /* models without neighbours at hand would take minutes */
    subject_begin(&one, m, 1);
    size_t calls = 0;
    gmds_error error = {0};
    const gmds_delaunay_options options = {.progress = stop, .user = &calls, .error = &error};
    ck_assert_int_eq(m->algorithms->do_delaunay(one.mesh, MANY, xy, &options, NULL), GMDS_ERR_CANCELLED);
    ck_assert_int_eq(error.status, GMDS_ERR_CANCELLED);
    is_empty_with_its_attributes(&one);
    cancelled += calls == 2;
    subject_end(&one);
  }
  free(xy);
  ck_assert_uint_ge(cancelled, 3);
}
END_TEST

/* ---- arguments */

static void refuses(subject *s, gmds_status status, gmds_status expected, const char *what)
{
  if (status != expected)
    subject_fail(s, "%s: '%s', expected '%s'", what, gmds_status_text(status), gmds_status_text(expected));
}

START_TEST(a_wrong_argument_changes_nothing)
{
  const gmds_id gone = 1000;
  for (size_t k = 0; k < n_models; k++) {
    const model *m = all_models[k];
    subject_begin(&one, m, 1);
    script_grid(&one, 2, 2, 2);
    gmds_id id = 77, v = 9;
    size_t n = allows(m, 3) ? 3 : 4;
    subject_remove_node(&one, v, GMDS_REFUSE); /* isolated: a hole */
    const gmds_id dead[4] = {0, v, 10, 4}, twice[4] = {0, 8, 8, 0}, beyond[4] = {0, GMDS_NONE, 1, 2},
                  good[4] = {0, 8, 10, 2};
    const gmds_id bad[4] = {gone, GMDS_NONE, GMDS_NONE, GMDS_NONE},
                  none[4] = {GMDS_NONE, GMDS_NONE, GMDS_NONE, GMDS_NONE};
    const gmds_links edges = {bad, none}, faces = {none, bad};
    refuses(&one, m->do_add_face(one.mesh, n, dead, NULL, &id), GMDS_ERR_CELL, "a node in a hole");
    refuses(&one, m->do_add_face(one.mesh, n, beyond, NULL, &id), GMDS_ERR_CELL, "GMDS_NONE as a node");
    refuses(&one, m->do_add_face(one.mesh, n, twice, NULL, &id), GMDS_ERR_ARGUMENT, "a repeated node");
    refuses(&one, m->do_add_face(one.mesh, 2, good, NULL, &id), GMDS_ERR_ARGUMENT, "a face of two sides");
    refuses(&one, m->do_add_face(one.mesh, 0, good, NULL, &id), GMDS_ERR_ARGUMENT, "a face of no side");
    if (!allows(m, 3) || !allows(m, 4))
      refuses(&one, m->do_add_face(one.mesh, allows(m, 3) ? 4 : 3, good, NULL, &id), GMDS_ERR_ARGUMENT, "another type");
    if (makes_edges(m))
      refuses(&one, m->do_add_face(one.mesh, n, good, &edges, &id), GMDS_ERR_CELL, "a dead edge as a link");
    if (stores(m, 2, 2))
      refuses(&one, m->do_add_face(one.mesh, n, good, &faces, &id), GMDS_ERR_CELL, "a dead face as a link");
    if (m->do_add_edge) {
      refuses(&one, m->do_add_edge(one.mesh, 0, 0, &id), GMDS_ERR_ARGUMENT, "an edge from a node to itself");
      refuses(&one, m->do_add_edge(one.mesh, 0, v, &id), GMDS_ERR_CELL, "an edge to a node in a hole");
    }
    refuses(&one, m->do_remove_face(one.mesh, gone, GMDS_KEEP_EDGES), GMDS_ERR_CELL, "a face that is not");
    refuses(&one, m->do_remove_node(one.mesh, v, GMDS_CASCADE), GMDS_ERR_CELL, "a node that is gone");
    if (m->do_remove_edge)
      refuses(&one, m->do_remove_edge(one.mesh, gone, GMDS_CASCADE), GMDS_ERR_CELL, "an edge that is not");
    ck_assert_uint_eq(id, 77);
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

START_TEST(points_that_are_not_finite_change_nothing)
{
  for (size_t k = 0; k < n_models; k++) {
    const model *m = with_delaunay(k);
    if (!m)
      continue;
    subject_begin(&one, m, 1);
    const double xy[8] = {0, 0, 1, 0, 0, INFINITY, 1, 1};
    gmds_error error = {0};
    const gmds_delaunay_options options = {.error = &error};
    ck_assert_int_eq(m->algorithms->do_delaunay(one.mesh, 4, xy, &options, NULL), GMDS_ERR_COORDINATE);
    ck_assert_int_eq(error.cell, 2);
    is_empty_with_its_attributes(&one);
    script_grid(&one, 1, 1, 0);
    ck_assert_int_eq(m->algorithms->do_delaunay(one.mesh, 2, xy, &options, NULL), GMDS_ERR_ARGUMENT);
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

RUN_SUITE("failures", an_operation_without_memory_changes_nothing, faces_at_once_without_memory_change_nothing,
          a_table_of_edges_without_memory_stays_empty, a_query_without_memory_fails_and_the_next_is_right,
          a_check_without_memory_says_so, a_triangulation_without_memory_leaves_the_mesh_empty,
          a_conversion_without_memory_leaves_both_sides_as_they_were, a_cell_beyond_the_limit_is_refused,
          a_triangulation_beyond_the_limit_leaves_the_mesh_empty, a_cancelled_triangulation_leaves_the_mesh_empty,
          a_wrong_argument_changes_nothing, points_that_are_not_finite_change_nothing)
