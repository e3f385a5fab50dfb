/* One box and one triangle. All products of coordinates are below 2^60, sums of two below 2^61. */
#include "sides.h"
#include <gmds/lattice.h>

/* Whether the cross product of the edge from a to b with the third axis parts the triangle a, b, c, in the plane of
 * axes u and v, from the box from the origin to `size`. */
static int edge_parts(const int64_t *a, const int64_t *b, const int64_t *c, int u, int v, const int64_t size[3])
{
  const int64_t along_u = b[u] - a[u], along_v = b[v] - a[v];
  const int64_t one = along_u * a[v] - along_v * a[u], other = along_u * c[v] - along_v * c[u];
  const int64_t to_v = along_u * size[v], to_u = -along_v * size[u];
  const int64_t least = (to_u < 0 ? to_u : 0) + (to_v < 0 ? to_v : 0);
  const int64_t most = (to_u > 0 ? to_u : 0) + (to_v > 0 ? to_v : 0);
  return (one < least && other < least) || (one > most && other > most);
}

/* Whether the plane of the triangle passes by the box. */
static int plane_parts(placed *t, const int64_t size[3])
{
  int64_t p[3], q[3];
  find_normal(t);
  for (int a = 0; a < 3; a++) {
    p[a] = t->normal[a] < 0 ? size[a] : 0;
    q[a] = size[a] - p[a];
  }
  return side_of(t, p[0], p[1], p[2]) > 0 || side_of(t, q[0], q[1], q[2]) < 0;
}

int gmds_lattice_meets(const int32_t low[3], const int32_t high[3], const int32_t triangle[9])
{
  placed t;
  int64_t origin[3], size[3];
  for (int a = 0; a < 3; a++) {
    origin[a] = low[a];
    size[a] = (int64_t)high[a] - low[a];
  }
  place(&t, triangle, origin);
  for (int a = 0; a < 3; a++)
    if (t.most[a] < 0 || t.least[a] > size[a])
      return 0;
  for (int k = 0; k < 3; k++) {
    const int64_t *p = t.corner[k], *q = t.corner[(k + 1) % 3], *r = t.corner[(k + 2) % 3];
    if (edge_parts(p, q, r, 0, 1, size) || edge_parts(p, q, r, 0, 2, size) || edge_parts(p, q, r, 1, 2, size))
      return 0;
  }
  return !plane_parts(&t, size);
}
