/* What random meshes of volumes are made of, and random operations. */
#include "volumes/pool.h"

const item pool[] = {
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
const size_t n_pool = sizeof pool / sizeof *pool;
enum { NODES = 28 };

static const cycle pentagonal_prism[] = {{5, {0, 1, 2, 3, 19}}, {5, {21, 22, 23, 24, 27}}, {4, {0, 1, 22, 21}},
                                         {4, {1, 2, 23, 22}},   {4, {2, 3, 24, 23}},       {4, {3, 19, 27, 24}},
                                         {4, {19, 0, 21, 27}}};
static const cycle roof[] = {
    {4, {8, 9, 10, 11}}, {3, {8, 9, 24}}, {3, {9, 10, 24}}, {3, {10, 11, 24}}, {3, {11, 8, 24}}};

void pool_nodes(subject *s)
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

void pool_add(subject *s, const item *it)
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

void pool_add_polyhedra(subject *s)
{
  if (reference_count(&s->ref, 0) < NODES || !s->m->do_add_polyhedron)
    return;
  subject_add_polyhedron(s, sizeof pentagonal_prism / sizeof *pentagonal_prism, pentagonal_prism);
  subject_add_polyhedron(s, sizeof roof / sizeof *roof, roof);
}

/* ---- random operations */

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

void pool_step(subject *s)
{
  if (random_below(&s->seed, 3) == 0)
    remove_something(s);
  else if (s->m->regions == 1 && random_below(&s->seed, 2))
    add_any_tetrahedron(s);
  else if (random_below(&s->seed, 12) == 0)
    pool_add_polyhedra(s);
  else
    pool_add(s, &pool[random_below(&s->seed, n_pool)]);
}
