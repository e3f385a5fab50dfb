/* gmds sweep: one Bowyer-Watson text over many models, each in a process of its own so that one's crash or memory is
 * not the others'. */
#define _DEFAULT_SOURCE
#include "command.h"
#include "file.h"
#include <gmds/named.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

/* The 17 models of Table 4 of [models] with its bytes for 1225 points, in its order. */
typedef struct table4_row {
  const char *mask;
  size_t bytes;
} table4_row;
static const table4_row table4[] = {{"F|N|N2F|F2N", 2334720},
                                    {"F|N|N2F|F2N|F2F", 2342912},
                                    {"F|E|N|F2N|N2F|F2E", 3526656},
                                    {"F|E|N|F2N|N2F|F2E|F2F", 3547136},
                                    {"F|E|N|F2E|E2F|F2N|N2F", 4038656},
                                    {"F|E|N|F2N|N2F|N2E|E2F", 5672960},
                                    {"F|E|N|F2N|N2F|N2E|E2F|F2F", 5726208},
                                    {"F|E|N|F2N|N2F|E2N|N2E|F2E|F2F", 5332992},
                                    {"F|E|N|F2N|N2F|E2F|F2E|E2N|N2E|F2F", 5902336},
                                    {"F|N|N2F|F2F", 2314240},
                                    {"F|E|N|N2F|N2E|F2F", 5136384},
                                    {"F|N|N2F", 2289664},
                                    {"F|N|F2N", 942080},
                                    {"F|N|F2N|F2F", 987136},
                                    {"F|E|N|E2F|N2E", 4567040},
                                    {"F|E|N|F2E|E2N", 1454080},
                                    {"F|E|N|F2E|E2N|F2F", 1499136}};

typedef struct sweep {
  const char *points, *models, *expect, *csv, *plot;
  unsigned long jobs;
  int dim;
  model_choice *chosen;
  size_t n;
  sweep_row *rows; /* shared with the processes that run the models */
} sweep;

/* ---- which models */

/* Adds the models of volumes of a word: `named`, those of named.h and the one for Delaunay triangulations; `paths`, the
 * 64 that take every path. */
static gmds_status choose_volumes(sweep *s, gmds_error *error)
{
#define NAME(name, mask, why) #name,
  static const char *const named[] = {GMDS_NAMED_LIST(NAME) "N|R|R2N|R2R"};
#undef NAME
  if (strcmp(s->models, "named") == 0) {
    for (size_t k = 0; k < sizeof named / sizeof *named; k++)
      GMDS_TRY(find_model(named[k], 3, error, &s->chosen[s->n++]));
    return GMDS_OK;
  }
  unsigned masks[GMDS_PATH_MODELS];
  gmds_census_paths(masks);
  for (size_t k = 0; k < GMDS_PATH_MODELS; k++) {
    char text[128];
    gmds_mask_text(masks[k], sizeof text, text);
    GMDS_TRY(find_model(text, 3, error, &s->chosen[s->n++]));
  }
  return GMDS_OK;
}

static gmds_status choose_surfaces(sweep *s, gmds_error *error)
{
  size_t n_all = 0;
  const model_entry *const *models = all_models(&n_all);
  const int all = strcmp(s->models, "all") == 0;
  if (strcmp(s->models, "table4") == 0) {
    for (size_t k = 0; k < sizeof table4 / sizeof *table4; k++)
      GMDS_TRY(find_model(table4[k].mask, 2, error, &s->chosen[s->n++]));
    return GMDS_OK;
  }
  for (size_t k = 0; k < n_all; k++)
    if (models[k]->dim == 2 && (all || gmds_census_of(models[k]->mask, 2).paper105))
      choose_model(models[k], &s->chosen[s->n++]);
  return GMDS_OK;
}

static int is_word(const char *text, int dim)
{
  static const char *const words[] = {"all", "paper105", "table4", "named", "paths"};
  const size_t from = dim == 3 ? 3 : 0, to = dim == 3 ? 5 : 3;
  for (size_t k = from; k < to; k++)
    if (strcmp(text, words[k]) == 0)
      return 1;
  return 0;
}

