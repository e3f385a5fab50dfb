/* Vectors, the corners of regions and the volume within walls: what measures and guards of regions share. Private to
 * the library. */
#ifndef GMDS_CORE_SOLID_H
#define GMDS_CORE_SOLID_H

#include <gmds/walls.h>
#include <math.h>

static inline void vector_to(const double *a, const double *b, double ab[3])
{
  for (int d = 0; d < 3; d++)
    ab[d] = b[d] - a[d];
}

static inline double dot(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double *a, const double *b, double out[3])
{
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double triple(const double *a, const double *b, const double *c)
{
  double ab[3];
  cross(a, b, ab);
  return dot(ab, c);
}

/* The corners of a region: a node and the three joined with it, which turn counter-clockwise seen from it towards the
 * inside when orient3d of the four is positive. A tetrahedron counts as one; the apex of a pyramid, where four edges
 * meet, is in those of its base. None of a polyhedron. */
enum { SOLID_CORNERS = 8 };
static inline size_t solid_corners(gmds_cell_type type, uint8_t corner[SOLID_CORNERS][4])
{
  const unsigned n = type == GMDS_TETRAHEDRON  ? 1
                     : type == GMDS_PYRAMID    ? 4
                     : type == GMDS_PRISM      ? 6
                     : type == GMDS_HEXAHEDRON ? 8
                                               : 0;
  const unsigned around = type == GMDS_PYRAMID ? 4 : n / 2;
  for (unsigned k = 0; k < n; k++) {
    const unsigned at = around ? k % around : 0, base = k - at;
    const unsigned next = base + (around ? (at + 1) % around : 1);
    const unsigned last = base + (around ? (at + around - 1) % around : 2);
    corner[k][0] = (uint8_t)k;
    corner[k][1] = (uint8_t)(base ? last : next);
    corner[k][2] = (uint8_t)(base ? next : last);
    corner[k][3] = (uint8_t)(!around ? 3 : type == GMDS_PYRAMID ? 4 : base ? at : k + around);
  }
  return n;
}

/* The mean of the nodes of wall w. */
static inline void wall_centre(const gmds_walls *walls, const double *points, size_t w, double centre[3])
{
  const size_t n = gmds_wall_sides(walls, w);
  for (int d = 0; d < 3; d++) {
    centre[d] = 0;
    for (size_t k = 0; k < n; k++)
      centre[d] += points[3 * (size_t)gmds_wall_node(walls, w, k) + (size_t)d] / (double)n;
  }
}

/* The volume that the walls of region r enclose; a wall that is no triangle is the triangles of its sides with the mean
 * of its nodes, so that two regions agree on it. */
static inline double solid_volume(const gmds_walls *walls, const double *points, size_t r)
{
  const gmds_complex *c = walls->complex;
  double sum = 0;
  if (c->first_wall[r] == c->first_wall[r + 1])
    return 0;
  const double *o = points + 3 * (size_t)gmds_wall_node(walls, c->first_wall[r], 0);
  for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
    const size_t n = gmds_wall_sides(walls, w);
    double centre[3], x[3], a[3], b[3];
    wall_centre(walls, points, w, centre);
    vector_to(o, centre, x);
    for (size_t k = 0; k < n; k++) {
      vector_to(o, points + 3 * (size_t)gmds_wall_node(walls, w, k), a);
      vector_to(o, points + 3 * (size_t)gmds_wall_node(walls, w, k + 1 < n ? k + 1 : 0), b);
      sum += triple(x, a, b);
    }
  }
  return sum / 6;
}

#endif
