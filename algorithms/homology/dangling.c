/* Step 2: removal of dangling edges, that is, peeling the leaves of the graph of kept edges. What is left at the end
 * (the 2-core) does not depend on the order.
 *
 * The paper locks vertices and follows each path of dangling edges. Here each thread has a share of the vertices, takes
 * its leaves first in, first out (a path followed to its end is a chain of cache misses), and tells the others what
 * their vertices have lost; when little is left to tell, one thread ends the work. No lock, no atomic. */
#include "simplify.h"
#include <string.h>

enum { FEW = 4096, AHEAD = 8 };

typedef struct peeling {
  gmds_simplification *w;
  unsigned threads;
  gmds_id *queue;                /* n_vertices: each thread has the part of its vertices */
  size_t head[GMDS_MAX_THREADS]; /* of each part */
  size_t tail[GMDS_MAX_THREADS];
  size_t used[GMDS_MAX_THREADS]; /* vertices of faces in each part */
  gmds_loss *losses;
  size_t *room; /* threads × threads: where what t tells u begins; one past the end of all */
  size_t *told; /* threads × threads: one past its end */
} peeling;

static unsigned share_of(const peeling *p, gmds_id v)
{
  const size_t n = p->w->s->n_vertices, size = n / p->threads, rest = n % p->threads;
  const size_t long_ones = rest * (size + 1);
  return v < long_ones ? (unsigned)(v / (size + 1)) : (unsigned)(rest + (v - long_ones) / size);
}

static inline gmds_id other_end(const gmds_surface *s, gmds_id d, gmds_id v)
{
  gmds_id a = s->origin[d];
  return a == v ? s->origin[gmds_surface_beta1(s, d)] : a;
}

static inline void add_end(gmds_spoke *spoke, gmds_id v, gmds_id d)
{
  spoke[v].degree++;
  spoke[v].darts ^= d;
}

/* Vertex v loses the edge of dart d; a leaf enters the queue. */
static inline void lose(gmds_spoke *spoke, gmds_id v, gmds_id d, gmds_id *queue, size_t *tail)
{
  spoke[v].darts ^= d;
  if (--spoke[v].degree == 1)
    queue[(*tail)++] = v;
}

/* The ends of kept edges at the vertices of share t, and how much it may have to tell the others. */
static void count_part(void *work, unsigned t)
{
  peeling *p = work;
  const gmds_surface *s = p->w->s;
  const uint8_t *edge = p->w->edge;
  gmds_spoke *spoke = p->w->spoke;
  size_t *room = p->room + (size_t)t * p->threads;
  const gmds_id low = (gmds_id)GMDS_SHARE(s->n_vertices, t, p->threads);
  const gmds_id end = (gmds_id)GMDS_SHARE(s->n_vertices, t + 1, p->threads);
  memset(spoke + low, 0, (end - low) * sizeof *spoke);
  for (size_t at = 0; at < p->w->n_edges; at += GMDS_EDGES_AT_ONCE)
    for (uint64_t kept = gmds_homology_eight(edge, at, GMDS_EDGE_KEPT); kept; kept &= kept - 1) {
      const gmds_id d = gmds_homology_dart(at, kept), a = s->origin[d], b = s->origin[gmds_surface_beta1(s, d)];
      const int has_a = a >= low && a < end, has_b = b >= low && b < end;
      if (has_a)
        add_end(spoke, a, d);
      if (has_b)
        add_end(spoke, b, d);
      if (has_a != has_b)
        room[share_of(p, has_a ? b : a)]++;
    }
  size_t tail = low, used = 0;
  for (gmds_id v = low; v < end; v++) {
    used += spoke[v].degree > 0;
    if (spoke[v].degree == 1)
      p->queue[tail++] = v;
    if (spoke[v].degree == 0) /* of no face: one of a face keeps an edge, or the faces around it would make a ring */
      spoke[v].darts = GMDS_NONE;
  }
  p->head[t] = low;
  p->tail[t] = tail;
  p->used[t] = used;
}

/* Takes leaf v away with its edge; *dart is that. Where the edge leads. */
static inline gmds_id peel(const gmds_surface *s, gmds_spoke *spoke, gmds_id v, gmds_id *dart)
{
  *dart = spoke[v].darts;
  spoke[v] = (gmds_spoke){0, GMDS_NONE};
  return other_end(s, *dart, v);
}

