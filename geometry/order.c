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

/* The frame of the box of n points; 0 when they are all equal. */
static int frame_init(frame *f, const sorter *s, size_t n, const item *items)
{
  double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX}, high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX}, extent = 0;
  const int dim = s->dim == 3 ? 3 : 2;
  for (size_t i = 0; i < n; i++) {
    const double *p = point_of(s, items[i]);
    for (int k = 0; k < dim; k++) {
      low[k] = p[k] < low[k] ? p[k] : low[k];
      high[k] = p[k] > high[k] ? p[k] : high[k];
    }
  }
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

/* Orders n points along the curve, equal points side by side as they came. Their keys are then 1 for a point that
 * equals the one before it, else 0. As deep as the file's opening comment says. */
static void order_along_curve(sorter *s, size_t n, item *items, item *scratch)
{
  if (n <= FEW) {
    order_few(s, n, items);
    return;
  }
  frame f;
  if (!frame_init(&f, s, n, items)) {
    for (size_t i = 0; i < n; i++)
      items[i].key = i > 0;
    return;
  }
  set_keys(s, &f, n, items);
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

/* How many rounds before the last a point is inserted, by its place among the distinct points (splitmix64's mixing). */
static unsigned rounds_before_last(uint64_t place, unsigned last)
{
  uint64_t z = (place + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  unsigned before = 0;
  for (; before < last && z % ROUND_RATIO == 0; z >>= ROUND_BITS)
    before++;
  return before;
}

/* Distributes the points on the curve over the rounds, and the equal ones over those that stand for them. */
static size_t deal(size_t n, const item *items, gmds_id *order, gmds_id *same_as)
{
  size_t distinct = 0, count[MAX_ROUNDS] = {0}, next[MAX_ROUNDS], begin = 0;
  for (size_t i = 0; i < n; i++)
    distinct += items[i].key == 0;
  unsigned last = 0;
  for (size_t m = distinct; m >= FIRST_ROUND && last < MAX_ROUNDS - 1; m /= ROUND_RATIO)
    last++;
  for (size_t place = 0; place < distinct; place++)
    count[last - rounds_before_last(place, last)]++;
  for (unsigned round = 0; round <= last; round++) {
    next[round] = round % 2 ? begin + count[round] - 1 : begin;
    begin += count[round];
  }
  for (size_t i = 0; same_as && i < n; i++)
    same_as[i] = (gmds_id)i;
  gmds_id stands = 0;
  for (size_t i = 0, place = 0; i < n; i++) {
    if (items[i].key == 0) {
      unsigned round = last - rounds_before_last(place++, last);
      order[round % 2 ? next[round]-- : next[round]++] = stands = items[i].id;
    } else if (same_as) {
      same_as[items[i].id] = stands;
    }
  }
  return distinct;
}

static gmds_status check_finite(int dim, size_t n, const double *xy, gmds_error *error)
{
  int finite = 1;
  for (size_t i = 0; i < n * (size_t)dim; i++)
    finite &= fabs(xy[i]) <= DBL_MAX;
  if (finite)
    return GMDS_OK;
  size_t i = 0;
  while (fabs(xy[i]) <= DBL_MAX)
    i++;
  size_t point = i / (size_t)dim;
  (void)gmds_fail(error, GMDS_ERR_COORDINATE, "point %zu (counted from 0): its %c is %g, not a finite number", point,
                  "xyz"[i % (size_t)dim], xy[i]);
  if (error)
    error->cell = (long long)point;
  return GMDS_ERR_COORDINATE;
}

gmds_status gmds_order_points(gmds_memory *memory, int dim, size_t n, const double *xy, gmds_error *error,
                              gmds_id *order, gmds_id *same_as, size_t *distinct)
{
  if (dim != 2 && dim != 3)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "points have 2 or 3 coordinates, not %d", dim);
  if (n / 2 > GMDS_ID_MAX / 2)
    return gmds_fail(error, GMDS_ERR_TOO_MANY, "%zu points are more than an identifier of %d bits can number", n,
                     GMDS_ID_BITS);
  GMDS_TRY(check_finite(dim, n, xy, error));
  if (n == 0) {
    *distinct = 0;
    return GMDS_OK;
  }
  void *block = NULL;
  if (n > SIZE_MAX / 2 || !gmds_resize(memory, &block, 0, 2 * n, sizeof(item)))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory: ordering %zu points takes %zu bytes a point", n,
                     2 * sizeof(item));
  item *items = block;
  for (size_t i = 0; i < n; i++)
    items[i].id = (gmds_id)i;
  sorter s;
  s.dim = dim;
  s.xy = xy;
  hilbert_init(&s.curve, dim);
  order_along_curve(&s, n, items, items + n);
  *distinct = deal(n, items, order, same_as);
  gmds_release(memory, block, 2 * n, sizeof(item));
  return GMDS_OK;
}
