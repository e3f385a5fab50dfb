/* Laplacian smoothing of a mesh of volumes: one text for every model that can list the nodes of its cells.
 *
 * In each sweep the inner nodes, in the order of their identifiers, go to the mean of the nodes that they are joined
 * with by edges of regions, unless a corner of a region would turn the other way, or lie flat, that did not: decided by
 * the exact predicate (orient3d of a node and the three joined with it; the apex of a pyramid is in the corners of its
 * base). A node is inner when each face of a region at it has two regions; all others stay, boundary nodes among them,
 * and those of polyhedra. Nodes, cells and relations stay as they are. The result does not depend on the model.
 *
 *   <prefix>_smooth(m, sweeps, moved)
 *     m       any mesh
 *     sweeps  how often to go over the nodes
 *     moved   may be NULL; receives how many nodes moved in the last sweep (0 for no sweep)
 *   GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a region do not make one of its type):
 *   nothing has moved. Working space comes from the mesh's memory. O(mesh) a sweep. */
#include <gmds/smooth.h>

_Static_assert(GMDS_LISTS_CELLS, "gmds: smooth() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
                                 "define GMDS_REGIONS TETRAHEDRON");

#if GMDS_LISTS_CELLS
#  define smooth GMDS_FN(smooth)

static inline gmds_status smooth(mesh *m, size_t sweeps, size_t *moved)
{
  gmds_complex complex;
  size_t last = 0;
  gmds_complex_init(&complex, mesh_memory(m), 0);
  GMDS_TRY(get_complex(m, &complex, NULL));
  gmds_status status = gmds_smooth_regions(&complex, coordinates(m), sweeps, &last);
  gmds_complex_clear(&complex);
  if (status == GMDS_OK && moved)
    *moved = last;
  return status;
}
#  undef smooth
#endif
