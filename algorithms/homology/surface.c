/* Building a surface: every dart looks for the one on the other side of its edge among those that wait at the lower
 * vertex of the edge. Those that wait are chained through their beta 2, which holds nothing yet. */
#include <gmds/surface.h>
#include <gmds/bits.h>
#include <gmds/threads.h>
#include <inttypes.h>
#include <string.h>

/* How far ahead the next darts to be matched are fetched: where faces lie in no order, nothing else is near. */
enum { AHEAD = 16, SCATTERED = 16 };

typedef struct matching {
  gmds_surface *s;
  gmds_id *head; /* for each vertex the last dart that waits there, or GMDS_NONE */
  unsigned threads;
  size_t turned[GMDS_MAX_THREADS];
} matching;

void gmds_surface_init(gmds_surface *surface, gmds_memory *memory)
{
  *surface = (gmds_surface){.memory = memory};
}

void gmds_surface_clear(gmds_surface *s)
{
  gmds_release(s->memory, s->listed, s->listed ? s->n_faces : 0, sizeof *s->listed);
  gmds_release(s->memory, s->begin, s->begin ? s->n_faces + 1 : 0, sizeof *s->begin);
  gmds_release(s->memory, s->face, s->face ? s->n_darts : 0, sizeof *s->face);
  gmds_release(s->memory, s->origin, s->origin ? s->n_darts : 0, sizeof *s->origin);
  gmds_release(s->memory, s->beta2, s->beta2 ? s->n_darts : 0, sizeof *s->beta2);
  gmds_surface_init(s, s->memory);
}

/* One dart of an edge from a to b, whose lower vertex is `low`: it meets its partner there, or waits for it. */
static inline size_t match_dart(gmds_surface *s, gmds_id *head, gmds_id d, gmds_id a, gmds_id b, gmds_id low)
{
  const gmds_id high = a == low ? b : a, first = head[low];
  gmds_id before = GMDS_NONE, e = first;
  while (e != GMDS_NONE) {
    gmds_id from = s->origin[e], to = s->origin[gmds_surface_beta1(s, e)], next = s->beta2[e];
    if ((from == low ? to : from) == high) {
      if (before == GMDS_NONE)
        head[low] = next;
      else
        s->beta2[before] = next;
      s->beta2[e] = d;
      s->beta2[d] = e;
      return from == a;
    }
    before = e;
    e = next;
  }
  s->beta2[d] = first;
  head[low] = d;
  return 0;
}

/* Thread t matches the darts whose edges have their lower vertex in its share, and writes no others. */
static void match_part(void *work, unsigned t)
{
  matching *m = work;
  gmds_surface *s = m->s;
  const gmds_id *origin = s->origin;
  gmds_id *head = m->head;
  const size_t n = s->n_darts;
  const gmds_id low = (gmds_id)GMDS_SHARE(s->n_vertices, t, m->threads);
  const gmds_id end = (gmds_id)GMDS_SHARE(s->n_vertices, t + 1, m->threads);
  size_t turned = 0;
  for (gmds_id v = low; v < end; v++)
    head[v] = GMDS_NONE;
  for (gmds_id d = 0; d < n; d++) {
    if (d + 2 * AHEAD + 1 < n) {
      const gmds_id *near = origin + d + 2 * AHEAD;
      __builtin_prefetch(head + (near[0] < near[1] ? near[0] : near[1]));
    }
    if (d + AHEAD + 1 < n) {
      const gmds_id *near = origin + d + AHEAD;
      const gmds_id v = near[0] < near[1] ? near[0] : near[1];
      if (v >= low && v < end && head[v] != GMDS_NONE) {
        __builtin_prefetch(origin + head[v]);
        __builtin_prefetch(s->beta2 + head[v]);
      }
    }
    const gmds_id a = origin[d], b = origin[gmds_surface_beta1(s, d)], v = a < b ? a : b;
    if (v >= low && v < end)
      turned += match_dart(s, head, d, a, b, v);
  }
  m->turned[t] = turned;
}

/* Takes the darts that still wait, chained by the lower vertex of their edges, for the border. If there are more than
 * two on an edge, one of them waits too: *third. O(vertices + darts) where there is a border. */
