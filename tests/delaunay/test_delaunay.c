/* Claims about Delaunay triangulations, in models that take different paths: whatever the input, the result is the
 * Delaunay triangulation (every triangle's circle is empty, by exact predicates, and the triangles fill the hull), it
 * is the same in every model and for every order of the points, and bad input changes nothing. */
#include "harness.h"
#include "models.h"
#include <gmds/io.h>
#include <math.h>

typedef struct outcome {
  gmds_status status;
  uint64_t sum;
  size_t nodes, edges, faces;
  gmds_delaunay_result result;
} outcome;

#define RUN best
#include "body.h"
#define RUN any
#include "body.h"
#define RUN nodal
#include "body.h"
#define RUN edged
#include "body.h"
#define RUN poor
#include "body.h"
#define RUN loose
#include "body.h"
#define RUN whole
#include "body.h"

typedef gmds_status (*runner)(size_t n, const double *xy, const gmds_delaunay_options *options, outcome *o,
                              gmds_soup *soup);
#define RUNNER(prefix) prefix##_run,
static const runner runners[] = {TESTED_MODELS(RUNNER)};
enum { MODELS = sizeof runners / sizeof *runners };

/* Every triangle turns left, as `best` keeps it, and its circle holds no point; the count is Euler's; every node
 * occurs. O(triangles × points). */
static void verify_soup(const gmds_soup *s, size_t hull)
{
  ck_assert_uint_eq(s->n_cells, 2 * s->n_points - 2 - hull);
  for (size_t c = 0; c < s->n_cells; c++) {
    const gmds_id *v = s->corners + 3 * c;
    const double *a = s->points + 2 * v[0], *b = s->points + 2 * v[1], *d = s->points + 2 * v[2];
    ck_assert_int_gt(gmds_orient2d(a, b, d), 0);
    for (size_t p = 0; p < s->n_points; p++)
      if (p != v[0] && p != v[1] && p != v[2]) {
        ck_assert_int_lt(gmds_incircle_perturbed(a, b, d, s->points + 2 * p), 0);
      }
  }
}

/* Points on the boundary of the convex hull, those inside its sides included: p is one when a line through it and
 * another point has no point strictly on its right. */
static size_t hull_size(const gmds_soup *s)
{
  size_t on_hull = 0;
  for (size_t p = 0; p < s->n_points; p++) {
    const double *x = s->points + 2 * p;
    int found = 0;
    for (size_t e = 0; e < s->n_points && !found; e++) {
      int holds = e != p;
      for (size_t q = 0; q < s->n_points && holds; q++)
        holds = gmds_orient2d(x, s->points + 2 * e, s->points + 2 * q) >= 0;
      found = holds;
    }
    on_hull += (size_t)found;
  }
  return on_hull;
}

/* Runs every model: all agree, and the first one's triangles are Delaunay. Returns the checksum. */
static uint64_t triangulate_everywhere(size_t n, const double *xy)
{
  uint64_t sum = 0;
  for (int k = 0; k < MODELS; k++) {
    outcome o;
    gmds_memory memory;
    gmds_soup soup;
    gmds_memory_init(&memory, NULL);
    gmds_soup_init(&soup, &memory, 2);
    ck_assert_int_eq(runners[k](n, xy, NULL, &o, k == 0 ? &soup : NULL), GMDS_OK);
    if (k == 0) {
      sum = o.sum;
      if (o.result.dimension == 2)
        verify_soup(&soup, hull_size(&soup));
    }
    ck_assert_uint_eq(o.sum, sum);
    ck_assert_uint_eq(o.nodes, o.result.distinct);
    if (o.edges)
      ck_assert_uint_eq(o.edges, o.nodes + o.faces - 1);
    gmds_soup_clear(&soup);
    gmds_delaunay_result_clear(&o.result);
    ck_assert_uint_eq(memory.live, 0);
  }
  return sum;
}

static void from_spec(const char *spec)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(gmds_make_points(spec, 2, NULL, &soup), GMDS_OK);
  triangulate_everywhere(soup.n_points, soup.points);
  gmds_soup_clear(&soup);
}

