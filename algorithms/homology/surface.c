/* Building a surface: every dart looks for the one on the other side of its edge among those that wait at the lower vertex
 * of the edge. Those that wait are chained through their beta 2, which holds nothing yet. */
#include <gmds/surface.h>
#include <gmds/bits.h>
#include <gmds/threads.h>
#include <inttypes.h>
#include <string.h>

/* How far ahead the next darts to be matched are fetched: where faces lie in no order, nothing else is near. */
enum { AHEAD = 16 };

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

/* Takes the darts that still wait, chained by the lower vertex of their edges, for the border. If there are more than two
 * on an edge, one of them waits too: *third. O(vertices + darts) where there is a border. */
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
    gmds_id f = gmds_surface_face(s, third);
    gmds_fail(error, GMDS_ERR_CONFLICT,
              "face %" GMDS_PRIid " is the third on the edge of vertices %" GMDS_PRIid " and %" GMDS_PRIid, f,
              s->origin[third], s->origin[gmds_surface_beta1(s, third)]);
    if (error)
      error->cell = (long long)f;
    return GMDS_ERR_CONFLICT;
  }
  for (unsigned t = 0; t < threads; t++)
    s->n_turned += m.turned[t];
  s->n_edges = s->n_border + (s->n_darts - s->n_border) / 2;
  return GMDS_OK;
}

/* Whether the corners make faces. */
static gmds_status check_corners(const gmds_surface *s, gmds_error *error)
{
  for (gmds_id d = 0; d < s->n_darts; d++) {
    const gmds_id v = s->origin[d];
    if (v < s->n_vertices && v != s->origin[gmds_surface_beta1(s, d)])
      continue;
    const gmds_id f = gmds_surface_face(s, d);
    gmds_status status = v < s->n_vertices ? GMDS_ERR_ARGUMENT : GMDS_ERR_CELL;
    if (status == GMDS_ERR_CELL)
      gmds_fail(error, status, "face %" GMDS_PRIid " has vertex %" GMDS_PRIid ", but there are %zu", f, v,
                s->n_vertices);
    else
      gmds_fail(error, status, "face %" GMDS_PRIid " has vertex %" GMDS_PRIid " twice in a row", f, v);
    if (error)
      error->cell = (long long)f;
    return status;
  }
  return GMDS_OK;
}

/* Room for the darts of faces that are not all triangles. */
static gmds_status take_rows(gmds_surface *s, size_t n_faces, size_t n_darts)
{
  void *begin = NULL, *face = NULL;
  if (!gmds_resize(s->memory, &begin, 0, n_faces + 1, sizeof *s->begin))
    return GMDS_ERR_MEMORY;
  s->begin = begin;
  s->n_faces = n_faces;
  if (!gmds_resize(s->memory, &face, 0, n_darts, sizeof *s->face))
    return GMDS_ERR_MEMORY;
  s->face = face;
  s->n_darts = n_darts;
  return GMDS_OK;
}

static gmds_status take_corners(gmds_surface *s, size_t n_faces, size_t n_darts)
{
  void *origin = NULL;
  if (!gmds_resize(s->memory, &origin, 0, n_darts, sizeof *s->origin))
    return GMDS_ERR_MEMORY;
  s->origin = origin;
  s->n_faces = n_faces;
  s->n_darts = n_darts;
  return GMDS_OK;
}

/* Face f of a surface with rows begins at dart `at` and has n corners. */
static void put_face(gmds_surface *s, gmds_id f, gmds_id at, size_t n, const gmds_id *nodes)
{
  s->begin[f] = at;
  for (size_t k = 0; k < n; k++)
    s->face[at + k] = f;
  memcpy(s->origin + at, nodes, n * sizeof *nodes);
}

