/* The cavity of a point: which tetrahedra are in conflict with it, and the walls around them. */

/* Whether p is in conflict with the tetrahedron of nodes v, when a filter does not tell or one of them is the ghost:
 * then it is beyond the finite face, or in the plane of it and within its circle. */
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
  unsigned inside =
      gmds_insphere_filter_pair(point(m, v[0]), point(m, v[1]), point(m, v[2]), point(m, v[3]), point(m, w[0]),
                                point(m, w[1]), point(m, w[2]), point(m, w[3]), p, &undecided);
  if (undecided & 1)
    inside |= in_conflict_exactly(in, v, p);
  if (undecided & 2)
    inside |= in_conflict_exactly(in, w, p) << 1;
  return inside;
}

/* Room in the lists for a cavity of n, which has at most 2 n + 2 walls and tests at most 4 n. */
GMDS_APART gmds_status reserve_cavity(insertion *in, size_t n)
{
  const size_t had = in->capacity, grown = gmds_grown(had, n < 64 ? 64 : n);
  void *block[5] = {in->cavity, in->tested, in->walls, in->sides, in->ids};
  const size_t bytes[5] = {sizeof *in->cavity, 4 * sizeof *in->tested, 4 * sizeof *in->walls, 4 * sizeof *in->sides,
                           4 * sizeof *in->ids};
  int done = 0;
  while (done < 5 && gmds_resize(mesh_memory(in->m), &block[done], had, grown, bytes[done]))
    done++;
  for (int k = 0; k < done && done < 5; k++) /* all grow or none */
    (void)gmds_resize(mesh_memory(in->m), &block[k], grown, had, bytes[k]);
  in->cavity = block[0];
  in->tested = block[1];
  in->walls = block[2];
  in->sides = block[3];
  in->ids = block[4];
  if (done < 5)
    return GMDS_ERR_MEMORY;
  in->capacity = grown;
  return GMDS_OK;
}

/* Marks for all regions that there are. */
GMDS_APART gmds_status reserve_marks(insertion *in, size_t n)
{
  void *marks = in->marks;
  const size_t grown = in->marked ? gmds_grown(in->marked, n) : n;
  if (!gmds_resize(mesh_memory(in->m), &marks, in->marked, grown, sizeof *in->marks))
    return GMDS_ERR_MEMORY;
  in->marks = marks;
  memset(in->marks + in->marked, 0, (grown - in->marked) * sizeof *in->marks);
  in->marked = grown;
  return GMDS_OK;
}

/* Gathers the cavity of p from a tetrahedron in it, breadth first. Each tetrahedron is tested once, two at a time, and
 * appended without a branch; what will be read of those in the queue, and of the numbers of nodes, is on its way
 * meanwhile. */
GMDS_SPECIALISED gmds_status grow_cavity(insertion *in, const candidate *root, const double p[3], int sharing)
{
  const mesh *m = in->m;
  const gmds_id outside = in->stamp += 2, start = root->region;
  gmds_id *const marks = in->marks, *const local = in->local;
  size_t n = 1, n_tested = 0, done = 0;
  candidate *tested = in->tested;
  append(in, 0, root);
  marks[start] = outside + 1;
  for (size_t i = 0; i < n; i++) {
    if (n + 8 > in->capacity) {
      if (sharing == GMDS__SHARED) {
        defer(in);
        return GMDS_OK;
      }
      GMDS_TRY(reserve_cavity(in, n + 8));
      tested = in->tested;
    }
    candidate around[4];
    GMDS_TRY(load(in, i, around));
    if (sharing == GMDS__SHARED && !owns_all(in, in->cavity[i].node)) {
      defer(in);
      return GMDS_OK;
    }
    for (int k = 0; k < 4; k++) {
      const gmds_id next = around[k].region, mark = marks[next];
      tested[n_tested] = around[k];
      n_tested += mark < outside;
      prefetch_3(m, next);
      __builtin_prefetch(local + in->cavity[i].node[k]);
      marks[next] = mark < outside ? outside : mark;
    }
    /* One that is left over waits for another as long as there can be one; then it is tested beside the first of all,
     * which stays what it is. */
    if (i + 1 == n && (n_tested - done) % 2)
      tested[n_tested++] = *root;
    for (; done + 2 <= n_tested; done += 2) {
      const candidate first = tested[done], second = tested[done + 1];
      const unsigned inside = in_conflict(in, nodes_of(in, &first), nodes_of(in, &second), p);
      append(in, n, &second);
      n += (inside >> 1) & (second.region != start);
      marks[second.region] = outside + (inside >> 1);
      append(in, n, &first);
      n += inside & 1;
      marks[first.region] = outside + (inside & 1);
    }
  }
  in->n_cavity = n;
  return GMDS_OK;
}

