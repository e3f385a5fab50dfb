/* Bowyer-Watson in space written by hand for one data structure, tetrahedra with their nodes and neighbours: what the
 * generic text is compared with. The same algorithm, order and predicates, and the same memory; no model, no query, no
 * operation of a mesh: rows are read and written where they are needed.
 *
 *     handwritten_delaunay3 SPEC        points as `gmds delaunay` takes them; prints the same keys as its --json
 *
 * A tetrahedron has its nodes in the order of VTK, 3 above the counter-clockwise triangle 0, 1, 2, and its faces too,
 * each counter-clockwise from outside. An insertion has three parts: a walk to a tetrahedron whose sphere holds the
 * point; the cavity, all such tetrahedra, breadth first; its star, one tetrahedron a face of the cavity's boundary. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <gmds/checksum.h>
#include <gmds/io.h>
#include <gmds/order.h>
#include <gmds/predicates.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* A tetrahedron of a cavity as it was. */
typedef struct former {
  gmds_id node[4], neighbour[4];
} former;

/* The nodes of a face of a cavity's boundary as numbered within it. */
typedef struct corners {
  gmds_id x, y, z;
} corners;

typedef struct triangulation {
  gmds_memory memory;
  double *point;      /* 3 a node; the last node is the ghost, whose coordinates are not numbers */
  gmds_id *node;      /* 4 a tetrahedron */
  gmds_id *neighbour; /* 4 a tetrahedron: 4 * tetrahedron + face beyond each face */
  gmds_id *mark;      /* a tetrahedron: 2 v + 1 in the cavity of node v, 2 v tested and outside, else less */
  gmds_id *local;     /* a node: base + its number within the boundary of the cavity at work, else less */
  size_t nodes, tetrahedra, room;
  gmds_id ghost, base;
  gmds_id last; /* the tetrahedron from which the next walk begins */
  /* scratch space for a cavity */
  size_t capacity;
  gmds_id *ids; /* of the cavity, then of the star */
  gmds_id *tested;
  gmds_id *sides; /* 4 * place in the cavity + face, for each face of its boundary */
  former *cavity;
  corners *corner;
  size_t spares, spares_room; /* identifiers that are free */
  gmds_id *spare;
  size_t edges; /* entries of `edge`, which finds the tetrahedron on a directed edge of the boundary */
  gmds_id *edge;
} triangulation;

/* The nodes of each face and the one opposite to it. */
static const unsigned char on_face[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}, opposite[4] = {2, 0, 1, 3};

enum { WIDTH = 64 }; /* boundaries with more nodes link their tetrahedra by hashing */

static const double *point_of(const triangulation *t, gmds_id v)
{
  return t->point + 3 * (size_t)v;
}

static int resize_ids(triangulation *t, gmds_id **ids, size_t had, size_t n)
{
  void *block = *ids;
  int done = gmds_resize(&t->memory, &block, had, n, sizeof **ids);
  *ids = block;
  return done;
}

/* Room for a cavity of n. What is counted by faces, of which a cavity of n has at most 2 n + 2 in its boundary and
 * tests at most 4 n tetrahedra, has four times as much. */
static int reserve_cavity(triangulation *t, size_t n)
{
  if (n <= t->capacity)
    return 1;
  size_t had = t->capacity, grown = gmds_grown(had, n);
  void *cavity = t->cavity, *corner = t->corner;
  if (!resize_ids(t, &t->ids, 4 * had, 4 * grown) || !resize_ids(t, &t->tested, 4 * had, 4 * grown) ||
      !resize_ids(t, &t->sides, 4 * had, 4 * grown) || !gmds_resize(&t->memory, &cavity, had, grown, sizeof(former)))
    return 0;
  t->cavity = cavity;
  if (!gmds_resize(&t->memory, &corner, 4 * had, 4 * grown, sizeof(corners)))
    return 0;
  t->corner = corner;
  t->capacity = grown;
  return 1;
}

