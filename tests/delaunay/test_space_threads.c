/* Claims about insertion by several threads in space, as test_threads.c makes them in the plane: the tetrahedra are
 * those of one thread, whatever the input and the number of threads; the numbering depends on the number of threads
 * alone; what fails leaves the mesh empty. A thread sanitizer runs this program too. */
#include "harness.h"
#include <gmds/io.h>
#include <math.h>

#define GMDS_PREFIX tet
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS TETRAHEDRON
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
_Static_assert(GMDS_CONCURRENT_STARS, "the model under test lets several threads insert");
#include <gmds/end.h>

static gmds_soup points_of(const char *spec, gmds_memory *memory)
{
  gmds_soup soup;
  gmds_memory_init(memory, NULL);
  gmds_soup_init(&soup, memory, 3);
  ck_assert_int_eq(gmds_make_points(spec, 3, NULL, &soup), GMDS_OK);
  return soup;
}

/* Triangulates with so many threads; the mesh is valid and compact. The checksum; *numbering, if not NULL, receives a
 * checksum of the rows by their numbers. */
static uint64_t sum_with(const gmds_soup *s, int threads, uint64_t *numbering)
{
  tet_mesh m;
  gmds_memory memory;
  gmds_error error;
  uint64_t sum = 0, state = 0;
  const gmds_delaunay_options options = {.threads = threads};
  gmds_delaunay_result result = {.dimension = 0};
  gmds_memory_init(&memory, NULL);
  tet_mesh_init(&m, NULL);
  ck_assert_int_eq(tet_delaunay(&m, s->n_points, s->points, &options, &result), GMDS_OK);
  ck_assert_msg(tet_check(&m, &memory, &error) == GMDS_OK, "%s", error.text);
  ck_assert_int_eq(tet_checksum(&m, &memory, &sum), GMDS_OK);
  ck_assert_int_eq(result.dimension, 3);
  ck_assert_uint_eq(tet_end_3(&m), tet_count_3(&m));
  ck_assert_uint_eq(tet_count_0(&m), result.distinct);
  for (size_t i = 0; i < s->n_points; i++)
    for (size_t k = 0; k < 3; k++)
      ck_assert(tet_point(&m, result.node_of[i])[k] == s->points[3 * i + k]);
  for (gmds_id r = 0; numbering && r < tet_end_3(&m); r++) {
    gmds_id v[4];
    tet_tetrahedron_nodes(&m, r, v);
    for (int k = 0; k < 4; k++) {
      state ^= v[k];
      *numbering = random_bits(&state);
    }
  }
  gmds_delaunay_result_clear(&result);
  tet_mesh_clear(&m);
  return sum;
}

START_TEST(any_number_of_threads_gives_the_tetrahedra_of_one)
{
  const char *const specs[] = {"random:17000:1", "grid:24", "clusters:16000:3", "random:8192:2", "random:8191:2"};
  const int threads[] = {2, 3, 4, 8, 300};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
    gmds_memory memory;
    gmds_soup soup = points_of(specs[i], &memory);
    uint64_t sum = sum_with(&soup, 1, NULL);
    for (size_t k = 0; k < sizeof threads / sizeof *threads; k++)
      ck_assert_msg(sum_with(&soup, threads[k], NULL) == sum, "%s, %d threads", specs[i], threads[k]);
    gmds_soup_clear(&soup);
  }
}
END_TEST

/* CGAL's (tests/oracle/expected3.txt). */
START_TEST(any_number_of_threads_gives_the_tetrahedra_of_the_oracle)
{
  const char *const specs[] = {"random:50000:3", "grid:30"};
  const uint64_t sums[] = {0xe71ae898895be8ec, 0xeea5f8cbc1b0c6de};
  const int threads[] = {1, 2, 3, 4, 8};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
    gmds_memory memory;
    gmds_soup soup = points_of(specs[i], &memory);
    for (size_t k = 0; k < sizeof threads / sizeof *threads; k++)
      ck_assert_msg(sum_with(&soup, threads[k], NULL) == sums[i], "%s, %d threads", specs[i], threads[k]);
    gmds_soup_clear(&soup);
  }
}
END_TEST

