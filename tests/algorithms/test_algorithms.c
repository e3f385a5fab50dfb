/* Boundary, components and smoothing in every way that a model can have them, against brute force. */
#include "algorithms/brute.h"
#include "harness.h"
#include <gmds/chains.h>
#include <gmds/io.h>
#include <gmds/manifold.h>
#include <gmds/predicates.h>
#include <gmds/quality.h>
#include <limits.h>
#include <math.h>

enum { SWEEPS = 3 };

typedef struct outcome {
  gmds_memory memory;
  gmds_csr chains;
  size_t open, count, moved;
  gmds_id *component;
  double *points;
  int ordered;
  gmds_surface_report report;
  double *values; /* and the sizes behind them */
  gmds_quality summary;
} outcome;

/* Every number from 1 to n has gone where the map says. */
static void check_numbers(const gmds_id *number, const gmds_id *map, size_t n)
{
  int *met = calloc(n + 1, sizeof *met);
  for (size_t c = 0; c < n; c++)
    ck_assert(map[c] < n && !met[map[c]]++ && number[map[c]] == c + 1);
  free(met);
}

/* Faces have the nodes that they had, and come by the least of these. */
static void check_faces(const gmds_csr *before, const gmds_csr *after, gmds_id *const *maps, size_t n, int ordered)
{
  gmds_id last = 0;
  for (size_t f = 0; f < n; f++) {
    const size_t from = before->begin[f], to = after->begin[maps[2][f]], length = before->begin[f + 1] - from;
    ck_assert_uint_eq(after->begin[maps[2][f] + 1] - to, length);
    for (size_t k = 0; k < length; k++) {
      size_t q = ordered ? k : 0;
      while (q < length && after->data[to + q] != maps[0][before->data[from + k]])
        q++;
      ck_assert(ordered ? q == k : q < length);
    }
  }
  for (size_t f = 0; f < n; f++) {
    gmds_id least = GMDS_NONE;
    for (size_t q = after->begin[f]; q < after->begin[f + 1]; q++)
      least = after->data[q] < least ? after->data[q] : least;
    ck_assert(least >= last);
    last = least;
  }
}

#include "algorithms/models.h"

typedef void runner(const gmds_soup *soup, int inject, outcome *o);
#define RUNNER(prefix) prefix##_run,
static runner *const runners[] = {TRIANGLE_MODELS(RUNNER) ALL_MODELS(RUNNER)};
#define ONE(prefix) +1
enum { N_TRIANGLE_MODELS = 0 TRIANGLE_MODELS(ONE), N_MODELS = sizeof runners / sizeof *runners };

static gmds_memory memory;

/* ---- brute force: the sides of all faces, sorted */

typedef struct side {
  gmds_id a, b, from, face; /* a < b; `from`: where it begins in its face */
} side;

static int by_ends(const void *p, const void *q)
{
  const side *x = p, *y = q;
  if (x->a != y->a)
    return x->a < y->a ? -1 : 1;
  return x->b != y->b ? (x->b < y->b ? -1 : 1) : (x->face > y->face) - (x->face < y->face);
}

static side *sides_of(const gmds_soup *s, size_t *n)
{
  side *sides = malloc((s->begin[s->n_cells] + 1) * sizeof *sides);
  *n = 0;
  for (size_t f = 0; f < s->n_cells; f++)
    for (size_t k = s->begin[f]; k < s->begin[f + 1]; k++) {
      gmds_id p = s->corners[k], q = s->corners[k + 1 < s->begin[f + 1] ? k + 1 : s->begin[f]];
      sides[(*n)++] = (side){p < q ? p : q, p < q ? q : p, p, (gmds_id)f};
    }
  qsort(sides, *n, sizeof *sides, by_ends);
  return sides;
}

static size_t group_end(const side *sides, size_t n, size_t k)
{
  size_t end = k + 1;
  while (end < n && sides[end].a == sides[k].a && sides[end].b == sides[k].b)
    end++;
  return end;
}