static int reserve_tetrahedra(triangulation *t, size_t n)
{
  if (n <= t->room)
    return 1;
  size_t had = t->room, grown = had + (had / 8 > n - had ? had / 8 : n - had);
  if (!resize_ids(t, &t->node, 4 * had, 4 * grown) || !resize_ids(t, &t->neighbour, 4 * had, 4 * grown) ||
      !resize_ids(t, &t->mark, had, grown))
    return 0;
  t->room = grown;
  return 1;
}

/* ---- the walk */

static int has_ghost(const triangulation *t, gmds_id id)
{
  const gmds_id *v = t->node + 4 * (size_t)id;
  return v[0] == t->ghost || v[1] == t->ghost || v[2] == t->ghost || v[3] == t->ghost;
}

/* A tetrahedron that p lies in, or one at the ghost that it is in conflict with. The walk crosses any face that p is
 * beyond; in a Delaunay triangulation, perturbed or not, it does not return. */
static gmds_id locate(const triangulation *t, const double p[3])
{
  gmds_id at = t->last;
  for (unsigned k = 0; k < 4; k++)
    if (t->node[4 * (size_t)at + opposite[k]] == t->ghost) {
      at = t->neighbour[4 * (size_t)at + k] >> 2;
      break;
    }
  unsigned from = 4;
  for (;;) {
    const gmds_id *v = t->node + 4 * (size_t)at;
    unsigned k = 0;
    for (; k < 4; k++)
      if (k != from && gmds_orient3d(point_of(t, v[on_face[k][0]]), point_of(t, v[on_face[k][1]]),
                                     point_of(t, v[on_face[k][2]]), p) > 0)
        break;
    if (k == 4)
      return at;
    gmds_id next = t->neighbour[4 * (size_t)at + k];
    at = next >> 2;
    from = next & 3;
    if (t->node[4 * (size_t)at + opposite[from]] == t->ghost)
      return at;
  }
}

/* ---- the cavity */

__attribute__((cold, noinline)) static unsigned in_conflict_exactly(const triangulation *t, gmds_id id,
                                                                    const double p[3])
{
  const gmds_id *v = t->node + 4 * (size_t)id;
  const double *q[4], *finite[3];
  int ghosts = 0, n = 0;
  for (int k = 0; k < 4; k++) {
    q[k] = point_of(t, v[k]);
    if (v[k] == t->ghost) {
      q[k] = p;
      ghosts++;
    } else if (n < 3)
      finite[n++] = q[k];
  }
  if (!ghosts)
    return gmds_insphere_perturbed_exact(q[0], q[1], q[2], q[3], p) > 0;
  int sign = gmds_orient3d(q[0], q[1], q[2], q[3]);
  return (sign ? sign : gmds_coplanar_incircle_perturbed(finite[0], finite[1], finite[2], p)) > 0;
}

static unsigned in_conflict(const triangulation *t, gmds_id first, gmds_id second, const double p[3])
{
  const gmds_id *v = t->node + 4 * (size_t)first, *w = t->node + 4 * (size_t)second;
  unsigned undecided;
  unsigned inside = gmds_insphere_filter_pair(point_of(t, v[0]), point_of(t, v[1]), point_of(t, v[2]),
                                              point_of(t, v[3]), point_of(t, w[0]), point_of(t, w[1]),
                                              point_of(t, w[2]), point_of(t, w[3]), p, &undecided);
  if (undecided & 1)
    inside |= in_conflict_exactly(t, first, p);
  if (undecided & 2)
    inside |= in_conflict_exactly(t, second, p) << 1;
  return inside;
}

/* Fills t->ids and t->cavity from a tetrahedron in conflict with node v; the value is how many there are, 0 without
 * memory. Each tetrahedron is tested once, two at a time, and appended without a branch; what will be read of those in
 * the queue, and of the numbers of nodes, is on its way meanwhile. */
