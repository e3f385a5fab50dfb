/* The reference mesh of volumes and its queries, by brute force. */
#include "volumes/reference.h"
#include "harness.h"

/* ---- local numbering, typed in a second time: VTK's faces, 9 ends a row */
static const unsigned char tables[4][6][5] = {
    {{0, 1, 3, 9}, {1, 2, 3, 9}, {2, 0, 3, 9}, {0, 2, 1, 9}},
    {{0, 3, 2, 1, 9}, {0, 1, 4, 9}, {1, 2, 4, 9}, {2, 3, 4, 9}, {3, 0, 4, 9}},
    {{0, 2, 1, 9}, {3, 4, 5, 9}, {0, 1, 4, 3, 9}, {1, 2, 5, 4, 9}, {2, 0, 3, 5, 9}},
    {{0, 4, 7, 3, 9}, {1, 2, 6, 5, 9}, {0, 1, 5, 4, 9}, {3, 7, 6, 2, 9}, {0, 3, 2, 1, 9}, {4, 5, 6, 7, 9}}};
static const unsigned char edges[4][12][2] = {
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}},
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
    {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}}};
static const size_t n_walls[] = {4, 5, 5, 6}, n_edges[] = {6, 8, 9, 12};

size_t reference_walls(gmds_cell_type type, const gmds_id *nodes, cycle *walls)
{
  int t = (int)type - (int)GMDS_TETRAHEDRON;
  for (size_t k = 0; k < n_walls[t]; k++)
    for (walls[k].n = 0; walls[k].n < 4 && tables[t][k][walls[k].n] != 9; walls[k].n++)
      walls[k].nodes[walls[k].n] = nodes[tables[t][k][walls[k].n]];
  return n_walls[t];
}

/* ---- */

int reference_has(const reference *r, int i, gmds_id c)
{
  return c < r->end[i] && r->cells[i][c].alive;
}

size_t reference_count(const reference *r, int i)
{
  size_t n = 0;
  for (gmds_id c = 0; c < r->end[i]; c++)
    n += (size_t)r->cells[i][c].alive;
  return n;
}

gmds_id reference_pick(const reference *r, int i, uint64_t *seed)
{
  size_t n = reference_count(r, i);
  if (!n)
    return GMDS_NONE;
  size_t k = random_below(seed, n);
  for (gmds_id c = 0;; c++)
    if (r->cells[i][c].alive && k-- == 0)
      return c;
}

static gmds_id take(reference *r, int i)
{
  gmds_id c = 0;
  while (c < r->end[i] && r->cells[i][c].alive)
    c++;
  ck_assert_uint_lt(c, MAX_CELLS);
  if (c == r->end[i])
    r->end[i]++;
  r->cells[i][c] = (reference_cell){.alive = 1};
  return c;
}

static void drop(reference *r, int i, gmds_id c)
{
  r->cells[i][c].alive = 0;
  while (r->end[i] && !r->cells[i][r->end[i] - 1].alive)
    r->end[i]--;
}

static int cycle_has(const cycle *c, gmds_id v)
{
  for (size_t k = 0; k < c->n; k++)
    if (c->nodes[k] == v)
      return 1;
  return 0;
}

static int same_set(const cycle *a, const cycle *b)
{
  for (size_t k = 0; k < a->n; k++)
    if (!cycle_has(b, a->nodes[k]))
      return 0;
  return a->n == b->n;
}

static int has_side(const cycle *c, gmds_id a, gmds_id b)
{
  for (size_t k = 0; k < c->n; k++) {
    gmds_id p = c->nodes[k], q = c->nodes[(k + 1) % c->n];
    if ((p == a && q == b) || (p == b && q == a))
      return 1;
  }
  return 0;
}

static int region_has(const reference_cell *c, gmds_id v)
{
  for (size_t k = 0; k < c->n_walls; k++)
    if (cycle_has(&c->walls[k], v))
      return 1;
  return 0;
}

