/* gmds delaunay: points to triangles or tetrahedra. */
#include "command.h"
#include <gmds/predicates.h>
#include <string.h>

static void print_report(size_t points, const model_report *r, const char *model, int json)
{
  if (json) {
    printf("{\"points\":%zu,\"duplicates\":%zu,\"dimension\":%d,\"cells\":%zu,\"seconds\":%.6f,\"bytes\":%zu,"
           "\"peak_bytes\":%zu,\"checksum\":\"%016llx\",\"model\":",
           points, r->duplicates, r->dimension, r->cells, r->seconds, r->bytes, r->peak_bytes,
           (unsigned long long)r->sum);
    json_text(stdout, model);
    printf("}\n");
    return;
  }
  printf("%zu points, %zu duplicates, dimension %d, %zu %s\n"
         "%.6f seconds, %zu bytes, %zu at the peak, checksum %016llx, model %s\n",
         points, r->duplicates, r->dimension, r->cells, r->dimension == 3 ? "tetrahedra" : "triangles", r->seconds,
         r->bytes, r->peak_bytes, (unsigned long long)r->sum, model);
}

/* Models that keep no order give triangles in any: turn them all counter-clockwise. */
static void turn_left(gmds_soup *s)
{
  for (size_t c = 0; c < s->n_cells && s->dim == 2; c++) {
    gmds_id *v = s->corners + s->begin[c], swap = v[1];
    if (gmds_orient2d(s->points + 2 * v[0], s->points + 2 * v[1], s->points + 2 * v[2]) < 0) {
      v[1] = v[2];
      v[2] = swap;
    }
  }
}

static int run(const verb *v, int argc, char **argv)
{
  const char *input = NULL, *output = NULL, *dim = "2", *model = NULL, *threads = "1";
  int json = 0;
  const option options[] = {
      {"output", 'o', &output, NULL,
       "FILE  where the mesh goes: .off .vtk .vtu .mesh .msh, or .svg for a picture (plane)"},
      {"dim", 0, &dim, NULL, "2|3  dimension (default 2)"},
      {"model", 0, &model, NULL,
       "MASK|cmap  mesh model (default N|F|F2N|F2F, in space N|R|R2N|R2R); in the plane MASK +X2Y borrows a relation"},
      {"threads", 0, &threads, NULL,
       "T  threads at most (default 1; more where the model allows: the defaults of --model)"},
      {"json", 0, NULL, &json, "print one JSON object"}};
  int code = read_arguments(v, argc, argv, options, 5, &input, 1, 1);
  if (code >= 0)
    return code;
  unsigned long number = 0;
  if (!read_number(dim, 2, 3, &number))
    return misused(v, "--dim is 2 or 3, not '%s'", dim);
  const int n_dim = (int)number;
  if (!model)
    model = n_dim == 3 ? "N|R|R2N|R2R" : "N|F|F2N|F2F";
  if (!read_number(threads, 1, 4096, &number))
    return misused(v, "--threads is a number from 1 to 4096, not '%s'", threads);
  const int n_threads = (int)number;
  gmds_error error = {.status = GMDS_OK};
  model_choice choice;
  if (find_model(model, n_dim, &error, &choice) != GMDS_OK)
    return failed("%s", error.text);
  gmds_format format;
  if (output && !is_svg(output) && gmds_format_of_path(output, &error, &format) != GMDS_OK)
    return failed("%s", error.text);
  gmds_memory memory;
  gmds_soup points, triangles;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&points, &memory, n_dim);
  gmds_soup_init(&triangles, &memory, n_dim);
  progress_state state = {"inserting", 0};
  model_report report = {0};
  gmds_status status = gmds_make_points(input, n_dim, &error, &points);
  if (status == GMDS_OK) {
    const model_task task = {.n = points.n_points,
                             .xy = points.points,
                             .soup = output ? &triangles : NULL,
                             .owner = choice.owner,
                             .now = now,
                             .threads = n_threads,
                             .progress = show_progress,
                             .user = &state,
                             .error = &error};
    status = choice.runs->triangulate(&task, &report);
    end_progress(&state);
  }
  turn_left(&triangles);
  if (status == GMDS_OK && output)
    status = write_any(output, &triangles, &error);
  if (status == GMDS_OK)
    print_report(points.n_points, &report, choice.name, json);
  gmds_soup_clear(&points);
  gmds_soup_clear(&triangles);
  return status == GMDS_OK ? DONE : failed("%s", error.text);
}

const verb verb_delaunay = {"delaunay", "INPUT [-o OUTPUT] [--dim 2|3] [--model MASK|cmap] [--threads T] [--json]",
                            "the Delaunay triangulation of points: a file, or random:N:SEED, grid:N, circle:N, "
                            "clusters:N:SEED",
                            run};
