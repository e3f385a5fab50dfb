/* Numbers for cells such that what is near has near numbers: what renumber() of a mesh asks (algorithms/renumber.h). */
#ifndef GMDS_RENUMBER_H
#define GMDS_RENUMBER_H

#include <gmds/complex.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Nodes along the Hilbert curve, equal ones in the order that they had; edges, faces and regions by the least new
 * number of a node of theirs, and in the order that they had.
 *   dim, points   2 or 3 coordinates a node
 *   complex       the nodes of the cells (it need not be joined)
 *   top           2 or 3: the highest dimension
 *   end           how many identifiers there are of each dimension
 *   maps          end[i] entries each: GMDS_NONE for holes, anything else for cells, which receive their new numbers
 * GMDS_OK; GMDS_ERR_COORDINATE (a node is not finite; `error` names it as the place among the live ones);
 * GMDS_ERR_MEMORY: the maps may have been written. O(nodes and entries), as order.h. */
gmds_status gmds_number_along_curve(gmds_memory *memory, int dim, const double *points, const gmds_complex *complex,
                                    int top, const size_t *end, gmds_id *const *maps, gmds_error *error);

#ifdef __cplusplus
}
#endif
#endif
