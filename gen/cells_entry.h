/* The work on cells that `gmds bench cells` measures, for one generated model, through the public interface alone.
 * Included between <gmds/mesh.h> and <gmds/end.h>, before entry.h. */
#include "model_entry.h"
#include <math.h>

/* A finished mesh from arrays: faces one at a time, or all at once. */
static gmds_status GMDS_FN(construct)(const cells_task *task, mesh *m, int at_once)
{
  gmds_id id = 0;
  GMDS_TRY(reserve(m, task->n_nodes, task->n_edges, task->n_triangles));
  for (size_t v = 0; v < task->n_nodes; v++)
    GMDS_TRY(add_node(m, task->xy + 2 * v, &id));
  if (at_once)
    return add_faces(m, task->n_triangles, NULL, task->nodes, NULL);
  for (const gmds_id *v = task->nodes, *end = v + 3 * task->n_triangles; v < end; v += 3)
    GMDS_TRY(add_triangle(m, v[0], v[1], v[2], &id));
  return GMDS_OK;
}

static inline double GMDS_FN(area_of)(const mesh *m, const gmds_id v[3])
{
  const double *a = point(m, v[0]), *b = point(m, v[1]), *c = point(m, v[2]);
  return fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/* The sum of the areas of all faces. */
static gmds_status GMDS_FN(area)(const mesh *m, cells_report *report)
{
  double twice = 0;
#if GMDS_VIEW(2, 0)
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1)) {
    size_t n = 0;
    twice += GMDS_FN(area_of)(m, view_2_0(m, f, &n));
  }
#else
  gmds_csr nodes;
  gmds_csr_init(&nodes, &report->memory);
  GMDS_TRY(all_adj_2_0(m, &nodes));
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    twice += GMDS_FN(area_of)(m, nodes.data + nodes.begin[f]);
  gmds_csr_clear(&nodes);
#endif
  report->area = twice / 2;
  return GMDS_OK;
}

/* The faces around every node: how many in all. */
static gmds_status GMDS_FN(stars)(const mesh *m, cells_report *report)
{
#if GMDS_CAN(0, 2)
  size_t count = 0;
  uint64_t sum = 0;
#  if GMDS_VIEW(0, 2)
  for (gmds_id v = next_0(m, 0); v != GMDS_NONE; v = next_0(m, v + 1)) {
    size_t n = 0;
    const gmds_id *faces = view_0_2(m, v, &n);
#  else
  gmds_csr around;
  gmds_csr_init(&around, &report->memory);
  GMDS_TRY(all_adj_0_2(m, &around));
  for (gmds_id v = next_0(m, 0); v != GMDS_NONE; v = next_0(m, v + 1)) {
    size_t n = around.begin[v + 1] - around.begin[v];
    const gmds_id *faces = n ? around.data + around.begin[v] : NULL;
#  endif
    count += n;
    for (size_t k = 0; k < n; k++)
      sum += faces[k];
  }
#  if !GMDS_VIEW(0, 2)
  gmds_csr_clear(&around);
#  endif
  report->star_faces = count;
  report->star_sum = sum;
  return GMDS_OK;
#else
  (void)m;
  (void)report;
  return GMDS_ERR_UNSUPPORTED;
#endif
}

/* All edges with their nodes, and the edges of all faces. */
static gmds_status GMDS_FN(edges)(const mesh *m, cells_report *report)
{
  gmds_edge_table table;
  gmds_edge_table_init(&table, &report->memory);
  GMDS_TRY(all_edges(m, &table));
  report->edges = table.n;
  gmds_edge_table_clear(&table);
  return GMDS_OK;
}

/* A mark on every second face, then the marked faces are counted. */
static gmds_status GMDS_FN(marks)(const mesh *m, cells_report *report)
{
  gmds_bits mark;
  size_t count = 0;
  GMDS_TRY(gmds_bits_init(&mark, &report->memory, end_2(m)));
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    if (f % 2)
      gmds_bits_set(&mark, f);
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    count += (size_t)gmds_bits_get(&mark, f);
  gmds_bits_clear(&mark);
  report->marked = count;
  return GMDS_OK;
}

/* A number on every face, written and read back. */
static gmds_status GMDS_FN(attributes)(mesh *m, cells_report *report)
{
  gmds_attribute *attribute = NULL;
  double sum = 0;
  GMDS_TRY(add_attribute(m, 2, "number", GMDS_DOUBLE, 1, &attribute));
  double *number = attribute->data;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    number[f] = (double)f;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    sum += number[f];
  remove_attribute(m, 2, attribute);
  report->number_sum = sum;
  return GMDS_OK;
}

static gmds_status GMDS_FN(work)(const cells_task *task, mesh *m, cells_work work, cells_report *report)
{
  switch (work) {
  case CELLS_BULK:
    return GMDS_FN(construct)(task, m, 1);
  case CELLS_CONSTRUCT:
    return GMDS_ADDS_LOCALLY ? GMDS_FN(construct)(task, m, 0) : GMDS_ERR_UNSUPPORTED;
  case CELLS_AREA:
    return GMDS_FN(area)(m, report);
  case CELLS_STARS:
    return GMDS_FN(stars)(m, report);
  case CELLS_EDGES:
    return GMDS_FN(edges)(m, report);
  case CELLS_MARKS:
    return GMDS_FN(marks)(m, report);
  case CELLS_ATTRIBUTES:
    return GMDS_FN(attributes)(m, report);
  default:
    return GMDS_ERR_ARGUMENT;
  }
}

/* All works, several times each; what the model cannot do is left out. */
static gmds_status GMDS_FN(measure_cells)(const cells_task *task, mesh *m, cells_report *report)
{
  for (int work = 0; work < CELLS_WORKS; work++) {
    gmds_status status = GMDS_OK;
    for (int k = 0; k < CELLS_REPETITIONS && status == GMDS_OK; k++) {
      if (work == CELLS_BULK || (work == CELLS_CONSTRUCT && GMDS_ADDS_LOCALLY)) {
        mesh_clear(m);
        mesh_init(m, NULL);
      }
      double begin = task->now();
      status = GMDS_FN(work)(task, m, (cells_work)work, report);
      report->seconds[work][k] = task->now() - begin;
      report->done[work] += status == GMDS_OK;
    }
    if (status != GMDS_OK && status != GMDS_ERR_UNSUPPORTED)
      return status;
    if (work != CELLS_CONSTRUCT)
      continue;
    GMDS_TRY(trim(m));
    report->bytes = mesh_memory(m)->live;
    report->peak_bytes = mesh_memory(m)->peak;
    report->nodes = count_0(m);
    report->triangles = count_2(m);
  }
  return GMDS_OK;
}

static gmds_status GMDS_FN(cells)(const cells_task *task, cells_report *report)
{
  mesh m;
  mesh_init(&m, NULL);
  gmds_status status = GMDS_FN(measure_cells)(task, &m, report);
  mesh_clear(&m);
  return status;
}