static void check_boundary(const gmds_soup *s, const outcome *o)
{
  size_t n = 0, bare = 0, walked = 0;
  side *sides = sides_of(s, &n);
  int *met = calloc(n + 1, sizeof *met);
  for (size_t k = 0, end; k < n; k = end) {
    end = group_end(sides, n, k);
    bare += end == k + 1;
  }
  for (size_t r = 0; r < o->chains.n; r++) {
    const gmds_id *row = o->chains.data + o->chains.begin[r];
    size_t length = o->chains.begin[r + 1] - o->chains.begin[r];
    for (size_t k = 0; k + (r < o->open) < length; k++) {
      gmds_id p = row[k], q = row[k + 1 < length ? k + 1 : 0];
      const side key = {p < q ? p : q, p < q ? q : p, p, 0};
      size_t at = 0, high = n;
      while (at < high) { /* the first that is not before the key */
        size_t middle = at + (high - at) / 2;
        if (by_ends(&sides[middle], &key) < 0)
          at = middle + 1;
        else
          high = middle;
      }
      ck_assert(at < n && sides[at].a == key.a && sides[at].b == key.b);
      ck_assert_uint_eq(group_end(sides, n, at), at + 1);
      ck_assert(!met[at]);
      met[at] = 1;
      walked++;
    }
  }
  ck_assert_uint_eq(walked, bare);
  ck_assert_uint_eq(o->open, 0); /* no side has more than two faces here */
  free(met);
  free(sides);
}

static gmds_id root(const gmds_id *parent, gmds_id f)
{
  while (parent[f] != f)
    f = parent[f];
  return f;
}

static void check_components(const gmds_soup *s, const outcome *o)
{
  size_t n = 0, count = 0;
  side *sides = sides_of(s, &n);
  gmds_id *parent = malloc((s->n_cells + 1) * sizeof *parent);
  for (size_t f = 0; f < s->n_cells; f++)
    parent[f] = (gmds_id)f;
  for (size_t k = 1; k < n; k++)
    if (sides[k].a == sides[k - 1].a && sides[k].b == sides[k - 1].b) {
      gmds_id p = root(parent, sides[k].face), q = root(parent, sides[k - 1].face);
      parent[p > q ? p : q] = p < q ? p : q;
    }
  for (gmds_id f = 0; f < s->n_cells; f++) {
    gmds_id r = root(parent, f);
    parent[f] = r; /* keeps the walks short */
    ck_assert_uint_eq(o->component[f], r == f ? count : o->component[r]);
    count += r == f;
  }
  ck_assert_uint_eq(o->count, count);
  free(parent);
  free(sides);
}

/* ---- manifolds, the slow way */

static int has_node(const gmds_soup *s, size_t f, gmds_id v)
{
  for (size_t k = s->begin[f]; k < s->begin[f + 1]; k++)
    if (s->corners[k] == v)
      return 1;
  return 0;
}

/* How many fans the faces at v make: of the sides at v each joins all of its faces. */
static size_t fans_at(const gmds_soup *s, const side *sides, size_t n, gmds_id v)
{
  size_t fans = 0;
  gmds_id *parent = malloc((s->n_cells + 1) * sizeof *parent);
  for (size_t f = 0; f < s->n_cells; f++)
    parent[f] = (gmds_id)f;
  for (size_t k = 1; k < n; k++)
    if (sides[k].a == sides[k - 1].a && sides[k].b == sides[k - 1].b && (sides[k].a == v || sides[k].b == v)) {
      gmds_id p = root(parent, sides[k].face), q = root(parent, sides[k - 1].face);
      parent[p > q ? p : q] = p < q ? p : q;
    }
  for (size_t f = 0; f < s->n_cells; f++)
    fans += has_node(s, f, v) && parent[f] == f;
  free(parent);
  return fans;
}

static void expect_finding(const gmds_finding *found, const gmds_finding *expected)
{
  ck_assert_uint_eq(found->count, expected->count);
  ck_assert_uint_eq(found->first[0], expected->first[0]);
  ck_assert_uint_eq(found->first[1], expected->first[1]);
}

static void note(gmds_finding *f, gmds_id a, gmds_id b)
{
  if (!f->count++) {
    f->first[0] = a;
    f->first[1] = b;
  }
}

