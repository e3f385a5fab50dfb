/* A closed surface on an integer lattice: which cells of an octree it cuts, and which lie inside, exactly, so that
 * whoever computes it finds the same.
 *
 * The vertices are snapped to a lattice over the bounding box, which is widened by a margin. The box is a grid of base
 * cells, each 2^bits steps wide along every axis, and a cell of level l is one of those that l halvings of the base
 * cells make. From there on all is integers: after gmds_lattice_of_surface no result depends on rounding, on the order
 * of the triangles, or on who asks.
 *
 * What is exact, of the snapped surface (its triangles with their corners on the lattice, a closed set):
 * - a cell is cut if and only if its closed box and a closed triangle have a point in common, flat triangles included;
 * - the winding number of the centre of a cell, the centre being moved by (e, e^2, e^3) for an infinitely small e > 0.
 *   Its parity is that of the crossings of any path to infinity, since every edge has two faces: it never contradicts
 *   itself, and a cell is inside where it is odd. All points of a cell that is not cut lie on the side of its centre,
 *   and two such cells that touch lie on the same side. The number itself says more where the faces are turned alike
 *   (n_turned is 0): 1 inside a surface turned outwards, and another number than 0 and 1 where it crosses itself,
 *   encloses a part of itself, or is turned inwards (-1). */
#ifndef GMDS_LATTICE_H
#define GMDS_LATTICE_H

#include <gmds/hops.h>
#include <gmds/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  GMDS_LATTICE_BITS = 30,       /* coordinates on the lattice are from 0 to 2^30 */
  GMDS_LATTICE_MAX_BASE = 16384 /* base cells along an axis */
};

/* Owned by its maker, who clears it; does not change, and may be read from any number of threads. */
typedef struct gmds_lattice {
  gmds_memory *memory;
  uint32_t base[3]; /* base cells along each axis */
  unsigned bits;    /* a base cell is 2^bits steps wide: as many as leave base << bits at most 2^30 */
  double low[3];    /* the corner of the box */
  double step[3];   /* the distance of two lattice points along each axis */
  size_t n_triangles;
  int32_t *triangles;   /* n_triangles × 3 × 3: the corners of each in steps, from 0 to base << bits */
  double snap_error[3]; /* the largest distance of a vertex and its lattice point along each axis */
  size_t n_degenerate;  /* triangles that snapping, or the input, made flat: they cut cells and part no sides */
  size_t n_turned;      /* edges along which both faces run the same way: windings count by parity alone */
} gmds_lattice;

typedef struct gmds_lattice_options {
  uint32_t base[3];  /* base cells along each axis, 0: 1; up to GMDS_LATTICE_MAX_BASE */
  double margin;     /* by how much of its extent the bounding box is widened at either end, up to 1; 0: 1/128 */
  unsigned threads;  /* from 1 to GMDS_MAX_THREADS, 0: 1; the result does not depend on it */
  gmds_error *error; /* receives the sentence of a failure; may be NULL */
} gmds_lattice_options;

/* A cell: position at[a], from 0 to (base[a] << level) - 1, among the cells of its level, from 0 to bits - 1. */
typedef struct gmds_lattice_cell {
  uint32_t at[3];
  uint32_t level;
} gmds_lattice_cell;

typedef enum gmds_lattice_state { GMDS_LATTICE_OUTSIDE, GMDS_LATTICE_INSIDE, GMDS_LATTICE_CUT } gmds_lattice_state;

/* No triangle. Allocates nothing. */
void gmds_lattice_init(gmds_lattice *lattice, gmds_memory *memory);
void gmds_lattice_clear(gmds_lattice *lattice);

/* Snaps a closed surface. points: surface->n_vertices × 3, row major; those that no face has do not count. Polygons
 * become fans of triangles about their first corner. options: may be NULL. The lattice is initialised and empty.
 * GMDS_OK; GMDS_ERR_ARGUMENT (no face; an edge of one face, which the sentence names; no extent along an axis, or one
 * that doubles cannot divide; an option out of its range); GMDS_ERR_COORDINATE (the sentence names the vertex);
 * GMDS_ERR_MEMORY. The lattice stays empty. O(darts + vertices). */
gmds_status gmds_lattice_of_surface(gmds_lattice *lattice, const gmds_surface *surface, const double *points,
                                    const gmds_lattice_options *options);

/* The same of the faces of a soup of dimension 3. Also GMDS_ERR_ARGUMENT (another dimension; a face of fewer than three
 * corners or with one twice in a row), GMDS_ERR_CONFLICT (an edge of three faces, which the sentence names),
 * GMDS_ERR_UNSUPPORTED (a cell of a volume), GMDS_ERR_TOO_MANY. Working space: a gmds_surface. */
gmds_status gmds_lattice_of_soup(gmds_lattice *lattice, const gmds_soup *soup, const gmds_lattice_options *options);

/* The coordinates of a lattice point, at[a] from 0 to base[a] << bits: low + at × step, and so the same for whoever
 * computes them, by whatever midpoints. Where the box lies 2^22 of its sizes from the origin or farther, points of the
 * lattice share doubles. O(1). */
void gmds_lattice_point(const gmds_lattice *lattice, const uint32_t at[3], double x[3]);

/* The width of the cells of a level in steps. */
static inline uint32_t gmds_lattice_width(const gmds_lattice *lattice, unsigned level)
{
  return (uint32_t)1 << (lattice->bits - level);
}

