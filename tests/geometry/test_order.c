/* Insertion orders: each distinct point once, equal points found, locality, failures without a trace. */
#define _POSIX_C_SOURCE 200809L /* popen */
#include "harness.h"
#include <float.h>
#include <geometry/hilbert.h>
#include <gmds/order.h>
#include <gmds/predicates.h>
#include <math.h>

#define TINY 0x1p-1074

/* X(name): kinds of point sets. */
#define KIND_LIST(X)                                                                     \
  X(uniform)                                                                             \
  X(lattice)   /* many equal points, zeros of both signs */                              \
  X(clusters)  /* a few, far apart */                                                    \
  X(nested)    /* each point nearer to the origin than the last by some powers of two */ \
  X(any_scale) /* from 1e-300 to 1e300 */                                                \
  X(huge)      /* the bounding box is wider than the largest double */                   \
  X(subnormal) /* small multiples of the smallest number */                              \
  X(on_one_line)                                                                         \
  X(all_equal)

#define KIND_ENUM(name) kind_##name,
enum { KIND_LIST(KIND_ENUM) kind_count };
#define KIND_NAME(name) #name,
static const char *const kind_name[] = {KIND_LIST(KIND_NAME)};

static double coordinate(int kind, uint64_t *seed, size_t i, int k, size_t n)
{
  double unit = random_unit(seed), sign = random_bits(seed) & 1 ? 1 : -1;
  size_t die = random_below(seed, 5);
  switch (kind) {
  case kind_lattice:
    return sign * (double)die;
  case kind_clusters:
    return (double)(i % 7 + (size_t)k * (i % 3)) + 1e-12 * unit;
  case kind_nested:
    return ldexp(sign * (1 + unit), -(int)(i * 2000 / n) + 1000);
  case kind_any_scale:
    return sign * pow(10, 600 * unit - 300);
  case kind_huge:
    return sign * DBL_MAX * (die ? unit : 1);
  case kind_subnormal:
    return sign * floor(40 * unit) * TINY;
  case kind_on_one_line:
    return k ? 3 : unit;
  case kind_all_equal:
    return k - 1.5;
  default:
    return unit;
  }
}

static double *points(int kind, uint64_t *seed, int dim, size_t n)
{
  double *xy = malloc((n + 1) * (size_t)dim * sizeof *xy);
  ck_assert(xy);
  for (size_t i = 0; i < n; i++)
    for (int k = 0; k < dim; k++)
      xy[i * (size_t)dim + (size_t)k] = coordinate(kind, seed, i, k, n);
  return xy;
}

typedef struct result {
  gmds_id *order, *same_as;
  size_t distinct;
} result;

static result result_new(size_t n)
{
  result r = {malloc((n + 1) * sizeof(gmds_id)), malloc((n + 1) * sizeof(gmds_id)), 999};
  ck_assert(r.order && r.same_as);
  memset(r.order, 0x55, (n + 1) * sizeof(gmds_id));
  memset(r.same_as, 0x55, (n + 1) * sizeof(gmds_id));
  return r;
}

static void result_free(result r)
{
  free(r.order);
  free(r.same_as);
}

/* Orders points that must be accepted; checks the memory taken. */
static result ordered(int dim, size_t n, const double *xy)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  result r = result_new(n);
  ck_assert_int_eq(gmds_order_points(&memory, NULL, 1, dim, n, xy, NULL, r.order, r.same_as, &r.distinct), GMDS_OK);
  ck_assert_uint_eq(memory.live, 0);
  ck_assert_uint_le(memory.peak, 4 * sizeof(double) * n);
#if GMDS_ID_BITS == 32
  ck_assert_uint_le(memory.peak, 24 * n);
#endif
  return r;
}

static const double *sorted_xy;
static int sorted_dim;

static int by_coordinates(const void *a, const void *b)
{
  size_t i = *(const size_t *)a, j = *(const size_t *)b;
  int compare = gmds_compare_points(sorted_dim, sorted_xy + i * (size_t)sorted_dim, sorted_xy + j * (size_t)sorted_dim);
  return compare ? compare : (i > j) - (i < j);
}