static void check_manifold(const gmds_soup *s, const outcome *o)
{
  const gmds_finding none = {0, {GMDS_NONE, GMDS_NONE}};
  gmds_finding border = none, crowded = none, turned = none, pinched = none;
  size_t n = 0, n_sides = 0, used = 0;
  side *sides = sides_of(s, &n);
  for (size_t k = 0, end; k < n; k = end) {
    end = group_end(sides, n, k);
    n_sides++;
    if (end != k + 2)
      note(end == k + 1 ? &border : &crowded, sides[k].a, sides[k].b);
    else if (sides[k].from == sides[k + 1].from && o->ordered)
      note(&turned, sides[k].a, sides[k].b);
  }
  for (gmds_id v = 0; v < s->n_points; v++) {
    const size_t fans = fans_at(s, sides, n, v);
    used += fans > 0;
    if (fans > 1)
      note(&pinched, v, GMDS_NONE);
  }
  expect_finding(&o->report.border, &border);
  expect_finding(&o->report.crowded, &crowded);
  expect_finding(&o->report.turned, &turned);
  expect_finding(&o->report.pinched, &pinched);
  ck_assert_uint_eq(o->report.faces, s->n_cells);
  ck_assert_uint_eq(o->report.sides, n_sides);
  ck_assert_uint_eq(o->report.nodes, used);
  ck_assert_int_eq(o->report.manifold, !crowded.count && !pinched.count);
  ck_assert_int_eq(o->report.closed, o->report.manifold && !border.count && o->report.faces);
  free(sides);
}

/* ---- quality, by other formulas: through the angles, sides and heights of a face */

static double distance(const gmds_soup *s, gmds_id a, gmds_id b)
{
  return hypot(s->points[2 * a] - s->points[2 * b], s->points[2 * a + 1] - s->points[2 * b + 1]);
}

static void check_quality(const gmds_soup *s, const outcome *o)
{
  for (size_t f = 0; f < s->n_cells; f++) {
    const gmds_id *v = s->corners + s->begin[f];
    const size_t n = s->begin[f + 1] - s->begin[f];
    double area = 0, around = 0, squares = 0, least = 1, value = 0;
    for (size_t k = 0; k < n; k++) {
      const double *p = s->points + 2 * v[k], *q = s->points + 2 * v[(k + 1) % n],
                   *r = s->points + 2 * v[(k + n - 1) % n];
      const double angle = atan2(r[1] - p[1], r[0] - p[0]) - atan2(q[1] - p[1], q[0] - p[0]);
      area += (p[0] * q[1] - p[1] * q[0]) / 2;
      around += distance(s, v[k], v[(k + 1) % n]);
      squares += pow(distance(s, v[k], v[(k + 1) % n]), 2);
      least = sin(angle) < least ? sin(angle) : least;
    }
    const double whole = acos(-1) / (double)n;
    value = n == 3   ? 4 * sqrt(3) * area / squares
            : n == 4 ? least
                     : 4 * (double)n * tan(whole) * area / (around * around);
    if (!o->ordered) {
      value = fabs(value);
      area = fabs(area);
    }
    ck_assert_double_eq_tol(o->values[f], value, 1e-12);
    ck_assert_double_eq_tol(o->values[s->n_cells + f], area, 1e-12);
  }
}

/* ---- smoothing, the slow way */

static int turn_of(const gmds_soup *s, const double *xy, size_t f, size_t k)
{
  size_t begin = s->begin[f], n = s->begin[f + 1] - begin;
  const gmds_id *v = s->corners + begin;
  return gmds_orient2d(xy + 2 * (size_t)v[(k + n - 1) % n], xy + 2 * (size_t)v[k], xy + 2 * (size_t)v[(k + 1) % n]);
}

static size_t smooth_slowly(const gmds_soup *s, double *xy)
{
  size_t moved = 0;
  int *times = calloc(s->n_points + 1, sizeof *times);
  for (gmds_id v = 0; v < s->n_points; v++) {
    double x[2] = {0, 0}, old[2] = {xy[2 * v], xy[2 * v + 1]};
    int before[64][8], n_before = 0, inner = 1, joined = 0, keeps = 1;
    memset(times, 0, s->n_points * sizeof *times);
    for (size_t f = 0; f < s->n_cells; f++) {
      size_t begin = s->begin[f], n = s->begin[f + 1] - begin;
      for (size_t k = 0; k < n; k++)
        if (s->corners[begin + k] == v) {
          times[s->corners[begin + (k + 1) % n]]++;
          times[s->corners[begin + (k + n - 1) % n]]++;
          for (size_t q = 0; q < n; q++)
            before[n_before][q] = turn_of(s, xy, f, q);
          n_before++;
        }
    }
    for (gmds_id w = 0; w < s->n_points; w++) {
      inner &= times[w] == 0 || times[w] == 2;
      joined += times[w] > 0;
    }
    if (!inner || !joined)
      continue;
    for (gmds_id w = 0; w < s->n_points; w++)
      if (times[w]) {
        x[0] += xy[2 * w] / joined;
        x[1] += xy[2 * w + 1] / joined;
      }
    if (x[0] == old[0] && x[1] == old[1])
      continue;
    xy[2 * v] = x[0];
    xy[2 * v + 1] = x[1];
    n_before = 0;
    for (size_t f = 0; f < s->n_cells; f++)
      for (size_t k = s->begin[f]; k < s->begin[f + 1]; k++)
        if (s->corners[k] == v) {
          for (size_t q = 0; q < s->begin[f + 1] - s->begin[f]; q++)
            keeps &= !before[n_before][q] || turn_of(s, xy, f, q) == before[n_before][q];
          n_before++;
        }
    if (!keeps)
      memcpy(xy + 2 * v, old, sizeof old);
    moved += (size_t)keeps;
  }
  free(times);
  return moved;
}