START_TEST(made_up_points_give_their_delaunay_triangulation)
{
  from_spec("random:200:1");
  from_spec("clusters:150:2");
  from_spec("grid:11");
  from_spec("grid:40"); /* large enough for rounds: points on sides of the hull that exist already */
  from_spec("circle:60");
}
END_TEST

START_TEST(every_order_of_up_to_six_points_gives_the_same_triangles)
{
  static const double sets[][12] = {{0, 0, 1, 0, 1, 1, 0, 1, 2, 0, 2, 1},    /* two squares */
                                    {0, 0, 1, 0, 2, 0, 3, 0, 1, 5, 1, -5},   /* a row and two apexes */
                                    {-5, 0, 5, 0, 0, 5, 0, -5, 3, 4, -3, 4}, /* cocircular */
                                    {0, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0.5}};
  for (size_t s = 0; s < 4; s++)
    for (size_t n = 3; n <= 6; n++) {
      size_t order[6] = {0, 1, 2, 3, 4, 5}, count[6] = {0};
      double xy[12];
      uint64_t first = triangulate_everywhere(n, sets[s]);
      for (size_t i = 1; i < n;) /* Heap's algorithm */
        if (count[i] < i) {
          size_t j = i % 2 ? count[i] : 0, swap = order[j];
          order[j] = order[i];
          order[i] = swap;
          for (size_t k = 0; k < n; k++)
            memcpy(xy + 2 * k, sets[s] + 2 * order[k], 2 * sizeof *xy);
          outcome o;
          ck_assert_int_eq(best_run(n, xy, NULL, &o, NULL), GMDS_OK);
          ck_assert_uint_eq(o.sum, first);
          gmds_delaunay_result_clear(&o.result);
          count[i]++;
          i = 1;
        } else
          count[i++] = 0;
    }
}
END_TEST

START_TEST(few_points_and_points_on_a_line_give_their_dimension_and_chain)
{
  const double none[2] = {0, 0}, one[2] = {3, 4}, two[4] = {2, 1, 1, 1};
  outcome o;
  for (int k = 0; k < MODELS; k++) {
    ck_assert_int_eq(runners[k](0, none, NULL, &o, NULL), GMDS_OK);
    ck_assert_int_eq(o.result.dimension, -1);
    ck_assert_int_eq(runners[k](1, one, NULL, &o, NULL), GMDS_OK);
    ck_assert_int_eq(o.result.dimension, 0);
    ck_assert_uint_eq(o.result.chain[0], 0);
    gmds_delaunay_result_clear(&o.result);
    ck_assert_int_eq(runners[k](2, two, NULL, &o, NULL), GMDS_OK);
    ck_assert_int_eq(o.result.dimension, 1);
    ck_assert_uint_eq(o.result.chain[0], o.result.node_of[1]);
    ck_assert_uint_eq(o.result.chain[1], o.result.node_of[0]);
    gmds_delaunay_result_clear(&o.result);
    double line[200];
    for (int i = 0; i < 100; i++) { /* 100 points of a line, shuffled, some twice */
      line[2 * i] = (i * 37) % 90;
      line[2 * i + 1] = 3 * line[2 * i] + 1;
    }
    ck_assert_int_eq(runners[k](100, line, NULL, &o, NULL), GMDS_OK);
    ck_assert_int_eq(o.result.dimension, 1);
    ck_assert_uint_eq(o.result.distinct, 90);
    ck_assert_uint_eq(o.faces, 0);
    for (size_t i = 0; i < 100; i++)
      ck_assert_uint_eq(o.result.chain[(size_t)line[2 * i]], o.result.node_of[i]);
    gmds_delaunay_result_clear(&o.result);
  }
}
END_TEST

START_TEST(equal_points_share_a_node_and_minus_zero_is_zero)
{
  const double xy[] = {0.0, 0.0, -0.0, 0.0, 1, 0, 0, 1, 1, 0, 0.0, -0.0, 1, 1, 0, 1};
  static const size_t same[] = {0, 0, 2, 3, 2, 0, 6, 3};
  for (int k = 0; k < MODELS; k++) {
    outcome o;
    ck_assert_int_eq(runners[k](8, xy, NULL, &o, NULL), GMDS_OK);
    ck_assert_uint_eq(o.result.distinct, 4);
    for (size_t i = 0; i < 8; i++)
      ck_assert_uint_eq(o.result.node_of[i], o.result.node_of[same[i]]);
    for (size_t i = 0; i < 8; i++)
      for (size_t j = 0; j < 8; j++)
        ck_assert_int_eq(same[i] == same[j], o.result.node_of[i] == o.result.node_of[j]);
    gmds_delaunay_result_clear(&o.result);
  }
  triangulate_everywhere(8, xy);
}
END_TEST

