/* Matching: the (n-1)-cells that two n-cells have in common are found by a hash of their nodes and sewn, all at once.
 * The table forgets what it has matched, so that it stays as small as the front between what was met and what was not.
 * */
#include "map_inside.h"
#include <gmds/template.h>
#include <string.h>

/* A border that waits for the other side. */
typedef struct waiting {
  uint64_t key;
  gmds_id dart; /* GMDS_NONE: no entry */
} waiting;

typedef struct matching {
  gmds_map *map;
  gmds_map_by by;
  uint64_t *hash; /* of each node */
  waiting *table; /* open addressing, linear probing, at most half full */
  size_t capacity, n;
  gmds_ids pairs;                 /* darts to be linked, two by two, one pair a border */
  gmds_id *parent[GMDS_MAP_KEPT]; /* which cells become one: forests, the smaller is the parent */
} matching;

/* What is read of darts: each layout that is a constant is compiled by itself. */
typedef struct layout {
  gmds_id *records;
  size_t stride;
  int n, node;
} layout;

#define RECORD(l, d) ((l).records + (size_t)(d) * (l).stride)

static uint64_t hash_of_node(const matching *m, gmds_id v)
{
  if (m->by == GMDS_BY_NODES)
    return mix64(v + 0x9e3779b97f4a7c15u);
  uint64_t h = 0;
  const double *x = gmds_map_point(m->map, v);
  for (int k = 0; k < m->map->coordinates; k++) {
    const double positive = x[k] + 0.0; /* -0 is +0 */
    uint64_t w = 0;
    memcpy(&w, &positive, sizeof w);
    h = (h ^ w) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  h *= 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 29);
}

static int same_node(const matching *m, gmds_id v, gmds_id w)
{
  if (m->by == GMDS_BY_NODES || v == w)
    return v == w;
  const double *x = gmds_map_point(m->map, v), *y = gmds_map_point(m->map, w);
  for (int k = 0; k < m->map->coordinates; k++)
    if (x[k] != y[k])
      return 0;
  return 1;
}

/* The key of the border of d, a closed cycle of free darts of which d is the first, or for n = 2 one dart. 0: it is
 * none. */
GMDS_SPECIALISED uint64_t key_of(const layout l, const uint64_t *hash, gmds_id d)
{
  const gmds_id *record = RECORD(l, d);
  if (record[l.n] != GMDS_NONE || record[1] == GMDS_NONE)
    return 0;
  if (l.n == 2)
    return hash[record[l.node]] + hash[RECORD(l, record[1])[l.node]];
  if (record[0] < d || record[0] == GMDS_NONE)
    return 0;
  uint64_t key = 0;
  gmds_id e = d;
  do {
    record = RECORD(l, e);
    key += hash[record[l.node]];
    e = record[1];
    if (e == GMDS_NONE || e < d)
      return 0;
  } while (e != d);
  return key;
}

/* The dart of the border of e that lies opposite d, or GMDS_NONE: their borders are not the same, or run the same way.
 * */
static gmds_id opposite(const matching *m, gmds_id d, gmds_id e)
{
  const gmds_map *map = m->map;
  const int node = map->slot[0];
  const gmds_id first = e;
  do {
    gmds_id a = d, b = e;
    const gmds_id after = gmds_map_beta(map, 1, a);
    int same = same_node(m, gmds_map_record(map, b)[node], gmds_map_record(map, after)[node]);
    if (map->n == 2)
      return same && same_node(m, gmds_map_record(map, a)[node], gmds_map_record(map, gmds_map_beta(map, 1, b))[node])
                 ? e
                 : GMDS_NONE;
    while (same) { /* b runs back while a runs on */
      a = gmds_map_beta(map, 1, a);
      b = gmds_map_beta(map, 0, b);
      if (a == d || b == e)
        return a == d && b == e ? e : GMDS_NONE;
      same = same_node(m, gmds_map_record(map, b)[node], gmds_map_record(map, gmds_map_beta(map, 1, a))[node]);
    }
    e = gmds_map_beta(map, 1, e);
  } while (e != first);
  return GMDS_NONE;
}

static gmds_status grow_table(matching *m)
{
  void *block = NULL;
  const size_t had = m->capacity, capacity = had ? 2 * had : 1024;
  if (!gmds_resize(&m->map->memory, &block, 0, capacity, sizeof *m->table))
    return GMDS_ERR_MEMORY;
  waiting *old = m->table;
  m->table = block;
  m->capacity = capacity;
  for (size_t k = 0; k < capacity; k++)
    m->table[k].dart = GMDS_NONE;
  for (size_t k = 0; k < had; k++)
    if (old[k].dart != GMDS_NONE) {
      size_t at = old[k].key & (capacity - 1);
      while (m->table[at].dart != GMDS_NONE)
        at = (at + 1) & (capacity - 1);
      m->table[at] = old[k];
    }
  gmds_release(&m->map->memory, old, had, sizeof *old);
  return GMDS_OK;
}