static void check_smoothing(const gmds_soup *s, const outcome *o)
{
  size_t bytes = 2 * s->n_points * sizeof(double), moved = 0;
  double *xy = malloc(bytes + 1);
  memcpy(xy, s->points, bytes);
  for (int k = 0; k < SWEEPS; k++)
    moved = smooth_slowly(s, xy);
  ck_assert_int_eq(memcmp(xy, o->points, bytes), 0);
  ck_assert_uint_eq(moved, o->moved);
  free(xy);
}

/* No corner has turned, boundary nodes have stayed. */
static void check_turns(const gmds_soup *s, const outcome *o)
{
  for (size_t f = 0; f < s->n_cells; f++)
    for (size_t k = 0; k < s->begin[f + 1] - s->begin[f]; k++) {
      int before = turn_of(s, s->points, f, k);
      ck_assert(!before || turn_of(s, o->points, f, k) == before);
    }
  for (size_t k = 0; k < o->chains.begin[o->chains.n]; k++)
    ck_assert_int_eq(memcmp(s->points + 2 * o->chains.data[k], o->points + 2 * o->chains.data[k], 16), 0);
}

/* ---- meshes */

static void outcome_begin(outcome *o)
{
  memset(o, 0, sizeof *o);
  gmds_memory_init(&o->memory, NULL);
  gmds_csr_init(&o->chains, &o->memory);
}

static void outcome_end(outcome *o)
{
  gmds_csr_clear(&o->chains);
  ck_assert_uint_eq(o->memory.live, 0);
  free(o->component);
  free(o->points);
  free(o->values);
}

static void all_models_agree(const gmds_soup *s, int triangles, int inject, int small)
{
  static outcome first, other;
  size_t begin = triangles ? 0 : N_TRIANGLE_MODELS;
  for (size_t k = begin; k < N_MODELS; k++) {
    outcome *o = k == begin ? &first : &other;
    outcome_begin(o);
    runners[k](s, inject, o);
    check_boundary(s, o);
    check_components(s, o);
    check_turns(s, o);
    if (small) {
      check_manifold(s, o);
      check_quality(s, o);
      check_smoothing(s, o);
    }
    ck_assert_int_eq(memcmp(first.points, o->points, 2 * s->n_points * sizeof(double)), 0);
    ck_assert_uint_eq(first.moved, o->moved);
    ck_assert_uint_eq(first.chains.begin[first.chains.n], o->chains.begin[o->chains.n]);
    if (k != begin)
      outcome_end(o);
  }
  outcome_end(&first);
}

static gmds_id add(gmds_soup *s, double x, double y)
{
  const double p[2] = {x, y};
  ck_assert_int_eq(gmds_soup_add_point(s, p), GMDS_OK);
  return (gmds_id)(s->n_points - 1);
}