START_TEST(a_result_may_be_zero_initialised)
{
  const double xy[] = {0, 0, 1, 0, 0, 1};
  best_mesh m;
  gmds_delaunay_result result = {0};
  ck_assert_int_eq(best_mesh_init(&m, NULL), GMDS_OK);
  ck_assert_int_eq(best_delaunay(&m, 3, xy, NULL, &result), GMDS_OK);
  ck_assert_int_eq(result.dimension, 2);
  gmds_delaunay_result_clear(&result);
  best_mesh_clear(&m);
  gmds_delaunay_result untouched = {0};
  gmds_delaunay_result_clear(&untouched);
}
END_TEST

START_TEST(a_node_never_has_minus_zero)
{
  const double xy[] = {-0.0, -0.0, 1, -0.0, -0.0, 1};
  gmds_memory memory;
  gmds_soup soup;
  outcome o;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(best_run(3, xy, NULL, &o, &soup), GMDS_OK);
  for (size_t k = 0; k < 6; k++)
    ck_assert(!signbit(soup.points[k]));
  gmds_soup_clear(&soup);
  gmds_delaunay_result_clear(&o.result);
}
END_TEST

START_TEST(extreme_coordinates_are_exact)
{
  const double huge[] = {1e300, 1e300, -1e300, 1e300, 1e300, -1e300, -1e300, -1e300, 0, 0, 1e299, 5, 1e-300, 1e-300};
  const double tiny[] = {5e-324, 0, 0, 5e-324, 5e-324, 5e-324, 0, 0, 1e-323, 1e-323, 1.5e-323, 0};
  const double mixed[] = {0, 0, 1e-300, 1e-300, 1, 1, 1e300, 0, 0, 1e300, 1e-10, 1e10, -1e300, -1, 3, -1e-200};
  const double top[] = {1.7976931348623157e308,
                        1.7976931348623157e308,
                        -1.7976931348623157e308,
                        1.7976931348623157e308,
                        -1.7976931348623157e308,
                        -1.7976931348623157e308,
                        1.7976931348623157e308,
                        -1.7976931348623157e308,
                        0,
                        0};
  triangulate_everywhere(7, huge);
  triangulate_everywhere(6, tiny);
  triangulate_everywhere(8, mixed);
  triangulate_everywhere(5, top);
}
END_TEST

/* The triangles as indices of input points, summed without order. */
static uint64_t combinatorics(size_t n, const double *xy)
{
  outcome o;
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(best_run(n, xy, NULL, &o, &soup), GMDS_OK);
  gmds_id *point_of = calloc(o.nodes, sizeof *point_of);
  for (size_t i = n; i-- > 0;)
    point_of[o.result.node_of[i]] = (gmds_id)i;
  uint64_t sum = 0;
  for (size_t c = 0; c < soup.n_cells; c++) {
    uint64_t h = 1, v[3];
    for (int k = 0; k < 3; k++)
      v[k] = point_of[soup.corners[3 * c + (size_t)k]];
    uint64_t low = v[0] < v[1] ? v[0] : v[1], high = v[0] < v[1] ? v[1] : v[0];
    low = low < v[2] ? low : v[2];
    high = high > v[2] ? high : v[2];
    uint64_t state = low * 1000003 + (v[0] + v[1] + v[2] - low - high) * 1009 + high;
    h = random_bits(&state);
    sum += h;
  }
  free(point_of);
  gmds_soup_clear(&soup);
  gmds_delaunay_result_clear(&o.result);
  return sum;
}

