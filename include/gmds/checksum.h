/* The checksum of a set of cells: it depends on coordinates and connections alone, never on numbering, order or model.
 * For each cell its points in lexicographic order (-0 as +0), h = 0, then for each coordinate's 64 bits w in that order
 * h = mix64((h xor w) + 0x9e3779b97f4a7c15), mix64 being the finaliser of splitmix64; the sum of all h modulo 2^64. */
#ifndef GMDS_CHECKSUM_H
#define GMDS_CHECKSUM_H

#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The h of one cell of n nodes; `points` has dim coordinates a node. The nodes are sorted in place.
 * GMDS_OK or GMDS_ERR_ARGUMENT (dim is not 2 or 3). O(n^1.5) comparisons. */
gmds_status gmds_checksum_cell(int dim, const double *points, size_t n, gmds_id *nodes, uint64_t *h);

#ifdef __cplusplus
}
#endif
#endif
