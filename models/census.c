/* The census of mesh models, computed from the composition tables. Definitions: [models] 2.2 and 2.3; the rule for the
 * 105 models of 4.2 is the paper's ("if the mesh model deals with edges, it has to contain 1 -> 0 or 0 -> 1") with the
 * models outside it that its Table 4 runs all the same: faces that keep their nodes and reach their neighbours. */
#include <ctype.h>
#include <gmds/census.h>
#include <gmds/models/tables.h>
#include <stdio.h>
#include <string.h>

typedef struct row {
  int id, table, hops;
  int cells[5], keep[4];
} row;

#define P1(id, i, j) {id, 0, 1, {i, j}, {1}},
#define P2(id, t, i, k, j, n) {id, t, 2, {i, k, j}, {1, n}},
#define P3(id, t, i, k, l, j, o, n) {id, t, 3, {i, k, l, j}, {1, o, n}},
#define P4(id, t, i, k, l, m, j, o, p, n) {id, t, 4, {i, k, l, m, j}, {1, o, p, n}},
#define END       \
  {               \
    0, 0, 0, {0}, \
    {             \
      0           \
    }             \
  }
#define LIST(i, j, PATHS) [4 * i + j] = (const row[]){PATHS(P1, P2, P3, P4) END},
static const row *const rows_of[16] = {GMDS_PAIR_LIST(LIST)};
static const row joined_by_edges[] = {GMDS_PATHS_0_0_BY_EDGES(P1, P2, P3, P4) END};
static const row joined_by_faces[] = {GMDS_PATHS_0_0_BY_FACES(P1, P2, P3, P4) END};
#undef LIST

static int stored(unsigned mask, int a, int b)
{
  return (mask >> (4 + 4 * a + b)) & 1;
}

/* The inverse hops of a row under a mask, or -1 when a hop has neither relation. */
static int inverse_hops(unsigned mask, const row *r)
{
  int inverse = 0;
  for (int s = 0; s < r->hops; s++) {
    int a = r->cells[s], b = r->cells[s + 1];
    if (stored(mask, a, b))
      continue;
    if (!stored(mask, b, a))
      return -1;
    inverse |= 1 << s;
  }
  return inverse;
}

static int bits(int x)
{
  int n = 0;
  for (; x; x &= x - 1)
    n++;
  return n;
}

/* Beyond simplices a multiplicity of nodes does not make a side (a quadrilateral and a diagonal that is an edge
 * elsewhere): the row is exact when the faces on it keep their nodes in order. */
static unsigned exact_types(unsigned mask, const row *r)
{
  const unsigned all = 7, triangles = 1;
  for (int s = 0; s <= r->hops; s++)
    if (r->cells[s] == 3)
      return 0;
  for (int s = 1; s < r->hops; s++) {
    int up = r->cells[s] == 0 && r->cells[s + 1] > 0 && r->keep[s] > 1;
    int by_sides = r->hops == 3 && s == 2 && stored(mask, 2, 1); /* F2E decides which faces share an edge */
    int ring = r->cells[0] == 0 && r->cells[s] == 2 && r->cells[s + 1] == 0;
    if ((up || ring) && !by_sides && !stored(mask, 2, 0))
      return triangles;
  }
  return all;
}

static int linked(unsigned mask, int a, int b)
{
  return stored(mask, a, b) || stored(mask, b, a);
}

/* The same where regions are kept (GMDS__EXACT_i_j of paths.h): beyond tetrahedra, cells that keep their nodes in order
 * decide, or what they keep of their edges and faces. A polyhedron keeps its faces (R2F) and these their nodes
 * (F2N). */
static unsigned exact_region_types(unsigned mask, int i, int j, const row *r)
{
  const unsigned all = 31, tetrahedra = 1;
  const int sides = stored(mask, 2, 0),
            walls = stored(mask, 3, 0) || (stored(mask, 3, 1) && stored(mask, 1, 0)) ||
                    (stored(mask, 3, 2) && stored(mask, 2, 0)),
            borders = sides || linked(mask, 1, 2),
            either = walls || linked(mask, 1, 3) || (linked(mask, 2, 3) && borders);
  int exact = 1;
  switch (4 * i + j) {
  case 0:
    exact = r->id == 3 ? sides : r->id == 4 ? walls : 1;
    break;
  case 6: /* 1 -> 2 */
  case 9: /* 2 -> 1 */
    exact = r->id != 2 || borders;
    break;
  case 7: /* 1 -> 3 */
    exact = r->id == 3 ? either : r->id == 4 ? borders : 1;
    break;
  case 10: /* 2 -> 2 */
    exact = r->id != 3 || borders;
    break;
  case 11: /* 2 -> 3 */
  case 14: /* 3 -> 2 */
    exact = r->id < 2 || walls || linked(mask, 2, 3);
    break;
  case 13: /* 3 -> 1 */
    exact = r->id == 3 ? either : r->id == 4 ? borders || either : 1;
    break;
  case 15: /* 3 -> 3 */
    exact = (r->id != 3 && r->id != 4 && r->id != 9) || walls || linked(mask, 2, 3);
    break;
  default:
    break;
  }
  return exact ? all : tetrahedra;
}