/* Takes entry k out and moves back those behind it that may. */
static void forget(matching *m, size_t k)
{
  const size_t last = m->capacity - 1;
  for (size_t next = (k + 1) & last; m->table[next].dart != GMDS_NONE; next = (next + 1) & last)
    if (((next - m->table[next].key) & last) >= ((next - k) & last)) {
      m->table[k] = m->table[next];
      k = next;
    }
  m->table[k].dart = GMDS_NONE;
  m->n--;
}

/* Finds the other side of a border, or lets it wait. */
static gmds_status meet(matching *m, gmds_id d, uint64_t key)
{
  if (2 * (m->n + 1) > m->capacity)
    GMDS_TRY(grow_table(m));
  size_t k = key & (m->capacity - 1);
  for (; m->table[k].dart != GMDS_NONE; k = (k + 1) & (m->capacity - 1)) {
    if (m->table[k].key != key)
      continue;
    const gmds_id e = opposite(m, d, m->table[k].dart);
    if (e == GMDS_NONE)
      continue;
    GMDS_TRY(gmds_ids_push(&m->pairs, d));
    GMDS_TRY(gmds_ids_push(&m->pairs, e));
    forget(m, k);
    return GMDS_OK;
  }
  m->table[k] = (waiting){key, d};
  m->n++;
  return GMDS_OK;
}

/* Borders are met some time after their keys are known: what the table and the other side hold is on its way meanwhile.
 * */
enum { AHEAD = 8, QUEUE = 16 };

GMDS_SPECIALISED gmds_status meet_borders(matching *m, const layout l)
{
  const gmds_cells *darts = &m->map->darts;
  const int full = darts->count == darts->end;
  waiting queue[QUEUE];
  size_t n = 0;
  for (size_t k = 0; k < darts->end; k++) {
    const gmds_id d = (gmds_id)k;
    const uint64_t key = full || gmds_bits_get(&darts->alive, k) ? key_of(l, m->hash, d) : 0;
    if (!key)
      continue;
    if (n >= QUEUE)
      GMDS_TRY(meet(m, queue[n % QUEUE].dart, queue[n % QUEUE].key));
    queue[n % QUEUE] = (waiting){key, d};
    __builtin_prefetch(m->table + (key & (m->capacity - 1)));
    if (n >= AHEAD) {
      const waiting *w = &m->table[queue[(n - AHEAD) % QUEUE].key & (m->capacity - 1)];
      if (w->dart != GMDS_NONE)
        __builtin_prefetch(RECORD(l, w->dart));
    }
    n++;
  }
  for (size_t k = n > QUEUE ? n - QUEUE : 0; k < n; k++)
    GMDS_TRY(meet(m, queue[k % QUEUE].dart, queue[k % QUEUE].key));
  return GMDS_OK;
}

static gmds_status meet_all(matching *m)
{
  const gmds_map *map = m->map;
  if (map->n == 3 && map->stride == 5)
    return meet_borders(m, (layout){map->records, 5, 3, 4});
  return meet_borders(m, (layout){map->records, (size_t)map->stride, map->n, map->slot[0]});
}

static gmds_status find_matches(matching *m)
{
  gmds_map *map = m->map;
  void *block = NULL;
  if (!gmds_resize(&map->memory, &block, 0, map->cells[0].end, sizeof *m->hash))
    return GMDS_ERR_MEMORY;
  m->hash = block;
  for (gmds_id v = gmds_cells_next(&map->cells[0], 0); v != GMDS_NONE; v = gmds_cells_next(&map->cells[0], v + 1))
    m->hash[v] = hash_of_node(m, v);
  GMDS_TRY(grow_table(m));
  GMDS_TRY(meet_all(m));
  for (int i = 0; i < map->n && i < GMDS_MAP_KEPT; i++) {
    void *parent = NULL;
    if (!map->slot[i])
      continue;
    if (i == 0) { /* in the room of the hashes, which are not needed any more: a call for fewer bytes */
      parent = m->hash;
      m->hash = NULL;
      (void)gmds_resize(&map->memory, &parent, map->cells[0].end * (sizeof *m->hash / sizeof(gmds_id)),
                        map->cells[0].end, sizeof(gmds_id));
    } else if (!gmds_resize(&map->memory, &parent, 0, map->cells[i].end, sizeof(gmds_id)))
      return GMDS_ERR_MEMORY;
    m->parent[i] = parent;
    for (size_t c = 0; c < map->cells[i].end; c++)
      m->parent[i][c] = (gmds_id)c;
  }
  return GMDS_OK;
}

