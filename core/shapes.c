/* Local numbering of regions, finding it again from their faces, and turning it outwards. */
#include "solid.h"
#include <gmds/predicates.h>
#include <gmds/shapes.h>

/* The rows are a table. */
/* clang-format off */
static const gmds_shape shapes[] = {
  {4, 6, 4, {{0,1}, {1,2}, {2,0}, {0,3}, {1,3}, {2,3}},
   {3, 3, 3, 3},
   {{0,1,3}, {1,2,3}, {2,0,3}, {0,2,1}},
   {{0,4,3}, {1,5,4}, {2,3,5}, {2,1,0}}},
  {5, 8, 5, {{0,1}, {1,2}, {2,3}, {3,0}, {0,4}, {1,4}, {2,4}, {3,4}},
   {4, 3, 3, 3, 3},
   {{0,3,2,1}, {0,1,4}, {1,2,4}, {2,3,4}, {3,0,4}},
   {{3,2,1,0}, {0,5,4}, {1,6,5}, {2,7,6}, {3,4,7}}},
  {6, 9, 5, {{0,1}, {1,2}, {2,0}, {3,4}, {4,5}, {5,3}, {0,3}, {1,4}, {2,5}},
   {3, 3, 4, 4, 4},
   {{0,2,1}, {3,4,5}, {0,1,4,3}, {1,2,5,4}, {2,0,3,5}},
   {{2,1,0}, {3,4,5}, {0,7,3,6}, {1,8,4,7}, {2,6,5,8}}},
  {8, 12, 6, {{0,1}, {1,2}, {3,2}, {0,3}, {4,5}, {5,6}, {7,6}, {4,7}, {0,4}, {1,5}, {3,7}, {2,6}},
   {4, 4, 4, 4, 4, 4},
   {{0,4,7,3}, {1,2,6,5}, {0,1,5,4}, {3,7,6,2}, {0,3,2,1}, {4,5,6,7}},
   {{8,7,10,3}, {1,11,5,9}, {0,9,4,8}, {10,6,11,2}, {3,2,1,0}, {4,5,6,7}}},
};
static const uint8_t base_of[] = {3, 0, 0, 4}; /* the face 0 2 1 or 0 3 2 1 */
/* clang-format on */

const gmds_shape *gmds_shape_of(gmds_cell_type type)
{
  return type >= GMDS_TETRAHEDRON && type <= GMDS_HEXAHEDRON ? &shapes[type - GMDS_TETRAHEDRON] : NULL;
}

static int has(const gmds_id *list, size_t n, gmds_id x)
{
  for (size_t k = 0; k < n; k++)
    if (list[k] == x)
      return 1;
  return 0;
}

/* The node beside v around one of the faces that is none of the n nodes of the base, or GMDS_NONE. */
static gmds_id above(const gmds_shape *s, const size_t *faces, const gmds_id *corners, const gmds_id *base, size_t n,
                     gmds_id v)
{
  for (size_t k = 0; k < s->faces; k++) {
    const gmds_id *row = corners + faces[k];
    size_t sides = faces[k + 1] - faces[k];
    for (size_t i = 0; i < sides; i++)
      for (size_t by = 1; by < sides && row[i] == v; by += sides - 2) {
        gmds_id beside = row[(i + by) % sides];
        if (!has(base, n, beside))
          return beside;
      }
  }
  return GMDS_NONE;
}

/* Whether one of the faces is local face k: the same nodes around it, from any of them on and either way. */
static int is_there(const gmds_shape *s, size_t k, const size_t *faces, const gmds_id *corners, const gmds_id *nodes)
{
  for (size_t f = 0; f < s->faces; f++) {
    const gmds_id *row = corners + faces[f];
    const size_t n = faces[f + 1] - faces[f];
    size_t at = 0, forwards = 0, backwards = 0;
    while (at < n && row[at] != nodes[s->face[k][0]])
      at++;
    for (size_t i = 0; i < n && n == s->sides[k] && at < n; i++) {
      forwards += row[(at + i) % n] == nodes[s->face[k][i]];
      backwards += row[(at + n - i) % n] == nodes[s->face[k][i]];
    }
    if (n == s->sides[k] && (forwards == n || backwards == n))
      return 1;
  }
  return 0;
}