static int region_has_side(const reference_cell *c, gmds_id a, gmds_id b)
{
  for (size_t k = 0; k < c->n_walls; k++)
    if (has_side(&c->walls[k], a, b))
      return 1;
  return 0;
}

static int region_has_wall(const reference_cell *c, const cycle *w)
{
  for (size_t k = 0; k < c->n_walls; k++)
    if (same_set(&c->walls[k], w))
      return 1;
  return 0;
}

gmds_id reference_edge(const reference *r, gmds_id a, gmds_id b)
{
  for (gmds_id e = 0; e < r->end[1]; e++)
    if (r->cells[1][e].alive && has_side(&r->cells[1][e].nodes, a, b))
      return e;
  return GMDS_NONE;
}

gmds_id reference_face(const reference *r, const cycle *c)
{
  for (gmds_id f = 0; f < r->end[2]; f++)
    if (r->cells[2][f].alive && same_set(&r->cells[2][f].nodes, c))
      return f;
  return GMDS_NONE;
}

size_t reference_regions_on(const reference *r, const cycle *c)
{
  size_t n = 0;
  for (gmds_id x = 0; x < r->end[3]; x++)
    n += r->cells[3][x].alive && region_has_wall(&r->cells[3][x], c);
  return n;
}

gmds_id reference_add_node(reference *r)
{
  return take(r, 0);
}

gmds_id reference_add_edge(reference *r, gmds_id a, gmds_id b)
{
  gmds_id e = reference_edge(r, a, b);
  if (e == GMDS_NONE) {
    e = take(r, 1);
    r->cells[1][e].nodes = (cycle){2, {a, b}};
  }
  return e;
}

gmds_id reference_add_face(reference *r, const cycle *c)
{
  if (r->makes_edges)
    for (size_t k = 0; k < c->n; k++)
      reference_add_edge(r, c->nodes[k], c->nodes[(k + 1) % c->n]);
  gmds_id f = reference_face(r, c);
  if (f == GMDS_NONE) {
    f = take(r, 2);
    r->cells[2][f].nodes = *c;
  }
  return f;
}

static gmds_id add_region(reference *r, const reference_cell *cell)
{
  gmds_id c = take(r, 3);
  r->cells[3][c] = *cell;
  r->cells[3][c].alive = 1;
  return c;
}

gmds_id reference_add_region(reference *r, gmds_cell_type type, const gmds_id *nodes)
{
  reference_cell cell = {.type = type};
  int t = (int)type - (int)GMDS_TETRAHEDRON;
  cell.n_walls = reference_walls(type, nodes, cell.walls);
  cell.n_corners = (size_t)gmds_cell_type_points(type);
  memcpy(cell.corners, nodes, cell.n_corners * sizeof *nodes);
  for (size_t e = 0; e < n_edges[t] && r->makes_edges; e++)
    reference_add_edge(r, nodes[edges[t][e][0]], nodes[edges[t][e][1]]);
  for (size_t k = 0; k < cell.n_walls && r->makes_faces; k++)
    reference_add_face(r, &cell.walls[k]);
  return add_region(r, &cell);
}

gmds_id reference_add_polyhedron(reference *r, size_t n, const gmds_id *faces)
{
  reference_cell cell = {.type = GMDS_POLYHEDRON, .n_walls = n};
  for (size_t k = 0; k < n; k++)
    cell.walls[k] = r->cells[2][faces[k]].nodes;
  return add_region(r, &cell);
}

/* ---- removal */

static int edge_is_bare(const reference *r, gmds_id e)
{
  const gmds_id *v = r->cells[1][e].nodes.nodes;
  for (gmds_id f = 0; f < r->end[2]; f++)
    if (r->cells[2][f].alive && has_side(&r->cells[2][f].nodes, v[0], v[1]))
      return 0;
  for (gmds_id x = 0; x < r->end[3]; x++)
    if (r->cells[3][x].alive && region_has_side(&r->cells[3][x], v[0], v[1]))
      return 0;
  return 1;
}

