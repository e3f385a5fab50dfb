/* Stepping from triangle to triangle, and the walk to a point. */

/* The predicates: of the plane, or of points of one plane in space. */
static inline int turn_of(const double *a, const double *b, const double *c)
{
#if GMDS_COORDINATES == 2
  return gmds_orient2d(a, b, c);
#else
  return gmds_coplanar_orientation(a, b, c);
#endif
}

static inline int circle_side(const double *a, const double *b, const double *c, const double *p)
{
#if GMDS_COORDINATES == 2
  return gmds_incircle_perturbed(a, b, c, p);
#else
  return gmds_coplanar_incircle_perturbed(a, b, c, p);
#endif
}

/* A side of the cavity found so far that is still to be crossed, or to be added to the boundary. */
typedef struct pending_side {
  gmds_cavity_face beyond;
  unsigned in, in_side; /* as in gmds_cavity_side */
  unsigned inside;      /* whether `beyond` is in the cavity */
} pending_side;

#if GMDS_CONCURRENT_STARS
typedef struct face_range {
  gmds_id first, end;
} face_range;
#endif

/* The state of an insertion. Its lists come from the mesh's memory. */
typedef struct insertion {
  mesh *m;
  gmds_id ghost;
  gmds_cavity_face last;   /* a finite triangle near the last point */
  size_t n_faces, n_sides; /* of the cavity */
  size_t steps;            /* of all walks */
  size_t capacity;         /* the lists hold as many faces, and two more sides */
  gmds_cavity_face *faces;
  gmds_cavity_side *sides;
  gmds_id *ids;
  pending_side *pending;
  gmds_ids near, nodes; /* answers of queries */
#if GMDS_CONCURRENT_STARS
  face_range fresh; /* faces taken in advance, and where there are more */
  const face_range *more;
  int axis; /* the nodes of this thread have their coordinate number `axis` from low to below high */
  double low, high;
  int deferred;    /* the point in hand cannot be inserted by this thread alone */
  char apart[128]; /* what one thread writes shares no cache line with what another does */
#endif
} insertion;

#include <gmds/algorithms/delaunay/sharing.h>

#if GMDS_ACROSS

/* The triangle beyond side q of t, entered over its side 0. */
static inline gmds_status step_over(insertion *in, const gmds_cavity_face *t, unsigned q, gmds_cavity_face *beyond)
{
  unsigned number = t->side + q, arrival = 0;
  gmds_id g = across(in->m, t->face, number < 3 ? number : number - 3, &arrival);
  beyond->face = g;
  beyond->side = arrival;
  beyond->node[0] = t->node[q < 2 ? q + 1 : 0];
  beyond->node[1] = t->node[q];
  beyond->node[2] = face_node(in->m, g, arrival < 1 ? arrival + 2 : arrival - 1);
  return GMDS_OK;
}

/* The triangles beyond sides 1 and 2 of t, each entered over its side 0. */
static inline gmds_status leave(insertion *in, const gmds_cavity_face *t, gmds_cavity_face *left,
                                gmds_cavity_face *right)
{
  GMDS_TRY(step_over(in, t, 1, left));
  return step_over(in, t, 2, right);
}

#else

/* The triangles beyond the three sides of t, each entered over its side 0: the adjacent faces, told apart by the nodes
 * that they share with t. */
static inline gmds_status neighbours(insertion *in, const gmds_cavity_face *t, gmds_cavity_face beyond[3])
{
  int found = 0;
  GMDS_TRY(get_adj_2_2(in->m, t->face, &in->near));
  for (size_t i = 0; i < in->near.n; i++) {
    GMDS_TRY(get_adj_2_0(in->m, in->near.data[i], &in->nodes));
    gmds_id third = GMDS_NONE;
    int absent[3] = {1, 1, 1}, shared = 0;
    for (size_t k = 0; k < in->nodes.n; k++) {
      gmds_id v = in->nodes.data[k];
      int own = 0;
      for (unsigned q = 0; q < 3; q++)
        if (t->node[q] == v) {
          absent[q] = 0;
          own = 1;
        }
      shared += own;
      if (!own)
        third = v;
    }
    if (shared != 2)
      return GMDS_ERR_INVARIANT;
    unsigned apex = absent[0] ? 0 : absent[1] ? 1 : 2, q = (apex + 1) % 3; /* the shared side begins after the apex */
    beyond[q] = (gmds_cavity_face){in->near.data[i], {t->node[(q + 1) % 3], t->node[q], third}, 0};
#  if GMDS_ORDERED_2_0
    while (in->nodes.data[beyond[q].side] != beyond[q].node[0])
      beyond[q].side++;
#  endif
    found |= 1 << q;
  }
  return found == 7 ? GMDS_OK : GMDS_ERR_INVARIANT;
}

static inline gmds_status step_over(insertion *in, const gmds_cavity_face *t, unsigned q, gmds_cavity_face *beyond)
{
  gmds_cavity_face all[3];
  GMDS_TRY(neighbours(in, t, all));
  *beyond = all[q];
  return GMDS_OK;
}

static inline gmds_status leave(insertion *in, const gmds_cavity_face *t, gmds_cavity_face *left,
                                gmds_cavity_face *right)
{
  gmds_cavity_face all[3];
  GMDS_TRY(neighbours(in, t, all));
  *left = all[1];
  *right = all[2];
  return GMDS_OK;
}

#endif

/* Walks from the last triangle to one whose circle holds p: the finite triangle that p lies in or on, or the infinite
 * one beyond a side of the hull that p lies outside of. A visibility walk: in a Delaunay triangulation it never meets
 * a triangle twice (Edelsbrunner 1990). */
GMDS_SPECIALISED gmds_status locate(insertion *in, const double p[GMDS_COORDINATES], int sharing,
                                    gmds_cavity_face *found)
{
  const mesh *m = in->m;
  gmds_cavity_face t = in->last;
  unsigned q = 0;
  while (q < 3) {
    if (turn_of(point(m, t.node[q]), point(m, t.node[q < 2 ? q + 1 : 0]), p) >= 0) {
      q++;
      continue;
    }
    gmds_cavity_face next;
    if (sharing == GMDS__SHARED)
      in->last = t; /* so that a point that is put off does not make the next walk longer */
    in->steps++;
    GMDS_TRY(step_over(in, &t, q, &next));
    t = next;
    if (t.node[2] == in->ghost)
      break;
    if (sharing == GMDS__SHARED && !owns(in, t.node[2])) {
      defer(in);
      break;
    }
    q = 1; /* p lies on this side of side 0 */
  }
  *found = t;
  return GMDS_OK;
}