static gmds_status close_border(gmds_surface *s, gmds_id *head, gmds_id *third)
{
  gmds_id last = GMDS_NONE;
  for (size_t v = 0; v < s->n_vertices; v++)
    for (gmds_id d = head[v]; d != GMDS_NONE; d = s->beta2[d]) {
      s->n_border++;
      last = d;
    }
  *third = GMDS_NONE;
  if (last == GMDS_NONE)
    return GMDS_OK;
  gmds_bits waits;
  GMDS_TRY(gmds_bits_init(&waits, s->memory, s->n_darts));
  for (size_t v = 0; v < s->n_vertices; v++)
    for (gmds_id d = head[v]; d != GMDS_NONE; d = s->beta2[d])
      gmds_bits_set(&waits, d);
  for (gmds_id d = 0; d < s->n_darts && *third == GMDS_NONE; d++) {
    const gmds_id a = s->origin[d], b = s->origin[gmds_surface_beta1(s, d)], low = a < b ? a : b;
    if (gmds_bits_get(&waits, d))
      continue;
    for (gmds_id e = head[low]; e != GMDS_NONE; e = s->beta2[e])
      if (s->origin[e] + s->origin[gmds_surface_beta1(s, e)] == a + b)
        *third = e;
  }
  for (size_t v = 0; v < s->n_vertices; v++)
    for (gmds_id d = head[v], next; d != GMDS_NONE; d = next) {
      next = s->beta2[d];
      s->beta2[d] = GMDS_NONE;
    }
  gmds_bits_clear(&waits);
  return GMDS_OK;
}

/* beta 2, once the rest is there. */
static gmds_status match_darts(gmds_surface *s, unsigned threads, gmds_error *error)
{
  void *head = NULL, *beta2 = NULL;
  if (!gmds_resize(s->memory, &beta2, 0, s->n_darts, sizeof *s->beta2))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the %zu sides of a surface", s->n_darts);
  s->beta2 = beta2;
  if (!gmds_resize(s->memory, &head, 0, s->n_vertices, sizeof(gmds_id)))
    return gmds_fail(error, GMDS_ERR_MEMORY, "out of memory for the %zu vertices of a surface", s->n_vertices);
  matching m = {.s = s, .head = head, .threads = threads};
  gmds_share(threads, match_part, &m);
  gmds_id third = GMDS_NONE;
  gmds_status status = close_border(s, m.head, &third);
  gmds_release(s->memory, head, s->n_vertices, sizeof(gmds_id));
  if (status != GMDS_OK)
    return gmds_fail(error, status, "out of memory for the border of a surface");
  if (third != GMDS_NONE) {
    const gmds_id f = gmds_surface_listed(s, gmds_surface_face(s, third));
    const gmds_id a = s->origin[third], b = s->origin[gmds_surface_beta1(s, third)];
    gmds_fail(error, GMDS_ERR_CONFLICT,
              "face %" GMDS_PRIid " is the third on the edge of vertices %" GMDS_PRIid " and %" GMDS_PRIid, f,
              a < b ? a : b, a < b ? b : a);
    if (error)
      error->cell = (long long)f;
    return GMDS_ERR_CONFLICT;
  }
  for (unsigned t = 0; t < threads; t++)
    s->n_turned += m.turned[t];
  s->n_edges = s->n_border + (s->n_darts - s->n_border) / 2;
  return GMDS_OK;
}

/* Whether faces that follow each other in the list are far apart: the mean distance of their first vertices is
 * compared. */
static int is_scattered(size_t n_vertices, size_t n_faces, const size_t *begin, const gmds_id *nodes)
{
  uint64_t sum = 0;
  gmds_id last = n_faces ? nodes[begin ? begin[0] : 0] : 0;
  for (size_t f = 0; f < n_faces; f++) {
    const gmds_id v = nodes[begin ? begin[f] : 3 * f];
    sum += v > last ? v - last : last - v;
    last = v;
  }
  return n_faces > SCATTERED && sum / n_faces > n_vertices / SCATTERED;
}

static gmds_id lowest(const gmds_id *nodes, size_t n)
{
  gmds_id low = nodes[0];
  for (size_t k = 1; k < n; k++)
    low = nodes[k] < low ? nodes[k] : low;
  return low;
}

/* The faces in the order of their lowest vertices: s->listed. Where neighbours lie near each other in memory,
 * everything that follows is three times as fast. */