START_TEST(scaling_by_powers_of_two_and_exact_translation_change_nothing)
{
  uint64_t seed = 7;
  double xy[200], moved[200];
  for (int round = 0; round < 6; round++) {
    for (int i = 0; i < 200; i++) /* a coarse lattice: many ties */
      xy[i] = (double)random_below(&seed, 16);
    uint64_t expected = combinatorics(100, xy);
    static const double factors[] = {0x1p-1060, 0x1p-500, 0x1p-3, 0x1p40, 0x1p1000};
    for (int f = 0; f < 5; f++) {
      for (int i = 0; i < 200; i++)
        moved[i] = xy[i] * factors[f];
      ck_assert_uint_eq(combinatorics(100, moved), expected);
    }
    for (int i = 0; i < 200; i++)
      moved[i] = xy[i] + (i % 2 ? 0x1p40 : -0x1p45);
    ck_assert_uint_eq(combinatorics(100, moved), expected);
  }
}
END_TEST

START_TEST(nan_and_infinity_are_named_and_leave_the_mesh_empty)
{
  for (int k = 0; k < MODELS; k++)
    for (int bad = 0; bad < 2; bad++) {
      double xy[] = {0, 0, 1, 0, 0, 1, 1, 1};
      xy[5] = bad ? INFINITY : NAN;
      gmds_error error;
      const gmds_delaunay_options options = {.error = &error};
      outcome o;
      ck_assert_int_eq(runners[k](4, xy, &options, &o, NULL), GMDS_ERR_COORDINATE);
      ck_assert_int_eq(error.cell, 2);
      ck_assert_ptr_nonnull(strstr(error.text, "2"));
      ck_assert_uint_eq(o.nodes + o.faces, 0);
      ck_assert_ptr_null(o.result.node_of);
    }
}
END_TEST

static int cancel_at_once(void *user, size_t done, size_t total)
{
  *(size_t *)user = done;
  return done < total;
}

