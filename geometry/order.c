/* Insertion orders: a Hilbert curve (hilbert.h) in rounds.
 *
 * Points are sorted by their place on the curve through a grid over their bounding box, 2^16 cells a side in 2D and
 * 2^10 in 3D. Points of one cell are ordered in the same way within their own box, so that clusters and mixed scales
 * keep their locality. Each level shrinks the box nearly 2^16 or 2^10 times, and the range of exponents ends the
 * recursion after 135 or 220 levels for any points; of spread points few go beyond the first. Equal points end in one
 * group.
 *
 * Rounds: the place on the curve, hashed, puts a point into the last round with probability 7/8, else into the one
 * before with 7/8, and so on (Amenta, Choi and Rote 2003, with fewer and larger rounds than their halving: each round
 * costs the walk a pass over the curve). Every other round runs along the curve backwards, from where the last ended.
 */
#include "hilbert.h"
#include "radix.h"
#include <float.h>
#include <gmds/order.h>
#include <gmds/predicates.h>
#include <gmds/threads.h>

enum {
  FEW = 16,           /* up to so many points of one cell are sorted by coordinates */
  MANY = 1024,        /* from so many on keys are sorted by digits */
  ROUND_RATIO = 8,    /* between the sizes of consecutive rounds, a power of two */
  ROUND_BITS = 3,     /* its logarithm */
  FIRST_ROUND = 1024, /* the first round holds fewer */
  MAX_ROUNDS = 20
};

typedef struct sorter {
  int dim;
  const double *xy;
  hilbert curve;
  radix_counts counts;
} sorter;

/* Maps coordinates to cells: (x half - low) first second. */
typedef struct frame {
  double low[3];
  double half;          /* 1/2 where the box is wider than the largest double, else 1 */
  double first, second; /* two factors, since one may not be finite for subnormal boxes */
} frame;

static const double *point_of(const sorter *s, item it)
{
  return s->xy + (size_t)it.id * (size_t)s->dim;
}

typedef struct box {
  double low[3], high[3];
} box;

static const box nothing = {{DBL_MAX, DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX, -DBL_MAX}};

static void box_add(box *b, int dim, const double *p)
{
  for (int k = 0; k < dim; k++) {
    b->low[k] = p[k] < b->low[k] ? p[k] : b->low[k];
    b->high[k] = p[k] > b->high[k] ? p[k] : b->high[k];
  }
}

/* The frame of a box; 0 when it is a point. */
static int frame_init(frame *f, int dim, const box *b)
{
  const double *low = b->low, *high = b->high;
  double extent = 0;
  f->half = 1;
  for (int k = 0; k < dim; k++)
    if (high[k] - low[k] > DBL_MAX)
      f->half = 0.5;
  for (int k = 0; k < dim; k++) {
    f->low[k] = low[k] * f->half;
    double width = high[k] * f->half - f->low[k];
    extent = width > extent ? width : extent;
  }
  if (extent == 0)
    return 0;
  /* The widest side takes all cells: its ends are in the first and the last, whatever the roundings, so that a box
   * always falls apart. */
  double cells = (dim == 2 ? 1 << HILBERT_BITS_2D : 1 << HILBERT_BITS_3D) - 0x1p-4;
  f->first = extent < 0x1p-900 ? 0x1p600 : 1;
  f->second = cells / (extent * f->first);
  return 1;
}

static uint32_t cell_of(const frame *f, int k, double x)
{
  return (uint32_t)((x * f->half - f->low[k]) * f->first * f->second);
}

static void set_keys(const sorter *s, const frame *f, size_t n, item *items)
{
  if (s->dim == 2)
    for (size_t i = 0; i < n; i++) {
      const double *p = point_of(s, items[i]);
      items[i].key = hilbert_place_2d(&s->curve, cell_of(f, 0, p[0]), cell_of(f, 1, p[1]));
    }
  else
    for (size_t i = 0; i < n; i++) {
      const double *p = point_of(s, items[i]);
      items[i].key = hilbert_place_3d(&s->curve, cell_of(f, 0, p[0]), cell_of(f, 1, p[1]), cell_of(f, 2, p[2]));
    }
}

/* Sorts a few points by their coordinates. */
static void order_few(const sorter *s, size_t n, item *items)
{
  for (size_t i = 1; i < n; i++) {
    item it = items[i];
    size_t j = i;
    for (; j > 0 && gmds_compare_points(s->dim, point_of(s, items[j - 1]), point_of(s, it)) > 0; j--)
      items[j] = items[j - 1];
    items[j] = it;
  }
  for (size_t i = n; i-- > 0;)
    items[i].key = i > 0 && gmds_compare_points(s->dim, point_of(s, items[i - 1]), point_of(s, items[i])) == 0;
}

