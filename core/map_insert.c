/* Insertion of cells into a combinatorial map, and closing. What is done in one place is done in its mirror images
 * beyond beta_3 to beta_n too, so that these stay involutions. */
#include "map_inside.h"
#include <string.h>

/* Puts the node at the origin of d at x, when the edit was committed. */
static void place(gmds_map *map, gmds_id d, const double *x)
{
  const size_t dim = (size_t)map->coordinates;
  if (x)
    memcpy(map->points + dim * gmds_map_cell(map, 0, d), x, dim * sizeof *x);
}

/* What an insertion works on: darts, what their betas were, and the darts made for each. */
typedef struct insertion {
  gmds_map *map;
  edit change;
  gmds_ids at;    /* darts, or pairs of darts */
  gmds_ids betas; /* n + 1 for each dart */
  id_table index; /* of each dart: its place */
} insertion;

static void insertion_begin(insertion *in, gmds_map *map)
{
  *in = (insertion){.map = map};
  in->at.memory = in->betas.memory = in->index.memory = &map->memory;
  edit_begin(&in->change, map);
}

static gmds_status insertion_end(insertion *in, gmds_status status)
{
  gmds_ids_clear(&in->at);
  gmds_ids_clear(&in->betas);
  id_table_clear(&in->index);
  if (status == GMDS_OK && !edit_is_sound(&in->change)) /* a face that is its own image */
    status = GMDS_ERR_CONFLICT;
  return edit_end(&in->change, status);
}

/* Takes the darts of an orbit, and their links as they are, and makes `each` darts for each of them. */
static gmds_status take_orbit(insertion *in, gmds_id d, unsigned betas, int each)
{
  const size_t width = (size_t)in->map->n + 1;
  GMDS_TRY(gmds_map_orbit(in->map, d, betas, &in->at));
  for (size_t k = 0; k < in->at.n; k++) {
    GMDS_TRY(id_table_put(&in->index, in->at.data[k], (gmds_id)k));
    for (size_t i = 0; i < width; i++)
      GMDS_TRY(gmds_ids_push(&in->betas, gmds_map_beta(in->map, (int)i, in->at.data[k])));
  }
  for (size_t k = 0; k < in->at.n * (size_t)each; k++) {
    gmds_id made = GMDS_NONE;
    GMDS_TRY(edit_make(&in->change, &made));
  }
  return GMDS_OK;
}

/* beta_i of dart k as it was, and dart number q that was made for a dart of the orbit. */
static gmds_id was(const insertion *in, int i, size_t k)
{
  return in->betas.data[k * ((size_t)in->map->n + 1) + (size_t)i];
}

static gmds_id made_for(const insertion *in, gmds_id d, size_t each, size_t q)
{
  return in->change.made.data[*id_table_find(&in->index, d) * each + q];
}

static gmds_status split_edge(insertion *in, gmds_id d)
{
  edit *e = &in->change;
  GMDS_TRY(take_orbit(in, d, gmds_map_cell_betas(in->map, 1), 1));
  for (size_t k = 0; k < in->at.n; k++) {
    const gmds_id q = in->at.data[k], half = e->made.data[k], next = gmds_map_beta(in->map, 1, q);
    GMDS_TRY(edit_join(e, 1, q, half));
    if (next != GMDS_NONE)
      GMDS_TRY(edit_join(e, 1, half, next));
  }
  for (size_t k = 0; k < in->at.n; k++)
    for (int j = 2; j <= in->map->n; j++)
      if (was(in, j, k) != GMDS_NONE) {
        GMDS_TRY(edit_join(e, j, in->at.data[k], made_for(in, was(in, j, k), 1, 0)));
        GMDS_TRY(edit_join(e, j, e->made.data[k], was(in, j, k)));
      }
  return GMDS_OK;
}

gmds_status gmds_map_insert_vertex_in_edge(gmds_map *map, gmds_id d, const double *x, gmds_id *made)
{
  insertion in;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  insertion_begin(&in, map);
  GMDS_TRY(insertion_end(&in, split_edge(&in, d)));
  const gmds_id half = gmds_map_beta(map, 1, d);
  place(map, half, x);
  if (made)
    *made = half;
  return GMDS_OK;
}

