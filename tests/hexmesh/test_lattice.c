/* Claims about cells and triangles on the lattice, on numbers so small that everything touches everything. */
#include "exact.h"
#include <gmds/lattice.h>
#include <limits.h>

static gmds_memory memory;

/* A box and a triangle in a cube of `size` steps, contacts of all kinds among them, times `scale`, moved by up to
 * `jitter`. */
static void draw_pair(uint64_t *seed, size_t size, int32_t scale, size_t jitter, int32_t low[3], int32_t high[3],
                      int32_t t[9])
{
  for (int a = 0; a < 3; a++) {
    const int32_t x = (int32_t)random_below(seed, size + 1), y = (int32_t)random_below(seed, size + 1);
    low[a] = scale * (x < y ? x : y);
    high[a] = scale * (x < y ? y : x);
  }
  for (int k = 0; k < 9; k++) {
    int32_t x = scale * (int32_t)random_below(seed, size + 1);
    if (jitter && x > (int32_t)jitter)
      x -= (int32_t)random_below(seed, jitter + 1);
    t[k] = x;
  }
  if (random_below(seed, 8) == 0) /* a flat one */
    memcpy(t + 6, t + 3 * random_below(seed, 2), 3 * sizeof *t);
}

START_TEST(a_box_meets_a_triangle_where_clipping_leaves_something)
{
  uint64_t seed = 1;
  size_t met = 0, n = 400000;
  static const struct {
    size_t size;
    int32_t scale;
    size_t jitter;
  } kinds[] = {{3, 1, 0}, {6, 1, 0}, {16, 1, 0}, {1000, 1, 0}, {3, 1 << 18, 1}, {7, 1 << 17, 2}, {1 << 20, 1, 0}};
  for (size_t k = 0; k < n; k++) {
    const size_t kind = k % 7;
    int32_t low[3], high[3], t[9];
    draw_pair(&seed, kinds[kind].size, kinds[kind].scale, kinds[kind].jitter, low, high, t);
    const int meets = clipped_meets(low, high, t);
    ck_assert_int_eq(gmds_lattice_meets(low, high, t), meets);
    for (int a = 0; a < 3; a++) /* the largest coordinates there are */
      low[a] *= 1024, high[a] *= 1024;
    for (int a = 0; a < 9; a++)
      t[a] *= 1024;
    ck_assert_int_eq(gmds_lattice_meets(low, high, t), meets);
    met += (size_t)meets;
  }
  ck_assert_uint_gt(met, n / 5);
  ck_assert_uint_lt(met, n - n / 5);
}
END_TEST

START_TEST(boxes_and_triangles_that_touch_meet)
{
  const int32_t low[3] = {2, 2, 2}, high[3] = {4, 4, 4};
  static const struct {
    int32_t t[9];
    int meets;
  } cases[] = {{{4, 4, 4, 6, 5, 5, 5, 6, 5}, 1},    /* a corner at a corner */
               {{4, 5, 3, 4, 3, 3, 6, 4, 3}, 1},    /* an edge across a face */
               {{3, 5, 3, 5, 3, 3, 6, 6, 3}, 1},    /* an edge across an edge, at a point */
               {{3, 5, 3, 6, 3, 3, 6, 6, 3}, 0},    /* just beyond it */
               {{4, 0, 0, 4, 9, 0, 4, 0, 9}, 1},    /* in the plane of a face */
               {{5, 0, 0, 5, 9, 0, 5, 0, 9}, 0},    /* beside it */
               {{12, 0, 0, 0, 12, 0, 0, 0, 12}, 1}, /* its inside at a corner */
               {{13, 0, 0, 0, 13, 0, 0, 0, 13}, 0}, /* the plane passes by */
               {{3, 3, 3, 3, 3, 3, 3, 3, 3}, 1},    /* a point inside */
               {{4, 4, 2, 4, 4, 2, 4, 4, 2}, 1},    /* a point at a corner */
               {{0, 0, 0, 6, 6, 6, 3, 3, 3}, 1},    /* a segment through the middle */
               {{0, 3, 5, 3, 0, 5, 1, 2, 5}, 0},    /* a segment above */
               {{0, 0, 3, 9, 0, 3, 0, 9, 3}, 1}};   /* across */
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    ck_assert_msg(gmds_lattice_meets(low, high, cases[k].t) == cases[k].meets, "case %zu", k);
    ck_assert_int_eq(clipped_meets(low, high, cases[k].t), cases[k].meets);
  }
}
END_TEST