/* Each point is represented by the lowest index with its coordinates, and each of these occurs once in the order. */
static void check_result(const char *what, int dim, size_t n, const double *xy, result r)
{
  size_t *sorted = malloc((n + 1) * sizeof *sorted), distinct = 0, stands = 0;
  char *seen = calloc(n + 1, 1);
  ck_assert(sorted && seen);
  for (size_t i = 0; i < n; i++)
    sorted[i] = i;
  sorted_xy = xy;
  sorted_dim = dim;
  qsort(sorted, n, sizeof *sorted, by_coordinates);
  for (size_t i = 0; i < r.distinct; i++) {
    ck_assert_msg(r.order[i] < n && !seen[r.order[i]], "%s: order[%zu] is %zu", what, i, (size_t)r.order[i]);
    seen[r.order[i]] = 1;
  }
  for (size_t i = 0; i < n; i++) {
    size_t d = (size_t)dim;
    if (i == 0 || gmds_compare_points(dim, xy + sorted[i - 1] * d, xy + sorted[i] * d)) {
      stands = sorted[i];
      distinct++;
      ck_assert_msg(seen[stands], "%s: point %zu is left out", what, stands);
    }
    ck_assert_msg(r.same_as[sorted[i]] == stands, "%s: point %zu", what, sorted[i]);
  }
  ck_assert_uint_eq(distinct, r.distinct);
  free(sorted);
  free(seen);
}

START_TEST(each_distinct_point_comes_once_and_the_lowest_index_stands_for_equal_ones)
{
  static const size_t sizes[] = {0, 1, 2, 3, 15, 16, 17, 18, 100, 1023, 1024, 5000, 60000};
  uint64_t seed = 31;
  for (int kind = 0; kind < kind_count; kind++)
    for (int dim = 2; dim <= 3; dim++)
      for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        double *xy = points(kind, &seed, dim, sizes[s]);
        result r = ordered(dim, sizes[s], xy);
        check_result(kind_name[kind], dim, sizes[s], xy, r);
        result_free(r);
        free(xy);
      }
}
END_TEST

START_TEST(zeros_of_both_signs_are_equal)
{
  static const double xy[] = {1, 0.0, -0.0, 0.0, 1, -0.0, 0.0, -0.0, 0.0, 0.0};
  static const gmds_id same_as[] = {0, 1, 0, 1, 1};
  result r = ordered(2, 5, xy);
  ck_assert_uint_eq(r.distinct, 2);
  ck_assert_mem_eq(r.same_as, same_as, sizeof same_as);
  result_free(r);
}
END_TEST

START_TEST(same_as_may_be_left_out)
{
  uint64_t seed = 32;
  double *xy = points(kind_lattice, &seed, 2, 500);
  result a = ordered(2, 500, xy), b = result_new(500);
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  ck_assert_int_eq(gmds_order_points(&memory, NULL, 1, 2, 500, xy, NULL, b.order, NULL, &b.distinct), GMDS_OK);
  ck_assert_uint_eq(a.distinct, b.distinct);
  ck_assert_mem_eq(a.order, b.order, a.distinct * sizeof *a.order);
  result_free(a);
  result_free(b);
  free(xy);
}
END_TEST

/* Orders points that must be refused, and compares what was written with what was there before: nothing. */
static void check_refused(gmds_memory *memory, int dim, size_t n, const double *xy, gmds_status expected,
                          gmds_error *error)
{
  size_t room = n > 100000 ? 0 : n;
  result r = result_new(room), before = result_new(room);
  gmds_status status = gmds_order_points(memory, NULL, 1, dim, n, xy, error, r.order, r.same_as, &r.distinct);
  ck_assert_int_eq(status, expected);
  ck_assert_mem_eq(r.order, before.order, (room + 1) * sizeof *r.order);
  ck_assert_mem_eq(r.same_as, before.same_as, (room + 1) * sizeof *r.same_as);
  ck_assert_uint_eq(r.distinct, before.distinct);
  ck_assert_uint_eq(memory->live, 0);
  result_free(r);
  result_free(before);
}

START_TEST(the_first_point_that_is_not_finite_is_named)
{
  static const double values[] = {NAN, INFINITY, -INFINITY};
  uint64_t seed = 33;
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  for (int dim = 2; dim <= 3; dim++)
    for (size_t v = 0; v < 3; v++) {
      gmds_error error;
      double *xy = points(kind_uniform, &seed, dim, 40);
      xy[17 * (size_t)dim + 1] = values[v];
      xy[30 * (size_t)dim] = NAN;
      check_refused(&memory, dim, 40, xy, GMDS_ERR_COORDINATE, &error);
      check_refused(&memory, dim, 40, xy, GMDS_ERR_COORDINATE, NULL);
      ck_assert_int_eq(error.status, GMDS_ERR_COORDINATE);
      ck_assert_int_eq(error.cell, 17);
      ck_assert_msg(strstr(error.text, "point 17 ") && strstr(error.text, "its y "), "%s", error.text);
      free(xy);
    }
}
END_TEST

START_TEST(a_wrong_dimension_and_too_many_points_are_refused)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  gmds_error error;
  check_refused(&memory, 1, 0, NULL, GMDS_ERR_ARGUMENT, &error);
  check_refused(&memory, 4, 0, NULL, GMDS_ERR_ARGUMENT, &error);
#if GMDS_ID_BITS == 32 && SIZE_MAX > UINT32_MAX
  check_refused(&memory, 2, (size_t)1 << 32, NULL, GMDS_ERR_TOO_MANY, &error);
