/* Signs on the lattice. Coordinates relative to a point of the box are at most 2^30 in size, those of normals 2^61.
 *
 * A point is moved by (e, e^2, e^3) for an infinitely small e: of what it moves by, x outweighs y, and y outweighs z.
 * So no moved point lies in the plane of a triangle, and no axis-parallel line through one meets an edge. */
#ifndef GMDS_HEXMESH_SIDES_H
#define GMDS_HEXMESH_SIDES_H

#include <stdint.h>

/* A triangle relative to a point, its bounding box, and its normal, where it has been asked for. */
typedef struct placed {
  int64_t corner[3][3];
  int64_t least[3], most[3];
  int64_t normal[3];
} placed;

static inline int sign_of(int64_t x)
{
  return (x > 0) - (x < 0);
}

static inline int64_t least3(int64_t a, int64_t b, int64_t c)
{
  const int64_t m = a < b ? a : b;
  return m < c ? m : c;
}

static inline int64_t most3(int64_t a, int64_t b, int64_t c)
{
  const int64_t m = a > b ? a : b;
  return m > c ? m : c;
}

static inline void place(placed *t, const int32_t *triangle, const int64_t origin[3])
{
  for (int a = 0; a < 3; a++) {
    for (int k = 0; k < 3; k++)
      t->corner[k][a] = triangle[3 * k + a] - origin[a];
    t->least[a] = least3(t->corner[0][a], t->corner[1][a], t->corner[2][a]);
    t->most[a] = most3(t->corner[0][a], t->corner[1][a], t->corner[2][a]);
  }
}

/* The normal, by the turn of the corners. Differences of corners are at most 2^30. */
static inline void find_normal(placed *t)
{
  for (int a = 0; a < 3; a++) {
    const int u = (a + 1) % 3, v = (a + 2) % 3;
    t->normal[a] = (t->corner[1][u] - t->corner[0][u]) * (t->corner[2][v] - t->corner[0][v]) -
                   (t->corner[1][v] - t->corner[0][v]) * (t->corner[2][u] - t->corner[0][u]);
  }
}

/* The sign of normal . (p - corner), p at most 2^30 from the corner along each axis. The normal is taken as h 2^31 + l,
 * 0 <= l < 2^31: the sums of products are below 3 2^60 and 3 2^61. */
static inline int side_of(const placed *t, int64_t x, int64_t y, int64_t z)
{
  const int64_t p[3] = {x - t->corner[0][0], y - t->corner[0][1], z - t->corner[0][2]};
  int64_t high = 0, low = 0;
  for (int a = 0; a < 3; a++) {
    high += (t->normal[a] >> 31) * p[a];
    low += (t->normal[a] & 0x7fffffff) * p[a];
  }
  high += low >> 31;
  return high ? sign_of(high) : (low & 0x7fffffff) != 0;
}

/* The same of the moved point: 0 only for a flat triangle. */
static inline int moved_side_of(const placed *t, int64_t x, int64_t y, int64_t z)
{
  const int side = side_of(t, x, y, z);
  if (side)
    return side;
  for (int a = 0; a < 2; a++)
    if (t->normal[a])
      return sign_of(t->normal[a]);
  return sign_of(t->normal[2]);
}

/* The turn of a, b and the moved point (p, q) in the plane of axes u < v. 0 only where a and b are the same there. */
static inline int turn_of(const int64_t *a, const int64_t *b, int u, int v, int64_t p, int64_t q)
{
  const int64_t turn = (a[u] - p) * (b[v] - q) - (a[v] - q) * (b[u] - p);
  if (turn)
    return sign_of(turn);
  return a[v] != b[v] ? sign_of(a[v] - b[v]) : sign_of(b[u] - a[u]);
}

/* Whether the line along the third axis through the moved point (p, q) in the plane of axes u < v meets the triangle.
 * It meets none that the projection makes flat. */
static inline int line_meets(const placed *t, int u, int v, int64_t p, int64_t q)
{
  const int64_t *a = t->corner[0], *b = t->corner[1], *c = t->corner[2];
  if (t->least[u] > p || t->most[u] <= p || t->least[v] > q || t->most[v] <= q)
    return 0;
  const int turn = turn_of(a, b, u, v, p, q);
  return turn && turn == turn_of(b, c, u, v, p, q) && turn == turn_of(c, a, u, v, p, q);
}

#endif
