/* Laplacian smoothing of a mesh of the plane, and of one of volumes (smoothing/space.h): one text for every model of
 * surfaces that answers 2 -> 0 in order (or holds triangles only) and 0 -> 2. Both are asked for once for all cells, or
 * read in place where they are stored.
 *
 * In each sweep the inner nodes, in the order of their identifiers, go to the mean of the nodes that they are joined
 * with by sides of faces, unless a corner of a face would turn the other way, or lie flat, that did not: turns are
 * decided by the exact predicate. A node is inner when two faces are on each of its sides; all others stay, boundary
 * nodes among them. Nodes, faces and relations stay as they are. The result does not depend on the model.
 *
 *   <prefix>_smooth(m, sweeps, moved)
 *     m       any mesh of the plane
 *     sweeps  how often to go over the nodes
 *     moved   may be NULL; receives how many nodes moved in the last sweep (0 for no sweep)
 *   GMDS_OK or GMDS_ERR_MEMORY (nothing has moved). Working space comes from the mesh's memory. O(mesh) a sweep, times
 *   the logarithm of the number of faces at a node. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/smoothing.h>"
#endif

#if GMDS_TOP == 3
#  include <gmds/algorithms/smoothing/space.h>
#else
#  include <gmds/predicates.h>

_Static_assert(GMDS_COORDINATES == 2, "gmds: smooth() moves nodes of the plane: take DIM3 out of GMDS_MODEL");
_Static_assert(GMDS_CAN(2, 0), "gmds: smooth() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL,
               "gmds: smooth() needs the order of the nodes of faces: add F2N, or define GMDS_FACES TRIANGLE");
_Static_assert(GMDS_CAN(0, 2), "gmds: smooth() needs 0->2: add N2F, or N2E with E2F, to GMDS_MODEL (the inverse of a "
                               "relation will do)");

#  if GMDS_COORDINATES == 2 && GMDS_CAN(2, 0) && (GMDS_ORDERED_2_0 || GMDS_SIMPLICIAL) && GMDS_CAN(0, 2)
#    define smoother GMDS_FN(smoother)
#    define corner_turn GMDS_FN(corner_turn)
#    define gather_joined GMDS_FN(gather_joined)
#    define keeps_turns GMDS_FN(keeps_turns)
#    define smooth_node GMDS_FN(smooth_node)
#    define smooth GMDS_FN(smooth)

typedef struct smoother {
  mesh *m;
  gmds_csr nodes, faces; /* 2 -> 0 and 0 -> 2 where they are not stored */
  gmds_ids joined;
} smoother;

/* Which way corner k of a face turns when node v is at x. */
static inline int corner_turn(const mesh *m, const gmds_id *nodes, size_t n, size_t k, gmds_id v, const double *x)
{
  const gmds_id a = nodes[k ? k - 1 : n - 1], b = nodes[k], c = nodes[k + 1 < n ? k + 1 : 0];
  return gmds_orient2d(a == v ? x : point(m, a), b == v ? x : point(m, b), c == v ? x : point(m, c));
}

/* The nodes joined with v, sorted; none when v is not inner. Room was made. */
static inline void gather_joined(smoother *s, gmds_id v)
{
  size_t n_faces = 0, entered = 0;
  const gmds_id *faces = read_0_2(s->m, &s->faces, v, &n_faces);
  s->joined.n = 0;
  for (size_t i = 0; i < n_faces; i++) {
    size_t n = 0, k = 0;
    const gmds_id *nodes = read_2_0(s->m, &s->nodes, faces[i], &n);
    while (nodes[k] != v)
      k++;
    s->joined.data[s->joined.n++] = nodes[k + 1 < n ? k + 1 : 0];
    s->joined.data[s->joined.n++] = nodes[k ? k - 1 : n - 1];
  }
  entered = s->joined.n;
  gmds_ids_keep(&s->joined, 0, 2, GMDS_NONE);
  if (2 * s->joined.n != entered) /* a side with one face, or with more than two */
    s->joined.n = 0;
}

/* Whether every corner that v takes part in turns as before with v at x. */
static inline int keeps_turns(const smoother *s, gmds_id v, const double *x)
{
  size_t n_faces = 0;
  const gmds_id *faces = read_0_2(s->m, &s->faces, v, &n_faces);
  for (size_t i = 0; i < n_faces; i++) {
    size_t n = 0, at = 0;
    const gmds_id *nodes = read_2_0(s->m, &s->nodes, faces[i], &n);
    while (nodes[at] != v)
      at++;
    for (size_t q = 0; q < (n == 3 ? 1 : 3); q++) { /* of a triangle all corners turn alike */
      size_t k = (at + q) % n;
      k = q == 2 ? (at + n - 1) % n : k;
      int before = corner_turn(s->m, nodes, n, k, v, point(s->m, v));
      if (before && corner_turn(s->m, nodes, n, k, v, x) != before)
        return 0;
    }
  }
  return 1;
}

static inline size_t smooth_node(smoother *s, gmds_id v)
{
  double x[2] = {0, 0};
  gather_joined(s, v);
  if (!s->joined.n)
    return 0;
  for (size_t i = 0; i < s->joined.n; i++) {
    const double *p = point(s->m, s->joined.data[i]);
    x[0] += p[0] / (double)s->joined.n;
    x[1] += p[1] / (double)s->joined.n;
  }
  const double *old = point(s->m, v);
  if ((x[0] == old[0] && x[1] == old[1]) || !keeps_turns(s, v, x))
    return 0;
  set_point(s->m, v, x);
  return 1;
}

static inline gmds_status smooth(mesh *m, size_t sweeps, size_t *moved)
{
  smoother s = {.m = m};
  size_t most = 0, n = 0, last = 0;
  gmds_csr_init(&s.nodes, mesh_memory(m));
  gmds_csr_init(&s.faces, mesh_memory(m));
  gmds_ids_init(&s.joined, mesh_memory(m));
  gmds_status status = prepare_2_0(m, &s.nodes);
  if (status == GMDS_OK)
    status = prepare_0_2(m, &s.faces);
  for (gmds_id v = next_0(m, 0); status == GMDS_OK && v != GMDS_NONE; v = next_0(m, v + 1)) {
    (void)read_0_2(m, &s.faces, v, &n);
    most = n > most ? n : most;
  }
  if (status == GMDS_OK)
    status = gmds_ids_reserve(&s.joined, 2 * most);
  for (size_t k = 0; status == GMDS_OK && k < sweeps; k++) {
    last = 0;
    for (gmds_id v = next_0(m, 0); v != GMDS_NONE; v = next_0(m, v + 1))
      last += smooth_node(&s, v);
  }
  gmds_csr_clear(&s.nodes);
  gmds_csr_clear(&s.faces);
  gmds_ids_clear(&s.joined);
  if (status == GMDS_OK && moved)
    *moved = last;
  return status;
}
#    undef smoother
#    undef corner_turn
#    undef gather_joined
#    undef keeps_turns
#    undef smooth_node
#    undef smooth
#  endif
#endif /* surfaces */
