/* Measures of single cells, and the histogram of many. */
#include "solid.h"
#include <gmds/quality.h>

static const double pi = 3.14159265358979323846;

static double over(double a, double b)
{
  return b > 0 ? a / b : 0;
}

/* ---- faces */

/* The vector from node a to node b, in the plane with a third component of 0. */
static void side(int dim, const double *points, gmds_id a, gmds_id b, double ab[3])
{
  ab[2] = 0;
  for (int d = 0; d < dim; d++)
    ab[d] = points[(size_t)dim * b + (size_t)d] - points[(size_t)dim * a + (size_t)d];
}

/* Twice the area as a vector. */
static void normal_of(int dim, const double *points, size_t n, const gmds_id *nodes, double normal[3])
{
  normal[0] = normal[1] = normal[2] = 0;
  for (size_t k = 1; k + 1 < n; k++) {
    double a[3], b[3], ab[3];
    side(dim, points, nodes[0], nodes[k], a);
    side(dim, points, nodes[0], nodes[k + 1], b);
    cross(a, b, ab);
    for (int d = 0; d < 3; d++)
      normal[d] += ab[d];
  }
}

double gmds_face_area(int dim, const double *points, size_t n, const gmds_id *nodes)
{
  double normal[3];
  normal_of(dim, points, n, nodes, normal);
  return (dim == 2 ? normal[2] : sqrt(dot(normal, normal))) / 2;
}

static double scaled_corners(int dim, const double *points, const gmds_id *nodes)
{
  double normal[3] = {0, 0, 1}, least = 1;
  if (dim == 3)
    normal_of(dim, points, 4, nodes, normal);
  const double length = sqrt(dot(normal, normal));
  for (size_t k = 0; k < 4; k++) {
    double a[3], b[3], ab[3];
    side(dim, points, nodes[k], nodes[(k + 1) % 4], a);
    side(dim, points, nodes[k], nodes[(k + 3) % 4], b);
    cross(a, b, ab);
    const double corner = over(dot(ab, normal), length * sqrt(dot(a, a)) * sqrt(dot(b, b)));
    least = corner < least ? corner : least;
  }
  return least;
}

double gmds_face_quality(int dim, const double *points, size_t n, const gmds_id *nodes)
{
  if (n == 4)
    return scaled_corners(dim, points, nodes);
  const double area = gmds_face_area(dim, points, n, nodes);
  double squares = 0, perimeter = 0, ab[3];
  for (size_t k = 0; k < n; k++) {
    side(dim, points, nodes[k], nodes[k + 1 < n ? k + 1 : 0], ab);
    squares += dot(ab, ab);
    perimeter += sqrt(dot(ab, ab));
  }
  return n == 3 ? over(4 * sqrt(3) * area, squares)
                : over(4 * (double)n * tan(pi / (double)n) * area, perimeter * perimeter);
}

/* ---- regions */

double gmds_region_volume(const gmds_walls *walls, const double *points, size_t r)
{
  return solid_volume(walls, points, r);
}

static double tetrahedron(const double *points, const gmds_id *v)
{
  double edge[3][3], squares = 0;
  for (int k = 0; k < 3; k++)
    vector_to(points + 3 * (size_t)v[0], points + 3 * (size_t)v[k + 1], edge[k]);
  for (int k = 0; k < 3; k++) {
    double other[3];
    vector_to(edge[k], edge[(k + 1) % 3], other);
    squares += dot(edge[k], edge[k]) + dot(other, other);
  }
  const double six = triple(edge[0], edge[1], edge[2]), root = cbrt(fabs(six) / 2);
  return over((six < 0 ? -12 : 12) * root * root, squares);
}

/* The triple product of the unit edges at a corner. */
static double scaled(double edge[3][3])
{
  return over(triple(edge[0], edge[1], edge[2]),
              sqrt(dot(edge[0], edge[0])) * sqrt(dot(edge[1], edge[1])) * sqrt(dot(edge[2], edge[2])));
}

/* The mean ratio of a corner of a pyramid's base, its edges to the neighbours in the base and to the apex: 3 det^(2/3)
 * / the square of the Frobenius norm of the matrix that takes the ideal corner to this one. */
static double base_corner(double edge[3][3])
{
  double up[3], squares = dot(edge[0], edge[0]) + dot(edge[1], edge[1]);
  for (int d = 0; d < 3; d++)
    up[d] = sqrt(2) * (edge[2][d] - (edge[0][d] + edge[1][d]) / 2);
  const double det = triple(edge[0], edge[1], up), root = cbrt(fabs(det));
  return over((det < 0 ? -3 : 3) * root * root, squares + dot(up, up));
}

