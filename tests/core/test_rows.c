/* Rows in a pool, short and long, against rows that are plain arrays. */
#include "harness.h"
#include <gmds/rows.h>

enum { ROWS = 12, ENTRIES = 400, VALUES = 1000 };

typedef struct plain {
  size_t n;
  gmds_id data[ENTRIES];
} plain;

static plain expected[ROWS];
static gmds_memory memory;

static size_t position(const plain *p, gmds_id x)
{
  size_t k = 0;
  while (k < p->n && p->data[k] != x)
    k++;
  return k;
}

static void compare(const gmds_rows *rows)
{
  for (size_t r = 0; r < ROWS; r++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, r, &n);
    if (n != expected[r].n || (n && memcmp(row, expected[r].data, n * sizeof *row) != 0))
      ck_abort_msg("row %zu: %zu entries, expected %zu, or others", r, n, expected[r].n);
    for (gmds_id x = 0; x < VALUES; x += 7) {
      size_t k = position(&expected[r], x);
      if (gmds_rows_find(rows, r, x) != (k < expected[r].n ? (gmds_id)k : GMDS_NONE))
        ck_abort_msg("row %zu: entry %lu is not found where it is", r, (unsigned long)x);
    }
  }
}

static void begin(gmds_rows *rows, int ordered)
{
  gmds_memory_init(&memory, NULL);
  gmds_rows_init(rows, ordered);
  ck_assert_int_eq(gmds_rows_resize(rows, &memory, ROWS), GMDS_OK);
  memset(expected, 0, sizeof expected);
}

static void end(gmds_rows *rows)
{
  gmds_rows_clear(rows, &memory);
  ck_assert_uint_eq(memory.live, 0);
}

static void push(gmds_rows *rows, size_t r, gmds_id x)
{
  ck_assert_int_eq(gmds_rows_reserve(rows, &memory, r, rows->length[r] + (size_t)1), GMDS_OK);
  gmds_rows_push(rows, r, x);
  expected[r].data[expected[r].n++] = x;
}

/* One random change of a row; rows 0 and 1 grow long, the others stay short. */
static void change(gmds_rows *rows, uint64_t *seed)
{
  size_t r = random_below(seed, ROWS), most = r < 2 ? ENTRIES : 20, what = random_below(seed, 100);
  plain *p = &expected[r];
  gmds_id x = (gmds_id)random_below(seed, VALUES), y = (gmds_id)random_below(seed, VALUES);
  size_t k = position(p, x);
  if (what < 60) {
    if (k == p->n && p->n < most)
      push(rows, r, x);
  } else if (what < 85) {
    if (p->n && random_below(seed, 4))
      x = p->data[k = random_below(seed, p->n)];
    gmds_rows_remove(rows, r, x);
    if (k < p->n)
      p->data[k] = p->data[--p->n];
  } else if (what < 97) {
    if (k < p->n && position(p, y) == p->n) {
      gmds_rows_replace(rows, r, x, y);
      p->data[k] = y;
    } else if (k == p->n)
      gmds_rows_replace(rows, r, x, y); /* nothing to replace */
  } else if (what < 98 && r > 1) {
    gmds_rows_release(rows, r);
    p->n = 0;
  } else if (what < 99 && random_below(seed, 20) == 0) {
    gmds_rows_empty(rows, r);
    p->n = 0;
  }
}

START_TEST(sets_follow_plain_arrays_through_every_change)
{
  gmds_rows rows;
  uint64_t seed = 1;
  size_t longest = 0;
  begin(&rows, 0);
  for (int i = 0; i < 60000; i++) {
    change(&rows, &seed);
    longest = rows.length[0] > longest ? rows.length[0] : longest;
    if (i % 300 == 0)
      compare(&rows);
    if (i % 9000 == 8999) {
      ck_assert_int_eq(gmds_rows_trim(&rows, &memory), GMDS_OK);
      compare(&rows);
    }
  }
  ck_assert_uint_gt(longest, 2 * GMDS_ROWS_LONG);
  end(&rows);
}
END_TEST

