/* Insertion by several threads, in models with GMDS_CONCURRENT_STARS: what the plane and space have in common.
 *
 * A first part of the points, a sample of all, goes in as ever. Then the points are cut into strips across an axis, in
 * space slabs, one a thread. Each thread inserts the points of its strip, going from cell to cell only where all nodes
 * are its own, and puts off those points for which that is not enough. Nothing is locked, and nothing needs to be:
 *   - a star removes and makes only cells of which all nodes are one thread's, and names the new ones in cells beyond
 *     sides of which all nodes are that thread's: no two threads write the same entry;
 *   - a thread reads the neighbours of cells that are its own, and the nodes of cells that share a side with such a
 *     cell: these are its own too or have nodes of several threads, and then nobody writes them.
 * The ghost counts as everyone's node. What was put off is cut into strips across the next axis, and the little that is
 * left after the last goes in by one thread. This is done in stages, of which each inserts seven times the points there
 * are: the finer the cells, the fewer have nodes of several threads. The triangulation is unique, so that it does not
 * depend on any of this; the numbering of cells depends on the number of threads alone.
 *
 * Where the cells of stars come from is a matter of the dimension: `supply`, open_stage(), open_round(), close_round(),
 * open_rest() and find_start() are defined in parallel.h and space/parallel.h. */
#define GMDS__SAMPLE 1024
#define GMDS__STAGE_RATIO 8 /* that of the rounds of the order (geometry/order.c) */

/* The work of all threads. */
typedef struct concurrent {
  unsigned threads;
  insertion *in;                /* one a thread */
  double cut[GMDS_MAX_THREADS]; /* strip t is from cut[t - 1] to below cut[t] */
  int axis;
  size_t n;                           /* points still to be inserted */
  gmds_id *waiting, *dealt;           /* these points, and the same by strips */
  size_t (*count)[GMDS_MAX_THREADS];  /* [t][s]: how many of part t of waiting are in strip s, then where they go */
  size_t begin[GMDS_MAX_THREADS + 1]; /* where the points of each strip begin in `dealt` */
  size_t kept[GMDS_MAX_THREADS];      /* how many of them were put off */
  int starts[GMDS_MAX_THREADS];       /* whether the thread has a cell to begin from */
  gmds_status status[GMDS_MAX_THREADS];
  const gmds_delaunay_options *options;
  supply supply;
  _Atomic size_t done; /* points inserted */
  _Atomic int calling; /* threads that are in options->progress, or would be */
  _Atomic int stopped; /* by the caller, or a failure */
} concurrent;

static inline void open_stage(concurrent *c);
static inline gmds_status open_round(concurrent *c);
static inline void close_round(concurrent *c);
static inline void open_rest(concurrent *c);
static inline int find_start(concurrent *c, unsigned t);

static inline unsigned strip_of(const concurrent *c, gmds_id v)
{
  double x = point(c->in->m, v)[c->axis];
  unsigned strip = 0;
  for (unsigned t = 0; t + 1 < c->threads; t++)
    strip += x >= c->cut[t];
  return strip;
}

static inline void count_part(void *work, unsigned t)
{
  concurrent *c = work;
  size_t end = GMDS_SHARE(c->n, t + 1, c->threads);
  for (size_t i = GMDS_SHARE(c->n, t, c->threads); i < end; i++)
    c->count[t][strip_of(c, c->waiting[i])]++;
}

static inline void deal_part(void *work, unsigned t)
{
  concurrent *c = work;
  size_t end = GMDS_SHARE(c->n, t + 1, c->threads);
  for (size_t i = GMDS_SHARE(c->n, t, c->threads); i < end; i++)
    c->dealt[c->count[t][strip_of(c, c->waiting[i])]++] = c->waiting[i];
}

