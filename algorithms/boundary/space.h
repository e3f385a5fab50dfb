/* The boundary of a mesh of volumes: the faces that one region has, turned outwards. One text for every model that can
 * list the nodes of its cells.
 *
 *   <prefix>_boundary(m, faces, on)
 *     m      any mesh
 *     faces  initialised and empty, its memory is the caller's: receives the nodes around each face, counter-clockwise
 *            seen from outside by the order of the region's nodes. Where the model keeps no such order regions are
 *            taken to enclose a positive volume, polyhedra always
 *     on     initialised and empty: receives two entries a face, its region and the number of the face there
 *            (shapes.h), or NULL. Faces are in the order of these
 *   GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a region do not make one of its type):
 *   both stay empty. Working space comes from the mesh's memory. O(mesh). */
#include <gmds/walls.h>

_Static_assert(GMDS_LISTS_CELLS,
               "gmds: boundary() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
               "define GMDS_REGIONS TETRAHEDRON");

#if GMDS_LISTS_CELLS
#  define boundary GMDS_FN(boundary)

static inline gmds_status boundary(mesh *m, gmds_csr *faces, gmds_ids *on)
{
  gmds_complex complex;
  gmds_walls walls;
  gmds_ids all = {.memory = mesh_memory(m)};
  gmds_complex_init(&complex, mesh_memory(m), 0);
  GMDS_TRY(get_complex(m, &complex, NULL));
  gmds_status status = gmds_walls_init(&walls, &complex, coordinates(m));
  if (status == GMDS_OK) {
    status = gmds_walls_boundary(&walls, faces, on ? on : &all);
    gmds_walls_clear(&walls);
  }
  gmds_complex_clear(&complex);
  gmds_ids_clear(&all);
  return status;
}
#  undef boundary
#endif
