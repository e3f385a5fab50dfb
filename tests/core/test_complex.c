/* Cell complexes: all relations against brute force on random cells that share nodes; the table of shapes; regions
 * found again from their faces; and soups that no volume can be made of. */
#include "harness.h"
#include <gmds/volume.h>

#define GMDS_PREFIX walled
#define GMDS_MODEL (N | R | R2N | R2R)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID)
#include <gmds/mesh.h>
#include <gmds/end.h>

enum { NODES = 11, MOST = 64 };

static gmds_memory memory;

/* ---- cells by hand */

typedef struct cycle {
  size_t n;
  gmds_id nodes[8];
} cycle;

typedef struct cells {
  size_t n[4];
  cycle nodes[4][MOST]; /* none: the cell is a hole */
  gmds_cell_type type[MOST];
  size_t n_walls[MOST];
  cycle walls[MOST][8];
  gmds_id faces[MOST][8]; /* of polyhedra */
} cells;

static cells all;

static int has(const cycle *c, gmds_id v)
{
  for (size_t k = 0; k < c->n; k++)
    if (c->nodes[k] == v)
      return 1;
  return 0;
}

static int same_set(const cycle *a, const cycle *b)
{
  for (size_t k = 0; k < a->n; k++)
    if (!has(b, a->nodes[k]))
      return 0;
  return a->n == b->n;
}

static int has_side(const cycle *c, gmds_id a, gmds_id b)
{
  for (size_t k = 0; k < c->n; k++) {
    const gmds_id p = c->nodes[k], q = c->nodes[(k + 1) % c->n];
    if ((p == a && q == b) || (p == b && q == a))
      return 1;
  }
  return 0;
}

static void random_nodes(cycle *c, size_t n, uint64_t *seed)
{
  for (c->n = 0; c->n < n;) {
    const gmds_id v = (gmds_id)random_below(seed, NODES);
    if (!has(c, v))
      c->nodes[c->n++] = v;
  }
}

/* The cell of dimension i with these nodes, or where it was put. */
static gmds_id find_or_put(int i, const cycle *c)
{
  for (size_t k = 0; k < all.n[i]; k++)
    if (all.nodes[i][k].n && same_set(&all.nodes[i][k], c))
      return (gmds_id)k;
  ck_assert_uint_lt(all.n[i], MOST);
  all.nodes[i][all.n[i]] = *c;
  return (gmds_id)all.n[i]++;
}

static void put_hole(int i)
{
  ck_assert_uint_lt(all.n[i], MOST);
  all.nodes[i][all.n[i]++].n = 0;
}

static void list_walls(gmds_cell_type type, const gmds_id *nodes, cycle *walls)
{
  const gmds_shape *s = gmds_shape_of(type);
  for (size_t k = 0; k < s->faces; k++)
    for (walls[k].n = 0; walls[k].n < s->sides[k]; walls[k].n++)
      walls[k].nodes[walls[k].n] = nodes[s->face[k][walls[k].n]];
}

/* A region of a shape, or the polyhedron that its faces make. */
static void put_region(gmds_cell_type type, int as_polyhedron, uint64_t *seed)
{
  const size_t r = all.n[3]++;
  const gmds_shape *s = gmds_shape_of(type);
  ck_assert_uint_lt(r, MOST);
  random_nodes(&all.nodes[3][r], s->nodes, seed);
  list_walls(type, all.nodes[3][r].nodes, all.walls[r]);
  all.type[r] = as_polyhedron ? GMDS_POLYHEDRON : type;
  all.n_walls[r] = s->faces;
  for (size_t k = 0; k < s->faces && as_polyhedron; k++) {
    all.faces[r][k] = find_or_put(2, &all.walls[r][k]);
    all.walls[r][k] = all.nodes[2][all.faces[r][k]]; /* around it as that face is */
  }
}

/* Some faces with the same nodes have other sides, so that polyhedra may not close: these are left out. */
static int closes(size_t r)
{
  for (size_t k = 0; k < all.n_walls[r]; k++)
    for (size_t q = 0; q < all.walls[r][k].n; q++) {
      const cycle *c = &all.walls[r][k];
      size_t times = 0;
      for (size_t w = 0; w < all.n_walls[r]; w++)
        times += (size_t)has_side(&all.walls[r][w], c->nodes[q], c->nodes[(q + 1) % c->n]);
      if (times != 2)
        return 0;
    }
  return 1;
}

static void make_cells(int tetrahedra, uint64_t *seed)
{
  memset(&all, 0, sizeof all);
  cycle c;
  for (int k = 0; k < 8; k++) {
    random_nodes(&c, 2, seed);
    (void)find_or_put(1, &c);
    random_nodes(&c, 3 + random_below(seed, 3), seed);
    (void)find_or_put(2, &c);
    if (k % 3 == 1) {
      put_hole(1);
      put_hole(2);
    }
  }
  for (int k = 0; k < 7; k++) {
    const gmds_cell_type type =
        tetrahedra ? GMDS_TETRAHEDRON : (gmds_cell_type)(GMDS_TETRAHEDRON + random_below(seed, 4));
    put_region(type, !tetrahedra && random_below(seed, 3) == 0, seed);
    if (!closes(all.n[3] - 1))
      all.n[3]--;
    if (k == 3)
      put_hole(3);
    if (k % 2 && all.n[3] && all.n_walls[all.n[3] - 1]) /* a face that a region has, turned */
      for (size_t q = 0, n = (c = all.walls[all.n[3] - 1][0]).n; q < n && q == 0; q++) {
        const gmds_id first = c.nodes[0];
        c.nodes[0] = c.nodes[n - 2];
        c.nodes[n - 2] = first;
        if (n == 3)
          (void)find_or_put(2, &c);
      }
  }
}

