/* Bit arrays against arrays of bytes. */
#include "harness.h"
#include <gmds/bits.h>

enum { MANY = 300 };

START_TEST(bits_follow_an_array_of_bytes)
{
  gmds_memory memory;
  gmds_bits bits;
  unsigned char expected[MANY] = {0};
  uint64_t seed = 1;
  gmds_memory_init(&memory, NULL);
  ck_assert_int_eq(gmds_bits_init(&bits, &memory, MANY), GMDS_OK);
  ck_assert_uint_eq(memory.live, 40);
  for (int round = 0; round < 400; round++) {
    size_t density = random_below(&seed, 3);
    for (int i = 0; i < 40; i++) {
      size_t k = random_below(&seed, MANY);
      expected[k] = random_below(&seed, 3) >= density;
      if (expected[k])
        gmds_bits_set(&bits, k);
      else
        gmds_bits_unset(&bits, k);
    }
    for (size_t n = 0; n <= MANY; n += 1 + random_below(&seed, 70))
      for (size_t i = 0; i <= n; i++) {
        size_t set = i, unset = i;
        while (set < n && !expected[set])
          set++;
        while (unset < n && expected[unset])
          unset++;
        if (gmds_bits_next(&bits, i, n) != set || gmds_bits_next_unset(&bits, i, n) != unset)
          ck_abort_msg("the next bit from %zu below %zu is not %zu, or the next unset %zu", i, n, set, unset);
      }
  }
  for (size_t k = 0; k < MANY; k++)
    ck_assert_int_eq(gmds_bits_get(&bits, k), expected[k]);
  gmds_bits_clear(&bits);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(fill_sets_the_first_and_no_others)
{
  gmds_memory memory;
  gmds_bits bits;
  gmds_memory_init(&memory, NULL);
  ck_assert_int_eq(gmds_bits_init(&bits, &memory, 130), GMDS_OK);
  for (size_t n = 0; n <= 130; n++) {
    gmds_bits_set(&bits, 129);
    gmds_bits_fill(&bits, n);
    for (size_t k = 0; k < 130; k++)
      if (gmds_bits_get(&bits, k) != (k < n))
        ck_abort_msg("bit %zu of %zu", k, n);
  }
  gmds_bits_clear(&bits);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(new_bits_are_0_and_old_ones_stay)
{
  gmds_memory memory;
  gmds_bits bits;
  gmds_memory_init(&memory, NULL);
  ck_assert_int_eq(gmds_bits_init(&bits, &memory, 64), GMDS_OK);
  gmds_bits_fill(&bits, 64);
  ck_assert_int_eq(gmds_bits_resize(&bits, 1000), GMDS_OK);
  ck_assert_uint_eq(gmds_bits_next_unset(&bits, 0, 1000), 64);
  ck_assert_uint_eq(gmds_bits_next(&bits, 64, 1000), 1000);
  memory.limit = memory.live;
  ck_assert_int_eq(gmds_bits_resize(&bits, 2000), GMDS_ERR_MEMORY);
  ck_assert_uint_eq(gmds_bits_next_unset(&bits, 0, 1000), 64);
  gmds_bits_clear(&bits);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

RUN_SUITE("bits", bits_follow_an_array_of_bytes, fill_sets_the_first_and_no_others, new_bits_are_0_and_old_ones_stay)
