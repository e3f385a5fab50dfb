/* Laplacian smoothing of a complex of regions: what smooth() of a mesh of volumes asks (algorithms/smoothing.h). */
#ifndef GMDS_SMOOTH_H
#define GMDS_SMOOTH_H

#include <gmds/complex.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Goes `sweeps` times over the inner nodes of a joined complex in the order of their identifiers and moves each to the
 * mean of the nodes that edges of regions join it with, unless a corner of a region would turn the other way, or lie
 * flat, that did not: decided by the exact predicate. A node is inner when each face of a region at it has two regions.
 * Nodes of polyhedra stay: these have no corners that tell.
 * points: 3 coordinates a node; moved receives how many moved in the last sweep. GMDS_OK or GMDS_ERR_MEMORY (nothing
 * has moved). Working space comes from the complex's memory. O(complex) a sweep. */
gmds_status gmds_smooth_regions(const gmds_complex *complex, double *points, size_t sweeps, size_t *moved);

#ifdef __cplusplus
}
#endif
#endif
