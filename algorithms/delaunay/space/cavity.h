/* The cavity of a point: which tetrahedra are in conflict with it, and the walls around them. */

/* Whether p is in conflict with the tetrahedron of nodes v, when a filter does not tell or one of them is the ghost: then
 * it is beyond the finite face, or in the plane of it and within its circle. */
__attribute__((cold, noinline)) static unsigned in_conflict_exactly(const insertion *in, const gmds_id v[4],
                                                                    const double p[3])
{
  const mesh *m = in->m;
  const double *q[4], *finite[3] = {NULL, NULL, NULL};
  int ghosts = 0, n = 0;
  for (int k = 0; k < 4; k++) {
    q[k] = point(m, v[k]);
    if (v[k] == in->ghost) {
      q[k] = p;
      ghosts++;
    } else if (n < 3)
      finite[n++] = q[k];
  }
  if (!ghosts)
    return gmds_insphere_perturbed_exact(q[0], q[1], q[2], q[3], p) > 0;
  int side = gmds_orient3d(q[0], q[1], q[2], q[3]);
  return (side ? side : gmds_coplanar_incircle_perturbed(finite[0], finite[1], finite[2], p)) > 0;
}

/* Whether the sphere of v holds p, and twice whether that of w does. */
static inline unsigned in_conflict(const insertion *in, const gmds_id v[4], const gmds_id w[4], const double p[3])
{
  const mesh *m = in->m;
  unsigned undecided = 0;
  unsigned inside = gmds_insphere_filter_pair(point(m, v[0]), point(m, v[1]), point(m, v[2]), point(m, v[3]),
                                              point(m, w[0]), point(m, w[1]), point(m, w[2]), point(m, w[3]), p,
                                              &undecided);
  if (undecided & 1)
    inside |= in_conflict_exactly(in, v, p);
  if (undecided & 2)
    inside |= in_conflict_exactly(in, w, p) << 1;
  return inside;
}

/* Room in the lists for a cavity of n, which has at most 2 n + 2 walls and tests at most 4 n. */
static inline gmds_status reserve_cavity(insertion *in, size_t n)
{
  if (n <= in->capacity)
    return GMDS_OK;
  const size_t had = in->capacity, grown = gmds_grown(had, n < 64 ? 64 : n);
  void *block[5] = {in->cavity, in->tested, in->walls, in->regions, in->ids};
  const size_t bytes[5] = {sizeof *in->cavity, 4 * sizeof *in->tested, 4 * sizeof *in->walls, 4 * sizeof *in->regions,
                           4 * sizeof *in->ids};
  int done = 0;
  while (done < 5 && gmds_resize(mesh_memory(in->m), &block[done], had, grown, bytes[done]))
    done++;
  for (int k = 0; k < done && done < 5; k++) /* all grow or none */
    (void)gmds_resize(mesh_memory(in->m), &block[k], grown, had, bytes[k]);
  in->cavity = block[0];
  in->tested = block[1];
  in->walls = block[2];
  in->regions = block[3];
  in->ids = block[4];
  if (done < 5)
    return GMDS_ERR_MEMORY;
  in->capacity = grown;
  return GMDS_OK;
}

/* Marks for all regions that there are. */
static inline gmds_status reserve_marks(insertion *in, size_t n)
{
  if (n <= in->marked)
    return GMDS_OK;
  void *marks = in->marks;
  const size_t grown = in->marked ? gmds_grown(in->marked, n) : n;
  if (!gmds_resize(mesh_memory(in->m), &marks, in->marked, grown, sizeof *in->marks))
    return GMDS_ERR_MEMORY;
  in->marks = marks;
  memset(in->marks + in->marked, 0, (grown - in->marked) * sizeof *in->marks);
  in->marked = grown;
  return GMDS_OK;
}

/* Appends what lies beyond the faces of one of the cavity and was not tested yet. */
static inline gmds_status visit(insertion *in, const candidate *c, size_t i, gmds_id outside, size_t *n_tested)
{
  tetrahedron *t = &in->cavity[i];
#if GMDS_ACROSS
  GMDS_TRY(load(in, c, t));
#else
  candidate around[4];
  GMDS_TRY(load_around(in, c, t, around));
#endif
  for (unsigned k = 0; k < 4; k++) {
    const gmds_id next = t->beyond[k], mark = in->marks[next];
#if GMDS_ACROSS
    in->tested[*n_tested] = (candidate){next};
#else
    in->tested[*n_tested] = around[k];
#endif
    *n_tested += mark < outside;
    in->marks[next] = mark < outside ? outside : mark;
  }
  return GMDS_OK;
}

