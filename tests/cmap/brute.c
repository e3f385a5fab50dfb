#include "brute.h"
#include "harness.h"

/* An assertion that costs nothing while it holds: Check writes a line for each of its own. */
#define HOLD(x)               \
  do                          \
    if (!(x))                 \
      ck_abort_msg("%s", #x); \
  while (0)

static gmds_id of(const brute *b, int i, gmds_id d)
{
  return d == GMDS_NONE ? GMDS_NONE : b->beta[i][d];
}

void brute_init(brute *b, int n)
{
  memset(b, 0, sizeof *b);
  b->n = n;
}

void brute_copy(brute *b, const gmds_map *map)
{
  brute_init(b, map->n);
  b->end = map->darts.end;
  HOLD(b->end <= BRUTE_MOST);
  for (gmds_id d = 0; d < b->end; d++) {
    b->alive[d] = (uint8_t)gmds_map_has(map, d);
    for (int i = 0; i <= b->n; i++)
      b->beta[i][d] = b->alive[d] ? gmds_map_beta(map, i, d) : GMDS_NONE;
  }
}

int brute_equals(const brute *b, const gmds_map *map)
{
  for (gmds_id d = 0; d < BRUTE_MOST; d++) {
    const int has = d < b->end && b->alive[d];
    if (has != gmds_map_has(map, d))
      return 0;
    for (int i = 0; i <= b->n && has; i++)
      if (b->beta[i][d] != gmds_map_beta(map, i, d))
        return 0;
  }
  return 1;
}

unsigned brute_cell(const brute *b, int i)
{
  unsigned mask = 0;
  for (int j = 1; j <= b->n; j++)
    mask |= j != i ? 1u << j : 0;
  return i ? mask : GMDS_SAME_ORIGIN;
}

/* Marks what one step leads to from d. */
static size_t step(const brute *b, gmds_id d, unsigned betas, uint8_t *in)
{
  gmds_id to[64];
  size_t n = 0, more = 0;
  if (betas == GMDS_SAME_ORIGIN) {
    for (int i = 0; i <= b->n; i++) /* every two links that keep the origin: one turns the dart round, the other back */
      for (int j = 0; j <= b->n; j++)
        if ((i == 0 && j > 1) || (i > 1 && j == 1) || (i > 1 && j > 1 && i != j))
          to[n++] = of(b, j, of(b, i, d));
  } else
    for (int i = 1; i <= b->n; i++)
      if (betas >> i & 1) {
        to[n++] = of(b, i, d);
        to[n++] = i == 1 ? of(b, 0, d) : GMDS_NONE;
      }
  for (size_t k = 0; k < n; k++)
    if (to[k] != GMDS_NONE && !in[to[k]]) {
      in[to[k]] = 1;
      more++;
    }
  return more;
}

size_t brute_orbit(const brute *b, gmds_id d, unsigned betas, uint8_t *in)
{
  size_t n = 1, more = 1;
  memset(in, 0, BRUTE_MOST);
  in[d] = 1;
  while (more) {
    more = 0;
    for (gmds_id e = 0; e < b->end; e++)
      if (in[e])
        more += step(b, e, betas, in);
    n += more;
  }
  return n;
}

int brute_is_map(const brute *b)
{
  for (gmds_id d = 0; d < b->end; d++) {
    if (!b->alive[d])
      continue;
    for (int i = 0; i <= b->n; i++) {
      const gmds_id e = b->beta[i][d];
      if (e == GMDS_NONE)
        continue;
      if (e >= b->end || !b->alive[e] || b->beta[i < 2 ? 1 - i : i][e] != d || (i > 1 && e == d))
        return 0;
    }
    for (int i = 1; i <= b->n; i++)
      for (int j = i + 2; j <= b->n; j++) {
        const gmds_id one = of(b, j, of(b, i, d)), other = of(b, i == 1 ? 0 : i, of(b, j, d));
        const int both = b->beta[i][d] != GMDS_NONE && b->beta[j][d] != GMDS_NONE;
        if (both ? one != other || one == GMDS_NONE : one != other && b->beta[i][d] != GMDS_NONE)
          return 0;
      }
  }
  return 1;
}

void brute_check_cells(const gmds_map *map)
{
  static brute b;
  static uint8_t in[BRUTE_MOST];
  brute_copy(&b, map);
  HOLD(brute_is_map(&b));
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    size_t orbits = 0, bare = 0;
    if (!map->slot[i])
      continue;
    for (gmds_id d = 0; d < b.end; d++) {
      if (!b.alive[d])
        continue;
      const gmds_id c = gmds_map_cell(map, i, d);
      HOLD(gmds_cells_has(&map->cells[i], c));
      (void)brute_orbit(&b, d, brute_cell(&b, i), in);
      gmds_id least = d;
      for (gmds_id e = 0; e < b.end; e++) {
        if (b.alive[e])
          HOLD((in[e] != 0) == (gmds_map_cell(map, i, e) == c));
        if (in[e] && e < least)
          least = e;
      }
      orbits += least == d;
      HOLD(in[map->anchor[i][c]]);
    }
    for (gmds_id c = gmds_cells_next(&map->cells[i], 0); c != GMDS_NONE; c = gmds_cells_next(&map->cells[i], c + 1))
      bare += map->anchor[i][c] == GMDS_NONE;
    HOLD(map->cells[i].count == orbits + bare);
    HOLD(i == 0 || bare == 0);
  }
}