static void fill_csr(gmds_csr *csr, int i)
{
  ck_assert_int_eq(gmds_csr_begin(csr, all.n[i]), GMDS_OK);
  for (size_t c = 0; c < all.n[i]; c++)
    csr->begin[c + 1] = all.nodes[i][c].n;
  ck_assert_int_eq(gmds_csr_finish(csr), GMDS_OK);
  for (size_t c = 0; c < all.n[i]; c++)
    memcpy(csr->data + csr->begin[c], all.nodes[i][c].nodes, all.nodes[i][c].n * sizeof *csr->data);
}

static void begin_complex(gmds_complex *c)
{
  void *types = NULL;
  gmds_complex_init(c, &memory, NODES);
  for (int i = 1; i < 4; i++)
    fill_csr(&c->nodes[i], i);
  ck_assert(gmds_resize(&memory, &types, 0, all.n[3], 1));
  c->types = types;
  c->types_capacity = all.n[3];
  ck_assert_int_eq(gmds_csr_begin(&c->walls, all.n[3]), GMDS_OK);
  for (size_t r = 0; r < all.n[3]; r++) {
    c->types[r] = (uint8_t)(all.nodes[3][r].n ? all.type[r] : GMDS_TETRAHEDRON);
    c->walls.begin[r + 1] = all.nodes[3][r].n && all.type[r] == GMDS_POLYHEDRON ? all.n_walls[r] : 0;
  }
  ck_assert_int_eq(gmds_csr_finish(&c->walls), GMDS_OK);
  for (size_t r = 0; r < all.n[3]; r++)
    if (c->walls.begin[r + 1] > c->walls.begin[r])
      memcpy(c->walls.data + c->walls.begin[r], all.faces[r], all.n_walls[r] * sizeof *c->walls.data);
}

/* ---- relations by their definition */

static int region_has_side(size_t r, gmds_id a, gmds_id b)
{
  for (size_t k = 0; k < all.n_walls[r]; k++)
    if (has_side(&all.walls[r][k], a, b))
      return 1;
  return 0;
}

static int region_has_wall(size_t r, const cycle *w)
{
  for (size_t k = 0; k < all.n_walls[r]; k++)
    if (same_set(&all.walls[r][k], w))
      return 1;
  return 0;
}

static int is_joined(gmds_id a, gmds_id b, int edges, int faces)
{
  for (int i = 1; i < 4; i++)
    for (size_t c = 0; c < all.n[i]; c++)
      if (all.nodes[i][c].n && ((i == 1 && edges) || (i == 2 && faces) || i == 3) &&
          (i == 3 ? region_has_side(c, a, b) : has_side(&all.nodes[i][c], a, b)))
        return 1;
  return 0;
}

static int exists(int i, size_t c)
{
  return i == 0 || all.nodes[i][c].n > 0;
}

/* Whether cells of dimensions i <= j are incident, or adjacent. */
static int related(int i, size_t a, int j, size_t b)
{
  const cycle *x = &all.nodes[i][a], *y = &all.nodes[j][b];
  if (i == j && a == b)
    return 0;
  if (i == 0)
    return j == 0 ? is_joined((gmds_id)a, (gmds_id)b, 1, 1) : has(y, (gmds_id)a);
  if (i == 1 && j > 1)
    return j == 2 ? has_side(y, x->nodes[0], x->nodes[1]) : region_has_side(b, x->nodes[0], x->nodes[1]);
  if (i == 2 && j == 3)
    return region_has_wall(b, x);
  for (size_t k = 0; k < x->n && i < 3; k++)
    if (i == 1 ? has(y, x->nodes[k]) : has_side(y, x->nodes[k], x->nodes[(k + 1) % x->n]))
      return 1;
  for (size_t k = 0; i == 3 && k < all.n_walls[a]; k++)
    if (region_has_wall(b, &all.walls[a][k]))
      return 1;
  return 0;
}

static size_t number(int i)
{
  return i ? all.n[i] : NODES;
}

static void compare_sets(const gmds_csr *csr, int i, int j)
{
  ck_assert_uint_eq(csr->n, number(i));
  for (size_t a = 0; a < number(i); a++) {
    const size_t n = csr->begin[a + 1] - csr->begin[a];
    const gmds_id *row = n ? csr->data + csr->begin[a] : NULL;
    size_t expected = 0;
    for (size_t b = 0; b < number(j); b++) {
      size_t times = 0;
      const int is = exists(i, a) && exists(j, b) && (i <= j ? related(i, a, j, b) : related(j, b, i, a));
      for (size_t k = 0; k < n; k++)
        times += row[k] == b;
      if (times != (size_t)is)
        ck_abort_msg("%d->%d of %zu names %zu %zu times", i, j, a, b, times);
      expected += (size_t)is;
    }
    ck_assert_uint_eq(n, expected);
  }
}

START_TEST(relations_are_those_of_the_definition)
{
  uint64_t seed = 31;
  size_t regions[4 + 1] = {0};
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 300; round++) {
    gmds_complex c;
    gmds_error error = {.status = GMDS_OK};
    make_cells(round % 4 == 0, &seed);
    begin_complex(&c);
    ck_assert_msg(gmds_complex_join(&c, &error) == GMDS_OK, "%s", error.text);
    for (int q = 0; q < 16; q++) {
      gmds_csr csr;
      gmds_csr_init(&csr, &memory);
      ck_assert_int_eq(gmds_complex_relation(&c, q / 4, q % 4, 0, &csr, NULL), GMDS_OK);
      compare_sets(&csr, q / 4, q % 4);
      gmds_csr_clear(&csr);
    }
    for (int how = 0; how < 4; how++) { /* nodes joined by some cells alone */
      gmds_csr csr;
      gmds_csr_init(&csr, &memory);
      ck_assert_int_eq(gmds_complex_joined(&c, how & 1, how >> 1, &csr), GMDS_OK);
      for (gmds_id a = 0; a < NODES; a++)
        for (gmds_id b = 0; b < NODES; b++) {
          int is = 0;
          for (size_t k = csr.begin[a]; k < csr.begin[a + 1]; k++)
            is += csr.data[k] == b;
          ck_assert_int_eq(is, a != b && is_joined(a, b, how & 1, how >> 1));
        }
      gmds_csr_clear(&csr);
    }
    for (size_t r = 0; r < all.n[3]; r++)
      regions[all.type[r] < GMDS_TETRAHEDRON ? 0 : all.type[r] - GMDS_TETRAHEDRON] += all.nodes[3][r].n > 0;
    gmds_complex_clear(&c);
    ck_assert_uint_eq(memory.live, 0);
  }
  for (int k = 0; k < 5; k++)
    ck_assert_uint_gt(regions[k], 20);
}
END_TEST

