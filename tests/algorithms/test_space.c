/* The algorithms on meshes of volumes, in every way that a model can have them, against brute force. */
#include "algorithms/brute.h"
#include "harness.h"
#include <gmds/io.h>
#include <gmds/manifold.h>
#include <gmds/predicates.h>
#include <gmds/quality.h>
#include <limits.h>
#include <math.h>

typedef struct subject {
  const char *name;
  size_t bytes;
  int ordered;
  void (*begin)(void *m, const gmds_allocator *allocator);
  void (*end)(void *m);
  gmds_status (*fill)(void *m, const gmds_soup *soup, gmds_error *error);
  gmds_status (*verify)(void *m, gmds_memory *memory, gmds_error *error);
  gmds_memory *(*memory)(void *m);
  double *(*points)(void *m);
  gmds_status (*bound)(void *m, gmds_csr *faces, gmds_ids *on);
  gmds_status (*part)(void *m, gmds_id *component, size_t *count);
  gmds_status (*look)(void *m, gmds_volume_report *report);
  gmds_status (*measure)(void *m, double *values, double *sizes, gmds_quality *summary);
  gmds_status (*relate)(void *m, int i, int j, gmds_complex *cells, gmds_csr *csr);
  gmds_status (*soften)(void *m, size_t sweeps, size_t *moved);
  gmds_status (*number)(void *m, gmds_id *const *maps);
  gmds_status (*list)(const void *m, gmds_soup *soup);
  gmds_attribute *(*attribute)(void *m, int i); /* of one identifier a cell: added, or found */
  size_t (*end_of)(const void *m, int i);
} subject;

#include "algorithms/space_models.h"

enum { SWEEPS = 3, N_TETRAHEDRAL = 4, WITH_POLYHEDRA = 8 };
#define SUBJECT(prefix) &prefix##_subject,
static const subject *const subjects[] = {SPACE_MODELS(SUBJECT)};
enum { N_SUBJECTS = sizeof subjects / sizeof *subjects };

static gmds_memory memory;

/* ---- what the algorithms give */

typedef struct outcome {
  gmds_memory memory;
  gmds_csr faces;
  gmds_ids on;
  gmds_id *component;
  size_t count, moved, n_points;
  gmds_volume_report report;
  double *values, *sizes, *points;
  gmds_quality summary;
} outcome;

static void outcome_begin(outcome *o, const gmds_soup *soup)
{
  memset(o, 0, sizeof *o);
  gmds_memory_init(&o->memory, NULL);
  gmds_csr_init(&o->faces, &o->memory);
  gmds_ids_init(&o->on, &o->memory);
  o->component = calloc(soup->n_cells + 1, sizeof *o->component);
  o->values = calloc(soup->n_cells + 1, sizeof *o->values);
  o->sizes = calloc(soup->n_cells + 1, sizeof *o->sizes);
  o->points = calloc(3 * soup->n_points + 1, sizeof *o->points);
  o->n_points = soup->n_points;
}

static void outcome_end(outcome *o)
{
  gmds_csr_clear(&o->faces);
  gmds_ids_clear(&o->on);
  ck_assert_uint_eq(o->memory.live, 0);
  free(o->component);
  free(o->values);
  free(o->sizes);
  free(o->points);
}

/* The relations of a small mesh, each against brute force; only that they are built where `b` is NULL. */
static gmds_status relate_all(const subject *s, void *m, const brute *b)
{
  gmds_complex cells;
  gmds_complex_init(&cells, s->memory(m), 0);
  gmds_status status = GMDS_OK;
  for (int ij = 0; ij < 16 && status == GMDS_OK; ij++) {
    gmds_csr csr;
    gmds_csr_init(&csr, s->memory(m));
    status = s->relate(m, ij / 4, ij % 4, &cells, &csr);
    if (status != GMDS_OK && csr.begin)
      ck_abort_msg("%s: a relation is left behind", s->name);
    if (status == GMDS_OK && b)
      brute_check_relation(b, &cells, ij / 4, ij % 4, &csr);
    gmds_csr_clear(&csr);
  }
  gmds_complex_clear(&cells);
  return status;
}

enum { BOUND, PART, LOOK, MEASURE, RELATE, SOFTEN, N_CALLS };

static gmds_status call(const subject *s, void *m, int which, const brute *b, outcome *o)
{
  switch (which) {
  case BOUND:
    return s->bound(m, &o->faces, &o->on);
  case PART:
    return s->part(m, o->component, &o->count);
  case LOOK:
    return s->look(m, &o->report);
  case MEASURE:
    return s->measure(m, o->values, o->sizes, &o->summary);
  case RELATE:
    return relate_all(s, m, b);
  default:
    return s->soften(m, SWEEPS, &o->moved);
  }
}

static int is_untouched(const subject *s, void *m, const gmds_soup *soup, const outcome *o)
{
  return !o->faces.begin && !o->on.n && !o->component[0] && !o->count && !o->report.regions && o->values[0] == 0 &&
         !o->summary.cells && memcmp(s->points(m), soup->points, 3 * soup->n_points * sizeof(double)) == 0;
}

