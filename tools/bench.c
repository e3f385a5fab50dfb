/* gmds bench: how long the work on cells takes in a model; how long a predicate takes. */
#include "command.h"
#include <gmds/predicates.h>
#include <stdlib.h>
#include <string.h>

static double median(int n, double *x)
{
  for (int i = 1; i < n; i++)
    for (int j = i; j > 0 && x[j - 1] > x[j]; j--) {
      double swap = x[j];
      x[j] = x[j - 1];
      x[j - 1] = swap;
    }
  return x[n / 2];
}

/* ---- cells: a grid of n × n squares, each cut in two */

typedef struct grid {
  size_t n_nodes, n_edges, n_triangles;
  double *xy;
  gmds_id *nodes;
} grid;

static gmds_status make_grid(size_t n, gmds_memory *memory, grid *g)
{
  void *xy = NULL, *nodes = NULL;
  size_t row = n + 1;
  *g = (grid){.n_nodes = row * row, .n_edges = 3 * n * n + 2 * n, .n_triangles = 2 * n * n};
  if (!gmds_resize(memory, &xy, 0, 2 * g->n_nodes, sizeof *g->xy))
    return GMDS_ERR_MEMORY;
  g->xy = xy;
  if (!gmds_resize(memory, &nodes, 0, 3 * g->n_triangles, sizeof *g->nodes))
    return GMDS_ERR_MEMORY;
  g->nodes = nodes;
  for (size_t v = 0; v < g->n_nodes; v++) {
    g->xy[2 * v] = (double)(v % row) / (double)n;
    g->xy[2 * v + 1] = (double)(v / row) / (double)n;
  }
  for (size_t s = 0; s < n * n; s++) {
    gmds_id a = (gmds_id)(s / n * row + s % n), b = a + 1, c = b + (gmds_id)row, d = a + (gmds_id)row;
    const gmds_id corners[6] = {a, b, c, a, c, d};
    memcpy(g->nodes + 6 * s, corners, sizeof corners);
  }
  return GMDS_OK;
}

static void free_grid(gmds_memory *memory, grid *g)
{
  gmds_release(memory, g->xy, g->xy ? 2 * g->n_nodes : 0, sizeof *g->xy);
  gmds_release(memory, g->nodes, g->nodes ? 3 * g->n_triangles : 0, sizeof *g->nodes);
}

/* What a grid must give; else a time would be that of something else. */
static int is_right(const grid *g, const cells_report *r)
{
  size_t t = g->n_triangles;
  return r->nodes == g->n_nodes && r->triangles == t && r->edges == g->n_edges && r->area > 1 - 1e-9 &&
         r->area < 1 + 1e-9 && r->marked == t / 2 && r->number_sum == (double)t * (double)(t - 1) / 2 &&
         (!r->done[CELLS_STARS] || (r->star_faces == 3 * t && r->star_sum == 3 * ((uint64_t)t * (t - 1) / 2)));
}

static const struct {
  cells_work work;
  const char *key, *text;
} works[] = {
    {CELLS_CONSTRUCT, "construct", "construct"},           {CELLS_AREA, "area", "areas of all faces"},
    {CELLS_STARS, "stars", "faces around all nodes"},      {CELLS_EDGES, "edges", "edges, E2N and F2E"},
    {CELLS_MARKS, "marks", "a mark set and read"},         {CELLS_ATTRIBUTES, "attributes", "a number written, read"},
    {CELLS_BULK, "construct_at_once", "construct at once"}};

/* In the models where a face alone would cost a traversal, construction is that of all faces at once. */
static cells_work work_of(const cells_report *r, size_t k)
{
  return works[k].work == CELLS_CONSTRUCT && !r->done[CELLS_CONSTRUCT] ? CELLS_BULK : works[k].work;
}

