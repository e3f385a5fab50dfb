/* Bowyer-Watson written by hand for one data structure, triangles with their nodes and neighbours: what the generic
 * text (algorithms/delaunay.h) is compared with. The same algorithm, order and predicates, and the same memory; no
 * model, no query, no operation of a mesh: rows are read and written where they are needed.
 *
 *     handwritten_delaunay SPEC        points as `gmds delaunay` takes them; prints the same keys as its --json */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <gmds/checksum.h>
#include <gmds/io.h>
#include <gmds/order.h>
#include <gmds/predicates.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* A triangle entered over a side: entry = 4 * triangle + side, from a to b; c is the node across. */
typedef struct entered {
  gmds_id entry, a, b, c;
} entered;

typedef struct triangulation {
  gmds_memory memory;
  double *point;      /* 2 a node; the last node is the ghost, whose coordinates are not numbers */
  gmds_id *node;      /* 3 a triangle, counter-clockwise */
  gmds_id *neighbour; /* 3 a triangle: 4 * triangle + side beyond the side from node k to node k + 1 */
  size_t nodes, triangles, room;
  gmds_id ghost;
  gmds_id last; /* the entry from which the next walk begins */
  /* scratch space for a cavity */
  size_t capacity;
  gmds_id *ids;
  entered *sides, *pending;
} triangulation;

static const double *point_of(const triangulation *t, gmds_id v)
{
  return t->point + 2 * (size_t)v;
}

/* Where an entry is in the rows of three. */
static size_t place(gmds_id entry)
{
  return (size_t)entry - (entry >> 2);
}

static size_t place_after(gmds_id entry)
{
  return (entry & 3) < 2 ? place(entry) + 1 : place(entry) - 2;
}

static size_t place_before(gmds_id entry)
{
  return (entry & 3) > 0 ? place(entry) - 1 : place(entry) + 2;
}

/* Crosses the side at a place, from b to a as seen from the other side. */
static entered cross(const triangulation *t, size_t at, gmds_id a, gmds_id b)
{
  gmds_id entry = t->neighbour[at];
  return (entered){entry, a, b, t->node[place_before(entry)]};
}

static entered locate(const triangulation *t, const double p[2])
{
  size_t at = place(t->last);
  entered e = {t->last, t->node[at], t->node[place_after(t->last)], t->node[place_before(t->last)]};
  if (gmds_orient2d(point_of(t, e.a), point_of(t, e.b), p) < 0)
    e = cross(t, at, e.b, e.a);
  while (e.c != t->ghost) {
    if (gmds_orient2d(point_of(t, e.b), point_of(t, e.c), p) < 0)
      e = cross(t, place_after(e.entry), e.c, e.b);
    else if (gmds_orient2d(point_of(t, e.c), point_of(t, e.a), p) < 0)
      e = cross(t, place_before(e.entry), e.a, e.c);
    else
      break;
  }
  return e;
}

__attribute__((cold)) static int in_conflict_exactly(const triangulation *t, const entered *e, const double p[2])
{
  const gmds_id v[3] = {e->a, e->b, e->c};
  if (v[0] != t->ghost && v[1] != t->ghost && v[2] != t->ghost)
    return gmds_incircle_perturbed(point_of(t, v[0]), point_of(t, v[1]), point_of(t, v[2]), p) > 0;
  int g = v[0] == t->ghost ? 0 : v[1] == t->ghost ? 1 : 2;
  const double *a = point_of(t, v[(g + 1) % 3]), *b = point_of(t, v[(g + 2) % 3]);
  int side = gmds_orient2d(a, b, p);
  return side ? side > 0 : gmds_compare_points(2, a, p) * gmds_compare_points(2, p, b) > 0;
}

static unsigned in_conflict(const triangulation *t, entered e, entered f, const double p[2])
{
  unsigned undecided = 0;
  unsigned inside = gmds_incircle_filter_pair(point_of(t, e.a), point_of(t, e.b), point_of(t, e.c), point_of(t, f.a),
                                              point_of(t, f.b), point_of(t, f.c), p, &undecided);
  if (undecided & 1) {
    const entered copy = e;
    inside |= (unsigned)in_conflict_exactly(t, &copy, p);
  }
  if (undecided & 2) {
    const entered copy = f;
    inside |= (unsigned)in_conflict_exactly(t, &copy, p) << 1;
  }
  return inside;
}