/* The rows that a mask may take from i to j. */
static const row *rows_for(unsigned mask, int i, int j)
{
  if (i == 0 && j == 0 && linked(mask, 0, 1))
    return joined_by_edges;
  if (i == 0 && j == 0 && linked(mask, 0, 2))
    return joined_by_faces;
  return rows_of[4 * i + j];
}

gmds_path gmds_path_of(unsigned mask, int i, int j)
{
  gmds_path path = {.cost = GMDS_COST_NONE};
  const row *best = NULL;
  int best_inverse = 0;
  for (const row *r = rows_for(mask, i, j); r->id; r++) {
    int inverse = inverse_hops(mask, r);
    /* of one row's hops only one set is the inverse one, so the fewest traversals, then the first row, decide */
    if (inverse >= 0 && (!best || bits(inverse) < bits(best_inverse))) {
      best = r;
      best_inverse = inverse;
    }
  }
  if (!best)
    return path;
  path.code = 16 * best->id + best_inverse;
  path.table = best->table;
  path.hops = best->hops;
  memcpy(path.cells, best->cells, sizeof path.cells);
  memcpy(path.keep, best->keep, sizeof path.keep);
  path.inverse = (unsigned)best_inverse;
  path.exact = exact_types(mask, best);
  path.exact_regions = exact_region_types(mask, i, j, best);
  if (!best_inverse)
    path.cost = best->hops == 1 ? GMDS_COST_DIRECT : GMDS_COST_LOCAL;
  else
    path.cost = best->hops == 1 ? GMDS_COST_GLOBAL : GMDS_COST_MIXED;
  return path;
}

const char *gmds_cost_text(gmds_cost cost)
{
#define WORD(name, word) word,
  static const char *const words[] = {GMDS_COST_LIST(WORD)};
#undef WORD
  return (unsigned)cost < GMDS_COST_COUNT ? words[cost] : "unknown";
}

static int answers(unsigned mask, int i, int j)
{
  return gmds_path_of(mask, i, j).cost != GMDS_COST_NONE;
}

gmds_census gmds_census_of(unsigned mask, int dim)
{
  gmds_census c = {.mask = mask, .full = 1, .complete = 1, .identified = 1};
  c.computable = answers(mask, dim, 0) && answers(mask, dim, dim);
  for (int i = 0; i <= dim; i++) {
    if (!(mask & GMDS_CELL_BIT(i))) {
      c.full = 0;
      continue;
    }
    for (int j = 0; j <= dim; j++)
      if ((mask & GMDS_CELL_BIT(j)) && gmds_path_of(mask, i, j).cost > GMDS_COST_LOCAL)
        c.complete = 0;
    if (i > 0 && i < dim && !answers(mask, i, 0))
      c.identified = 0;
  }
  c.identified = c.identified && c.computable;
  int ordered = stored(mask, 2, 0) && (stored(mask, 2, 2) || stored(mask, 0, 2));
  c.paper105 = dim == 2 && c.computable && (c.identified || ordered);
  return c;
}

#define BIT(name, i, j) GMDS_RELATION_BIT(i, j),
#define NAME(name, i, j) #name,
#define ENDS(name, i, j) (GMDS_CELL_BIT(i) | GMDS_CELL_BIT(j)),
static const unsigned relation_bits[16] = {GMDS_RELATION_LIST(BIT)};
static const char *const relation_names[16] = {GMDS_RELATION_LIST(NAME)};
static const unsigned relation_ends[16] = {GMDS_RELATION_LIST(ENDS)};

/* The relations of the census: i2j for i != j up to the dimension, and the adjacency of the top cells. */
static int in_census(int dim, int r)
{
  int i = r / 4, j = r % 4;
  return i <= dim && j <= dim && (i != j || i == dim);
}

size_t gmds_census_size(int dim)
{
  return dim == 2 ? 128 : dim == 3 ? 8192 : 0;
}

unsigned gmds_census_mask(int dim, size_t k)
{
  unsigned mask = GMDS_N | GMDS_CELL_BIT(dim);
  int position = 0;
  for (int r = 0; r < 16; r++)
    if (in_census(dim, r) && (k >> position++ & 1))
      mask |= relation_bits[r] | relation_ends[r];
  return mask;
}

/* ---- the models that take every path */

enum { CODES = 256 };

static int new_paths(unsigned mask, unsigned char taken[16][CODES], int take)
{
  int n = 0;
  for (int q = 0; q < 16; q++) {
    int code = gmds_path_of(mask, q / 4, q % 4).code;
    n += code && !taken[q][code];
    if (take && code)
      taken[q][code] = 1;
  }
  return n;
}

