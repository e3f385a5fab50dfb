/* What a failing call leaves behind in models of volumes: for every k, the k-th allocation of an operation fails, in
 * every operation of every compiled model. A status each time, the mesh as it was (an operation that fills it: empty),
 * nothing leaked, and the next attempt succeeds. */
#include "volumes/pool.h"
#include <limits.h>

static subject one, two;

/* ---- elementary operations */

/* Attributes of every dimension, which grow with the cells. */
static void give_attributes(subject *s)
{
  for (int i = 0; i < 4; i++) {
    gmds_attribute *a = NULL;
    ck_assert_int_eq(gmds_attribute_add(&s->m->do_cells(s->mesh)[i], "tag", GMDS_INT, 1, &a), GMDS_OK);
  }
}

START_TEST(an_operation_without_memory_changes_nothing)
{
  size_t attempts = 0, done = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    subject_begin(&one, volume_models[k], 300 + k);
    give_attributes(&one);
    pool_nodes(&one);
    one.inject = 1;
    for (int i = 0; i < 40; i++) {
      subject_trim(&one); /* no room is left: everything must be asked for */
      pool_step(&one);
      attempts += (size_t)one.attempt;
      if (i % 20 == 19) {
        one.inject = 0;
        subject_compare(&one);
        one.inject = 1;
        subject_compact(&one);
        pool_nodes(&one);
      }
    }
    one.inject = 0;
    subject_compare(&one);
    done += one.done;
    subject_end(&one);
  }
  printf("%zu operations done, %zu failures before the last step of each\n", done, attempts);
  ck_assert_uint_gt(attempts, n_volume_models);
}
END_TEST

/* ---- reading */

/* Memory that fails, beside that of the mesh. */
static failing elsewhere;
static gmds_memory scarce;

static void begin_elsewhere(void)
{
  const gmds_allocator allocator = failing_allocator(&elsewhere);
  elsewhere = (failing){.until = LONG_MAX};
  gmds_memory_init(&scarce, &allocator);
}

static void fill(subject *s, const volume_model *m, uint64_t seed)
{
  subject_begin(s, m, seed);
  pool_nodes(s);
  for (int i = 0; i < 30; i++)
    pool_step(s);
}

START_TEST(a_query_without_memory_fails_and_the_next_is_right)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    fill(&one, m, 700 + k);
    begin_elsewhere();
    const uint64_t before = subject_fingerprint(&one);
    for (int q = 0; q < 16; q++) {
      const gmds_id c = reference_pick(&one.ref, q / 4, &one.seed);
      gmds_status status = m->can[q / 4][q % 4] && c != GMDS_NONE ? GMDS_ERR_MEMORY : GMDS_OK;
      for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
        gmds_ids list = {.memory = &scarce};
        elsewhere.until = n;
        status = m->do_query(one.mesh, q / 4, q % 4, c, &list);
        gmds_ids_clear(&list);
        ck_assert_uint_eq(elsewhere.live, 0);
        ck_assert(n > 0 || status == GMDS_ERR_MEMORY);
      }
      ck_assert_int_eq(status, GMDS_OK);
      status = m->can[q / 4][q % 4] ? GMDS_ERR_MEMORY : GMDS_OK;
      for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
        gmds_csr csr;
        gmds_csr_init(&csr, &scarce);
        elsewhere.until = n;
        status = m->do_bulk(one.mesh, q / 4, q % 4, &csr);
        ck_assert(status == GMDS_OK || (!csr.begin && !csr.data));
        gmds_csr_clear(&csr);
        ck_assert_uint_eq(elsewhere.live, 0);
        ck_assert(n > 0 || status == GMDS_ERR_MEMORY);
      }
      ck_assert_int_eq(status, GMDS_OK);
    }
    ck_assert_uint_eq(subject_fingerprint(&one), before);
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