/* Takes the leaves of share t until it has none. */
static void peel_part(void *work, unsigned t)
{
  peeling *p = work;
  const gmds_surface *s = p->w->s;
  gmds_spoke *spoke = p->w->spoke;
  const gmds_id low = (gmds_id)GMDS_SHARE(s->n_vertices, t, p->threads);
  const gmds_id end = (gmds_id)GMDS_SHARE(s->n_vertices, t + 1, p->threads);
  size_t head = p->head[t], tail = p->tail[t], dangling = 0;
  for (; head < tail; head++) {
    if (head + AHEAD < tail && spoke[p->queue[head + AHEAD]].degree)
      __builtin_prefetch(s->origin + spoke[p->queue[head + AHEAD]].darts);
    const gmds_id v = p->queue[head];
    if (spoke[v].degree != 1) /* the last vertex of a tree */
      continue;
    gmds_id dart = 0;
    const gmds_id to = peel(s, spoke, v, &dart);
    dangling++;
    if (to >= low && to < end)
      lose(spoke, to, dart, p->queue, &tail);
    else
      p->losses[p->told[(size_t)t * p->threads + share_of(p, to)]++] = (gmds_loss){to, dart};
  }
  p->head[t] = head;
  p->tail[t] = tail;
  p->w->dangling[t] += dangling;
}

/* What share t was told, into its queue. Where both ends of an edge took it away at once, it is counted once, and its
 * lower end is the last vertex of the tree. */
static void hear_part(void *work, unsigned t)
{
  peeling *p = work;
  const gmds_surface *s = p->w->s;
  gmds_spoke *spoke = p->w->spoke;
  for (unsigned from = 0; from < p->threads; from++) {
    const size_t k = (size_t)from * p->threads + t;
    for (size_t i = p->room[k]; i < p->told[k]; i++) {
      const gmds_loss *loss = &p->losses[i];
      if (spoke[loss->vertex].degree)
        lose(spoke, loss->vertex, loss->dart, p->queue, &p->tail[t]);
      else if (loss->vertex < other_end(s, loss->dart, loss->vertex)) {
        spoke[loss->vertex].darts = 0;
        p->w->dangling[t]--;
      }
    }
  }
}

/* Room for what shares may tell each other: room[k] of entry k becomes where it begins, told[k] as well. */
static gmds_status take_losses(peeling *p, size_t *n_losses)
{
  const size_t pairs = (size_t)p->threads * p->threads;
  size_t sum = 0;
  void *losses = NULL;
  for (size_t k = 0; k < pairs; k++) {
    size_t n = p->room[k];
    p->room[k] = p->told[k] = sum;
    sum += n;
  }
  if (!gmds_resize(p->w->memory, &losses, 0, sum, sizeof *p->losses))
    return GMDS_ERR_MEMORY;
  p->losses = losses;
  *n_losses = sum;
  return GMDS_OK;
}

/* Rounds: all peel, then all hear. With little to tell the rounds go on by one thread, which costs no start of
 * others. */
static void peel_all(peeling *p)
{
  const size_t pairs = (size_t)p->threads * p->threads;
  for (size_t told = SIZE_MAX; told;) {
    if (told > FEW)
      gmds_share(p->threads, peel_part, p);
    else
      for (unsigned t = 0; t < p->threads; t++)
        peel_part(p, t);
    told = 0;
    for (size_t k = 0; k < pairs; k++)
      told += p->told[k] - p->room[k];
    if (told > FEW)
      gmds_share(p->threads, hear_part, p);
    else if (told)
      for (unsigned t = 0; t < p->threads; t++)
        hear_part(p, t);
    memcpy(p->told, p->room, pairs * sizeof *p->told);
  }
}

gmds_status gmds_homology_dangling(gmds_simplification *w, gmds_homology *h)
{
  const size_t n = w->s->n_vertices, pairs = (size_t)w->threads * w->threads;
  peeling p = {.w = w, .threads = w->threads};
  size_t n_losses = 0;
  void *queue = NULL, *room = NULL;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(w->memory, &queue, 0, n, sizeof *p.queue) &&
      gmds_resize(w->memory, &room, 0, 2 * pairs, sizeof *p.room)) {
    memset(room, 0, 2 * pairs * sizeof *p.room);
    p.queue = queue;
    p.room = room;
    p.told = p.room + pairs;
    gmds_share(w->threads, count_part, &p);
    status = take_losses(&p, &n_losses);
  }
  if (status == GMDS_OK) {
    peel_all(&p);
    for (unsigned t = 0; t < w->threads; t++) {
      h->dangling += w->dangling[t];
      h->vertices += p.used[t];
    }
  }
  gmds_release(w->memory, p.losses, n_losses, sizeof *p.losses);
  gmds_release(w->memory, room, room ? 2 * pairs : 0, sizeof *p.room);
  gmds_release(w->memory, queue, queue ? n : 0, sizeof *p.queue);
  return status;
}