/* The edge with these ends, the face with these nodes: GMDS_NONE where there is none. */
static gmds_id cell_of(int i, const cycle *c)
{
  for (size_t k = 0; k < all.n[i]; k++)
    if (all.nodes[i][k].n && same_set(&all.nodes[i][k], c))
      return (gmds_id)k;
  return GMDS_NONE;
}

static void compare_aligned(const gmds_csr *csr, int i, int j)
{
  for (size_t x = 0; x < all.n[i]; x++) {
    const gmds_id *row = csr->data + csr->begin[x];
    const size_t n = csr->begin[x + 1] - csr->begin[x];
    const cycle *c = &all.nodes[i][x];
    if (i == 2) {
      ck_assert_uint_eq(n, c->n);
      for (size_t k = 0; k < n; k++)
        ck_assert_uint_eq(row[k], cell_of(1, &(cycle){2, {c->nodes[k], c->nodes[(k + 1) % n]}}));
      continue;
    }
    const gmds_shape *s = c->n ? gmds_shape_of(all.type[x]) : NULL;
    if (!c->n || (!s && j == 1)) /* edges of a polyhedron have no order of their own */
      continue;
    ck_assert_uint_eq(n, j == 1 ? s->edges : all.n_walls[x]);
    for (size_t k = 0; k < n; k++)
      ck_assert_uint_eq(row[k], j == 1 ? cell_of(1, &(cycle){2, {c->nodes[s->edge[k][0]], c->nodes[s->edge[k][1]]}})
                                       : cell_of(2, &all.walls[x][k]));
  }
}

/* Whether a region has a face that two others have too. */
static int is_crowded(size_t r)
{
  for (size_t k = 0; k < all.n_walls[r]; k++) {
    size_t on = 0;
    for (size_t s = 0; s < all.n[3]; s++)
      on += all.nodes[3][s].n && region_has_wall(s, &all.walls[r][k]);
    if (on > 2)
      return 1;
  }
  return 0;
}

/* What lies beyond each face; 0 where more than two regions share one. */
static int compare_beyond(const gmds_csr *csr, gmds_status status, size_t where, int coded)
{
  for (size_t r = 0; r < all.n[3]; r++)
    for (size_t k = 0; all.nodes[3][r].n && k < all.n_walls[r]; k++) {
      gmds_id beyond = GMDS_NONE;
      size_t others = 0;
      for (size_t s = 0; s < all.n[3]; s++)
        for (size_t q = 0; all.nodes[3][s].n && s != r && q < all.n_walls[s]; q++)
          if (same_set(&all.walls[r][k], &all.walls[s][q])) {
            beyond = coded ? (gmds_id)(4 * s + q) : (gmds_id)s;
            others++;
          }
      if (others > 1) {
        ck_assert_int_eq(status, GMDS_ERR_CONFLICT);
        ck_assert(is_crowded(where));
        return 0;
      }
      if (status == GMDS_OK)
        ck_assert_uint_eq(csr->data[csr->begin[r] + k], beyond);
    }
  ck_assert_int_eq(status, GMDS_OK);
  return 1;
}

START_TEST(aligned_relations_have_an_entry_a_side_or_face)
{
  uint64_t seed = 32;
  size_t beyond = 0, conflicts = 0;
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 200; round++) {
    static const int pairs[][2] = {{2, 1}, {3, 1}, {3, 2}};
    gmds_complex c;
    gmds_csr csr;
    size_t where = 0;
    const int tetrahedra = round % 2;
    make_cells(tetrahedra, &seed);
    begin_complex(&c);
    ck_assert_int_eq(gmds_complex_join(&c, NULL), GMDS_OK);
    for (size_t q = 0; q < 3; q++) {
      gmds_csr_init(&csr, &memory);
      ck_assert_int_eq(gmds_complex_relation(&c, pairs[q][0], pairs[q][1], 1, &csr, NULL), GMDS_OK);
      compare_aligned(&csr, pairs[q][0], pairs[q][1]);
      gmds_csr_clear(&csr);
    }
    for (int coded = 0; coded <= tetrahedra; coded++) {
      gmds_csr_init(&csr, &memory);
      gmds_status status = gmds_complex_relation(&c, 3, 3, 1 + coded, &csr, &where);
      if (compare_beyond(&csr, status, where, coded))
        beyond++;
      else
        conflicts++;
      gmds_csr_clear(&csr);
    }
    gmds_complex_clear(&c);
    ck_assert_uint_eq(memory.live, 0);
  }
  ck_assert_uint_gt(beyond, 20);
  ck_assert_uint_gt(conflicts, 5);
}
END_TEST