static size_t find_cavity(triangulation *t, gmds_id start, gmds_id v)
{
  const double *p = point_of(t, v);
  const gmds_id outside = 2 * v, inside = 2 * v + 1, *const node = t->node, *const neighbour = t->neighbour;
  gmds_id *const mark = t->mark, *ids = t->ids, *tested = t->tested;
  size_t n = 1, n_tested = 0, done = 0;
  ids[0] = start;
  mark[start] = inside;
  for (size_t i = 0; i < n; i++) {
    if (n + 8 > t->capacity) {
      if (!reserve_cavity(t, n + 8))
        return 0;
      ids = t->ids;
      tested = t->tested;
    }
    former *f = &t->cavity[i];
    memcpy(f->node, node + 4 * (size_t)ids[i], sizeof f->node);
    memcpy(f->neighbour, neighbour + 4 * (size_t)ids[i], sizeof f->neighbour);
    for (int k = 0; k < 4; k++) {
      gmds_id next = f->neighbour[k] >> 2, had = mark[next];
      tested[n_tested] = next;
      n_tested += had < outside;
      __builtin_prefetch(node + 4 * (size_t)next);
      __builtin_prefetch(neighbour + 4 * (size_t)next);
      __builtin_prefetch(t->local + f->node[k]);
      mark[next] = had < outside ? outside : had;
    }
    /* One that is left over waits for another as long as there can be one; then it is tested beside the first of all,
     * which stays what it is. */
    if (i + 1 == n && (n_tested - done) % 2)
      tested[n_tested++] = start;
    while (done + 2 <= n_tested) {
      gmds_id first = tested[done], second = tested[done + 1];
      unsigned in = in_conflict(t, first, second, p);
      ids[n] = second;
      n += (in >> 1) & (second != start);
      mark[second] = outside + (in >> 1);
      ids[n] = first;
      n += in & 1;
      mark[first] = outside + (in & 1);
      done += 2;
    }
  }
  return n;
}

/* ---- the star */

/* The number of a node within the boundary at work, the next one if it has none. */
static gmds_id number(gmds_id *local, gmds_id v, gmds_id base, gmds_id *count)
{
  gmds_id had = local[v], next = base + *count, is_new = had < base, l = had ^ ((had ^ next) & (0 - is_new));
  local[v] = l;
  *count += is_new;
  return l - base;
}

/* The faces of the cavity's n tetrahedra whose other side is outside, as t->sides; the value is how many. */
static size_t find_sides(triangulation *t, size_t n, gmds_id v)
{
  const gmds_id inside = 2 * v + 1, *mark = t->mark;
  const former *cavity = t->cavity;
  gmds_id *sides = t->sides;
  size_t n_sides = 0;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < 4; k++) {
      sides[n_sides] = (gmds_id)(4 * i + k);
      n_sides += mark[cavity[i].neighbour[k] >> 2] != inside;
    }
  return n_sides;
}

/* Makes the n identifiers of the cavity n_sides for the star: others come from the spare ones, then from the end. */
static int take_ids(triangulation *t, size_t n_sides, size_t n)
{
  if (!reserve_tetrahedra(t, t->tetrahedra + n_sides))
    return 0;
  for (; n < n_sides && t->spares; n++)
    t->ids[n] = t->spare[--t->spares];
  for (; n < n_sides; n++) {
    t->mark[t->tetrahedra] = 0;
    t->ids[n] = (gmds_id)t->tetrahedra++;
  }
  if (n_sides == n)
    return 1;
  size_t more = n - n_sides, grown = t->spares + more;
  if (grown > t->spares_room) {
    grown = gmds_grown(t->spares_room, grown);
    if (!resize_ids(t, &t->spare, t->spares_room, grown))
      return 0;
    t->spares_room = grown;
  }
  memcpy(t->spare + t->spares, t->ids + n_sides, more * sizeof *t->spare);
  t->spares += more;
  return 1;
}

/* The place of a directed edge in a hash table of mask + 1 entries: of itself, or an empty one. */
static size_t edge_slot(const gmds_id *table, size_t mask, gmds_id from, gmds_id to)
{
  size_t h = (size_t)(((uint64_t)from << 32 | to) * 0x9e3779b97f4a7c15u >> 32) & mask;
  while (table[3 * h + 2] != GMDS_NONE && (table[3 * h] != from || table[3 * h + 1] != to))
    h = (h + 1) & mask;
  return 3 * h;
}