START_TEST(a_check_and_a_checksum_without_memory_say_so)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    fill(&one, m, 900 + k);
    begin_elsewhere();
    gmds_status status = GMDS_ERR_MEMORY;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      gmds_error error = {.status = GMDS_OK};
      elsewhere.until = n;
      status = m->do_check(one.mesh, &scarce, &error);
      if (status != GMDS_OK && (status != GMDS_ERR_MEMORY || !strstr(error.text, "memory")))
        subject_fail(&one, "a check without memory: '%s', '%s'", gmds_status_text(status), error.text);
      ck_assert_uint_eq(elsewhere.live, 0);
    }
    status = m->do_checksum ? GMDS_ERR_MEMORY : GMDS_OK;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      uint64_t sum = 11;
      elsewhere.until = n;
      status = m->do_checksum(one.mesh, &scarce, &sum);
      ck_assert(status == GMDS_OK || sum == 11);
      ck_assert_uint_eq(elsewhere.live, 0);
    }
    ck_assert_int_eq(status, GMDS_OK);
    subject_end(&one);
  }
}
END_TEST

/* ---- whole meshes */

static void is_empty(const subject *s)
{
  const gmds_cells *cells = s->m->do_cells(s->mesh);
  for (int i = 0; i < 4; i++)
    if (cells[i].count || cells[i].end)
      subject_fail(s, "a failure leaves %zu cells of dimension %d", cells[i].count, i);
  if (s->from.live || s->m->do_memory(s->mesh)->live)
    subject_fail(s, "%zu bytes are held after a failure", s->from.live);
}

static void says_memory(const subject *s, gmds_status status, const gmds_error *error)
{
  if (status != GMDS_ERR_MEMORY || error->status != status || !strstr(error->text, "memory"))
    subject_fail(s, "'%s', '%s'", gmds_status_text(status), error->text);
}

static void is_converted(const subject *s, const subject *from)
{
  const volume_model *m = s->m, *other = from->m;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory memory;
  uint64_t sum = 0, expected = 1;
  gmds_memory_init(&memory, NULL);
  if (m->do_check(s->mesh, &memory, &error) != GMDS_OK)
    subject_fail(s, "from %s: %s", other->name, error.text);
  ck_assert_int_eq(other->do_checksum(from->mesh, &memory, &expected), GMDS_OK);
  ck_assert_int_eq(m->do_checksum(s->mesh, &memory, &sum), GMDS_OK);
  ck_assert_uint_eq(sum, expected);
  for (int i = 0; i < 4; i++) /* where they keep the same */
    if ((i != 1 || (m->makes_edges && other->makes_edges)) && (i != 2 || (m->makes_faces && other->makes_faces)))
      ck_assert_uint_ge(m->do_cells(s->mesh)[i].count, other->do_cells(from->mesh)[i].count);
}

/* The mesh that is filled has no memory; whether it could have been filled. */
static size_t fill_without_memory(gmds_volume *volume, const volume_model *to)
{
  gmds_error error = {.status = GMDS_OK};
  gmds_status status = GMDS_ERR_MEMORY;
  subject_begin(&two, to, 1);
  for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
    two.from.until = n;
    status = to->do_set_volume(two.mesh, volume, &error);
    two.from.until = LONG_MAX;
    if (status == GMDS_OK)
      break;
    is_empty(&two);
    if (status == GMDS_ERR_MEMORY)
      says_memory(&two, status, &error);
  }
  ck_assert(status == GMDS_OK || status == GMDS_ERR_UNSUPPORTED || status == GMDS_ERR_CONFLICT);
  if (status == GMDS_OK)
    is_converted(&two, &one);
  subject_end(&two);
  return status == GMDS_OK;
}