/* Runs all of them on the regions of a soup. With `inject` each call is repeated with one more allocation granted until
 * it succeeds, and in between nothing has changed. */
static void run(const subject *s, const gmds_soup *soup, const brute *b, int inject, outcome *o)
{
  void *m = malloc(s->bytes);
  gmds_error error = {.status = GMDS_OK};
  failing from = {.until = LONG_MAX};
  const gmds_allocator allocator = failing_allocator(&from);
  s->begin(m, &allocator);
  ck_assert_msg(s->fill(m, soup, &error) == GMDS_OK, "%s: %s", s->name, error.text);
  const size_t live = from.live;
  for (int which = 0; which < N_CALLS; which++) {
    gmds_status status = GMDS_ERR_MEMORY;
    int untouched = 1;
    outcome own;
    outcome_begin(&own, soup);
    for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
      from.until = k;
      status = call(s, m, which, b, inject ? &own : o);
      untouched &= status == GMDS_OK || is_untouched(s, m, soup, &own);
      untouched &= from.live == live || !inject;
    }
    ck_assert_msg(untouched, "%s: call %d leaves something behind", s->name, which);
    ck_assert_int_eq(status, GMDS_OK);
    outcome_end(&own);
  }
  from.until = LONG_MAX;
  if (soup->n_points)
    memcpy(o->points, s->points(m), 3 * soup->n_points * sizeof(double));
  ck_assert_msg(s->verify(m, &o->memory, &error) == GMDS_OK, "%s: %s", s->name, error.text);
  s->end(m);
  ck_assert_uint_eq(from.live, 0);
  free(m);
}

/* ---- claims */

static void check_boundary(const brute *b, const subject *s, const outcome *o)
{
  size_t bare = 0;
  double volume = 0;
  for (size_t w = 0; w < b->n_walls; w++)
    bare += b->on[b->group[w]] == 1;
  ck_assert_uint_eq(o->faces.n, bare);
  ck_assert_uint_eq(o->on.n, 2 * bare);
  for (size_t f = 0; f < o->faces.n; f++) {
    const gmds_id *nodes = o->faces.data + o->faces.begin[f], r = o->on.data[2 * f], k = o->on.data[2 * f + 1];
    const size_t n = o->faces.begin[f + 1] - o->faces.begin[f], w = brute_wall(b, r, n, nodes);
    ck_assert_msg(w < b->n_walls, "%s: face %zu is none of region %lu", s->name, f, (unsigned long)r);
    ck_assert_uint_eq(b->on[b->group[w]], 1);
    if (b->type[r] != GMDS_POLYHEDRON)
      ck_assert_msg(brute_same_cycle(&b->wall[w], nodes), "%s: face %zu is turned", s->name, f);
    if (s->ordered)
      ck_assert_uint_eq(b->first[r] + k, w);
    ck_assert(!f || r > o->on.data[2 * f - 2] || (r == o->on.data[2 * f - 2] && k > o->on.data[2 * f - 1]));
    volume += brute_cone(b, n, nodes);
  }
  ck_assert_double_eq_tol(volume, o->summary.size, 1e-9 * (1 + fabs(volume)));
}

static void check_components(const brute *b, const outcome *o)
{
  gmds_id *number = malloc((b->n_regions + 1) * sizeof *number);
  ck_assert_uint_eq(brute_components(b, number), o->count);
  ck_assert_int_eq(memcmp(number, o->component, b->n_regions * sizeof *number), 0);
  free(number);
}

static void check_finding(const gmds_finding *f, size_t count, gmds_id first, gmds_id second)
{
  ck_assert_uint_eq(f->count, count);
  ck_assert_uint_eq(f->first[0], first);
  if (second != GMDS_NONE)
    ck_assert_uint_eq(f->first[1], second);
}

static void check_manifold(const brute *b, const outcome *o)
{
  const gmds_volume_report *r = &o->report;
  size_t border = 0, crowded = 0, faces = 0, pinched = 0, used = 0;
  gmds_id first = GMDS_NONE;
  for (size_t w = b->n_walls; w-- > 0;) {
    faces += b->group[w] == w;
    border += b->on[b->group[w]] == 1;
    crowded += b->group[w] == w && b->on[w] > 2;
    first = b->on[b->group[w]] == 1 ? (gmds_id)b->owner[w] : first;
  }
  check_finding(&r->border, border, first, GMDS_NONE);
  ck_assert_uint_eq(r->crowded.count, crowded);
  ck_assert_uint_eq(r->regions, b->n_regions);
  ck_assert_uint_eq(r->faces, faces);
  first = GMDS_NONE;
  for (gmds_id v = (gmds_id)b->n_nodes; v-- > 0;) {
    const size_t fans = brute_fans(b, v, GMDS_NONE);
    used += fans > 0;
    pinched += fans > 1;
    first = fans > 1 ? v : first;
  }
  check_finding(&r->pinched_nodes, pinched, first, GMDS_NONE);
  ck_assert_uint_eq(r->nodes, used);
  gmds_id second = GMDS_NONE;
  first = GMDS_NONE;
  pinched = used = 0;
  for (gmds_id v = (gmds_id)b->n_nodes; v-- > 0;)
    for (gmds_id x = (gmds_id)b->n_nodes; x-- > v + 1;) {
      const size_t fans = brute_fans(b, v, x);
      used += fans > 0;
      pinched += fans > 1;
      first = fans > 1 ? v : first;
      second = fans > 1 ? x : second;
    }
  check_finding(&r->pinched_edges, pinched, first, second);
  ck_assert_uint_eq(r->edges, used);
  ck_assert_int_eq(r->manifold, !r->crowded.count && !r->pinched_nodes.count && !pinched);
  ck_assert_uint_eq(r->surface.faces, border);
  ck_assert_uint_eq(r->turned.count + r->surface.turned.count + r->surface.border.count, 0);
}

