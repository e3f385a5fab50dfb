/* Insertion by several threads in the plane (strips.h): a star has two faces more than its cavity, so that the faces of
 * all stars are taken at once, before the first, and dealt out two a point. */
#if GMDS_CONCURRENT_STARS

typedef struct supply {
  face_range ranges[4 * GMDS_MAX_THREADS + 4]; /* faces that nobody has used, which an empty range ends */
  face_range pieces[4 * GMDS_MAX_THREADS + 4]; /* of each thread, likewise */
  size_t sampled;                              /* faces below this number had rows before any thread began */
} supply;

#  include <gmds/algorithms/delaunay/strips.h>

static inline int find_start(concurrent *c, unsigned t)
{
  insertion *in = &c->in[t];
  for (gmds_id f = 0; f < c->supply.sampled; f++) {
    gmds_id v[3];
    triangle_nodes(in->m, f, v);
    if (v[0] != in->ghost && v[1] != in->ghost && v[2] != in->ghost && owns(in, v[0]) && owns(in, v[1]) &&
        owns(in, v[2])) {
      in->last = (gmds_cavity_face){f, {v[0], v[1], v[2]}, 0};
      return 1;
    }
  }
  return 0;
}

static inline void open_stage(concurrent *c)
{
  insertion *in = c->in;
  if (in->fresh.first == in->fresh.end)
    in->fresh = *in->more; /* the rest of the last stage used what it found before */
  c->supply.sampled = in->fresh.first;
  c->supply.ranges[0] = in->fresh;
  c->supply.ranges[1] = (face_range){0, 0};
}

/* Deals faces from the front of the ranges in pieces; what is left of the ranges moves to their front. */
static inline gmds_status open_round(concurrent *c)
{
  face_range *ranges = c->supply.ranges, *piece = c->supply.pieces;
  size_t r = 0, n = 0;
  assign_strips(c);
  for (unsigned t = 0; t < c->threads; t++) {
    size_t need = 2 * (c->begin[t + 1] - c->begin[t]);
    c->in[t].fresh = (face_range){0, 0};
    c->in[t].more = piece;
    while (need) {
      size_t here = (size_t)(ranges[r].end - ranges[r].first);
      here = here < need ? here : need;
      *piece++ = (face_range){ranges[r].first, ranges[r].first + (gmds_id)here};
      ranges[r].first += (gmds_id)here;
      r += ranges[r].first == ranges[r].end;
      need -= here;
    }
    *piece++ = (face_range){0, 0};
  }
  for (; ranges[r].first < ranges[r].end; r++)
    ranges[n++] = ranges[r];
  ranges[n] = (face_range){0, 0};
  return GMDS_OK;
}

/* Puts the faces that were not used before the ranges. */
static inline void close_round(concurrent *c)
{
  face_range rest[4 * GMDS_MAX_THREADS + 4], *ranges = c->supply.ranges;
  size_t n = 0;
  for (unsigned t = 0; t < c->threads; t++) {
    const insertion *in = &c->in[t];
    if (in->fresh.first < in->fresh.end)
      rest[n++] = in->fresh;
    for (const face_range *more = in->more; more->first < more->end; more++)
      rest[n++] = *more;
  }
  for (size_t r = 0; ranges[r].first < ranges[r].end; r++)
    rest[n++] = ranges[r];
  memcpy(ranges, rest, n * sizeof *ranges);
  ranges[n] = (face_range){0, 0};
}

static inline void open_rest(concurrent *c)
{
  c->in->fresh = (face_range){0, 0};
  c->in->more = c->supply.ranges;
}
#endif
