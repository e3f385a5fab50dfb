/* The same sets of nodes: open addressing, the key of a set a sum over its nodes. */
#include "sets.h"
#include "mix.h"
#include <string.h>

/* Rows up to this long are compared node by node, longer ones by marks. */
enum { FEW = 8 };

typedef struct grouping {
  const size_t *begin;
  const gmds_id *data;
  gmds_id *table, *mark; /* mark: of each node, the last long row that was looked up with it */
  size_t capacity;       /* of the table, a power of two */
} grouping;

static int is_among(const gmds_id *nodes, size_t n, gmds_id v)
{
  for (size_t k = 0; k < n; k++)
    if (nodes[k] == v)
      return 1;
  return 0;
}

/* Whether rows k and l have the same set. Where row k is long its nodes are marked. */
static int same_set(const grouping *g, size_t k, size_t l)
{
  const gmds_id *a = g->data + g->begin[k], *b = g->data + g->begin[l];
  const size_t n = g->begin[k + 1] - g->begin[k];
  if (g->begin[l + 1] - g->begin[l] != n)
    return 0;
  for (size_t q = 0; q < n; q++)
    if (n > FEW ? g->mark[b[q]] != k : !is_among(a, n, b[q]))
      return 0;
  return 1;
}

/* Where in the table the set of row k is, or belongs. */
static size_t find_place(const grouping *g, size_t k, const gmds_id *leader)
{
  const gmds_id *nodes = g->data + g->begin[k];
  const size_t n = g->begin[k + 1] - g->begin[k];
  uint64_t key = n;
  for (size_t q = 0; q < n; q++) {
    key += mix((uint64_t)nodes[q] + 1);
    if (n > FEW)
      g->mark[nodes[q]] = (gmds_id)k;
  }
  size_t at = (size_t)mix(key) & (g->capacity - 1);
  while (g->table[at] != GMDS_NONE && !same_set(g, k, leader[g->table[at]]))
    at = (at + 1) & (g->capacity - 1);
  return at;
}

gmds_status gmds_group_sets(size_t n_keys, size_t n, const size_t *begin, const gmds_id *data, gmds_memory *memory,
                            gmds_id *group, gmds_id *leader, size_t *n_groups)
{
  grouping g = {.begin = begin, .data = data, .capacity = 16};
  void *table = NULL, *mark = NULL;
  size_t found = 0, longest = 0;
  for (size_t k = 0; k < n; k++)
    longest = begin[k + 1] - begin[k] > longest ? begin[k + 1] - begin[k] : longest;
  const size_t n_marks = longest > FEW ? n_keys : 0;
  while (g.capacity < 2 * n)
    g.capacity *= 2;
  const int ok = gmds_resize(memory, &table, 0, g.capacity, sizeof(gmds_id)) &&
                 gmds_resize(memory, &mark, 0, n_marks, sizeof(gmds_id));
  if (ok) {
    g.table = table;
    g.mark = mark;
    memset(table, 0xff, g.capacity * sizeof(gmds_id));
    if (n_marks)
      memset(mark, 0xff, n_marks * sizeof(gmds_id));
    for (size_t k = 0; k < n; k++) {
      group[k] = GMDS_NONE;
      if (begin[k] == begin[k + 1])
        continue;
      const size_t at = find_place(&g, k, leader);
      if (g.table[at] == GMDS_NONE) {
        leader[found] = (gmds_id)k;
        g.table[at] = (gmds_id)found++;
      }
      group[k] = g.table[at];
    }
    *n_groups = found;
  }
  gmds_release(memory, table, table ? g.capacity : 0, sizeof(gmds_id));
  gmds_release(memory, mark, mark ? n_marks : 0, sizeof(gmds_id));
  return ok ? GMDS_OK : GMDS_ERR_MEMORY;
}

int gmds_same_cycle(const gmds_id *a, const gmds_id *b, size_t n)
{
  size_t at = 0, forwards = 1, backwards = 1;
  while (at < n && b[at] != a[0])
    at++;
  if (at == n)
    return 0;
  for (size_t k = 0; k < n; k++) {
    forwards &= a[k] == b[at + k < n ? at + k : at + k - n];
    backwards &= a[k] == b[at >= k ? at - k : at + n - k];
  }
  return forwards || backwards;
}