/* Gathers the cavity of node v from a tetrahedron in it, breadth first. Each tetrahedron is tested once, two at a time, and
 * appended without a branch. */
static inline gmds_status grow_cavity(insertion *in, const candidate *root, gmds_id v)
{
  const double *p = point(in->m, v);
  const gmds_id outside = 2 * v;
  size_t n = 1, n_tested = 0, done = 0;
  GMDS_TRY(reserve_cavity(in, 8));
  candidate *queue = (candidate *)(void *)in->walls; /* of the cavity: walls are written when it is empty */
  _Static_assert(sizeof(candidate) <= sizeof(gmds_cavity_wall), "gmds: candidates take the place of walls");
  queue[0] = *root;
  in->marks[root->region] = outside + 1;
  for (size_t i = 0; i < n; i++) {
    GMDS_TRY(reserve_cavity(in, n + 8));
    queue = (candidate *)(void *)in->walls;
    GMDS_TRY(visit(in, &queue[i], i, outside, &n_tested));
    /* one that is left over waits for another as long as there can be one; then it is tested beside itself */
    while (done + 2 <= n_tested || (i + 1 == n && done < n_tested)) {
      const int two = done + 1 < n_tested;
      const candidate *first = &in->tested[done], *second = &in->tested[two ? done + 1 : done];
      const unsigned inside = in_conflict(in, nodes_of(in, first), nodes_of(in, second), p) & (two ? 3u : 1u);
      queue[n] = *second;
      n += inside >> 1;
      in->marks[second->region] = outside + (inside >> 1);
      queue[n] = *first;
      n += inside & 1;
      in->marks[first->region] = outside + (inside & 1);
      done += two ? 2 : 1;
    }
  }
  in->n_cavity = n;
  return GMDS_OK;
}

/* The number of a node within the boundary at work, the next one if it has none. */
static inline unsigned number_of(gmds_id *local, gmds_id v, gmds_id base, gmds_id *count)
{
  const gmds_id had = local[v], next = base + *count, is_new = had < base, l = had ^ ((had ^ next) & (0 - is_new));
  local[v] = l;
  *count += is_new;
  return (unsigned)(l - base);
}

/* The walls: faces of the cavity whose other side is outside, turned inwards, their nodes numbered. */
static inline void find_walls(insertion *in, gmds_id v)
{
  const gmds_id inside = 2 * v + 1, *marks = in->marks, base = in->base;
  const tetrahedron *cavity = in->cavity;
  gmds_id *sides = in->ids, *local = in->local, count = 0; /* sides: 4 * place + face */
  size_t n = 0;
  for (size_t i = 0; i < in->n_cavity; i++) {
    in->regions[i] = cavity[i].region;
    for (size_t k = 0; k < 4; k++) {
      sides[n] = (gmds_id)(4 * i + k);
      n += marks[cavity[i].beyond[k]] != inside;
    }
  }
  for (size_t i = 0; i < n; i++) {
    const tetrahedron *t = &cavity[sides[i] >> 2];
    const unsigned k = (unsigned)(sides[i] & 3);
    const unsigned char *on = face_nodes[k];
    gmds_cavity_wall *w = &in->walls[i];
    w->node[0] = t->node[on[0]];
    w->node[1] = t->node[on[2]];
    w->node[2] = t->node[on[1]];
    w->out = t->beyond[k];
    w->out_side = t->arrival[k];
    for (int q = 0; q < 3; q++)
      w->local[q] = number_of(local, w->node[q], base, &count);
  }
  in->n_walls = n;
  in->base = base + count;
  if (in->base > GMDS_NONE / 2) { /* numbers are used up */
    memset(in->local, 0, (count_0(in->m)) * sizeof *in->local);
    in->base = 1;
  }
}

static inline gmds_status insert_point(insertion *in, gmds_id v)
{
  candidate root;
  GMDS_TRY(locate(in, point(in->m, v), &root));
  GMDS_TRY(grow_cavity(in, &root, v));
  find_walls(in, v);
  GMDS_TRY(star(in->m, v, in->n_cavity, in->regions, in->n_walls, in->walls, in->ids));
  GMDS_TRY(reserve_marks(in, end_3(in->m)));
  size_t i = 0; /* a cavity has a wall without the ghost */
  while (in->walls[i].node[0] == in->ghost || in->walls[i].node[1] == in->ghost || in->walls[i].node[2] == in->ghost)
    i++;
#if GMDS_ACROSS
  in->last = (candidate){in->ids[i]};
#else
  in->last = (candidate){in->ids[i], {in->walls[i].node[0], in->walls[i].node[1], in->walls[i].node[2], v}};
#endif
  return GMDS_OK;
}