START_TEST(a_conversion_without_memory_leaves_the_mesh_empty)
{
  uint64_t seed = 8;
  size_t converted = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k], *to = volume_models[random_below(&seed, n_volume_models)];
    if (!m->do_get_volume)
      continue;
    gmds_volume volume;
    gmds_error error = {.status = GMDS_OK};
    fill(&one, m, 60 + k);
    give_attributes(&one);
    begin_elsewhere();
    gmds_volume_init(&volume, &scarce);
    gmds_status status = GMDS_ERR_MEMORY;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      elsewhere.until = n;
      status = m->do_get_volume(one.mesh, &volume, &error);
      if (status == GMDS_OK)
        break;
      says_memory(&one, status, &error);
      ck_assert_uint_eq(elsewhere.live, 0);
    }
    elsewhere.until = LONG_MAX;
    converted += fill_without_memory(&volume, to);
    status = GMDS_ERR_MEMORY; /* where the volume has no memory, it goes on serving */
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      gmds_volume again;
      gmds_volume_init(&again, &scarce);
      ck_assert_int_eq(m->do_get_volume(one.mesh, &again, &error), GMDS_OK);
      subject_begin(&two, to, 1);
      elsewhere.until = n;
      status = to->do_set_volume(two.mesh, &again, &error);
      elsewhere.until = LONG_MAX;
      if (status == GMDS_ERR_MEMORY) {
        is_empty(&two);
        ck_assert_int_ne(to->do_set_volume(two.mesh, &again, &error), GMDS_ERR_MEMORY);
      }
      if (to->do_cells(two.mesh)[0].count)
        is_converted(&two, &one);
      subject_end(&two);
      gmds_volume_clear(&again);
    }
    gmds_volume_clear(&volume);
    ck_assert_uint_eq(elsewhere.live, 0);
    subject_compare(&one);
    subject_end(&one);
  }
  printf("%zu conversions\n", converted);
  ck_assert_uint_gt(converted, 90);
}
END_TEST

/* Cells of every type that a model holds, some twice, with attributes. */
static void make_soup(gmds_soup *soup, gmds_memory *memory, const subject *s)
{
  gmds_attribute *a = NULL;
  gmds_soup_init(soup, memory, 3);
  for (int v = 0; v < 28; v++) {
    const double x[3] = {v % 3, v / 3 % 3, v / 9 + v * v % 5 * 0.1};
    ck_assert_int_eq(gmds_soup_add_point(soup, x), GMDS_OK);
  }
  ck_assert_int_eq(gmds_soup_add_attribute(soup, GMDS_OF_POINTS, "heat", GMDS_DOUBLE, 2, &a), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(soup, GMDS_OF_CELLS, "tag", GMDS_INT, 1, &a), GMDS_OK);
  for (size_t i = 0; i < 2 * n_pool; i++) {
    const item *it = &pool[i % n_pool];
    const int dim = gmds_cell_type_dimension(it->type);
    const size_t n = (size_t)gmds_cell_type_points(it->type);
    if (dim == 3 && (!(s->m->regions >> (it->type - GMDS_TETRAHEDRON) & 1) || i > 12))
      continue; /* no third region on a face */
    if (dim == 2 && !(s->m->faces & (n == 3 ? 1u : 2u)))
      continue;
    ck_assert_int_eq(gmds_soup_add_cell(soup, it->type, n, it->nodes), GMDS_OK);
  }
  const gmds_id vertex = 26, any[] = {4, 3, 12, 13, 26, 3, 12, 13, 27, 3, 12, 26, 27, 3, 13, 26, 27};
  ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_VERTEX, 1, &vertex), GMDS_OK);
  if (s->m->regions >> (GMDS_POLYHEDRON - GMDS_TETRAHEDRON) & 1)
    ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_POLYHEDRON, sizeof any / sizeof *any, any), GMDS_OK);
}