static gmds_status star_face(insertion *in, gmds_id d)
{
  edit *e = &in->change;
  GMDS_TRY(take_orbit(in, d, gmds_map_cell_betas(in->map, 2), 2));
  for (size_t k = 0; k < in->at.n; k++)
    if (was(in, 1, k) == GMDS_NONE)
      return GMDS_ERR_CONFLICT;
  for (size_t k = 0; k < in->at.n; k++) {
    const gmds_id q = in->at.data[k], in_ = made_for(in, q, 2, 0), out = made_for(in, q, 2, 1);
    GMDS_TRY(edit_join(e, 1, q, in_));
    GMDS_TRY(edit_join(e, 1, in_, out));
    GMDS_TRY(edit_join(e, 1, out, q));
    GMDS_TRY(edit_join(e, 2, in_, made_for(in, was(in, 1, k), 2, 1)));
    for (int j = 3; j <= in->map->n; j++)
      if (was(in, j, k) != GMDS_NONE) {
        GMDS_TRY(edit_join(e, j, in_, made_for(in, was(in, j, k), 2, 1)));
        GMDS_TRY(edit_join(e, j, out, made_for(in, was(in, j, k), 2, 0)));
      }
  }
  return GMDS_OK;
}

gmds_status gmds_map_insert_vertex_in_face(gmds_map *map, gmds_id d, const double *x, gmds_id *made)
{
  insertion in;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  insertion_begin(&in, map);
  GMDS_TRY(insertion_end(&in, star_face(&in, d)));
  const gmds_id out = gmds_map_beta(map, 0, d);
  place(map, out, x);
  if (made)
    *made = out;
  return GMDS_OK;
}

/* ---- an edge at one corner of a face, or between two: `at` has two darts a place, the same where it is one corner */

/* Finds the images of the corners of d and e beyond beta_3 to beta_n. */
static gmds_status take_corners(insertion *in, gmds_id d, gmds_id e)
{
  const gmds_map *map = in->map;
  GMDS_TRY(gmds_ids_push(&in->at, d));
  GMDS_TRY(gmds_ids_push(&in->at, e));
  GMDS_TRY(id_table_put(&in->index, d, 0));
  for (size_t k = 0; k < in->at.n; k += 2) {
    const gmds_id p = gmds_map_beta(map, 0, in->at.data[k]), q = gmds_map_beta(map, 0, in->at.data[k + 1]);
    if (p == GMDS_NONE || q == GMDS_NONE)
      return GMDS_ERR_CONFLICT;
    for (int j = 3; j <= map->n; j++) {
      const gmds_id a = gmds_map_beta(map, j, p), b = gmds_map_beta(map, j, q);
      if (a == GMDS_NONE || id_table_find(&in->index, a))
        continue;
      if (b == GMDS_NONE || (d != e && id_table_find(&in->index, b)))
        return GMDS_ERR_CONFLICT;
      GMDS_TRY(id_table_put(&in->index, a, (gmds_id)(in->at.n / 2)));
      GMDS_TRY(gmds_ids_push(&in->at, a));
      GMDS_TRY(gmds_ids_push(&in->at, b));
    }
  }
  for (size_t k = 1; k < in->at.n && d != e; k += 2) /* a face that is its own image */
    if (id_table_find(&in->index, in->at.data[k]))
      return GMDS_ERR_CONFLICT;
  return GMDS_OK;
}