static gmds_status choose(sweep *s, gmds_error *error)
{
  size_t n_all = 0;
  (void)all_models(&n_all);
  s->chosen = calloc(n_all + strlen(s->models) + 32, sizeof *s->chosen);
  if (!s->chosen)
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the list of models");
  if (is_word(s->models, s->dim))
    return s->dim == 3 ? choose_volumes(s, error) : choose_surfaces(s, error);
  if (is_word(s->models, 5 - s->dim))
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "--models %s is for --dim %d", s->models, 5 - s->dim);
  for (const char *at = s->models;; at++) {
    char text[512]; /* find_model() refuses what is half as long */
    size_t length = strcspn(at, ",");
    snprintf(text, sizeof text, "%.*s", length > 511 ? 511 : (int)length, at);
    GMDS_TRY(find_model(text, s->dim, error, &s->chosen[s->n]));
    s->n++;
    at += length;
    if (!*at)
      return GMDS_OK;
  }
}

/* ---- running */

static void run_model(const sweep *s, const gmds_soup *points, size_t k)
{
  sweep_row *row = &s->rows[k];
  gmds_error error = {.status = GMDS_OK};
  const model_task task = {
      .n = points->n_points, .xy = points->points, .owner = s->chosen[k].owner, .now = now, .error = &error};
  gmds_status status = s->chosen[k].runs->triangulate(&task, &row->report);
  char sum[32];
  snprintf(sum, sizeof sum, "%016llx", (unsigned long long)row->report.sum);
  row->points = points->n_points;
  row->ok = status == GMDS_OK && (!s->expect || strcmp(sum, s->expect) == 0);
  snprintf(row->status, sizeof row->status, "%s",
           status != GMDS_OK ? error.text
           : row->ok         ? "ok"
                             : "differs from the expected checksum");
}

/* Every process takes each J-th model. */
static void run_share(const sweep *s, const gmds_soup *points, size_t share)
{
  for (size_t k = share; k < s->n; k += s->jobs)
    run_model(s, points, k);
}

static void wait_for_all(void)
{
  while (wait(NULL) > 0 || errno == EINTR)
    ;
}

static int run_all(const sweep *s, const gmds_soup *points)
{
  fflush(NULL);
  for (size_t share = 0; share < s->jobs; share++) {
    pid_t child = fork();
    if (child < 0) {
      int code = failed("cannot start a process: %s", strerror(errno));
      wait_for_all();
      return code;
    }
    if (child == 0) {
      run_share(s, points, share);
      _exit(0);
    }
  }
  wait_for_all();
  return DONE;
}

/* ---- results */

static void print_row(FILE *file, const sweep_row *r, int csv)
{
  const char *form = csv ? r->ok ? "%s,%zu,%zu,%.6f,%zu,%zu,%016llx,%s\n" : "%s,%zu,%zu,%.6f,%zu,%zu,%016llx,\"%s\"\n"
                         : "%-36s %8zu %9zu %11.6f %11zu %11zu  %016llx  %s\n";
  fprintf(file, form, r->model, r->points, r->report.cells, r->report.seconds, r->report.bytes, r->report.peak_bytes,
          (unsigned long long)r->report.sum, r->status);
}

static gmds_status write_csv(const sweep *s, gmds_error *error)
{
  gmds_output output;
  GMDS_TRY(gmds_output_open(&output, s->csv, error));
  fputs("model,points,cells,seconds,bytes,peak_bytes,checksum,status\n", output.file);
  for (size_t k = 0; k < s->n; k++)
    print_row(output.file, &s->rows[k], 1);
  return gmds_output_close(&output, GMDS_OK, error);
}

static size_t print_table(const sweep *s)
{
  size_t ok = 0;
  printf("%-36s %8s %9s %11s %11s %11s  %-16s  %s\n", "model", "points", "cells", "seconds", "bytes", "peak_bytes",
         "checksum", "status");
  for (size_t k = 0; k < s->n; k++) {
    print_row(stdout, &s->rows[k], 0);
    ok += (size_t)s->rows[k].ok;
  }
  if (s->expect)
    printf("%zu of %zu models ok: the checksum is %s\n", ok, s->n, s->expect);
  else
    printf("%zu of %zu models ok\n", ok, s->n);
  return ok;
}

/* Without an expected checksum the models must at least agree with the first. */
static void compare_rows(sweep *s)
{
  for (size_t k = 1; k < s->n && !s->expect; k++)
    if (s->rows[k].ok && s->rows[0].ok && s->rows[k].report.sum != s->rows[0].report.sum) {
      s->rows[k].ok = 0;
      snprintf(s->rows[k].status, sizeof s->rows[k].status, "differs from the first model");
    }
}

static int report(sweep *s)
{
  gmds_error error = {.status = GMDS_OK};
  compare_rows(s);
  size_t ok = print_table(s);
  if (s->csv && write_csv(s, &error) != GMDS_OK)
    return failed("%s", error.text);
  if (s->plot && write_plot(s->plot, s->rows, s->n, &error) != GMDS_OK)
    return failed("%s", error.text);
  return ok == s->n ? DONE : failed("%zu of %zu models failed or differ", s->n - ok, s->n);
}

