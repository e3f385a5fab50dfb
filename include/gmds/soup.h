/* A soup: points and cells as lists of points, as files hold them. What readers give and writers take; a mesh of any
 * model is made from one (<prefix>_from_soup) and gives one (<prefix>_to_soup). */
#ifndef GMDS_SOUP_H
#define GMDS_SOUP_H

#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, dimension, number of points (0: any), text). Points of a cell are listed in VTK's order. */
#define GMDS_CELL_TYPE_LIST(X)                 \
  X(GMDS_VERTEX, 0, 1, "vertex")               \
  X(GMDS_SEGMENT, 1, 2, "edge")                \
  X(GMDS_TRIANGLE, 2, 3, "triangle")           \
  X(GMDS_QUADRILATERAL, 2, 4, "quadrilateral") \
  X(GMDS_POLYGON, 2, 0, "polygon")             \
  X(GMDS_TETRAHEDRON, 3, 4, "tetrahedron")     \
  X(GMDS_PYRAMID, 3, 5, "pyramid")             \
  X(GMDS_PRISM, 3, 6, "prism")                 \
  X(GMDS_HEXAHEDRON, 3, 8, "hexahedron")       \
  X(GMDS_POLYHEDRON, 3, 0, "polyhedron")

#define GMDS_CELL_TYPE_ENUM_(name, dim, points, text) name,
typedef enum gmds_cell_type { GMDS_CELL_TYPE_LIST(GMDS_CELL_TYPE_ENUM_) GMDS_CELL_TYPE_COUNT } gmds_cell_type;
#undef GMDS_CELL_TYPE_ENUM_

int gmds_cell_type_dimension(gmds_cell_type type);    /* 0 to 3 */
int gmds_cell_type_points(gmds_cell_type type);       /* how many points, 0 for a polygon: any number from 3 */
const char *gmds_cell_type_text(gmds_cell_type type); /* never NULL */

typedef struct gmds_soup {
  gmds_memory *memory; /* where the arrays come from; outlives the soup */
  int dim;             /* coordinates a point: 2 or 3 */
  size_t n_points;
  double *points; /* n_points × dim, row major */
  size_t n_cells;
  uint8_t *types;   /* n_cells: gmds_cell_type */
  size_t *begin;    /* n_cells + 1: cell c has entries begin[c] to begin[c + 1] of `corners`; NULL when n_cells is 0
                       and nothing was reserved */
  gmds_id *corners; /* begin[n_cells] indices of points */
  size_t point_capacity, cell_capacity, corner_capacity;
  size_t degenerate; /* cells that a reader left out because two of their points are the same */
} gmds_soup;

/* An empty soup. Allocates nothing. */
void gmds_soup_init(gmds_soup *soup, gmds_memory *memory, int dim);
void gmds_soup_clear(gmds_soup *soup);

/* Room for this many points, cells and corners in all, exactly. GMDS_OK or GMDS_ERR_MEMORY; the content is unchanged.
 */
gmds_status gmds_soup_reserve(gmds_soup *soup, size_t points, size_t cells, size_t corners);

/* Appends a point of soup->dim coordinates, or a cell of n corners. Amortised constant time a number.
 * GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; for a cell also GMDS_ERR_ARGUMENT (n is not of the type) and
 * GMDS_ERR_CELL (a corner that is no point of the soup). On failure nothing is appended. */
gmds_status gmds_soup_add_point(gmds_soup *soup, const double *x);
gmds_status gmds_soup_add_cell(gmds_soup *soup, gmds_cell_type type, size_t n, const gmds_id *corners);

/* Drops capacity beyond the content. */
void gmds_soup_trim(gmds_soup *soup);

/* How many cells of dimension 0 to 3 there are. O(cells). */
void gmds_soup_count(const gmds_soup *soup, size_t count[4]);

#ifdef __cplusplus
}
#endif
#endif
