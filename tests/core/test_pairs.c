/* Pairs against rows that are plain arrays: most hold two entries at most, some grow beyond and shrink again. */
#include "harness.h"
#include <gmds/hops.h>
#include <limits.h>

enum { ROWS = 40, ENTRIES = 90, VALUES = 64 };

typedef struct plain {
  size_t n;
  gmds_id data[ENTRIES];
} plain;

static plain expected[ROWS];
static gmds_memory memory;
static failing from;

static void begin(gmds_pairs *pairs)
{
  from = (failing){.until = LONG_MAX};
  gmds_allocator allocator = failing_allocator(&from);
  gmds_memory_init(&memory, &allocator);
  gmds_pairs_init(pairs);
  ck_assert_int_eq(gmds_pairs_resize(pairs, &memory, ROWS), GMDS_OK);
  memset(expected, 0, sizeof expected);
}

static void end(gmds_pairs *pairs)
{
  gmds_pairs_clear(pairs, &memory);
  ck_assert_uint_eq(memory.live, 0);
  ck_assert_uint_eq(from.live, 0);
}

static void compare(const gmds_pairs *pairs)
{
  for (size_t r = 0; r < ROWS; r++) {
    size_t n = 0;
    const gmds_id *row = gmds_pairs_get(pairs, r, &n);
    if (n != expected[r].n || (n && memcmp(row, expected[r].data, n * sizeof *row) != 0))
      ck_abort_msg("row %zu: %zu entries, expected %zu, or others", r, n, expected[r].n);
  }
}

static size_t position(const plain *p, gmds_id x)
{
  size_t k = 0;
  while (k < p->n && p->data[k] != x)
    k++;
  return k;
}

/* One change of a row with room made for one more entry; rows 0 to 3 grow long. */
static void change(gmds_pairs *pairs, uint64_t *seed)
{
  size_t r = random_below(seed, ROWS);
  plain *p = &expected[r];
  gmds_id x = (gmds_id)random_below(seed, VALUES), y = (gmds_id)random_below(seed, VALUES);
  size_t k = position(p, x), most = r < 4 ? 80 : r < 8 ? 4 : 2;
  switch (random_below(seed, 8)) {
  case 0:
    gmds_pairs_remove(pairs, r, x);
    if (k < p->n)
      p->data[k] = p->data[--p->n];
    break;
  case 1:
    if (position(p, y) < p->n)
      break;
    gmds_pairs_replace(pairs, r, x, y);
    if (k < p->n)
      p->data[k] = y;
    break;
  case 2:
    if (random_below(seed, 10))
      break;
    gmds_pairs_empty(pairs, r);
    p->n = 0;
    break;
  default:
    if (k < p->n || p->n == most)
      break;
    ck_assert_int_eq(gmds_pairs_reserve(pairs, &memory, r, p->n + 1), GMDS_OK);
    gmds_pairs_push(pairs, r, x);
    p->data[p->n++] = x;
  }
}

START_TEST(pairs_hold_what_plain_arrays_hold)
{
  gmds_pairs pairs;
  uint64_t seed = 3;
  begin(&pairs);
  for (int round = 0; round < 200; round++) {
    for (int i = 0; i < 100; i++)
      change(&pairs, &seed);
    compare(&pairs);
    if (round % 9 == 8) {
      ck_assert_int_eq(gmds_pairs_trim(&pairs, &memory), GMDS_OK);
      compare(&pairs);
    }
  }
  end(&pairs);
}
END_TEST

START_TEST(two_entries_a_row_take_two_identifiers_a_row)
{
  gmds_pairs pairs;
  begin(&pairs);
  for (gmds_id r = 0; r < ROWS; r++)
    for (gmds_id x = 0; x < 2; x++) {
      ck_assert_int_eq(gmds_pairs_reserve(&pairs, &memory, r, x + (size_t)1), GMDS_OK);
      gmds_pairs_push(&pairs, r, x);
    }
  ck_assert_uint_eq(memory.live, 2 * ROWS * sizeof(gmds_id));
  /* a third entry, taken back: nothing of it is left after a trim */
  ck_assert_int_eq(gmds_pairs_reserve(&pairs, &memory, 7, 3), GMDS_OK);
  gmds_pairs_push(&pairs, 7, 9);
  gmds_pairs_remove(&pairs, 7, 9);
  ck_assert_uint_gt(memory.live, 2 * ROWS * sizeof(gmds_id));
  ck_assert_int_eq(gmds_pairs_trim(&pairs, &memory), GMDS_OK);
  ck_assert_uint_eq(memory.live, 2 * ROWS * sizeof(gmds_id));
  end(&pairs);
}
END_TEST

