/* gmds homology: Betti numbers and generators of a surface. */
#include "command.h"
#include <gmds/homology.h>
#include <gmds/threads.h>
#include <string.h>

typedef struct timing {
  double last, build, step[GMDS_STEP_COUNT];
} timing;

static void note_step(void *user, gmds_homology_step step)
{
  timing *t = user;
  const double time = now();
  t->step[step] = time - t->last;
  t->last = time;
}

static const char *yes(int is)
{
  return is ? "true" : "false";
}

static void print_homology(const gmds_homology *h, const timing *t, int json)
{
  const double inner = t->step[GMDS_STEP_CLUSTERS] + t->step[GMDS_STEP_INNER];
  if (json) {
    printf("{\"vertices\":%zu,\"edges\":%zu,\"faces\":%zu,\"components\":%zu,\"closed\":%s,\"orientable\":%s,"
           "\"betti\":[%zu,%zu,%zu],"
           "\"seconds\":{\"build\":%.6f,\"inner\":%.6f,\"critical\":%.6f,\"dangling\":%.6f,\"contract\":%.6f},"
           "\"removed\":{\"inner\":%zu,\"critical\":%zu,\"border\":%zu,\"dangling\":%zu,\"contracted\":%zu}}\n",
           h->vertices, h->edges, h->faces, h->components, yes(h->closed), yes(h->orientable), h->betti[0], h->betti[1],
           h->betti[2], t->build, inner, t->step[GMDS_STEP_CRITICAL], t->step[GMDS_STEP_DANGLING],
           t->step[GMDS_STEP_CONTRACT], h->inner, h->critical, h->border, h->dangling, h->contracted);
    return;
  }
  printf("%zu vertices, %zu edges, %zu faces: %s, %s\n"
         "%zu components, Betti numbers %zu, %zu, %zu%s\n"
         "removed: %zu inner edges, %zu critical, %zu of borders, %zu dangling; %zu contracted\n"
         "seconds: %.6f to build, %.6f inner, %.6f critical, %.6f dangling, %.6f to contract\n",
         h->vertices, h->edges, h->faces, h->closed ? "closed" : "with a border",
         h->orientable ? "orientable" : "not orientable", h->components, h->betti[0], h->betti[1], h->betti[2],
         h->orientable ? "" : " over the integers modulo 2", h->inner, h->critical, h->border, h->dangling,
         h->contracted, t->build, inner, t->step[GMDS_STEP_CRITICAL], t->step[GMDS_STEP_DANGLING],
         t->step[GMDS_STEP_CONTRACT]);
}

/* "one", "ranges", "ranges:N", "grid", "grid:N": *boxes is of a grid. 1 or 0. */
static int read_clusters(const char *text, gmds_homology_options *o, unsigned *boxes)
{
  const char *colon = strchr(text, ':');
  const size_t n = colon ? (size_t)(colon - text) : strlen(text);
  unsigned long number = 0;
  if (strcmp(text, "one") == 0)
    number = 1;
  else if (n == 4 && strncmp(text, "grid", n) == 0 && (!colon || read_number(colon + 1, 1, 40, &number)))
    o->clustering = GMDS_BY_LABELS;
  else if (n != 6 || strncmp(text, "ranges", n) != 0 || (colon && !read_number(colon + 1, 1, 65536, &number)))
    return 0;
  o->ranges = *boxes = (unsigned)number;
  return 1;
}

/* The surface of a soup, and its labels in a grid where they are wanted: then the points go, unless generators need
 * them, before there is anything else. */