/* ---- sewing: a pair is asked for and checked until nothing is new */

static gmds_id with[BRUTE_MOST], back[BRUTE_MOST];

static int pair_up(const brute *b, int i, gmds_id d, gmds_id e, size_t *pairs)
{
  if (d == GMDS_NONE && e == GMDS_NONE)
    return 1;
  if (d == GMDS_NONE || e == GMDS_NONE || (i > 1 && d == e))
    return 0;
  if (with[d] == e && (i == 1 ? back[e] == d : with[e] == d))
    return 1;
  if (with[d] != GMDS_NONE || (i == 1 ? back[e] : with[e]) != GMDS_NONE)
    return 0;
  if (b->beta[i][d] != GMDS_NONE || b->beta[i == 1 ? 0 : i][e] != GMDS_NONE)
    return 0;
  with[d] = e;
  if (i == 1)
    back[e] = d;
  else
    with[e] = d;
  ++*pairs;
  return 1;
}

int brute_sew(brute *b, int i, gmds_id d, gmds_id e)
{
  size_t pairs = 0, had = 0;
  for (size_t k = 0; k < BRUTE_MOST; k++)
    with[k] = back[k] = GMDS_NONE;
  if (!pair_up(b, i, d, e, &pairs))
    return 0;
  while (had != pairs) {
    had = pairs;
    for (gmds_id x = 0; x < b->end; x++) {
      const gmds_id y = with[x];
      if (y == GMDS_NONE)
        continue;
      if (i > 2 && (!pair_up(b, i, b->beta[1][x], b->beta[0][y], &pairs) ||
                    !pair_up(b, i, b->beta[0][x], b->beta[1][y], &pairs)))
        return 0;
      for (int j = 2; j <= b->n; j++) {
        if (j >= i - 1 && j <= i + 1)
          continue;
        const gmds_id p = b->beta[j][x], q = b->beta[j][y];
        if (!(i == 1 ? pair_up(b, i, q, p, &pairs) : pair_up(b, i, p, q, &pairs)))
          return 0;
      }
    }
    had = had == pairs ? pairs : 0;
  }
  for (gmds_id x = 0; x < b->end; x++)
    if (with[x] != GMDS_NONE) {
      b->beta[i][x] = with[x];
      if (i == 1)
        b->beta[0][with[x]] = x;
    }
  return 1;
}

int brute_unsew(brute *b, int i, gmds_id d)
{
  static uint8_t goes[BRUTE_MOST];
  if (b->beta[i][d] == GMDS_NONE)
    return 0;
  memset(goes, 0, sizeof goes);
  goes[d] = 1;
  for (int more = 1; more;) {
    more = 0;
    for (gmds_id x = 0; x < b->end; x++) {
      if (!goes[x])
        continue;
      for (int j = 0; j <= b->n; j++) {
        if ((j < 2 && i < 3) || (j >= i - 1 && j <= i + 1))
          continue;
        const gmds_id y = of(b, j, i == 1 ? b->beta[1][x] : x);
        if (y != GMDS_NONE && !goes[y] && b->beta[i][y] != GMDS_NONE)
          more = goes[y] = 1;
      }
    }
  }
  for (gmds_id x = 0; x < b->end; x++)
    if (goes[x] && b->beta[i][x] != GMDS_NONE) {
      b->beta[i == 1 ? 0 : i][b->beta[i][x]] = GMDS_NONE;
      b->beta[i][x] = GMDS_NONE;
    }
  return 1;
}

