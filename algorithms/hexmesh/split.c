/* The eight children of a cell and its triangles: each triangle is held against all eight at once, in coordinates
 * relative to the centre of the cell. A set of children is a byte, a bit for each. */
#include "sides.h"
#include <gmds/lattice.h>
#include <string.h>

/* The children in the lower half along each axis. */
static const unsigned lower_half[3] = {0x55, 0x33, 0x0f};

typedef struct interval {
  int64_t least, most;
} interval;

/* Those whose boxes, s wide, meet the bounding box; *within: whether that lies in the cell. */
static inline unsigned meet_bounds(const placed *t, int64_t s, int *within)
{
  unsigned met = 0xff;
  *within = 1;
  for (int a = 0; a < 3; a++) {
    const int64_t least = t->least[a], most = t->most[a];
    const unsigned low = lower_half[a];
    met &= (least <= 0 && most >= -s ? low : 0) | (most >= 0 && least <= s ? 0xff ^ low : 0);
    *within &= least >= -s && most <= s;
  }
  return met;
}

static inline unsigned if_meets(interval of, int64_t least, int64_t most, unsigned which)
{
  return (unsigned)-((of.least <= most) & (of.most >= least)) & which;
}

/* Those that the cross product of the edge from a to b with the third axis does not part from the triangle a, b, c. In
 * the direction of the product, a child reaches from -n to p for each of two axes where it is in the upper half, and
 * from -p to n in the lower. */
static inline unsigned meet_edge(const int64_t *a, const int64_t *b, const int64_t *c, int u, int v, int64_t s)
{
  const int64_t along_u = b[u] - a[u], along_v = b[v] - a[v];
  const int64_t one = along_u * a[v] - along_v * a[u], other = along_u * c[v] - along_v * c[u];
  const interval of = {one < other ? one : other, one < other ? other : one};
  const int64_t to_u = -along_v * s, to_v = along_u * s;
  const int64_t pu = to_u > 0 ? to_u : 0, nu = pu - to_u, pv = to_v > 0 ? to_v : 0, nv = pv - to_v;
  const unsigned lu = lower_half[u], lv = lower_half[v], hu = 0xff ^ lu, hv = 0xff ^ lv;
  return if_meets(of, -pu - pv, nu + nv, lu & lv) | if_meets(of, -nu - pv, pu + nv, hu & lv) |
         if_meets(of, -pu - nv, nu + pv, lu & hv) | if_meets(of, -nu - nv, pu + pv, hu & hv);
}

/* Those of `met` that the plane does not pass by. */
static inline unsigned meet_plane(const placed *t, int64_t s, unsigned met)
{
  for (unsigned c = 0; c < 8; c++) {
    int64_t p[3], q[3];
    if (!(met >> c & 1))
      continue;
    for (int a = 0; a < 3; a++) {
      const int64_t low = c >> a & 1 ? 0 : -s;
      p[a] = t->normal[a] < 0 ? low + s : low;
      q[a] = t->normal[a] < 0 ? low : low + s;
    }
    if (side_of(t, p[0], p[1], p[2]) > 0 || side_of(t, q[0], q[1], q[2]) < 0)
      met ^= 1u << c;
  }
  return met;
}

/* Which children, s wide, the triangle meets. */
static inline unsigned meet_children(placed *t, int64_t s)
{
  int within;
  unsigned met = meet_bounds(t, s, &within);
  if (!met || (within && !(met & (met - 1))))
    return met;
  for (int k = 0; k < 3; k++) {
    const int64_t *a = t->corner[k], *b = t->corner[(k + 1) % 3], *c = t->corner[(k + 2) % 3];
    met &= meet_edge(a, b, c, 0, 1, s);
    met &= meet_edge(a, b, c, 0, 2, s);
    met &= meet_edge(a, b, c, 1, 2, s);
  }
  find_normal(t);
  return meet_plane(t, s, met);
}

/* Adds to the windings of the children in `which` what the way from p to the place `to` on an axis crosses: half the
 * difference of the sides. */
static inline void walk(const placed *t, const int64_t p[3], int along, int64_t to, unsigned which, int32_t winding[8])
{
  int64_t q[3] = {p[0], p[1], p[2]};
  q[along] = to;
  const int32_t change = (moved_side_of(t, p[0], p[1], p[2]) - moved_side_of(t, q[0], q[1], q[2])) / 2;
  for (unsigned c = 0; change && c < 8; c++)
    winding[c] += which >> c & 1 ? change : 0;
}

/* The ways from the cell's centre to those of its children, r away along each axis: along x, then y, then z, those of
 * several children together as long as they are the same. */