/* Which corners of a region turn which way at node v: of its edges there, in their order. */
static int turn_of(const brute *b, const double *points, size_t r, unsigned v)
{
  const gmds_shape *s = gmds_shape_of(b->type[r]);
  const double *p[4] = {points + 3 * (size_t)b->nodes[r][v]};
  size_t n = 1;
  for (unsigned e = 0; e < s->edges && n < 5; e++)
    for (int i = 0; i < 2; i++)
      if (s->edge[e][i] == v && n++ < 4)
        p[n - 1] = points + 3 * (size_t)b->nodes[r][s->edge[e][!i]];
  return n == 4 ? gmds_orient3d(p[0], p[1], p[2], p[3]) : 0;
}

static int keeps(const brute *b, const double *before, const double *after)
{
  for (size_t r = 0; r < b->n_regions; r++)
    for (unsigned v = 0; b->type[r] != GMDS_POLYHEDRON && v < gmds_shape_of(b->type[r])->nodes; v++) {
      const int turn = turn_of(b, before, r, v);
      if (turn && turn_of(b, after, r, v) != turn)
        return 0;
    }
  return 1;
}

static void check_smoothing(const brute *b, const gmds_soup *soup, const outcome *o)
{
  const size_t bytes = 3 * soup->n_points * sizeof(double);
  double *x = malloc(bytes), *old = malloc(bytes);
  size_t moved = 0;
  if (bytes)
    memcpy(x, soup->points, bytes);
  for (int sweep = 0; sweep < SWEEPS; sweep++) {
    moved = 0;
    for (gmds_id v = 0; v < b->n_nodes; v++) {
      size_t joined = 0;
      double mean[3] = {0, 0, 0};
      if (!brute_is_inner(b, v))
        continue;
      for (gmds_id y = 0; y < b->n_nodes; y++)
        joined += brute_fans(b, v, y) > 0;
      for (gmds_id y = 0; y < b->n_nodes; y++)
        for (size_t d = 0; d < 3 && brute_fans(b, v, y); d++)
          mean[d] += x[3 * y + d] / (double)joined;
      memcpy(old, x, bytes);
      memcpy(x + 3 * v, mean, sizeof mean);
      if (!keeps(b, old, x))
        memcpy(x, old, bytes);
      moved += memcmp(x, old, bytes) != 0;
    }
  }
  ck_assert_int_eq(memcmp(x, o->points, bytes), 0);
  ck_assert_uint_eq(moved, o->moved);
  free(x);
  free(old);
}

static void models_agree(const outcome *a, const outcome *b, size_t n)
{
  for (size_t r = 0; r < n; r++) {
    ck_assert_double_eq_tol(a->values[r], b->values[r], 1e-12);
    ck_assert_double_eq_tol(a->sizes[r], b->sizes[r], 1e-12 * (1 + fabs(a->sizes[r])));
  }
  ck_assert_uint_eq(a->summary.inverted, b->summary.inverted);
  ck_assert_double_eq_tol(a->summary.mean, b->summary.mean, 1e-12);
  ck_assert_uint_eq(a->report.inverted.count, b->report.inverted.count);
  ck_assert_uint_eq(a->report.degenerate.count, b->report.degenerate.count);
  ck_assert_uint_eq(a->report.surface.sides, b->report.surface.sides);
  ck_assert_uint_eq(a->report.surface.crowded.count, b->report.surface.crowded.count);
  ck_assert_uint_eq(a->report.surface.pinched.count, b->report.surface.pinched.count);
  ck_assert_uint_eq(a->moved, b->moved);
  ck_assert_int_eq(memcmp(a->points, b->points, 3 * a->n_points * sizeof(double)), 0);
}

/* Everything, in every model that holds the regions: from subject `begin` on. */
static void all_models_agree(const gmds_soup *soup, size_t begin, int inject)
{
  static outcome first, other;
  brute b;
  brute_begin(&b, soup);
  for (size_t k = begin; k < N_SUBJECTS; k++) {
    outcome *o = k == begin ? &first : &other;
    outcome_begin(o, soup);
    run(subjects[k], soup, inject || b.n_regions > 60 ? NULL : &b, inject, o);
    if (!inject) {
      check_boundary(&b, subjects[k], o);
      check_components(&b, o);
      check_manifold(&b, o);
      if (k == begin)
        check_smoothing(&b, soup, o);
      models_agree(&first, o, soup->n_cells);
    }
    if (k != begin)
      outcome_end(o);
  }
  outcome_end(&first);
  brute_end(&b);
}