static gmds_status insert_edges(insertion *in, gmds_id d, gmds_id e)
{
  edit *change = &in->change;
  gmds_map *map = in->map;
  gmds_ids image = {.memory = &map->memory}; /* place of the image beyond beta_j, j from 3 */
  gmds_status status = take_corners(in, d, e);
  for (size_t k = 0; k < in->at.n && status == GMDS_OK; k += 2) {
    gmds_id made = GMDS_NONE;
    const gmds_id p = gmds_map_beta(map, 0, in->at.data[k]);
    for (int j = 3; j <= map->n && status == GMDS_OK; j++) {
      const gmds_id a = gmds_map_beta(map, j, p);
      status = gmds_ids_push(&image, a == GMDS_NONE ? GMDS_NONE : *id_table_find(&in->index, a));
    }
    for (int q = 0; q < 2 && status == GMDS_OK; q++)
      status = edit_make(change, &made);
  }
  for (size_t k = 0; k < in->at.n && status == GMDS_OK; k += 2) {
    const gmds_id from = in->at.data[k], to = in->at.data[k + 1], a = change->made.data[k],
                  b = change->made.data[k + 1];
    const gmds_id p = gmds_map_beta(map, 0, from), q = gmds_map_beta(map, 0, to);
    status = edit_join(change, 1, p, a);
    if (status == GMDS_OK)
      status = d == e ? edit_join(change, 1, a, b) : edit_join(change, 1, a, to);
    if (status == GMDS_OK && d != e)
      status = edit_join(change, 1, q, b);
    if (status == GMDS_OK)
      status = edit_join(change, 1, b, from);
    if (status == GMDS_OK)
      status = edit_join(change, 2, a, b);
    for (int j = 3; j <= map->n && status == GMDS_OK; j++) {
      const gmds_id other = image.data[k / 2 * (size_t)(map->n - 2) + (size_t)(j - 3)];
      if (other == GMDS_NONE)
        continue;
      status = edit_join(change, j, a, change->made.data[2 * other + 1]);
      if (status == GMDS_OK)
        status = edit_join(change, j, b, change->made.data[2 * other]);
    }
  }
  gmds_ids_clear(&image);
  return status;
}

gmds_status gmds_map_insert_edge_in_face(gmds_map *map, gmds_id d, gmds_id e, gmds_id *made)
{
  if (!gmds_map_has(map, d) || !gmds_map_has(map, e))
    return GMDS_ERR_CELL;
  gmds_id f = d;
  int found = 0;
  do {
    f = gmds_map_beta(map, 1, f);
    found |= f == e && f != d;
  } while (f != GMDS_NONE && f != d);
  if (!found || f == GMDS_NONE)
    return GMDS_ERR_CONFLICT;
  insertion in;
  insertion_begin(&in, map);
  GMDS_TRY(insertion_end(&in, insert_edges(&in, d, e)));
  if (made)
    *made = gmds_map_beta(map, 2, gmds_map_beta(map, 0, d));
  return GMDS_OK;
}

gmds_status gmds_map_insert_dangling_edge(gmds_map *map, gmds_id d, const double *x, gmds_id *made)
{
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  if (gmds_map_beta(map, 0, d) == GMDS_NONE)
    return GMDS_ERR_CONFLICT;
  insertion in;
  insertion_begin(&in, map);
  GMDS_TRY(insertion_end(&in, insert_edges(&in, d, d)));
  const gmds_id back = gmds_map_beta(map, 0, d);
  place(map, back, x);
  if (made)
    *made = gmds_map_beta(map, 0, back);
  return GMDS_OK;
}

/* ---- a face in a volume */

/* Whether dart e begins where d ends, on the surface of their volume. */
static int follows(const gmds_map *map, gmds_id d, gmds_id e)
{
  const gmds_id first = gmds_map_beta(map, 1, d);
  gmds_id f = first;
  while (f != GMDS_NONE) {
    if (f == e)
      return 1;
    f = gmds_map_next(map, 1, gmds_map_beta(map, 2, f));
    if (f == first)
      return 0;
  }
  for (f = first; f != GMDS_NONE; f = gmds_map_next(map, 2, gmds_map_beta(map, 0, f)))
    if (f == e)
      return 1;
  return 0;
}

static gmds_status check_path(insertion *in, size_t n, const gmds_id *path)
{
  for (size_t k = 0; k < n; k++) {
    if (!gmds_map_has(in->map, path[k]))
      return GMDS_ERR_CELL;
    if (id_table_find(&in->index, path[k]))
      return GMDS_ERR_CONFLICT;
    GMDS_TRY(id_table_put(&in->index, path[k], (gmds_id)k));
  }
  for (size_t k = 0; k < n; k++) {
    const gmds_id beside = gmds_map_beta(in->map, 2, path[k]);
    if (!follows(in->map, path[k], path[k + 1 < n ? k + 1 : 0]) ||
        (beside != GMDS_NONE && id_table_find(&in->index, beside)))
      return GMDS_ERR_CONFLICT;
  }
  return GMDS_OK;
}

