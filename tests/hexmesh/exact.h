/* What lattices are held against: clipping of a triangle in rational numbers, and rays over all triangles, none of it
 * shared with the library; and for leaves of large coordinates the library's test of one box, which is held against
 * clipping itself. */
#ifndef GMDS_TESTS_EXACT_H
#define GMDS_TESTS_EXACT_H

#include "harness.h"
#include <gmds/lattice.h>

__extension__ typedef __int128 wide;

/* A point (x, y, z) / w, w > 0. */
typedef struct rational_point {
  wide x[4];
} rational_point;

static inline wide wide_gcd(wide a, wide b)
{
  a = a < 0 ? -a : a;
  b = b < 0 ? -b : b;
  while (b) {
    wide r = a % b;
    a = b;
    b = r;
  }
  return a;
}

/* Keeps what lies where sign * (coordinate a - k) >= 0 of a polygon of n points. */
static inline int clip_polygon(rational_point *polygon, int n, int a, wide k, int sign)
{
  rational_point to[16];
  int m = 0;
  for (int i = 0; i < n; i++) {
    const rational_point *p = &polygon[i], *q = &polygon[(i + 1) % n];
    const wide dp = sign * (p->x[a] - k * p->x[3]), dq = sign * (q->x[a] - k * q->x[3]);
    if (dp >= 0)
      to[m++] = *p;
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
      const wide fp = dp < 0 ? -dp : dp, fq = dq < 0 ? -dq : dq;
      wide g = 0;
      for (int b = 0; b < 4; b++) {
        to[m].x[b] = fq * p->x[b] + fp * q->x[b];
        g = wide_gcd(g, to[m].x[b]);
      }
      for (int b = 0; b < 4; b++)
        to[m].x[b] /= g;
      m++;
    }
  }
  memcpy(polygon, to, (size_t)m * sizeof *to);
  return m;
}

/* Whether a box and a triangle meet. Coordinates up to 2^20. */
static inline int clipped_meets(const int32_t low[3], const int32_t high[3], const int32_t t[9])
{
  rational_point polygon[16];
  int n = 3;
  for (int k = 0; k < 3; k++) {
    for (int a = 0; a < 3; a++)
      polygon[k].x[a] = t[3 * k + a];
    polygon[k].x[3] = 1;
  }
  for (int a = 0; a < 3 && n; a++) {
    n = clip_polygon(polygon, n, a, low[a], 1);
    n = n ? clip_polygon(polygon, n, a, high[a], -1) : 0;
  }
  return n > 0;
}

/* Twice the turn of the corners i and j of a triangle and p in the plane of axes u and v. Corners are multiplied by s
 * first. */
static inline wide turn_about(const int32_t *t, int i, int j, int u, int v, wide s, const wide p[3])
{
  return (s * t[3 * i + u] - p[u]) * (s * t[3 * j + v] - p[v]) - (s * t[3 * i + v] - p[v]) * (s * t[3 * j + u] - p[u]);
}

/* How often the ray from p in the direction of axis a runs out through the triangles less how often it runs in, the
 * corners multiplied by s. In the plane of the other axes p must be on no edge (ck_assert). */
static inline long wind_along(size_t n, const int32_t *triangles, wide s, const wide p[3], int a)
{
  const int u = (a + 1) % 3, v = (a + 2) % 3;
  long sum = 0;
  for (size_t k = 0; k < n; k++) {
    const int32_t *t = triangles + 9 * k;
    const wide x = turn_about(t, 1, 2, u, v, s, p), y = turn_about(t, 2, 0, u, v, s, p),
               z = turn_about(t, 0, 1, u, v, s, p);
    if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) {
      ck_assert(((x > 0 || y > 0 || z > 0) && (x < 0 || y < 0 || z < 0)) || x + y + z == 0);
      continue;
    }
    /* The line meets the triangle at (x c0 + y c1 + z c2) / (x + y + z): whether that lies in front of p. */
    const wide ahead = x * (s * t[a] - p[a]) + y * (s * t[3 + a] - p[a]) + z * (s * t[6 + a] - p[a]);
    ck_assert(ahead != 0);
    if (x > 0 ? ahead > 0 : ahead < 0)
      sum += x > 0 ? 1 : -1;
  }
  return sum;
}

/* Whether a ray from p in the direction of axis a leaves an odd number of triangles; an edge belongs to what lies on
 * one side of it in projection. */
static inline int odd_along(size_t n, const int32_t *triangles, const int64_t p[3], int a)
{
  const int u = (a + 1) % 3, v = (a + 2) % 3;
  int odd = 0;
  for (size_t k = 0; k < n; k++) {
    const int32_t *t = triangles + 9 * k;
    const int above[3] = {t[u] > p[u], t[3 + u] > p[u], t[6 + u] > p[u]};
    if (above[0] == above[1] && above[1] == above[2])
      continue;
    int crossed = 0;
    wide area = 0, ahead = 0;
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, o = (i + 2) % 3;
      const wide weight = turn_about(t, i, j, u, v, 1, (const wide[3]){p[0], p[1], p[2]});
      area += weight;
      ahead += weight * (t[3 * o + a] - p[a]);
      if (above[i] != above[j]) /* to the right of p, where the edge is met at the height of p */
        crossed ^= above[j] ? weight > 0 : weight < 0;
    }
    if (crossed)
      odd ^= area > 0 ? ahead > 0 : ahead < 0;
  }
  return odd;
}

/* Whether a leaf is what the boxes of all triangles say, and, where it is not cut, rays along y and z. */
static inline int leaf_is_right(const gmds_lattice *l, const gmds_lattice_leaf *leaf)
{
  const gmds_lattice_cell cell = {{leaf->at[0], leaf->at[1], leaf->at[2]}, leaf->level};
  int32_t low[3], high[3];
  int64_t centre[3];
  int cut = 0;
  gmds_lattice_bounds(l, cell, low, high);
  for (int a = 0; a < 3; a++)
    centre[a] = ((int64_t)low[a] + high[a]) / 2;
  for (size_t t = 0; t < l->n_triangles && !cut; t++)
    cut = gmds_lattice_meets(low, high, l->triangles + 9 * t);
  if (cut || leaf->state == GMDS_LATTICE_CUT)
    return cut && leaf->state == GMDS_LATTICE_CUT;
  const int inside = leaf->state == GMDS_LATTICE_INSIDE;
  return odd_along(l->n_triangles, l->triangles, centre, 1) == inside &&
         odd_along(l->n_triangles, l->triangles, centre, 2) == inside;
}

#endif