static gmds_id root_of(gmds_id *parent, gmds_id c)
{
  while (parent[c] != c)
    c = parent[c] = parent[parent[c]];
  return c;
}

static void join_cells(matching *m, int i, gmds_id a, gmds_id b)
{
  const gmds_map *map = m->map;
  if (a == b)
    return;
  a = root_of(m->parent[i], a);
  b = root_of(m->parent[i], b);
  if (a == b)
    return;
  const gmds_id kept = a < b ? a : b, gone = a < b ? b : a;
  m->parent[i][gone] = kept;
  for (size_t k = 0; k < map->n_rules; k++) {
    const gmds_map_rule *rule = &map->rules[k];
    if (rule->cell == i && rule->merge)
      rule->merge(rule->user, (char *)rule->attribute->data + kept * rule->attribute->bytes,
                  (const char *)rule->attribute->data + gone * rule->attribute->bytes);
  }
}

/* Links the darts of two borders and joins their cells. */
GMDS_SPECIALISED void sew_border(matching *m, const layout l, int only_nodes, gmds_id d, gmds_id e)
{
  const int *slot = m->map->slot;
  const gmds_id first = d;
  do {
    gmds_id *a = RECORD(l, d), *b = RECORD(l, e);
    a[l.n] = e;
    b[l.n] = d;
    join_cells(m, 0, a[l.node], RECORD(l, b[1])[l.node]);
    if (l.n == 2)
      join_cells(m, 0, b[l.node], RECORD(l, a[1])[l.node]);
    for (int i = 1; i < l.n && !only_nodes; i++)
      if (slot[i])
        join_cells(m, i, a[slot[i]], b[slot[i]]);
    d = a[1];
    e = b[0];
  } while (l.n > 2 && d != first);
}

static void sew_borders(matching *m)
{
  const gmds_map *map = m->map;
  const gmds_id *pair = m->pairs.data, *end = pair + m->pairs.n;
  if (map->n == 3 && map->stride == 5)
    for (; pair < end; pair += 2)
      sew_border(m, (layout){map->records, 5, 3, 4}, 1, pair[0], pair[1]);
  else
    for (; pair < end; pair += 2)
      sew_border(m, (layout){map->records, (size_t)map->stride, map->n, map->slot[0]}, 0, pair[0], pair[1]);
}

/* Writes the cells that were joined into all darts and drops the others. */
static void settle(matching *m)
{
  gmds_map *map = m->map;
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    gmds_id *parent = m->parent[i];
    const int slot = map->slot[i];
    if (!parent)
      continue;
    for (size_t c = 0; c < map->cells[i].end; c++)
      parent[c] = parent[parent[c]]; /* the parent is smaller: it has its root already */
    const int full = map->darts.count == map->darts.end;
    for (size_t d = 0; d < map->darts.end; d++)
      if (full || gmds_bits_get(&map->darts.alive, d)) {
        gmds_id *cell = map->records + d * (size_t)map->stride + slot;
        *cell = parent[*cell];
      }
    for (size_t c = map->cells[i].end; c-- > 0;)
      if (parent[c] != c)
        gmds_cells_drop(&map->cells[i], (gmds_id)c);
  }
}

gmds_status gmds_map_match(gmds_map *map, gmds_map_by by, size_t *sewn)
{
  matching m = {.map = map, .by = by, .pairs = {.memory = &map->memory}};
  size_t end[GMDS_MAP_KEPT];
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    end[i] = map->cells[i].end;
  if (map->n > 3 || (by != GMDS_BY_NODES && by != GMDS_BY_COORDINATES))
    return GMDS_ERR_ARGUMENT;
  gmds_status status = find_matches(&m);
  const size_t n = m.pairs.n / 2;
  if (status == GMDS_OK) {
    sew_borders(&m);
    if (n)
      settle(&m);
  }
  gmds_release(&map->memory, m.hash, m.hash ? end[0] : 0, sizeof *m.hash);
  gmds_release(&map->memory, m.table, m.capacity, sizeof *m.table);
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    gmds_release(&map->memory, m.parent[i], m.parent[i] ? end[i] : 0, sizeof(gmds_id));
  gmds_ids_clear(&m.pairs);
  if (status == GMDS_OK && sewn)
    *sewn = n;
  return status;
}