/* A lattice of 16 steps a side, made of the sides of random tetrahedra, flat ones among them: a closed surface that
 * crosses itself everywhere, of 4 n triangles. */
static gmds_lattice draw_lattice(uint64_t *seed, size_t n, uint32_t base, unsigned bits, int32_t *triangles)
{
  static const int side[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  for (size_t k = 0; k < n; k++) {
    int32_t corner[4][3];
    for (int i = 0; i < 12; i++)
      corner[i / 3][i % 3] = (int32_t)(random_below(seed, 3) ? 16 * random_below(seed, 2) : random_below(seed, 17));
    for (size_t i = 0; i < 12; i++)
      memcpy(triangles + 36 * k + 3 * i, corner[side[i / 3][i % 3]], sizeof *corner);
  }
  return (gmds_lattice){
      .memory = &memory, .base = {base, base, base}, .bits = bits, .n_triangles = 4 * n, .triangles = triangles};
}

static int every(void *user, gmds_lattice_cell cell, gmds_lattice_state state)
{
  (void)cell, (void)state;
  ++*(size_t *)user;
  return 1;
}

/* One leaf of the lattice above against all triangles: the box by clipping, the centre, moved by little enough, by rays
 * along every axis. */
static void check_leaf(const gmds_lattice *l, gmds_lattice_cell cell, gmds_lattice_state state, int32_t winding)
{
  int32_t low[3], high[3];
  int cut = 0;
  wide p[3];
  gmds_lattice_bounds(l, cell, low, high);
  for (size_t t = 0; t < l->n_triangles && !cut; t++)
    cut = clipped_meets(low, high, l->triangles + 9 * t);
  for (int a = 0; a < 3; a++)
    p[a] = ((wide)(low[a] + high[a]) << 35) + ((wide)1 << (24 - 12 * a));
  for (int a = 0; a < 3; a++)
    ck_assert_int_eq(wind_along(l->n_triangles, l->triangles, (wide)1 << 36, p, a), winding);
  ck_assert_int_eq(state, cut ? GMDS_LATTICE_CUT : gmds_lattice_side(winding));
}

START_TEST(children_are_what_clipping_and_rays_say)
{
  uint64_t seed = 2;
  int32_t triangles[36 * 4];
  size_t seen[3] = {0};
  for (int round = 0; round < 60; round++) {
    gmds_memory_init(&memory, NULL);
    const gmds_lattice l = draw_lattice(&seed, 1 + (size_t)round % 4, 1, 4, triangles);
    gmds_ids list, none;
    gmds_lattice_octants o;
    gmds_ids_init(&list, &memory);
    gmds_ids_init(&none, &memory);
    gmds_lattice_roots roots;
    gmds_lattice_roots_init(&roots, &memory);
    ck_assert_int_eq(gmds_lattice_find_roots(&l, 0, 1, &roots), GMDS_OK);
    const gmds_id *row;
    const size_t n = gmds_csr_row(&roots.triangles, 0, &row);
    ck_assert_uint_eq(n, l.n_triangles);
    const gmds_lattice_cell root = {{0, 0, 0}, 0};
    ck_assert_int_eq(gmds_lattice_split(&l, root, roots.winding[0], n, row, 0xff, &list, &o), GMDS_OK);
    for (unsigned c = 0; c < 8; c++) {
      const gmds_lattice_cell child = gmds_lattice_child(root, c);
      gmds_lattice_octants below, alone;
      ck_assert_int_eq(o.cut >> c & 1, o.begin[c + 1] != o.begin[c]);
      check_leaf(&l, child, o.cut >> c & 1 ? GMDS_LATTICE_CUT : gmds_lattice_side(o.winding[c]), o.winding[c]);
      ck_assert_int_eq(gmds_lattice_split(&l, child, o.winding[c], o.begin[c + 1] - o.begin[c], list.data + o.begin[c],
                                          0, NULL, &below),
                       GMDS_OK);
      none.n = 0; /* all triangles in place of the child's, some lists alone */
      ck_assert_int_eq(gmds_lattice_split(&l, child, o.winding[c], n, row, 0x96, &none, &alone), GMDS_OK);
      ck_assert_uint_eq(alone.cut, below.cut);
      ck_assert_mem_eq(alone.winding, below.winding, sizeof alone.winding);
      for (unsigned d = 0; d < 8; d++) {
        const int cut = below.cut >> d & 1;
        ck_assert_int_eq(alone.begin[d + 1] != alone.begin[d], (0x96 >> d & 1) && cut);
        const gmds_lattice_state state = cut ? GMDS_LATTICE_CUT : gmds_lattice_side(below.winding[d]);
        check_leaf(&l, gmds_lattice_child(child, d), state, below.winding[d]);
        seen[state]++;
      }
    }
    gmds_lattice_roots_clear(&roots);
    gmds_ids_clear(&list);
    gmds_ids_clear(&none);
    ck_assert_uint_eq(memory.live, 0);
  }
  ck_assert(seen[GMDS_LATTICE_OUTSIDE] > 500 && seen[GMDS_LATTICE_CUT] > 500);
}
END_TEST

/* The finest cells as base cells, by parts, and as children of one: the same. */
START_TEST(roots_are_what_children_are)
{
  uint64_t seed = 3;
  int32_t triangles[36 * 6];
  size_t seen[3] = {0};
  for (int round = 0; round < 25; round++) {
    gmds_memory_init(&memory, NULL);
    const gmds_lattice l = draw_lattice(&seed, 1 + (size_t)round % 6, 1, 4, triangles);
    gmds_lattice fine = l;
    fine.bits = 1;
    fine.base[0] = fine.base[1] = fine.base[2] = 8;
    gmds_lattice_roots part[3];
    const size_t end[4] = {0, 64 * (size_t)(round % 8) + 3, 500, 512};
    for (int k = 0; k < 3; k++) {
      gmds_lattice_roots_init(&part[k], &memory);
      ck_assert_int_eq(gmds_lattice_find_roots(&fine, end[k], end[k + 1], &part[k]), GMDS_OK);
      ck_assert_uint_eq(part[k].first, end[k]);
    }
    gmds_lattice_leaves leaves;
    size_t asked = 0;
    gmds_lattice_leaves_init(&leaves, &memory);
    ck_assert_int_eq(gmds_lattice_refine(&l, 3, every, &asked, &leaves), GMDS_OK);
    ck_assert_uint_eq(asked, 1 + 8 + 64);
    ck_assert_uint_eq(leaves.n, 512);
    for (size_t k = 0; k < leaves.n; k++) {
      const gmds_lattice_leaf *leaf = &leaves.leaf[k];
      const size_t c = leaf->at[0] + 8 * (leaf->at[1] + 8 * (size_t)leaf->at[2]);
      const gmds_lattice_roots *in = &part[(c >= end[1]) + (c >= end[2])];
      const gmds_lattice_cell base = gmds_lattice_base(&fine, c);
      const gmds_id *row;
      const size_t n = gmds_csr_row(&in->triangles, c - in->first, &row);
      ck_assert_mem_eq(base.at, leaf->at, sizeof base.at);
      ck_assert_int_eq(leaf->state, n ? GMDS_LATTICE_CUT : gmds_lattice_side(in->winding[c - in->first]));
      for (size_t i = 1; i < n; i++)
        ck_assert_uint_lt(row[i - 1], row[i]);
      check_leaf(&fine, base, (gmds_lattice_state)leaf->state, in->winding[c - in->first]);
    }
    for (int k = 0; k < 3; k++)
      seen[k] += leaves.count[k];
    gmds_lattice_leaves_clear(&leaves);
    for (int k = 0; k < 3; k++)
      gmds_lattice_roots_clear(&part[k]);
    ck_assert_uint_eq(memory.live, 0);
  }
  ck_assert(seen[GMDS_LATTICE_OUTSIDE] > 500 && seen[GMDS_LATTICE_INSIDE] > 30 && seen[GMDS_LATTICE_CUT] > 500);
}
END_TEST

/* The same on the largest lattice, where sums of products would overflow first; and with corners moved by a step, cells
 * one by one, and rays along y and z. */
START_TEST(the_largest_lattice_is_as_the_smallest)
{
  uint64_t seed = 6;
  int32_t triangles[36 * 3], large[36 * 3];
  for (int round = 0; round < 40; round++) {
    gmds_memory_init(&memory, NULL);
    const gmds_lattice l = draw_lattice(&seed, 1 + (size_t)round % 3, 1, 4, triangles);
    gmds_lattice big = l;
    gmds_lattice_leaves leaves[2];
    size_t asked = 0, wrong = 0;
    big.bits = 30;
    big.triangles = large;
    for (size_t k = 0; k < 9 * l.n_triangles; k++)
      large[k] = triangles[k] << 26;
    for (int k = 0; k < 2; k++) {
      gmds_lattice_leaves_init(&leaves[k], &memory);
      ck_assert_int_eq(gmds_lattice_refine(k ? &big : &l, 3, every, &asked, &leaves[k]), GMDS_OK);
    }
    ck_assert_uint_eq(leaves[0].n, leaves[1].n);
    for (size_t k = 0; k < leaves[0].n; k++)
      wrong += leaves[0].leaf[k].state != leaves[1].leaf[k].state;
    ck_assert_uint_eq(wrong, 0);
    ck_assert(leaves[0].lowest == leaves[1].lowest && leaves[0].highest == leaves[1].highest);
    gmds_lattice_leaves_clear(&leaves[1]);
    for (size_t k = 0; k < 9 * l.n_triangles; k++) /* equal corners stay equal */
      large[k] += ((triangles[k - k % 3] + triangles[k - k % 3 + 1] + triangles[k - k % 3 + 2]) % 3 - 1) *
                  (triangles[k] && triangles[k] < 16);
    gmds_lattice_leaves_init(&leaves[1], &memory);
    ck_assert_int_eq(gmds_lattice_refine(&big, 3, every, &asked, &leaves[1]), GMDS_OK);
    for (size_t k = 0; k < leaves[1].n; k++)
      wrong += !leaf_is_right(&big, &leaves[1].leaf[k]);
    ck_assert_uint_eq(wrong, 0);
    gmds_lattice_leaves_clear(&leaves[0]);
    gmds_lattice_leaves_clear(&leaves[1]);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

START_TEST(cells_that_are_not_there_are_refused)
{
  uint64_t seed = 4;
  int32_t triangles[36];
  gmds_memory_init(&memory, NULL);
  const gmds_lattice l = draw_lattice(&seed, 1, 1, 4, triangles);
  gmds_lattice_octants o;
  gmds_lattice_roots roots;
  gmds_lattice_leaves leaves;
  gmds_lattice_roots_init(&roots, &memory);
  gmds_lattice_leaves_init(&leaves, &memory);
  const gmds_lattice_cell deep = {{0, 0, 0}, 3}, beside = {{0, 2, 0}, 1};
  ck_assert_int_eq(gmds_lattice_split(&l, deep, 0, 0, NULL, 0, NULL, &o), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_lattice_split(&l, beside, 0, 0, NULL, 0, NULL, &o), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_lattice_find_roots(&l, 0, 2, &roots), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_lattice_find_roots(&l, 1, 1, &roots), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_lattice_refine(&l, 4, NULL, NULL, &leaves), GMDS_ERR_ARGUMENT);
  ck_assert(!leaves.n && !roots.triangles.n && !memory.peak);
}
END_TEST

RUN_SUITE("cells on the lattice", a_box_meets_a_triangle_where_clipping_leaves_something,
          boxes_and_triangles_that_touch_meet, children_are_what_clipping_and_rays_say, roots_are_what_children_are,
          the_largest_lattice_is_as_the_smallest, cells_that_are_not_there_are_refused)
