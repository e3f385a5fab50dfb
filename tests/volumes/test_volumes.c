/* Every query of models of volumes against brute force: on regular meshes, where shared nodes mislead, and after random
 * creation and deletion; every row of the tables taken by a model. */
#include "volumes/subject.h"
#include <gmds/census.h>

static subject one;

/* ---- what meshes are made of: regions and faces that fit each other or mislead, on nodes 0 to 27 */

typedef struct item {
  gmds_cell_type type;
  gmds_id nodes[8];
} item;

static const item pool[] = {
    {GMDS_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}},
    {GMDS_HEXAHEDRON, {4, 5, 6, 7, 8, 9, 10, 11}},
    {GMDS_HEXAHEDRON, {1, 12, 13, 2, 5, 14, 15, 6}},
    {GMDS_PRISM, {8, 9, 10, 16, 17, 18}}, /* half of a quadrilateral is no face of the hexahedron */
    {GMDS_PRISM, {0, 1, 19, 3, 2, 20}},
    {GMDS_PRISM, {16, 17, 18, 21, 22, 23}},
    {GMDS_PYRAMID, {8, 9, 10, 11, 24}},
    {GMDS_PYRAMID, {0, 1, 6, 7, 25}}, /* on a diagonal plane of the hexahedron */
    {GMDS_PYRAMID, {4, 7, 3, 0, 25}},
    {GMDS_TETRAHEDRON, {0, 2, 5, 26}}, /* its edges are diagonals */
    {GMDS_TETRAHEDRON, {0, 2, 5, 7}},
    {GMDS_TETRAHEDRON, {8, 9, 24, 27}},
    {GMDS_TETRAHEDRON, {9, 10, 24, 27}},
    {GMDS_TETRAHEDRON, {16, 17, 18, 24}},
    {GMDS_TETRAHEDRON, {0, 1, 25, 26}},
    {GMDS_TETRAHEDRON, {0, 1, 26, 27}},
    {GMDS_TETRAHEDRON, {0, 1, 27, 25}},
    {GMDS_TETRAHEDRON, {1, 2, 26, 27}},
    {GMDS_TETRAHEDRON, {2, 0, 26, 27}},
    {GMDS_TRIANGLE, {4, 5, 6}},
    {GMDS_TRIANGLE, {0, 1, 25}},
    {GMDS_TRIANGLE, {25, 26, 27}},
    {GMDS_QUADRILATERAL, {2, 3, 4, 5}}, /* no face, though its nodes are a hexahedron's and two sides are edges */
    {GMDS_QUADRILATERAL, {12, 13, 15, 14}},
    {GMDS_SEGMENT, {0, 6}},
    {GMDS_SEGMENT, {1, 2}},
};
enum { POOL = sizeof pool / sizeof *pool, NODES = 28 };

static const cycle pentagonal_prism[] = {{5, {0, 1, 2, 3, 19}},      {5, {21, 22, 23, 24, 27}}, {4, {0, 1, 22, 21}},
                                         {4, {1, 2, 23, 22}},        {4, {2, 3, 24, 23}},       {4, {3, 19, 27, 24}},
                                         {4, {19, 0, 21, 27}}};
static const cycle roof[] = {{4, {8, 9, 10, 11}}, {3, {8, 9, 24}}, {3, {9, 10, 24}}, {3, {10, 11, 24}}, {3, {11, 8, 24}}};

static void nodes_of_pool(subject *s)
{
  while (reference_count(&s->ref, 0) < NODES)
    subject_add_node(s);
}

static int is_alive(const subject *s, size_t n, const gmds_id *nodes)
{
  for (size_t k = 0; k < n; k++)
    if (!reference_has(&s->ref, 0, nodes[k]))
      return 0;
  return 1;
}

static void add_item(subject *s, const item *it)
{
  const size_t n = (size_t)gmds_cell_type_points(it->type);
  cycle c = {n, {0}};
  if (!is_alive(s, n, it->nodes))
    return;
  memcpy(c.nodes, it->nodes, n * sizeof *c.nodes);
  if (it->type == GMDS_SEGMENT)
    subject_add_edge(s, c.nodes[0], c.nodes[1]);
  else if (it->type == GMDS_TRIANGLE || it->type == GMDS_QUADRILATERAL)
    subject_add_face(s, &c);
  else
    subject_add_region(s, it->type, it->nodes);
}

static void add_polyhedra(subject *s)
{
  if (reference_count(&s->ref, 0) < NODES || !s->m->do_add_polyhedron)
    return;
  subject_add_polyhedron(s, sizeof pentagonal_prism / sizeof *pentagonal_prism, pentagonal_prism);
  subject_add_polyhedron(s, sizeof roof / sizeof *roof, roof);
}

START_TEST(paths_of_the_preprocessor_are_those_of_the_census)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < 4; j++) {
        gmds_path path = gmds_path_of(m->mask, i, j);
        int can = path.cost != GMDS_COST_NONE && (m->regions & ~path.exact_regions) == 0;
        if (m->path[i][j] != path.code || m->can[i][j] != can)
          ck_abort_msg("%s %d->%d: compiled as path %d, can %d; the census says %d, %d", m->name, i, j, m->path[i][j],
                       m->can[i][j], path.code, can);
      }
    ck_assert_msg(m->adds_regions || (m->regions & ~1u), "%s cannot add tetrahedra", m->name);
  }
}
END_TEST

