/* The mixing of splitmix64: every bit of the result depends on every bit of z. Private to the library. */
#ifndef GMDS_CORE_MIX_H
#define GMDS_CORE_MIX_H

#include <stdint.h>

static inline uint64_t mix(uint64_t z)
{
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

#endif
