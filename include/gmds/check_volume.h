/* The check of a mesh of volumes; <prefix>_check hands it over. */
#ifndef GMDS_CHECK_VOLUME_H
#define GMDS_CHECK_VOLUME_H

#include <gmds/complex.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The stored relations of a mesh of volumes. */
typedef struct gmds_stored_relations {
  unsigned mask; /* which are stored */
  size_t end[4]; /* identifiers of nodes, edges, faces, regions */
  const gmds_bits *alive[4];
  gmds_csr relation[4][4];      /* relation[i][j] where i2j is stored, GMDS_NONE included */
  int keeps_edges, keeps_faces; /* regions and faces make theirs */
  int sides;                    /* F2E is in the order of the nodes of the face */
  int local;                    /* R2E and R2F are in the local order of shapes.h */
  int aligned;                  /* entry k of R2R belongs to face k */
} gmds_stored_relations;

/* Checks that every entry names a live cell and none twice, and none is left where a cell was deleted. GMDS_OK;
 * GMDS_ERR_INVARIANT, `error` names the first violation; GMDS_ERR_MEMORY. O(entries log entries of a row). */
gmds_status gmds_check_entries(const gmds_stored_relations *all, gmds_memory *memory, gmds_error *error);

/* Checks every stored relation against what the nodes of cells say, which come from some of them; and that no edge or
 * face is there twice or missing. Status as above. O(entries). */
gmds_status gmds_check_complex(const gmds_stored_relations *all, gmds_complex *complex, gmds_error *error);

/* Where the nodes of cells cannot be listed: relations that are stored both ways say the same. Status as above. */
gmds_status gmds_check_inverses(const gmds_stored_relations *all, gmds_memory *memory, gmds_error *error);

#ifdef __cplusplus
}
#endif
#endif