START_TEST(renumbering_moves_rows_and_renames_entries)
{
  gmds_pairs pairs;
  gmds_id row_map[ROWS], entry_map[VALUES], fresh = 0;
  uint64_t seed = 11;
  begin(&pairs);
  for (int i = 0; i < 3000; i++)
    change(&pairs, &seed);
  for (size_t r = 0; r < ROWS; r++) {
    if (r % 3 == 1) {
      gmds_pairs_empty(&pairs, r);
      expected[r].n = 0;
    }
    row_map[r] = r % 3 == 1 ? GMDS_NONE : fresh++;
  }
  for (gmds_id x = 0; x < VALUES; x++)
    entry_map[x] = VALUES - 1 - x;
  gmds_pairs_renumber(&pairs, ROWS, row_map, entry_map);
  for (size_t r = 0; r < ROWS; r++)
    if (row_map[r] != GMDS_NONE)
      expected[row_map[r]] = expected[r];
  for (size_t r = 0; r < ROWS; r++) {
    if (r >= fresh)
      expected[r].n = 0;
    for (size_t k = 0; k < expected[r].n; k++)
      expected[r].data[k] = entry_map[expected[r].data[k]];
  }
  compare(&pairs);
  for (int i = 0; i < 3000; i++)
    change(&pairs, &seed);
  compare(&pairs);
  end(&pairs);
}
END_TEST

/* Both directions of a relation between rows and values. */
START_TEST(a_traversal_and_an_inverse_find_the_rows_of_an_entry)
{
  gmds_pairs pairs;
  gmds_csr csr;
  uint64_t seed = 5;
  begin(&pairs);
  gmds_csr_init(&csr, &memory);
  for (int i = 0; i < 4000; i++)
    change(&pairs, &seed);
  ck_assert_int_eq(gmds_invert_pairs(&pairs, ROWS, VALUES, &csr), GMDS_OK);
  for (gmds_id x = 0; x < VALUES; x++) {
    gmds_ids list = {.memory = &memory};
    size_t n = csr.begin[x];
    ck_assert_int_eq(gmds_ids_push(&list, x), GMDS_OK);
    ck_assert_int_eq(gmds_scan_pairs(&pairs, ROWS, &list, 0, 1), GMDS_OK);
    gmds_ids_keep(&list, 1, 1, GMDS_NONE);
    size_t k = 1;
    for (gmds_id r = 0; r < ROWS; r++)
      if (position(&expected[r], x) < expected[r].n) {
        ck_assert_uint_lt(k, list.n);
        ck_assert_uint_eq(list.data[k++], r);
        ck_assert_uint_eq(csr.data[n++], r);
      }
    ck_assert_uint_eq(k, list.n);
    ck_assert_uint_eq(n, csr.begin[x + 1]);
    gmds_ids_clear(&list);
  }
  for (gmds_id r = 0; r < ROWS; r++) {
    gmds_ids list = {.memory = &memory};
    ck_assert_int_eq(gmds_ids_push(&list, r), GMDS_OK);
    ck_assert_int_eq(gmds_hop_pairs(&pairs, &list, 0, 1), GMDS_OK);
    ck_assert_uint_eq(list.n, 1 + expected[r].n);
    gmds_ids_clear(&list);
  }
  gmds_csr_clear(&csr);
  end(&pairs);
}
END_TEST