/* What spans no volume, and too few points for more than one thread: all is as with one. */
START_TEST(flat_and_few_points_do_not_ask_for_threads)
{
  const char *const specs[] = {"random:9000:3", "grid:21"};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++)
    for (int dimension = 0; dimension < 3; dimension++) {
      gmds_memory memory;
      gmds_soup soup = points_of(specs[i], &memory);
      for (size_t k = 0; k < soup.n_points; k++)
        for (int x = dimension; x < 3; x++)
          soup.points[3 * k + (size_t)x] = dimension == 2 ? soup.points[3 * k] : 3;
      gmds_delaunay_result one = {.dimension = 7};
      for (int threads = 1; threads <= 8; threads++) {
        tet_mesh m;
        gmds_delaunay_result result = {.dimension = 7};
        const gmds_delaunay_options options = {.threads = threads};
        tet_mesh_init(&m, NULL);
        ck_assert_int_eq(tet_delaunay(&m, soup.n_points, soup.points, &options, threads == 1 ? &one : &result),
                         GMDS_OK);
        ck_assert_uint_eq(tet_count_3(&m), 0);
        ck_assert_uint_eq(tet_count_0(&m), one.distinct);
        ck_assert_int_eq(one.dimension, dimension);
        ck_assert(threads == 1 || (result.dimension == dimension && result.n_triangles == one.n_triangles &&
                                   memcmp(result.node_of, one.node_of, soup.n_points * sizeof *one.node_of) == 0));
        for (size_t k = 0; threads > 1 && k < 3 * one.n_triangles; k++)
          ck_assert_uint_eq(result.triangles[k], one.triangles[k]);
        for (size_t k = 0; threads > 1 && dimension == 1 && k < one.distinct; k++)
          ck_assert_uint_eq(result.chain[k], one.chain[k]);
        gmds_delaunay_result_clear(&result);
        tet_mesh_clear(&m);
      }
      gmds_delaunay_result_clear(&one);
      gmds_soup_clear(&soup);
    }
  for (size_t n = 0; n < 12; n++) {
    gmds_memory memory;
    gmds_soup soup = points_of("random:12:1", &memory);
    for (int threads = 1; threads <= 8; threads++) {
      tet_mesh m;
      gmds_delaunay_result result = {.dimension = 7};
      const gmds_delaunay_options options = {.threads = threads};
      tet_mesh_init(&m, NULL);
      ck_assert_int_eq(tet_delaunay(&m, n, soup.points, &options, &result), GMDS_OK);
      ck_assert_int_eq(result.dimension, n < 4 ? (int)n - 1 : 3);
      ck_assert_uint_eq(tet_count_0(&m), n);
      ck_assert((n < 4) == (tet_count_3(&m) == 0));
      gmds_delaunay_result_clear(&result);
      tet_mesh_clear(&m);
    }
    gmds_soup_clear(&soup);
  }
}
END_TEST

/* What is hard for slabs, or for the room that threads take in advance. */
static void distort(int kind, size_t n, size_t i, double *p, const double *first)
{
  const double angle = 0x1p-4 * (double)i, length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  switch (kind) {
  case 0: /* nearly all in one plane, where every slab across it begins or ends */
    if (i % 500)
      p[0] = 0.5;
    break;
  case 1: /* few distinct abscissas and ordinates */
    p[0] = floor(4 * p[0]);
    p[1] = floor(4 * p[1]);
    break;
  case 2: /* every point twice */
    if (i >= n / 2)
      memcpy(p, first + 3 * (i - n / 2), 3 * sizeof *p);
    break;
  case 3: /* two far clusters */
    p[0] = p[0] * 0x1p-20 + (i % 2 ? 1e6 : 0);
    break;
  case 4: /* about a sphere: nearly one cavity for all, and the ghost in every second one */
    for (int k = 0; k < 3; k++)
      p[k] = p[k] / length;
    break;
  case 5: /* on a helix: boundaries of many nodes */
    p[0] = cos(angle);
    p[1] = sin(angle);
    p[2] = 0x1p-8 * angle;
    break;
  default: /* two lines that do not meet: nearly every pair of points of both is joined, more regions than were taken */
    p[0] = i % 300 ? p[0] : 0;
    p[1] = i % 300 ? 0 : 1 + p[1];
    p[2] = i % 300 ? 0 : 1;
  }
}

