/* The connected components of the faces of a mesh: faces that share a side are in one. One text for every model that
 * answers 2 -> 2, which is asked for once for all faces, or read in place where F2F is stored.
 *
 *   <prefix>_components(m, component, count)
 *     m          any mesh
 *     component  end_2 entries: receives the number of the component of each face, counted from 0 in the order of the first
 *                face of each; GMDS_NONE where no face is alive
 *     count      receives how many components there are
 *   GMDS_OK or GMDS_ERR_MEMORY (nothing was written). Working space comes from the mesh's memory. O(mesh and
 *   2 -> 2), nearly: a forest in which the smaller face is the parent, paths halved (Tarjan and van Leeuwen, 1984). */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/components.h>"
#endif

_Static_assert(GMDS_CAN(2, 2), "gmds: components() needs 2->2: add F2F, or F2N, or define GMDS_FACES TRIANGLE");

#if GMDS_CAN(2, 2)
#  define root_of GMDS_FN(root_of)
#  define join_faces GMDS_FN(join_faces)
#  define components GMDS_FN(components)

static inline gmds_id root_of(gmds_id *parent, gmds_id f)
{
  while (parent[f] != f)
    f = parent[f] = parent[parent[f]];
  return f;
}

static inline void join_faces(gmds_id *parent, gmds_id f, gmds_id g)
{
  f = root_of(parent, f);
  g = root_of(parent, g);
  parent[f > g ? f : g] = f < g ? f : g;
}

static inline gmds_status components(mesh *m, gmds_id *component, size_t *count)
{
#  if !GMDS_STORED(2, 2)
  gmds_csr beyond;
  gmds_csr_init(&beyond, mesh_memory(m));
  GMDS_TRY(all_adj_2_2(m, &beyond));
#  endif
  for (size_t f = 0; f < end_2(m); f++)
    component[f] = has_2(m, (gmds_id)f) ? (gmds_id)f : GMDS_NONE;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1)) {
#  if GMDS_STORED(2, 2)
    for (size_t k = 0; k < face_sides(m, f); k++)
      if (face_beside(m, f, k) < f) /* GMDS_NONE is larger than any face */
        join_faces(component, f, face_beside(m, f, k));
#  else
    for (size_t k = beyond.begin[f]; k < beyond.begin[f + 1]; k++)
      if (beyond.data[k] < f)
        join_faces(component, f, beyond.data[k]);
#  endif
  }
  gmds_id n = 0;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1)) /* a parent is smaller, and has its number */
    component[f] = component[f] == f ? n++ : component[component[f]];
  *count = n;
#  if !GMDS_STORED(2, 2)
  gmds_csr_clear(&beyond);
#  endif
  return GMDS_OK;
}
#  undef root_of
#  undef join_faces
#  undef components
#endif
