/* All edges of faces, by counting. */
#include <gmds/edges.h>
#include <string.h>

/* A side in the bucket of its lower node. When the buckets are gone through, edges come out in order and are never more
 * than sides: their nodes are written over the sides that have been read. */
typedef struct side {
  gmds_id high;  /* its other node */
  gmds_id index; /* where its edge goes in the rows of the table */
} side;

_Static_assert(sizeof(side) == 2 * sizeof(gmds_id), "gmds: the nodes of an edge take the place of a side");

/* The faces and their room: rows of `arity` nodes, or between `begin` and the next. */
typedef struct source {
  size_t n_nodes, n_faces, arity;
  const size_t *begin;
  const gmds_id *nodes;
  const gmds_bits *alive;
} source;

void gmds_edge_table_init(gmds_edge_table *table, gmds_memory *memory)
{
  *table = (gmds_edge_table){.memory = memory};
}

static size_t sides_of(const gmds_edge_table *table)
{
  return table->begin ? table->begin[table->n_faces] : table->arity * table->n_faces;
}

void gmds_edge_table_clear(gmds_edge_table *table)
{
  gmds_release(table->memory, table->edges, table->edges ? sides_of(table) : 0, sizeof *table->edges);
  gmds_release(table->memory, table->begin, table->begin ? table->n_faces + 1 : 0, sizeof *table->begin);
  gmds_release(table->memory, table->nodes, table->capacity, sizeof *table->nodes);
  gmds_edge_table_init(table, table->memory);
}

/* Counts the sides of one face at their lower nodes, or places them: `next` is where the next side of a node goes. */
static inline void count_sides(size_t n, const gmds_id *v, gmds_id *count)
{
  for (size_t k = 0, before = n - 1; k < n; before = k++)
    count[v[before] < v[k] ? v[before] : v[k]]++;
}

static inline void place_sides(size_t n, const gmds_id *v, size_t index, gmds_id *next, side *sides)
{
  for (size_t k = 0, before = n - 1; k < n; before = k++) {
    gmds_id a = v[before], b = v[k], low = a < b ? a : b;
    sides[next[low]++] = (side){a < b ? b : a, (gmds_id)(index + before)};
  }
}

/* One pass over all faces: they are counted while `sides` is NULL. Written so that the arity is known where it counts. */
static inline void pass_inline(const source *s, size_t arity, gmds_id *at, side *sides)
{
  for (size_t f = 0; f < s->n_faces; f++)
    if (s->alive && !gmds_bits_get(s->alive, f))
      continue;
    else if (sides)
      place_sides(arity, s->nodes + arity * f, arity * f, at, sides);
    else
      count_sides(arity, s->nodes + arity * f, at);
}

static void pass(const source *s, gmds_id *at, side *sides)
{
  if (s->arity == 3)
    pass_inline(s, 3, at, sides);
  else if (s->arity)
    pass_inline(s, s->arity, at, sides);
  for (size_t f = 0; !s->arity && f < s->n_faces; f++) {
    size_t n = s->begin[f + 1] - s->begin[f];
    if (n && sides)
      place_sides(n, s->nodes + s->begin[f], s->begin[f], at, sides);
    else if (n)
      count_sides(n, s->nodes + s->begin[f], at);
  }
}

/* Numbers the edges bucket by bucket; last[v] is the edge to v found last, of this bucket if it is not below `first`.
 * end[v] is where the bucket of v ends. */
static size_t number_edges(const source *s, const gmds_id *end, gmds_id *last, side *sides, gmds_id *edges)
{
  gmds_id *nodes = (gmds_id *)sides;
  gmds_id n = 0, i = 0;
  memset(last, 0xff, s->n_nodes * sizeof *last);
  for (size_t low = 0; low < s->n_nodes; low++)
    for (gmds_id first = n; i < end[low]; i++) {
      side x = sides[i];
      gmds_id e = last[x.high];
      if (e - first >= n - first) { /* also GMDS_NONE */
        e = last[x.high] = n++;
        nodes[2 * (size_t)e] = (gmds_id)low;
        nodes[2 * (size_t)e + 1] = x.high;
      }
      edges[x.index] = e;
    }
  return n;
}

