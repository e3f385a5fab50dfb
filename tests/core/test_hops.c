/* Hops: a traversal of the inverse gives what the stored relation gives, in every form of storage. */
#include "harness.h"
#include <gmds/hops.h>

/* A relation of FROM cells, ARITY entries each, towards TO cells. */
enum { FROM = 220, TO = 90, ARITY = 3 };

typedef struct relation {
  gmds_memory memory;
  gmds_bits alive;
  gmds_id inlined[FROM * ARITY];
  gmds_rows rows; /* the same entries, without GMDS_NONE */
  gmds_ids list;
} relation;

static relation r;

static void begin(uint64_t seed)
{
  gmds_memory_init(&r.memory, NULL);
  gmds_ids_init(&r.list, &r.memory);
  gmds_rows_init(&r.rows, 0);
  ck_assert_int_eq(gmds_bits_init(&r.alive, &r.memory, FROM), GMDS_OK);
  ck_assert_int_eq(gmds_rows_resize(&r.rows, &r.memory, FROM), GMDS_OK);
  for (size_t c = 0; c < FROM; c++) {
    int lives = random_below(&seed, 5) != 0;
    if (lives)
      gmds_bits_set(&r.alive, c);
    ck_assert_int_eq(gmds_rows_reserve(&r.rows, &r.memory, c, ARITY), GMDS_OK);
    for (size_t k = 0; k < ARITY; k++) {
      gmds_id *row = r.inlined + ARITY * c, x = (gmds_id)(30 * k + random_below(&seed, 30));
      row[k] = k && random_below(&seed, 6) == 0 ? GMDS_NONE : x;
      if (lives && row[k] != GMDS_NONE)
        gmds_rows_push(&r.rows, c, row[k]);
    }
  }
}

static void end(void)
{
  gmds_rows_clear(&r.rows, &r.memory);
  gmds_bits_clear(&r.alive);
  gmds_ids_clear(&r.list);
  ck_assert_uint_eq(r.memory.live, 0);
}

static size_t links(size_t c, gmds_id x)
{
  size_t n = 0;
  for (size_t k = 0; k < ARITY && gmds_bits_get(&r.alive, c); k++)
    n += r.inlined[ARITY * c + k] == x;
  return n;
}

static size_t times(size_t first, gmds_id x)
{
  size_t n = 0;
  for (size_t k = first; k < r.list.n; k++)
    n += r.list.data[k] == x;
  return n;
}

static void start_with(const gmds_id *cells, size_t n)
{
  r.list.n = 0;
  ck_assert_int_eq(gmds_ids_push(&r.list, 5), GMDS_OK); /* not part of the start */
  for (size_t k = 0; k < n; k++)
    ck_assert_int_eq(gmds_ids_push(&r.list, cells[k]), GMDS_OK);
}

static void is_along(const gmds_id *cells, size_t n, const char *what)
{
  for (gmds_id x = 0; x < TO; x++) {
    size_t expected = 0;
    for (size_t k = 0; k < n; k++)
      expected += links(cells[k], x);
    if (times(n + 1, x) != expected)
      ck_abort_msg("%s: %lu occurs %zu times, expected %zu", what, (unsigned long)x, times(n + 1, x), expected);
  }
  ck_assert_uint_eq(times(n + 1, GMDS_NONE), 0);
}

static void is_against(const gmds_id *cells, size_t n, const char *what)
{
  for (gmds_id c = 0; c < FROM; c++) {
    size_t expected = 0;
    for (size_t k = 0; k < n; k++)
      expected += links(c, cells[k]);
    if (times(n + 1, c) != expected)
      ck_abort_msg("%s: %lu occurs %zu times, expected %zu", what, (unsigned long)c, times(n + 1, c), expected);
  }
}

START_TEST(a_hop_keeps_every_link)
{
  begin(1);
  uint64_t seed = 2;
  for (int round = 0; round < 100; round++) {
    gmds_id cells[6];
    size_t n = random_below(&seed, 7);
    for (size_t k = 0; k < n; k++)
      do
        cells[k] = (gmds_id)random_below(&seed, FROM);
      while (!gmds_bits_get(&r.alive, cells[k]));
    start_with(cells, n);
    ck_assert_int_eq(gmds_hop_rows(&r.rows, &r.list, 1, n + 1), GMDS_OK);
    is_along(cells, n, "rows");
    start_with(cells, n);
    ck_assert_int_eq(gmds_hop_inline(r.inlined, ARITY, &r.list, 1, n + 1), GMDS_OK);
    is_along(cells, n, "inline");
  }
  end();
}
END_TEST