/* Links the tetrahedra of the star where their boundary has too many nodes for a table. */
static int link_by_hash(triangulation *t, size_t n_sides)
{
  size_t edges = 1;
  while (edges < 6 * n_sides)
    edges *= 2;
  if (t->edges < edges) {
    if (!resize_ids(t, &t->edge, 3 * t->edges, 3 * edges))
      return 0;
    t->edges = edges;
  }
  gmds_id *const table = t->edge;
  memset(table, 0xff, 3 * edges * sizeof *table);
  for (int link = 0; link < 2; link++)
    for (size_t i = 0; i < n_sides; i++) {
      const size_t id = t->ids[i];
      const gmds_id *row = t->node + 4 * id;
      for (gmds_id k = 0; k < 3; k++) {
        gmds_id from = row[on_face[k][1]], to = row[on_face[k][0]];
        if (link)
          t->neighbour[4 * id + k] = table[edge_slot(table, edges - 1, to, from) + 2];
        else {
          size_t slot = edge_slot(table, edges - 1, from, to);
          table[slot] = from;
          table[slot + 1] = to;
          table[slot + 2] = 4 * t->ids[i] + k;
        }
      }
    }
  return 1;
}

/* Joins each side to node v. The tetrahedron x, z, y, v has the side as face 3, and on faces 0, 1 and 2 the edges z x,
 * y z and x y. A table over the numbers of the boundary's nodes takes a directed edge to the face on it. */
static int fill_cavity(triangulation *t, size_t n, gmds_id v)
{
  size_t n_sides = find_sides(t, n, v), n_nodes = n_sides / 2 + 2;
  if (!take_ids(t, n_sides, n))
    return 0;
  gmds_id table[WIDTH * WIDTH], count = 0;
  gmds_id *const node = t->node, *const neighbour = t->neighbour, *const local = t->local;
  const gmds_id base = t->base;
  for (size_t i = 0; i < n_sides; i++) {
    gmds_id side = t->sides[i], face = 4 * t->ids[i];
    const former *f = &t->cavity[side >> 2];
    const unsigned char *on = on_face[side & 3];
    gmds_id x = f->node[on[0]], y = f->node[on[1]], z = f->node[on[2]], beyond = f->neighbour[side & 3];
    node[face] = x;
    node[face + 1] = z;
    node[face + 2] = y;
    node[face + 3] = v;
    neighbour[face + 3] = beyond;
    neighbour[beyond] = face + 3;
    x = number(local, x, base, &count);
    y = number(local, y, base, &count);
    z = number(local, z, base, &count);
    t->corner[i] = (corners){x, y, z};
    x %= WIDTH;
    y %= WIDTH;
    z %= WIDTH;
    table[z * WIDTH + x] = face;
    table[y * WIDTH + z] = face + 1;
    table[x * WIDTH + y] = face + 2;
  }
  t->last = t->ids[0];
  t->base = base + count;
  if (t->base > GMDS_NONE / 2) { /* numbers are used up */
    memset(t->local, 0, (t->nodes + 1) * sizeof *t->local);
    t->base = 1;
  }
  if (n_nodes > WIDTH)
    return link_by_hash(t, n_sides);
  for (size_t i = 0; i < n_sides; i++) {
    const corners c = t->corner[i];
    gmds_id *around = neighbour + 4 * (size_t)t->ids[i];
    around[0] = table[c.x * WIDTH + c.z];
    around[1] = table[c.z * WIDTH + c.y];
    around[2] = table[c.y * WIDTH + c.x];
  }
  return 1;
}

static int insert(triangulation *t, gmds_id v)
{
  gmds_id start = locate(t, point_of(t, v));
  size_t n = find_cavity(t, start, v);
  return n && fill_cavity(t, n, v);
}

/* ---- the whole */

