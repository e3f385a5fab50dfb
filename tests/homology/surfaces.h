/* Surfaces for the tests of homology: quotients of a grid, and faces drawn at random. */
#ifndef GMDS_TESTS_SURFACES_H
#define GMDS_TESTS_SURFACES_H

#include "harness.h"
#include "rank.h"

/* How the sides of an n × n grid of squares are identified. */
typedef enum shape { DISK, ANNULUS, MOEBIUS, TORUS, KLEIN, PROJECTIVE, SPHERE, N_SHAPES } shape;

static const size_t betti_of_shape[N_SHAPES][3] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 2, 1},
                                                   {1, 2, 1}, {1, 1, 1}, {1, 0, 1}};

static inline face_list new_faces(size_t n_vertices, size_t faces_, size_t corners)
{
  face_list f = {n_vertices, 0, malloc((faces_ + 1) * sizeof(size_t)), malloc((corners + 1) * sizeof(gmds_id))};
  f.begin[0] = 0;
  return f;
}

static inline void free_faces(face_list *f)
{
  free(f->begin);
  free(f->nodes);
}

/* A face, without vertices that are the one before; none where that leaves two. */
static inline void put_face(face_list *f, size_t n, const gmds_id *nodes)
{
  size_t end = f->begin[f->n];
  for (size_t k = 0; k < n; k++)
    if (nodes[k] != nodes[k ? k - 1 : n - 1])
      f->nodes[end++] = nodes[k];
  if (end < f->begin[f->n] + 3)
    return;
  f->n++;
  f->begin[f->n] = end;
}

/* The point that grid point (i, j) is the same as. */
static inline gmds_id grid_point(shape s, size_t n, size_t i, size_t j)
{
  switch (s) {
  case ANNULUS:
    i %= n;
    break;
  case MOEBIUS:
    if (i == n) {
      i = 0;
      j = n - j;
    }
    break;
  case TORUS:
    i %= n;
    j %= n;
    break;
  case KLEIN:
    j %= n;
    if (i == n) {
      i = 0;
      j = (n - j) % n;
    }
    break;
  case PROJECTIVE: /* opposite points of the rim */
    if ((i % n == 0 || j % n == 0) && n - i + (n + 1) * (n - j) < i + (n + 1) * j) {
      i = n - i;
      j = n - j;
    }
    break;
  case SPHERE: /* a tube with its ends drawn together */
    i = j % n == 0 ? 0 : i % n;
    break;
  default:
    break;
  }
  return (gmds_id)(i * (n + 1) + j);
}

/* Squares, or triangles of which every other has been turned round where `turned`. */
static inline face_list make_shape(shape s, size_t n, int triangles, int turned)
{
  face_list f = new_faces((n + 1) * (n + 1), 2 * n * n, 6 * n * n);
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < n; j++) {
      const gmds_id a = grid_point(s, n, i, j), b = grid_point(s, n, i + 1, j), c = grid_point(s, n, i + 1, j + 1),
                    d = grid_point(s, n, i, j + 1);
      const gmds_id square[4] = {a, b, c, d}, one[3] = {a, b, c}, other[3] = {turned ? c : a, turned ? a : c, d};
      if (triangles) {
        put_face(&f, 3, one);
        put_face(&f, 3, other);
      } else
        put_face(&f, 4, square);
    }
  return f;
}

/* At most n faces of 3 to `most` vertices, drawn from a few, with one or two faces an edge: pinched at many vertices,
 * with borders, of several components, mostly not orientable. */
static inline face_list draw_faces(uint64_t *seed, size_t n_vertices, size_t n, size_t most)
{
  face_list f = new_faces(n_vertices, n, n * most);
  unsigned char *sides = calloc(n_vertices * n_vertices, 1);
  for (size_t draw = 0; draw < n; draw++) {
    gmds_id v[16];
    const size_t sides_of = 3 + random_below(seed, most - 2);
    int fits = 1;
    for (size_t k = 0; k < sides_of; k++)
      v[k] = (gmds_id)random_below(seed, n_vertices);
    for (int pass = 1; pass >= -1; pass -= 2) /* counts the sides, and takes them back where they do not fit */
      if (pass == 1 || !fits)
        for (size_t k = 0; k < sides_of; k++) {
          const gmds_id a = v[k], b = v[(k + 1) % sides_of];
          unsigned char *side = &sides[(a < b ? a : b) * n_vertices + (a < b ? b : a)];
          *side = (unsigned char)(*side + pass);
          fits &= a != b && *side <= 2;
        }
    if (fits)
      put_face(&f, sides_of, v);
  }
  free(sides);
  return f;
}

#endif