START_TEST(points_that_slabs_do_not_divide_are_inserted_too)
{
  enum { KINDS = 7 };
  for (int kind = 0; kind < KINDS; kind++) {
    gmds_memory memory;
    gmds_soup soup = points_of("random:9000:9", &memory);
    for (size_t i = 0; i < soup.n_points; i++)
      distort(kind, soup.n_points, i, soup.points + 3 * i, soup.points);
    const uint64_t sum = sum_with(&soup, 1, NULL);
    for (int threads = 2; threads <= 4; threads++)
      ck_assert_msg(sum_with(&soup, threads, NULL) == sum, "kind %d, %d threads", kind, threads);
    gmds_soup_clear(&soup);
  }
}
END_TEST

/* Points that one thread must put off in a row do not make the walks longer: nearly all points in one plane, which is
 * where the slabs are cut. */
START_TEST(points_that_are_put_off_do_not_make_the_walks_longer)
{
  gmds_memory memory;
  gmds_soup soup = points_of("random:20000:8", &memory);
  for (size_t i = 0; i < soup.n_points; i++)
    if (i % 1000)
      soup.points[3 * i] = 0.5;
  for (int threads = 1; threads <= 4; threads *= 2) {
    tet_mesh m;
    gmds_delaunay_result result = {.dimension = 0};
    const gmds_delaunay_options options = {.threads = threads};
    tet_mesh_init(&m, NULL);
    ck_assert_int_eq(tet_delaunay(&m, soup.n_points, soup.points, &options, &result), GMDS_OK);
    ck_assert_uint_gt(result.steps, soup.n_points);
    ck_assert_msg(result.steps < 50 * soup.n_points, "%d threads: %zu steps", threads, result.steps);
    gmds_delaunay_result_clear(&result);
    tet_mesh_clear(&m);
  }
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(the_numbering_depends_on_the_number_of_threads_alone)
{
  gmds_memory memory;
  gmds_soup soup = points_of("random:20000:4", &memory);
  for (int threads = 1; threads <= 3; threads++) {
    uint64_t first = 0;
    sum_with(&soup, threads, &first);
    for (int again = 0; again < 3; again++) {
      uint64_t numbering = 0;
      sum_with(&soup, threads, &numbering);
      ck_assert_uint_eq(numbering, first);
    }
  }
  gmds_soup_clear(&soup);
}
END_TEST

typedef struct patience {
  long calls, until;
  size_t done;
} patience;

static int give_up(void *user, size_t done, size_t total)
{
  patience *p = user;
  ck_assert_uint_le(done, total);
  ck_assert_uint_ge(done, p->done); /* never goes back */
  p->done = done;
  return ++p->calls >= p->until;
}

START_TEST(cancelling_at_any_call_leaves_the_mesh_empty)
{
  gmds_memory memory;
  gmds_soup soup = points_of("random:20000:5", &memory);
  int cancelled = 0;
  for (long until = 1, done = 0; !done; until++) {
    patience p = {0, until, 0};
    tet_mesh m;
    const gmds_delaunay_options options = {.progress = give_up, .user = &p, .threads = 2};
    tet_mesh_init(&m, NULL);
    gmds_status status = tet_delaunay(&m, soup.n_points, soup.points, &options, NULL);
    done = status == GMDS_OK;
    cancelled += !done;
    ck_assert(done || (status == GMDS_ERR_CANCELLED && !tet_count_0(&m) && !tet_count_3(&m)));
    tet_mesh_clear(&m);
    ck_assert_uint_eq(m.memory.live, 0);
  }
  ck_assert_int_gt(cancelled, 2);
  gmds_soup_clear(&soup);
}
END_TEST

/* Whatever the points, progress is called for each few thousand of them, and by the end for nearly all. */
START_TEST(progress_is_told_to_the_end)
{
  const char *const specs[] = {"random:20000:5", "clusters:20000:1", "grid:25", "random:16383:1"};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++)
    for (int threads = 2; threads <= 3; threads++) {
      gmds_memory memory;
      gmds_soup soup = points_of(specs[i], &memory);
      for (size_t k = 0; i == 2 && k < soup.n_points; k++)
        soup.points[3 * k] = k % 2 ? 1 : 0; /* two planes: nearly all points are put off */
      patience p = {0, 1000000, 0};
      tet_mesh m;
      gmds_delaunay_result result = {.dimension = 0};
      const gmds_delaunay_options options = {.progress = give_up, .user = &p, .threads = threads};
      tet_mesh_init(&m, NULL);
      ck_assert_int_eq(tet_delaunay(&m, soup.n_points, soup.points, &options, &result), GMDS_OK);
      ck_assert_msg((size_t)p.calls >= result.distinct / 8192, "%s: %ld calls", specs[i], p.calls);
      ck_assert_msg(p.done + 4 * 4096 > result.distinct, "%s: %zu of %zu", specs[i], p.done, result.distinct);
      gmds_delaunay_result_clear(&result);
      tet_mesh_clear(&m);
      gmds_soup_clear(&soup);
    }
}
END_TEST

