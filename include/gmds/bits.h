/* Sets of cells as bit arrays: which cells are alive, and the marks of callers. */
#ifndef GMDS_BITS_H
#define GMDS_BITS_H

#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One bit a cell, all 0 at first. Owned by its maker: a mark is never part of a mesh, so that concurrent readers can
 * each have their own. */
typedef struct gmds_bits {
  uint64_t *words;
  size_t n_words;
  gmds_memory *memory;
} gmds_bits;

/* A set for `n` cells (at most; see gmds_bits_resize). GMDS_OK or GMDS_ERR_MEMORY. n / 8 bytes. */
gmds_status gmds_bits_init(gmds_bits *bits, gmds_memory *memory, size_t n);
void gmds_bits_clear(gmds_bits *bits);

/* Room for exactly n cells, new ones 0. GMDS_OK or GMDS_ERR_MEMORY (unchanged). */
gmds_status gmds_bits_resize(gmds_bits *bits, size_t n);

static inline int gmds_bits_get(const gmds_bits *bits, size_t i)
{
  return (int)(bits->words[i >> 6] >> (i & 63) & 1);
}

static inline void gmds_bits_set(gmds_bits *bits, size_t i)
{
  bits->words[i >> 6] |= UINT64_C(1) << (i & 63);
}

static inline void gmds_bits_unset(gmds_bits *bits, size_t i)
{
  bits->words[i >> 6] &= ~(UINT64_C(1) << (i & 63));
}

/* The first set (unset) bit from `i` on and below `n`, or n. 64 cells a step. */
size_t gmds_bits_next(const gmds_bits *bits, size_t i, size_t n);
size_t gmds_bits_next_unset(const gmds_bits *bits, size_t i, size_t n);

/* Sets bits 0 to n - 1 and no others. */
void gmds_bits_fill(gmds_bits *bits, size_t n);

#ifdef __cplusplus
}
#endif
#endif