START_TEST(a_traversal_is_the_hop_of_the_inverse)
{
  begin(3);
  uint64_t seed = 4;
  gmds_csr of_rows, of_inline, twice;
  gmds_csr_init(&of_rows, &r.memory);
  gmds_csr_init(&of_inline, &r.memory);
  gmds_csr_init(&twice, &r.memory);
  ck_assert_int_eq(gmds_invert_rows(&r.rows, FROM, TO, &of_rows), GMDS_OK);
  ck_assert_int_eq(gmds_invert_inline(r.inlined, ARITY, &r.alive, FROM, TO, &of_inline), GMDS_OK);
  ck_assert_int_eq(gmds_invert_csr(&of_rows, FROM, &twice), GMDS_OK);
  for (int round = 0; round < 200; round++) { /* one pass, several, or by the filter */
    gmds_id cells[20];
    size_t n = random_below(&seed, round % 2 ? 21 : 6);
    for (size_t k = 0; k < n; k++)
      cells[k] = (gmds_id)random_below(&seed, TO);
    start_with(cells, n);
    ck_assert_int_eq(gmds_scan_rows(&r.rows, FROM, &r.list, 1, n + 1), GMDS_OK);
    is_against(cells, n, "scan of rows");
    start_with(cells, n);
    ck_assert_int_eq(gmds_scan_inline(r.inlined, ARITY, &r.alive, FROM, &r.list, 1, n + 1), GMDS_OK);
    is_against(cells, n, "scan of a column");
    start_with(cells, n);
    ck_assert_int_eq(gmds_hop_csr(&of_rows, &r.list, 1, n + 1), GMDS_OK);
    is_against(cells, n, "inverse of rows");
    start_with(cells, n);
    ck_assert_int_eq(gmds_hop_csr(&of_inline, &r.list, 1, n + 1), GMDS_OK);
    is_against(cells, n, "inverse of a column");
    start_with(cells, n);
    ck_assert_int_eq(gmds_hop_csr(&twice, &r.list, 1, n + 1), GMDS_OK);
    is_along(cells, n, "inverse of the inverse");
  }
  gmds_csr_clear(&of_rows);
  gmds_csr_clear(&of_inline);
  gmds_csr_clear(&twice);
  end();
}
END_TEST

/* Rows that moved about the pool leave old entries in free blocks, and are not in its order. */
START_TEST(a_traversal_passes_over_free_blocks)
{
  begin(7);
  uint64_t seed = 8;
  for (int round = 0; round < 400; round++) {
    size_t c = random_below(&seed, FROM), n = 0;
    if (!gmds_bits_get(&r.alive, c))
      continue;
    gmds_rows_get(&r.rows, c, &n);
    if (random_below(&seed, 2))
      ck_assert_int_eq(gmds_rows_reserve(&r.rows, &r.memory, c, 4 + random_below(&seed, 20)), GMDS_OK);
    else {
      gmds_id kept[ARITY];
      if (n)
        memcpy(kept, gmds_rows_get(&r.rows, c, &n), n * sizeof *kept);
      gmds_rows_release(&r.rows, c);
      ck_assert_int_eq(gmds_rows_reserve(&r.rows, &r.memory, c, n), GMDS_OK);
      for (size_t k = 0; k < n; k++)
        gmds_rows_push(&r.rows, c, kept[k]);
    }
  }
  for (gmds_id x = 0; x < TO; x++) {
    start_with(&x, 1);
    ck_assert_int_eq(gmds_scan_rows(&r.rows, FROM, &r.list, 1, 2), GMDS_OK);
    is_against(&x, 1, "scan of rows");
  }
  end();
}
END_TEST