static void run_one(const gmds_soup *soup, size_t k, outcome *o)
{
  outcome_begin(o, soup);
  run(subjects[k], soup, NULL, 0, o);
}

/* ---- meshes */

static gmds_id add(gmds_soup *s, double x, double y, double z)
{
  const double p[3] = {x, y, z};
  ck_assert_int_eq(gmds_soup_add_point(s, p), GMDS_OK);
  return (gmds_id)(s->n_points - 1);
}

static void add_region(gmds_soup *s, gmds_cell_type type, size_t n, const gmds_id *nodes)
{
  ck_assert_int_eq(gmds_soup_add_cell(s, type, n, nodes), GMDS_OK);
}

/* The hexahedron as a polyhedron, each of its faces turned and begun anywhere. */
static void add_as_polyhedron(gmds_soup *s, const gmds_id *v, uint64_t *seed)
{
  const gmds_shape *shape = gmds_shape_of(GMDS_HEXAHEDRON);
  gmds_id stream[31] = {6};
  size_t n = 1;
  for (size_t k = 0; k < 6; k++) {
    const size_t from = random_below(seed, 4), by = random_below(seed, 2) ? 1 : 3;
    stream[n++] = 4;
    for (size_t q = 0; q < 4; q++)
      stream[n++] = v[shape->face[k][(from + q * by) % 4]];
  }
  add_region(s, GMDS_POLYHEDRON, n, stream);
}

static void add_cell(gmds_soup *s, const gmds_id *v, int kind, uint64_t *seed)
{
  const gmds_shape *shape = gmds_shape_of(GMDS_HEXAHEDRON);
  const gmds_id prisms[2][6] = {{v[0], v[1], v[2], v[4], v[5], v[6]}, {v[0], v[2], v[3], v[4], v[6], v[7]}};
  const size_t what = kind ? random_below(seed, kind == 1 ? 4u : 5u) : 3;
  if (what == 0)
    for (int k = 0; k < 2; k++)
      add_region(s, GMDS_PRISM, 6, prisms[k]);
  else if (what == 1) {
    double c[3] = {0, 0, 0};
    for (size_t i = 0; i < 24; i++)
      c[i % 3] += s->points[3 * v[i / 3] + i % 3] / 8;
    const gmds_id apex = add(s, c[0], c[1], c[2]);
    for (size_t k = 0; k < 6; k++) {
      const uint8_t *f = shape->face[k];
      const gmds_id pyramid[5] = {v[f[3]], v[f[2]], v[f[1]], v[f[0]], apex};
      const gmds_id halves[2][4] = {{v[f[3]], v[f[2]], v[f[1]], apex}, {v[f[3]], v[f[1]], v[f[0]], apex}};
      if (random_below(seed, 3))
        add_region(s, GMDS_PYRAMID, 5, pyramid);
      else
        for (int i = 0; i < 2; i++)
          add_region(s, GMDS_TETRAHEDRON, 4, halves[i]);
    }
  } else if (what == 4)
    add_as_polyhedron(s, v, seed);
  else
    add_region(s, GMDS_HEXAHEDRON, 8, v);
}

/* n cubed cells, shaken; some are left out where that is little; kind 0: hexahedra, 1: all types, 2: polyhedra too. */
static void make_grid(gmds_soup *s, gmds_id n, int kind, double shake, uint64_t seed)
{
  gmds_soup_init(s, &memory, 3);
  for (gmds_id p = 0; p < (n + 1) * (n + 1) * (n + 1); p++)
    add(s, p % (n + 1) + shake * random_unit(&seed), p / (n + 1) % (n + 1) + shake * random_unit(&seed),
        p / (n + 1) / (n + 1) + shake * random_unit(&seed));
  for (gmds_id c = 0; c < n * n * n; c++) {
    const gmds_id up = (n + 1) * (n + 1), a = c / n / n * up + c / n % n * (n + 1) + c % n, b = a + n + 1;
    const gmds_id v[8] = {a, a + 1, b + 1, b, a + up, a + 1 + up, b + 1 + up, b + up};
    if (shake > 0.5 || random_below(&seed, 4))
      add_cell(s, v, kind, &seed);
  }
}

