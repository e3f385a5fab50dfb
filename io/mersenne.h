/* The 64-bit Mersenne twister MT19937-64 (Nishimura and Matsumoto 2000) and its usual map to [0, 1): what
 * std::mt19937_64 with std::uniform_real_distribution<double> gives, so that other programs can make the same points.
 */
#ifndef GMDS_MERSENNE_H
#define GMDS_MERSENNE_H

#include <stddef.h>
#include <stdint.h>

enum { GMDS_MERSENNE_WORDS = 312, GMDS_MERSENNE_SHIFT = 156 };

typedef struct gmds_mersenne {
  uint64_t word[GMDS_MERSENNE_WORDS];
  size_t next;
} gmds_mersenne;

static inline void gmds_mersenne_seed(gmds_mersenne *m, uint64_t seed)
{
  m->word[0] = seed;
  for (size_t i = 1; i < GMDS_MERSENNE_WORDS; i++)
    m->word[i] = 6364136223846793005u * (m->word[i - 1] ^ (m->word[i - 1] >> 62)) + i;
  m->next = GMDS_MERSENNE_WORDS;
}

static inline void gmds_mersenne_refill(gmds_mersenne *m)
{
  const uint64_t low = 0x7fffffff, twist = 0xb5026f5aa96619e9u;
  for (size_t i = 0; i < GMDS_MERSENNE_WORDS; i++) {
    uint64_t y = (m->word[i] & ~low) | (m->word[(i + 1) % GMDS_MERSENNE_WORDS] & low);
    m->word[i] = m->word[(i + GMDS_MERSENNE_SHIFT) % GMDS_MERSENNE_WORDS] ^ (y >> 1) ^ (y & 1 ? twist : 0);
  }
  m->next = 0;
}

static inline uint64_t gmds_mersenne_bits(gmds_mersenne *m)
{
  if (m->next == GMDS_MERSENNE_WORDS)
    gmds_mersenne_refill(m);
  uint64_t x = m->word[m->next++];
  x ^= (x >> 29) & 0x5555555555555555u;
  x ^= (x << 17) & 0x71d67fffeda60000u;
  x ^= (x << 37) & 0xfff7eee000000000u;
  return x ^ (x >> 43);
}

/* The 64 bits over 2^64, rounded once; the few that round up to 1 become its predecessor. */
static inline double gmds_mersenne_unit(gmds_mersenne *m)
{
  double x = (double)gmds_mersenne_bits(m) * 0x1p-64;
  return x < 1 ? x : 0x1.fffffffffffffp-1;
}
#endif