START_TEST(every_failing_allocation_leaves_the_mesh_empty)
{
  gmds_memory memory;
  gmds_soup soup = points_of("random:9000:6", &memory);
  const gmds_delaunay_options options = {.threads = 2};
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    tet_mesh m;
    tet_mesh_init(&m, &allocator);
    gmds_status status = tet_delaunay(&m, soup.n_points, soup.points, &options, NULL);
    done = status == GMDS_OK;
    ck_assert(done || (status == GMDS_ERR_MEMORY && !tet_count_0(&m) && !tet_count_3(&m)));
    ck_assert_int_lt(k, 1000);
    tet_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
  gmds_soup_clear(&soup);
}
END_TEST

/* Regions taken and given back leave the mesh as it was; no more are taken than there is room for. */
START_TEST(regions_that_were_taken_can_be_given_back)
{
  tet_mesh m;
  gmds_memory memory;
  gmds_error error;
  gmds_attribute *colour = NULL;
  gmds_id first = 7, v[4], r = 0;
  const double xyz[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  gmds_memory_init(&memory, NULL);
  tet_mesh_init(&m, NULL);
  ck_assert_int_eq(tet_add_attribute(&m, 3, "colour", GMDS_INT, 1, &colour), GMDS_OK);
  ck_assert_uint_eq(tet_take_regions(&m, 5, &first), 0);
  for (int k = 0; k < 4; k++)
    ck_assert_int_eq(tet_add_node(&m, xyz[k], &v[k]), GMDS_OK);
  ck_assert_int_eq(tet_add_tetrahedron(&m, v[0], v[1], v[2], v[3], &r), GMDS_OK);
  ck_assert_int_eq(tet_reserve(&m, 4, 0, 0, 101), GMDS_OK);
  ck_assert_uint_eq(tet_take_regions(&m, 60, &first), 60);
  ck_assert_uint_eq(first, 1);
  ck_assert_uint_eq(tet_take_regions(&m, SIZE_MAX, &first), 40);
  ck_assert_uint_eq(first, 61);
  ck_assert_uint_eq(tet_count_3(&m), 101);
  for (gmds_id g = 1; g < 101; g++)
    ck_assert_int_eq(((int *)colour->data)[g], 0);
  tet_drop_regions(&m, 1, 60);
  tet_drop_regions(&m, 61, 40);
  ck_assert_uint_eq(tet_count_3(&m), 1);
  ck_assert_uint_eq(tet_end_3(&m), 1);
  ck_assert_msg(tet_check(&m, &memory, &error) == GMDS_OK, "%s", error.text);
  tet_mesh_clear(&m);
}
END_TEST

RUN_SUITE("threads in space", any_number_of_threads_gives_the_tetrahedra_of_one,
          any_number_of_threads_gives_the_tetrahedra_of_the_oracle, flat_and_few_points_do_not_ask_for_threads,
          points_that_slabs_do_not_divide_are_inserted_too, the_numbering_depends_on_the_number_of_threads_alone,
          points_that_are_put_off_do_not_make_the_walks_longer, cancelling_at_any_call_leaves_the_mesh_empty,
          progress_is_told_to_the_end, every_failing_allocation_leaves_the_mesh_empty,
          regions_that_were_taken_can_be_given_back)