START_TEST(what_is_made_is_what_was_missing)
{
  uint64_t seed = 33;
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 100; round++) {
    gmds_complex c;
    make_cells(0, &seed);
    begin_complex(&c);
    ck_assert_int_eq(gmds_complex_join(&c, NULL), GMDS_OK);
    ck_assert_int_eq(gmds_complex_make(&c, round & 1, round >> 1 & 1, NULL), GMDS_OK);
    const size_t edges = all.n[1], faces = all.n[2];
    if (round >> 1 & 1)
      for (size_t r = 0; r < all.n[3]; r++)
        for (size_t k = 0; all.nodes[3][r].n && k < all.n_walls[r]; k++)
          (void)find_or_put(2, &all.walls[r][k]);
    for (int i = 2; i < 4 && round & 1; i++)
      for (size_t x = 0; x < (i == 2 ? all.n[2] : all.n[3]); x++)
        for (size_t k = 0; k < (i == 2 ? 1 : all.nodes[3][x].n ? all.n_walls[x] : 0); k++) {
          const cycle *w = i == 2 ? &all.nodes[2][x] : &all.walls[x][k];
          for (size_t q = 0; q < w->n; q++)
            (void)find_or_put(1, &(cycle){2, {w->nodes[q], w->nodes[(q + 1) % w->n]}});
        }
    for (int i = 1; i < 3; i++) {
      ck_assert_uint_eq(c.nodes[i].n, all.n[i]);
      for (size_t x = i == 1 ? edges : faces; x < c.nodes[i].n; x++) {
        cycle made = {c.nodes[i].begin[x + 1] - c.nodes[i].begin[x], {0}};
        memcpy(made.nodes, c.nodes[i].data + c.nodes[i].begin[x], made.n * sizeof *made.nodes);
        ck_assert_uint_lt(cell_of(i, &made), all.n[i]); /* one of those that were missing, */
        ck_assert_uint_ge(cell_of(i, &made), i == 1 ? edges : faces);
      }
    }
    gmds_csr csr;
    gmds_csr_init(&csr, &memory); /* and none is missing any more */
    ck_assert_int_eq(gmds_complex_relation(&c, 3, 2, 1, &csr, NULL), GMDS_OK);
    for (size_t k = 0; k < csr.begin[csr.n] && round >> 1 & 1; k++)
      ck_assert_uint_ne(csr.data[k], GMDS_NONE);
    gmds_csr_clear(&csr);
    gmds_complex_clear(&c);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

/* ---- shapes */

static const gmds_cell_type types[4] = {GMDS_TETRAHEDRON, GMDS_PYRAMID, GMDS_PRISM, GMDS_HEXAHEDRON};

/* A convex cell of each type in positive order. */
static const double unit[4][8][3] = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

static double determinant(const double *o, const double *a, const double *b, const double *c)
{
  double x[3][3];
  for (int d = 0; d < 3; d++) {
    x[0][d] = a[d] - o[d];
    x[1][d] = b[d] - o[d];
    x[2][d] = c[d] - o[d];
  }
  return x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) + x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
         x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
}

START_TEST(shapes_are_closed_and_face_outwards)
{
  for (size_t t = 0; t < 4; t++) {
    const gmds_shape *s = gmds_shape_of(types[t]);
    int on[12] = {0}, forwards[12] = {0};
    ck_assert_int_eq(s->nodes, gmds_cell_type_points(types[t]));
    ck_assert_int_eq(s->nodes - s->edges + s->faces, 2);
    for (size_t k = 0; k < s->faces; k++) {
      for (size_t i = 0; i < s->sides[k]; i++) {
        const uint8_t a = s->face[k][i], b = s->face[k][(i + 1u) % s->sides[k]], *ends = s->edge[s->border[k][i]];
        ck_assert((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a));
        on[s->border[k][i]]++;
        forwards[s->border[k][i]] += ends[0] == a;
      }
      for (size_t v = 0; v < s->nodes; v++) /* no node is outside of a face, and some are inside */
        ck_assert_double_le(
            determinant(unit[t][s->face[k][0]], unit[t][s->face[k][1]], unit[t][s->face[k][2]], unit[t][v]), 0);
    }
    for (size_t e = 0; e < s->edges; e++)
      ck_assert(on[e] == 2 && forwards[e] == 1); /* once each way */
  }
  ck_assert_ptr_null(gmds_shape_of(GMDS_POLYHEDRON));
  ck_assert_ptr_null(gmds_shape_of(GMDS_QUADRILATERAL));
}
END_TEST

typedef struct face_list {
  size_t begin[7];
  gmds_id corners[24];
} face_list;

static void put_face(face_list *l, size_t k, const cycle *c)
{
  l->begin[k + 1] = l->begin[k] + c->n;
  memcpy(l->corners + l->begin[k], c->nodes, c->n * sizeof *c->nodes);
}

/* Whether nodes in the order of a type have just these faces, and these sides around them. */
static int has_these_faces(gmds_cell_type type, const gmds_id *nodes, const face_list *l)
{
  const gmds_shape *s = gmds_shape_of(type);
  cycle walls[6];
  int given_already[6] = {0};
  list_walls(type, nodes, walls);
  for (size_t k = 0; k < s->nodes; k++)
    for (size_t q = 0; q < k; q++)
      if (nodes[q] == nodes[k])
        return 0;
  for (size_t k = 0; k < s->faces; k++) {
    cycle given = {l->begin[k + 1] - l->begin[k], {0}};
    memcpy(given.nodes, l->corners + l->begin[k], given.n * sizeof *given.nodes);
    size_t w = 0;
    while (w < s->faces && !same_set(&walls[w], &given))
      w++;
    if (w == s->faces || given_already[w]++)
      return 0;
    for (size_t i = 0; i < given.n; i++)
      if (!has_side(&walls[w], given.nodes[i], given.nodes[(i + 1) % given.n]))
        return 0;
  }
  return 1;
}

static int next_permutation(size_t *p, size_t n)
{
  size_t k = n - 1, q = n - 1;
  while (k > 0 && p[k - 1] >= p[k])
    k--;
  if (!k)
    return 0;
  while (p[q] <= p[k - 1])
    q--;
  size_t swap = p[q];
  p[q] = p[k - 1];
  p[k - 1] = swap;
  for (q = n - 1; k < q; k++, q--) {
    swap = p[q];
    p[q] = p[k];
    p[k] = swap;
  }
  return 1;
}

