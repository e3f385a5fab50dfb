/* The boundary of a mesh: of a surface the sides that one face is on, joined to loops; of a volume the faces that one
 * region is on (boundary/space.h). One text for every model of surfaces that answers 2 -> 0 in order (or holds
 * triangles only) and 2 -> 2. Both are asked for once for all faces, or read in place where they are stored.
 *
 *   <prefix>_boundary(m, chains, open)
 *     m       any mesh
 *     chains  initialised and empty, its memory is the caller's: receives one row a chain, its nodes in order. A loop
 *             goes the way of the faces on it where these turn alike and keep an order; it ends before the node that it
 *             began at. Where loops touch in a node they may come as one
 *     open    receives how many chains are open; they come first. Sides of more than two faces can leave such: a
 *             boundary without them is all loops
 *   GMDS_OK or GMDS_ERR_MEMORY (nothing has changed). Working space comes from the mesh's memory. O(mesh), times the
 *   square of the sides of a face where F2F is not stored; where many loops touch in one node also the square of their
 *   number. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/boundary.h>"
#endif

#if GMDS_TOP == 3
#  include <gmds/algorithms/boundary/space.h>
#else
#  include <gmds/chains.h>

_Static_assert(GMDS_CAN(2, 0), "gmds: boundary() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: boundary() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
_Static_assert(GMDS_CAN(2, 2), "gmds: boundary() needs 2->2: add F2F, or F2N, or define GMDS_FACES TRIANGLE");

#  if GMDS_CAN(2, 0) && (GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL) && GMDS_CAN(2, 2)
#    define boundary GMDS_FN(boundary)
#    define is_side_of GMDS_FN(is_side_of)
#    define is_bare GMDS_FN(is_bare)
#    define gather_bare GMDS_FN(gather_bare)

#    if !(GMDS_ORDERED_2_0 && GMDS_STORED(2, 2))
/* Whether nodes a and b follow each other among n nodes around a face. */
static inline int is_side_of(const gmds_id *nodes, size_t n, gmds_id a, gmds_id b)
{
  for (size_t k = 0, last = n - 1; k < n; last = k++)
    if ((nodes[last] == a && nodes[k] == b) || (nodes[last] == b && nodes[k] == a))
      return 1;
  return 0;
}
#    endif

/* Whether no other face is on side k of face f, from a to b. */
static inline int is_bare(const mesh *m, const gmds_csr *nodes, const gmds_csr *faces, gmds_id f, size_t k, gmds_id a,
                          gmds_id b)
{
#    if GMDS_ORDERED_2_0 && GMDS_STORED(2, 2)
  (void)nodes;
  (void)faces;
  (void)a;
  (void)b;
  return face_beside(m, f, k) == GMDS_NONE;
#    else
  (void)k;
  for (size_t i = faces->begin[f]; i < faces->begin[f + 1]; i++) {
    size_t n = 0;
    const gmds_id *around = read_2_0(m, nodes, faces->data[i], &n);
    if (is_side_of(around, n, a, b))
      return 0;
  }
  return 1;
#    endif
}

/* The nodes of every bare side, two by two. */
static inline gmds_status gather_bare(const mesh *m, const gmds_csr *nodes, const gmds_csr *faces, gmds_ids *sides)
{
  for (gmds_id f = next_2(m, 0); f != GMDS_NONE; f = next_2(m, f + 1)) {
    size_t n = 0;
    const gmds_id *around = read_2_0(m, nodes, f, &n);
    for (size_t k = 0; k < n; k++) {
      gmds_id a = around[k], b = around[k + 1 < n ? k + 1 : 0];
      if (!is_bare(m, nodes, faces, f, k, a, b))
        continue;
      GMDS_TRY(gmds_ids_push(sides, a));
      GMDS_TRY(gmds_ids_push(sides, b));
    }
  }
  return GMDS_OK;
}

static inline gmds_status boundary(mesh *m, gmds_csr *chains, size_t *open)
{
  gmds_csr nodes, faces;
  gmds_ids sides;
  gmds_csr_init(&nodes, mesh_memory(m));
  gmds_csr_init(&faces, mesh_memory(m));
  gmds_ids_init(&sides, mesh_memory(m));
  gmds_status status = prepare_2_0(m, &nodes);
#    if !(GMDS_ORDERED_2_0 && GMDS_STORED(2, 2))
  if (status == GMDS_OK)
    status = all_adj_2_2(m, &faces);
#    endif
  if (status == GMDS_OK)
    status = gather_bare(m, &nodes, &faces, &sides);
  gmds_csr_clear(&nodes);
  gmds_csr_clear(&faces);
  if (status == GMDS_OK)
    status = gmds_chain_sides(sides.n / 2, sides.data, end_0(m), mesh_memory(m), chains, open);
  gmds_ids_clear(&sides);
  return status;
}
#    undef boundary
#    undef is_side_of
#    undef is_bare
#    undef gather_bare
#  endif
#endif /* surfaces */
