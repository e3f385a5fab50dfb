/* The homology of a surface, and the surface of a mesh as a 2-map at rest. One text for every model that answers 2 -> 0
 * in order, or holds triangles only.
 *
 *   <prefix>_get_surface(m, threads, error, surface, faces)
 *     m        any mesh of faces; its nodes keep their numbers
 *     threads  from 1 to GMDS_MAX_THREADS
 *     error    receives the sentence of a failure; may be NULL
 *     surface  initialised and empty (surface.h); receives the faces, listed without holes
 *     faces    receives the face of the mesh that each in the list is; its memory is the caller's
 *   Statuses as gmds_surface_from_faces; both stay as they are on failure. O(mesh).
 *
 *   <prefix>_homology(m, options, homology)
 *     options   as gmds_homology_of (homology.h); labels are one for each of end_0 nodes; may be NULL
 *     homology  initialised and empty; receives numbers and generators, in nodes and faces of the mesh
 *   Statuses as gmds_surface_from_faces and gmds_homology_of; it stays empty on failure. Working space comes from the
 *   mesh's memory. Nearly O(mesh); H1 also takes the length of its chains.
 *   Source: [homology] Algorithm 1. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/homology.h>"
#endif
#include <gmds/homology.h>

_Static_assert(GMDS_TOP == 2, "gmds: homology() is of surfaces: drop R and what names regions from GMDS_MODEL");
_Static_assert(GMDS_CAN(2, 0), "gmds: homology() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_TOP != 2 || GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: homology() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");

#if GMDS_TOP == 2
#  if GMDS_CAN(2, 0) && (GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL)
#    define get_surface GMDS_FN(get_surface)
#    define homology GMDS_FN(homology)

static inline gmds_status get_surface(mesh *m, unsigned threads, gmds_error *error, gmds_surface *surface,
                                      gmds_ids *faces)
{
  gmds_csr nodes;
  gmds_ids live;
  gmds_csr_init(&nodes, mesh_memory(m));
  gmds_ids_init(&live, faces->memory);
  gmds_status status = gmds_ids_reserve(&live, count_2(m));
  if (status == GMDS_OK)
    status = all_adj_2_0(m, &nodes);
  if (status != GMDS_OK)
    gmds_fail(error, status, "listing the nodes of %zu faces: %s", (size_t)count_2(m), gmds_status_text(status));
  for (gmds_id f = next_2(m, 0); status == GMDS_OK && f != GMDS_NONE; f = next_2(m, f + 1)) {
    nodes.begin[live.n + 1] = nodes.begin[f + 1]; /* dead faces have empty rows */
    live.data[live.n++] = f;
  }
  if (status == GMDS_OK)
    status =
        gmds_surface_from_faces(surface, end_0(m), live.n, live.n ? nodes.begin : NULL, nodes.data, threads, error);
  gmds_csr_clear(&nodes);
  if (status != GMDS_OK) {
    gmds_ids_clear(&live);
    return status;
  }
  gmds_ids_clear(faces);
  *faces = live;
  return GMDS_OK;
}

static inline gmds_status homology(mesh *m, const gmds_homology_options *options, gmds_homology *result)
{
  gmds_surface surface;
  gmds_ids faces;
  gmds_surface_init(&surface, mesh_memory(m));
  gmds_ids_init(&faces, mesh_memory(m));
  const unsigned threads = options && options->threads ? options->threads : 1;
  gmds_status status = get_surface(m, threads, options ? options->error : NULL, &surface, &faces);
  if (status == GMDS_OK)
    status = gmds_homology_of(&surface, options, result);
  for (size_t k = 0; status == GMDS_OK && result->h2.n && k < result->h2.begin[result->h2.n]; k++)
    result->h2.data[k] = faces.data[gmds_surface_listed(&surface, result->h2.data[k])];
  gmds_surface_clear(&surface);
  gmds_ids_clear(&faces);
  return status;
}
#    undef get_surface
#    undef homology
#  endif
#endif