/* The closed box of a cell in steps. */
static inline void gmds_lattice_bounds(const gmds_lattice *lattice, gmds_lattice_cell cell, int32_t low[3],
                                       int32_t high[3])
{
  const uint32_t width = gmds_lattice_width(lattice, cell.level);
  for (int a = 0; a < 3; a++) {
    low[a] = (int32_t)(cell.at[a] * width);
    high[a] = (int32_t)((cell.at[a] + 1) * width);
  }
}

/* Where a point of this winding number lies. */
static inline gmds_lattice_state gmds_lattice_side(int32_t winding)
{
  return winding & 1 ? GMDS_LATTICE_INSIDE : GMDS_LATTICE_OUTSIDE;
}

/* Whether a closed box of lattice points, low[a] <= high[a], and a closed triangle (3 × 3, row major) that may be flat
 * have a point in common. All coordinates are from 0 to 2^30. The thirteen separating axes, in integers. O(1). */
int gmds_lattice_meets(const int32_t low[3], const int32_t high[3], const int32_t triangle[9]);

/* Base cells, numbered i + A (j + B k): row c - first of `triangles` are those that cell c meets, ascending. */
typedef struct gmds_lattice_roots {
  size_t first;
  gmds_csr triangles;
  int32_t *winding; /* as many as rows: of the centre, along a ray in the direction of x over all triangles */
} gmds_lattice_roots;

/* No cell. Allocates nothing. */
void gmds_lattice_roots_init(gmds_lattice_roots *roots, gmds_memory *memory);
void gmds_lattice_roots_clear(gmds_lattice_roots *roots);

/* The base cells from number `first` to `end` - 1: those that a rank is to refine, or all. The roots are initialised
 * and empty. GMDS_OK; GMDS_ERR_ARGUMENT (no such cells); GMDS_ERR_MEMORY (they stay empty). O(triangles + base cells in
 * the boxes of triangles). */
gmds_status gmds_lattice_find_roots(const gmds_lattice *lattice, size_t first, size_t end, gmds_lattice_roots *roots);

/* The position of base cell number c, as a cell of level 0. */
static inline gmds_lattice_cell gmds_lattice_base(const gmds_lattice *lattice, size_t c)
{
  const size_t row = c / lattice->base[0];
  const gmds_lattice_cell cell = {
      {(uint32_t)(c % lattice->base[0]), (uint32_t)(row % lattice->base[1]), (uint32_t)(row / lattice->base[1])}, 0};
  return cell;
}

/* The eight children of a cell: bit a of the number of a child says in which half along axis a it lies. */
typedef struct gmds_lattice_octants {
  unsigned cut;       /* bit c: child c meets a triangle */
  int32_t winding[8]; /* of the centre of each */
  size_t begin[9];    /* the triangles of child c are begin[c] to begin[c + 1] - 1 of the list they were appended to */
} gmds_lattice_octants;

/* Child c of a cell. */
static inline gmds_lattice_cell gmds_lattice_child(gmds_lattice_cell cell, unsigned c)
{
  const gmds_lattice_cell child = {{2 * cell.at[0] + (c & 1), 2 * cell.at[1] + (c >> 1 & 1), 2 * cell.at[2] + (c >> 2)},
                                   cell.level + 1};
  return child;
}

/* Divides a cell: which children are cut, the windings of their centres, and the triangles of each, ascending if those
 * of the cell are. winding: of the cell's centre. triangles: n of them, among them all that the cell meets. keep: bit c
 * says that the triangles of child c are wanted; where it is 0 for all, nothing is allocated, and lists may be NULL.
 * lists: what the triangles are appended to, in the order of the children; not the list that `triangles` lies in. Calls
 * with different lists may run at once.
 * GMDS_OK; GMDS_ERR_ARGUMENT (no such cell, or its children would have no centre on the lattice: the cell's level is
 * bits - 1); GMDS_ERR_MEMORY (the list is as it was). O(n). */
gmds_status gmds_lattice_split(const gmds_lattice *lattice, gmds_lattice_cell cell, int32_t winding, size_t n,
                               const gmds_id *triangles, unsigned keep, gmds_ids *lists, gmds_lattice_octants *octants);

typedef struct gmds_lattice_leaf {
  uint32_t at[3];
  uint8_t level;
  uint8_t state; /* gmds_lattice_state */
} gmds_lattice_leaf;

/* The leaves of an octree over every base cell. */
typedef struct gmds_lattice_leaves {
  gmds_memory *memory;
  size_t n, capacity;
  gmds_lattice_leaf *leaf; /* n: by level, within it by the order of their parents, then by number of child */
  size_t count[3];         /* how many there are in each state */
  int32_t lowest, highest; /* winding of those that are not cut: see n_turned */
} gmds_lattice_leaves;

/* No leaf. Allocates nothing. */
void gmds_lattice_leaves_init(gmds_lattice_leaves *leaves, gmds_memory *memory);
void gmds_lattice_leaves_clear(gmds_lattice_leaves *leaves);

/* Whether a cell is to be refined. */
typedef int gmds_lattice_decision(void *user, gmds_lattice_cell cell, gmds_lattice_state state);

/* Refines from the base cells on, level by level, every cell of a level below `depth` that `refine` asks for (NULL:
 * those that are cut). refine is called once for each such cell. depth: from 0 to bits - 1. The leaves are initialised
 * and empty; their memory is that of all working space.
 * GMDS_OK; GMDS_ERR_ARGUMENT (the depth); GMDS_ERR_MEMORY (they stay empty). O(cells + triangles, times the cells of
 * each level that they meet). */
gmds_status gmds_lattice_refine(const gmds_lattice *lattice, unsigned depth, gmds_lattice_decision *refine, void *user,
                                gmds_lattice_leaves *leaves);

#ifdef __cplusplus
}
#endif
#endif
