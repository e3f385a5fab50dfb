/* Sides grouped by their nodes. */
#include "sides.h"
#include <string.h>

/* A side in the bucket of its lower node. When the buckets are gone through, groups come out in order and are never
 * more than sides: their nodes are written over the sides that have been read. */
typedef struct side {
  gmds_id high;   /* its other node */
  gmds_id number; /* where its group is written */
} side;

_Static_assert(sizeof(side) == 2 * sizeof(gmds_id), "gmds: the nodes of a group take the place of a side");

/* Counts (places NULL) a side at its lower node, or places it: `at` is where the next side of a node goes. */
static inline void put(gmds_id a, gmds_id b, size_t number, gmds_id *at, side *places)
{
  gmds_id low = a < b ? a : b;
  if (places)
    places[at[low]] = (side){a < b ? b : a, (gmds_id)number};
  at[low]++;
}

static inline void put_face(size_t n, const gmds_id *v, size_t number, gmds_id *at, side *places)
{
  for (size_t k = 0, before = n - 1; k < n; before = k++)
    put(v[before], v[k], number + before, at, places);
}

/* Written so that the arity is known where it counts, and whether sides are counted or placed. */
static inline void pass_inline(const gmds_sides *s, size_t arity, gmds_id *at, side *places)
{
  for (size_t f = 0; f < s->n_faces; f++)
    if (!s->alive || gmds_bits_get(s->alive, f))
      put_face(arity, s->nodes + arity * f, arity * f, at, places);
}

/* One pass over all sides and pairs. */
static void pass(const gmds_sides *s, gmds_id *at, side *places)
{
  if (s->arity == 3 && places)
    pass_inline(s, 3, at, places);
  else if (s->arity == 3)
    pass_inline(s, 3, at, NULL);
  else if (s->arity)
    pass_inline(s, s->arity, at, places);
  for (size_t f = 0; !s->arity && f < s->n_faces; f++) {
    size_t first = s->rows ? s->rows->start[f] : s->begin[f];
    size_t n = s->rows ? s->rows->length[f] : s->begin[f + 1] - first;
    if (n)
      put_face(n, (s->rows ? s->rows->pool : s->nodes) + first, first, at, places);
  }
  for (size_t p = 0; p < s->n_pairs; p++)
    if (gmds_bits_get(s->pair_alive, p))
      put(s->pairs[2 * p], s->pairs[2 * p + 1], s->first_pair + p, at, places);
}

/* Numbers the groups bucket by bucket; last[v] is the group of v found last, of this bucket if it is not below `first`.
 * end[v] is where the bucket of v ends. */
static size_t number_groups(const gmds_sides *s, const gmds_id *end, gmds_id *last, side *places, gmds_id *group)
{
  gmds_id *nodes = (gmds_id *)places;
  gmds_id n = 0, i = 0;
  memset(last, 0xff, s->n_nodes * sizeof *last);
  for (size_t low = 0; low < s->n_nodes; low++)
    for (gmds_id first = n; i < end[low]; i++) {
      side x = places[i];
      gmds_id g = last[x.high];
      if (g - first >= n - first) { /* also GMDS_NONE */
        g = last[x.high] = n++;
        nodes[2 * (size_t)g] = (gmds_id)low;
        nodes[2 * (size_t)g + 1] = x.high;
      }
      group[x.number] = g;
    }
  return n;
}

gmds_status gmds_group_sides(const gmds_sides *sides, gmds_memory *memory, gmds_id *group, size_t *n, gmds_id **nodes,
                             size_t *capacity)
{
  void *at_block = NULL, *last = NULL, *places = NULL;
  size_t n_nodes = sides->n_nodes;
  if (!gmds_resize(memory, &at_block, 0, n_nodes, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *at = at_block, total = 0;
  if (n_nodes) {
    memset(at, 0, n_nodes * sizeof *at);
    pass(sides, at, NULL);
  }
  for (size_t v = 0; v < n_nodes; v++) {
    gmds_id count = at[v];
    at[v] = total;
    total += count;
  }
  int ok =
      gmds_resize(memory, &last, 0, n_nodes, sizeof(gmds_id)) && gmds_resize(memory, &places, 0, total, sizeof(side));
  if (ok) {
    if (total)
      pass(sides, at, places); /* each place moves on to the end of its bucket */
    *n = total ? number_groups(sides, at, last, places, group) : 0;
    *nodes = places;
    *capacity = 2 * (size_t)total;
  }
  gmds_release(memory, at, n_nodes, sizeof *at);
  gmds_release(memory, last, last ? n_nodes : 0, sizeof(gmds_id));
  return ok ? GMDS_OK : GMDS_ERR_MEMORY;
}