START_TEST(a_long_row_is_hashed_and_shrinks_to_a_short_one)
{
  gmds_rows rows;
  begin(&rows, 0);
  for (gmds_id x = 0; x < 300; x++)
    push(&rows, 3, 64 * x); /* equal low bits */
  compare(&rows);
  for (gmds_id x = 0; x < 300; x += 2) {
    gmds_rows_remove(&rows, 3, 64 * x);
    size_t k = position(&expected[3], 64 * x);
    expected[3].data[k] = expected[3].data[--expected[3].n];
  }
  compare(&rows);
  while (expected[3].n > 5)
    gmds_rows_remove(&rows, 3, expected[3].data[--expected[3].n]);
  ck_assert_int_eq(gmds_rows_trim(&rows, &memory), GMDS_OK);
  compare(&rows);
  ck_assert_uint_eq(rows.pool_capacity, 5);
  end(&rows);
}
END_TEST

START_TEST(freed_blocks_are_used_again)
{
  gmds_rows rows;
  begin(&rows, 0);
  for (gmds_id x = 0; x < 200; x++)
    push(&rows, 0, x);
  gmds_rows_release(&rows, 0);
  expected[0].n = 0;
  size_t used = rows.pool_used;
  for (int round = 0; round < 50; round++) {
    size_t r = (size_t)round % ROWS;
    for (gmds_id x = 0; x < 200; x++)
      push(&rows, r, x + (gmds_id)round);
    compare(&rows);
    gmds_rows_release(&rows, r);
    expected[r].n = 0;
  }
  ck_assert_uint_eq(rows.pool_used, used);
  end(&rows);
}
END_TEST

START_TEST(an_ordered_row_keeps_its_places_and_may_hold_none)
{
  gmds_rows rows;
  begin(&rows, 1);
  for (gmds_id x = 0; x < 100; x++)
    push(&rows, 1, x % 3 ? x : GMDS_NONE);
  push(&rows, 2, 5);
  push(&rows, 2, 5);
  ck_assert_int_eq(gmds_rows_trim(&rows, &memory), GMDS_OK);
  compare(&rows);
  size_t n = 0;
  ck_assert_uint_eq(gmds_rows_get(&rows, 1, &n)[3], GMDS_NONE);
  ck_assert_uint_eq(n, 100);
  end(&rows);
}
END_TEST

START_TEST(meet_keeps_what_enough_rows_have)
{
  gmds_rows rows;
  uint64_t seed = 5;
  begin(&rows, 0);
  for (int i = 0; i < 4000; i++) {
    size_t r = random_below(&seed, ROWS);
    gmds_id x = (gmds_id)random_below(&seed, 150);
    if (position(&expected[r], x) == expected[r].n && expected[r].n < (r ? 40 : 140))
      push(&rows, r, x);
  }
  gmds_ids list;
  gmds_ids_init(&list, &memory);
  for (int round = 0; round < 300; round++) {
    size_t n = 1 + random_below(&seed, 4), times = 1 + random_below(&seed, n), found = 0;
    list.n = 0;
    ck_assert_int_eq(gmds_ids_push(&list, 77), GMDS_OK);
    for (size_t k = 0; k < n; k++) {
      gmds_id r = (gmds_id)random_below(&seed, ROWS);
      while (gmds_ids_has(&list, r))
        r = (r + 1) % ROWS;
      ck_assert_int_eq(gmds_ids_push(&list, r), GMDS_OK);
    }
    ck_assert_int_eq(gmds_rows_meet(&rows, 1, n + 1, times, &list), GMDS_OK);
    for (gmds_id x = 0; x < 150; x++) {
      size_t copies = 0, given = 0;
      for (size_t k = 1; k <= n; k++)
        copies += position(&expected[list.data[k]], x) < expected[list.data[k]].n;
      for (size_t k = n + 1; k < list.n; k++)
        given += list.data[k] == x;
      if (given != (copies >= times))
        ck_abort_msg("%lu is in %zu of %zu rows, given %zu times for %zu", (unsigned long)x, copies, n, given, times);
      found += given;
    }
    ck_assert_uint_eq(list.n, n + 1 + found);
  }
  gmds_ids_clear(&list);
  end(&rows);
}
END_TEST

