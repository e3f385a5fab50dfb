/* The connected components of a mesh: faces that share a side are in one, in models of volumes regions that share a
 * face. One text for every model that answers 2 -> 2, or 3 -> 3, which is asked for once for all cells, or read in
 * place where F2F is stored.
 *
 *   <prefix>_components(m, component, count)
 *     m          any mesh
 *     component  end_2 entries (end_3): receives the number of the component of each face (region), counted from 0 in
 *                the order of the first of each; GMDS_NONE where none is alive
 *     count      receives how many components there are
 *   GMDS_OK or GMDS_ERR_MEMORY (nothing was written). Working space comes from the mesh's memory. O(mesh and
 *   answer), nearly: a forest in which the smaller cell is the parent, paths halved (Tarjan and van Leeuwen, 1984). */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/components.h>"
#endif

#if GMDS_TOP == 3
_Static_assert(GMDS_CAN(3, 3), "gmds: components() of regions needs 3->3: add R2R, or R2N, or R2F with F2N");
#  define next_cell next_3
#  define end_cell end_3
#  define has_cell has_3
#  define all_beside all_adj_3_3
#else
_Static_assert(GMDS_CAN(2, 2), "gmds: components() needs 2->2: add F2F, or F2N, or define GMDS_FACES TRIANGLE");
#  define next_cell next_2
#  define end_cell end_2
#  define has_cell has_2
#  define all_beside all_adj_2_2
#endif

#if (GMDS_TOP == 2 && GMDS_CAN(2, 2)) || (GMDS_TOP == 3 && GMDS_CAN(3, 3))
#  define root_of GMDS_FN(root_of)
#  define join_cells GMDS_FN(join_cells)
#  define components GMDS_FN(components)

static inline gmds_id root_of(gmds_id *parent, gmds_id f)
{
  while (parent[f] != f)
    f = parent[f] = parent[parent[f]];
  return f;
}

static inline void join_cells(gmds_id *parent, gmds_id f, gmds_id g)
{
  f = root_of(parent, f);
  g = root_of(parent, g);
  parent[f > g ? f : g] = f < g ? f : g;
}

static inline gmds_status components(mesh *m, gmds_id *component, size_t *count)
{
#  if !(GMDS_TOP == 2 && GMDS_STORED(2, 2))
  gmds_csr beyond;
  gmds_csr_init(&beyond, mesh_memory(m));
  GMDS_TRY(all_beside(m, &beyond));
#  endif
  for (size_t f = 0; f < end_cell(m); f++)
    component[f] = has_cell(m, (gmds_id)f) ? (gmds_id)f : GMDS_NONE;
  for (gmds_id f = next_cell(m, 0); f != GMDS_NONE; f = next_cell(m, f + 1)) {
#  if (GMDS_TOP == 2 && GMDS_STORED(2, 2))
    for (size_t k = 0; k < face_sides(m, f); k++)
      if (face_beside(m, f, k) < f) /* GMDS_NONE is larger than any face */
        join_cells(component, f, face_beside(m, f, k));
#  else
    for (size_t k = beyond.begin[f]; k < beyond.begin[f + 1]; k++)
      if (beyond.data[k] < f)
        join_cells(component, f, beyond.data[k]);
#  endif
  }
  gmds_id n = 0;
  for (gmds_id f = next_cell(m, 0); f != GMDS_NONE;
       f = next_cell(m, f + 1)) /* a parent is smaller, and has its number */
    component[f] = component[f] == f ? n++ : component[component[f]];
  *count = n;
#  if !(GMDS_TOP == 2 && GMDS_STORED(2, 2))
  gmds_csr_clear(&beyond);
#  endif
  return GMDS_OK;
}
#  undef root_of
#  undef join_cells
#  undef components
#endif
#undef next_cell
#undef end_cell
#undef has_cell
#undef all_beside
