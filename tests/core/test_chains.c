/* Chains: every side once, open ones first, loops closed. */
#include "harness.h"
#include <gmds/chains.h>

enum { NODES = 20 };

static gmds_memory memory;
static gmds_csr chains;
static size_t n_open;

/* Chains the sides; each must occur once in them, the closing one of a loop too. */
static void chain(size_t n, const gmds_id *sides)
{
  int left[NODES][NODES] = {{0}};
  gmds_memory_init(&memory, NULL);
  gmds_csr_init(&chains, &memory);
  ck_assert_int_eq(gmds_chain_sides(n, sides, NODES, &memory, &chains, &n_open), GMDS_OK);
  for (size_t k = 0; k < n; k++) {
    left[sides[2 * k]][sides[2 * k + 1]]++;
    left[sides[2 * k + 1]][sides[2 * k]]++;
  }
  for (size_t r = 0; r < chains.n; r++) {
    size_t length = chains.begin[r + 1] - chains.begin[r];
    const gmds_id *row = chains.data + chains.begin[r];
    for (size_t k = 0; k + (r < n_open) < length; k++) {
      gmds_id p = row[k], q = row[k + 1 < length ? k + 1 : 0];
      left[p][q]--;
      left[q][p]--;
    }
  }
  for (int p = 0; p < NODES; p++)
    for (int q = 0; q < NODES; q++)
      ck_assert_int_eq(left[p][q], 0);
}

static void done(void)
{
  gmds_csr_clear(&chains);
  ck_assert_uint_eq(memory.live, 0);
}

START_TEST(a_loop_goes_the_way_of_its_sides)
{
  const gmds_id sides[] = {7, 3, 5, 7, 3, 9, 9, 5};
  const gmds_id expected[] = {7, 3, 9, 5};
  chain(4, sides);
  ck_assert_uint_eq(n_open, 0);
  ck_assert_uint_eq(chains.n, 1);
  ck_assert_int_eq(memcmp(chains.data, expected, sizeof expected), 0);
  done();
  chain(0, NULL);
  ck_assert_uint_eq(chains.n, 0);
  done();
}
END_TEST

START_TEST(open_chains_come_before_loops)
{
  const gmds_id sides[] = {0, 1, 1, 2, 2, 0, 10, 11, 12, 11, 12, 13, 11, 14};
  chain(7, sides);
  ck_assert_uint_eq(n_open, 2); /* three sides meet in node 11 */
  ck_assert_uint_eq(chains.n, 3);
  ck_assert_uint_eq(chains.begin[3] - chains.begin[2], 3);
  done();
}
END_TEST

START_TEST(random_sides_are_used_once)
{
  uint64_t seed = 1;
  for (int round = 0; round < 500; round++) {
    gmds_id sides[2 * 30];
    size_t n = random_below(&seed, 31);
    for (size_t k = 0; k < n; k++) {
      sides[2 * k] = (gmds_id)random_below(&seed, NODES);
      sides[2 * k + 1] = (gmds_id)((sides[2 * k] + 1 + random_below(&seed, NODES - 1)) % NODES);
    }
    chain(n, sides);
    done();
  }
}
END_TEST

START_TEST(without_memory_nothing_has_changed)
{
  const gmds_id sides[] = {0, 1, 1, 2, 2, 0, 3, 4};
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    size_t open = 99;
    gmds_memory_init(&memory, &allocator);
    gmds_csr_init(&chains, &memory);
    status = gmds_chain_sides(4, sides, NODES, &memory, &chains, &open);
    ck_assert(status == GMDS_OK || (!chains.begin && open == 99));
    gmds_csr_clear(&chains);
    ck_assert_uint_eq(f.live, 0);
  }
  ck_assert_int_eq(status, GMDS_OK);
}
END_TEST

RUN_SUITE("chains", a_loop_goes_the_way_of_its_sides, open_chains_come_before_loops, random_sides_are_used_once,
          without_memory_nothing_has_changed)