START_TEST(renumbering_moves_rows_and_entries)
{
  gmds_rows rows;
  gmds_id row_map[ROWS], entry_map[VALUES], fresh = 0;
  begin(&rows, 0);
  for (size_t r = 0; r < ROWS; r++)
    for (gmds_id x = 0; r % 3 && x < (r == 4 ? 300 : 10); x++)
      push(&rows, r, (gmds_id)r + 2 * x);
  for (size_t r = 0; r < ROWS; r++)
    row_map[r] = r % 3 ? fresh++ : GMDS_NONE;
  for (gmds_id x = 0; x < VALUES; x++)
    entry_map[x] = x ? x - 1 : GMDS_NONE;
  gmds_rows_renumber(&rows, ROWS, row_map, entry_map);
  for (size_t r = 0; r < ROWS; r++) {
    for (size_t k = 0; k < expected[r].n; k++)
      expected[r].data[k]--;
    if (r % 3)
      expected[row_map[r]] = expected[r];
  }
  for (size_t r = fresh; r < ROWS; r++)
    expected[r].n = 0;
  compare(&rows);
  end(&rows);
}
END_TEST

START_TEST(rows_that_cannot_grow_are_unchanged)
{
  failing f = {.until = 1000};
  gmds_allocator allocator = failing_allocator(&f);
  gmds_rows rows;
  memset(expected, 0, sizeof expected);
  gmds_memory_init(&memory, &allocator);
  gmds_rows_init(&rows, 0);
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    f.until = k;
    status = gmds_rows_resize(&rows, &memory, ROWS);
    ck_assert_uint_eq(rows.n_rows, status == GMDS_OK ? ROWS : 0);
  }
  ck_assert_int_eq(status, GMDS_OK);
  for (gmds_id x = 0; x < 200; x++) {
    for (f.until = 0; gmds_rows_reserve(&rows, &memory, 5, x + (size_t)1) != GMDS_OK; f.until = 1)
      compare(&rows);
    gmds_rows_push(&rows, 5, x);
    expected[5].data[expected[5].n++] = x;
    f.until = 0;
    (void)gmds_rows_trim(&rows, &memory);
    compare(&rows);
  }
  ck_assert_int_eq(gmds_rows_reserve(&rows, &memory, 5, GMDS_NONE / 2), GMDS_ERR_TOO_MANY);
  compare(&rows);
  gmds_rows_clear(&rows, &memory);
  ck_assert_uint_eq(f.live, 0);
}
END_TEST

/* Entries that lie as the pool would are taken over; a long row of a set is copied, for its hash. */
START_TEST(rows_adopt_what_lies_as_a_pool)
{
  for (int longest = 3; longest <= 100; longest += 97)
    for (int ordered = 0; ordered < 2; ordered++) {
      gmds_rows rows;
      gmds_status status = GMDS_ERR_MEMORY;
      for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
        failing f = {.until = 1};
        gmds_allocator allocator = failing_allocator(&f);
        void *block = NULL;
        size_t begin[ROWS + 1], n = 0;
        gmds_memory_init(&memory, &allocator);
        gmds_rows_init(&rows, ordered);
        memset(expected, 0, sizeof expected);
        for (size_t r = 0; r < ROWS; r++) {
          begin[r] = n;
          n += r == 4 ? (size_t)longest : r % 3;
        }
        begin[ROWS] = n;
        ck_assert(gmds_resize(&memory, &block, 0, n, sizeof(gmds_id)));
        gmds_id *data = block;
        for (size_t r = 0; r < ROWS; r++)
          for (size_t i = begin[r]; i < begin[r + 1]; i++)
            expected[r].data[expected[r].n++] = data[i] = (gmds_id)(i - begin[r]);
        f.until = k;
        status = gmds_rows_adopt(&rows, &memory, ROWS, begin, ROWS, &data, n);
        if (status == GMDS_OK) {
          compare(&rows);
          ck_assert_int_eq(data == NULL, longest == 3);
          ck_assert_uint_eq(gmds_rows_find(&rows, 4, 2), 2);
        } else
          ck_assert(data == block && !rows.n_rows && !rows.pool);
        if (data)
          gmds_release(&memory, data, n, sizeof *data);
        gmds_rows_clear(&rows, &memory);
        ck_assert_uint_eq(f.live, 0);
      }
      ck_assert_int_eq(status, GMDS_OK);
    }
}
END_TEST

RUN_SUITE("rows", sets_follow_plain_arrays_through_every_change, a_long_row_is_hashed_and_shrinks_to_a_short_one,
          freed_blocks_are_used_again, an_ordered_row_keeps_its_places_and_may_hold_none,
          meet_keeps_what_enough_rows_have, renumbering_moves_rows_and_entries, rows_that_cannot_grow_are_unchanged,
          rows_adopt_what_lies_as_a_pool)