START_TEST(a_meeting_is_what_several_rows_name)
{
  begin(9);
  uint64_t seed = 10;
  for (int round = 0; round < 300; round++) {
    gmds_id cells[8];
    size_t n = 1 + random_below(&seed, 8), least = 1 + random_below(&seed, 4);
    for (size_t k = 0; k < n; k++)
      cells[k] = (gmds_id)(11 * k + random_below(&seed, 11));
    for (int inlined = 0; inlined < 2; inlined++) {
      start_with(cells, n);
      if (inlined)
        ck_assert_int_eq(gmds_scan_meet_inline(r.inlined, ARITY, &r.alive, FROM, &r.list, 1, n + 1, least), GMDS_OK);
      else
        ck_assert_int_eq(gmds_scan_meet_rows(&r.rows, FROM, &r.list, 1, n + 1, least), GMDS_OK);
      for (gmds_id c = 0; c < FROM; c++) {
        size_t common = 0;
        for (size_t k = 0; k < n; k++)
          common += links(c, cells[k]);
        ck_assert_uint_eq(times(n + 1, c), common >= least);
      }
    }
  }
  end();
}
END_TEST

START_TEST(a_hop_without_memory_leaves_the_list_as_it_was)
{
  begin(5);
  gmds_csr csr;
  gmds_csr_init(&csr, &r.memory);
  ck_assert_int_eq(gmds_invert_rows(&r.rows, FROM, TO, &csr), GMDS_OK);
  gmds_ids all = {.memory = &r.memory};
  for (gmds_id x = 0; x < TO; x++)
    ck_assert_int_eq(gmds_ids_push(&all, x), GMDS_OK);
  size_t n = all.n;
  r.memory.limit = r.memory.live;
  ck_assert_int_eq(gmds_scan_rows(&r.rows, FROM, &all, 0, n), GMDS_ERR_MEMORY);
  ck_assert_int_eq(gmds_scan_inline(r.inlined, ARITY, &r.alive, FROM, &all, 0, n), GMDS_ERR_MEMORY);
  ck_assert_int_eq(gmds_hop_csr(&csr, &all, 0, n), GMDS_ERR_MEMORY);
  ck_assert_int_eq(gmds_hop_rows(&r.rows, &all, 0, n), GMDS_ERR_MEMORY);
  ck_assert_int_eq(gmds_hop_inline(r.inlined, ARITY, &all, 0, n), GMDS_ERR_MEMORY);
  ck_assert_uint_eq(all.n, n);
  gmds_csr other;
  gmds_csr_init(&other, &r.memory);
  ck_assert_int_eq(gmds_invert_csr(&csr, FROM, &other), GMDS_ERR_MEMORY);
  ck_assert(!other.begin && !other.data);
  gmds_csr_clear(&csr);
  gmds_ids_clear(&all);
  end();
}
END_TEST

START_TEST(a_pair_is_found_in_either_order_among_live_cells)
{
  enum { PAIRS = 200 };
  gmds_memory memory;
  gmds_bits alive;
  gmds_id pairs[2 * PAIRS];
  uint64_t seed = 6;
  gmds_memory_init(&memory, NULL);
  ck_assert_int_eq(gmds_bits_init(&alive, &memory, PAIRS), GMDS_OK);
  for (size_t e = 0; e < PAIRS; e++) {
    pairs[2 * e] = (gmds_id)(e / 10);
    pairs[2 * e + 1] = (gmds_id)(20 + e % 10);
    if (random_below(&seed, 4))
      gmds_bits_set(&alive, e);
  }
  for (gmds_id a = 0; a < 20; a++)
    for (gmds_id b = 20; b < 31; b++) {
      gmds_id e = 10 * a + b - 20;
      gmds_id expected = b < 30 && gmds_bits_get(&alive, e) ? e : GMDS_NONE;
      ck_assert_uint_eq(gmds_find_pair(pairs, &alive, PAIRS, a, b), expected);
      ck_assert_uint_eq(gmds_find_pair(pairs, &alive, PAIRS, b, a), expected);
      ck_assert_uint_eq(gmds_find_pair(pairs, &alive, PAIRS, a, a), GMDS_NONE);
    }
  gmds_bits_clear(&alive);
}
END_TEST

RUN_SUITE("hops", a_hop_keeps_every_link, a_traversal_is_the_hop_of_the_inverse, a_traversal_passes_over_free_blocks,
          a_meeting_is_what_several_rows_name, a_hop_without_memory_leaves_the_list_as_it_was,
          a_pair_is_found_in_either_order_among_live_cells)
