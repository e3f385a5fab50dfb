/* Stepping from tetrahedron to tetrahedron, and the walk to a point. */

/* A tetrahedron in hand: its nodes in positive order, and what lies beyond its faces (shapes.h numbers them). In models
 * with GMDS_ACROSS the order is the mesh's, and an entry is 4 * region + the number of the face there; in others it
 * comes from the step by which it was reached, and an entry is a region. */
typedef struct tetrahedron {
  gmds_id node[4];
  gmds_id beyond[4];
} tetrahedron;

/* One that is going to be tested. */
typedef struct candidate {
  gmds_id region;
#if !GMDS_ACROSS
  gmds_id node[4];
#endif
} candidate;

/* The state of an insertion. Its lists come from the mesh's memory. */
typedef struct insertion {
  mesh *m;
  gmds_id ghost;
  candidate last; /* a finite tetrahedron near the last point */
  size_t steps;   /* of all walks */
  gmds_id *marks; /* of each region: stamp + 1 in the cavity at work, stamp tested and outside, else less */
  size_t marked;  /* how many there are */
  gmds_id stamp;  /* even, of each cavity its own */
  gmds_id *local; /* of each node: base + its number within the boundary at work, else less */
  size_t numbered;
  gmds_id base;
  size_t capacity; /* the lists hold cavities of so many tetrahedra */
  tetrahedron *cavity;
  gmds_id *ids;            /* of the cavity, then of its star: 4 capacity */
  candidate *tested;       /* 4 capacity */
  gmds_id *sides;          /* 4 * place in the cavity + face, for each face of its boundary: 4 capacity */
  gmds_cavity_wall *walls; /* 4 capacity */
  size_t n_cavity, n_walls;
  gmds_ids near, nodes; /* answers of queries */
#if GMDS_CONCURRENT_STARS
  gmds_id fresh, fresh_end; /* regions taken in advance */
  gmds_id spare;            /* the first of those that nothing uses any more; its mark is the next */
  size_t n_spare;
  size_t ghost_at; /* where this thread keeps the number of the ghost in `local` */
  int axis;        /* the nodes of this thread have their coordinate number `axis` from low to below high */
  double low, high;
  int deferred;    /* the point in hand cannot be inserted by this thread alone */
  char apart[128]; /* what one thread writes shares no cache line with what another does */
#endif
} insertion;

#include <gmds/algorithms/delaunay/sharing.h>

/* How far apart the numbers of the ghost are that several threads have: on cache lines of their own. */
#define GMDS__OF_GHOST 16

/* The nodes of each face, counter-clockwise from outside, and the one opposite. */
static const unsigned char face_nodes[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}};
static const unsigned char opposite_node[4] = {2, 0, 1, 3};

static inline int is_finite(const insertion *in, const gmds_id v[4])
{
  return (v[0] != in->ghost) & (v[1] != in->ghost) & (v[2] != in->ghost) & (v[3] != in->ghost);
}

#if GMDS_ACROSS

static inline gmds_id region_beyond(const tetrahedron *t, size_t k)
{
  return t->beyond[k] >> 2;
}

static inline unsigned face_beyond(const tetrahedron *t, size_t k)
{
  return t->beyond[k] & 3;
}

static inline candidate candidate_of(gmds_id region, const gmds_id node[4])
{
  (void)node;
  return (candidate){region};
}

static inline const gmds_id *nodes_of(const insertion *in, const candidate *c)
{
  size_t n = 0;
  return view_3_0(in->m, c->region, &n);
}

/* Puts tetrahedron c on place i of the cavity. */
static inline void append(insertion *in, size_t i, const candidate *c)
{
  in->ids[i] = c->region;
}

/* Reads what was put on place i, and the tetrahedra beyond its faces into around[0 .. 3]. */
static inline gmds_status load(insertion *in, size_t i, candidate around[4])
{
  tetrahedron *t = &in->cavity[i];
  tetrahedron_nodes(in->m, in->ids[i], t->node);
  across_all(in->m, in->ids[i], t->beyond);
  for (int k = 0; k < 4; k++)
    around[k] = (candidate){t->beyond[k] >> 2};
  return GMDS_OK;
}

#else

/* Reads the tetrahedron that a candidate is, whose nodes have their order already, and with it those beyond its faces:
 * around[k], ordered so that its face 3 is the one it shares with t. */