/* For a few cells in one pass, for more in several, for many by the filter. */
START_TEST(a_traversal_for_many_entries_counts_every_link)
{
  gmds_pairs pairs;
  uint64_t seed = 8;
  begin(&pairs);
  for (int round = 0; round < 300; round++) {
    gmds_ids list = {.memory = &memory};
    size_t n = random_below(&seed, 24), found = 0;
    for (int i = 0; i < 50; i++)
      change(&pairs, &seed);
    for (size_t k = 0; k < n; k++)
      ck_assert_int_eq(gmds_ids_push(&list, (gmds_id)random_below(&seed, VALUES)), GMDS_OK);
    ck_assert_int_eq(gmds_scan_pairs(&pairs, ROWS, &list, 0, n), GMDS_OK);
    for (gmds_id r = 0; r < ROWS; r++) {
      size_t links = 0, told = 0;
      for (size_t k = 0; k < n; k++)
        links += position(&expected[r], list.data[k]) < expected[r].n;
      for (size_t k = n; k < list.n; k++)
        told += list.data[k] == r;
      ck_assert_uint_eq(told, links);
      found += told;
    }
    ck_assert_uint_eq(list.n, n + found);
    memory.limit = memory.live;
    size_t had = list.n;
    if (found > list.capacity - list.n) {
      ck_assert_int_eq(gmds_scan_pairs(&pairs, ROWS, &list, 0, n), GMDS_ERR_MEMORY);
      ck_assert_uint_eq(list.n, had);
    }
    memory.limit = SIZE_MAX;
    gmds_ids_clear(&list);
  }
  end(&pairs);
}
END_TEST

START_TEST(pairs_are_filled_at_once_with_nothing_spare)
{
  gmds_pairs pairs, filled;
  gmds_csr values, rows;
  uint64_t seed = 9;
  begin(&pairs);
  for (int i = 0; i < 4000; i++)
    change(&pairs, &seed);
  gmds_csr_init(&values, &memory);
  gmds_csr_init(&rows, &memory);
  ck_assert_int_eq(gmds_invert_pairs(&pairs, ROWS, VALUES, &values), GMDS_OK);
  ck_assert_int_eq(gmds_invert_csr(&values, ROWS, &rows), GMDS_OK); /* every row in the order of its entries */
  for (size_t r = 0; r < ROWS; r++)
    for (size_t k = 0; k < expected[r].n; k++)
      expected[r].data[k] = rows.data[rows.begin[r] + k];
  size_t live = memory.live;
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    gmds_pairs_init(&filled);
    from.until = k;
    status = gmds_pairs_fill(&filled, &memory, ROWS + 3, rows.begin, ROWS, rows.data);
    ck_assert(status == GMDS_OK || memory.live == live);
  }
  from.until = LONG_MAX;
  ck_assert_int_eq(status, GMDS_OK);
  compare(&filled);
  size_t n = 1, used = memory.live;
  for (size_t r = ROWS; r < ROWS + 3; r++) {
    gmds_pairs_get(&filled, r, &n);
    ck_assert_uint_eq(n, 0);
  }
  ck_assert_int_eq(gmds_pairs_trim(&filled, &memory), GMDS_OK);
  ck_assert_uint_eq(memory.live, used);
  gmds_pairs_clear(&filled, &memory);
  gmds_csr_clear(&values);
  gmds_csr_clear(&rows);
  end(&pairs);
}
END_TEST

START_TEST(pairs_without_memory_change_nothing)
{
  gmds_pairs pairs;
  begin(&pairs);
  for (gmds_id x = 0; x < 70; x++)
    for (size_t r = 0; r < 6; r++) {
      gmds_status status = GMDS_ERR_MEMORY;
      for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
        from.until = k;
        status = gmds_pairs_reserve(&pairs, &memory, r, x + (size_t)1);
        compare(&pairs);
      }
      ck_assert_int_eq(status, GMDS_OK);
      gmds_pairs_push(&pairs, r, x);
      expected[r].data[expected[r].n++] = x;
      if (x % 8 == 7) {
        from.until = (long)r % 3;
        (void)gmds_pairs_trim(&pairs, &memory);
        compare(&pairs);
      }
    }
  ck_assert_int_eq(gmds_pairs_reserve(&pairs, &memory, 0, GMDS_NONE / 2), GMDS_ERR_TOO_MANY);
  from.until = 0;
  ck_assert_int_eq(gmds_pairs_resize(&pairs, &memory, 2 * ROWS), GMDS_ERR_MEMORY);
  compare(&pairs);
  end(&pairs);
}
END_TEST

RUN_SUITE("pairs", pairs_hold_what_plain_arrays_hold, two_entries_a_row_take_two_identifiers_a_row,
          renumbering_moves_rows_and_renames_entries, a_traversal_and_an_inverse_find_the_rows_of_an_entry,
          a_traversal_for_many_entries_counts_every_link, pairs_are_filled_at_once_with_nothing_spare,
          pairs_without_memory_change_nothing)
