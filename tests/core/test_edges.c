/* Tables of edges against brute force, on faces that share nodes at random. */
#include "harness.h"
#include <gmds/edges.h>
#include <limits.h>

enum { NODES = 20, FACES = 60, SIDES = 6 };

static gmds_memory memory;

typedef struct faces {
  size_t n, begin[FACES + 1];
  gmds_id nodes[FACES * SIDES];
} faces;

/* Faces of `least` to `most` distinct nodes. */
static void make_faces(faces *all, size_t least, size_t most, uint64_t *seed)
{
  *all = (faces){.n = FACES};
  for (size_t f = 0; f < FACES; f++) {
    size_t n = least + random_below(seed, most - least + 1);
    gmds_id *v = all->nodes + all->begin[f];
    all->begin[f + 1] = all->begin[f] + n;
    for (size_t k = 0; k < n;) {
      size_t q = 0;
      v[k] = (gmds_id)random_below(seed, NODES);
      while (v[q] != v[k])
        q++;
      k += q == k;
    }
  }
}

/* Whether edge e of the table joins a and b. */
static int joins(const gmds_edge_table *t, gmds_id e, gmds_id a, gmds_id b)
{
  return e < t->n && t->nodes[2 * e] == (a < b ? a : b) && t->nodes[2 * e + 1] == (a < b ? b : a);
}

/* Each row names the edges of its sides; each edge is named, no two join the same nodes, and lower nodes ascend. */
static void compare(const gmds_edge_table *t, const faces *all, const gmds_bits *alive)
{
  static int named[FACES * SIDES];
  memset(named, 0, sizeof named);
  ck_assert_uint_eq(t->n_faces, all->n);
  for (size_t f = 0; f < all->n; f++) {
    size_t n = 0, sides = all->begin[f + 1] - all->begin[f];
    const gmds_id *row = gmds_edge_table_row(t, f, &n), *v = all->nodes + all->begin[f];
    ck_assert_uint_eq(n, sides);
    for (size_t k = 0; k < n; k++)
      if (alive && !gmds_bits_get(alive, f))
        ck_assert_uint_eq(row[k], GMDS_NONE);
      else {
        ck_assert(joins(t, row[k], v[k], v[(k + 1) % n]));
        named[row[k]] = 1;
      }
  }
  for (size_t e = 0; e < t->n; e++) {
    ck_assert(named[e] && t->nodes[2 * e] < t->nodes[2 * e + 1]);
    for (size_t other = 0; other < e; other++)
      ck_assert(t->nodes[2 * other] < t->nodes[2 * e] ||
                (t->nodes[2 * other] == t->nodes[2 * e] && t->nodes[2 * other + 1] != t->nodes[2 * e + 1]));
  }
}

START_TEST(every_side_has_its_edge_and_every_edge_is_there_once)
{
  faces all;
  uint64_t seed = 1;
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 50; round++) {
    gmds_edge_table t;
    gmds_edge_table_init(&t, &memory);
    make_faces(&all, 2, SIDES, &seed);
    ck_assert_int_eq(gmds_edges_of_rows(NODES, all.n, all.begin, all.nodes, &t), GMDS_OK);
    compare(&t, &all, NULL);
    gmds_edge_table_clear(&t);
    for (size_t arity = 3; arity <= 5; arity++) {
      gmds_bits alive;
      ck_assert_int_eq(gmds_bits_init(&alive, &memory, FACES), GMDS_OK);
      for (size_t f = 0; f < FACES; f++)
        if (random_below(&seed, 4))
          gmds_bits_set(&alive, f);
      make_faces(&all, arity, arity, &seed);
      ck_assert_int_eq(gmds_edges_of_inline(NODES, all.n, arity, all.nodes, &alive, &t), GMDS_OK);
      compare(&t, &all, &alive);
      gmds_edge_table_clear(&t);
      ck_assert_int_eq(gmds_edges_of_inline(NODES, all.n, arity, all.nodes, NULL, &t), GMDS_OK);
      compare(&t, &all, NULL);
      gmds_edge_table_clear(&t);
      gmds_bits_clear(&alive);
    }
  }
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(no_faces_have_no_edges)
{
  gmds_edge_table t;
  const size_t begin[1] = {0};
  gmds_memory_init(&memory, NULL);
  gmds_edge_table_init(&t, &memory);
  ck_assert_int_eq(gmds_edges_of_inline(5, 0, 3, NULL, NULL, &t), GMDS_OK);
  ck_assert_uint_eq(t.n, 0);
  gmds_edge_table_clear(&t);
  ck_assert_int_eq(gmds_edges_of_rows(0, 0, begin, NULL, &t), GMDS_OK);
  ck_assert_uint_eq(t.n, 0);
  gmds_edge_table_clear(&t);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(a_table_without_memory_stays_empty)
{
  faces all;
  uint64_t seed = 9;
  make_faces(&all, 3, 3, &seed);
  for (int rows = 0; rows < 2; rows++) {
    failing f = {.until = 0};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory_init(&memory, &allocator);
    gmds_status status = GMDS_ERR_MEMORY;
    long k = 0;
    for (; status == GMDS_ERR_MEMORY; k++) {
      gmds_edge_table t;
      gmds_edge_table_init(&t, &memory);
      f.until = k;
      status = rows ? gmds_edges_of_rows(NODES, all.n, all.begin, all.nodes, &t)
                    : gmds_edges_of_inline(NODES, all.n, 3, all.nodes, NULL, &t);
      ck_assert(status == GMDS_OK || (!t.n && !t.nodes && !t.edges && !t.begin && memory.live == 0));
      gmds_edge_table_clear(&t);
      ck_assert_uint_eq(f.live, 0);
    }
    ck_assert_int_eq(status, GMDS_OK);
    ck_assert_int_ge(k, 4);
  }
}
END_TEST

RUN_SUITE("edges", every_side_has_its_edge_and_every_edge_is_there_once, no_faces_have_no_edges,
          a_table_without_memory_stays_empty)
