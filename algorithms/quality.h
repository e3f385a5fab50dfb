/* The quality and the size of every cell: one text for every model that can list the nodes of its cells in order. The
 * measures, one for each type of cell, 1 the best and 0 or less for what is degenerate or inverted, are those of
 * quality.h, which cites them.
 *
 *   <prefix>_quality(m, values, sizes, summary)
 *     m        any mesh
 *     values   end_2 entries (end_3 in models that keep regions), or NULL: receives the measure of each face (region),
 *              0 where none is alive
 *     sizes    as many, or NULL: receives area (volume). Areas in the plane and volumes are negative where cells are
 *              inverted; where the model does not keep the order that says so they are taken as positive, and so are
 *              polyhedra
 *     summary  may be NULL; receives the histogram, the least, the largest and the mean measure, and how many are
 *              inverted
 *   GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a region do not make one of its type):
 *   nothing was written. Working space comes from the mesh's memory. O(mesh). */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/quality.h>"
#endif

#include <gmds/quality.h>

#if GMDS_TOP == 3
_Static_assert(GMDS_LISTS_CELLS,
               "gmds: quality() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
               "define GMDS_REGIONS TETRAHEDRON");
#else
_Static_assert(GMDS_CAN(2, 0), "gmds: quality() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: quality() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
#endif

#if GMDS_LISTS_CELLS
#  define quality GMDS_FN(quality)

#  if GMDS_TOP == 3
static inline gmds_status quality(mesh *m, double *values, double *sizes, gmds_quality *summary)
{
  gmds_complex complex;
  gmds_walls walls;
  gmds_complex_init(&complex, mesh_memory(m), 0);
  GMDS_TRY(get_complex(m, &complex, NULL));
  gmds_status status = gmds_walls_init(&walls, &complex, coordinates(m));
  if (status == GMDS_OK) {
    gmds_quality_of_regions(&walls, coordinates(m), values, sizes, summary);
    gmds_walls_clear(&walls);
  }
  gmds_complex_clear(&complex);
  return status;
}
#  else
static inline gmds_status quality(mesh *m, double *values, double *sizes, gmds_quality *summary)
{
  gmds_csr nodes;
  gmds_csr_init(&nodes, mesh_memory(m));
  GMDS_TRY(all_adj_2_0(m, &nodes));
  gmds_quality_of_faces(GMDS_COORDINATES, coordinates(m), &nodes, GMDS_ORDERED_2_0, values, sizes, summary);
  gmds_csr_clear(&nodes);
  return GMDS_OK;
}
#  endif
#  undef quality
#endif