START_TEST(a_soup_without_memory_leaves_both_sides_as_they_were)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    gmds_soup soup, back;
    gmds_error error = {.status = GMDS_OK};
    subject_begin(&one, m, 1);
    make_soup(&soup, &one.memory, &one);
    gmds_status status = GMDS_ERR_MEMORY;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      one.from.until = n;
      status = m->do_from_soup(one.mesh, &soup, &error);
      one.from.until = LONG_MAX;
      if (status == GMDS_OK)
        break;
      says_memory(&one, status, &error);
      is_empty(&one);
    }
    if (m->do_check(one.mesh, &one.memory, &error) != GMDS_OK)
      subject_fail(&one, "%s", error.text);
    ck_assert_int_eq(m->do_from_soup(one.mesh, &soup, &error), GMDS_ERR_ARGUMENT);
    begin_elsewhere();
    gmds_soup_init(&back, &scarce, 3);
    const double alone[3] = {3, 4, 5};
    ck_assert_int_eq(gmds_soup_add_point(&back, alone), GMDS_OK);
    const size_t before = elsewhere.live;
    status = m->do_to_soup ? GMDS_ERR_MEMORY : GMDS_OK;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      elsewhere.until = n;
      status = m->do_to_soup(one.mesh, &back, &error);
      if (status == GMDS_OK)
        break;
      says_memory(&one, status, &error);
      ck_assert(back.n_points == 1 && back.points[1] == 4 && elsewhere.live == before);
    }
    ck_assert_int_eq(status, GMDS_OK);
    if (m->do_to_soup)
      ck_assert_uint_eq(back.n_points, soup.n_points);
    gmds_soup_clear(&back);
    gmds_soup_clear(&soup);
    ck_assert_uint_eq(elsewhere.live, 0);
    subject_end(&one);
  }
}
END_TEST

/* ---- triangulation */

enum { POINTS = 14 };

/* Points anywhere, on a lattice where some occur twice, or in a plane. */
static void make_points(int how, double *xyz)
{
  uint64_t seed = 7;
  for (size_t i = 0; i < POINTS; i++)
    for (size_t k = 0; k < 3; k++)
      xyz[3 * i + k] = how == 2 && k == 2 ? 1 : how ? (double)random_below(&seed, 3) : random_unit(&seed);
}

START_TEST(a_triangulation_without_memory_leaves_the_mesh_empty)
{
  size_t models = 0, attempts = 0;
  uint64_t first[3] = {0, 0, 0};
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    for (int how = 0; m->do_delaunay && how < 3; how++) {
      double xyz[3 * POINTS];
      gmds_delaunay_result result;
      make_points(how, xyz);
      models += how == 0;
      subject_begin(&one, m, 1);
      const gmds_allocator allocator = failing_allocator(&one.from);
      gmds_delaunay_result_init(&result, &allocator);
      gmds_status status = GMDS_ERR_MEMORY;
      for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
        gmds_error error = {.status = GMDS_OK};
        const gmds_delaunay_options options = {.error = &error};
        one.from.until = n;
        status = m->do_delaunay(one.mesh, POINTS, xyz, &options, &result);
        one.from.until = LONG_MAX;
        if (status == GMDS_OK)
          break;
        attempts++;
        says_memory(&one, status, &error);
        is_empty(&one);
        ck_assert(!result.node_of && !result.chain && !result.points && !result.triangles);
      }
      ck_assert_int_eq(status, GMDS_OK);
      ck_assert_int_eq(result.dimension, how == 2 ? 2 : 3);
      gmds_error error = {.status = GMDS_OK};
      uint64_t sum = 0;
      if (m->do_check(one.mesh, &one.memory, &error) != GMDS_OK)
        subject_fail(&one, "%s", error.text);
      ck_assert_int_eq(m->do_checksum(one.mesh, &one.memory, &sum), GMDS_OK);
      first[how] = first[how] ? first[how] : sum;
      ck_assert_uint_eq(sum, first[how]);
      gmds_delaunay_result_clear(&result);
      subject_end(&one);
    }
  }
  printf("%zu models triangulate, %zu failures\n", models, attempts);
  ck_assert_uint_gt(models, 50);
}
END_TEST

/* ---- the cavity operator */

