/* Hops: from a few cells to the cells they are linked with, along a stored relation or, where only its inverse is
 * stored, by one traversal of it. Queries of every model are made of these, compiled once. */
#ifndef GMDS_HOPS_H
#define GMDS_HOPS_H

#include <gmds/bits.h>
#include <gmds/pairs.h>
#include <gmds/rows.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A relation of a whole mesh: the cells of cell c are data[begin[c]] to data[begin[c + 1] - 1]. Owned by the caller. */
typedef struct gmds_csr {
  size_t n; /* cells, holes included: `begin` has n + 1 entries, or is NULL */
  size_t *begin;
  gmds_id *data;
  size_t capacity; /* of data */
  gmds_memory *memory;
} gmds_csr;

void gmds_csr_init(gmds_csr *csr, gmds_memory *memory);
void gmds_csr_clear(gmds_csr *csr);

/* How many cells cell c has, and where they lie (NULL where there is none). */
static inline size_t gmds_csr_row(const gmds_csr *csr, size_t c, const gmds_id **data)
{
  const size_t n = csr->begin[c + 1] - csr->begin[c];
  *data = n ? csr->data + csr->begin[c] : NULL;
  return n;
}

/* Each takes the cells list[first] to list[last - 1] and appends what they are linked with, once for each link. The
 * multiset is what Keep counts. GMDS_OK or GMDS_ERR_MEMORY (what was appended is cut off again).
 *   rows, pairs, inline   along the stored relation; GMDS_NONE is left out; a row inline has `arity` entries
 *   scan                  by traversal of the inverse relation of `end` cells: O(end * arity), or O(entries)
 *   csr                   along a relation of the whole mesh */
gmds_status gmds_hop_rows(const gmds_rows *rows, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_hop_pairs(const gmds_pairs *pairs, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_hop_inline(const gmds_id *data, size_t arity, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_hop_csr(const gmds_csr *csr, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_scan_rows(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_scan_pairs(const gmds_pairs *pairs, size_t end, gmds_ids *list, size_t first, size_t last);
gmds_status gmds_scan_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, gmds_ids *list,
                             size_t first, size_t last);

/* The cells of a relation of `end` cells, whose rows are sets, that name at least `times` (1 or more) of the distinct
 * cells list[first] to list[last - 1], appended once each: Keep_times after a traversal. Only last - first - times + 1
 * of the cells are looked for, since one of them must be there. GMDS_OK or GMDS_ERR_MEMORY (as above). */
gmds_status gmds_scan_meet_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, gmds_ids *list,
                                  size_t first, size_t last, size_t times);
gmds_status gmds_scan_meet_rows(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last,
                                size_t times);

/* The live cell among `end` whose two entries are a and b, in either order, or GMDS_NONE. One traversal. */
gmds_id gmds_find_pair(const gmds_id *data, const gmds_bits *alive, size_t end, gmds_id a, gmds_id b);

/* The inverse of a relation of `end` cells towards `n` cells, for the whole mesh. GMDS_OK or GMDS_ERR_MEMORY (the csr
 * stays empty). O(n + entries). */
gmds_status gmds_invert_rows(const gmds_rows *rows, size_t end, size_t n, gmds_csr *csr);
gmds_status gmds_invert_pairs(const gmds_pairs *pairs, size_t end, size_t n, gmds_csr *csr);
gmds_status gmds_invert_csr(const gmds_csr *relation, size_t n, gmds_csr *csr);
gmds_status gmds_invert_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, size_t n,
                               gmds_csr *csr);

#ifdef __cplusplus
}
#endif
#endif
