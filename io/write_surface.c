/* Writers of surfaces: OBJ and STL. The points of STL are the corners of its triangles alone. */
#include "writers.h"
#include <math.h>
#include <string.h>

gmds_status gmds_write_obj(const gmds_sink *sink)
{
  static const char keywords[] = {'p', 'l', 'f'};
  const gmds_soup *soup = sink->soup;
  for (size_t p = 0; p < soup->n_points; p++) {
    fputs("v ", sink->file);
    gmds_put_point(sink->file, soup, p, 3);
    putc('\n', sink->file);
  }
  for (size_t c = 0; c < soup->n_cells; c++) {
    putc(keywords[gmds_cell_type_dimension((gmds_cell_type)soup->types[c])], sink->file);
    gmds_put_corners(sink->file, soup, c, 1);
    putc('\n', sink->file);
  }
  return GMDS_OK;
}

/* The unit normal of a triangle, 0 where it has none. */
static void normal_of(const gmds_soup *soup, size_t cell, float normal[3])
{
  double u[3], v[3], n[3], length = 0;
  const gmds_id *corners = soup->corners + soup->begin[cell];
  for (int k = 0; k < 3; k++) {
    u[k] = gmds_coordinate(soup, corners[1], k) - gmds_coordinate(soup, corners[0], k);
    v[k] = gmds_coordinate(soup, corners[2], k) - gmds_coordinate(soup, corners[0], k);
  }
  for (int k = 0; k < 3; k++) {
    n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    length += n[k] * n[k];
  }
  length = sqrt(length);
  for (int k = 0; k < 3; k++)
    normal[k] = length > 0 && isfinite(length) ? (float)(n[k] / length) : 0;
}

static void put_float(FILE *file, float x)
{
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  gmds_put_word(file, bits, 4, 1);
}

static void write_triangle(const gmds_sink *sink, size_t cell)
{
  const gmds_soup *soup = sink->soup;
  float normal[3];
  normal_of(soup, cell, normal);
  if (!sink->binary)
    fprintf(sink->file, "facet normal %.9g %.9g %.9g\nouter loop\n", (double)normal[0], (double)normal[1],
            (double)normal[2]);
  for (int k = 0; sink->binary && k < 3; k++)
    put_float(sink->file, normal[k]);
  for (size_t i = soup->begin[cell]; i < soup->begin[cell + 1]; i++) {
    for (int k = 0; sink->binary && k < 3; k++)
      put_float(sink->file, (float)gmds_coordinate(soup, soup->corners[i], k));
    if (!sink->binary) {
      fputs("vertex ", sink->file);
      gmds_put_point(sink->file, soup, soup->corners[i], 3);
      putc('\n', sink->file);
    }
  }
  if (sink->binary)
    gmds_put_word(sink->file, 0, 2, 1);
  else
    fputs("endloop\nendfacet\n", sink->file);
}

gmds_status gmds_write_stl(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  static const char header[80] = "triangles written by gmds";
  if (soup->n_cells > UINT32_MAX)
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "STL has 32 bits for the number of triangles");
  for (size_t i = 0; sink->binary && i < soup->n_points * (size_t)soup->dim; i++)
    if (fabs(soup->points[i]) > 3.4e38 || (double)(float)soup->points[i] != soup->points[i])
      return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED,
                            "binary STL has coordinates of 32 bits, and one of point %zu (from 0) needs more",
                            i / (size_t)soup->dim);
  if (sink->binary) {
    fwrite(header, 1, sizeof header, sink->file);
    gmds_put_word(sink->file, soup->n_cells, 4, 1);
  } else {
    fputs("solid gmds\n", sink->file);
  }
  for (size_t c = 0; c < soup->n_cells; c++)
    write_triangle(sink, c);
  if (!sink->binary)
    fputs("endsolid gmds\n", sink->file);
  return GMDS_OK;
}
