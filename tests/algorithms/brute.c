/* A soup of regions taken apart: no index, no table, every question asked of every wall. */
#include "algorithms/brute.h"
#include "harness.h"

static int same_set(size_t n, const gmds_id *a, const gmds_id *b)
{
  for (size_t i = 0; i < n; i++) {
    size_t k = 0;
    while (k < n && b[k] != a[i])
      k++;
    if (k == n)
      return 0;
  }
  return 1;
}

static void add_walls(brute *b, const gmds_soup *s, size_t r)
{
  const gmds_id *v = s->corners + s->begin[r];
  const gmds_shape *shape = gmds_shape_of(b->type[r]);
  const size_t n = shape ? shape->faces : *v++;
  for (size_t k = 0; k < n; k++) {
    brute_cycle *w = &b->wall[b->n_walls];
    b->owner[b->n_walls++] = r;
    w->n = shape ? shape->sides[k] : *v++;
    for (size_t q = 0; q < w->n; q++)
      w->v[q] = shape ? v[shape->face[k][q]] : *v++;
  }
  for (size_t k = 0; shape && k < shape->nodes; k++)
    b->nodes[r][k] = v[k];
}

void brute_begin(brute *b, const gmds_soup *s)
{
  const size_t most = s->n_cells * 8 + 1;
  *b = (brute){.n_nodes = s->n_points, .n_regions = s->n_cells, .points = s->points};
  b->type = calloc(most, sizeof *b->type);
  b->nodes = calloc(most, sizeof *b->nodes);
  b->first = calloc(most, sizeof *b->first);
  b->owner = calloc(most, sizeof *b->owner);
  b->wall = calloc(most, sizeof *b->wall);
  b->group = calloc(most, sizeof *b->group);
  b->on = calloc(most, sizeof *b->on);
  for (size_t r = 0; r < b->n_regions; r++) {
    b->type[r] = (gmds_cell_type)s->types[r];
    b->first[r] = b->n_walls;
    add_walls(b, s, r);
  }
  b->first[b->n_regions] = b->n_walls;
  for (size_t w = 0; w < b->n_walls; w++) {
    size_t g = 0;
    while (b->wall[g].n != b->wall[w].n || !same_set(b->wall[w].n, b->wall[g].v, b->wall[w].v))
      g++;
    b->group[w] = g;
    b->on[g]++;
  }
}

void brute_end(brute *b)
{
  free(b->type);
  free(b->nodes);
  free(b->first);
  free(b->owner);
  free(b->wall);
  free(b->group);
  free(b->on);
}

size_t brute_wall(const brute *b, size_t r, size_t n, const gmds_id *nodes)
{
  for (size_t w = b->first[r]; w < b->first[r + 1]; w++)
    if (b->wall[w].n == n && same_set(n, b->wall[w].v, nodes))
      return w;
  return b->n_walls;
}

int brute_same_cycle(const brute_cycle *wall, const gmds_id *nodes)
{
  for (size_t from = 0; from < wall->n; from++) {
    size_t k = 0;
    while (k < wall->n && wall->v[(from + k) % wall->n] == nodes[k])
      k++;
    if (k == wall->n)
      return 1;
  }
  return 0;
}

double brute_cone(const brute *b, size_t n, const gmds_id *nodes)
{
  double sum = 0, c[3] = {0, 0, 0};
  for (size_t k = 0; k < n; k++)
    for (size_t d = 0; d < 3; d++)
      c[d] += b->points[3 * (size_t)nodes[k] + d] / (double)n;
  for (size_t k = 0; k < n; k++) {
    const double *p = b->points + 3 * (size_t)nodes[k], *q = b->points + 3 * (size_t)nodes[(k + 1) % n];
    sum += c[0] * (p[1] * q[2] - p[2] * q[1]) + c[1] * (p[2] * q[0] - p[0] * q[2]) + c[2] * (p[0] * q[1] - p[1] * q[0]);
  }
  return sum / 6;
}

/* Whether a wall has node v, or, unless x is GMDS_NONE, the side from v to x. */
static int has(const brute_cycle *w, gmds_id v, gmds_id x)
{
  for (size_t k = 0; k < w->n; k++) {
    const gmds_id a = w->v[k], c = w->v[(k + 1) % w->n];
    if (x == GMDS_NONE ? a == v : (a == v && c == x) || (a == x && c == v))
      return 1;
  }
  return 0;
}

/* Joins the regions that share a wall at the key, or anywhere where v is GMDS_NONE; those at it have a number below
 * n_regions, which becomes the least of their fan. */