/* How well a mask serves to fill the list: few relations, but 3 -> 0 and 3 -> 3 without a traversal. */
static int fills(unsigned mask)
{
  if (gmds_path_of(mask, 3, 0).cost > GMDS_COST_LOCAL || gmds_path_of(mask, 3, 3).cost > GMDS_COST_LOCAL)
    return 0;
  return 32 - bits((int)mask);
}

void gmds_census_paths(unsigned masks[GMDS_PATH_MODELS])
{
  unsigned char taken[16][CODES] = {{0}};
  for (int m = 0; m < GMDS_PATH_MODELS; m++) {
    int most = 0;
    masks[m] = 0;
    for (int filling = 0; filling < 2 && !most; filling++)
      for (size_t k = 0; k < gmds_census_size(3); k++) {
        unsigned mask = gmds_census_mask(3, k);
        int known = 0, gain = filling ? fills(mask) : new_paths(mask, taken, 0);
        for (int q = 0; q < m; q++)
          known |= masks[q] == mask;
        if (gain > most && !known && gmds_census_of(mask, 3).identified) {
          most = gain;
          masks[m] = mask;
        }
      }
    (void)new_paths(masks[m], taken, 1);
  }
}

static int same_word(const char *word, size_t length, const char *name)
{
  for (size_t i = 0; i < length; i++)
    if (toupper((unsigned char)word[i]) != name[i])
      return 0;
  return name[length] == 0;
}

static unsigned word_bits(const char *word, size_t length)
{
  static const char *const cells[] = {"N", "E", "F", "R"};
  for (int i = 0; i < 4; i++)
    if (same_word(word, length, cells[i]))
      return 1u << i;
  if (same_word(word, length, "DIM2"))
    return GMDS_DIM2;
  if (same_word(word, length, "DIM3"))
    return GMDS_DIM3;
  for (int r = 0; r < 16; r++)
    if (same_word(word, length, relation_names[r]))
      return relation_bits[r] | relation_ends[r];
  return 0;
}

gmds_status gmds_mask_parse(const char *text, gmds_error *error, unsigned *mask)
{
  unsigned parsed = 0;
  const char *at = text;
  for (;;) {
    at += strspn(at, " \t");
    size_t length = strcspn(at, "| \t");
    unsigned word = word_bits(at, length);
    if (!word)
      return gmds_fail(error, GMDS_ERR_ARGUMENT,
                       "mask '%.80s': '%.*s' is no cell (N, E, F, R), no relation such as F2N, and not DIM2 or DIM3",
                       text, length > 40 ? 40 : (int)length, at);
    parsed |= word;
    at += length;
    at += strspn(at, " \t");
    if (!*at)
      break;
    if (*at != '|')
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "mask '%.80s': '|' is missing before '%.40s'", text, at);
    at++;
  }
  if (parsed & GMDS_DIM2 && parsed & GMDS_DIM3)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "mask '%.80s': a node has two coordinates (DIM2) or three (DIM3)", text);
  *mask = parsed;
  return GMDS_OK;
}

/* Appends to a text of limited size, always terminated. */
static void append(size_t size, char *text, const char *more)
{
  size_t used = strlen(text);
  if (used + 1 < size)
    snprintf(text + used, size - used, "%s", more);
}

void gmds_mask_text(unsigned mask, size_t size, char *text)
{
  static const char *const cells[] = {"N", "E", "F", "R"};
  text[0] = 0;
  const char *bar = "";
  if (mask & GMDS_DIM2 || mask & GMDS_DIM3) {
    append(size, text, mask & GMDS_DIM3 ? "DIM3" : "DIM2");
    bar = "|";
  }
  for (int i = 0; i < 4; i++)
    if (mask & GMDS_CELL_BIT(i)) {
      append(size, text, bar);
      append(size, text, cells[i]);
      bar = "|";
    }
  for (int r = 0; r < 16; r++)
    if (mask & relation_bits[r]) {
      append(size, text, bar);
      append(size, text, relation_names[r]);
      bar = "|";
    }
}

void gmds_path_advice(int i, int j, size_t size, char *text)
{
  snprintf(text, size, "add ");
  for (const row *r = rows_of[4 * i + j]; r->id; r++) {
    if (r->table >= 3 && r->hops > 2)
      continue; /* longer rows only repeat the shorter ones */
    if (r != rows_of[4 * i + j])
      append(size, text, ", or ");
    for (int s = 0; s < r->hops; s++) {
      if (s)
        append(size, text, " with ");
      append(size, text, relation_names[4 * r->cells[s] + r->cells[s + 1]]);
    }
  }
  append(size, text, " (the inverse of a relation will do, at the cost of a traversal)");
}

void gmds_matrices(unsigned mask, char direct[4][4], char indirect[4][4])
{
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {
      gmds_path path = gmds_path_of(mask, i, j);
      direct[i][j] = stored(mask, i, j) ? '1' : '0';
      indirect[i][j] = path.cost == GMDS_COST_DIRECT  ? 'x'
                       : path.cost == GMDS_COST_LOCAL ? (char)('0' + path.cells[1])
                                                      : '-';
    }
}
