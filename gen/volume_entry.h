/* The shell of a generated model of volumes, as entry.h is of a surface: included between <gmds/mesh.h> and
 * <gmds/end.h>, after the algorithms. */
#include "model_entry.h"

static gmds_status GMDS_FN(report)(const model_task *task, double begin, const mesh *m,
                                   const gmds_delaunay_result *result, model_report *report)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  report->seconds = task->now() - begin;
  report->dimension = result->dimension;
  report->duplicates = task->n - result->distinct;
  report->cells = count_3(m);
  report->bytes = m->memory.live;
  report->peak_bytes = m->memory.peak;
  gmds_status status = checksum(m, &memory, &report->sum);
  if (status == GMDS_OK && task->verify)
    return check(m, &memory, task->error);
#if GMDS_LISTS_CELLS
  if (status == GMDS_OK && task->soup)
    return to_soup(m, task->soup, task->error);
#else
  if (status == GMDS_OK && task->soup)
    status = GMDS_ERR_UNSUPPORTED;
#endif
  return status == GMDS_OK ? status : gmds_fail(task->error, status, "%s", gmds_status_text(status));
}

/* Points of one plane give triangles of no mesh: they go to the soup and into the checksum by themselves. */
static gmds_status GMDS_FN(report_flat)(const model_task *task, const mesh *m, const gmds_delaunay_result *result,
                                        model_report *report)
{
  report->cells = result->n_triangles;
  report->sum = 0;
  for (size_t t = 0; t < result->n_triangles; t++) {
    gmds_id nodes[3];
    uint64_t h = 0;
    memcpy(nodes, result->triangles + 3 * t, sizeof nodes);
    if (task->soup)
      GMDS_TRY(gmds_soup_add_cell(task->soup, GMDS_TRIANGLE, 3, nodes));
    GMDS_TRY(gmds_checksum_cell(3, m->points, 3, nodes, &h));
    report->sum += h;
  }
  return GMDS_OK;
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
  if (status == GMDS_OK && result.n_triangles)
    status = GMDS_FN(report_flat)(task, &m, &result, report);
  gmds_delaunay_result_clear(&result);
  mesh_clear(&m);
  return status;
}

#define GMDS__CODE(i, j) GMDS_FN(code_##i##_##j)
#define GMDS__CODES(i)                                                                                                 \
  GMDS__CODE(i, 0) = GMDS__PATH_##i##_0, GMDS__CODE(i, 1) = GMDS__PATH_##i##_1, GMDS__CODE(i, 2) = GMDS__PATH_##i##_2, \
                GMDS__CODE(i, 3) = GMDS__PATH_##i##_3
enum { GMDS__CODES(0), GMDS__CODES(1), GMDS__CODES(2), GMDS__CODES(3) };
#undef GMDS__CODES
#define GMDS__CODES(i)                                                     \
  {                                                                        \
    GMDS__CODE(i, 0), GMDS__CODE(i, 1), GMDS__CODE(i, 2), GMDS__CODE(i, 3) \
  }

const model_entry GMDS_FN(entry) = {.mask = GMDS__MASK,
                                    .dim = 3,
                                    .triangulate = GMDS_FN(triangulate),
                                    .code = {GMDS__CODES(0), GMDS__CODES(1), GMDS__CODES(2), GMDS__CODES(3)}};
#undef GMDS__CODE
#undef GMDS__CODES