static void print_cells(const char *model, unsigned long n, cells_report *r, int json)
{
  const size_t n_works = sizeof works / sizeof *works;
  if (json) {
    printf("{\"model\":");
    json_text(stdout, model);
    printf(",\"n\":%lu,\"nodes\":%zu,\"edges\":%zu,\"triangles\":%zu,\"seconds\":{", n, r->nodes, r->edges,
           r->triangles);
  } else
    printf("%s, %lu x %lu squares: %zu nodes, %zu edges, %zu triangles\n%zu bytes, %zu at the peak\n", model, n, n,
           r->nodes, r->edges, r->triangles, r->bytes, r->peak_bytes);
  for (size_t k = 0; k < n_works; k++) {
    cells_work work = work_of(r, k);
    const char *comma = k ? "," : "";
    double seconds = r->done[work] ? median(r->done[work], r->seconds[work]) : 0;
    if (json && r->done[work])
      printf("%s\"%s\":%.9f", comma, works[k].key, seconds);
    else if (json)
      printf("%s\"%s\":null", comma, works[k].key);
    else if (r->done[work])
      printf("  %-24s %10.3f ms\n", works[k].text, 1e3 * seconds);
    else
      printf("  %-24s %13s\n", works[k].text, "none");
  }
  if (json)
    printf("},\"face_by_face\":%s,\"bytes\":%zu,\"peak_bytes\":%zu}\n", r->done[CELLS_CONSTRUCT] ? "true" : "false",
           r->bytes, r->peak_bytes);
}

static int bench_cells(const verb *v, const char *size, const char *model, int json)
{
  unsigned long n = 0;
  if (!size)
    return misused(v, "cells needs --n N");
  if (!read_number(size, 1, 20000, &n))
    return misused(v, "--n is a number from 1 to 20000, not '%s'", size);
  gmds_error error = {.status = GMDS_OK};
  model_choice choice;
  if (find_model(model, 2, &error, &choice) != GMDS_OK)
    return failed("%s", error.text);
  if (choice.owner)
    return failed("bench cells measures one model: '%s' borrows from another", choice.name);
  gmds_memory memory;
  grid g;
  static cells_report report;
  gmds_memory_init(&memory, NULL);
  gmds_memory_init(&report.memory, NULL);
  gmds_status status = make_grid(n, &memory, &g);
  if (status == GMDS_OK) {
    const cells_task task = {g.n_nodes, g.n_edges, g.n_triangles, g.xy, g.nodes, now};
    status = choice.runs->cells(&task, &report);
  }
  int right = status == GMDS_OK && is_right(&g, &report);
  free_grid(&memory, &g);
  if (status != GMDS_OK)
    return failed("a grid of %lu x %lu squares in model %s: %s", n, n, model, gmds_status_text(status));
  if (!right)
    return failed("a grid of %lu x %lu squares in model %s: an answer is wrong", n, n, model);
  print_cells(model, n, &report, json);
  return DONE;
}

/* ---- predicates: points at random in the unit square or cube, where the filters decide, and on a lattice, where a
 * call in twenty or so is degenerate */

enum { POINTS = 4096, CALLS = 1 << 20, REPETITIONS = 7, KINDS = 2 };