/* Shell's sort: for a sample that is enough. */
static inline void sort_sample(size_t n, double *x)
{
  for (size_t gap = n / 2; gap > 0; gap /= 2)
    for (size_t i = gap; i < n; i++) {
      double value = x[i];
      size_t k = i;
      for (; k >= gap && x[k - gap] > value; k -= gap)
        x[k] = x[k - gap];
      x[k] = value;
    }
}

/* Cuts the points so that the strips hold like numbers of a sample of them, deals them, and tells the threads. */
static inline void cut_strips(concurrent *c, int axis)
{
  double sample[GMDS__SAMPLE];
  size_t n = c->n < GMDS__SAMPLE ? c->n : GMDS__SAMPLE;
  c->axis = axis;
  for (size_t i = 0; i < n; i++)
    sample[i] = point(c->in->m, c->waiting[c->n / n * i + c->n % n * i / n])[axis];
  sort_sample(n, sample);
  for (unsigned t = 0; t < c->threads; t++) {
    c->cut[t] = t + 1 < c->threads ? sample[n * (t + 1) / c->threads] : HUGE_VAL;
    memset(c->count[t], 0, sizeof c->count[t]);
  }
  gmds_share(c->threads, count_part, c);
  size_t sum = 0;
  for (unsigned s = 0; s < c->threads; s++) {
    c->begin[s] = sum;
    for (unsigned t = 0; t < c->threads; t++) {
      size_t here = c->count[t][s];
      c->count[t][s] = sum;
      sum += here;
    }
  }
  c->begin[c->threads] = sum;
  gmds_share(c->threads, deal_part, c);
}

/* Tells each thread which nodes are its own, and finds a finite cell of such nodes, from which its first walk
 * begins. */
static inline void assign_strips(concurrent *c)
{
  for (unsigned t = 0; t < c->threads; t++) {
    insertion *in = &c->in[t];
    in->axis = c->axis;
    in->low = t > 0 ? c->cut[t - 1] : -HUGE_VAL;
    in->high = t + 1 < c->threads ? c->cut[t] : HUGE_VAL;
    c->status[t] = GMDS_OK;
    c->kept[t] = c->begin[t + 1] - c->begin[t];
    c->starts[t] = find_start(c, t);
  }
}

/* Counts points as inserted and, if no other thread does so now, tells the caller how many are; notes when it wants no
 * more. Any thread may be the one: whichever has work goes on calling. */
static inline void tell_progress(concurrent *c, size_t inserted)
{
  const gmds_delaunay_options *o = c->options;
  c->done += inserted;
  if (!o || !o->progress)
    return;
  if (c->calling++ == 0 && o->progress(o->user, c->done, c->in->ghost))
    c->stopped = 1;
  c->calling--;
}

/* Inserts the points of strip t; those put off gather at its beginning. */
static inline void insert_strip(void *work, unsigned t)
{
  enum { EVERY = 4096 };
  concurrent *c = work;
  insertion *in = &c->in[t];
  gmds_id *waiting = c->dealt + c->begin[t];
  size_t n = c->starts[t] ? c->begin[t + 1] - c->begin[t] : 0, kept = 0, told = 0;
  for (size_t i = 0; i < n; i++) {
    if (i % EVERY == 0) {
      tell_progress(c, i - kept - told);
      told = i - kept;
      if (c->stopped)
        return;
    }
    in->deferred = 0;
    gmds_status status = insert_shared(in, waiting[i]);
    if (status != GMDS_OK) {
      c->status[t] = status;
      c->stopped = 1;
      return;
    }
    if (in->deferred)
      waiting[kept++] = waiting[i];
  }
  if (c->starts[t]) {
    c->kept[t] = kept;
    c->done += n - kept - told;
  }
}

/* One round of all threads over the points waiting[0 .. n). Those put off are waiting[0 .. n) then. */
static inline gmds_status insert_strips(concurrent *c, int axis)
{
  size_t n = 0;
  cut_strips(c, axis);
  GMDS_TRY(open_round(c));
  gmds_share(c->threads, insert_strip, c);
  close_round(c);
  for (unsigned t = 0; t < c->threads; t++) {
    GMDS_TRY(c->status[t]);
    memmove(c->waiting + n, c->dealt + c->begin[t], c->kept[t] * sizeof *c->waiting);
    n += c->kept[t];
  }
  c->n = n;
  return c->stopped ? GMDS_ERR_CANCELLED : GMDS_OK;
}