/* Whether a file can be written: better known before the sweep than after it. */
static gmds_status try_output(const char *path, gmds_error *error)
{
  gmds_output output;
  if (!path)
    return GMDS_OK;
  GMDS_TRY(gmds_output_open(&output, path, error));
  (void)gmds_output_close(&output, GMDS_ERR_CANCELLED, NULL);
  return GMDS_OK;
}

static int run_sweep(sweep *s)
{
  gmds_error error = {.status = GMDS_OK};
  gmds_memory memory;
  gmds_soup points;
  int code = FAILED;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&points, &memory, s->dim);
  if (choose(s, &error) != GMDS_OK || try_output(s->csv, &error) != GMDS_OK || try_output(s->plot, &error) != GMDS_OK ||
      gmds_make_points(s->points, s->dim, &error, &points) != GMDS_OK) {
    code = failed("%s", error.text);
    goto end;
  }
  s->rows = mmap(NULL, s->n * sizeof *s->rows, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (s->rows == MAP_FAILED) {
    code = failed("out of memory for %zu rows", s->n);
    goto end;
  }
  for (size_t k = 0; k < s->n; k++) {
    memcpy(s->rows[k].model, s->chosen[k].name, sizeof s->rows[k].model);
    snprintf(s->rows[k].status, sizeof s->rows[k].status, "the process that ran it died");
  }
  code = run_all(s, &points);
  if (code == DONE)
    code = report(s);
  munmap(s->rows, s->n * sizeof *s->rows);
end:
  gmds_soup_clear(&points);
  free(s->chosen);
  return code;
}

static int is_checksum(const char *text)
{
  return strlen(text) == 16 && strspn(text, "0123456789abcdef") == 16;
}

static int run(const verb *v, int argc, char **argv)
{
  sweep s = {.points = "random:1225:1"};
  const char *dim = "2", *jobs = "1";
  const option options[] = {
      {"points", 0, &s.points, NULL, "SPEC  random:N:SEED, grid:N, circle:N, clusters:N:SEED or a file"},
      {"models", 0, &s.models, NULL,
       "all | paper105 | table4 | masks and cmap with commas between, MASK +X2Y borrows (default all); "
       "--dim 3: named | paths | masks, cmap and names F1 to F6, R1 to R4 (default named)"},
      {"dim", 0, &dim, NULL, "2|3  dimension (default 2)"},
      {"expect", 0, &s.expect, NULL, "SUM  16 hexadecimal digits that every checksum must equal"},
      {"csv", 0, &s.csv, NULL, "FILE  the table as CSV"},
      {"plot", 0, &s.plot, NULL, "FILE.svg  time against bytes, one dot a model"},
      {"jobs", 0, &jobs, NULL, "J  models run at the same time (default 1; more disturb the times)"}};
  int code = read_arguments(v, argc, argv, options, sizeof options / sizeof *options, NULL, 0, 0);
  if (code >= 0)
    return code;
  unsigned long number = 0;
  if (!read_number(dim, 2, 3, &number))
    return misused(v, "--dim is 2 or 3, not '%s'", dim);
  s.dim = (int)number;
  if (!s.models)
    s.models = s.dim == 3 ? "named" : "all";
  if (!read_number(jobs, 1, 1024, &s.jobs))
    return misused(v, "--jobs is a number from 1, not '%s'", jobs);
  if (s.expect && strchr(s.expect, '\n'))
    return misused(v, "--expect takes one checksum, not several lines that begin with '%.*s'",
                   (int)strcspn(s.expect, "\n"), s.expect);
  if (s.expect && !is_checksum(s.expect))
    return misused(v, "--expect takes 16 hexadecimal digits in lower case, not '%s'", s.expect);
  if (s.plot && !is_svg(s.plot))
    return misused(v, "--plot writes SVG: '%s' does not end in .svg", s.plot);
  if (s.plot && s.csv && strcmp(s.plot, s.csv) == 0)
    return misused(v, "--csv and --plot name the same file");
  return run_sweep(&s);
}

const verb verb_sweep = {"sweep",
                         "[--points SPEC] [--models LIST] [--dim 2|3] [--expect SUM] [--csv FILE] [--plot FILE.svg] "
                         "[--jobs J]",
                         "one Bowyer-Watson text over many mesh models: time and memory of each, results compared",
                         run};