static gmds_status sort_faces(gmds_surface *s, const size_t *begin, const gmds_id *nodes)
{
  void *listed = NULL, *at = NULL;
  if (!gmds_resize(s->memory, &listed, 0, s->n_faces, sizeof *s->listed))
    return GMDS_ERR_MEMORY;
  s->listed = listed;
  if (!gmds_resize(s->memory, &at, 0, s->n_vertices + 1, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *place = at;
  memset(place, 0, (s->n_vertices + 1) * sizeof *place);
  for (int pass = 0; pass < 2; pass++) {
    for (size_t f = 0; f < s->n_faces; f++) {
      const size_t first = begin ? begin[f] : 3 * f;
      const gmds_id v = lowest(nodes + first, begin ? begin[f + 1] - first : 3);
      if (pass == 0)
        place[v + 1]++;
      else
        s->listed[place[v]++] = (gmds_id)f;
    }
    for (size_t v = 0; pass == 0 && v < s->n_vertices; v++)
      place[v + 1] += place[v];
  }
  gmds_release(s->memory, at, s->n_vertices + 1, sizeof(gmds_id));
  return GMDS_OK;
}

/* Copies the corners of the faces, in the order in which these are to be. */
static void copy_faces(gmds_surface *s, const size_t *begin, const gmds_id *nodes)
{
  gmds_id at = 0;
  if (!s->listed && !s->begin && s->n_darts)
    memcpy(s->origin, nodes + (begin ? begin[0] : 0), s->n_darts * sizeof *nodes);
  for (gmds_id f = 0; (s->listed || s->begin) && f < s->n_faces; f++) {
    const size_t from = gmds_surface_listed(s, f), first = begin ? begin[from] : 3 * from;
    const gmds_id n = begin ? (gmds_id)(begin[from + 1] - first) : 3;
    if (s->listed && f + AHEAD < s->n_faces) {
      const size_t next = s->listed[f + AHEAD];
      __builtin_prefetch(nodes + (begin ? begin[next] : 3 * next));
    }
    for (gmds_id k = 0; k < n; k++)
      s->origin[at + k] = nodes[first + k];
    if (s->begin) {
      for (gmds_id k = 0; k < n; k++)
        s->face[at + k] = f;
      s->begin[f] = at;
    }
    at += n;
  }
  if (s->begin)
    s->begin[s->n_faces] = at;
}

/* Room for the darts: begin and face where not all faces are triangles. */
static gmds_status take_darts(gmds_surface *s, size_t n_darts, int triangles)
{
  void *begin = NULL, *face = NULL, *origin = NULL;
  if (!triangles) {
    if (!gmds_resize(s->memory, &begin, 0, s->n_faces + 1, sizeof *s->begin))
      return GMDS_ERR_MEMORY;
    s->begin = begin;
    if (!gmds_resize(s->memory, &face, 0, n_darts, sizeof *s->face))
      return GMDS_ERR_MEMORY;
    s->face = face;
    s->n_darts = n_darts;
  }
  if (!gmds_resize(s->memory, &origin, 0, n_darts, sizeof *s->origin))
    return GMDS_ERR_MEMORY;
  s->origin = origin;
  s->n_darts = n_darts;
  return GMDS_OK;
}

static gmds_status check_size(size_t n_vertices, size_t n_darts, unsigned threads, gmds_error *error)
{
  if (threads < 1 || threads > GMDS_MAX_THREADS)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%u threads: there can be from 1 to %d", threads, GMDS_MAX_THREADS);
  if (n_vertices >= GMDS_NONE || n_darts >= GMDS_NONE)
    return gmds_fail(error, GMDS_ERR_TOO_MANY, "%zu sides of faces and %zu vertices are more than can be numbered",
                     n_darts, n_vertices);
  return GMDS_OK;
}

/* Whether the rows make faces; *triangles: whether all are. The sentence names the first that does not. */
static gmds_status check_faces(size_t n_vertices, size_t n_faces, const size_t *begin, const gmds_id *nodes,
                               int *triangles, gmds_error *error)
{
  *triangles = 1;
  for (size_t f = 0; f < n_faces; f++) {
    const size_t first = begin ? begin[f] : 3 * f, end = begin ? begin[f + 1] : first + 3;
    gmds_status status = end < first + 3 ? GMDS_ERR_ARGUMENT : GMDS_OK;
    *triangles &= end == first + 3;
    if (status != GMDS_OK)
      gmds_fail(error, status, "face %zu has fewer than three vertices", f);
    for (size_t k = first, last = end - 1; status == GMDS_OK && k < end; last = k++) {
      if (nodes[k] < n_vertices && nodes[k] != nodes[last])
        continue;
      status = nodes[k] < n_vertices ? GMDS_ERR_ARGUMENT : GMDS_ERR_CELL;
      if (status == GMDS_ERR_CELL)
        gmds_fail(error, status, "face %zu has vertex %" GMDS_PRIid ", but there are %zu", f, nodes[k], n_vertices);
      else
        gmds_fail(error, status, "face %zu has vertex %" GMDS_PRIid " twice in a row", f, nodes[k]);
    }
    if (status == GMDS_OK)
      continue;
    if (error)
      error->cell = (long long)f;
    return status;
  }
  return GMDS_OK;
}

/* The last part of every way to make a surface. */
static gmds_status finish(gmds_surface *s, gmds_status status, unsigned threads, gmds_error *error)
{
  if (status == GMDS_ERR_MEMORY)
    gmds_fail(error, status, "out of memory for the faces of a surface");
  if (status == GMDS_OK)
    status = match_darts(s, threads, error);
  if (status != GMDS_OK)
    gmds_surface_clear(s);
  return status;
}

gmds_status gmds_surface_from_faces(gmds_surface *s, size_t n_vertices, size_t n_faces, const size_t *begin,
                                    const gmds_id *nodes, unsigned threads, gmds_error *error)
{
  int triangles = 1;
  if (!begin && n_faces > SIZE_MAX / 3)
    return gmds_fail(error, GMDS_ERR_TOO_MANY, "%zu triangles are more than can be numbered", n_faces);
  const size_t n = begin ? begin[n_faces] - begin[0] : 3 * n_faces;
  GMDS_TRY(check_size(n_vertices, n, threads, error));
  GMDS_TRY(check_faces(n_vertices, n_faces, begin, nodes, &triangles, error));
  s->n_vertices = n_vertices;
  s->n_faces = n_faces;
  gmds_status status = is_scattered(n_vertices, n_faces, begin, nodes) ? sort_faces(s, begin, nodes) : GMDS_OK;
  if (status == GMDS_OK)
    status = take_darts(s, n, triangles);
  if (status == GMDS_OK)
    copy_faces(s, begin, nodes);
  return finish(s, status, threads, error);
}

/* How many faces a soup has, and corners of them; whether all are triangles. */
static gmds_status count_faces(const gmds_soup *soup, size_t *faces, size_t *corners, int *triangles, gmds_error *error)
{
  *faces = *corners = 0;
  *triangles = 1;
  for (size_t c = 0; c < soup->n_cells; c++) {
    int dim = gmds_cell_type_dimension((gmds_cell_type)soup->types[c]);
    if (dim == 3) {
      gmds_fail(error, GMDS_ERR_UNSUPPORTED, "cell %zu is a %s: a surface has faces only", c,
                gmds_cell_type_text((gmds_cell_type)soup->types[c]));
      if (error)
        error->cell = (long long)c;
      return GMDS_ERR_UNSUPPORTED;
    }
    if (dim < 2)
      continue;
    ++*faces;
    *corners += soup->begin[c + 1] - soup->begin[c];
    *triangles &= soup->types[c] == GMDS_TRIANGLE;
  }
  return GMDS_OK;
}

/* The faces of a soup that has other cells as well, as a list of their own. */
static gmds_status from_some(gmds_surface *s, const gmds_soup *soup, size_t faces, size_t corners, unsigned threads,
                             gmds_error *error)
{
  void *begin = NULL, *nodes = NULL;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(s->memory, &begin, 0, faces + 1, sizeof(size_t)) &&
      gmds_resize(s->memory, &nodes, 0, corners, sizeof(gmds_id))) {
    size_t *to = begin, at = 0;
    for (size_t c = 0; c < soup->n_cells; c++) {
      if (gmds_cell_type_dimension((gmds_cell_type)soup->types[c]) != 2)
        continue;
      const size_t n = soup->begin[c + 1] - soup->begin[c];
      memcpy((gmds_id *)nodes + at, soup->corners + soup->begin[c], n * sizeof(gmds_id));
      *to++ = at;
      at += n;
    }
    *to = at;
    status = gmds_surface_from_faces(s, soup->n_points, faces, begin, nodes, threads, error);
  } else
    gmds_fail(error, status, "out of memory for %zu faces", faces);
  gmds_release(s->memory, begin, begin ? faces + 1 : 0, sizeof(size_t));
  gmds_release(s->memory, nodes, nodes ? corners : 0, sizeof(gmds_id));
  return status;
}

gmds_status gmds_surface_from_soup(gmds_surface *s, const gmds_soup *soup, unsigned threads, gmds_error *error)
{
  size_t faces = 0, corners = 0;
  int triangles = 0;
  GMDS_TRY(count_faces(soup, &faces, &corners, &triangles, error));
  if (faces != soup->n_cells)
    return from_some(s, soup, faces, corners, threads, error);
  return gmds_surface_from_faces(s, soup->n_points, faces, triangles ? NULL : soup->begin, soup->corners, threads,
                                 error);
}

gmds_status gmds_surface_take_soup(gmds_surface *s, gmds_soup *soup, unsigned threads, gmds_error *error)
{
  size_t faces = 0, corners = 0;
  int triangles = 0;
  gmds_status status = count_faces(soup, &faces, &corners, &triangles, error);
  if (status == GMDS_OK && triangles && faces == soup->n_cells && soup->memory == s->memory &&
      !is_scattered(soup->n_points, faces, NULL, soup->corners)) {
    status = check_size(soup->n_points, corners, threads, error);
    if (status == GMDS_OK)
      status = check_faces(soup->n_points, faces, NULL, soup->corners, &triangles, error);
    if (status == GMDS_OK) {
      s->n_vertices = soup->n_points;
      s->n_faces = faces;
      s->origin = gmds_soup_give_corners(soup, &s->n_darts);
      gmds_soup_clear(soup);
      return finish(s, GMDS_OK, threads, error);
    }
  } else if (status == GMDS_OK)
    status = gmds_surface_from_soup(s, soup, threads, error);
  gmds_soup_clear(soup);
  return status;
}