static gmds_status build(gmds_soup *soup, unsigned boxes, gmds_homology_options *o, uint16_t **labels, size_t *n_labels,
                         gmds_surface *surface)
{
  void *block = NULL;
  if (o->clustering == GMDS_BY_LABELS) {
    if (!gmds_resize(soup->memory, &block, 0, soup->n_points, sizeof **labels))
      return gmds_fail(o->error, GMDS_ERR_MEMORY, "out of memory for the clusters of %zu vertices", soup->n_points);
    *labels = block;
    *n_labels = soup->n_points;
    GMDS_TRY(gmds_grid_labels(soup->n_points, 3, soup->points, boxes, o->threads, *labels, o->error));
    o->labels = *labels;
  }
  return o->generators ? gmds_surface_from_soup(surface, soup, o->threads, o->error)
                       : gmds_surface_take_soup(surface, soup, o->threads, o->error);
}

static gmds_status write_generators(const char *path, const gmds_surface *s, const gmds_homology *h,
                                    const gmds_soup *soup, gmds_error *error)
{
  gmds_soup made;
  gmds_soup_init(&made, soup->memory, 3);
  gmds_status status = gmds_homology_to_soup(s, h, soup->points, &made);
  if (status != GMDS_OK)
    gmds_fail(error, status, "the generators: %s", gmds_status_text(status));
  else
    status = gmds_write_soup(path, &made, error);
  gmds_soup_clear(&made);
  return status;
}

static int run(const verb *v, int argc, char **argv)
{
  const char *input = NULL, *threads = "1", *clusters = "ranges", *generators = NULL;
  int json = 0;
  const option options[] = {
      {"threads", 0, &threads, NULL, "T  threads (default 1)"},
      {"clusters", 0, &clusters, NULL,
       "one | ranges[:N] | grid[:N]  how faces are dealt (default ranges, of 64; grid: 8 boxes an axis)"},
      {"generators", 0, &generators, NULL, "FILE  where the generators go: .vtk .vtu, vertices, edges and faces"},
      {"json", 0, NULL, &json, "print one JSON object"}};
  int code = read_arguments(v, argc, argv, options, 4, &input, 1, 1);
  if (code >= 0)
    return code;
  unsigned long number = 0;
  unsigned boxes = 0;
  timing t = {0};
  gmds_error error = {.status = GMDS_OK};
  gmds_homology_options o = {.generators = generators != NULL, .after = note_step, .user = &t, .error = &error};
  if (!read_number(threads, 1, GMDS_MAX_THREADS, &number))
    return misused(v, "--threads is a number from 1 to %d, not '%s'", GMDS_MAX_THREADS, threads);
  o.threads = (unsigned)number;
  if (!read_clusters(clusters, &o, &boxes))
    return misused(v, "--clusters is one, ranges:N (N up to 65536) or grid:N (N up to 40), not '%s'", clusters);
  gmds_format format;
  if (generators && gmds_format_of_path(generators, &error, &format) != GMDS_OK)
    return failed("%s", error.text);
  gmds_memory memory;
  gmds_soup soup;
  gmds_surface surface;
  gmds_homology h;
  uint16_t *labels = NULL;
  size_t n_labels = 0;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 3);
  gmds_surface_init(&surface, &memory);
  gmds_homology_init(&h, &memory);
  gmds_status status = gmds_make_surface(input, &error, &soup);
  t.last = now();
  if (status == GMDS_OK)
    status = build(&soup, boxes, &o, &labels, &n_labels, &surface);
  note_step(&t, GMDS_STEP_CLUSTERS);
  t.build = t.step[GMDS_STEP_CLUSTERS];
  if (status == GMDS_OK)
    status = gmds_homology_of(&surface, &o, &h);
  if (status == GMDS_OK && generators)
    status = write_generators(generators, &surface, &h, &soup, &error);
  if (status == GMDS_OK)
    print_homology(&h, &t, json);
  gmds_release(&memory, labels, n_labels, sizeof *labels);
  gmds_homology_clear(&h);
  gmds_surface_clear(&surface);
  gmds_soup_clear(&soup);
  return status == GMDS_OK ? DONE : failed("%s", error.text);
}

const verb verb_homology = {"homology", "INPUT [--threads T] [--clusters C] [--generators FILE] [--json]",
                            "Betti numbers and generators of a surface: a file, or torus:N, sphere:N", run};
