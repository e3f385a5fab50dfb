/* Whether a mesh is a manifold and how its cells are turned: one text for every model that can list the nodes of its
 * cells in order (of triangles without an order all but which way they turn). The report names how many of each kind
 * there are and the first (manifold.h): of surfaces sides with one face or more than two, neighbours that turn against
 * each other, nodes with more than one fan, whether they can be oriented; of volumes the same of faces, edges and
 * nodes, regions that are inverted or flat by the exact predicate, and the boundary as a surface.
 *
 *   <prefix>_manifold(m, report)
 *     m       any mesh
 *     report  receives a gmds_surface_report, in models that keep regions a gmds_volume_report. Where the order of
 *             regions is not kept they are taken to enclose a positive volume; what the report calls first does not
 *             depend on the model, but for the numbers of faces in regions of which no order is kept
 *   GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a region do not make one of its type):
 *   nothing was written. Working space comes from the mesh's memory. O(mesh), nearly. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/manifold.h>"
#endif

#include <gmds/manifold.h>

#if GMDS_TOP == 3
_Static_assert(GMDS_LISTS_CELLS,
               "gmds: manifold() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
               "define GMDS_REGIONS TETRAHEDRON");
#else
_Static_assert(GMDS_CAN(2, 0), "gmds: manifold() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: manifold() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
#endif

#if GMDS_LISTS_CELLS
#  define manifold GMDS_FN(manifold)

#  if GMDS_TOP == 3
static inline gmds_status manifold(mesh *m, gmds_volume_report *report)
{
  gmds_complex complex;
  gmds_complex_init(&complex, mesh_memory(m), 0);
  GMDS_TRY(get_complex(m, &complex, NULL));
  gmds_status status = gmds_look_at_regions(&complex, coordinates(m), report);
  gmds_complex_clear(&complex);
  return status;
}
#  else
static inline gmds_status manifold(mesh *m, gmds_surface_report *report)
{
  gmds_csr nodes;
  gmds_csr_init(&nodes, mesh_memory(m));
  GMDS_TRY(all_adj_2_0(m, &nodes));
  gmds_status status = gmds_look_at_faces(end_0(m), &nodes, GMDS_ORDERED_2_0, mesh_memory(m), report);
  gmds_csr_clear(&nodes);
  return status;
}
#  endif
#  undef manifold
#endif