static void drop_bare_sides(reference *r, const cycle *c)
{
  for (size_t k = 0; k < c->n; k++) {
    gmds_id e = reference_edge(r, c->nodes[k], c->nodes[(k + 1) % c->n]);
    if (e != GMDS_NONE && edge_is_bare(r, e))
      drop(r, 1, e);
  }
}

void reference_remove_face(reference *r, gmds_id f, gmds_bare bare)
{
  cycle c = r->cells[2][f].nodes;
  drop(r, 2, f);
  if (bare == GMDS_DROP_BARE)
    drop_bare_sides(r, &c);
}

void reference_remove_region(reference *r, gmds_id c, gmds_bare bare)
{
  reference_cell cell = r->cells[3][c];
  drop(r, 3, c);
  for (size_t k = 0; k < cell.n_walls && bare == GMDS_DROP_BARE; k++) {
    gmds_id f = reference_face(r, &cell.walls[k]);
    if (f != GMDS_NONE && reference_regions_on(r, &cell.walls[k]) == 0)
      drop(r, 2, f);
  }
  for (size_t k = 0; k < cell.n_walls && bare == GMDS_DROP_BARE; k++)
    drop_bare_sides(r, &cell.walls[k]);
}

void reference_remove(reference *r, int i, gmds_id c)
{
  answer around;
  for (int j = 3; j > i; j--) {
    reference_query(r, i, j, c, &around);
    for (size_t k = 0; k < around.n; k++)
      drop(r, j, around.cells[k]);
  }
  drop(r, i, c);
}

/* ---- queries */

static void put(answer *out, gmds_id x)
{
  size_t k = 0;
  while (k < out->n && out->cells[k] < x)
    k++;
  if (k < out->n && out->cells[k] == x)
    return;
  memmove(out->cells + k + 1, out->cells + k, (out->n - k) * sizeof x);
  out->cells[k] = x;
  out->n++;
}

/* Whether a cell of dimension i < j bounds one of dimension j. */
static int bounds(const reference *r, int i, gmds_id a, int j, gmds_id b)
{
  const reference_cell *x = &r->cells[i][a], *y = &r->cells[j][b];
  if (i == 0)
    return j == 3 ? region_has(y, a) : cycle_has(&y->nodes, a);
  if (i == 1)
    return j == 3 ? region_has_side(y, x->nodes.nodes[0], x->nodes.nodes[1])
                  : has_side(&y->nodes, x->nodes.nodes[0], x->nodes.nodes[1]);
  return region_has_wall(y, &x->nodes);
}

static int are_joined(const reference *r, gmds_id a, gmds_id b)
{
  for (int i = 1; i < 4; i++)
    for (gmds_id c = 0; c < r->end[i]; c++)
      if (r->cells[i][c].alive &&
          (i == 3 ? region_has_side(&r->cells[i][c], a, b) : has_side(&r->cells[i][c].nodes, a, b)))
        return 1;
  return 0;
}

static int adjacent(const reference *r, int i, gmds_id a, gmds_id b)
{
  const reference_cell *x = &r->cells[i][a], *y = &r->cells[i][b];
  if (i == 0)
    return are_joined(r, a, b);
  for (size_t k = 0; k < x->nodes.n && i < 3; k++)
    if (i == 1 ? cycle_has(&y->nodes, x->nodes.nodes[k])
               : has_side(&y->nodes, x->nodes.nodes[k], x->nodes.nodes[(k + 1) % x->nodes.n]))
      return 1;
  for (size_t k = 0; k < x->n_walls && i == 3; k++)
    if (region_has_wall(y, &x->walls[k]))
      return 1;
  return 0;
}

void reference_query(const reference *r, int i, int j, gmds_id c, answer *out)
{
  out->n = 0;
  for (gmds_id x = 0; x < r->end[j]; x++) {
    if (!r->cells[j][x].alive || (i == j && x == c))
      continue;
    if (i == j ? adjacent(r, i, c, x) : i < j ? bounds(r, i, c, j, x) : bounds(r, j, x, i, c))
      put(out, x);
  }
}
