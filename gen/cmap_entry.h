/* The shell of a combinatorial map as a model of the command, as entry.h is of a set of relations: included between
 * <gmds/mesh.h> and <gmds/end.h>, after the algorithms. */
#include "model_entry.h"

#if GMDS_TOP == 3
#  define count_top count_3
#else
#  define count_top count_2
#endif

/* Points of one plane give triangles of no map: they go to the soup and into the checksum by themselves. */
static gmds_status GMDS_FN(report_flat)(const model_task *task, const mesh *m, const gmds_delaunay_result *result,
                                        model_report *report)
{
  report->cells = result->n_triangles;
  for (size_t t = 0; t < result->n_triangles; t++) {
    gmds_id nodes[3];
    uint64_t h = 0;
    memcpy(nodes, result->triangles + 3 * t, sizeof nodes);
    if (task->soup)
      GMDS_TRY(gmds_soup_add_cell(task->soup, GMDS_TRIANGLE, 3, nodes));
    GMDS_TRY(gmds_checksum_cell(GMDS_COORDINATES, m->map.points, 3, nodes, &h));
    report->sum += h;
  }
  return GMDS_OK;
}

static gmds_status GMDS_FN(report)(const model_task *task, double begin, const mesh *m,
                                   const gmds_delaunay_result *result, model_report *report)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  report->seconds = task->now() - begin;
  report->dimension = result->dimension;
  report->duplicates = task->n - result->distinct;
  report->cells = count_top(m);
  report->bytes = m->map.memory.live;
  report->peak_bytes = m->map.memory.peak;
  gmds_status status = checksum(m, &memory, &report->sum);
  if (status == GMDS_OK && task->verify)
    return check(m, &memory, task->error);
  if (status == GMDS_OK && task->soup)
    status = write_soup(m, task->soup, task->error);
  if (status == GMDS_OK && result->n_triangles)
    status = GMDS_FN(report_flat)(task, m, result, report);
  return status == GMDS_OK ? status : gmds_fail(task->error, status, "%s", gmds_status_text(status));
}

static gmds_status GMDS_FN(triangulate)(const model_task *task, model_report *report)
{
  mesh m;
  gmds_delaunay_result result;
  const gmds_delaunay_options options = {
      .progress = task->progress, .user = task->user, .threads = task->threads, .error = task->error};
  mesh_init(&m, NULL);
  gmds_delaunay_result_init(&result, NULL);
  double begin = task->now();
  gmds_status status = GMDS_FN(delaunay)(&m, task->n, task->xy, &options, &result);
  if (status == GMDS_OK)
    status = GMDS_FN(report)(task, begin, &m, &result, report);
  gmds_delaunay_result_clear(&result);
  mesh_clear(&m);
  return status;
}

const model_entry GMDS_FN(entry) = {.name = "cmap",
                                    .mask = GMDS__MASK,
                                    .dim = GMDS_TOP,
                                    .triangulate = GMDS_FN(triangulate),
#if GMDS_TOP == 2
                                    .cells = GMDS_FN(cells)
#endif
};
#undef count_top