/* The last part of every way to make a surface. */
static gmds_status finish(gmds_surface *s, gmds_status status, unsigned threads, gmds_error *error)
{
  if (status == GMDS_ERR_MEMORY)
    gmds_fail(error, status, "out of memory for the faces of a surface");
  if (status == GMDS_OK)
    status = check_corners(s, error);
  if (status == GMDS_OK)
    status = match_darts(s, threads, error);
  return status;
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

gmds_status gmds_surface_from_faces(gmds_surface *s, size_t n_vertices, size_t n_faces, const size_t *begin,
                                    const gmds_id *nodes, unsigned threads, gmds_error *error)
{
  int triangles = 1;
  const size_t n = begin ? begin[n_faces] - begin[0] : 3 * n_faces;
  if (!begin && n_faces > SIZE_MAX / 3)
    return gmds_fail(error, GMDS_ERR_TOO_MANY, "%zu triangles are more than can be numbered", n_faces);
  GMDS_TRY(check_size(n_vertices, n, threads, error));
  for (size_t f = 0; begin && f < n_faces; f++) {
    if (begin[f + 1] < begin[f] + 3 || begin[f + 1] - begin[0] > n)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "face %zu has fewer than three vertices", f);
    triangles &= begin[f + 1] - begin[f] == 3;
  }
  gmds_status status = triangles ? GMDS_OK : take_rows(s, n_faces, n);
  if (status == GMDS_OK)
    status = take_corners(s, n_faces, n);
  s->n_vertices = n_vertices;
  if (status == GMDS_OK && triangles && n)
    memcpy(s->origin, begin ? nodes + begin[0] : nodes, n * sizeof *nodes);
  if (status == GMDS_OK && !triangles) {
    for (size_t f = 0; f < n_faces; f++)
      put_face(s, (gmds_id)f, (gmds_id)(begin[f] - begin[0]), begin[f + 1] - begin[f], nodes + begin[f]);
    s->begin[n_faces] = (gmds_id)n;
  }
  status = finish(s, status, threads, error);
  if (status != GMDS_OK)
    gmds_surface_clear(s);
  return status;
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

gmds_status gmds_surface_from_soup(gmds_surface *s, const gmds_soup *soup, unsigned threads, gmds_error *error)
{
  size_t faces = 0, corners = 0;
  int triangles = 0;
  GMDS_TRY(count_faces(soup, &faces, &corners, &triangles, error));
  GMDS_TRY(check_size(soup->n_points, corners, threads, error));
  gmds_status status = triangles ? GMDS_OK : take_rows(s, faces, corners);
  if (status == GMDS_OK)
    status = take_corners(s, faces, corners);
  s->n_vertices = soup->n_points;
  gmds_id at = 0, f = 0;
  for (size_t c = 0; status == GMDS_OK && c < soup->n_cells; c++) {
    if (gmds_cell_type_dimension((gmds_cell_type)soup->types[c]) != 2)
      continue;
    const size_t n = soup->begin[c + 1] - soup->begin[c];
    if (triangles)
      memcpy(s->origin + at, soup->corners + soup->begin[c], 3 * sizeof *s->origin);
    else
      put_face(s, f, at, n, soup->corners + soup->begin[c]);
    at += (gmds_id)n;
    f++;
  }
  if (status == GMDS_OK && !triangles)
    s->begin[faces] = at;
  status = finish(s, status, threads, error);
  if (status != GMDS_OK)
    gmds_surface_clear(s);
  return status;
}

gmds_status gmds_surface_take_soup(gmds_surface *s, gmds_soup *soup, unsigned threads, gmds_error *error)
{
  size_t faces = 0, corners = 0;
  int triangles = 0;
  gmds_status status = count_faces(soup, &faces, &corners, &triangles, error);
  if (status == GMDS_OK)
    status = check_size(soup->n_points, corners, threads, error);
  const int moves = triangles && faces == soup->n_cells && soup->memory == s->memory;
  if (status == GMDS_OK && !moves)
    status = gmds_surface_from_soup(s, soup, threads, error);
  if (status == GMDS_OK && moves) {
    s->n_vertices = soup->n_points;
    s->n_faces = faces;
    s->origin = gmds_soup_give_corners(soup, &s->n_darts);
    gmds_soup_clear(soup);
    status = finish(s, GMDS_OK, threads, error);
    if (status != GMDS_OK)
      gmds_surface_clear(s);
  }
  gmds_soup_clear(soup);
  return status;
}