static gmds_status fill(const source *s, size_t n_sides, gmds_edge_table *table)
{
  void *at_block = NULL, *last = NULL, *sides = NULL;
  gmds_memory *memory = table->memory;
  int ok = gmds_resize(memory, &at_block, 0, s->n_nodes, sizeof(gmds_id)) &&
           gmds_resize(memory, &last, 0, s->n_nodes, sizeof(gmds_id)) &&
           gmds_resize(memory, &sides, 0, n_sides, sizeof(side));
  gmds_id *at = at_block, sum = 0;
  if (ok && n_sides) {
    memset(at, 0, s->n_nodes * sizeof *at);
    pass(s, at, NULL);
    for (size_t v = 0; v < s->n_nodes; v++) {
      gmds_id count = at[v];
      at[v] = sum;
      sum += count;
    }
    pass(s, at, sides); /* each place moves on to the end of its bucket */
    table->n = number_edges(s, at, last, sides, table->edges);
  }
  gmds_release(memory, at, at ? s->n_nodes : 0, sizeof *at);
  gmds_release(memory, last, last ? s->n_nodes : 0, sizeof(gmds_id));
  if (!ok) {
    gmds_release(memory, sides, sides ? n_sides : 0, sizeof(side));
    return GMDS_ERR_MEMORY;
  }
  table->capacity = 2 * n_sides;
  if (gmds_resize(memory, &sides, 2 * n_sides, 2 * table->n, sizeof(gmds_id)))
    table->capacity = 2 * table->n;
  table->nodes = sides;
  return GMDS_OK;
}

gmds_status gmds_edges_of_inline(size_t n_nodes, size_t n_faces, size_t arity, const gmds_id *nodes,
                                 const gmds_bits *alive, gmds_edge_table *table)
{
  const source s = {.n_nodes = n_nodes, .n_faces = n_faces, .arity = arity, .nodes = nodes, .alive = alive};
  if (arity && n_faces >= GMDS_NONE / arity)
    return GMDS_ERR_TOO_MANY;
  void *edges = NULL;
  if (!gmds_resize(table->memory, &edges, 0, arity * n_faces, sizeof *table->edges))
    return GMDS_ERR_MEMORY;
  table->n_faces = n_faces;
  table->arity = arity;
  table->edges = edges;
  for (size_t f = 0; alive && f < n_faces; f++)
    for (size_t k = 0; !gmds_bits_get(alive, f) && k < arity; k++)
      table->edges[arity * f + k] = GMDS_NONE;
  gmds_status status = fill(&s, arity * n_faces, table);
  if (status != GMDS_OK)
    gmds_edge_table_clear(table);
  return status;
}

gmds_status gmds_edges_of_rows(size_t n_nodes, size_t n_faces, const size_t *begin, const gmds_id *nodes,
                               gmds_edge_table *table)
{
  const source s = {.n_nodes = n_nodes, .n_faces = n_faces, .begin = begin, .nodes = nodes};
  void *rows = NULL, *edges = NULL;
  if (begin[n_faces] >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  if (!gmds_resize(table->memory, &rows, 0, n_faces + 1, sizeof *table->begin))
    return GMDS_ERR_MEMORY;
  memcpy(rows, begin, (n_faces + 1) * sizeof *begin);
  table->n_faces = n_faces;
  table->begin = rows;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(table->memory, &edges, 0, begin[n_faces], sizeof *table->edges)) {
    table->edges = edges;
    status = fill(&s, begin[n_faces], table);
  }
  if (status != GMDS_OK)
    gmds_edge_table_clear(table);
  return status;
}