static int reserve_cavity(triangulation *t, size_t n)
{
  if (n <= t->capacity)
    return 1;
  size_t had = t->capacity, grown = gmds_grown(had, n < 64 ? 64 : n);
  void *ids = t->ids, *sides = t->sides, *pending = t->pending;
  if (!gmds_resize(&t->memory, &ids, had, grown, sizeof *t->ids))
    return 0;
  t->ids = ids;
  if (!gmds_resize(&t->memory, &sides, had, grown, sizeof *t->sides))
    return 0;
  t->sides = sides;
  if (!gmds_resize(&t->memory, &pending, had, grown, sizeof *t->pending))
    return 0;
  t->pending = pending;
  t->capacity = grown;
  return 1;
}

/* Replaces the cavity of node v by its star. */
static int insert(triangulation *t, gmds_id v)
{
  const double *p = point_of(t, v);
  entered e = locate(t, p);
  entered left = cross(t, place(e.entry), e.b, e.a);
  size_t faces = 0, sides = 0, depth = 0;
  if (in_conflict(t, left, left, p) == 0)
    left.c = GMDS_NONE; /* pending, and known to lie outside */
  t->pending[depth++] = left;
  for (;;) {
    if (!reserve_cavity(t, faces + 4))
      return 0;
    t->ids[faces++] = e.entry >> 2;
    left = cross(t, place_after(e.entry), e.c, e.b);
    entered right = cross(t, place_before(e.entry), e.a, e.c);
    unsigned inside = in_conflict(t, left, right, p);
    if (inside & 1) {
      if (inside == 1)
        right.c = GMDS_NONE;
      t->pending[depth++] = right;
      e = left;
      continue;
    }
    t->sides[sides++] = left;
    if (inside) {
      e = right;
      continue;
    }
    t->sides[sides++] = right;
    while (depth && t->pending[depth - 1].c == GMDS_NONE)
      t->sides[sides++] = t->pending[--depth];
    if (!depth)
      break;
    e = t->pending[--depth];
  }
  t->ids[faces] = (gmds_id)t->triangles++;
  t->ids[faces + 1] = (gmds_id)t->triangles++;
  gmds_id before = t->ids[sides - 1];
  for (size_t i = 0; i < sides; i++) {
    const entered *side = &t->sides[i];
    gmds_id f = t->ids[i], *node = t->node + 3 * (size_t)f, *neighbour = t->neighbour + 3 * (size_t)f;
    node[0] = side->b;
    node[1] = side->a;
    node[2] = v;
    neighbour[0] = side->entry;
    t->neighbour[place(side->entry)] = 4 * f;
    neighbour[2] = 4 * before + 1;
    t->neighbour[3 * (size_t)before + 1] = 4 * f + 2;
    if (side->a != t->ghost && side->b != t->ghost)
      t->last = 4 * f;
    before = f;
  }
  return 1;
}

/* Removes the triangles at the ghost; the last ones move into their places. */
static void remove_ghost(triangulation *t)
{
  gmds_id *node = t->node, *neighbour = t->neighbour;
  for (size_t f = 0; f < t->triangles;) {
    if (node[3 * f] != t->ghost && node[3 * f + 1] != t->ghost && node[3 * f + 2] != t->ghost) {
      f++;
      continue;
    }
    for (int k = 0; k < 3; k++)
      if (neighbour[3 * f + (size_t)k] != GMDS_NONE)
        neighbour[place(neighbour[3 * f + (size_t)k])] = GMDS_NONE;
    size_t from = --t->triangles;
    if (from == f)
      break;
    memcpy(node + 3 * f, node + 3 * from, 3 * sizeof *node);
    memcpy(neighbour + 3 * f, neighbour + 3 * from, 3 * sizeof *neighbour);
    for (gmds_id k = 0; k < 3; k++)
      if (neighbour[3 * f + k] != GMDS_NONE)
        neighbour[place(neighbour[3 * f + k])] = 4 * (gmds_id)f + k;
  }
}

