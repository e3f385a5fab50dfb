/* The check of stored relations against each other; <prefix>_check hands a mesh over. */
#ifndef GMDS_CHECK_H
#define GMDS_CHECK_H

#include <gmds/census.h>
#include <gmds/hops.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The stored relations of a mesh up to faces. */
typedef struct gmds_relations {
  unsigned mask; /* which are stored */
  int triangles; /* the model holds no other faces */
  int ordered;   /* faces list their nodes (F2N) or edges (F2E) in their order around the face */
  int aligned;   /* entry k of F2F belongs to side k, GMDS_NONE where there is no face */
  size_t end[3]; /* identifiers of nodes, edges, faces */
  const gmds_bits *alive[3];
  gmds_csr relation[3][3]; /* relation[i][j] where i2j is stored */
} gmds_relations;

/* Checks that every entry names a live cell, that cells have as many nodes as they must, that i2j and j2i agree, that
 * F2E and F2F agree with the sides of faces, and that every relation is what the others give along the composition
 * tables. GMDS_OK; GMDS_ERR_INVARIANT, `error` names the first violation (relation, cell, what was found);
 * GMDS_ERR_MEMORY. O(n log n) for n entries; where cells know cells of their own dimension also the squares of their
 * numbers. */
gmds_status gmds_check_relations(const gmds_relations *all, gmds_memory *memory, gmds_error *error);

/* Copies of stored relations for the check, GMDS_NONE included; `shift` drops low bits of entries.
 * GMDS_OK or GMDS_ERR_MEMORY. */
gmds_status gmds_copy_pairs(const gmds_pairs *pairs, size_t end, gmds_csr *csr);
gmds_status gmds_copy_rows(const gmds_rows *rows, size_t end, gmds_csr *csr);
gmds_status gmds_copy_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, int shift,
                             gmds_csr *csr);

#ifdef __cplusplus
}
#endif
#endif