/* Inserts by one thread what all have put off. */
static inline gmds_status insert_rest(concurrent *c)
{
  enum { EVERY = 4096 };
  const unsigned threads = c->threads;
  open_rest(c);
  if (c->n == 0)
    return GMDS_OK;
  c->threads = 1;
  assign_strips(c); /* one strip of all */
  c->threads = threads;
  if (!c->starts[0])
    return GMDS_ERR_INVARIANT;
  for (size_t i = 0; i < c->n; i++) {
    if (i % EVERY == 0) {
      tell_progress(c, i ? EVERY : 0);
      if (c->stopped)
        return GMDS_ERR_CANCELLED;
    }
    GMDS_TRY(insert_alone(c->in, c->waiting[i]));
  }
  c->done += c->n - (c->n - 1) / EVERY * EVERY;
  return GMDS_OK;
}

/* Inserts nodes first to end - 1, a sample of the curve, but those in `but`, into the triangulation of those before. */
static inline gmds_status insert_stage(concurrent *c, gmds_id first, gmds_id end, const gmds_id but[2])
{
  open_stage(c);
  c->n = 0;
  for (gmds_id v = first; v < end; v++)
    if (v != but[0] && v != but[1])
      c->waiting[c->n++] = v;
  for (int axis = 0; axis < GMDS_TOP && c->n > 0; axis++)
    GMDS_TRY(insert_strips(c, axis));
  return insert_rest(c);
}

/* Inserts the nodes from `first` on, but those in `but`, into the triangulation of those before, which in[0] made;
 * in[1], ... are empty. Each stage has as many points as make a sample of the next. */
static inline gmds_status insert_by_threads(unsigned threads, insertion *in, gmds_id first, const gmds_id but[2],
                                            const gmds_delaunay_options *options)
{
  mesh *m = in->m;
  gmds_memory *memory = mesh_memory(m);
  const gmds_id end = in->ghost;
  size_t room = end - first;
  void *waiting = NULL, *dealt = NULL, *count = NULL, *block = NULL;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(memory, &block, 0, 1, sizeof(concurrent)) &&
      gmds_resize(memory, &waiting, 0, room, sizeof(gmds_id)) &&
      gmds_resize(memory, &dealt, 0, room, sizeof(gmds_id)) &&
      gmds_resize(memory, &count, 0, threads, GMDS_MAX_THREADS * sizeof(size_t))) {
    concurrent *c = block;
    memset(c, 0, sizeof *c);
    c->threads = threads;
    c->in = in;
    c->options = options;
    c->done = first;
    c->waiting = waiting;
    c->dealt = dealt;
    c->count = count;
    status = GMDS_OK;
    for (unsigned t = 0; t < threads && status == GMDS_OK; t++) {
      in[t].m = m;
      in[t].ghost = in->ghost;
      status = reserve_cavity(&in[t], 256);
    }
    for (gmds_id next; first < end && status == GMDS_OK; first = next) {
      next = first < end / GMDS__STAGE_RATIO ? first * GMDS__STAGE_RATIO : end;
      status = insert_stage(c, first, next, but);
    }
  }
  gmds_release(memory, waiting, waiting ? room : 0, sizeof(gmds_id));
  gmds_release(memory, dealt, dealt ? room : 0, sizeof(gmds_id));
  gmds_release(memory, count, count ? threads : 0, GMDS_MAX_THREADS * sizeof(size_t));
  gmds_release(memory, block, block ? 1 : 0, sizeof(concurrent));
  return status;
}

#undef GMDS__SAMPLE
#undef GMDS__STAGE_RATIO