/* Every path that a mask of the census takes, and every row of the tables, is taken by a compiled model, which the other
 * tests hold against brute force. */
START_TEST(every_path_is_taken)
{
  static int met[16][256], taken[16][256];
  size_t codes = 0, missing = 0;
  for (size_t k = 0; k < gmds_census_size(3); k++) {
    unsigned mask = gmds_census_mask(3, k);
    for (int q = 0; q < 16 && gmds_census_of(mask, 3).identified; q++)
      taken[q][gmds_path_of(mask, q / 4, q % 4).code] = 1;
  }
  taken[0][16] = taken[5][16] = taken[10][16] = 1; /* N2N, E2E and F2F themselves, which the census leaves out */
  for (size_t k = 0; k < n_volume_models; k++)
    for (int q = 0; q < 16; q++)
      met[q][volume_models[k]->path[q / 4][q % 4]] += volume_models[k]->can[q / 4][q % 4];
  for (int q = 0; q < 16; q++) {
    printf("%d->%d:", q / 4, q % 4);
    for (int code = 16; code < 256; code++) {
      if (met[q][code])
        printf(" %d.%d", code / 16, code % 16);
      codes += met[q][code] > 0;
      if (taken[q][code] && !met[q][code]) {
        printf(" (%d.%d missing)", code / 16, code % 16);
        missing++;
      }
    }
    printf("\n");
  }
  printf("%zu paths\n", codes);
  ck_assert_uint_eq(missing, 0);
}
END_TEST

/* ---- fixed meshes */

START_TEST(answers_are_exact_while_a_mesh_grows)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    subject_begin(&one, volume_models[k], 1);
    subject_compare(&one);
    nodes_of_pool(&one);
    for (size_t i = 0; i < POOL; i++) {
      add_item(&one, &pool[i]);
      if (i % 5 == 4 || one.m->regions != 1)
        subject_compare(&one);
    }
    add_polyhedra(&one);
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

/* ---- random meshes */

static void remove_something(subject *s)
{
  const size_t which = random_below(&s->seed, 12);
  const gmds_bare bare = random_below(&s->seed, 2) ? GMDS_KEEP_BARE : GMDS_DROP_BARE;
  const gmds_around around = random_below(&s->seed, 2) ? GMDS_REFUSE : GMDS_CASCADE;
  const int i = which < 7 ? 3 : which < 9 ? 2 : which < 11 ? 1 : 0;
  const gmds_id c = reference_pick(&s->ref, i, &s->seed);
  if (c == GMDS_NONE)
    return;
  if (i == 3)
    subject_remove_region(s, c, bare);
  else if (i == 2)
    subject_remove_face(s, c, around, bare);
  else if (i == 1)
    subject_remove_edge(s, c, around);
  else {
    subject_remove_node(s, c, around);
    if (!reference_has(&s->ref, 0, c))
      subject_add_node(s); /* takes its number */
  }
}

/* Any four of a few nodes make a tetrahedron: more than two on a face, faces of which no region knows. */
static void add_any_tetrahedron(subject *s)
{
  gmds_id v[4];
  for (int k = 0; k < 4; k++)
    v[k] = (gmds_id)random_below(&s->seed, 8);
  int distinct = 1;
  for (int k = 0; k < 4; k++)
    for (int q = 0; q < k; q++)
      distinct &= v[k] != v[q];
  if (distinct && is_alive(s, 4, v))
    subject_add_region(s, GMDS_TETRAHEDRON, v);
}

START_TEST(answers_are_exact_after_creation_and_deletion)
{
  size_t done = 0, refused = 0, unsupported = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    subject_begin(&one, volume_models[k], 1000 + k);
    nodes_of_pool(&one);
    for (int round = 0; round < 4; round++) {
      for (int i = 0; i < 40; i++) {
        if (random_below(&one.seed, 3) == 0)
          remove_something(&one);
        else if (one.m->regions == 1 && random_below(&one.seed, 2))
          add_any_tetrahedron(&one);
        else if (random_below(&one.seed, 12) == 0)
          add_polyhedra(&one);
        else
          add_item(&one, &pool[random_below(&one.seed, POOL)]);
        if (i % 10 == 9)
          subject_compare(&one);
      }
      subject_compact(&one);
      subject_compare(&one);
      nodes_of_pool(&one);
    }
    done += one.done;
    refused += one.refused;
    unsupported += one.unsupported;
    subject_end(&one);
  }
  printf("%zu operations done, %zu refused, %zu not supported\n", done, refused, unsupported);
}
END_TEST

RUN_SUITE("volumes", paths_of_the_preprocessor_are_those_of_the_census, every_path_is_taken,
          answers_are_exact_while_a_mesh_grows, answers_are_exact_after_creation_and_deletion)
