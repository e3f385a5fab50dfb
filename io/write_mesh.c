/* Writers of meshes as text: OFF and Medit. A soup in a plane gets a third coordinate 0 where the format has no plane.
 */
#include "writers.h"
#include <string.h>

gmds_status gmds_write_off(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  FILE *file = sink->file;
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
  return GMDS_OK;
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

static void write_medit_cells(const gmds_sink *sink, gmds_cell_type type, const char *keyword)
{
  const gmds_soup *soup = sink->soup;
  const gmds_attribute *reference = gmds_soup_find_attribute(soup, GMDS_OF_CELLS, "ref");
  if (reference && !gmds_medit_holds(soup, GMDS_OF_CELLS, reference))
    reference = NULL;
  size_t n = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    n += soup->types[c] == type;
  if (!n)
    return;
  fprintf(sink->file, "%s\n%zu\n", keyword, n);
  for (size_t c = 0; c < soup->n_cells; c++)
    if (soup->types[c] == type) {
      gmds_put_corners(sink->file, soup, c, 1);
      fprintf(sink->file, " %d\n", gmds_reference(reference, c));
    }
}

gmds_status gmds_write_medit(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  const gmds_attribute *reference = gmds_soup_find_attribute(soup, GMDS_OF_POINTS, "ref");
  if (reference && !gmds_medit_holds(soup, GMDS_OF_POINTS, reference))
    reference = NULL;
  fprintf(sink->file, "MeshVersionFormatted 2\nDimension %d\nVertices\n%zu\n", soup->dim, soup->n_points);
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(sink->file, soup, p, soup->dim);
    fprintf(sink->file, " %d\n", gmds_reference(reference, p));
  }
#define WRITE(type, keyword) write_medit_cells(sink, type, keyword);
  MEDIT_KEYWORD_LIST(WRITE)
#undef WRITE
  fputs("End\n", sink->file);
  return GMDS_OK;
}

int gmds_medit_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  return strcmp(attribute->name, "ref") == 0 && gmds_is_reference(soup, place, attribute);
}