/* Each cube of a grid as six tetrahedra around a diagonal, or some of them. */
static void make_tetrahedra(gmds_soup *s, gmds_id n, double shake, uint64_t seed)
{
  static const uint8_t paths[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                      {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  gmds_soup hexahedra;
  make_grid(&hexahedra, n, 0, shake, seed);
  gmds_soup_init(s, &memory, 3);
  for (size_t p = 0; p < hexahedra.n_points; p++)
    add(s, hexahedra.points[3 * p], hexahedra.points[3 * p + 1], hexahedra.points[3 * p + 2]);
  for (size_t c = 0; c < hexahedra.n_cells; c++)
    for (size_t k = 0; k < 6; k++) {
      gmds_id v[4];
      for (size_t i = 0; i < 4; i++)
        v[i] = hexahedra.corners[hexahedra.begin[c] + paths[k][i]];
      if (shake > 0.5 || random_below(&seed, 9))
        add_region(s, GMDS_TETRAHEDRON, 4, v);
    }
  gmds_soup_clear(&hexahedra);
}

static size_t begin_of_kind(int kind)
{
  return kind == 2 ? WITH_POLYHEDRA : N_TETRAHEDRAL;
}

START_TEST(small_meshes_are_as_brute_force_has_them)
{
  gmds_memory_init(&memory, NULL);
  for (uint64_t seed = 1; seed <= 2; seed++) {
    gmds_soup s;
    for (int kind = 0; kind < 3; kind++) {
      make_grid(&s, 3, kind, 0.2, seed);
      all_models_agree(&s, begin_of_kind(kind), 0);
      gmds_soup_clear(&s);
    }
    make_tetrahedra(&s, 2, 0.15, seed);
    all_models_agree(&s, 0, 0);
    gmds_soup_clear(&s);
  }
}
END_TEST

/* Where cells are tangled enough that the mean would turn a corner. */
START_TEST(smoothing_turns_no_corner)
{
  gmds_memory_init(&memory, NULL);
  for (uint64_t seed = 1; seed <= 6; seed++) {
    gmds_soup s;
    outcome o;
    brute b;
    if (seed % 2)
      make_grid(&s, 3, 1, 0.9, seed);
    else
      make_tetrahedra(&s, 3, 0.8, seed);
    brute_begin(&b, &s);
    run_one(&s, N_TETRAHEDRAL, &o);
    ck_assert(keeps(&b, s.points, o.points) && memcmp(s.points, o.points, 3 * s.n_points * sizeof(double)));
    if (seed < 4)
      check_smoothing(&b, &s, &o);
    outcome_end(&o);
    brute_end(&b);
    gmds_soup_clear(&s);
  }
}
END_TEST

START_TEST(a_failing_call_changes_nothing)
{
  gmds_soup s;
  gmds_memory_init(&memory, NULL);
  for (int kind = 0; kind < 3; kind++) {
    make_grid(&s, 2, kind, 0.1, 3);
    all_models_agree(&s, begin_of_kind(kind), 1);
    gmds_soup_clear(&s);
  }
  make_tetrahedra(&s, 1, 0.1, 3);
  all_models_agree(&s, 0, 1);
  gmds_soup_clear(&s);
}
END_TEST

START_TEST(an_empty_mesh_has_nothing_to_report)
{
  gmds_soup s;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&s, &memory, 3);
  all_models_agree(&s, 0, 0);
  add(&s, 1, 2, 3);
  all_models_agree(&s, 0, 0);
  gmds_soup_clear(&s);
}
END_TEST

/* ---- single cells */

static const double ideal[][8][3] = {
    {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
    {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {{0, 0, 0}, {1, 0, 0}, {0.5, 0.86602540378443865, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, 0.86602540378443865, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

static void make_ideal(gmds_soup *s, gmds_cell_type type)
{
  static const gmds_id order[] = {0, 1, 2, 3, 4, 5, 6, 7}, turned[] = {0, 2, 1, 3};
  const size_t n = gmds_shape_of(type)->nodes;
  gmds_soup_init(s, &memory, 3);
  for (size_t v = 0; v < n; v++)
    add(s, ideal[type - GMDS_TETRAHEDRON][v][0], ideal[type - GMDS_TETRAHEDRON][v][1],
        ideal[type - GMDS_TETRAHEDRON][v][2]);
  add_region(s, type, n, type == GMDS_TETRAHEDRON ? turned : order);
}

START_TEST(ideal_cells_measure_one)
{
  static const double volumes[] = {8.0 / 3, 2.0 / 3, 0.43301270189221932, 1};
  gmds_memory_init(&memory, NULL);
  for (int type = GMDS_TETRAHEDRON; type <= GMDS_HEXAHEDRON; type++)
    for (size_t k = N_TETRAHEDRAL; k < N_SUBJECTS; k++) {
      gmds_soup s;
      outcome o;
      make_ideal(&s, (gmds_cell_type)type);
      run_one(&s, k, &o);
      ck_assert_double_eq_tol(o.values[0], 1, 1e-14);
      ck_assert_double_eq_tol(o.sizes[0], volumes[type - GMDS_TETRAHEDRON], 1e-14);
      ck_assert_uint_eq(o.summary.bins[9] + o.summary.bins[8], 1);
      ck_assert_uint_eq(o.report.inverted.count + o.report.degenerate.count, 0);
      ck_assert(o.report.manifold && o.report.surface.closed && o.report.surface.orientable);
      outcome_end(&o);
      gmds_soup_clear(&s);
    }
}
END_TEST

/* A tetrahedron of edges 1, 1, 1, sqrt(2), ... at the corner of a cube: 12 (1/2)^(2/3) / 9; a cube as a polyhedron. */
START_TEST(other_cells_measure_what_formulas_say)
{
  gmds_soup s;
  outcome o;
  uint64_t seed = 5;
  const gmds_id v[] = {0, 1, 3, 4};
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 20; round++) {
    make_ideal(&s, GMDS_HEXAHEDRON);
    const gmds_id all[] = {0, 1, 2, 3, 4, 5, 6, 7};
    s.n_cells = 0;
    add_as_polyhedron(&s, all, &seed);
    run_one(&s, WITH_POLYHEDRA, &o);
    ck_assert_double_eq_tol(o.values[0], 3.14159265358979323846 / 6, 1e-14);
    ck_assert_double_eq_tol(o.sizes[0], 1, 1e-14);
    ck_assert(o.report.surface.closed && !o.report.surface.turned.count);
    outcome_end(&o);
    gmds_soup_clear(&s);
  }
  make_ideal(&s, GMDS_HEXAHEDRON);
  s.n_cells = 0;
  add_region(&s, GMDS_TETRAHEDRON, 4, v);
  run_one(&s, 0, &o);
  ck_assert_double_eq_tol(o.values[0], 12 * pow(0.5, 2.0 / 3) / 9, 1e-14);
  ck_assert_double_eq_tol(o.sizes[0], 1.0 / 6, 1e-14);
  outcome_end(&o);
  gmds_soup_clear(&s);
}
END_TEST

START_TEST(inverted_and_flat_regions_are_found)
{
  gmds_memory_init(&memory, NULL);
  for (int type = GMDS_TETRAHEDRON; type <= GMDS_HEXAHEDRON; type++)
    for (int flat = 0; flat < 2; flat++) {
      const double pushed[4][3] = {{-3, -3, -3}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
      const double laid[4][3] = {{-1, -1, -1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
      const gmds_id v[4] = {0, 4, 3, 4};
      gmds_soup s;
      outcome o;
      make_ideal(&s, (gmds_cell_type)type);
      const int t = type - GMDS_TETRAHEDRON;
      memcpy(s.points + 3 * v[t], flat ? laid[t] : pushed[t], sizeof laid[t]);
      if (flat && type == GMDS_TETRAHEDRON)
        memcpy(s.points, s.points + 3, sizeof laid[t]);
      run_one(&s, N_TETRAHEDRAL, &o);
      ck_assert_uint_eq(o.report.inverted.count, flat ? 0 : 1);
      ck_assert_uint_eq(o.report.degenerate.count, flat ? 1 : 0);
      ck_assert(flat ? fabs(o.values[0]) < 1e-15 : o.values[0] < -0.1);
      outcome_end(&o);
      gmds_soup_clear(&s);
    }
}
END_TEST

/* Three tetrahedra on one face, one of them listed the other way round, and one that only has an edge of it. */
START_TEST(faces_of_three_regions_and_turned_ones_are_found)
{
  static const gmds_id v[4][4] = {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 2, 1, 5}, {0, 1, 6, 7}};
  static const double x[][3] = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                {0, 0, -1}, {1, 1, -1}, {0, -1, 0}, {0, 0, -2}};
  for (int turned = 0; turned < 2; turned++)
    for (size_t k = 0; k < N_SUBJECTS; k++) {
      gmds_soup s;
      outcome o;
      brute b;
      if (k == 1 || k == 5 || k == 6 || k == 9 || (turned && !subjects[k]->ordered))
        continue; /* R2R holds two */
      gmds_memory_init(&memory, NULL);
      gmds_soup_init(&s, &memory, 3);
      for (size_t p = 0; p < 8; p++)
        add(&s, x[p][0], x[p][1], x[p][2]);
      for (size_t r = 0; r < 4; r++) {
        gmds_id w[4];
        memcpy(w, v[r], sizeof w);
        if (turned && r == 1) {
          w[1] = v[r][2];
          w[2] = v[r][1];
        }
        add_region(&s, GMDS_TETRAHEDRON, 4, w);
      }
      run_one(&s, k, &o);
      brute_begin(&b, &s);
      if (!turned)
        check_manifold(&b, &o);
      check_finding(&o.report.crowded, 1, 0, GMDS_NONE);
      check_finding(&o.report.pinched_edges, 1, 0, 1);
      check_finding(&o.report.inverted, (size_t)turned, turned ? 1 : GMDS_NONE, GMDS_NONE);
      ck_assert(!o.report.manifold);
      brute_end(&b);
      outcome_end(&o);
      gmds_soup_clear(&s);
    }
}
END_TEST

/* ---- new numbers */

/* The maps are one to one and go up along the least nodes, attributes have gone along, and region r of the one is
 * region map[r] of the other. */
static void check_numbers(const subject *s, void *m, const gmds_soup *soup, const gmds_soup *after, gmds_id **maps,
                          const size_t *end)
{
  for (int i = 0; i < 4; i++) {
    int *met = calloc(end[i] + 1, sizeof *met);
    const gmds_id *number = s->attribute(m, i)->data;
    ck_assert_uint_eq(s->end_of(m, i), end[i]);
    for (size_t c = 0; c < end[i]; c++) {
      ck_assert(maps[i][c] < end[i] && !met[maps[i][c]]++);
      ck_assert_uint_eq(number[maps[i][c]], c + 1);
    }
    free(met);
  }
  for (size_t v = 0; v < end[0]; v++)
    ck_assert_int_eq(memcmp(soup->points + 3 * v, after->points + 3 * maps[0][v], 3 * sizeof(double)), 0);
  const size_t first = after->n_cells - end[3]; /* behind the faces that bound nothing, of which there are none */
  gmds_id before = 0;
  for (size_t r = 0; r < end[3] && s->ordered; r++) {
    const size_t x = first + maps[3][r], n = soup->begin[r + 1] - soup->begin[r];
    ck_assert_int_eq(after->types[x], soup->types[r]);
    for (size_t k = 0; k < n; k++)
      ck_assert_uint_eq(after->corners[after->begin[x] + k], maps[0][soup->corners[soup->begin[r] + k]]);
  }
  for (size_t x = first; x < after->n_cells && s->ordered; x++) {
    gmds_id least = GMDS_NONE;
    for (size_t k = after->begin[x]; k < after->begin[x + 1]; k++)
      least = after->corners[k] < least ? after->corners[k] : least;
    ck_assert_uint_ge(least, before);
    before = least;
  }
}

static void renumber_one(const subject *s, const gmds_soup *soup, int inject, gmds_soup *after)
{
  void *m = malloc(s->bytes);
  gmds_error error = {.status = GMDS_OK};
  failing from = {.until = LONG_MAX};
  const gmds_allocator allocator = failing_allocator(&from);
  size_t end[4];
  gmds_id *maps[4];
  s->begin(m, &allocator);
  ck_assert_msg(s->fill(m, soup, &error) == GMDS_OK, "%s: %s", s->name, error.text);
  for (int i = 0; i < 4; i++) {
    end[i] = s->end_of(m, i);
    maps[i] = malloc((end[i] + 1) * sizeof *maps[i]);
    gmds_attribute *a = s->attribute(m, i);
    for (size_t c = 0; c < end[i]; c++)
      ((gmds_id *)a->data)[c] = (gmds_id)c + 1;
  }
  const size_t live = from.live;
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = s->number(m, maps);
    if (status != GMDS_OK && (from.live != live || s->memory(m)->live != live))
      ck_abort_msg("%s: renumbering leaves something behind", s->name);
  }
  from.until = LONG_MAX;
  ck_assert_int_eq(status, GMDS_OK);
  ck_assert_uint_eq(from.live, s->memory(m)->live);
  ck_assert_msg(s->verify(m, &memory, &error) == GMDS_OK, "%s: %s", s->name, error.text);
  gmds_soup_init(after, &memory, 3);
  ck_assert_int_eq(s->list(m, after), GMDS_OK);
  check_numbers(s, m, soup, after, maps, end);
  for (int i = 0; i < 4; i++)
    free(maps[i]);
  s->end(m);
  ck_assert_uint_eq(from.live, 0);
  free(m);
}

START_TEST(new_numbers_follow_the_curve_and_change_nothing_else)
{
  gmds_memory_init(&memory, NULL);
  for (int kind = 0; kind < 4; kind++) {
    gmds_soup s, after, first = {.n_points = 0};
    if (kind < 3)
      make_grid(&s, 3, kind, 0.3, 5);
    else
      make_tetrahedra(&s, 2, 0.3, 5);
    const size_t begin = kind < 3 ? begin_of_kind(kind) : 0;
    for (size_t k = begin; k < N_SUBJECTS; k++) {
      renumber_one(subjects[k], &s, 0, k == begin ? &first : &after);
      if (k == begin)
        continue;
      ck_assert_int_eq(memcmp(first.points, after.points, 3 * s.n_points * sizeof(double)), 0);
      gmds_soup_clear(&after);
    }
    double along = 0, listed = 0; /* the way from node to node has become short */
    for (size_t d = 3; d < 3 * s.n_points; d++) {
      along += fabs(first.points[d] - first.points[d - 3]);
      listed += fabs(s.points[d] - s.points[d - 3]);
    }
    ck_assert(along < listed);
    gmds_soup_clear(&first);
    gmds_soup_clear(&s);
  }
}
END_TEST

START_TEST(a_failing_renumbering_changes_nothing)
{
  gmds_soup s, after;
  gmds_memory_init(&memory, NULL);
  make_tetrahedra(&s, 1, 0.1, 3);
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    renumber_one(subjects[k], &s, 1, &after);
    gmds_soup_clear(&after);
  }
  gmds_soup_clear(&s);
}
END_TEST

START_TEST(renumbering_closes_holes)
{
  gmds_soup s;
  whole_mesh m;
  gmds_id *maps[4];
  uint64_t before = 0, after = 1;
  gmds_memory_init(&memory, NULL);
  make_grid(&s, 3, 1, 0.3, 8);
  whole_mesh_init(&m, NULL);
  ck_assert_int_eq(whole_from_soup(&m, &s, NULL), GMDS_OK);
  for (gmds_id r = 0; r < whole_end_3(&m); r += 3)
    ck_assert_int_eq(whole_remove_region(&m, r, GMDS_DROP_BARE), GMDS_OK);
  const size_t end[4] = {whole_end_0(&m), whole_end_1(&m), whole_end_2(&m), whole_end_3(&m)};
  for (int i = 0; i < 4; i++)
    maps[i] = malloc(end[i] * sizeof *maps[i]);
  ck_assert(whole_count_3(&m) < end[3] && whole_count_2(&m) < end[2] && whole_count_1(&m) < end[1]);
  ck_assert_int_eq(whole_checksum(&m, &memory, &before), GMDS_OK);
  ck_assert_int_eq(whole_renumber(&m, maps, NULL), GMDS_OK);
  ck_assert_int_eq(whole_check(&m, &memory, NULL), GMDS_OK);
  ck_assert_int_eq(whole_checksum(&m, &memory, &after), GMDS_OK);
  ck_assert_uint_eq(before, after);
  ck_assert(whole_count_3(&m) == whole_end_3(&m) && whole_count_2(&m) == whole_end_2(&m));
  for (size_t r = 0; r < end[3]; r++)
    ck_assert_int_eq(maps[3][r] == GMDS_NONE, r % 3 == 0);
  for (int i = 0; i < 4; i++)
    free(maps[i]);
  whole_mesh_clear(&m);
  gmds_soup_clear(&s);
}
END_TEST

/* ---- files */

static void load(const char *folder, const char *file, gmds_soup *s)
{
  char command[1200], name[80];
  const char *base = strrchr(file, '/') + 1, *packed = strstr(base, ".xz");
  const int length = packed ? (int)(packed - base) : (int)strlen(base);
  gmds_soup all;
  gmds_error error = {.status = GMDS_OK};
  snprintf(name, sizeof name, "space_%.*s", length, base);
  snprintf(command, sizeof command, packed ? "xz -dc '%s/%s' >%s" : "cp '%s/%s' %s", folder, file, name);
  ck_assert_int_eq(system(command), 0);
  gmds_soup_init(&all, &memory, 3);
  gmds_soup_init(s, &memory, 3);
  ck_assert_msg(gmds_read_soup(name, 0, &error, &all) == GMDS_OK, "%s", error.text);
  remove(name);
  for (size_t p = 0; p < all.n_points; p++)
    add(s, all.points[3 * p], all.points[3 * p + 1], all.points[3 * p + 2]);
  for (size_t c = 0; c < all.n_cells; c++)
    if (gmds_cell_type_dimension((gmds_cell_type)all.types[c]) == 3)
      add_region(s, (gmds_cell_type)all.types[c], all.begin[c + 1] - all.begin[c], all.corners + all.begin[c]);
  gmds_soup_clear(&all);
}

START_TEST(real_meshes_are_as_their_census_says)
{
  static const struct {
    const char *file;
    size_t nodes, edges, faces, regions, border;
    long surface; /* the Euler characteristic of the boundary */
    int tetrahedra;
  } files[] = {{"volumes/gmds_tet_in_box.vtk", 29, 113, 146, 61, 48, 2, 1},
               {"volumes/gmds_B80.vtk.xz", 749, 4111, 6195, 2832, 1062, 2, 1},
               {"volumes/mfem_homology.asc.v22.msh.xz", 1961, 10821, 16252, 7392, 2936, 0, 1},
               {"volumes/polyfem_microstructure_P1.msh.xz", 1585, 8890, 13709, 6414, 1762, -20, 1},
               {"volumes/hexsmoothing_mixedElementMesh.vtk.xz", 1201, 3916, 4344, 1628, 697, 2, 0},
               {"volumes/cinolib_rockerarm_hex.mesh.xz", 12751, 35989, 33838, 10600, 4076, 0, 0}};
  const char *folder = data_folder("real meshes of volumes");
  for (size_t f = 0; folder && f < sizeof files / sizeof *files; f++)
    for (size_t k = files[f].tetrahedra ? 0 : N_TETRAHEDRAL; k < N_SUBJECTS; k++) {
      gmds_soup s;
      outcome o;
      gmds_memory_init(&memory, NULL);
      load(folder, files[f].file, &s);
      run_one(&s, k, &o);
      const gmds_volume_report *r = &o.report;
      ck_assert_uint_eq(r->nodes, files[f].nodes);
      ck_assert_uint_eq(r->edges, files[f].edges);
      ck_assert_uint_eq(r->faces, files[f].faces);
      ck_assert_uint_eq(r->regions, files[f].regions);
      ck_assert_uint_eq(r->border.count, files[f].border);
      ck_assert_uint_eq(o.faces.n, files[f].border);
      ck_assert_int_eq((long)r->surface.nodes - (long)r->surface.sides + (long)r->surface.faces, files[f].surface);
      ck_assert(r->manifold && r->surface.closed && r->surface.orientable && !r->surface.turned.count);
      ck_assert_uint_eq(o.count, 1);
      outcome_end(&o);
      gmds_soup_clear(&s);
    }
}
END_TEST

RUN_SUITE("algorithms in space", small_meshes_are_as_brute_force_has_them, smoothing_turns_no_corner,
          a_failing_call_changes_nothing, an_empty_mesh_has_nothing_to_report, ideal_cells_measure_one,
          other_cells_measure_what_formulas_say, inverted_and_flat_regions_are_found,
          faces_of_three_regions_and_turned_ones_are_found, new_numbers_follow_the_curve_and_change_nothing_else,
          a_failing_renumbering_changes_nothing, renumbering_closes_holes, real_meshes_are_as_their_census_says)
