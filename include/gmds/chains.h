/* Sides joined to chains. */
#ifndef GMDS_CHAINS_H
#define GMDS_CHAINS_H

#include <gmds/hops.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Joins n sides, each from sides[2k] to sides[2k + 1], both below n_nodes, to chains: row by row their nodes in order,
 * each side used once, along its direction where there is a choice. The first `open` chains are open, the others are
 * loops, which end before the node that they began at; each begins at its smallest unused side. chains is initialised
 * and empty, its memory the caller's; working space comes from `memory`. GMDS_OK or GMDS_ERR_MEMORY (nothing has
 * changed). O(n_nodes + n), times the sides at a node. */
gmds_status gmds_chain_sides(size_t n, const gmds_id *sides, size_t n_nodes, gmds_memory *memory, gmds_csr *chains,
                             size_t *open);

#ifdef __cplusplus
}
#endif
#endif