static inline void walk_to_children(placed *t, int64_t r, int32_t winding[8])
{
  const int64_t to[2] = {-r, r};
  const unsigned x[2] = {0x55, 0xaa}, y[2] = {0x33, 0xcc}, z[2] = {0x0f, 0xf0};
  const int along_x = line_meets(t, 1, 2, 0, 0);
  int along_y[2], along_z[4], any = along_x;
  for (int i = 0; i < 2; i++)
    any |= along_y[i] = line_meets(t, 0, 2, to[i], 0);
  for (int i = 0; i < 4; i++)
    any |= along_z[i] = line_meets(t, 0, 1, to[i & 1], to[i >> 1]);
  if (!any)
    return;
  find_normal(t);
  for (int k = 0; k < 2; k++) {
    if (along_x)
      walk(t, (const int64_t[3]){0, 0, 0}, 0, to[k], x[k], winding);
    for (int i = 0; i < 2; i++)
      if (along_y[i])
        walk(t, (const int64_t[3]){to[i], 0, 0}, 1, to[k], x[i] & y[k], winding);
    for (int i = 0; i < 4; i++)
      if (along_z[i])
        walk(t, (const int64_t[3]){to[i & 1], to[i >> 1], 0}, 2, to[k], x[i & 1] & y[i >> 1] & z[k], winding);
  }
}

/* All triangles against all children. met: a byte for each triangle, or NULL; total: how many each child meets. */
static void hold(const gmds_lattice *l, const int64_t centre[3], int64_t s, size_t n, const gmds_id *triangles,
                 uint8_t *met, size_t total[8], int32_t winding[8])
{
  unsigned all = 0;
  for (size_t k = 0; k < n; k++) {
    placed t;
    place(&t, l->triangles + 9 * (size_t)triangles[k], centre);
    const unsigned which = meet_children(&t, s);
    walk_to_children(&t, s / 2, winding);
    all |= which;
    if (!met)
      continue;
    met[k] = (uint8_t)which;
    for (int c = 0; c < 8; c++)
      total[c] += which >> c & 1;
  }
  for (int c = 0; !met && c < 8; c++)
    total[c] = all >> c & 1;
}

/* Appends the lists of the children in `keep`. What tells them, a byte a triangle, lies behind the end of the list, and
 * is moved over in the end. */
static gmds_status append_lists(size_t n, const gmds_id *triangles, unsigned keep, const size_t total[8],
                                gmds_ids *lists, gmds_lattice_octants *o)
{
  const size_t bytes = (n + sizeof(gmds_id) - 1) / sizeof(gmds_id);
  size_t sum = 0, at[8];
  for (int c = 0; c < 8; c++) {
    o->begin[c] = lists->n + sum;
    at[c] = sum;
    sum += keep >> c & 1 ? total[c] : 0;
  }
  o->begin[8] = lists->n + sum;
  GMDS_TRY(gmds_ids_reserve(lists, lists->n + bytes + sum));
  const uint8_t *met = (const uint8_t *)(lists->data + lists->n);
  gmds_id *to = lists->data + lists->n + bytes;
  for (size_t k = 0; k < n; k++)
    for (unsigned c = 0, left = met[k] & keep; left; c++, left >>= 1)
      if (left & 1)
        to[at[c]++] = triangles[k];
  memmove(lists->data + lists->n, to, sum * sizeof *to);
  lists->n += sum;
  return GMDS_OK;
}

/* Whether the cell is there, and its children have centres on the lattice. */
static int can_split(const gmds_lattice *l, gmds_lattice_cell cell)
{
  if (cell.level >= l->bits || cell.level + 1 >= l->bits)
    return 0;
  for (int a = 0; a < 3; a++)
    if (cell.at[a] >= (uint64_t)l->base[a] << cell.level)
      return 0;
  return 1;
}

gmds_status gmds_lattice_split(const gmds_lattice *lattice, gmds_lattice_cell cell, int32_t winding, size_t n,
                               const gmds_id *triangles, unsigned keep, gmds_ids *lists, gmds_lattice_octants *octants)
{
  if (!can_split(lattice, cell))
    return GMDS_ERR_ARGUMENT;
  gmds_lattice_octants o = {0};
  size_t total[8] = {0};
  int64_t centre[3];
  uint8_t *met = NULL;
  const int64_t s = gmds_lattice_width(lattice, cell.level) / 2;
  for (int a = 0; a < 3; a++)
    centre[a] = (2 * (int64_t)cell.at[a] + 1) * s;
  for (int c = 0; c < 8; c++)
    o.winding[c] = winding;
  for (int c = 0; c < 9; c++)
    o.begin[c] = lists ? lists->n : 0;
  if (n && keep) {
    GMDS_TRY(gmds_ids_reserve(lists, lists->n + (n + sizeof(gmds_id) - 1) / sizeof(gmds_id)));
    met = (uint8_t *)(lists->data + lists->n);
  }
  hold(lattice, centre, s, n, triangles, met, total, o.winding);
  for (int c = 0; c < 8; c++)
    o.cut |= (unsigned)(total[c] != 0) << c;
  if (met)
    GMDS_TRY(append_lists(n, triangles, keep, total, lists, &o));
  *octants = o;
  return GMDS_OK;
}