/* Every order of the faces; each face begins anywhere and turns either way. */
START_TEST(a_shape_is_found_from_its_faces_in_any_order)
{
  uint64_t seed = 34;
  size_t ways = 0;
  for (size_t t = 0; t < 4; t++) {
    const gmds_shape *s = gmds_shape_of(types[t]);
    const size_t base = types[t] == GMDS_PYRAMID || types[t] == GMDS_HEXAHEDRON ? 4 : 3;
    const gmds_id nodes[8] = {17, 3, 5, 40, 2, 11, 8, 90};
    size_t order[6] = {0, 1, 2, 3, 4, 5};
    cycle walls[6];
    list_walls(types[t], nodes, walls);
    do
      for (int turn = 0; turn < 24; turn++) {
        face_list l = {{0}, {0}};
        int first_outwards = -1;
        for (size_t k = 0; k < s->faces; k++) {
          const cycle *w = &walls[order[k]];
          const size_t shift = random_below(&seed, w->n), back = random_below(&seed, 2);
          cycle turned = {w->n, {0}};
          for (size_t i = 0; i < w->n; i++)
            turned.nodes[i] = w->nodes[(back ? shift + w->n - i : shift + i) % w->n];
          put_face(&l, k, &turned);
          if (first_outwards < 0 && w->n == base)
            first_outwards = !back;
        }
        gmds_id found[GMDS_SHAPE_NODES];
        double corner[8][3];
        ck_assert_int_eq(gmds_shape_from_faces(types[t], l.begin, l.corners, found), GMDS_OK);
        ck_assert(has_these_faces(types[t], found, &l));
        for (size_t v = 0; v < s->nodes; v++)
          for (size_t q = 0; q < s->nodes; q++)
            if (nodes[q] == found[v])
              memcpy(corner[v], unit[t][q], sizeof corner[v]);
        const double volume = determinant(corner[0], corner[1], corner[2], corner[s->nodes - 1]);
        ck_assert((volume > 0) == first_outwards); /* turned as its first face is given */
        ways++;
      }
    while (next_permutation(order, s->faces));
  }
  printf("%zu ways to list faces\n", ways);
}
END_TEST