static double polyhedron(const gmds_walls *walls, const double *points, size_t r)
{
  const gmds_complex *c = walls->complex;
  const double volume = solid_volume(walls, points, r);
  double area = 0;
  for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
    const size_t n = gmds_wall_sides(walls, w);
    double centre[3], a[3], b[3], ab[3];
    wall_centre(walls, points, w, centre);
    for (size_t k = 0; k < n; k++) {
      vector_to(centre, points + 3 * (size_t)gmds_wall_node(walls, w, k), a);
      vector_to(centre, points + 3 * (size_t)gmds_wall_node(walls, w, k + 1 < n ? k + 1 : 0), b);
      cross(a, b, ab);
      area += sqrt(dot(ab, ab)) / 2;
    }
  }
  return over((volume < 0 ? -36 : 36) * pi * volume * volume, area * area * area);
}

double gmds_region_quality(const gmds_walls *walls, const double *points, size_t r)
{
  const gmds_complex *c = walls->complex;
  const gmds_cell_type type = (gmds_cell_type)c->types[r];
  const gmds_id *nodes = c->nodes[3].data + c->nodes[3].begin[r];
  uint8_t corner[SOLID_CORNERS][4];
  const size_t n = solid_corners(type, corner);
  double least = 1;
  if (type == GMDS_TETRAHEDRON)
    return tetrahedron(points, nodes);
  if (!n)
    return polyhedron(walls, points, r);
  for (size_t k = 0; k < n; k++) {
    double edge[3][3];
    for (int i = 0; i < 3; i++)
      vector_to(points + 3 * (size_t)nodes[corner[k][0]], points + 3 * (size_t)nodes[corner[k][i + 1]], edge[i]);
    const double value =
        type == GMDS_PYRAMID ? base_corner(edge) : scaled(edge) * (type == GMDS_PRISM ? 2 / sqrt(3) : 1);
    least = value < least ? value : least;
  }
  return least;
}

/* ---- many */

typedef struct tally {
  gmds_quality q;
  size_t numbers;
} tally;

static void count(tally *t, size_t x, double value, double size)
{
  gmds_quality *q = &t->q;
  q->cells++;
  q->size += size;
  if (value > 0)
    q->bins[value < 1 ? (size_t)(value * GMDS_QUALITY_BINS) : GMDS_QUALITY_BINS - 1]++;
  else
    q->inverted++;
  if (isnan(value))
    return;
  if (!t->numbers || value < q->min) {
    q->min = value;
    q->worst = (gmds_id)x;
  }
  q->max = !t->numbers || value > q->max ? value : q->max;
  q->mean += value;
  t->numbers++;
}

static void finish(tally *t, gmds_quality *summary)
{
  if (t->numbers)
    t->q.mean /= (double)t->numbers;
  if (summary)
    *summary = t->q;
}

static void keep(size_t x, double value, double size, double *values, double *sizes)
{
  if (values)
    values[x] = value;
  if (sizes)
    sizes[x] = size;
}

void gmds_quality_of_faces(int dim, const double *points, const gmds_csr *faces, int ordered, double *values,
                           double *sizes, gmds_quality *summary)
{
  tally t = {.q = {.worst = GMDS_NONE}};
  for (size_t f = 0; f < faces->n; f++) {
    const size_t n = faces->begin[f + 1] - faces->begin[f];
    double value = 0, size = 0;
    if (n) {
      const gmds_id *nodes = faces->data + faces->begin[f];
      value = gmds_face_quality(dim, points, n, nodes);
      size = gmds_face_area(dim, points, n, nodes);
      value = ordered ? value : fabs(value);
      size = ordered ? size : fabs(size);
      count(&t, f, value, size);
    }
    keep(f, value, size, values, sizes);
  }
  finish(&t, summary);
}

void gmds_quality_of_regions(const gmds_walls *walls, const double *points, double *values, double *sizes,
                             gmds_quality *summary)
{
  const gmds_complex *c = walls->complex;
  tally t = {.q = {.worst = GMDS_NONE}};
  for (size_t r = 0; r < c->nodes[3].n; r++) {
    double value = 0, size = 0;
    if (c->nodes[3].begin[r] < c->nodes[3].begin[r + 1]) {
      value = gmds_region_quality(walls, points, r);
      size = gmds_region_volume(walls, points, r);
      count(&t, r, value, size);
    }
    keep(r, value, size, values, sizes);
  }
  finish(&t, summary);
}