#endif
}
END_TEST

START_TEST(failing_allocations_leave_the_outputs_untouched)
{
  uint64_t seed = 34;
  double *xy = points(kind_lattice, &seed, 2, 3000);
  for (long k = 0;; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    result r = result_new(3000);
    gmds_status status = gmds_order_points(&memory, NULL, 1, 2, 3000, xy, NULL, r.order, r.same_as, &r.distinct);
    result_free(r);
    ck_assert_uint_eq(f.live, 0);
    if (status == GMDS_OK) {
      ck_assert_int_gt(k, 0);
      break;
    }
    f.until = k;
    gmds_error error;
    check_refused(&memory, 2, 3000, xy, GMDS_ERR_MEMORY, &error);
    ck_assert_uint_eq(f.live, 0);
  }
  free(xy);
}
END_TEST

START_TEST(the_order_does_not_depend_on_a_power_of_two)
{
  enum { N = 3000 };
  static const int exponents[] = {-950, -1, 1, 1023};
  uint64_t seed = 35;
  for (int dim = 2; dim <= 3; dim++) {
    double *xy = points(kind_uniform, &seed, dim, N), *scaled = malloc(N * 3 * sizeof *scaled);
    ck_assert(scaled);
    result a = ordered(dim, N, xy);
    for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++) {
      for (size_t i = 0; i < N * (size_t)dim; i++)
        scaled[i] = ldexp(xy[i], exponents[e]);
      result b = ordered(dim, N, scaled);
      ck_assert_mem_eq(a.order, b.order, N * sizeof *a.order);
      result_free(b);
    }
    result_free(a);
    free(scaled);
    free(xy);
  }
}
END_TEST

static double path_length(int dim, const double *xy, result r)
{
  double length = 0;
  for (size_t i = 1; i < r.distinct; i++) {
    double square = 0;
    for (int k = 0; k < dim; k++) {
      double step = xy[(size_t)r.order[i] * (size_t)dim + (size_t)k];
      step -= xy[(size_t)r.order[i - 1] * (size_t)dim + (size_t)k];
      square += step * step;
    }
    length += sqrt(square);
  }
  return length;
}

START_TEST(the_path_through_spread_points_is_short)
{
  enum { N = 100000 };
  uint64_t seed = 36;
  for (int dim = 2; dim <= 3; dim++) {
    double *xy = points(kind_uniform, &seed, dim, N);
    result r = ordered(dim, N, xy);
    /* A Hilbert curve steps 0.9 mean distances; the rounds add theirs. A random order would take 0.5 N. */
    ck_assert_double_lt(path_length(dim, xy, r), 1.6 * pow(N, 1 - 1.0 / dim));
    result_free(r);
    free(xy);
  }
}
END_TEST

START_TEST(the_path_through_clusters_is_short)
{
  enum { N = 100000, CLUSTERS = 100 };
  uint64_t seed = 37;
  double *xy = points(kind_uniform, &seed, 2, N);
  const double size = 1e-7;
  for (size_t i = 2 * CLUSTERS; i < (size_t)2 * N; i++)
    xy[i] = xy[i % (2 * CLUSTERS)] + size * xy[i];
  result r = ordered(2, N, xy);
  /* Through each cluster as through spread points, and from one to another: each round once. */
  double inside = CLUSTERS * size * 2 * sqrt(N / CLUSTERS), rounds = 4, between = rounds * 1.6 * sqrt(CLUSTERS);
  ck_assert_double_lt(path_length(2, xy, r), inside + between);
  result_free(r);
  free(xy);
}
END_TEST

START_TEST(early_rounds_cover_the_whole_set)
{
  enum { N = 100000, SIDE = 16 };
  uint64_t seed = 38;
  double *xy = points(kind_uniform, &seed, 2, N);
  result r = ordered(2, N, xy);
  int seen[SIDE * SIDE] = {0}, count = 0;
  for (size_t i = 0; i < N / 6; i++) {
    const double *p = xy + 2 * (size_t)r.order[i];
    int *box = &seen[(int)(p[0] * SIDE) * SIDE + (int)(p[1] * SIDE)];
    count += !*box;
    *box = 1;
  }
  ck_assert_int_eq(count, SIDE * SIDE);
  result_free(r);
  free(xy);
}
END_TEST