/* w by h squares with some left out, shaken; kind 0: cut in two, 1: whole, 2: both and hexagons. */
static void make_grid(gmds_soup *s, gmds_id w, gmds_id h, int kind, uint64_t seed)
{
  gmds_soup_init(s, &memory, 2);
  for (gmds_id y = 0; y <= h; y++)
    for (gmds_id x = 0; x <= w; x++)
      add(s, x + 0.45 * random_unit(&seed), y + 0.45 * random_unit(&seed));
  for (gmds_id y = 0; y < h; y++)
    for (gmds_id x = 0; x < w; x++) {
      gmds_id a = y * (w + 1) + x, b = a + 1, c = b + w + 1, d = a + w + 1;
      const gmds_id lower[3] = {a, b, c}, upper[3] = {a, c, d}, whole[4] = {a, b, c, d};
      const gmds_id joined[6] = {a, b, b + 1, c + 1, c, d};
      if (random_below(&seed, 6) == 0)
        continue;
      if (kind == 2 && x + 1 < w && random_below(&seed, 3) == 0) {
        ck_assert_int_eq(gmds_soup_add_cell(s, GMDS_POLYGON, 6, joined), GMDS_OK);
        x++;
      } else if (kind == 1 || (kind == 2 && random_below(&seed, 2)))
        ck_assert_int_eq(gmds_soup_add_cell(s, GMDS_QUADRILATERAL, 4, whole), GMDS_OK);
      else {
        ck_assert_int_eq(gmds_soup_add_cell(s, GMDS_TRIANGLE, 3, lower), GMDS_OK);
        ck_assert_int_eq(gmds_soup_add_cell(s, GMDS_TRIANGLE, 3, upper), GMDS_OK);
      }
    }
}

START_TEST(small_meshes_are_as_brute_force_has_them)
{
  gmds_memory_init(&memory, NULL);
  for (uint64_t seed = 1; seed <= 12; seed++)
    for (int kind = 0; kind < 3; kind++) {
      gmds_soup s;
      make_grid(&s, 7, 6, kind, seed);
      all_models_agree(&s, kind == 0, 0, 1);
      gmds_soup_clear(&s);
    }
}
END_TEST

START_TEST(an_empty_mesh_has_no_boundary_and_no_component)
{
  gmds_soup s;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&s, &memory, 2);
  ck_assert_int_eq(gmds_soup_reserve(&s, 1, 1, 1), GMDS_OK);
  all_models_agree(&s, 1, 0, 1);
  add(&s, 1, 2);
  all_models_agree(&s, 1, 1, 1);
  gmds_soup_clear(&s);
}
END_TEST

/* Any three of a few nodes: sides of many faces, turned either way; in models that hold them. */
START_TEST(what_is_no_manifold_is_reported)
{
  gmds_memory_init(&memory, NULL);
  for (uint64_t seed = 1; seed <= 20; seed++) {
    static const size_t holding[] = {0, 1, 4, 6, 8, 9};
    uint64_t state = seed;
    gmds_soup s;
    gmds_soup_init(&s, &memory, 2);
    for (int p = 0; p < 9; p++)
      add(&s, random_unit(&state), random_unit(&state));
    for (int f = 0; f < 8; f++) {
      const gmds_id a = (gmds_id)random_below(&state, 3),
                    v[3] = {a, a + 1 + (gmds_id)random_below(&state, 2), a + 3 + (gmds_id)random_below(&state, 4)};
      const gmds_id w[3] = {v[1], v[0], v[2]};
      ck_assert_int_eq(gmds_soup_add_cell(&s, GMDS_TRIANGLE, 3, random_below(&state, 2) ? v : w), GMDS_OK);
    }
    for (size_t k = 0; k < sizeof holding / sizeof *holding; k++) {
      outcome o;
      outcome_begin(&o);
      runners[holding[k]](&s, 0, &o);
      check_manifold(&s, &o);
      check_quality(&s, &o);
      outcome_end(&o);
    }
    gmds_soup_clear(&s);
  }
}
END_TEST

/* n triangles in a band, closed with a half turn or without. */
START_TEST(a_band_with_a_half_turn_cannot_be_oriented)
{
  gmds_memory_init(&memory, NULL);
  for (int half = 0; half < 2; half++) {
    const gmds_id n = 9 + (gmds_id)!half;
    gmds_soup s;
    gmds_soup_init(&s, &memory, 2);
    for (gmds_id p = 0; p < n; p++)
      add(&s, cos(p), sin(p));
    for (gmds_id f = 0; f < n; f++) {
      const gmds_id v[3] = {f, (f + 1) % n, (f + 2) % n};
      ck_assert_int_eq(gmds_soup_add_cell(&s, GMDS_TRIANGLE, 3, v), GMDS_OK);
    }
    for (size_t k = 0; k < N_MODELS; k++) {
      outcome o;
      outcome_begin(&o);
      runners[k](&s, 0, &o);
      check_manifold(&s, &o);
      ck_assert_int_eq(o.report.orientable, !half);
      ck_assert(o.report.manifold && !o.report.closed);
      outcome_end(&o);
    }
    gmds_soup_clear(&s);
  }
}
END_TEST

