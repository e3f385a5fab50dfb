/* Claims about insertion by several threads: the triangles are those of one thread, whatever the input and the number
 * of threads; the numbering depends on the number of threads alone; what fails leaves the mesh empty. A thread
 * sanitizer runs this program too. */
#include "harness.h"
#include <gmds/io.h>

#define GMDS_PREFIX tri
#define GMDS_MODEL (N | F | F2N | F2F)
#define GMDS_FACES TRIANGLE
#include <gmds/mesh.h>
#include <gmds/algorithms/delaunay.h>
_Static_assert(GMDS_CONCURRENT_STARS, "the model under test lets several threads insert");
#include <gmds/end.h>

static gmds_soup points_of(const char *spec, gmds_memory *memory)
{
  gmds_soup soup;
  gmds_memory_init(memory, NULL);
  gmds_soup_init(&soup, memory, 2);
  ck_assert_int_eq(gmds_make_points(spec, 2, NULL, &soup), GMDS_OK);
  return soup;
}

/* Triangulates with so many threads; the mesh is valid and compact. The checksum; *numbering, if not NULL, receives a
 * checksum of the rows by their numbers. */
static uint64_t sum_with(const gmds_soup *s, int threads, uint64_t *numbering)
{
  tri_mesh m;
  gmds_memory memory;
  gmds_error error;
  uint64_t sum = 0, state = 0;
  const gmds_delaunay_options options = {.threads = threads};
  gmds_delaunay_result result = {.dimension = 0};
  gmds_memory_init(&memory, NULL);
  tri_mesh_init(&m, NULL);
  ck_assert_int_eq(tri_delaunay(&m, s->n_points, s->points, &options, &result), GMDS_OK);
  ck_assert_msg(tri_check(&m, &memory, &error) == GMDS_OK, "%s", error.text);
  ck_assert_int_eq(tri_checksum(&m, &memory, &sum), GMDS_OK);
  ck_assert_uint_eq(tri_end_2(&m), tri_count_2(&m));
  ck_assert_uint_eq(tri_count_0(&m), result.distinct);
  for (size_t i = 0; i < s->n_points; i++)
    ck_assert(tri_point(&m, result.node_of[i])[0] == s->points[2 * i] &&
              tri_point(&m, result.node_of[i])[1] == s->points[2 * i + 1]);
  for (gmds_id f = 0; numbering && f < tri_end_2(&m); f++) {
    gmds_id v[3];
    tri_triangle_nodes(&m, f, v);
    for (int k = 0; k < 3; k++) {
      state ^= v[k];
      *numbering = random_bits(&state);
    }
  }
  gmds_delaunay_result_clear(&result);
  tri_mesh_clear(&m);
  return sum;
}

