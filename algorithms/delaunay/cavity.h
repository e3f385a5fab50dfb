/* The cavity of a point: the triangles whose circles hold it, a tree since no node lies inside. */

/* What the filter leaves undecided. The circle of an infinite triangle (a, b, ghost) is the half-plane left of a -> b
 * and the open segment between them; the ghost's coordinates, not numbers, leave it undecided. */
__attribute__((cold)) static inline int in_conflict_exactly(const insertion *in, gmds_id v0, gmds_id v1, gmds_id v2,
                                                            const double p[GMDS_COORDINATES])
{
  const mesh *m = in->m;
  const gmds_id v[3] = {v0, v1, v2};
  if (v[0] != in->ghost && v[1] != in->ghost && v[2] != in->ghost)
    return circle_side(point(m, v[0]), point(m, v[1]), point(m, v[2]), p) > 0;
  unsigned g = v[0] == in->ghost ? 0 : v[1] == in->ghost ? 1 : 2;
  const double *a = point(m, v[(g + 1) % 3]), *b = point(m, v[(g + 2) % 3]);
  int side = turn_of(a, b, p);
  return side ? side > 0
              : gmds_compare_points(GMDS_COORDINATES, a, p) * gmds_compare_points(GMDS_COORDINATES, p, b) > 0;
}

/* Whether the circle of s holds p, and twice whether that of t does. */
static inline unsigned in_conflict(const insertion *in, const gmds_cavity_face *s, const gmds_cavity_face *t,
                                   const double p[GMDS_COORDINATES])
{
  const mesh *m = in->m;
  const gmds_id *v = s->node, *w = t->node;
#if GMDS_COORDINATES == 2
  unsigned undecided = 0,
           inside = gmds_incircle_filter_pair(point(m, v[0]), point(m, v[1]), point(m, v[2]), point(m, w[0]),
                                              point(m, w[1]), point(m, w[2]), p, &undecided);
#else
  unsigned undecided = 3, inside = 0; /* no filter for points of a plane in space */
  (void)m;
#endif
  if (undecided & 1)
    inside |= (unsigned)in_conflict_exactly(in, v[0], v[1], v[2], p);
  if (undecided & 2)
    inside |= (unsigned)in_conflict_exactly(in, w[0], w[1], w[2], p) << 1;
  return inside;
}

/* Room in the lists for a cavity of n faces. */
static inline gmds_status reserve_cavity(insertion *in, size_t n)
{
  if (n <= in->capacity)
    return GMDS_OK;
  gmds_memory *memory = mesh_memory(in->m);
  size_t had = in->capacity, grown = gmds_grown(had, n < 32 ? 32 : n);
  void *block[4] = {in->faces, in->sides, in->ids, in->pending};
  const size_t bytes[4] = {sizeof *in->faces, sizeof *in->sides, sizeof *in->ids, sizeof *in->pending};
  const size_t more[4] = {0, 2, 2, 0};
  int done = 0;
  while (done < 4 && gmds_resize(memory, &block[done], had ? had + more[done] : 0, grown + more[done], bytes[done]))
    done++;
  for (int k = 0; k < done && done < 4; k++) /* all grow or none */
    (void)gmds_resize(memory, &block[k], grown + more[k], had ? had + more[k] : 0, bytes[k]);
  in->faces = block[0];
  in->sides = block[1];
  in->ids = block[2];
  in->pending = block[3];
  if (done < 4)
    return GMDS_ERR_MEMORY;
  in->capacity = grown;
  return GMDS_OK;
}

/* Side q of face c of the cavity, beyond which `out` is not in it. */
static inline void add_side(insertion *in, size_t c, unsigned q, const gmds_cavity_face *out)
{
  in->sides[in->n_sides++] = (gmds_cavity_side){out->node[1], out->node[0], out->face, out->side, (unsigned)c, q};
}

/* Gathers the cavity of p from a triangle in it, depth first: the sides of its boundary are met in order around it.
 * Both sides by which a triangle is left are tested at once. */
GMDS_SPECIALISED gmds_status grow_cavity(insertion *in, const double p[GMDS_COORDINATES], int sharing,
                                         const gmds_cavity_face *root)
{
  size_t depth = 0, faces = 0;
  gmds_cavity_face t = *root, left, right;
  GMDS_TRY(reserve_cavity(in, 1));
  GMDS_TRY(step_over(in, root, 0, &left));
  in->pending[depth++] = (pending_side){left, 0, 0, in_conflict(in, &left, &left, p) & 1};
  in->n_sides = 0;
  for (;;) {
    size_t c = faces++;
    if (sharing == GMDS__SHARED && (faces == in->capacity || !owns(in, t.node[2]))) {
      defer(in);
      return GMDS_OK;
    }
    GMDS_TRY(reserve_cavity(in, faces + 1));
    in->faces[c] = t;
    GMDS_TRY(leave(in, &t, &left, &right));
    unsigned inside = in_conflict(in, &left, &right, p);
    if (inside & 1) {
      in->pending[depth++] = (pending_side){right, (unsigned)c, 2, inside >> 1};
      t = left;
      continue;
    }
    add_side(in, c, 1, &left);
    if (inside >> 1) {
      t = right;
      continue;
    }
    add_side(in, c, 2, &right);
    while (depth && !in->pending[depth - 1].inside) {
      const pending_side *side = &in->pending[--depth];
      add_side(in, side->in, side->in_side, &side->beyond);
    }
    if (!depth)
      break;
    t = in->pending[--depth].beyond;
  }
  in->n_faces = faces;
  return GMDS_OK;
}

#if GMDS_CONCURRENT_STARS
static inline gmds_id take_fresh(insertion *in)
{
  if (in->fresh.first == in->fresh.end)
    in->fresh = *in->more++;
  return in->fresh.first++;
}
#endif

GMDS_SPECIALISED gmds_status insert_point(insertion *in, gmds_id v, int sharing)
{
  gmds_cavity_face root;
  const double *p = point(in->m, v);
  GMDS_TRY(locate(in, p, sharing, &root));
  if (sharing == GMDS__SHARED && is_deferred(in))
    return GMDS_OK;
  GMDS_TRY(grow_cavity(in, p, sharing, &root));
  if (sharing == GMDS__SHARED && is_deferred(in))
    return GMDS_OK;
#if GMDS_CONCURRENT_STARS
  in->ids[in->n_faces] = take_fresh(in);
  in->ids[in->n_faces + 1] = take_fresh(in);
  star_of(in->m, v, in->n_faces, in->faces, in->n_sides, in->sides, in->ids);
#else
  GMDS_TRY(star(in->m, v, in->n_faces, in->faces, in->n_sides, in->sides, in->ids));
#endif
  size_t i = in->n_sides - 1; /* of two sides in a row one at least has no ghost, or the one before them has none */
  while (in->sides[i].a == in->ghost || in->sides[i].b == in->ghost)
    i--;
  in->last = (gmds_cavity_face){in->ids[i], {in->sides[i].a, in->sides[i].b, v}, 0};
  return GMDS_OK;
}

static inline gmds_status insert_alone(insertion *in, gmds_id v)
{
  return insert_point(in, v, GMDS__ALONE);
}

#if GMDS_CONCURRENT_STARS
static inline gmds_status insert_shared(insertion *in, gmds_id v)
{
  return insert_point(in, v, GMDS__SHARED);
}
#endif
