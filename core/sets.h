/* Rows of nodes grouped by their sets, and compared around. Private to the library. */
#ifndef GMDS_CORE_SETS_H
#define GMDS_CORE_SETS_H

#include <gmds/hops.h>

/* Numbers the sets of the rows begin[k] to begin[k + 1] - 1 of `data`, whose entries are below n_keys and distinct in
 * each row: group[k], n of them, receives the number of the set of row k, in the order in which they come, or GMDS_NONE
 * where the row is empty; leader[g] the first row of each set (room for n); *n_groups how many there are. n is less
 * than GMDS_NONE. GMDS_OK or GMDS_ERR_MEMORY (group and leader have lost their content). O(n_keys + entries). */
gmds_status gmds_group_sets(size_t n_keys, size_t n, const size_t *begin, const gmds_id *data, gmds_memory *memory,
                            gmds_id *group, gmds_id *leader, size_t *n_groups);

/* Whether two rows of the same n distinct nodes list them around in the same order, from any of them on and either way.
 * O(n). */
int gmds_same_cycle(const gmds_id *a, const gmds_id *b, size_t n);

#endif