static gmds_status insert_wall(insertion *in, size_t n, const gmds_id *path)
{
  edit *e = &in->change;
  GMDS_TRY(check_path(in, n, path));
  for (size_t k = 0; k < 2 * n; k++) {
    gmds_id made = GMDS_NONE;
    GMDS_TRY(edit_make(e, &made));
  }
  const gmds_id *f = e->made.data, *g = f + n; /* on the side of the path, and on the other */
  for (size_t k = 0; k < n; k++) {
    const size_t next = k + 1 < n ? k + 1 : 0;
    const gmds_id beside = gmds_map_beta(in->map, 2, path[k]);
    GMDS_TRY(edit_join(e, 2, path[k], f[k]));
    if (beside != GMDS_NONE)
      GMDS_TRY(edit_join(e, 2, beside, g[k]));
    GMDS_TRY(edit_join(e, 1, f[next], f[k]));
    GMDS_TRY(edit_join(e, 1, g[k], g[next]));
    GMDS_TRY(edit_join(e, 3, f[k], g[k]));
  }
  return GMDS_OK;
}

gmds_status gmds_map_insert_face_in_volume(gmds_map *map, size_t n, const gmds_id *path, gmds_id *made)
{
  if (map->n != 3 || !n)
    return GMDS_ERR_ARGUMENT;
  insertion in;
  insertion_begin(&in, map);
  GMDS_TRY(insertion_end(&in, insert_wall(&in, n, path)));
  if (made)
    *made = gmds_map_beta(map, 2, path[0]);
  return GMDS_OK;
}

/* ---- closing */

/* The i-free dart that the hole goes on with at dart d: from beta_j(d) around what is sewn. GMDS_NONE: there is none.
 * */
static gmds_id around_hole(const gmds_map *map, int i, int j, gmds_id d)
{
  gmds_id x = gmds_map_beta(map, j, d);
  while (x != GMDS_NONE && gmds_map_beta(map, i, x) != GMDS_NONE)
    x = gmds_map_beta(map, j, gmds_map_beta(map, i, x));
  return x;
}

static gmds_status close_holes(insertion *in, int i)
{
  edit *e = &in->change;
  gmds_map *map = in->map;
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1))
    if (gmds_map_beta(map, i, d) == GMDS_NONE) {
      GMDS_TRY(id_table_put(&in->index, d, (gmds_id)in->at.n));
      GMDS_TRY(gmds_ids_push(&in->at, d));
    }
  for (size_t k = 0; k < in->at.n; k++) {
    gmds_id made = GMDS_NONE;
    GMDS_TRY(edit_make(e, &made));
  }
  for (size_t k = 0; k < in->at.n; k++) { /* links among the new darts first: the holes are still open */
    const gmds_id d = in->at.data[k], made = e->made.data[k];
    for (int j = 1; j <= map->n; j++) {
      if (j == i || j == i + 1)
        continue;
      const int towards = j == 1 ? 0 : j;
      const gmds_id other = j == i - 1 ? around_hole(map, i, towards, d) : gmds_map_beta(map, towards, d);
      if (other == GMDS_NONE && j < i)
        return GMDS_ERR_CONFLICT;
      if (other != GMDS_NONE)
        GMDS_TRY(edit_join(e, j, made, made_for(in, other, 1, 0)));
    }
  }
  for (size_t k = 0; k < in->at.n; k++)
    GMDS_TRY(edit_join(e, i, in->at.data[k], e->made.data[k]));
  return GMDS_OK;
}

gmds_status gmds_map_close(gmds_map *map, int i, size_t *made)
{
  if (i < 2 || i > map->n)
    return GMDS_ERR_ARGUMENT;
  insertion in;
  insertion_begin(&in, map);
  const size_t had = map->darts.count;
  GMDS_TRY(insertion_end(&in, close_holes(&in, i)));
  if (made)
    *made = map->darts.count - had;
  return GMDS_OK;
}