/* ---- removal and contraction: every link into the cell is followed through it, on a copy of the links */

static void drop(brute *b, const uint8_t *in)
{
  for (gmds_id d = 0; d < b->end; d++)
    for (int i = 0; i <= b->n; i++)
      if (in[d] || (b->beta[i][d] != GMDS_NONE && in[b->beta[i][d]]))
        b->beta[i][d] = GMDS_NONE;
  for (gmds_id d = 0; d < b->end; d++)
    b->alive[d] = b->alive[d] && !in[d];
}

/* Follows beta_i, and through the cell beta_`through` and beta_i, until it is left. */
static gmds_id pass(const brute *b, const uint8_t *in, int i, int through, gmds_id d)
{
  gmds_id e = of(b, i, d);
  while (e != GMDS_NONE && in[e])
    e = of(b, i, through ? of(b, through, e) : e);
  return e;
}

static int take_out(brute *b, int i, gmds_id d, int through)
{
  static brute was;
  static uint8_t in[BRUTE_MOST];
  was = *b;
  (void)brute_orbit(b, d, brute_cell(b, i), in);
  drop(b, in);
  for (gmds_id x = 0; x < b->end; x++) {
    if (!b->alive[x])
      continue;
    if (i == 0) { /* the end of x goes: so does all that begins there */
      gmds_id last = GMDS_NONE, e = was.beta[1][x];
      for (; e != GMDS_NONE && in[e]; e = was.beta[1][e])
        last = e;
      if (last == GMDS_NONE)
        continue;
      b->beta[1][x] = e;
      if (e != GMDS_NONE)
        b->beta[0][e] = x;
      for (int j = 2; j <= b->n; j++)
        if (was.beta[j][last] != GMDS_NONE && !in[was.beta[j][last]] && was.beta[j][last] != x) {
          b->beta[j][x] = was.beta[j][last];
          b->beta[j][b->beta[j][x]] = x;
        } else /* an end of one edge: it becomes free */
          b->beta[j][x] = was.beta[j][x] != GMDS_NONE && in[was.beta[j][x]] ? GMDS_NONE : b->beta[j][x];
      continue;
    }
    if (was.beta[i][x] == GMDS_NONE || !in[was.beta[i][x]])
      continue;
    const gmds_id y = pass(&was, in, i, through, x);
    if (y == GMDS_NONE || (i > 1 && y == x))
      continue;
    b->beta[i][x] = y;
    b->beta[i == 1 ? 0 : i][y] = x;
  }
  return brute_is_map(b); /* around open faces it need not be one */
}

int brute_remove(brute *b, int i, gmds_id d)
{
  static uint8_t in[BRUTE_MOST];
  (void)brute_orbit(b, d, brute_cell(b, i), in);
  for (gmds_id x = 0; x < b->end && i < b->n - 1; x++)
    if (in[x] && of(b, i + 1, of(b, i + 2, x)) != of(b, i + 2, of(b, i ? i + 1 : 0, x)))
      return 0;
  return take_out(b, i, d, i + 1);
}

int brute_contract(brute *b, int i, gmds_id d)
{
  static uint8_t in[BRUTE_MOST];
  (void)brute_orbit(b, d, brute_cell(b, i), in);
  for (gmds_id x = 0; x < b->end && i > 1; x++)
    if (in[x]) {
      const int inverse = i == 2 ? 1 : i == 3 ? 0 : i - 2;
      if (of(b, i - 1, of(b, i - 2, x)) != of(b, inverse, of(b, i - 1, x)))
        return 0;
    }
  return take_out(b, i, d, i > 1 ? i - 1 : 0);
}
