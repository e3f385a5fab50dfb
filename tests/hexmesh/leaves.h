/* What holds of the leaves of every surface. */
#ifndef GMDS_TESTS_LEAVES_H
#define GMDS_TESTS_LEAVES_H

#include "exact.h"
#include <gmds/io.h>
#include <gmds/lattice.h>
#include <math.h>

static gmds_memory memory;

/* Six times the volume within the triangles, exactly: signed, in cubes of steps. */
static inline wide volume_of(const gmds_lattice *l)
{
  wide sum = 0;
  for (size_t k = 0; k < l->n_triangles; k++) {
    const int32_t *t = l->triangles + 9 * k;
    for (int a = 0; a < 3; a++) {
      const int u = (a + 1) % 3, v = (a + 2) % 3;
      sum += (wide)t[a] * ((int64_t)t[3 + u] * t[6 + v] - (int64_t)t[3 + v] * t[6 + u]);
    }
  }
  return sum;
}

/* Six times the volume of the leaves in a state. */
static inline wide volume_in(const gmds_lattice *l, const gmds_lattice_leaves *leaves, gmds_lattice_state state)
{
  wide sum = 0;
  for (size_t k = 0; k < leaves->n; k++) {
    const wide w = gmds_lattice_width(l, leaves->leaf[k].level);
    sum += leaves->leaf[k].state == (uint8_t)state ? 6 * w * w * w : 0;
  }
  return sum;
}

/* The leaves as a grid of cells of level `depth`: every cell is in one leaf, and no cell inside shares a face with one
 * outside. */
static inline void check_neighbours(const gmds_lattice *l, const gmds_lattice_leaves *leaves, unsigned depth)
{
  const size_t n[3] = {(size_t)l->base[0] << depth, (size_t)l->base[1] << depth, (size_t)l->base[2] << depth};
  const size_t next[3] = {1, n[0], n[0] * n[1]};
  size_t twice = 0, none = 0, contradictions = 0;
  uint8_t *grid = malloc(n[0] * n[1] * n[2]);
  memset(grid, 9, n[0] * n[1] * n[2]);
  for (size_t k = 0; k < leaves->n; k++) {
    const gmds_lattice_leaf *leaf = &leaves->leaf[k];
    const size_t w = (size_t)1 << (depth - leaf->level);
    for (size_t z = leaf->at[2] * w; z < (leaf->at[2] + 1) * w; z++)
      for (size_t y = leaf->at[1] * w; y < (leaf->at[1] + 1) * w; y++)
        for (size_t x = leaf->at[0] * w; x < (leaf->at[0] + 1) * w; x++) {
          uint8_t *at = &grid[x + next[1] * y + next[2] * z];
          twice += *at != 9;
          *at = leaf->state;
        }
  }
  for (size_t c = 0; c < next[2] * n[2]; c++) {
    none += grid[c] == 9;
    for (int a = 0; a < 3 && grid[c] != GMDS_LATTICE_CUT; a++)
      if (c / next[a] % n[a] + 1 < n[a])
        contradictions += grid[c + next[a]] != GMDS_LATTICE_CUT && grid[c + next[a]] != grid[c];
  }
  free(grid);
  ck_assert(!twice && !none && !contradictions);
}

/* Leaves, all of them where that is no more than some millions of tests, against all triangles. */
static inline void check_leaves(const gmds_lattice *l, const gmds_lattice_leaves *leaves)
{
  size_t wrong = 0;
  for (size_t k = 0; k < leaves->n; k += 1 + leaves->n * l->n_triangles / 10000000)
    wrong += !leaf_is_right(l, &leaves->leaf[k]);
  ck_assert_uint_eq(wrong, 0);
}

static inline void make(const char *spec, gmds_soup *soup)
{
  gmds_error error = {.status = GMDS_OK};
  gmds_soup_init(soup, &memory, 3);
  ck_assert_msg(gmds_make_surface(spec, &error, soup) == GMDS_OK, "%s", error.text);
}

static inline void lay(const gmds_soup *soup, const gmds_lattice_options *options, gmds_lattice *l)
{
  gmds_lattice_init(l, &memory);
  ck_assert_msg(gmds_lattice_of_soup(l, soup, options) == GMDS_OK, "%s", options->error->text);
}

static inline void refine(const gmds_lattice *l, unsigned depth, gmds_lattice_leaves *leaves)
{
  gmds_lattice_leaves_init(leaves, &memory);
  ck_assert_int_eq(gmds_lattice_refine(l, depth, NULL, NULL, leaves), GMDS_OK);
}

/* What holds of every surface. *v: six times the volumes inside and cut. */
static inline void check_surface(const gmds_soup *soup, const gmds_lattice_options *o, unsigned depth, wide v[2],
                                 gmds_lattice *l, gmds_lattice_leaves *leaves)
{
  lay(soup, o, l);
  refine(l, depth, leaves);
  ck_assert_uint_eq(leaves->count[0] + leaves->count[1] + leaves->count[2], leaves->n);
  check_neighbours(l, leaves, depth);
  check_leaves(l, leaves);
  v[0] = volume_in(l, leaves, GMDS_LATTICE_INSIDE);
  v[1] = volume_in(l, leaves, GMDS_LATTICE_CUT);
  for (int a = 0; a < 3; a++)
    ck_assert(l->snap_error[a] <= 0.51 * l->step[a] + 0x1p-50 * fabs(l->low[a]));
}

/* What is refused leaves nothing behind, and says why. */
static inline void refuse(const gmds_soup *soup, gmds_lattice_options o, gmds_status status, const char *text)
{
  gmds_error error = {.status = GMDS_OK};
  gmds_lattice l;
  gmds_lattice_init(&l, &memory);
  const size_t live = memory.live;
  o.error = &error;
  ck_assert_int_eq(gmds_lattice_of_soup(&l, soup, &o), status);
  ck_assert_str_eq(error.text, text);
  ck_assert(!l.triangles && !l.bits && memory.live == live);
}

#endif