static void order_by_keys(sorter *s, size_t n, item *items, item *scratch);

/* Orders n points along the curve, equal points side by side as they came. Their keys are then 1 for a point that
 * equals the one before it, else 0. As deep as the file's opening comment says. */
static void order_along_curve(sorter *s, size_t n, item *items, item *scratch)
{
  if (n <= FEW) {
    order_few(s, n, items);
    return;
  }
  frame f;
  box b = nothing;
  for (size_t i = 0; i < n; i++)
    box_add(&b, s->dim == 3 ? 3 : 2, point_of(s, items[i]));
  if (!frame_init(&f, s->dim, &b)) {
    for (size_t i = 0; i < n; i++)
      items[i].key = i > 0;
    return;
  }
  set_keys(s, &f, n, items);
  order_by_keys(s, n, items, scratch);
}

static void order_by_keys(sorter *s, size_t n, item *items, item *scratch)
{
  item *sorted = n < MANY ? merge_sort(n, items, scratch) : radix_sort(&s->counts, n, items, scratch);
  if (sorted != items)
    memcpy(items, sorted, n * sizeof *items);
  for (size_t begin = 0, end; begin < n; begin = end) {
    uint32_t key = items[begin].key;
    for (end = begin + 1; end < n && items[end].key == key;)
      end++;
    if (end - begin > 1)
      order_along_curve(s, end - begin, items + begin, scratch + begin);
    else
      items[begin].key = 0;
  }
}

/* How many rounds before the last a point is inserted, by its place among the distinct points (splitmix64's mixing):
 * one for each factor of the ratio in a random number. */
