/* Writers of meshes: OFF, VTK legacy (ASCII), Medit. A soup in a plane gets a third coordinate 0 where the format has
 * no plane. */
#include "writers.h"

void gmds_write_off(FILE *file, const gmds_soup *soup)
{
  fprintf(file, "OFF\n%zu %zu 0\n", soup->n_points, soup->n_cells);
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(file, soup, p, 3);
    putc('\n', file);
  }
  for (size_t c = 0; c < soup->n_cells; c++) {
    fprintf(file, "%zu", soup->begin[c + 1] - soup->begin[c]);
    gmds_put_corners(file, soup, c, 0);
    putc('\n', file);
  }
}

/* X(type, VTK's number for it) */
#define VTK_NUMBER_LIST(X) \
  X(GMDS_VERTEX, 1)        \
  X(GMDS_SEGMENT, 3)       \
  X(GMDS_TRIANGLE, 5)      \
  X(GMDS_QUADRILATERAL, 9) \
  X(GMDS_POLYGON, 7)       \
  X(GMDS_TETRAHEDRON, 10)  \
  X(GMDS_PYRAMID, 14)      \
  X(GMDS_PRISM, 13)        \
  X(GMDS_HEXAHEDRON, 12)

void gmds_write_vtk(FILE *file, const gmds_soup *soup)
{
#define ROW(type, number) [type] = number,
  static const int numbers[GMDS_CELL_TYPE_COUNT] = {VTK_NUMBER_LIST(ROW)};
#undef ROW
  size_t corners = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  fprintf(file, "# vtk DataFile Version 3.0\ngmds\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %zu double\n",
          soup->n_points);
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(file, soup, p, 3);
    putc('\n', file);
  }
  fprintf(file, "CELLS %zu %zu\n", soup->n_cells, soup->n_cells + corners);
  for (size_t c = 0; c < soup->n_cells; c++) {
    fprintf(file, "%zu", soup->begin[c + 1] - soup->begin[c]);
    gmds_put_corners(file, soup, c, 0);
    putc('\n', file);
  }
  fprintf(file, "CELL_TYPES %zu\n", soup->n_cells);
  for (size_t c = 0; c < soup->n_cells; c++)
    fprintf(file, "%d\n", numbers[soup->types[c]]);
}

/* X(type, keyword) */
#define MEDIT_KEYWORD_LIST(X)             \
  X(GMDS_SEGMENT, "Edges")                \
  X(GMDS_TRIANGLE, "Triangles")           \
  X(GMDS_QUADRILATERAL, "Quadrilaterals") \
  X(GMDS_TETRAHEDRON, "Tetrahedra")       \
  X(GMDS_PYRAMID, "Pyramids")             \
  X(GMDS_PRISM, "Prisms")                 \
  X(GMDS_HEXAHEDRON, "Hexahedra")

static void write_medit_cells(FILE *file, const gmds_soup *soup, gmds_cell_type type, const char *keyword)
{
  size_t n = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    n += soup->types[c] == type;
  if (!n)
    return;
  fprintf(file, "%s\n%zu\n", keyword, n);
  for (size_t c = 0; c < soup->n_cells; c++)
    if (soup->types[c] == type) {
      gmds_put_corners(file, soup, c, 1);
      fputs(" 0\n", file);
    }
}

void gmds_write_medit(FILE *file, const gmds_soup *soup)
{
  fprintf(file, "MeshVersionFormatted 2\nDimension %d\nVertices\n%zu\n", soup->dim, soup->n_points);
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(file, soup, p, soup->dim);
    fputs(" 0\n", file);
  }
#define WRITE(type, keyword) write_medit_cells(file, soup, type, keyword);
  MEDIT_KEYWORD_LIST(WRITE)
#undef WRITE
  fputs("End\n", file);
}