/* Whether any order of the nodes that occur has these faces. */
static int is_possible(gmds_cell_type type, const face_list *l)
{
  const gmds_shape *s = gmds_shape_of(type);
  gmds_id nodes[24], ordered[8];
  size_t n = 0, order[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  for (size_t k = 0; k < l->begin[s->faces]; k++) {
    size_t q = 0;
    while (q < n && nodes[q] != l->corners[k])
      q++;
    if (q == n)
      nodes[n++] = l->corners[k];
  }
  if (n != s->nodes)
    return 0;
  do {
    for (size_t k = 0; k < n; k++)
      ordered[k] = nodes[order[k]];
    if (has_these_faces(type, ordered, l))
      return 1;
  } while (next_permutation(order, n));
  return 0;
}

START_TEST(what_are_no_faces_of_a_shape_is_refused)
{
  uint64_t seed = 35;
  size_t refused = 0, accepted = 0;
  for (size_t t = 0; t < 4; t++) /* faces of other numbers of sides, of none, one or two too */
    for (size_t sides = 0; sides < 7; sides++) {
      const gmds_shape *s = gmds_shape_of(types[t]);
      const gmds_id nodes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
      gmds_id around[6 * 8], found[GMDS_SHAPE_NODES];
      size_t begin[7] = {0};
      for (size_t k = 0; k < s->faces; k++) {
        begin[k + 1] = begin[k] + (k ? s->sides[k] : sides);
        for (size_t i = 0; i < begin[k + 1] - begin[k]; i++)
          around[begin[k] + i] = i < s->sides[k] ? nodes[s->face[k][i]] : 10 + (gmds_id)i;
      }
      ck_assert_int_eq(gmds_shape_from_faces(types[t], begin, around, found),
                       sides == s->sides[0] ? GMDS_OK : GMDS_ERR_INVARIANT);
    }
  for (int round = 0; round < 400; round++) {
    const size_t t = (size_t)round % 4;
    const gmds_shape *s = gmds_shape_of(types[t]);
    const gmds_id nodes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    cycle walls[6];
    face_list l = {{0}, {0}};
    list_walls(types[t], nodes, walls);
    for (size_t q = 0; q < 1 + random_below(&seed, 3); q++) {
      cycle *w = &walls[random_below(&seed, s->faces)];
      gmds_id *a = &w->nodes[random_below(&seed, w->n)], *b = &w->nodes[random_below(&seed, w->n)], was = *a;
      const gmds_id other = (gmds_id)random_below(&seed, s->nodes);
      if (random_below(&seed, 3) == 0 || has(w, other)) { /* two exchanged: other sides */
        *a = *b;
        *b = was;
      } else
        *a = other;
    }
    for (size_t k = 0; k < s->faces; k++)
      put_face(&l, k, &walls[k]);
    gmds_id found[GMDS_SHAPE_NODES];
    const gmds_status status = gmds_shape_from_faces(types[t], l.begin, l.corners, found);
    const int possible = is_possible(types[t], &l);
    if (status == GMDS_OK ? !has_these_faces(types[t], found, &l) : possible)
      ck_abort_msg("round %d, a %s: '%s', though it %s", round, gmds_cell_type_text(types[t]), gmds_status_text(status),
                   possible ? "is one" : "is none");
    *(status == GMDS_OK ? &accepted : &refused) += 1;
  }
  ck_assert_uint_gt(refused, 100);
  ck_assert_uint_gt(accepted, 20);
  gmds_id found[GMDS_SHAPE_NODES];
  const size_t begin[] = {0, 3, 6, 9, 12};
  const gmds_id corners[12] = {0, 1, 2, 0, 1, 3, 1, 2, 3, 0, 2, 3};
  ck_assert_int_eq(gmds_shape_from_faces(GMDS_POLYHEDRON, begin, corners, found), GMDS_ERR_INVARIANT);
}
END_TEST

/* ---- complexes and soups that cannot be joined */

static void begin_soup(gmds_soup *soup, size_t n)
{
  gmds_soup_init(soup, &memory, 3);
  for (size_t v = 0; v < n; v++) {
    const double x[3] = {(double)v, (double)(v * v), (double)(v * v * v)};
    ck_assert_int_eq(gmds_soup_add_point(soup, x), GMDS_OK);
  }
}

/* The soup is refused with a status and a sentence in which `word` stands, and the volume stays empty. */
static void is_refused(const gmds_soup *soup, gmds_status expected, const char *word)
{
  gmds_volume volume;
  gmds_error error = {.status = GMDS_OK};
  const size_t before = memory.live;
  gmds_volume_init(&volume, &memory);
  const gmds_status status = gmds_volume_from_soup(&volume, soup, &error);
  if (status != expected || error.status != expected || !strstr(error.text, word))
    ck_abort_msg("'%s', '%s', not '%s' with %s", gmds_status_text(status), error.text, gmds_status_text(expected),
                 word);
  ck_assert(!volume.cells[0].end && !volume.points);
  ck_assert_uint_eq(memory.live, before);
  gmds_volume_clear(&volume);
}

static const gmds_id tetrahedron[] = {0, 1, 2, 3};

START_TEST(a_soup_with_a_wrong_cell_is_refused)
{
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  begin_soup(&soup, 8);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, tetrahedron), GMDS_OK);
  const gmds_id twice[] = {4, 5, 4, 6};
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, twice), GMDS_OK);
  is_refused(&soup, GMDS_ERR_ARGUMENT, "cell 1 (tetrahedron) has point 4 twice");
  soup.corners[6] = 8; /* behind the back of gmds_soup_add_cell */
  is_refused(&soup, GMDS_ERR_CELL, "cell 1 (tetrahedron) has point 8");
  soup.corners[6] = 7;
  soup.types[1] = GMDS_PYRAMID;
  is_refused(&soup, GMDS_ERR_ARGUMENT, "cell 1 (pyramid) has 4 points");
  soup.types[1] = GMDS_SEGMENT;
  is_refused(&soup, GMDS_ERR_ARGUMENT, "cell 1 (edge) has 4 points");
  soup.types[1] = GMDS_POLYHEDRON;
  is_refused(&soup, GMDS_ERR_ARGUMENT, "cell 1 (polyhedron): the counts");
  soup.types[1] = GMDS_CELL_TYPE_COUNT;
  is_refused(&soup, GMDS_ERR_ARGUMENT, "cell 1 has the type");
  gmds_soup_clear(&soup);
  begin_soup(&soup, 2);
  const gmds_id vertex = 1;
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_VERTEX, 1, &vertex), GMDS_OK);
  soup.corners[0] = 1000000;
  is_refused(&soup, GMDS_ERR_CELL, "cell 0 (vertex) has point 1000000");
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(a_polyhedron_that_does_not_close_is_refused)
{
  static const gmds_id open[] = {4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 4};
  static const gmds_id face_twice[] = {5, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3, 3, 2, 1, 0};
  static const gmds_id pillows[] = {4, 3, 0, 1, 2, 3, 2, 1, 0, 3, 4, 5, 6, 3, 4, 5, 6};
  static const gmds_id point_twice[] = {4, 3, 0, 1, 2, 3, 0, 1, 0, 3, 1, 2, 3, 3, 0, 2, 3};
  static const gmds_id closed[] = {4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3};
  static const struct {
    size_t n;
    const gmds_id *stream;
    const char *word;
  } cases[] = {{sizeof open / sizeof *open, open, "region 1, a polyhedron, do not close"},
               {sizeof face_twice / sizeof *face_twice, face_twice, "region 1, a polyhedron, do not close"},
               {sizeof pillows / sizeof *pillows, pillows, "region 1, a polyhedron, do not close"},
               {sizeof point_twice / sizeof *point_twice, point_twice, "cell 1 (polyhedron) has point 0 twice"},
               {sizeof closed / sizeof *closed, closed, NULL}};
  gmds_memory_init(&memory, NULL);
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    gmds_soup soup;
    begin_soup(&soup, 8);
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, tetrahedron), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_POLYHEDRON, cases[k].n, cases[k].stream), GMDS_OK);
    if (cases[k].word)
      is_refused(&soup, GMDS_ERR_ARGUMENT, cases[k].word);
    else {
      gmds_volume volume;
      gmds_volume_init(&volume, &memory);
      ck_assert_int_eq(gmds_volume_from_soup(&volume, &soup, NULL), GMDS_OK);
      ck_assert_uint_eq(volume.complex.nodes[2].n, 4);
      gmds_volume_clear(&volume);
    }
    gmds_soup_clear(&soup);
  }
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(edges_and_faces_that_are_listed_twice_are_one)
{
  static const gmds_id first[] = {0, 1, 2, 3}, turned[] = {2, 1, 0, 3}, bent[] = {0, 2, 1, 3}, back[] = {1, 0};
  gmds_soup soup, out;
  gmds_volume volume;
  gmds_memory_init(&memory, NULL);
  begin_soup(&soup, 5);
  gmds_attribute *a = NULL;
  ck_assert_int_eq(gmds_soup_add_attribute(&soup, GMDS_OF_CELLS, "tag", GMDS_INT, 1, &a), GMDS_OK);
  for (int again = 0; again < 2; again++) {
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_SEGMENT, 2, again ? back : first), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, again ? turned : first), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, again ? turned : first), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, first), GMDS_OK); /* regions are not */
  }
  gmds_volume_init(&volume, &memory);
  gmds_soup_init(&out, &memory, 3);
  ck_assert_int_eq(gmds_volume_from_soup(&volume, &soup, NULL), GMDS_OK);
  ck_assert_uint_eq(volume.cells[1].count, 1);
  ck_assert_uint_eq(volume.cells[2].count, 2);
  ck_assert_uint_eq(volume.cells[3].count, 2);
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, NULL), GMDS_OK);
  ck_assert_uint_eq(out.n_cells, soup.n_cells); /* each comes back as often as it was listed */
  ck_assert_ptr_nonnull(gmds_soup_find_attribute(&out, GMDS_OF_CELLS, "tag"));
  gmds_soup_clear(&out);
  gmds_volume_clear(&volume);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, bent), GMDS_OK); /* crosses itself */
  is_refused(&soup, GMDS_ERR_CONFLICT, "a face is listed twice in different orders: points 0 2 1 3");
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(an_edge_has_two_nodes)
{
  static const gmds_id nodes[] = {0, 1, 2};
  for (size_t n = 1; n < 4; n++) {
    gmds_complex c;
    gmds_error error = {.status = GMDS_OK};
    gmds_memory_init(&memory, NULL);
    gmds_complex_init(&c, &memory, 3);
    ck_assert_int_eq(gmds_csr_begin(&c.nodes[1], 1), GMDS_OK);
    c.nodes[1].begin[1] = n;
    ck_assert_int_eq(gmds_csr_finish(&c.nodes[1]), GMDS_OK);
    memcpy(c.nodes[1].data, nodes, n * sizeof *nodes);
    for (int i = 2; i < 4; i++) {
      ck_assert_int_eq(gmds_csr_begin(&c.nodes[i], 0), GMDS_OK);
      ck_assert_int_eq(gmds_csr_finish(&c.nodes[i]), GMDS_OK);
    }
    ck_assert_int_eq(gmds_complex_join(&c, &error), n == 2 ? GMDS_OK : GMDS_ERR_ARGUMENT);
    ck_assert(n == 2 || strstr(error.text, "an edge has two"));
    gmds_complex_clear(&c);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

START_TEST(a_volume_that_is_wrong_is_not_written)
{
  gmds_soup soup, out;
  gmds_volume volume;
  gmds_error error = {.status = GMDS_OK};
  gmds_attribute *a = NULL;
  gmds_memory_init(&memory, NULL);
  begin_soup(&soup, 4);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, tetrahedron), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, tetrahedron), GMDS_OK);
  gmds_soup_init(&out, &memory, 3);
  gmds_volume_init(&volume, &memory);
  ck_assert_int_eq(gmds_volume_from_soup(&volume, &soup, NULL), GMDS_OK);
  gmds_complex_part(&volume.complex);
  volume.complex.nodes[3].data[2] = 4;
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, &error), GMDS_ERR_CELL);
  ck_assert_msg(strstr(error.text, "region 0 has node 4") != NULL, "%s", error.text);
  volume.complex.nodes[3].data[2] = 2;
  volume.complex.types[0] = GMDS_PRISM;
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, &error), GMDS_ERR_ARGUMENT);
  ck_assert_msg(strstr(error.text, "region 0 has 4 nodes") != NULL, "%s", error.text);
  volume.complex.types[0] = GMDS_TETRAHEDRON;
  volume.complex.nodes[2].begin[1] = 2;
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, &error), GMDS_ERR_ARGUMENT);
  ck_assert_msg(strstr(error.text, "face 0 has 2 nodes, which is too few") != NULL, "%s", error.text);
  volume.complex.nodes[2].begin[1] = 3;
  ck_assert_int_eq(gmds_attribute_add(&volume.cells[2], "heat", GMDS_INT, 1, &a), GMDS_OK);
  ck_assert_int_eq(gmds_attribute_add(&volume.cells[3], "heat", GMDS_DOUBLE, 1, &a), GMDS_OK);
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, &error), GMDS_ERR_CONFLICT);
  ck_assert_msg(strstr(error.text, "'heat'") != NULL, "%s", error.text);
  ck_assert(!out.n_points && !out.n_cells && !out.attributes[GMDS_OF_CELLS]);
  gmds_volume_clear(&volume);
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

