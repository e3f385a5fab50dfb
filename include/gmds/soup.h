/* A soup: points and cells as lists of points, as files hold them. What readers give and writers take; a mesh of any
 * model is made from one (<prefix>_from_soup) and gives one (<prefix>_to_soup). */
#ifndef GMDS_SOUP_H
#define GMDS_SOUP_H

#include <gmds/cells.h>
#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, dimension, number of points (0: any), text). Points of a cell are listed in VTK's order. A polyhedron is
 * listed as its faces are, VTK's face stream: the number of faces (4 or more), then for each face the number of its
 * points (3 or more) and these points; where its entries in `corners` are walked, the counts among them must be told
 * apart. */
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
int gmds_cell_type_points(gmds_cell_type type);       /* how many points, 0 for any number */
const char *gmds_cell_type_text(gmds_cell_type type); /* never NULL */

/* What an attribute's values stand beside. */
typedef enum gmds_place { GMDS_OF_POINTS, GMDS_OF_CELLS, GMDS_PLACE_COUNT } gmds_place;

typedef struct gmds_soup {
  gmds_memory *memory; /* where the arrays come from; outlives the soup */
  int dim;             /* coordinates a point: 2 or 3 */
  size_t n_points;
  double *points; /* n_points × dim, row major */
  size_t n_cells;
  uint8_t *types;   /* n_cells: gmds_cell_type */
  size_t *begin;    /* n_cells + 1: cell c has entries begin[c] to begin[c + 1] of `corners`; NULL when n_cells is 0
                       and nothing was reserved */
  gmds_id *corners; /* begin[n_cells] indices of points, and the counts of polyhedra */
  gmds_attribute *attributes[GMDS_PLACE_COUNT]; /* columns of values, a row a point or a cell, in the order they were
                                                   added: reference numbers of a file, solutions, ... */
  size_t point_capacity, cell_capacity, corner_capacity;
  size_t degenerate;         /* cells that a reader left out because two of their points are the same, */
  size_t degenerate_regions; /* and how many of them are of dimension 3 */
  size_t unread; /* arrays, names and the like that a reader left out because a soup has no place for them */
} gmds_soup;

/* An empty soup. Allocates nothing. */
void gmds_soup_init(gmds_soup *soup, gmds_memory *memory, int dim);
void gmds_soup_clear(gmds_soup *soup);

/* Room for this many points, cells and corners in all, exactly. GMDS_OK or GMDS_ERR_MEMORY; the content is unchanged.
 */
gmds_status gmds_soup_reserve(gmds_soup *soup, size_t points, size_t cells, size_t corners);

/* Appends a point of soup->dim coordinates, or a cell of n corners. Amortised constant time a number. The attributes of
 * what is appended are 0. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; for a cell also GMDS_ERR_ARGUMENT (n is not of
 * the type; the counts of a polyhedron do not add up) and GMDS_ERR_CELL (a corner that is no point of the soup). On
 * failure nothing is appended. */
gmds_status gmds_soup_add_point(gmds_soup *soup, const double *x);
gmds_status gmds_soup_add_cell(gmds_soup *soup, gmds_cell_type type, size_t n, const gmds_id *corners);

/* The points of a cell: as they are listed, those of a polyhedron once each, in ascending order. GMDS_OK or
 * GMDS_ERR_MEMORY. O(m log m) for a polyhedron of m entries. */
gmds_status gmds_soup_cell_points(const gmds_soup *soup, size_t cell, gmds_ids *points);

/* Adds a column of values, all 0, under a name not in use at its place; those of item i are from i * components on in
 * `data`, which moves when the soup grows. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_ARGUMENT (no name, no component, unknown
 * type or place); GMDS_ERR_CONFLICT (the name is taken). */
gmds_status gmds_soup_add_attribute(gmds_soup *soup, gmds_place place, const char *name, gmds_value type,
                                    size_t components, gmds_attribute **attribute);

/* The column of a name, or NULL. */
gmds_attribute *gmds_soup_find_attribute(const gmds_soup *soup, gmds_place place, const char *name);

/* Removes a column of this soup and frees it. */
void gmds_soup_remove_attribute(gmds_soup *soup, gmds_place place, gmds_attribute *attribute);

/* Drops capacity beyond the content. */
void gmds_soup_trim(gmds_soup *soup);

/* Hands over the array of corners, cut to its length: *n of them, to be freed as such in the soup's memory. The soup
 * has no cell left, the columns beside cells are empty. O(n) at most. */
gmds_id *gmds_soup_give_corners(gmds_soup *soup, size_t *n);

/* How many cells of dimension 0 to 3 there are. O(cells). */
void gmds_soup_count(const gmds_soup *soup, size_t count[4]);

#ifdef __cplusplus
}
#endif
#endif
