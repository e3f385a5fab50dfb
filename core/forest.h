/* A forest of sets that grow together, with a parity between members: the smaller root is the parent, paths are halved
 * (Tarjan and van Leeuwen, 1984). Private to the library. */
#ifndef GMDS_CORE_FOREST_H
#define GMDS_CORE_FOREST_H

#include <gmds/ids.h>

typedef struct forest {
  gmds_id *parent;
  uint8_t *odd; /* whether a member differs from its parent */
  size_t n;
  gmds_memory *memory;
} forest;

static inline void forest_clear(forest *f)
{
  gmds_release(f->memory, f->parent, f->parent ? f->n : 0, sizeof *f->parent);
  gmds_release(f->memory, f->odd, f->odd ? f->n : 0, 1);
  *f = (forest){.memory = f->memory};
}

/* n sets of one. GMDS_OK or GMDS_ERR_MEMORY (it can be cleared). */
static inline gmds_status forest_begin(forest *f, gmds_memory *memory, size_t n)
{
  void *parent = NULL, *odd = NULL;
  *f = (forest){.n = n, .memory = memory};
  if (!gmds_resize(memory, &parent, 0, n, sizeof *f->parent))
    return GMDS_ERR_MEMORY;
  f->parent = parent;
  if (!gmds_resize(memory, &odd, 0, n, 1))
    return GMDS_ERR_MEMORY;
  f->odd = odd;
  for (size_t k = 0; k < n; k++) {
    f->parent[k] = (gmds_id)k;
    f->odd[k] = 0;
  }
  return GMDS_OK;
}

/* The root of x; *odd: whether x differs from it. */
static inline gmds_id forest_root(forest *f, gmds_id x, unsigned *odd)
{
  *odd = 0;
  while (f->parent[x] != x) {
    const gmds_id p = f->parent[x];
    f->odd[x] ^= f->odd[p];
    f->parent[x] = f->parent[p];
    *odd ^= f->odd[x];
    x = f->parent[x];
  }
  return x;
}

/* Says that x and y differ, or that they do not. Returns 0 where the opposite was said before. */
static inline int forest_join(forest *f, gmds_id x, gmds_id y, unsigned differ)
{
  unsigned odd_x = 0, odd_y = 0;
  x = forest_root(f, x, &odd_x);
  y = forest_root(f, y, &odd_y);
  if (x == y)
    return (odd_x ^ odd_y) == differ;
  const gmds_id low = x < y ? x : y, high = x < y ? y : x;
  f->parent[high] = low;
  f->odd[high] = (uint8_t)(odd_x ^ odd_y ^ differ);
  return 1;
}

#endif
