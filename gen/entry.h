/* The shell of a generated model: gives the command one entry a model. Included between <gmds/mesh.h> and <gmds/end.h>,
 * after the algorithms and cells_entry.h. */
#include "model_entry.h"

/* What has come of a triangulation that began at `begin`. */
static gmds_status GMDS_FN(report)(const model_task *task, double begin, const mesh *m, model_report *report)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  report->seconds = task->now() - begin;
  report->cells = count_2(m);
  report->bytes = m->memory.live;
  report->peak_bytes = m->memory.peak;
  gmds_status status = checksum(m, &memory, &report->sum);
  if (status == GMDS_OK && task->verify)
    return check(m, &memory, task->error);
  if (status == GMDS_OK && task->soup)
    status = to_soup(m, task->soup);
  return status == GMDS_OK ? status : gmds_fail(task->error, status, "%s", gmds_status_text(status));
}

static gmds_status GMDS_FN(measure)(const model_task *task, mesh *m, gmds_delaunay_result *result, model_report *report)
{
  const gmds_delaunay_options options = {
      .progress = task->progress, .user = task->user, .threads = task->threads, .error = task->error};
  double begin = task->now();
  GMDS_TRY(GMDS_FN(delaunay)(m, task->n, task->xy, &options, result));
  report->dimension = result->dimension;
  report->duplicates = task->n - result->distinct;
  if (!task->owner)
    return GMDS_FN(report)(task, begin, m, report);
  gmds_parts parts;
  gmds_parts_init(&parts);
  give_parts(m, &parts);
  gmds_status status = task->owner->give_back(task, begin, &parts, report);
  gmds_parts_clear(&parts);
  return status;
}

static gmds_status GMDS_FN(triangulate)(const model_task *task, model_report *report)
{
  mesh m;
  gmds_delaunay_result result;
  mesh_init(&m, NULL);
  gmds_delaunay_result_init(&result, NULL);
  gmds_status status = GMDS_FN(measure)(task, &m, &result, report);
  gmds_delaunay_result_clear(&result);
  mesh_clear(&m);
  return status;
}

static gmds_status GMDS_FN(give_back)(const model_task *task, double begin, gmds_parts *parts, model_report *report)
{
  mesh m;
  mesh_init(&m, NULL);
  gmds_status status = take_parts(&m, parts, task->error);
  if (status == GMDS_OK)
    status = GMDS_FN(report)(task, begin, &m, report);
  mesh_clear(&m);
  return status;
}

#define GMDS__CODE(i, j) GMDS_FN(code_##i##_##j)
enum {
  GMDS__CODE(0, 0) = GMDS__PATH_0_0,
  GMDS__CODE(0, 1) = GMDS__PATH_0_1,
  GMDS__CODE(0, 2) = GMDS__PATH_0_2,
  GMDS__CODE(1, 0) = GMDS__PATH_1_0,
  GMDS__CODE(1, 1) = GMDS__PATH_1_1,
  GMDS__CODE(1, 2) = GMDS__PATH_1_2,
  GMDS__CODE(2, 0) = GMDS__PATH_2_0,
  GMDS__CODE(2, 1) = GMDS__PATH_2_1,
  GMDS__CODE(2, 2) = GMDS__PATH_2_2
};

const model_entry GMDS_FN(entry) = {.mask = GMDS__MASK,
                                    .dim = 2,
                                    .triangulate = GMDS_FN(triangulate),
                                    .cells = GMDS_FN(cells),
                                    .give_back = GMDS_FN(give_back),
                                    .code = {{GMDS__CODE(0, 0), GMDS__CODE(0, 1), GMDS__CODE(0, 2)},
                                             {GMDS__CODE(1, 0), GMDS__CODE(1, 1), GMDS__CODE(1, 2)},
                                             {GMDS__CODE(2, 0), GMDS__CODE(2, 1), GMDS__CODE(2, 2)}}};
#undef GMDS__CODE