static inline gmds_status load_around(insertion *in, const candidate *c, tetrahedron *t, candidate around[4])
{
  memcpy(t->node, c->node, sizeof t->node);
  for (int k = 0; k < 4; k++)
    t->beyond[k] = GMDS_NONE;
  GMDS_TRY(get_adj_3_3(in->m, c->region, &in->near));
  for (size_t i = 0; i < in->near.n; i++) {
    gmds_id apex = GMDS_NONE;
    unsigned shared = 0;
    GMDS_TRY(get_adj_3_0(in->m, in->near.data[i], &in->nodes));
    for (size_t q = 0; q < in->nodes.n; q++) {
      unsigned at = 0;
      while (at < 4 && t->node[at] != in->nodes.data[q])
        at++;
      if (at < 4)
        shared |= 1u << at;
      else
        apex = in->nodes.data[q];
    }
    for (unsigned k = 0; k < 4; k++)
      if (shared == (15u ^ 1u << opposite_node[k])) {
        const unsigned char *on = face_nodes[k];
        t->beyond[k] = in->near.data[i];
        around[k] = (candidate){in->near.data[i], {t->node[on[0]], t->node[on[1]], t->node[on[2]], apex}};
      }
  }
  for (int k = 0; k < 4; k++)
    if (t->beyond[k] == GMDS_NONE)
      return GMDS_ERR_INVARIANT;
  return GMDS_OK;
}

static inline gmds_id region_beyond(const tetrahedron *t, size_t k)
{
  return t->beyond[k];
}

static inline unsigned face_beyond(const tetrahedron *t, size_t k)
{
  (void)t;
  (void)k;
  return 0;
}

static inline candidate candidate_of(gmds_id region, const gmds_id node[4])
{
  return (candidate){region, {node[0], node[1], node[2], node[3]}};
}

static inline const gmds_id *nodes_of(const insertion *in, const candidate *c)
{
  (void)in;
  return c->node;
}

static inline void append(insertion *in, size_t i, const candidate *c)
{
  in->ids[i] = c->region;
  memcpy(in->cavity[i].node, c->node, sizeof c->node);
}

static inline gmds_status load(insertion *in, size_t i, candidate around[4])
{
  const candidate c = candidate_of(in->ids[i], in->cavity[i].node);
  return load_around(in, &c, &in->cavity[i], around);
}

#endif

/* A tetrahedron that p lies in, or one at the ghost that it is in conflict with. The walk crosses any face that p is
 * beyond; in a Delaunay triangulation, perturbed or not, it does not return. */
#if GMDS_ACROSS
GMDS_APART gmds_status locate(insertion *in, const double p[3], candidate *found)
{
  const mesh *m = in->m;
  gmds_id at = in->last.region;
  unsigned from = 4;
  for (;;) {
    size_t n = 0;
    const gmds_id *v = view_3_0(m, at, &n);
    unsigned k = 0;
    for (; k < 4; k++)
      if (k != from && gmds_orient3d(point(m, v[face_nodes[k][0]]), point(m, v[face_nodes[k][1]]),
                                     point(m, v[face_nodes[k][2]]), p) > 0)
        break;
    if (k == 4)
      break;
    at = across(m, at, k, &from);
    in->steps++;
    if (view_3_0(m, at, &n)[opposite_node[from]] == in->ghost)
      break;
  }
  found->region = at;
  return GMDS_OK;
}
#else
GMDS_APART gmds_status locate(insertion *in, const double p[3], candidate *found)
{
  const mesh *m = in->m;
  candidate at = in->last, around[4];
  unsigned from = 4; /* face 3 of what a step arrives at is the one it came over */
  for (;;) {
    tetrahedron t;
    const gmds_id *v = at.node;
    unsigned k = 0;
    for (; k < 4; k++)
      if (k != from && gmds_orient3d(point(m, v[face_nodes[k][0]]), point(m, v[face_nodes[k][1]]),
                                     point(m, v[face_nodes[k][2]]), p) > 0)
        break;
    if (k == 4)
      break;
    GMDS_TRY(load_around(in, &at, &t, around));
    at = around[k];
    from = 3;
    in->steps++;
    if (!is_finite(in, at.node))
      break;
  }
  *found = at;
  return GMDS_OK;
}
#endif