/* A tetrahedron, region 0, one more on each of its faces, and a node in it; attributes of all, and no room left. */
static void make_cavity(subject *s, const volume_model *m, gmds_cavity_wall walls[4])
{
  static const double xyz[9][3] = {{0, 0, 0},  {4, 0, 0},  {0, 4, 0},  {0, 0, 4}, {3, 3, 3},
                                   {1, 1, -2}, {-2, 1, 1}, {1, -2, 1}, {1, 1, 1}};
  static const gmds_id first[4] = {0, 1, 2, 3}, faces[4][3] = {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  gmds_id id = 0;
  subject_begin(s, m, 1);
  give_attributes(s);
  for (int i = 0; i < 9; i++)
    ck_assert_int_eq(m->do_add_node(s->mesh, xyz[i], &id), GMDS_OK);
  ck_assert_int_eq(m->do_add_region(s->mesh, GMDS_TETRAHEDRON, first, &id), GMDS_OK);
  for (gmds_id k = 0; k < 4; k++) {
    const gmds_id *f = faces[k], outer[4] = {f[0], f[1], f[2], 4 + k};
    ck_assert_int_eq(m->do_add_region(s->mesh, GMDS_TETRAHEDRON, outer, &id), GMDS_OK);
    walls[k] = (gmds_cavity_wall){{f[0], f[2], f[1]}, id, 3, {f[0], f[2], f[1]}}; /* face 3 is that of nodes 0, 1, 2 */
  }
  subject_trim(s);
}

START_TEST(a_star_without_memory_changes_nothing_or_leaves_a_valid_mesh)
{
  size_t kept = 0, lost = 0;
  uint64_t first = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    gmds_status status = m->do_star ? GMDS_ERR_MEMORY : GMDS_OK;
    for (long n = 0; status == GMDS_ERR_MEMORY; n++) {
      gmds_cavity_wall walls[4];
      gmds_id ids[5] = {0};
      gmds_error error = {.status = GMDS_OK};
      uint64_t sum = 0;
      make_cavity(&one, m, walls);
      const gmds_cells *cells = m->do_cells(one.mesh);
      const uint64_t before = subject_fingerprint(&one);
      one.from.until = n;
      status = m->do_star(one.mesh, 8, 1, 4, walls, ids);
      one.from.until = LONG_MAX;
      ck_assert(status == GMDS_OK || status == GMDS_ERR_MEMORY);
      const int same = subject_fingerprint(&one) == before;
      if (status != GMDS_OK && m->stars_or_nothing && !same)
        subject_fail(&one, "a star that fails at allocation %ld changes the mesh", n);
      kept += status != GMDS_OK && same;
      lost += status != GMDS_OK && !same;
      if (m->do_check(one.mesh, &one.memory, &error) != GMDS_OK)
        subject_fail(&one, "a star that ends at allocation %ld: %s", n, error.text);
      ck_assert_uint_eq(m->do_memory(one.mesh)->live, one.from.live);
      ck_assert_uint_eq(cells[0].count, 9);
      for (gmds_id r = 1; r < 5; r++)
        ck_assert(gmds_cells_has(&cells[3], r));
      if (status == GMDS_OK) {
        ck_assert_uint_eq(cells[3].count, 8);
        if (m->do_checksum)
          ck_assert_int_eq(m->do_checksum(one.mesh, &one.memory, &sum), GMDS_OK);
        first = first ? first : sum;
        ck_assert(!m->do_checksum || sum == first);
      }
      subject_end(&one);
    }
    ck_assert_int_eq(status, GMDS_OK);
  }
  printf("%zu stars that failed changed nothing, %zu left a part\n", kept, lost);
  ck_assert_uint_gt(kept, 50);
}
END_TEST

RUN_SUITE("failures of volumes", an_operation_without_memory_changes_nothing,
          a_query_without_memory_fails_and_the_next_is_right, a_check_and_a_checksum_without_memory_say_so,
          a_conversion_without_memory_leaves_the_mesh_empty, a_soup_without_memory_leaves_both_sides_as_they_were,
          a_triangulation_without_memory_leaves_the_mesh_empty,
          a_star_without_memory_changes_nothing_or_leaves_a_valid_mesh)