/* Five tetrahedra, the first of finite nodes with one at the ghost beyond each face. */
static void begin(triangulation *t, const gmds_id first[4])
{
  memcpy(t->node, first, 4 * sizeof *first);
  for (size_t k = 0; k < 4; k++) {
    for (size_t i = 0; i < 3; i++)
      t->node[4 * (k + 1) + i] = first[on_face[k][i]];
    t->node[4 * (k + 1) + 3] = t->ghost;
  }
  t->tetrahedra = 5;
  memset(t->mark, 0, 5 * sizeof *t->mark);
  /* Any two of the five share a face, the one opposite to the node that the other has not. */
  for (gmds_id a = 0; a < 5; a++)
    for (gmds_id b = 0; b < 5; b++)
      for (gmds_id k = 0; k < 4 && a != b; k++) {
        gmds_id v = t->node[4 * a + opposite[k]];
        int in_b = 0;
        for (int i = 0; i < 4; i++)
          in_b |= t->node[4 * b + (gmds_id)i] == v;
        for (gmds_id l = 0; l < 4 && !in_b; l++) {
          gmds_id w = t->node[4 * b + opposite[l]];
          int in_a = 0;
          for (int i = 0; i < 4; i++)
            in_a |= t->node[4 * a + (gmds_id)i] == w;
          if (!in_a)
            t->neighbour[4 * a + k] = 4 * b + l;
        }
      }
}

/* Removes the tetrahedra at the ghost and the spare ones; the last ones move into their places. */
static void remove_ghost(triangulation *t)
{
  gmds_id *node = t->node, *neighbour = t->neighbour;
  for (size_t i = 0; i < t->spares; i++)
    for (size_t k = 0; k < 4; k++) {
      node[4 * (size_t)t->spare[i] + k] = t->ghost;
      neighbour[4 * (size_t)t->spare[i] + k] = GMDS_NONE;
    }
  for (size_t id = 0; id < t->tetrahedra;) {
    if (!has_ghost(t, (gmds_id)id)) {
      id++;
      continue;
    }
    for (size_t k = 0; k < 4; k++)
      if (neighbour[4 * id + k] != GMDS_NONE)
        neighbour[neighbour[4 * id + k]] = GMDS_NONE;
    size_t from = --t->tetrahedra;
    if (from == id)
      break;
    memcpy(node + 4 * id, node + 4 * from, 4 * sizeof *node);
    memcpy(neighbour + 4 * id, neighbour + 4 * from, 4 * sizeof *neighbour);
    for (gmds_id k = 0; k < 4; k++)
      if (neighbour[4 * id + k] != GMDS_NONE)
        neighbour[neighbour[4 * id + k]] = 4 * (gmds_id)id + k;
  }
}

/* The first four nodes that are not in a plane, positively oriented; 0 when there are none. */
static int first_four(const triangulation *t, gmds_id v[4])
{
  gmds_id n = (gmds_id)t->nodes, c = 2, d;
  while (c < n && !gmds_coplanar_orientation(point_of(t, 0), point_of(t, 1), point_of(t, c)))
    c++;
  int turn = 0;
  for (d = c + 1; d < n; d++)
    if ((turn = gmds_orient3d(point_of(t, 0), point_of(t, 1), point_of(t, c), point_of(t, d))) != 0)
      break;
  v[0] = turn < 0;
  v[1] = turn > 0;
  v[2] = c;
  v[3] = d;
  return turn;
}

/* Points in the order of insertion, and the ghost. */
static gmds_status place_points(triangulation *t, size_t n, const double *xyz)
{
  void *order = NULL, *point = NULL;
  gmds_memory *memory = &t->memory;
  if (!gmds_resize(memory, &order, 0, n, sizeof(gmds_id)) || !gmds_resize(memory, &point, 0, n + 1, 3 * sizeof(double)))
    return GMDS_ERR_MEMORY;
  const gmds_id *at = order;
  t->point = point;
  void *scratch = gmds_order_scratch(n) <= 3 * sizeof(double) * n ? point : NULL;
  GMDS_TRY(gmds_order_points(memory, scratch, 1, 3, n, xyz, NULL, order, NULL, &t->nodes));
  for (size_t i = 0; i < t->nodes; i++)
    for (size_t k = 0; k < 3; k++)
      t->point[3 * i + k] = xyz[3 * (size_t)at[i] + k] + 0.0;
  for (size_t k = 0; k < 3; k++)
    t->point[3 * t->nodes + k] = NAN;
  t->ghost = (gmds_id)t->nodes;
  gmds_release(memory, order, n, sizeof(gmds_id));
  return GMDS_OK;
}