START_TEST(a_cancelled_triangulation_leaves_the_mesh_empty)
{
  gmds_memory memory;
  gmds_soup soup;
  size_t seen = 0;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(gmds_make_points("random:9000:3", 2, NULL, &soup), GMDS_OK);
  const gmds_delaunay_options options = {.progress = cancel_at_once, .user = &seen};
  outcome o;
  ck_assert_int_eq(best_run(soup.n_points, soup.points, &options, &o, NULL), GMDS_ERR_CANCELLED);
  ck_assert_uint_gt(seen, 0);
  ck_assert_uint_eq(o.nodes + o.faces, 0);
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(a_mesh_that_is_not_empty_is_refused_unchanged)
{
  best_mesh m;
  gmds_id v = 0;
  const double xy[] = {0, 0, 1, 0, 0, 1};
  best_mesh_init(&m, NULL);
  ck_assert_int_eq(best_add_node(&m, xy, &v), GMDS_OK);
  ck_assert_int_eq(best_delaunay(&m, 3, xy, NULL, NULL), GMDS_ERR_ARGUMENT);
  ck_assert_uint_eq(best_count_0(&m), 1);
  best_mesh_clear(&m);
}
END_TEST

/* Fails the k-th allocation for every k: an error each time, the mesh empty, nothing leaked. */
START_TEST(every_failing_allocation_leaves_the_mesh_empty)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(gmds_make_points("random:60:5", 2, NULL, &soup), GMDS_OK);
#define FAIL_EACH(prefix)                                                                             \
  for (long k = 0, done = 0; !done; k++) {                                                            \
    failing f = {.until = k};                                                                         \
    gmds_allocator allocator = failing_allocator(&f);                                                 \
    prefix##_mesh m;                                                                                  \
    prefix##_mesh_init(&m, &allocator);                                                               \
    gmds_status status = prefix##_delaunay(&m, soup.n_points, soup.points, NULL, NULL);               \
    done = status == GMDS_OK;                                                                         \
    ck_assert(done || (status == GMDS_ERR_MEMORY && !prefix##_count_0(&m) && !prefix##_count_2(&m))); \
    ck_assert_int_lt(k, 20000);                                                                       \
    prefix##_mesh_clear(&m);                                                                          \
    ck_assert_uint_eq(f.live, 0);                                                                     \
  }
  TESTED_MODELS(FAIL_EACH)
#undef FAIL_EACH
  gmds_soup_clear(&soup);
}
END_TEST

/* One triangle whose sides have nothing beyond them, and the star of a node in it: with every allocation failing in
 * turn nothing has changed; then there are three triangles and every relation holds. */
START_TEST(a_star_that_fails_changes_nothing)
{
  static const double xy[4][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 1}};
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
#define STAR_EACH(prefix)                                                             \
  for (long k = 0, done = 0; !done; k++) {                                            \
    failing f = {.until = 1000};                                                      \
    gmds_allocator allocator = failing_allocator(&f);                                 \
    gmds_error error = {.text = ""};                                                  \
    gmds_id v[4], face = 0, ids[3] = {7, 7, 7};                                       \
    prefix##_mesh m;                                                                  \
    ck_assert_int_eq(prefix##_mesh_init(&m, &allocator), GMDS_OK);                    \
    for (int i = 0; i < 4; i++)                                                       \
      ck_assert_int_eq(prefix##_add_node(&m, xy[i], &v[i]), GMDS_OK);                 \
    ck_assert_int_eq(prefix##_add_triangle(&m, v[0], v[1], v[2], &face), GMDS_OK);    \
    ck_assert_int_eq(prefix##_trim(&m), GMDS_OK);                                     \
    const gmds_cavity_face cavity = {face, {v[0], v[1], v[2]}, 0};                    \
    gmds_cavity_side sides[3];                                                        \
    for (unsigned i = 0; i < 3; i++)                                                  \
      sides[i] = (gmds_cavity_side){v[i], v[(i + 1) % 3], GMDS_NONE, 0, 0, i};        \
    f.until = k;                                                                      \
    gmds_status status = prefix##_star(&m, v[3], 1, &cavity, 3, sides, ids);          \
    done = status == GMDS_OK;                                                         \
    ck_assert(done || status == GMDS_ERR_MEMORY);                                     \
    ck_assert(done || (ids[0] == 7 && ids[1] == 7 && ids[2] == 7));                   \
    ck_assert_uint_eq(prefix##_count_2(&m), done ? 3 : 1);                            \
    ck_assert(prefix##_count_1(&m) == 0 || prefix##_count_1(&m) == (done ? 6u : 3u)); \
    ck_assert_msg(prefix##_check(&m, &memory, &error) == GMDS_OK, "%s", error.text);  \
    ck_assert_int_lt(k, 100);                                                         \
    f.until = 1000;                                                                   \
    prefix##_mesh_clear(&m);                                                          \
    ck_assert_uint_eq(f.live, 0);                                                     \
  }
  TESTED_MODELS(STAR_EACH)
#undef STAR_EACH
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(too_many_cells_are_refused)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  ck_assert_int_eq(gmds_make_points("random:60:5", 2, NULL, &soup), GMDS_OK);
  for (int i = 0; i < 3; i++) {
    whole_mesh m;
    whole_mesh_init(&m, NULL);
    m.cells[i].limit = 40;
    ck_assert_int_eq(whole_delaunay(&m, soup.n_points, soup.points, NULL, NULL), GMDS_ERR_TOO_MANY);
    ck_assert_uint_eq(whole_count_0(&m) + whole_count_1(&m) + whole_count_2(&m), 0);
    whole_mesh_clear(&m);
  }
  gmds_soup_clear(&soup);
}
END_TEST

RUN_SUITE("delaunay", made_up_points_give_their_delaunay_triangulation,
          every_order_of_up_to_six_points_gives_the_same_triangles,
          few_points_and_points_on_a_line_give_their_dimension_and_chain,
          equal_points_share_a_node_and_minus_zero_is_zero, a_result_may_be_zero_initialised,
          a_node_never_has_minus_zero, extreme_coordinates_are_exact,
          scaling_by_powers_of_two_and_exact_translation_change_nothing,
          nan_and_infinity_are_named_and_leave_the_mesh_empty, a_cancelled_triangulation_leaves_the_mesh_empty,
          a_mesh_that_is_not_empty_is_refused_unchanged, every_failing_allocation_leaves_the_mesh_empty,
          a_star_that_fails_changes_nothing, too_many_cells_are_refused)
