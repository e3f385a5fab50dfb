/* The checksum of a set of cells. */
#include "mix.h"
#include <gmds/checksum.h>
#include <string.h>

static int before(int dim, const double *a, const double *b)
{
  for (int k = 0; k < dim; k++)
    if (a[k] != b[k])
      return a[k] < b[k];
  return 0;
}

gmds_status gmds_checksum_cell(int dim, const double *points, size_t n, gmds_id *nodes, uint64_t *h)
{
  if (dim != 2 && dim != 3)
    return GMDS_ERR_ARGUMENT;
  size_t d = (size_t)dim;
  size_t gap = 1; /* Shell's sort with Knuth's gaps: insertion for a triangle, fast enough for any polygon */
  while (gap < n / 3)
    gap = 3 * gap + 1;
  for (; gap > 0; gap /= 3)
    for (size_t i = gap; i < n; i++)
      for (size_t j = i; j >= gap && before(dim, points + d * nodes[j], points + d * nodes[j - gap]); j -= gap) {
        gmds_id swap = nodes[j];
        nodes[j] = nodes[j - gap];
        nodes[j - gap] = swap;
      }
  uint64_t sum = 0;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < d; k++) {
      double x = points[d * nodes[i] + k] + 0.0; /* -0 becomes +0 */
      uint64_t w = 0;
      memcpy(&w, &x, sizeof w);
      sum = mix((sum ^ w) + UINT64_C(0x9e3779b97f4a7c15));
    }
  *h = sum;
  return GMDS_OK;
}