static size_t spread(const brute *b, gmds_id v, gmds_id x, size_t *number)
{
  size_t fans = 0;
  for (size_t r = 0; r < b->n_regions; r++)
    number[r] = v == GMDS_NONE ? r : b->n_regions;
  for (size_t w = 0; w < b->n_walls && v != GMDS_NONE; w++)
    if (has(&b->wall[w], v, x))
      number[b->owner[w]] = b->owner[w];
  for (int changed = 1; changed;) {
    changed = 0;
    for (size_t w = 0; w < b->n_walls; w++) {
      const size_t g = b->group[w];
      if (g == w || (v != GMDS_NONE && !(has(&b->wall[w], v, x) && has(&b->wall[g], v, x))))
        continue;
      size_t *p = &number[b->owner[w]], *q = &number[b->owner[g]];
      changed |= *p != *q;
      *p = *q = *p < *q ? *p : *q;
    }
  }
  for (size_t r = 0; r < b->n_regions; r++)
    fans += number[r] == r;
  return fans;
}

size_t brute_components(const brute *b, gmds_id *number)
{
  size_t *least = malloc((b->n_regions + 1) * sizeof *least), n = 0;
  const size_t fans = spread(b, GMDS_NONE, GMDS_NONE, least);
  for (size_t r = 0; r < b->n_regions; r++)
    number[r] = least[r] == r ? (gmds_id)n++ : number[least[r]];
  free(least);
  return fans;
}

size_t brute_fans(const brute *b, gmds_id v, gmds_id x)
{
  int any = 0;
  for (size_t w = 0; w < b->n_walls && !any; w++)
    any = has(&b->wall[w], v, x);
  if (!any)
    return 0;
  size_t *least = malloc((b->n_regions + 1) * sizeof *least);
  const size_t fans = spread(b, v, x, least);
  free(least);
  return fans;
}

int brute_is_inner(const brute *b, gmds_id v)
{
  int used = 0;
  for (size_t w = 0; w < b->n_walls; w++) {
    if (!has(&b->wall[w], v, GMDS_NONE))
      continue;
    used = 1;
    if (b->on[b->group[w]] != 2 || b->type[b->owner[w]] == GMDS_POLYHEDRON)
      return 0;
  }
  return used;
}

/* ---- relations */

static size_t nodes_of(const gmds_complex *c, int i, size_t x, const gmds_id **nodes)
{
  *nodes = c->nodes[i].data + c->nodes[i].begin[x];
  return c->nodes[i].begin[x + 1] - c->nodes[i].begin[x];
}

static int is_in(gmds_id v, size_t n, const gmds_id *nodes)
{
  for (size_t k = 0; k < n; k++)
    if (nodes[k] == v)
      return 1;
  return 0;
}

/* Whether i-cell x is on j-cell y, i < j. */
static int is_on(const brute *b, const gmds_complex *c, int i, size_t x, int j, size_t y)
{
  const gmds_id *p = NULL, *q = NULL, self = (gmds_id)x;
  const size_t n = i ? nodes_of(c, i, x, &p) : 1, m = nodes_of(c, j, y, &q);
  if (i == 0)
    return is_in(self, m, q);
  if (j == 2) {
    brute_cycle w = {.n = m};
    memcpy(w.v, q, m * sizeof *q);
    return has(&w, p[0], p[1]);
  }
  if (i == 2)
    return brute_wall(b, y, n, p) < b->n_walls;
  for (size_t w = b->first[y]; w < b->first[y + 1]; w++)
    if (has(&b->wall[w], p[0], p[1]))
      return 1;
  return 0;
}

/* Whether two i-cells are beside each other: they have an (i - 1)-cell in common, nodes an edge. */
static int is_beside(const brute *b, const gmds_complex *c, int i, size_t x, size_t y)
{
  const int k = i ? i - 1 : 1;
  const size_t n = k ? c->nodes[k].n : c->n_nodes;
  for (size_t z = 0; z < n && x != y; z++)
    if (i ? is_on(b, c, k, z, i, x) && is_on(b, c, k, z, i, y) : is_on(b, c, 0, x, 1, z) && is_on(b, c, 0, y, 1, z))
      return 1;
  return 0;
}

void brute_check_relation(const brute *b, const gmds_complex *c, int i, int j, const gmds_csr *csr)
{
  const size_t n = i ? c->nodes[i].n : c->n_nodes, m = j ? c->nodes[j].n : c->n_nodes;
  ck_assert_uint_eq(csr->n, n);
  for (size_t x = 0; x < n; x++) {
    size_t expected = 0;
    for (size_t y = 0; y < m; y++) {
      const int is = i == j ? is_beside(b, c, i, x, y) : i < j ? is_on(b, c, i, x, j, y) : is_on(b, c, j, y, i, x);
      expected += (size_t)is;
      if (is && !is_in((gmds_id)y, csr->begin[x + 1] - csr->begin[x], csr->data + csr->begin[x]))
        ck_abort_msg("%d -> %d: cell %zu lacks %zu", i, j, x, y); /* an assertion that holds is written down, too */
    }
    ck_assert_uint_eq(csr->begin[x + 1] - csr->begin[x], expected);
  }
}