static gmds_status triangulate(triangulation *t, size_t n, const double *xyz)
{
  GMDS_TRY(gmds_predicates_check());
  GMDS_TRY(place_points(t, n, xyz));
  gmds_id first[4];
  if (!first_four(t, first))
    return GMDS_OK;
  /* Uniform points have 6.77 tetrahedra each. */
  if (!reserve_tetrahedra(t, 7 * t->nodes + 8) || !reserve_cavity(t, 64) || !resize_ids(t, &t->local, 0, t->nodes + 1))
    return GMDS_ERR_MEMORY;
  memset(t->local, 0, (t->nodes + 1) * sizeof *t->local);
  t->base = 1;
  begin(t, first);
  for (gmds_id v = 2; v < t->nodes; v++)
    if (v != first[2] && v != first[3] && !insert(t, v))
      return GMDS_ERR_MEMORY;
  remove_ghost(t);
  void *point = t->point;
  (void)gmds_resize(&t->memory, &point, n + 1, t->nodes, 3 * sizeof(double));
  t->point = point;
  (void)resize_ids(t, &t->node, 4 * t->room, 4 * t->tetrahedra);
  (void)resize_ids(t, &t->neighbour, 4 * t->room, 4 * t->tetrahedra);
  gmds_release(&t->memory, t->mark, t->room, sizeof *t->mark);
  gmds_release(&t->memory, t->local, t->nodes + 1, sizeof *t->local);
  gmds_release(&t->memory, t->ids, 4 * t->capacity, sizeof *t->ids);
  gmds_release(&t->memory, t->tested, 4 * t->capacity, sizeof *t->tested);
  gmds_release(&t->memory, t->sides, 4 * t->capacity, sizeof *t->sides);
  gmds_release(&t->memory, t->cavity, t->capacity, sizeof *t->cavity);
  gmds_release(&t->memory, t->corner, 4 * t->capacity, sizeof *t->corner);
  gmds_release(&t->memory, t->spare, t->spares_room, sizeof *t->spare);
  gmds_release(&t->memory, t->edge, 3 * t->edges, sizeof *t->edge);
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
    fprintf(stderr, "usage: handwritten_delaunay3 SPEC\n");
    return 2;
  }
  gmds_memory_init(&memory, NULL);
  gmds_memory_init(&t.memory, NULL);
  gmds_soup_init(&soup, &memory, 3);
  if (gmds_make_points(argv[1], 3, &error, &soup) != GMDS_OK) {
    fprintf(stderr, "handwritten_delaunay3: %s\n", error.text);
    return 1;
  }
  double begun = now();
  gmds_status status = triangulate(&t, soup.n_points, soup.points);
  double seconds = now() - begun;
  if (status != GMDS_OK) {
    fprintf(stderr, "handwritten_delaunay3: %s\n", gmds_status_text(status));
    return 1;
  }
  uint64_t sum = 0;
  for (size_t id = 0; id < t.tetrahedra; id++) {
    uint64_t h = 0;
    (void)gmds_checksum_cell(3, t.point, 4, t.node + 4 * id, &h);
    sum += h;
  }
  printf("{\"points\":%zu,\"cells\":%zu,\"seconds\":%.6f,\"bytes\":%zu,\"peak_bytes\":%zu,\"checksum\":\"%016llx\"}\n",
         soup.n_points, t.tetrahedra, seconds, t.memory.live, t.memory.peak, (unsigned long long)sum);
  return 0;
}