static uint64_t next_random(uint64_t *state)
{
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

/* Five points, of which each predicate takes as many as it needs. */
#define PREDICATE(name, ...)                \
  static int name(const double *const x[5]) \
  {                                         \
    return gmds_##name(__VA_ARGS__);        \
  }
PREDICATE(orient2d, x[0], x[1], x[2])
PREDICATE(incircle, x[0], x[1], x[2], x[3])
PREDICATE(incircle_perturbed, x[0], x[1], x[2], x[3])
PREDICATE(orient3d, x[0], x[1], x[2], x[3])
PREDICATE(insphere, x[0], x[1], x[2], x[3], x[4])
PREDICATE(insphere_perturbed, x[0], x[1], x[2], x[3], x[4])
#undef PREDICATE

static const struct {
  const char *name;
  size_t dim;
  int (*call)(const double *const x[5]);
} predicates[] = {{"orient2d", 2, orient2d}, {"incircle", 2, incircle}, {"incircle_perturbed", 2, incircle_perturbed},
                  {"orient3d", 3, orient3d}, {"insphere", 3, insphere}, {"insphere_perturbed", 3, insphere_perturbed}};

static const char *const kinds[KINDS] = {"uniform", "lattice"};

static volatile int sign_sum; /* so that the calls are made */

/* Nanoseconds a call, the median of several runs. */
static double time_predicate(size_t p, const double *points)
{
  const size_t dim = predicates[p].dim;
  double seconds[REPETITIONS];
  for (int r = 0; r < REPETITIONS; r++) {
    int sum = 0;
    double begin = now();
    for (size_t k = 0; k < CALLS; k++) {
      const double *x[5];
      for (size_t i = 0; i < 5; i++)
        x[i] = points + dim * ((k + i + (i == dim + 1 ? k / POINTS : 0)) % POINTS);
      sum += predicates[p].call(x);
    }
    seconds[r] = now() - begin;
    sign_sum = sum;
  }
  return 1e9 * median(REPETITIONS, seconds) / CALLS;
}

static int bench_predicates(int json)
{
  static double points[KINDS][3 * POINTS];
  uint64_t seed = 1;
  for (size_t k = 0; k < 3 * (size_t)POINTS; k++) {
    points[0][k] = (double)(next_random(&seed) >> 11) * 0x1p-53;
    points[1][k] = (double)(next_random(&seed) % 16) / 16;
  }
  gmds_status status = gmds_predicates_check();
  if (status != GMDS_OK)
    return failed("predicates: %s", gmds_status_text(status));
  const size_t n = sizeof predicates / sizeof *predicates;
  if (json)
    printf("{\"calls\":%d,\"nanoseconds\":{", CALLS);
  else
    printf("%-20s %10s %10s  nanoseconds a call\n", "", kinds[0], kinds[1]);
  for (size_t p = 0; p < n; p++) {
    double each[KINDS];
    for (int kind = 0; kind < KINDS; kind++)
      each[kind] = time_predicate(p, points[kind]);
    if (json)
      printf("%s\"%s\":{\"%s\":%.2f,\"%s\":%.2f}", p ? "," : "", predicates[p].name, kinds[0], each[0], kinds[1],
             each[1]);
    else
      printf("%-20s %10.2f %10.2f\n", predicates[p].name, each[0], each[1]);
  }
  if (json)
    printf("}}\n");
  return DONE;
}

static int run(const verb *v, int argc, char **argv)
{
  const char *what = NULL, *size = NULL, *model = NULL;
  int json = 0;
  const option options[] = {
      {"n", 0, &size, NULL, "N  cells: N x N squares, each cut into two triangles; hexgrid: N x N x N cubes"},
      {"model", 0, &model, NULL, "MASK|cmap  mesh model (default N|F|F2N|F2F)"},
      {"json", 0, NULL, &json, "print one JSON object"}};
  int code = read_arguments(v, argc, argv, options, 3, &what, 1, 1);
  if (code >= 0)
    return code;
  if (strcmp(what, "cells") == 0)
    return bench_cells(v, size, model ? model : "N|F|F2N|F2F", json);
  if (strcmp(what, "hexgrid") == 0)
    return model ? misused(v, "--model belongs to 'cells'") : bench_hexgrid(v, size, json);
  if (strcmp(what, "predicates") == 0)
    return size || model ? misused(v, "--%s belongs to 'cells'", size ? "n" : "model") : bench_predicates(json);
  return misused(v, "there is nothing called '%s' to measure", what);
}

const verb verb_bench = {
    "bench",
    "cells --n N [--model MASK] [--json]\n       gmds bench hexgrid --n N [--json]\n"
    "       gmds bench predicates [--json]",
    "times of the work on cells in a model, of a grid of hexahedra as a 3-map, and of the predicates", run};