START_TEST(any_number_of_threads_gives_the_triangles_of_one)
{
  const char *const specs[] = {"random:20000:1", "grid:120",      "clusters:20000:3", "circle:10000",
                               "random:8192:2",  "random:8191:2", "grid:91"};
  const int threads[] = {2, 3, 300};
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

/* Strips that cut nothing off: all abscissas equal but for a few points; few distinct abscissas; every point given
 * twice; two far clusters. */
START_TEST(points_that_strips_do_not_divide_are_inserted_too)
{
  enum { MANY = 20000 };
  gmds_memory memory;
  for (int kind = 0; kind < 4; kind++) {
    gmds_soup soup = points_of("random:20000:9", &memory);
    for (size_t i = 0; i < MANY; i++) {
      double *p = soup.points + 2 * i;
      if (kind == 0 && i % 1000)
        p[0] = 0.5;
      else if (kind == 1)
        p[0] = (double)(int)(4 * p[0]);
      else if (kind == 2)
        memcpy(p, soup.points + i % (MANY / 2) * 2, 2 * sizeof *p);
      else if (kind == 3)
        p[0] = p[0] * 0x1p-20 + (i % 2 ? 1e6 : 0);
    }
    uint64_t sum = sum_with(&soup, 1, NULL);
    ck_assert_uint_eq(sum_with(&soup, 2, NULL), sum);
    ck_assert_uint_eq(sum_with(&soup, 4, NULL), sum);
    gmds_soup_clear(&soup);
  }
}
END_TEST

/* Points that one thread must put off in a row do not make the walks longer: nearly all points on one line, which is
 * where the strips are cut. A walk that began where the last insertion was would go through thousands of triangles. */
START_TEST(points_that_are_put_off_do_not_make_the_walks_longer)
{
  gmds_memory memory;
  gmds_soup soup = points_of("random:40000:8", &memory);
  for (size_t i = 0; i < soup.n_points; i++)
    if (i % 1000)
      soup.points[2 * i] = 0.5;
  for (int threads = 1; threads <= 4; threads *= 2) {
    tri_mesh m;
    gmds_delaunay_result result = {.dimension = 0};
    const gmds_delaunay_options options = {.threads = threads};
    tri_mesh_init(&m, NULL);
    ck_assert_int_eq(tri_delaunay(&m, soup.n_points, soup.points, &options, &result), GMDS_OK);
    ck_assert_uint_gt(result.steps, soup.n_points);
    ck_assert_msg(result.steps < 50 * soup.n_points, "%d threads: %zu steps", threads, result.steps);
    gmds_delaunay_result_clear(&result);
    tri_mesh_clear(&m);
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
    tri_mesh m;
    const gmds_delaunay_options options = {.progress = give_up, .user = &p, .threads = 2};
    tri_mesh_init(&m, NULL);
    gmds_status status = tri_delaunay(&m, soup.n_points, soup.points, &options, NULL);
    done = status == GMDS_OK;
    cancelled += !done;
    ck_assert(done || (status == GMDS_ERR_CANCELLED && !tri_count_0(&m) && !tri_count_2(&m)));
    tri_mesh_clear(&m);
    ck_assert_uint_eq(m.memory.live, 0);
  }
  ck_assert_int_gt(cancelled, 2);
  gmds_soup_clear(&soup);
}
END_TEST

/* Whatever the points, progress is called for each few thousand of them, and by the end for nearly all. */
START_TEST(progress_is_told_to_the_end)
{
  const char *const specs[] = {"random:40000:5", "circle:40000", "grid:200", "random:16383:1"};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++)
    for (int threads = 2; threads <= 3; threads++) {
      gmds_memory memory;
      gmds_soup soup = points_of(specs[i], &memory);
      for (size_t k = 0; i == 2 && k < soup.n_points; k++)
        soup.points[2 * k] = k % 2 ? 1 : 0; /* two columns: nearly all points are put off */
      patience p = {0, 1000000, 0};
      tri_mesh m;
      gmds_delaunay_result result = {.dimension = 0};
      const gmds_delaunay_options options = {.progress = give_up, .user = &p, .threads = threads};
      tri_mesh_init(&m, NULL);
      ck_assert_int_eq(tri_delaunay(&m, soup.n_points, soup.points, &options, &result), GMDS_OK);
      ck_assert_msg((size_t)p.calls >= result.distinct / 8192, "%s: %ld calls", specs[i], p.calls);
      ck_assert_msg(p.done + 4 * 4096 > result.distinct, "%s: %zu of %zu", specs[i], p.done, result.distinct);
      gmds_delaunay_result_clear(&result);
      tri_mesh_clear(&m);
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
    tri_mesh m;
    tri_mesh_init(&m, &allocator);
    gmds_status status = tri_delaunay(&m, soup.n_points, soup.points, &options, NULL);
    done = status == GMDS_OK;
    ck_assert(done || (status == GMDS_ERR_MEMORY && !tri_count_0(&m) && !tri_count_2(&m)));
    ck_assert_int_lt(k, 1000);
    tri_mesh_clear(&m);
    ck_assert_uint_eq(f.live, 0);
  }
  gmds_soup_clear(&soup);
}
END_TEST

/* Faces taken and given back leave the mesh as it was, with the attributes of later faces 0. */
START_TEST(faces_that_were_taken_can_be_given_back)
{
  tri_mesh m;
  gmds_memory memory;
  gmds_error error;
  gmds_attribute *colour = NULL;
  gmds_id first = 7, v[3], f = 0;
  const double xy[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  gmds_memory_init(&memory, NULL);
  tri_mesh_init(&m, NULL);
  ck_assert_int_eq(tri_add_attribute(&m, 2, "colour", GMDS_INT, 1, &colour), GMDS_OK);
  for (int k = 0; k < 3; k++)
    ck_assert_int_eq(tri_add_node(&m, xy[k], &v[k]), GMDS_OK);
  ck_assert_int_eq(tri_add_triangle(&m, v[0], v[1], v[2], &f), GMDS_OK);
  ck_assert_int_eq(tri_take_faces(&m, 100, &first), GMDS_OK);
  ck_assert_uint_eq(first, 1);
  ck_assert_uint_eq(tri_count_2(&m), 101);
  for (gmds_id g = first; g < 101; g++)
    ck_assert_int_eq(((int *)colour->data)[g], 0);
  tri_drop_faces(&m, first, 100);
  ck_assert_uint_eq(tri_count_2(&m), 1);
  ck_assert_uint_eq(tri_end_2(&m), 1);
  ck_assert_msg(tri_check(&m, &memory, &error) == GMDS_OK, "%s", error.text);
  ck_assert_int_eq(tri_take_faces(&m, SIZE_MAX, &first), GMDS_ERR_TOO_MANY);
  ck_assert_uint_eq(tri_count_2(&m), 1);
  tri_mesh_clear(&m);
}
END_TEST

RUN_SUITE("threads", any_number_of_threads_gives_the_triangles_of_one,
          points_that_strips_do_not_divide_are_inserted_too, the_numbering_depends_on_the_number_of_threads_alone,
          points_that_are_put_off_do_not_make_the_walks_longer, cancelling_at_any_call_leaves_the_mesh_empty,
          progress_is_told_to_the_end, every_failing_allocation_leaves_the_mesh_empty,
          faces_that_were_taken_can_be_given_back)