/* The number of a node, whose entry in in->local is at `v`, within the boundary at work, the next one if it has
 * none. */
static inline unsigned number_of(gmds_id *local, size_t v, gmds_id base, gmds_id *count)
{
  const gmds_id had = local[v], next = base + *count, is_new = had < base, l = had ^ ((had ^ next) & (0 - is_new));
  local[v] = l;
  *count += is_new;
  return (unsigned)(l - base);
}

/* The faces of the cavity whose other side is outside, as in->sides. */
GMDS_APART void find_sides(insertion *in)
{
  const gmds_id inside = in->stamp + 1, *marks = in->marks;
  const tetrahedron *cavity = in->cavity;
  const size_t n_cavity = in->n_cavity;
  gmds_id *sides = in->sides;
  size_t n = 0;
  for (size_t i = 0; i < n_cavity; i++)
    for (size_t k = 0; k < 4; k++) {
      sides[n] = (gmds_id)(4 * i + k);
      n += marks[region_beyond(&cavity[i], k)] != inside;
    }
  in->n_walls = n;
}

/* Where in in->local the number of a node is: each thread has an entry of its own for the ghost. */
static inline size_t number_at(const insertion *in, gmds_id v, int sharing)
{
#if GMDS_CONCURRENT_STARS
  if (sharing == GMDS__SHARED && v == in->ghost)
    return in->ghost_at;
#endif
  (void)in;
  (void)sharing;
  return v;
}

/* The walls on these faces, turned inwards, their nodes numbered. */
GMDS_SPECIALISED void find_walls(insertion *in, int sharing)
{
  const gmds_id base = in->base, *sides = in->sides;
  const tetrahedron *cavity = in->cavity;
  gmds_id *const local = in->local, count = 0;
  gmds_cavity_wall *const walls = in->walls;
  const size_t n = in->n_walls;
  for (size_t i = 0; i < n; i++) {
    const tetrahedron *t = &cavity[sides[i] >> 2];
    const unsigned k = (unsigned)(sides[i] & 3);
    const unsigned char *on = face_nodes[k];
    const gmds_id x = t->node[on[0]], y = t->node[on[2]], z = t->node[on[1]];
    gmds_cavity_wall *w = &walls[i];
    w->node[0] = x;
    w->node[1] = y;
    w->node[2] = z;
    w->out = region_beyond(t, k);
    w->out_side = face_beyond(t, k);
    w->local[0] = number_of(local, number_at(in, x, sharing), base, &count);
    w->local[1] = number_of(local, number_at(in, y, sharing), base, &count);
    w->local[2] = number_of(local, number_at(in, z, sharing), base, &count);
  }
  in->base = base + count;
}

/* Begins numbers anew when they are used up. */
static inline void renew_numbers(insertion *in)
{
  if (in->base <= GMDS_NONE / 2)
    return;
  memset(in->local, 0, in->numbered * sizeof *in->local);
  in->base = 1;
}

/* The next walk begins at a finite tetrahedron of the star: a cavity has a wall without the ghost. */
static inline void remember_star(insertion *in, gmds_id v)
{
  const gmds_cavity_wall *w = in->walls;
  while (w->node[0] == in->ghost || w->node[1] == in->ghost || w->node[2] == in->ghost)
    w++;
  const gmds_id node[4] = {w->node[0], w->node[1], w->node[2], v};
  in->last = candidate_of(in->ids[w - in->walls], node);
}

/* Functions of their own: their loops lack registers where they stand in their caller. */
GMDS_APART gmds_status grow_alone(insertion *in, const candidate *root, const double p[3])
{
  return grow_cavity(in, root, p, GMDS__ALONE);
}

GMDS_APART void find_walls_alone(insertion *in)
{
  find_walls(in, GMDS__ALONE);
}

static inline gmds_status insert_alone(insertion *in, gmds_id v)
{
  candidate root;
  const double *p = point(in->m, v);
  GMDS_TRY(locate(in, p, &root));
  GMDS_TRY(grow_alone(in, &root, p));
  find_sides(in);
  find_walls_alone(in);
  renew_numbers(in);
  GMDS_TRY(star(in->m, v, in->n_cavity, in->n_walls, in->walls, in->ids));
  if (end_3(in->m) > in->marked)
    GMDS_TRY(reserve_marks(in, end_3(in->m)));
  remember_star(in, v);
  return GMDS_OK;
}