/* Whether there are as many triangles and quadrilaterals among the faces as in the shape, and nothing else. */
static int has_sides(const gmds_shape *s, const size_t *faces)
{
  int triangles = 0;
  for (size_t f = 0; f < s->faces; f++) {
    const size_t n = faces[f + 1] - faces[f];
    if (n != 3 && n != 4)
      return 0;
    triangles += (n == 3) - (s->sides[f] == 3);
  }
  return triangles == 0;
}

gmds_status gmds_shape_from_faces(gmds_cell_type type, const size_t *faces, const gmds_id *corners, gmds_id *nodes)
{
  const gmds_shape *s = gmds_shape_of(type);
  if (!s || !has_sides(s, faces))
    return GMDS_ERR_INVARIANT;
  const uint8_t base = base_of[type - GMDS_TETRAHEDRON];
  const size_t n = s->sides[base];
  gmds_id found[GMDS_SHAPE_NODES];
  size_t first = 0;
  while (faces[first + 1] - faces[first] != n)
    first++;
  for (size_t i = 0; i < n; i++)
    found[s->face[base][i]] = corners[faces[first] + i];
  for (size_t i = n; i < s->nodes; i++)
    found[i] = above(s, faces, corners, found, n, found[i - n]);
  for (size_t k = 0; k < s->faces; k++)
    if (!is_there(s, k, faces, corners, found))
      return GMDS_ERR_INVARIANT;
  for (size_t i = 0; i < s->nodes; i++)
    nodes[i] = found[i];
  return GMDS_OK;
}

/* Six times the volume that a region encloses, its faces cut into triangles. */
static double enclosed(const gmds_shape *s, const double *points, const gmds_id *nodes)
{
  const double *o = points + 3 * (size_t)nodes[0];
  double sum = 0;
  for (size_t k = 0; k < s->faces; k++)
    for (size_t q = 1; q + 1 < s->sides[k]; q++) {
      const size_t at[3] = {s->face[k][0], s->face[k][q], s->face[k][q + 1]};
      double x[3][3];
      for (int i = 0; i < 3; i++)
        vector_to(o, points + 3 * (size_t)nodes[at[i]], x[i]);
      sum += triple(x[0], x[1], x[2]);
    }
  return sum;
}

static int is_inwards(gmds_cell_type type, const double *points, const gmds_id *nodes)
{
  const gmds_shape *s = gmds_shape_of(type);
  uint8_t corner[SOLID_CORNERS][4];
  const size_t corners = solid_corners(type, corner);
  int turns = 0;
  for (size_t i = 0; i < s->nodes; i++)
    for (size_t d = 0; d < 3; d++)
      if (!isfinite(points[3 * (size_t)nodes[i] + d]))
        return 0;
  for (size_t k = 0; k < corners; k++) {
    const double *x[4];
    for (int i = 0; i < 4; i++)
      x[i] = points + 3 * (size_t)nodes[corner[k][i]];
    turns += gmds_orient3d(x[0], x[1], x[2], x[3]);
  }
  return turns < 0 || (turns == 0 && type != GMDS_TETRAHEDRON && enclosed(s, points, nodes) < 0);
}

void gmds_shape_turn_outwards(gmds_cell_type type, const double *points, gmds_id *nodes)
{
  const gmds_shape *s = gmds_shape_of(type);
  if (!s || !is_inwards(type, points, nodes))
    return;
  const size_t opposite = type == GMDS_TETRAHEDRON || type == GMDS_PRISM ? 2 : 3; /* of node 1 in its base */
  const size_t bases = type == GMDS_PRISM || type == GMDS_HEXAHEDRON ? 2 : 1;
  for (size_t k = 0; k < bases; k++) {
    gmds_id *base = nodes + k * (opposite + 1), swap = base[1];
    base[1] = base[opposite];
    base[opposite] = swap;
  }
}