START_TEST(a_failing_call_changes_nothing)
{
  gmds_memory_init(&memory, NULL);
  for (int kind = 0; kind < 3; kind++) {
    gmds_soup s;
    make_grid(&s, 4, 3, kind, 5);
    all_models_agree(&s, kind == 0, 1, 1);
    gmds_soup_clear(&s);
  }
}
END_TEST

START_TEST(renumbering_closes_holes)
{
  gmds_soup s;
  whole_mesh m;
  gmds_id faces[200], *const maps[3] = {NULL, NULL, faces};
  uint64_t before = 0, after = 1;
  gmds_memory_init(&memory, NULL);
  make_grid(&s, 7, 6, 2, 4);
  whole_mesh_init(&m, NULL);
  ck_assert_int_eq(whole_from_soup(&m, &s, NULL), GMDS_OK);
  const size_t end = whole_end_2(&m);
  for (gmds_id f = 0; f < end; f += 3)
    ck_assert_int_eq(whole_remove_face(&m, f, GMDS_DROP_BARE_EDGES), GMDS_OK);
  ck_assert_int_eq(whole_checksum(&m, &memory, &before), GMDS_OK);
  ck_assert_int_eq(whole_renumber(&m, maps, NULL), GMDS_OK);
  ck_assert_int_eq(whole_check(&m, &memory, NULL), GMDS_OK);
  ck_assert_int_eq(whole_checksum(&m, &memory, &after), GMDS_OK);
  ck_assert_uint_eq(before, after);
  ck_assert(whole_count_2(&m) == whole_end_2(&m) && whole_count_1(&m) == whole_end_1(&m) && end <= 200);
  for (size_t f = 0; f < end; f++)
    ck_assert_int_eq(faces[f] == GMDS_NONE, f % 3 == 0);
  whole_mesh_clear(&m);
  gmds_soup_clear(&s);
}
END_TEST

/* The faces of a file, seen from above: what lies in space is flattened. */
static void load(const char *folder, const char *file, gmds_soup *s)
{
  char command[1200], name[64];
  snprintf(name, sizeof name, "algorithms_%.*s", (int)strlen(strrchr(file, '/') + 1) - 3, strrchr(file, '/') + 1);
  snprintf(command, sizeof command, "xz -dc '%s/%s' >%s", folder, file, name);
  ck_assert_int_eq(system(command), 0);
  gmds_soup all;
  gmds_error error = {0};
  gmds_soup_init(&all, &memory, 3);
  gmds_soup_init(s, &memory, 2);
  ck_assert_msg(gmds_read_soup(name, 0, &error, &all) == GMDS_OK, "%s", error.text);
  remove(name);
  for (size_t v = 0; v < all.n_points; v++)
    add(s, all.points[(size_t)all.dim * v], all.points[(size_t)all.dim * v + 1]);
  for (size_t c = 0; c < all.n_cells; c++)
    if (gmds_cell_type_dimension((gmds_cell_type)all.types[c]) == 2)
      ck_assert_int_eq(gmds_soup_add_cell(s, (gmds_cell_type)all.types[c], all.begin[c + 1] - all.begin[c],
                                          all.corners + all.begin[c]),
                       GMDS_OK);
  gmds_soup_clear(&all);
}

START_TEST(real_meshes_have_their_boundaries_and_components)
{
  static const struct {
    const char *file;
    int triangles;
  } files[] = {{"surfaces/cgal_blade_open.off.xz", 1},
               {"surfaces/cgal_elephant.off.xz", 1},
               {"volumes/gmds_HolesInSquare2.vtk.xz", 1},
               {"volumes/gmds_ElipticSmoothTest2_quads.vtk.xz", 0},
               {"volumes/mmg_naca.mesh.xz", 1}};
  const char *folder = data_folder("boundaries and components of real meshes");
  gmds_memory_init(&memory, NULL);
  for (size_t k = 0; folder && k < sizeof files / sizeof *files; k++) {
    gmds_soup s;
    load(folder, files[k].file, &s);
    all_models_agree(&s, files[k].triangles, 0, 0);
    gmds_soup_clear(&s);
  }
}
END_TEST

RUN_SUITE("algorithms", small_meshes_are_as_brute_force_has_them, what_is_no_manifold_is_reported,
          a_band_with_a_half_turn_cannot_be_oriented, an_empty_mesh_has_no_boundary_and_no_component,
          a_failing_call_changes_nothing, renumbering_closes_holes, real_meshes_have_their_boundaries_and_components)