static gmds_status triangulate(triangulation *t, size_t n, const double *xy)
{
  void *order = NULL, *point = NULL, *node = NULL, *neighbour = NULL;
  gmds_memory *memory = &t->memory;
  GMDS_TRY(gmds_predicates_check());
  if (!gmds_resize(memory, &order, 0, n, sizeof(gmds_id)) || !gmds_resize(memory, &point, 0, n + 1, 2 * sizeof(double)))
    return GMDS_ERR_MEMORY;
  const gmds_id *at = order;
  t->point = point;
  void *scratch = gmds_order_scratch(n) <= 2 * sizeof(double) * n ? point : NULL;
  GMDS_TRY(gmds_order_points(memory, scratch, 1, 2, n, xy, NULL, order, NULL, &t->nodes));
  for (size_t k = 0; k < t->nodes; k++) {
    t->point[2 * k] = xy[2 * (size_t)at[k]] + 0.0;
    t->point[2 * k + 1] = xy[2 * (size_t)at[k] + 1] + 0.0;
  }
  t->point[2 * t->nodes] = t->point[2 * t->nodes + 1] = NAN;
  t->ghost = (gmds_id)t->nodes;
  gmds_release(memory, order, n, sizeof(gmds_id));
  gmds_id third = 2;
  int turn = 0;
  while (third < t->nodes && !(turn = gmds_orient2d(point_of(t, 0), point_of(t, 1), point_of(t, third))))
    third++;
  if (!turn)
    return GMDS_OK;
  t->room = 2 * t->nodes - 2;
  if (!gmds_resize(memory, &node, 0, t->room, 3 * sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  t->node = node;
  if (!gmds_resize(memory, &neighbour, 0, t->room, 3 * sizeof(gmds_id)) || !reserve_cavity(t, 64))
    return GMDS_ERR_MEMORY;
  t->neighbour = neighbour;
  const gmds_id a = turn<0, b = turn> 0, c = third, g = t->ghost;
  const gmds_id nodes[12] = {a, b, c, b, a, g, c, b, g, a, c, g};
  const gmds_id neighbours[12] = {4, 8, 12, 0, 12 + 2, 8 + 1, 1, 4 + 2, 12 + 1, 2, 8 + 2, 4 + 1};
  memcpy(t->node, nodes, sizeof nodes);
  memcpy(t->neighbour, neighbours, sizeof neighbours);
  t->triangles = 4;
  for (gmds_id v = 2; v < t->nodes; v++)
    if (v != third && !insert(t, v))
      return GMDS_ERR_MEMORY;
  remove_ghost(t);
  (void)gmds_resize(memory, &point, n + 1, t->nodes, 2 * sizeof(double));
  (void)gmds_resize(memory, &node, t->room, t->triangles, 3 * sizeof(gmds_id));
  (void)gmds_resize(memory, &neighbour, t->room, t->triangles, 3 * sizeof(gmds_id));
  t->point = point;
  t->node = node;
  t->neighbour = neighbour;
  gmds_release(memory, t->ids, t->capacity, sizeof *t->ids);
  gmds_release(memory, t->sides, t->capacity, sizeof *t->sides);
  gmds_release(memory, t->pending, t->capacity, sizeof *t->pending);
  return GMDS_OK;
}

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_error error;
  triangulation t = {.nodes = 0};
  if (argc != 2) {
    fprintf(stderr, "usage: handwritten_delaunay SPEC\n");
    return 2;
  }
  gmds_memory_init(&memory, NULL);
  gmds_memory_init(&t.memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  if (gmds_make_points(argv[1], 2, &error, &soup) != GMDS_OK) {
    fprintf(stderr, "handwritten_delaunay: %s\n", error.text);
    return 1;
  }
  double begin = now();
  gmds_status status = triangulate(&t, soup.n_points, soup.points);
  double seconds = now() - begin;
  if (status != GMDS_OK) {
    fprintf(stderr, "handwritten_delaunay: %s\n", gmds_status_text(status));
    return 1;
  }
  uint64_t sum = 0;
  for (size_t f = 0; f < t.triangles; f++) {
    uint64_t h = 0;
    (void)gmds_checksum_cell(2, t.point, 3, t.node + 3 * f, &h);
    sum += h;
  }
  printf("{\"points\":%zu,\"cells\":%zu,\"seconds\":%.6f,\"bytes\":%zu,\"peak_bytes\":%zu,\"checksum\":\"%016llx\"}\n",
         soup.n_points, t.triangles, seconds, t.memory.live, t.memory.peak, (unsigned long long)sum);
  return 0;
}