/* A prism over a polygon of n sides as a polyhedron: two faces of n nodes and n of four. */
static gmds_id *make_drum(size_t n, size_t *entries)
{
  gmds_id *stream = malloc((3 + 7 * n) * sizeof *stream), *at = stream;
  *at++ = (gmds_id)(n + 2);
  for (size_t base = 0; base < 2; base++) {
    *at++ = (gmds_id)n;
    for (size_t k = 0; k < n; k++)
      *at++ = (gmds_id)(base ? n + k : n - 1 - k);
  }
  for (size_t k = 0; k < n; k++) {
    const size_t next = k + 1 < n ? k + 1 : 0;
    const gmds_id wall[5] = {4, (gmds_id)k, (gmds_id)next, (gmds_id)(n + next), (gmds_id)(n + k)};
    memcpy(at, wall, sizeof wall);
    at += 5;
  }
  *entries = (size_t)(at - stream);
  return stream;
}

/* Its faces and edges are many: what compares each with each does not come back. */
START_TEST(a_polyhedron_of_many_faces_goes_through_a_volume)
{
  enum { SIDES = 200000 };
  static const int from[] = {2, 3, 3, 3, 1}, to[] = {1, 1, 2, 3, 3};
  static const size_t expected[] = {6 * SIDES, 3 * SIDES, SIDES + 2, 0, 3 * SIDES};
  gmds_soup soup, out;
  gmds_volume volume;
  size_t entries = 0;
  gmds_id *stream = make_drum(SIDES, &entries), *face = malloc(SIDES * sizeof *face);
  for (size_t k = 0; k < SIDES; k++)
    face[k] = (gmds_id)(SIDES - 1 - (k + SIDES / 2) % SIDES);
  gmds_memory_init(&memory, NULL);
  begin_soup(&soup, 2 * SIDES);
  for (int k = 0; k < 2; k++) /* one of its faces twice, and begun elsewhere */
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_POLYGON, SIDES, k ? face : stream + 2), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_POLYHEDRON, entries, stream), GMDS_OK);
  gmds_volume_init(&volume, &memory);
  gmds_soup_init(&out, &memory, 3);
  ck_assert_int_eq(gmds_volume_from_soup(&volume, &soup, NULL), GMDS_OK);
  ck_assert_uint_eq(volume.complex.nodes[2].n, SIDES + 2);
  ck_assert_int_eq(gmds_volume_to_soup(&volume, &out, NULL), GMDS_OK);
  ck_assert_uint_eq(out.n_cells, 3);
  ck_assert_mem_eq(out.corners, soup.corners, soup.begin[3] * sizeof *soup.corners);
  ck_assert_int_eq(gmds_complex_make(&volume.complex, 1, 1, NULL), GMDS_OK);
  ck_assert_uint_eq(volume.complex.nodes[1].n, 3 * SIDES);
  for (size_t k = 0; k < sizeof from / sizeof *from; k++) {
    gmds_csr csr;
    gmds_csr_init(&csr, &memory);
    ck_assert_int_eq(gmds_complex_relation(&volume.complex, from[k], to[k], 0, &csr, NULL), GMDS_OK);
    ck_assert_uint_eq(csr.begin[csr.n], expected[k]);
    gmds_csr_clear(&csr);
  }
  gmds_volume_clear(&volume);
  gmds_soup_clear(&soup);
  gmds_soup_clear(&out);
  free(stream);
  free(face);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