START_TEST(consecutive_places_of_the_curve_are_neighbours)
{
  enum { N = 4096 };
  static unsigned x[N], y[N], z[N];
  hilbert curve;
  hilbert_init(&curve, 2);
  for (unsigned i = 0; i < N; i++) {
    uint32_t place = hilbert_place_2d(&curve, i % 64 << 10, i / 64 << 10) >> 20;
    x[place] = i % 64 + 1;
    y[place] = i / 64 + 1;
  }
  for (unsigned i = 1; i < N; i++)
    ck_assert_int_eq(abs((int)(x[i] - x[i - 1])) + abs((int)(y[i] - y[i - 1])), 1);
  memset(x, 0, sizeof x);
  hilbert_init(&curve, 3);
  for (unsigned i = 0; i < N; i++) {
    uint32_t place = hilbert_place_3d(&curve, i % 16 << 6, i / 16 % 16 << 6, i / 256 << 6) >> 18;
    x[place] = i % 16 + 1;
    y[place] = i / 16 % 16 + 1;
    z[place] = i / 256 + 1;
  }
  for (unsigned i = 1; i < N; i++)
    ck_assert_int_eq(abs((int)(x[i] - x[i - 1])) + abs((int)(y[i] - y[i - 1])) + abs((int)(z[i] - z[i - 1])), 1);
}
END_TEST

/* Reads a compressed file of n points in the plane; NULL after a word when there is none. */
static double *read_points(const char *name, size_t n)
{
  const char *folder = data_folder(name);
  if (!folder)
    return NULL;
  char command[4096];
  snprintf(command, sizeof command, "xz -dc '%s/points/%s'", folder, name);
  FILE *file = popen(command, "r");
  double *xy = malloc(2 * n * sizeof *xy);
  ck_assert(file && xy);
  for (size_t i = 0; i < 2 * n; i++)
    ck_assert_int_eq(fscanf(file, "%lf", &xy[i]), 1);
  ck_assert_int_eq(pclose(file), 0);
  return xy;
}

START_TEST(equal_points_of_real_sets_are_found)
{
  static const struct {
    const char *name;
    size_t n, distinct;
  } sets[] = {{"geonames_cities1000_lonlat.xy.xz", 144563, 144327},
              {"cgal_norway_coast_endpoints.xy.xz", 81156, 40561}};
  for (size_t i = 0; i < 2; i++) {
    double *xy = read_points(sets[i].name, sets[i].n);
    if (!xy)
      continue;
    result r = ordered(2, sets[i].n, xy);
    ck_assert_uint_eq(r.distinct, sets[i].distinct);
    check_result(sets[i].name, 2, sets[i].n, xy, r);
    result_free(r);
    free(xy);
  }
}
END_TEST

/* Any number of threads gives the order of one: spread points, a grid, equal points, all in one place, mixed scales. */
START_TEST(threads_do_not_change_the_order)
{
  enum { MANY = 300000 };
  double *xy = malloc(3 * MANY * sizeof *xy);
  uint64_t seed = 77;
  ck_assert(xy != NULL);
  for (int dim = 2; dim <= 3; dim++)
    for (int kind = 0; kind < 5; kind++) {
      size_t n = (size_t)MANY * (size_t)dim;
      for (size_t i = 0; i < n; i++) {
        double x = random_unit(&seed);
        xy[i] = kind == 0   ? x
                : kind == 1 ? (double)(int)(500 * x)
                : kind == 2 ? (double)(int)(20 * x)
                : kind == 3 ? 1.5
                            : ldexp(x, (int)random_below(&seed, 200) - 100);
      }
      gmds_memory memory;
      gmds_memory_init(&memory, NULL);
      result one = result_new(MANY);
      ck_assert_int_eq(gmds_order_points(&memory, NULL, 1, dim, MANY, xy, NULL, one.order, one.same_as, &one.distinct),
                       GMDS_OK);
      for (unsigned threads = 2; threads < 12; threads += 3) {
        result r = result_new(MANY);
        ck_assert_int_eq(
            gmds_order_points(&memory, NULL, threads, dim, MANY, xy, NULL, r.order, r.same_as, &r.distinct), GMDS_OK);
        ck_assert_uint_eq(r.distinct, one.distinct);
        ck_assert(memcmp(r.order, one.order, r.distinct * sizeof *r.order) == 0);
        ck_assert(memcmp(r.same_as, one.same_as, MANY * sizeof *r.same_as) == 0);
        result_free(r);
      }
      result_free(one);
      ck_assert_uint_eq(memory.live, 0);
    }
  free(xy);
}
END_TEST

RUN_SUITE("order", threads_do_not_change_the_order,
          each_distinct_point_comes_once_and_the_lowest_index_stands_for_equal_ones, zeros_of_both_signs_are_equal,
          same_as_may_be_left_out, the_first_point_that_is_not_finite_is_named,
          a_wrong_dimension_and_too_many_points_are_refused, failing_allocations_leave_the_outputs_untouched,
          the_order_does_not_depend_on_a_power_of_two, the_path_through_spread_points_is_short,
          the_path_through_clusters_is_short, early_rounds_cover_the_whole_set,
          consecutive_places_of_the_curve_are_neighbours, equal_points_of_real_sets_are_found)
