/* New numbers for all cells, so that what is near lies near in memory: nodes along the Hilbert curve, edges, faces and
 * regions by the least new number of a node of theirs. One text for every model that can list the nodes of its cells in
 * order.
 *
 *   <prefix>_renumber(m, maps, error)
 *     m      any mesh whose coordinates are finite. Afterwards it has no holes; attributes and orders have gone along
 *     maps   three arrays, four in models that keep regions, or NULL: maps[i], of end_i entries, or NULL, receives the
 *            new number of each i-cell, GMDS_NONE for holes
 *     error  may be NULL
 *   GMDS_OK; GMDS_ERR_COORDINATE; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY; GMDS_ERR_INVARIANT (faces of a region do not make
 *   one of its type): nothing has changed. Working space, more than that of a second mesh, comes from the mesh's
 *   allocator. O(mesh), the curve as in order.h. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/renumber.h>"
#endif

#include <gmds/renumber.h>

#if GMDS_TOP == 3
_Static_assert(GMDS_LISTS_CELLS,
               "gmds: renumber() of regions needs the nodes of all cells: add R2N, or R2F with F2N, or "
               "define GMDS_REGIONS TETRAHEDRON");
#else
_Static_assert(GMDS_CAN(2, 0), "gmds: renumber() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: renumber() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
#endif

#if GMDS_LISTS_CELLS
#  define renumber GMDS_FN(renumber)
#  define begin_maps GMDS_FN(begin_maps)

/* An array for each dimension, GMDS_NONE for holes. */
static inline gmds_status begin_maps(const mesh *m, const size_t *end, gmds_memory *work, gmds_id **maps)
{
  for (int i = 0; i <= GMDS_TOP; i++) {
    void *block = NULL;
    if (!gmds_resize(work, &block, 0, end[i], sizeof(gmds_id)))
      return GMDS_ERR_MEMORY;
    maps[i] = block;
    if (end[i])
      memset(block, 0xff, end[i] * sizeof(gmds_id));
  }
  for (gmds_id v = next_0(m, 0); v != GMDS_NONE; v = next_0(m, v + 1))
    maps[0][v] = 0;
  for (gmds_id e = next_1(m, 0); e != GMDS_NONE; e = next_1(m, e + 1))
    maps[1][e] = 0;
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1))
    maps[2][f] = 0;
#  if GMDS_TOP == 3
  for (gmds_id r = next_3(m, 0); r != GMDS_NONE; r = next_3(m, r + 1))
    maps[3][r] = 0;
#  endif
  return GMDS_OK;
}

static inline gmds_status renumber(mesh *m, gmds_id *const *maps, gmds_error *error)
{
  gmds_memory work, *memory = mesh_memory(m); /* the mesh's own counts are those of another mesh afterwards */
  gmds_complex complex;
  gmds_id *own[4] = {NULL, NULL, NULL, NULL};
  size_t end[4] = {end_0(m), end_1(m), end_2(m), 0};
#  if GMDS_TOP == 3
  end[3] = end_3(m);
#  endif
  gmds_memory_init(&work, &memory->allocator);
  work.limit = memory->limit - memory->live;
  gmds_complex_init(&complex, &work, 0);
  GMDS_TRY(get_complex(m, &complex, error));
  gmds_status status = begin_maps(m, end, &work, own);
  if (status == GMDS_OK)
    status = gmds_number_along_curve(&work, GMDS_COORDINATES, coordinates(m), &complex, GMDS_TOP, end, own, error);
  gmds_complex_clear(&complex);
  if (memory->live + work.peak > memory->peak)
    memory->peak = memory->live + work.peak;
  if (status == GMDS_OK)
    status = permute(m, own);
  for (int i = 0; i <= GMDS_TOP; i++) {
    if (status == GMDS_OK && maps && maps[i] && end[i])
      memcpy(maps[i], own[i], end[i] * sizeof(gmds_id));
    gmds_release(&work, own[i], own[i] ? end[i] : 0, sizeof(gmds_id));
  }
  return status;
}
#  undef renumber
#  undef begin_maps
#endif