static unsigned rounds_before_last(uint64_t place, unsigned last)
{
  uint64_t z = (place + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  unsigned before = (unsigned)__builtin_ctzll(z | UINT64_C(1) << 63) / ROUND_BITS;
  return before < last ? before : last;
}

/* ---- the work of several threads: each has a part of the points, then an interval of the curve */

enum {
  TOP_BITS = 11, /* intervals of the curve are told apart by so many bits of the key */
  TOPS = 1 << TOP_BITS
};

typedef struct part {
  sorter sort;
  size_t not_finite; /* the first coordinate of the part that is not finite, or SIZE_MAX */
  box bounds;
  gmds_id top[TOPS];              /* how many points of the part have these top bits */
  gmds_id next[GMDS_MAX_THREADS]; /* where the part's next point of each interval goes */
  size_t distinct;                /* in the part of the ordered points */
  size_t count[MAX_ROUNDS];       /* of these, how many are inserted in each round */
  size_t first[MAX_ROUNDS];       /* where the first of them goes */
} part;

typedef struct ordering {
  unsigned threads;
  int dim;
  size_t n;
  const double *xy;
  item *items, *scratch;
  frame f;
  size_t begin[GMDS_MAX_THREADS + 1]; /* of each interval among the points */
  unsigned short interval[TOPS];      /* of the keys with these top bits */
  unsigned last;                      /* the number of the last round */
  gmds_id *order, *same_as;
  part *parts;
} ordering;

static size_t part_begin(const ordering *o, unsigned t)
{
  return GMDS_SHARE(o->n, t, o->threads);
}

static void bound_part(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  const int dim = o->dim == 3 ? 3 : 2;
  size_t first = part_begin(o, t), end = part_begin(o, t + 1);
  int finite = 1;
  p->bounds = nothing;
  p->not_finite = SIZE_MAX;
  for (size_t i = first; i < end; i++) {
    box_add(&p->bounds, dim, o->xy + i * (size_t)dim);
    for (int k = 0; k < dim; k++)
      finite &= fabs(o->xy[i * (size_t)dim + (size_t)k]) <= DBL_MAX;
  }
  if (finite)
    return;
  p->not_finite = first * (size_t)dim;
  while (fabs(o->xy[p->not_finite]) <= DBL_MAX)
    p->not_finite++;
}

static void number_part(const ordering *o, unsigned t)
{
  for (size_t i = part_begin(o, t); i < part_begin(o, t + 1); i++)
    o->items[i].id = (gmds_id)i;
}

/* Keys of the part's points, and how many fall into each interval. */
static void key_part(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  size_t first = part_begin(o, t), end = part_begin(o, t + 1);
  const int shift = o->dim == 2 ? 2 * HILBERT_BITS_2D - TOP_BITS : 3 * HILBERT_BITS_3D - TOP_BITS;
  number_part(o, t);
  p->sort = (sorter){.dim = o->dim, .xy = o->xy};
  hilbert_init(&p->sort.curve, o->dim);
  set_keys(&p->sort, &o->f, end - first, o->items + first);
  memset(p->top, 0, sizeof p->top);
  for (size_t i = first; i < end; i++)
    p->top[o->items[i].key >> shift]++;
}

/* Cuts the curve into intervals of like numbers of points. */
static void cut_curve(ordering *o)
{
  size_t sum = 0, place[GMDS_MAX_THREADS] = {0};
  unsigned s = 0;
  o->begin[0] = 0;
  for (unsigned top = 0; top < TOPS; top++) {
    while (s + 1 < o->threads && sum >= GMDS_SHARE(o->n, s + 1, o->threads))
      o->begin[++s] = sum;
    o->interval[top] = (unsigned short)s;
    for (unsigned t = 0; t < o->threads; t++)
      sum += o->parts[t].top[top];
  }
  while (s < o->threads)
    o->begin[++s] = o->n;
  memcpy(place, o->begin, o->threads * sizeof *place);
  for (unsigned t = 0; t < o->threads; t++) {
    part *p = &o->parts[t];
    for (s = 0; s < o->threads; s++)
      p->next[s] = (gmds_id)place[s];
    for (unsigned top = 0; top < TOPS; top++)
      place[o->interval[top]] += p->top[top];
  }
}

static void deal_part(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  const int shift = o->dim == 2 ? 2 * HILBERT_BITS_2D - TOP_BITS : 3 * HILBERT_BITS_3D - TOP_BITS;
  size_t end = part_begin(o, t + 1);
  for (size_t i = part_begin(o, t); i < end; i++)
    o->scratch[p->next[o->interval[o->items[i].key >> shift]]++] = o->items[i];
}

static void order_interval(void *work, unsigned t)
{
  ordering *o = work;
  size_t first = o->begin[t], n = o->begin[t + 1] - first;
  if (n)
    order_by_keys(&o->parts[t].sort, n, o->scratch + first, o->items + first);
}

static void count_distinct(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  size_t end = part_begin(o, t + 1);
  p->distinct = 0;
  for (size_t i = part_begin(o, t); i < end; i++)
    p->distinct += o->items[i].key == 0;
}

/* Which place the first distinct point of a part has along the curve. */
static size_t first_place(const ordering *o, unsigned t)
{
  size_t place = 0;
  for (unsigned before = 0; before < t; before++)
    place += o->parts[before].distinct;
  return place;
}

static void count_rounds(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  size_t place = first_place(o, t), end = place + p->distinct;
  memset(p->count, 0, sizeof p->count);
  for (; place < end; place++)
    p->count[o->last - rounds_before_last(place, o->last)]++;
}

/* Where each part's points of each round go: odd rounds run backwards. */
static void place_rounds(ordering *o)
{
  size_t begin = 0;
  for (unsigned round = 0; round <= o->last; round++) {
    size_t here = 0;
    for (unsigned t = 0; t < o->threads; t++)
      here += o->parts[t].count[round];
    size_t forwards = begin, backwards = begin + here;
    for (unsigned t = 0; t < o->threads; t++) {
      part *p = &o->parts[t];
      p->first[round] = round % 2 ? backwards - 1 : forwards;
      forwards += p->count[round];
      backwards -= p->count[round];
    }
    begin += here;
  }
}

/* Distributes the distinct points over the rounds, and gives the equal ones those that stand for them. */
static void deal_rounds(void *work, unsigned t)
{
  ordering *o = work;
  part *p = &o->parts[t];
  size_t place = first_place(o, t), end = part_begin(o, t + 1), i = part_begin(o, t), before = i;
  if (o->same_as && i < end) {
    while (o->items[before].key != 0)
      before--;
  }
  gmds_id stands = i < end ? o->items[before].id : 0;
  for (; i < end; i++) {
    gmds_id id = o->items[i].id;
    if (o->items[i].key == 0) {
      unsigned round = o->last - rounds_before_last(place++, o->last);
      o->order[round % 2 ? p->first[round]-- : p->first[round]++] = stands = id;
    }
    if (o->same_as)
      o->same_as[id] = stands;
  }
}

static gmds_status check_finite(const ordering *o, gmds_error *error)
{
  for (unsigned t = 0; t < o->threads; t++)
    if (o->parts[t].not_finite != SIZE_MAX) {
      size_t i = o->parts[t].not_finite, point = i / (size_t)o->dim;
      (void)gmds_fail(error, GMDS_ERR_COORDINATE, "point %zu (counted from 0): its %c is %g, not a finite number",
                      point, "xyz"[i % (size_t)o->dim], o -> xy[i]);
      if (error)
        error->cell = (long long)point;
      return GMDS_ERR_COORDINATE;
    }
  return GMDS_OK;
}

/* The points in their order along the curve, in o->items, equal ones marked. */
static void order_all(ordering *o)
{
  box b = nothing;
  for (unsigned t = 0; t < o->threads; t++) {
    box_add(&b, 3, o->parts[t].bounds.low);
    box_add(&b, 3, o->parts[t].bounds.high);
  }
  int flat = !frame_init(&o->f, o->dim, &b); /* all points are equal */
  if (o->threads > 1 && !flat) {
    gmds_share(o->threads, key_part, o);
    cut_curve(o);
    gmds_share(o->threads, deal_part, o);
    gmds_share(o->threads, order_interval, o);
    item *ordered = o->scratch;
    o->scratch = o->items;
    o->items = ordered;
    return;
  }
  for (unsigned t = 0; t < o->threads; t++)
    number_part(o, t);
  o->parts->sort = (sorter){.dim = o->dim, .xy = o->xy};
  hilbert_init(&o->parts->sort.curve, o->dim);
  if (flat || o->n <= FEW) {
    order_along_curve(&o->parts->sort, o->n, o->items, o->scratch);
  } else {
    set_keys(&o->parts->sort, &o->f, o->n, o->items);
    order_by_keys(&o->parts->sort, o->n, o->items, o->scratch);
  }
}

size_t gmds_order_scratch(size_t n)
{
  return n > SIZE_MAX / (2 * sizeof(item)) ? SIZE_MAX : 2 * n * sizeof(item);
}

static gmds_status order_points(gmds_memory *memory, void *scratch, unsigned threads, int rounds, int dim, size_t n,
                                const double *xy, gmds_error *error, gmds_id *order, gmds_id *same_as, size_t *distinct)
{
  enum { WORTH = 1 << 15 }; /* points a thread */
  if (dim != 2 && dim != 3)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "points have 2 or 3 coordinates, not %d", dim);
  if (n / 2 > GMDS_ID_MAX / 2)
    return gmds_fail(error, GMDS_ERR_TOO_MANY, "%zu points are more than an identifier of %d bits can number", n,
                     GMDS_ID_BITS);
  if (n / WORTH < threads)
    threads = (unsigned)(n / WORTH);
  threads = threads < 1 ? 1 : threads > GMDS_MAX_THREADS ? GMDS_MAX_THREADS : threads;
  part alone;
  void *block = NULL, *parts = NULL;
  ordering o = {.threads = threads, .dim = dim, .n = n, .xy = xy, .order = order, .same_as = same_as};
  gmds_status status = GMDS_ERR_MEMORY;
  if (threads == 1 || gmds_resize(memory, &parts, 0, threads, sizeof(part))) {
    o.parts = parts ? parts : &alone;
    gmds_share(threads, bound_part, &o);
    status = check_finite(&o, error);
    if (status == GMDS_OK && !scratch && !gmds_resize(memory, &block, 0, 1, gmds_order_scratch(n)))
      status = GMDS_ERR_MEMORY;
  }
  if (status == GMDS_OK) {
    o.items = scratch ? scratch : block;
    o.scratch = n ? o.items + n : NULL;
    *distinct = 0;
    if (n)
      order_all(&o);
    gmds_share(threads, count_distinct, &o);
    *distinct = first_place(&o, threads);
    for (size_t m = rounds ? *distinct : 0; m >= FIRST_ROUND && o.last < MAX_ROUNDS - 1; m /= ROUND_RATIO)
      o.last++;
    gmds_share(threads, count_rounds, &o);
    place_rounds(&o);
    gmds_share(threads, deal_rounds, &o);
  } else if (status == GMDS_ERR_MEMORY)
    (void)gmds_fail(error, status, "out of memory: ordering %zu points takes %zu bytes a point", n, 2 * sizeof(item));
  gmds_release(memory, block, block != NULL, gmds_order_scratch(n));
  gmds_release(memory, parts, parts ? threads : 0, sizeof(part));
  return status;
}

gmds_status gmds_order_points(gmds_memory *memory, void *scratch, unsigned threads, int dim, size_t n, const double *xy,
                              gmds_error *error, gmds_id *order, gmds_id *same_as, size_t *distinct)
{
  return order_points(memory, scratch, threads, 1, dim, n, xy, error, order, same_as, distinct);
}

gmds_status gmds_order_along_curve(gmds_memory *memory, int dim, size_t n, const double *xy, gmds_error *error,
                                   gmds_id *order, gmds_id *same_as, size_t *distinct)
{
  return order_points(memory, NULL, 1, 0, dim, n, xy, error, order, same_as, distinct);
}
