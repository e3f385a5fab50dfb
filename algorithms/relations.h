/* Any relation of a whole mesh, whatever the model stores or keeps: the j-cells of every i-cell, for all nine or
 * sixteen pairs of dimensions. One text for every model that can list the nodes of its cells in order. Cells that the
 * model keeps have their identifiers; edges and faces that bound cells and are not kept get numbers of their own behind
 * these.
 *
 *   <prefix>_relation(m, i, j, cells, csr)
 *     m      any mesh
 *     i, j   from 0 to 2, to 3 in models that keep regions
 *     cells  a complex (complex.h), initialised: one that is empty receives all cells with their nodes, its memory is
 *            the caller's; one that was filled by a call before is asked, so that several relations of one mesh, which
 *            must not have changed, have numbers in common and are built from one listing
 *     csr    initialised and empty, its memory is the caller's: row c receives the j-cells of i-cell c, as
 *            gmds_complex_relation orders them; 0 -> 0 is being joined by an edge, 1 -> 1 sharing a node, 2 -> 2 a
 *            side, 3 -> 3 a face
 *   GMDS_OK; GMDS_ERR_ARGUMENT (no such dimension); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a
 *   region do not make one of its type): the csr stays empty, the complex too if it was. O(mesh and answer). */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/relations.h>"
#endif

#if GMDS_TOP == 3
_Static_assert(GMDS_LISTS_CELLS,
               "gmds: relation() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
               "define GMDS_REGIONS TETRAHEDRON");
#else
_Static_assert(GMDS_CAN(2, 0), "gmds: relation() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: relation() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
#endif

#if GMDS_LISTS_CELLS
#  define relation GMDS_FN(relation)

static inline gmds_status relation(const mesh *m, int i, int j, gmds_complex *cells, gmds_csr *csr)
{
  if (i < 0 || j < 0 || i > GMDS_TOP || j > GMDS_TOP)
    return GMDS_ERR_ARGUMENT;
  if (!cells->rows.begin) {
    gmds_complex all;
    gmds_complex_init(&all, cells->memory, 0);
    GMDS_TRY(get_complex(m, &all, NULL));
    gmds_status status = gmds_complex_make(&all, 1, GMDS_TOP == 3, NULL);
    if (status == GMDS_OK)
      status = gmds_complex_relation(&all, i, j, 0, csr, NULL);
    if (status == GMDS_OK)
      *cells = all;
    else
      gmds_complex_clear(&all);
    return status;
  }
  return gmds_complex_relation(cells, i, j, 0, csr, NULL);
}
#  undef relation
#endif
