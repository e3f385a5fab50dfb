/* Sets of cells as bit arrays. */
#include <gmds/bits.h>
#include <string.h>

static size_t words_for(size_t n)
{
  return n / 64 + (n % 64 != 0);
}

gmds_status gmds_bits_init(gmds_bits *bits, gmds_memory *memory, size_t n)
{
  *bits = (gmds_bits){.memory = memory};
  return gmds_bits_resize(bits, n);
}

void gmds_bits_clear(gmds_bits *bits)
{
  gmds_release(bits->memory, bits->words, bits->n_words, sizeof *bits->words);
  *bits = (gmds_bits){.memory = bits->memory};
}

gmds_status gmds_bits_resize(gmds_bits *bits, size_t n)
{
  size_t wanted = words_for(n), had = bits->n_words;
  void *words = bits->words;
  if (!gmds_resize(bits->memory, &words, had, wanted, sizeof *bits->words))
    return GMDS_ERR_MEMORY;
  bits->words = words;
  bits->n_words = wanted;
  if (wanted > had)
    memset(bits->words + had, 0, (wanted - had) * sizeof *bits->words);
  return GMDS_OK;
}

static unsigned lowest(uint64_t word)
{
#if defined __GNUC__
  return (unsigned)__builtin_ctzll(word);
#else
  unsigned k = 0;
  while (!(word >> k & 1))
    k++;
  return k;
#endif
}

/* The first bit that differs from `flip`'s, from i on. */
static size_t next(const gmds_bits *bits, size_t i, size_t n, uint64_t flip)
{
  if (i >= n)
    return n;
  size_t w = i >> 6;
  uint64_t word = (bits->words[w] ^ flip) & (~UINT64_C(0) << (i & 63));
  while (!word) {
    if (++w >= words_for(n))
      return n;
    word = bits->words[w] ^ flip;
  }
  i = 64 * w + lowest(word);
  return i < n ? i : n;
}

size_t gmds_bits_next(const gmds_bits *bits, size_t i, size_t n)
{
  return next(bits, i, n, 0);
}

size_t gmds_bits_next_unset(const gmds_bits *bits, size_t i, size_t n)
{
  return next(bits, i, n, ~UINT64_C(0));
}

void gmds_bits_fill(gmds_bits *bits, size_t n)
{
  if (!bits->n_words)
    return;
  memset(bits->words, 0, bits->n_words * sizeof *bits->words);
  memset(bits->words, 0xff, n / 64 * sizeof *bits->words);
  if (n % 64)
    bits->words[n / 64] = (UINT64_C(1) << (n % 64)) - 1;
}
