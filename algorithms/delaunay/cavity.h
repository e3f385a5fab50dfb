/* The cavity of a point: the triangles whose circles hold it, a tree since no node lies inside. */

/* Whether the circle of t holds p. That of an infinite triangle (a, b, ghost) is the half-plane left of a -> b and the
 * open segment between them. */
static inline int in_conflict(const insertion *in, const gmds_cavity_face *t, const double p[2])
{
  const mesh *m = in->m;
  const gmds_id *v = t->node;
  if (v[0] != in->ghost && v[1] != in->ghost && v[2] != in->ghost)
    return gmds_incircle_perturbed(point(m, v[0]), point(m, v[1]), point(m, v[2]), p) > 0;
  unsigned g = v[0] == in->ghost ? 0 : v[1] == in->ghost ? 1 : 2;
  const double *a = point(m, v[(g + 1) % 3]), *b = point(m, v[(g + 2) % 3]);
  int side = gmds_orient2d(a, b, p);
  return side ? side > 0 : gmds_compare_points(2, a, p) * gmds_compare_points(2, p, b) > 0;
}

/* Room in the lists for a cavity of n faces. */
static inline gmds_status reserve_cavity(insertion *in, size_t n)
{
  if (n <= in->capacity)
    return GMDS_OK;
  gmds_memory *memory = mesh_memory(in->m);
  size_t had = in->capacity, grown = gmds_grown(had, n < 32 ? 32 : n);
  void *block[5] = {in->faces, in->sides, in->ids, in->stack, in->around};
  const size_t bytes[5] = {sizeof *in->faces, sizeof *in->sides, sizeof *in->ids, sizeof *in->stack,
                           GMDS_ACROSS ? 0 : sizeof *in->around};
  const size_t more[5] = {0, 2, 2, 2, 0};
  int done = 0;
  while (done < 5 && gmds_resize(memory, &block[done], had ? had + more[done] : 0, grown + more[done], bytes[done]))
    done++;
  for (int k = 0; k < done && done < 5; k++) /* all grow or none */
    (void)gmds_resize(memory, &block[k], grown + more[k], had ? had + more[k] : 0, bytes[k]);
  in->faces = block[0];
  in->sides = block[1];
  in->ids = block[2];
  in->stack = block[3];
  in->around = block[4];
  if (done < 5)
    return GMDS_ERR_MEMORY;
  in->capacity = grown;
  return GMDS_OK;
}

static inline gmds_status add_to_cavity(insertion *in, const gmds_cavity_face *t)
{
  GMDS_TRY(reserve_cavity(in, in->n_faces + 1));
#if !GMDS_ACROSS
  GMDS_TRY(neighbours(in, t, in->around[in->n_faces]));
#endif
  in->faces[in->n_faces++] = *t;
  return GMDS_OK;
}

/* Gathers the cavity of p from a triangle in it, depth first: sides that lead out are met in order around it. */
static inline gmds_status grow_cavity(insertion *in, const double p[2], const gmds_cavity_face *root)
{
  size_t depth = 0;
  in->n_faces = in->n_sides = 0;
  GMDS_TRY(add_to_cavity(in, root));
  for (unsigned q = 3; q-- > 0;)
    in->stack[depth++] = q;
  while (depth) {
    uint64_t top = in->stack[--depth];
    size_t c = (size_t)(top >> 2);
    unsigned q = (unsigned)(top & 3);
    gmds_cavity_face beyond;
#if GMDS_ACROSS
    GMDS_TRY(step_over(in, &in->faces[c], q, &beyond));
#else
    beyond = in->around[c][q];
#endif
    if (in_conflict(in, &beyond, p)) {
      GMDS_TRY(add_to_cavity(in, &beyond));
      in->stack[depth++] = 4 * (uint64_t)(in->n_faces - 1) + 2;
      in->stack[depth++] = 4 * (uint64_t)(in->n_faces - 1) + 1;
    } else {
      const gmds_id *v = in->faces[c].node;
      in->sides[in->n_sides++] =
          (gmds_cavity_side){v[q], v[q < 2 ? q + 1 : 0], (unsigned)c, q, beyond.face, beyond.side};
    }
  }
  return GMDS_OK;
}

static inline gmds_status insert_point(insertion *in, gmds_id v)
{
  gmds_cavity_face root;
  const double *p = point(in->m, v);
  GMDS_TRY(locate(in, p, &root));
  GMDS_TRY(grow_cavity(in, p, &root));
  GMDS_TRY(star(in->m, v, in->n_faces, in->faces, in->n_sides, in->sides, in->ids));
  size_t i = 0; /* of two sides that follow each other, one at least has no ghost, or the next has none */
  while (in->sides[i].a == in->ghost || in->sides[i].b == in->ghost)
    i++;
  in->last = (gmds_cavity_face){in->ids[i], {in->sides[i].a, in->sides[i].b, v}, 0};
  return GMDS_OK;
}
