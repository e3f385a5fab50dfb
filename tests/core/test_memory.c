/* Counted memory and lists of identifiers. */
#include "harness.h"
#include <gmds/ids.h>

START_TEST(live_and_peak_are_exact)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  void *a = NULL, *b = NULL;
  ck_assert(gmds_resize(&memory, &a, 0, 10, 8));
  ck_assert(gmds_resize(&memory, &b, 0, 3, 4));
  ck_assert_uint_eq(memory.live, 92);
  ck_assert(gmds_resize(&memory, &a, 10, 5, 8));
  ck_assert_uint_eq(memory.live, 52);
  ck_assert_uint_eq(memory.peak, 92);
  gmds_release(&memory, a, 5, 8);
  gmds_release(&memory, b, 3, 4);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(overflow_and_limit_are_refused)
{
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  void *a = NULL;
  ck_assert(!gmds_resize(&memory, &a, 0, SIZE_MAX / 2, 8));
  memory.limit = 64;
  ck_assert(!gmds_resize(&memory, &a, 0, 65, 1));
  ck_assert(gmds_resize(&memory, &a, 0, 64, 1));
  ck_assert(!gmds_resize(&memory, &a, 64, 65, 1));
  ck_assert_uint_eq(memory.live, 64);
  memory.limit = 32; /* below what is held: it may shrink, not grow */
  ck_assert(!gmds_resize(&memory, &a, 64, 65, 1));
  ck_assert(gmds_resize(&memory, &a, 64, 40, 1));
  ck_assert(!gmds_resize(&memory, &a, 40, 41, 1));
  gmds_release(&memory, a, 40, 1);
}
END_TEST

START_TEST(keep_counts_multiplicities)
{
  uint64_t seed = 1;
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  gmds_ids list;
  gmds_ids_init(&list, &memory);
  gmds_ids_keep(&list, 0, 1, GMDS_NONE); /* nothing was ever in it */
  ck_assert_uint_eq(list.n, 0);
  for (int round = 0; round < 200; round++) {
    size_t n = random_below(&seed, 120), range = 1 + random_below(&seed, 40), times = 1 + random_below(&seed, 3);
    gmds_id but = (gmds_id)random_below(&seed, range);
    size_t count[40] = {0};
    list.n = 0;
    for (size_t i = 0; i < n; i++) {
      gmds_id id = (gmds_id)random_below(&seed, range);
      count[id]++;
      ck_assert_int_eq(gmds_ids_push(&list, id), GMDS_OK);
    }
    gmds_ids_keep(&list, 0, times, but);
    size_t expected = 0;
    for (gmds_id id = 0; id < range; id++)
      if (count[id] >= times && id != but) {
        ck_assert_uint_eq(list.data[expected], id);
        expected++;
      }
    ck_assert_uint_eq(list.n, expected);
  }
  gmds_ids_clear(&list);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(a_list_that_cannot_grow_is_unchanged)
{
  failing f = {.until = 1};
  gmds_allocator allocator = failing_allocator(&f);
  gmds_memory memory;
  gmds_memory_init(&memory, &allocator);
  gmds_ids list;
  gmds_ids_init(&list, &memory);
  while (gmds_ids_push(&list, 7) == GMDS_OK)
    ck_assert_uint_le(list.n, list.capacity);
  ck_assert_uint_eq(list.n, list.capacity);
  ck_assert_uint_eq(list.data[list.n - 1], 7);
  gmds_ids_clear(&list);
  ck_assert_uint_eq(f.live, 0);
}
END_TEST

/* An allocator that cannot cut a block: it answers NULL, against its contract. */
static void *cut_nothing(void *user, void *block, size_t old_bytes, size_t new_bytes)
{
  (void)user;
  if (new_bytes && new_bytes < old_bytes)
    return NULL;
  void *moved = new_bytes ? realloc(block, new_bytes) : NULL;
  if (!new_bytes)
    free(block);
  return moved;
}

START_TEST(fewer_bytes_are_never_refused)
{
  gmds_memory memory;
  void *block = NULL;
  const gmds_allocator allocator = {cut_nothing, NULL};
  gmds_memory_init(&memory, &allocator);
  ck_assert(gmds_resize(&memory, &block, 0, 100, 8));
  void *whole = block;
  ck_assert(gmds_resize(&memory, &block, 100, 10, 8));
  ck_assert_ptr_eq(block, whole);
  ck_assert_uint_eq(memory.live, 80);
  gmds_release(&memory, block, 10, 8);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(every_status_has_a_text)
{
  for (int s = 0; s < GMDS_STATUS_COUNT; s++)
    ck_assert_uint_gt(strlen(gmds_status_text((gmds_status)s)), 3);
  gmds_error error;
  ck_assert_int_eq(gmds_fail(&error, GMDS_ERR_CELL, "node %d", 3), GMDS_ERR_CELL);
  ck_assert_str_eq(error.text, "node 3");
  ck_assert_int_eq(gmds_fail(NULL, GMDS_ERR_CELL, "node %d", 3), GMDS_ERR_CELL);
}
END_TEST

RUN_SUITE("memory", live_and_peak_are_exact, overflow_and_limit_are_refused, keep_counts_multiplicities,
          a_list_that_cannot_grow_is_unchanged, fewer_bytes_are_never_refused, every_status_has_a_text)
