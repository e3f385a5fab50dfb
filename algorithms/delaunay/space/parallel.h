/* Insertion by several threads in space (strips.h). How many regions a star has more than its cavity is not known
 * before: each thread takes some for each of its points before a round, 6.8 of uniform points being what they need,
 * keeps those that cavities leave over, puts points off when it has none left, and gives back what it has before the
 * rest goes in.
 *
 * Marks of regions and numbers of nodes are everyone's, too. Those of a region with nodes of several threads are
 * written by the one thread that it shares a face with, if there is one; the ghost has a number a thread. */
#if GMDS_CONCURRENT_STARS

#  define GMDS__A_POINT 7 /* regions taken for each */

typedef struct supply {
  size_t known; /* of regions below this number all that are alive had rows before the stage */
} supply;

/* As locate(), but of the faces that p is beyond it crosses one behind which all nodes are this thread's, and where
 * there is none it puts p off. The next walk begins there, so that points put off in a row do not make walks longer. */
GMDS_APART void locate_shared(insertion *in, const double p[3], candidate *found)
{
  const mesh *m = in->m;
  gmds_id at = in->last.region, apex = GMDS_NONE;
  unsigned from = 4;
  while (apex != in->ghost) {
    size_t n = 0;
    const gmds_id *v = view_3_0(m, at, &n);
    gmds_id next = GMDS_NONE;
    unsigned k = 0, arrival = 4;
    for (; k < 4; k++) {
      if (k == from || gmds_orient3d(point(m, v[face_nodes[k][0]]), point(m, v[face_nodes[k][1]]),
                                     point(m, v[face_nodes[k][2]]), p) <= 0)
        continue;
      next = across(m, at, k, &arrival);
      apex = view_3_0(m, next, &n)[opposite_node[arrival]];
      if (owns(in, apex))
        break;
    }
    in->last.region = at;
    if (k == 4) {
      if (next != GMDS_NONE)
        defer(in);
      break;
    }
    at = next;
    from = arrival;
    in->steps++;
  }
  found->region = at;
}

GMDS_APART gmds_status grow_shared(insertion *in, const candidate *root, const double p[3])
{
  return grow_cavity(in, root, p, GMDS__SHARED);
}

GMDS_APART void find_walls_shared(insertion *in)
{
  find_walls(in, GMDS__SHARED);
}

static inline void push_spare(insertion *in, gmds_id r)
{
  in->marks[r] = in->spare;
  in->spare = r;
  in->n_spare++;
}

static inline gmds_id pop_spare(insertion *in)
{
  const gmds_id r = in->spare;
  in->spare = in->marks[r];
  in->marks[r] = 0;
  in->n_spare--;
  return r;
}

/* Puts into in->ids what the star has more than the cavity. The value is whether there was enough. */
static inline int supply_star(insertion *in)
{
  const size_t n = in->n_cavity;
  if (in->n_walls > GMDS_STAR_OF_WALLS || in->n_walls > n + in->n_spare + (in->fresh_end - in->fresh))
    return 0;
  for (size_t i = n; i < in->n_walls; i++)
    in->ids[i] = in->n_spare ? pop_spare(in) : in->fresh++;
  for (size_t i = in->n_walls; i < n; i++)
    push_spare(in, in->ids[i]);
  return 1;
}

static inline gmds_status insert_shared(insertion *in, gmds_id v)
{
  candidate root;
  const double *p = point(in->m, v);
  locate_shared(in, p, &root);
  if (is_deferred(in))
    return GMDS_OK;
  GMDS_TRY(grow_shared(in, &root, p));
  if (is_deferred(in))
    return GMDS_OK;
  find_sides(in);
  if (in->base > GMDS_NONE / 2 || !supply_star(in)) {
    defer(in);
    return GMDS_OK;
  }
  find_walls_shared(in);
  star_of(in->m, v, in->n_walls, in->walls, in->ids);
  remember_star(in, v);
  return GMDS_OK;
}

#  include <gmds/algorithms/delaunay/strips.h>

static inline int find_start(concurrent *c, unsigned t)
{
  insertion *in = &c->in[t];
  for (gmds_id r = next_3(in->m, 0); r < c->supply.known; r = next_3(in->m, r + 1)) {
    gmds_id v[4];
    tetrahedron_nodes(in->m, r, v);
    if (is_finite(in, v) && owns_all(in, v)) {
      in->last.region = r;
      return 1;
    }
  }
  return 0;
}

static inline void open_stage(concurrent *c)
{
  c->supply.known = end_3(c->in->m);
}

/* Takes regions for all threads, as many as there is room for without growing: what that is not enough for goes in by
 * one thread, which makes room. */
static inline gmds_status open_round(concurrent *c)
{
  enum { MORE = 64 };
  insertion *in = c->in;
  mesh *m = in->m;
  size_t need[GMDS_MAX_THREADS], all = 0;
  gmds_id first = 0;
  assign_strips(c);
  for (unsigned t = 0; t < c->threads; t++) {
    for (gmds_id r = in[t].fresh_end; r-- > in[t].fresh;)
      push_spare(&in[t], r);
    need[t] = GMDS__A_POINT * (c->begin[t + 1] - c->begin[t]) + MORE;
    need[t] -= in[t].n_spare < need[t] ? in[t].n_spare : need[t];
    all += need[t];
  }
  size_t left = take_regions(m, all, &first);
  if (end_3(m) > in->marked)
    GMDS_TRY(reserve_marks(in, end_3(m)));
  for (unsigned t = 0; t < c->threads; t++) {
    const size_t n = need[t] == all ? left : (size_t)((double)left * ((double)need[t] / (double)all));
    in[t].fresh = first;
    in[t].fresh_end = first += (gmds_id)n;
    left -= n;
    all -= need[t];
    in[t].marks = in->marks;
    in[t].marked = in->marked;
    in[t].local = in->local;
    in[t].stamp = in->stamp;
    in[t].base = in->base;
    in[t].ghost_at = in->numbered - GMDS__OF_GHOST * (size_t)(t + 1);
  }
  return GMDS_OK;
}

/* Stamps and numbers go on behind those of all threads. A spare region that find_start() could meet is given back. */
static inline void close_round(concurrent *c)
{
  insertion *one = c->in;
  for (unsigned t = 0; t < c->threads; t++) {
    insertion *in = &c->in[t];
    size_t n = in->n_spare;
    gmds_id *link = &in->spare;
    for (size_t i = 0; i < n; i++) {
      const gmds_id r = *link;
      if (r >= c->supply.known) {
        link = &in->marks[r];
        continue;
      }
      *link = in->marks[r];
      in->marks[r] = 0;
      in->n_spare--;
      drop_regions(in->m, r, 1);
    }
    one->stamp = one->stamp < in->stamp ? in->stamp : one->stamp;
    one->base = one->base < in->base ? in->base : one->base;
  }
  renew_numbers(one);
}

/* Gives back what no thread has used. */
static inline void open_rest(concurrent *c)
{
  for (unsigned t = c->threads; t-- > 0;) {
    insertion *in = &c->in[t];
    drop_regions(in->m, in->fresh, in->fresh_end - in->fresh);
    in->fresh_end = in->fresh;
    while (in->n_spare)
      drop_regions(in->m, pop_spare(in), 1);
  }
}

#  undef GMDS__A_POINT
#endif
