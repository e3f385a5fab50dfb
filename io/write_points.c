/* Writers of points alone: text, Triangle's .node, raw little-endian doubles. */
#include "writers.h"
#include <string.h>

void gmds_write_text(FILE *file, const gmds_soup *soup)
{
  for (size_t p = 0; p < soup->n_points; p++) {
    gmds_put_point(file, soup, p, soup->dim);
    putc('\n', file);
  }
}

void gmds_write_node(FILE *file, const gmds_soup *soup)
{
  fprintf(file, "%zu %d 0 0\n", soup->n_points, soup->dim);
  for (size_t p = 0; p < soup->n_points; p++) {
    fprintf(file, "%zu ", p);
    gmds_put_point(file, soup, p, soup->dim);
    putc('\n', file);
  }
}

void gmds_write_f64(FILE *file, const gmds_soup *soup)
{
  for (size_t i = 0; i < soup->n_points * (size_t)soup->dim; i++) {
    uint64_t bits;
    unsigned char bytes[8];
    memcpy(&bits, &soup->points[i], sizeof bits);
    for (int k = 0; k < 8; k++)
      bytes[k] = (unsigned char)(bits >> 8 * k);
    fwrite(bytes, 1, sizeof bytes, file);
  }
}
