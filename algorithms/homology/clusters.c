/* Dealing the faces to clusters, and the clusters to threads. */
#include "simplify.h"
#include <math.h>
#include <string.h>

enum { RANGES = 64, MOST_LABELS = 65536, BOXES = 8, MOST_BOXES = 40 };

typedef struct boxing {
  const double *points;
  uint16_t *labels;
  size_t n, dim, boxes;
  unsigned threads;
  double low[3], scale[3];
} boxing;

static void label_part(void *work, unsigned t)
{
  const boxing *b = work;
  const size_t end = GMDS_SHARE(b->n, t + 1, b->threads);
  const double most = (double)(b->boxes - 1);
  for (size_t v = GMDS_SHARE(b->n, t, b->threads); v < end; v++) {
    size_t box = 0;
    for (size_t k = b->dim; k-- > 0;) {
      double x = (b->points[v * b->dim + k] - b->low[k]) * b->scale[k];
      box = box * b->boxes + (size_t)(x < most ? x : most);
    }
    b->labels[v] = (uint16_t)box;
  }
}

gmds_status gmds_grid_labels(size_t n, int dim, const double *points, unsigned boxes, unsigned threads,
                             uint16_t *labels, gmds_error *error)
{
  boxing b = {.points = points, .labels = labels, .n = n, .boxes = boxes ? boxes : BOXES, .threads = threads};
  double high[3] = {0, 0, 0};
  if (boxes > MOST_BOXES || (dim != 2 && dim != 3) || threads < 1 || threads > GMDS_MAX_THREADS)
    return gmds_fail(
        error, GMDS_ERR_ARGUMENT,
        "a grid takes points of 2 or 3 coordinates, up to %d boxes along an axis, and from 1 to %d threads", MOST_BOXES,
        GMDS_MAX_THREADS);
  b.dim = (size_t)dim;
  for (size_t k = 0; n && k < b.dim; k++)
    b.low[k] = high[k] = points[k];
  for (size_t v = 0; v < n; v++)
    for (size_t k = 0; k < b.dim; k++) {
      double x = points[v * b.dim + k];
      if (!isfinite(x))
        return gmds_fail(error, GMDS_ERR_ARGUMENT, "point %zu has a coordinate that is not a finite number", v);
      b.low[k] = x < b.low[k] ? x : b.low[k];
      high[k] = x > high[k] ? x : high[k];
    }
  for (size_t k = 0; k < b.dim; k++) {
    double half = high[k] / 2 - b.low[k] / 2; /* the whole may not be a number that is there */
    b.scale[k] = half > 0 ? (double)b.boxes / 2 / half : 0;
    b.scale[k] = isfinite(b.scale[k]) ? b.scale[k] : 0;
  }
  gmds_share(threads, label_part, &b);
  return GMDS_OK;
}

typedef struct dealing {
  gmds_simplification *w;
  const uint16_t *labels;
  gmds_id *size; /* threads × n_clusters: how many faces of each thread's part have each label */
} dealing;

static void deal_part(void *work, unsigned t)
{
  const dealing *p = work;
  const gmds_surface *s = p->w->s;
  gmds_id *size = p->size + t * p->w->n_clusters;
  const size_t first = GMDS_SHARE(s->n_faces, t, p->w->threads), end = GMDS_SHARE(s->n_faces, t + 1, p->w->threads);
  for (size_t f = first; f < end; f++) {
    uint16_t least = UINT16_MAX;
    for (gmds_id d = gmds_surface_first(s, f); d < gmds_surface_first(s, f + 1); d++) {
      uint16_t label = p->labels[s->origin[d]];
      least = label < least ? label : least;
    }
    p->w->cluster[f] = least;
    size[least]++;
  }
}

/* Gives each cluster, in order, to the thread that has the fewest faces so far. */
static void deal_clusters(gmds_simplification *w, const gmds_id *size)
{
  size_t load[GMDS_MAX_THREADS] = {0};
  for (size_t c = 0; c < w->n_clusters; c++) {
    unsigned least = 0;
    for (unsigned t = 1; size[c] && t < w->threads; t++)
      least = load[t] < load[least] ? t : least;
    load[least] += size[c];
    w->worker[c] = (uint16_t)least;
  }
}

static gmds_status deal_labels(gmds_simplification *w, const uint16_t *labels)
{
  dealing p = {.w = w, .labels = labels};
  const size_t entries = w->threads * w->n_clusters;
  void *size = NULL;
  if (!gmds_resize(w->memory, &size, 0, entries, sizeof *p.size))
    return GMDS_ERR_MEMORY;
  p.size = size;
  memset(size, 0, entries * sizeof *p.size);
  gmds_share(w->threads, deal_part, &p);
  for (size_t k = w->n_clusters; k < entries; k++)
    p.size[k % w->n_clusters] += p.size[k];
  deal_clusters(w, p.size);
  gmds_release(w->memory, size, entries, sizeof *p.size);
  return GMDS_OK;
}

gmds_status gmds_homology_clusters(gmds_simplification *w, const gmds_homology_options *o)
{
  void *cluster = NULL, *worker = NULL;
  if (o->clustering == GMDS_BY_RANGES ? o->ranges > MOST_LABELS : o->clustering != GMDS_BY_LABELS || !o->labels)
    return gmds_fail(o->error, GMDS_ERR_ARGUMENT, "clusters are at most %d ranges, or by labels of vertices",
                     MOST_LABELS);
  w->n_clusters = o->ranges ? o->ranges : RANGES;
  if (o->clustering == GMDS_BY_RANGES)
    return GMDS_OK;
  w->n_clusters = 1;
  for (size_t v = 0; v < w->s->n_vertices; v++)
    w->n_clusters = o->labels[v] < w->n_clusters ? w->n_clusters : (size_t)o->labels[v] + 1;
  if (!gmds_resize(w->memory, &cluster, 0, w->s->n_faces, sizeof *w->cluster))
    return GMDS_ERR_MEMORY;
  w->cluster = cluster;
  if (!gmds_resize(w->memory, &worker, 0, w->n_clusters, sizeof *w->worker))
    return GMDS_ERR_MEMORY;
  w->worker = worker;
  return deal_labels(w, o->labels);
}