/* What has failed has changed nothing: the lists, and what was found of them, are those from before. */
START_TEST(a_complex_that_cannot_be_made_longer_stays)
{
  uint64_t seed = 34;
  size_t failures = 0;
  for (int round = 0; round < 40; round++) {
    failing f = {.until = 1000000};
    const gmds_allocator allocator = failing_allocator(&f);
    gmds_complex c;
    gmds_csr before, after;
    gmds_error error = {.status = GMDS_OK};
    gmds_status status = GMDS_ERR_MEMORY;
    gmds_memory_init(&memory, &allocator);
    make_cells(0, &seed);
    begin_complex(&c);
    gmds_csr_init(&before, &memory);
    gmds_csr_init(&after, &memory);
    ck_assert_int_eq(gmds_complex_join(&c, NULL), GMDS_OK);
    ck_assert_int_eq(gmds_complex_relation(&c, 3, 2, 1, &before, NULL), GMDS_OK);
    for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
      const size_t n[2] = {c.nodes[1].n, c.nodes[2].n};
      f.until = k;
      error.text[0] = 0;
      status = gmds_complex_make(&c, 1, 1, &error);
      f.until = 1000000;
      if (status == GMDS_OK)
        break;
      failures++;
      ck_assert(status == GMDS_ERR_MEMORY && error.status == status && error.text[0]);
      ck_assert(c.nodes[1].n == n[0] && c.nodes[2].n == n[1]);
      ck_assert_int_eq(gmds_complex_relation(&c, 3, 2, 1, &after, NULL), GMDS_OK);
      ck_assert_uint_eq(after.n, before.n);
      ck_assert_mem_eq(after.begin, before.begin, (before.n + 1) * sizeof *before.begin);
      ck_assert(!before.begin[before.n] ||
                !memcmp(after.data, before.data, before.begin[before.n] * sizeof *before.data));
      gmds_csr_clear(&after);
    }
    ck_assert_int_eq(status, GMDS_OK);
    gmds_csr_clear(&before);
    gmds_complex_clear(&c);
    ck_assert(!memory.live && !f.live);
  }
  ck_assert_uint_gt(failures, 400);
}
END_TEST

START_TEST(a_model_names_the_region_that_it_cannot_hold)
{
  static const gmds_id more[][4] = {{0, 2, 1, 4}, {0, 1, 2, 5}};
  const gmds_id prism[] = {0, 1, 2, 3, 4, 5};
  gmds_soup soup;
  walled_mesh m;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory_init(&memory, NULL);
  walled_mesh_init(&m, NULL);
  begin_soup(&soup, 6);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, tetrahedron), GMDS_OK);
  for (int k = 0; k < 2; k++)
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, more[k]), GMDS_OK);
  ck_assert_int_eq(walled_from_soup(&m, &soup, &error), GMDS_ERR_CONFLICT);
  ck_assert_msg(strstr(error.text, "region 0 has a face that two others have") != NULL, "%s", error.text);
  ck_assert(error.status == GMDS_ERR_CONFLICT && !walled_count_0(&m) && !walled_mesh_memory(&m)->live);
  gmds_soup_clear(&soup);
  begin_soup(&soup, 6);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, tetrahedron), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_PRISM, 6, prism), GMDS_OK);
  ck_assert_int_eq(walled_from_soup(&m, &soup, &error), GMDS_ERR_UNSUPPORTED);
  ck_assert_msg(strstr(error.text, "region 1 is a prism") != NULL, "%s", error.text);
  ck_assert(!walled_count_0(&m) && !walled_mesh_memory(&m)->live);
  gmds_soup_clear(&soup);
  walled_mesh_clear(&m);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

RUN_SUITE("complexes", relations_are_those_of_the_definition, aligned_relations_have_an_entry_a_side_or_face,
          what_is_made_is_what_was_missing, shapes_are_closed_and_face_outwards,
          a_shape_is_found_from_its_faces_in_any_order, what_are_no_faces_of_a_shape_is_refused,
          a_soup_with_a_wrong_cell_is_refused, a_polyhedron_that_does_not_close_is_refused,
          edges_and_faces_that_are_listed_twice_are_one, an_edge_has_two_nodes, a_volume_that_is_wrong_is_not_written,
          a_polyhedron_of_many_faces_goes_through_a_volume, a_complex_that_cannot_be_made_longer_stays,
          a_model_names_the_region_that_it_cannot_hold)
