/* Writers of points alone: text, Triangle's .node, raw little-endian doubles. */
#include "writers.h"

gmds_status gmds_write_text(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(sink->file, soup, p, soup->dim);
    putc('\n', sink->file);
  }
  return GMDS_OK;
}

gmds_status gmds_write_node(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  fprintf(sink->file, "%zu %d 0 0\n", soup->n_points, soup->dim);
  for (size_t p = 0; p < soup->n_points; p++) {
    fprintf(sink->file, "%zu ", p);
    gmds_put_point(sink->file, soup, p, soup->dim);
    putc('\n', sink->file);
  }
  return GMDS_OK;
}

gmds_status gmds_write_f64(const gmds_sink *sink)
{
  for (size_t i = 0; i < sink->soup->n_points * (size_t)sink->soup->dim; i++)
    gmds_put_double(sink->file, sink->soup->points[i], 1);
  return GMDS_OK;
}
