/* Orbits of darts, and the cells around a cell. */
#include "map_inside.h"
#include <string.h>

void id_table_clear(id_table *t)
{
  gmds_release(t->memory, t->slots, 2 * t->capacity, sizeof(gmds_id));
  t->slots = NULL;
  t->capacity = t->n = 0;
}

void id_table_empty(id_table *t)
{
  for (size_t k = 0; k < t->capacity; k++)
    t->slots[2 * k] = GMDS_NONE;
  t->n = 0;
}

/* Where a key is, or would be. */
static size_t place_of(const gmds_id *slots, size_t step, size_t capacity, gmds_id key)
{
  size_t k = (size_t)(((uint64_t)key * 0x9e3779b97f4a7c15u) >> 32) & (capacity - 1);
  while (slots[step * k] != key && slots[step * k] != GMDS_NONE)
    k = (k + 1) & (capacity - 1);
  return k;
}

gmds_id *id_table_find(const id_table *t, gmds_id key)
{
  if (!t->capacity)
    return NULL;
  gmds_id *slot = t->slots + 2 * place_of(t->slots, 2, t->capacity, key);
  return *slot == key ? slot + 1 : NULL;
}

static gmds_status grow_table(id_table *t)
{
  void *block = NULL;
  const size_t had = t->capacity, capacity = had ? 2 * had : 32;
  if (!gmds_resize(t->memory, &block, 0, 2 * capacity, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_id *old = t->slots;
  t->slots = block;
  t->capacity = capacity;
  const size_t n = t->n;
  id_table_empty(t);
  t->n = n;
  for (size_t k = 0; k < had; k++)
    if (old[2 * k] != GMDS_NONE)
      memcpy(t->slots + 2 * place_of(t->slots, 2, capacity, old[2 * k]), old + 2 * k, 2 * sizeof *old);
  gmds_release(t->memory, old, 2 * had, sizeof(gmds_id));
  return GMDS_OK;
}

gmds_status id_table_put(id_table *t, gmds_id key, gmds_id value)
{
  if (2 * (t->n + 1) > t->capacity)
    GMDS_TRY(grow_table(t));
  gmds_id *slot = t->slots + 2 * place_of(t->slots, 2, t->capacity, key);
  t->n += *slot != key;
  slot[0] = key;
  slot[1] = value;
  return GMDS_OK;
}

unsigned gmds_map_cell_betas(const gmds_map *map, int i)
{
  const unsigned all = (GMDS_BETA(map->n + 1) - 1) & ~GMDS_BETA(0);
  return i == 0 ? GMDS_SAME_ORIGIN : all & ~GMDS_BETA(i);
}

int map_moves(const gmds_map *map, unsigned betas, gmds_id d, gmds_id to[MAP_MOVES])
{
  const gmds_id *beta = gmds_map_record(map, d);
  int n = 0;
  if (betas == GMDS_SAME_ORIGIN) {
    for (int j = 2; j <= map->n; j++) {
      to[n++] = gmds_map_next(map, j, beta[0]);
      to[n++] = gmds_map_next(map, 1, beta[j]);
      for (int k = 2; k <= map->n; k++)
        if (k != j)
          to[n++] = gmds_map_next(map, k, beta[j]);
    }
    return n;
  }
  if (betas & 3) {
    to[n++] = beta[1];
    to[n++] = beta[0];
  }
  for (int j = 2; j <= map->n; j++)
    if (betas >> j & 1)
      to[n++] = beta[j];
  return n;
}

/* The cycles that need no marks: darts one after the other along `first`, then along `second` from d the other way
 * where the cycle is open. Two betas each, applied one after the other; -1 for none. */
static gmds_status walk(const gmds_map *map, gmds_id d, const int first[2], const int second[2], gmds_ids *list)
{
  gmds_id e = d;
  list->n = 0;
  do {
    GMDS_TRY(gmds_ids_push(list, e));
    e = gmds_map_next(map, first[0], e);
    if (first[1] >= 0)
      e = gmds_map_next(map, first[1], e);
  } while (e != d && e != GMDS_NONE);
  if (e == d)
    return GMDS_OK;
  for (e = d;;) {
    e = gmds_map_next(map, second[0], e);
    if (second[1] >= 0)
      e = gmds_map_next(map, second[1], e);
    if (e == GMDS_NONE)
      return GMDS_OK;
    GMDS_TRY(gmds_ids_push(list, e));
  }
}

enum { FEW = 16 };

/* Puts the darts of the queue, list[0 .. n), into a table of `capacity` slots behind room for half as many. */
static gmds_status rebuild(gmds_ids *list, size_t *capacity)
{
  const size_t grown = *capacity ? 2 * *capacity : 4 * FEW;
  GMDS_TRY(gmds_ids_reserve(list, grown / 2 + grown));
  gmds_id *table = list->data + grown / 2;
  for (size_t k = 0; k < grown; k++)
    table[k] = GMDS_NONE;
  for (size_t k = 0; k < list->n; k++)
    table[place_of(table, 1, grown, list->data[k])] = list->data[k];
  *capacity = grown;
  return GMDS_OK;
}

/* Appends d to the queue unless it is there. The queue may be as long as half the table. */
static gmds_status visit(gmds_ids *list, size_t *capacity, gmds_id d)
{
  if (!*capacity) {
    if (gmds_ids_has(list, d))
      return GMDS_OK;
    if (list->n < FEW)
      return gmds_ids_push(list, d);
    GMDS_TRY(rebuild(list, capacity));
  }
  gmds_id *table = list->data + *capacity / 2;
  size_t place = place_of(table, 1, *capacity, d);
  if (table[place] == d)
    return GMDS_OK;
  if (list->n == *capacity / 2) {
    GMDS_TRY(rebuild(list, capacity));
    table = list->data + *capacity / 2;
    place = place_of(table, 1, *capacity, d);
  }
  table[place] = d;
  list->data[list->n++] = d;
  return GMDS_OK;
}

gmds_status gmds_map_orbit(const gmds_map *map, gmds_id d, unsigned betas, gmds_ids *list)
{
  const unsigned all = GMDS_BETA(map->n + 1) - 1;
  if (betas == GMDS_SAME_ORIGIN && map->n == 2)
    return walk(map, d, (const int[2]){0, 2}, (const int[2]){2, 1}, list);
  if (betas != GMDS_SAME_ORIGIN && (betas & all) && !(betas & all & ~3u))
    return walk(map, d, (const int[2]){1, -1}, (const int[2]){0, -1}, list);
  size_t capacity = 0;
  list->n = 0;
  GMDS_TRY(gmds_ids_push(list, d));
  for (size_t k = 0; k < list->n; k++) {
    gmds_id to[MAP_MOVES];
    const int n = map_moves(map, betas, list->data[k], to);
    for (int q = 0; q < n; q++)
      if (to[q] != GMDS_NONE)
        GMDS_TRY(visit(list, &capacity, to[q]));
  }
  return GMDS_OK;
}

/* Keeps the entries from `first` on once each, in their order, less `but`; moves them to the front. Short lists and
 * those in order (2 -> 0, 2 -> 1) by comparison, long ones are sorted. */
static void keep_once(gmds_ids *list, size_t first, gmds_id but, int ordered)
{
  if (!ordered && list->n - first > 2 * FEW) {
    gmds_ids_keep(list, first, 1, but);
    memmove(list->data, list->data + first, (list->n - first) * sizeof *list->data);
    list->n -= first;
    return;
  }
  size_t n = 0;
  for (size_t k = first; k < list->n; k++) {
    const gmds_id c = list->data[k];
    size_t q = 0;
    while (q < n && list->data[q] != c)
      q++;
    if (q == n && c != but && c != GMDS_NONE)
      list->data[n++] = c;
  }
  list->n = n;
}

/* Appends the j-cells at dart d of an i-cell, i != j. */
static gmds_status push_incident(const gmds_map *map, int i, int j, gmds_id d, gmds_ids *list)
{
  const gmds_id before = gmds_map_beta(map, 0, d), after = gmds_map_beta(map, 1, d);
  if (i == 0 && before != GMDS_NONE)
    GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, j, before)));
  GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, j, d)));
  if (j == 0 && after != GMDS_NONE)
    return gmds_ids_push(list, gmds_map_cell(map, 0, after));
  for (int k = 2; i == 0 && before == GMDS_NONE && k <= map->n; k++) { /* cells that end here at an open border */
    const gmds_id beside = gmds_map_beta(map, k, d);
    if (beside != GMDS_NONE)
      GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, j, beside)));
  }
  return GMDS_OK;
}

/* Appends the i-cells around the (i-1)-cells at dart d of an i-cell: those that share one with it. For nodes: the other
 * ends of edges. */
static gmds_status push_adjacent(const gmds_map *map, int i, gmds_id d, gmds_ids *orbit, gmds_ids *list)
{
  const gmds_id before = gmds_map_beta(map, 0, d), after = gmds_map_beta(map, 1, d);
  if (i == map->n) {
    const gmds_id beyond = gmds_map_beta(map, i, d);
    return beyond == GMDS_NONE ? GMDS_OK : gmds_ids_push(list, gmds_map_cell(map, i, beyond));
  }
  if (i == 0) {
    if (before != GMDS_NONE)
      GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, 0, before)));
    return after == GMDS_NONE ? GMDS_OK : gmds_ids_push(list, gmds_map_cell(map, 0, after));
  }
  const gmds_id at[2] = {d, i == 1 ? after : GMDS_NONE};
  for (int k = 0; k < 2; k++) {
    if (at[k] == GMDS_NONE)
      continue;
    GMDS_TRY(gmds_map_orbit(map, at[k], gmds_map_cell_betas(map, i - 1), orbit));
    for (size_t q = 0; q < orbit->n; q++) {
      const gmds_id o = orbit->data[q], p = i == 1 ? gmds_map_beta(map, 0, o) : GMDS_NONE;
      GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, i, o)));
      if (p != GMDS_NONE)
        GMDS_TRY(gmds_ids_push(list, gmds_map_cell(map, i, p)));
    }
  }
  return GMDS_OK;
}

/* The first dart of each face of the volume of d where that is a tetrahedron: what triangulations ask most. */
static int faces_of_tetrahedron(const gmds_map *map, gmds_id d, gmds_id face[4])
{
  const gmds_id b = gmds_map_beta(map, 1, d), c = gmds_map_beta(map, 0, d);
  if (b == GMDS_NONE || c == GMDS_NONE || gmds_map_beta(map, 1, b) != c)
    return 0;
  const gmds_id on[3] = {d, b, c};
  face[3] = d;
  for (int k = 0; k < 3; k++) {
    face[k] = gmds_map_beta(map, 2, on[k]);
    const gmds_id next = gmds_map_next(map, 1, face[k]), last = gmds_map_next(map, 1, next);
    if (last == GMDS_NONE || gmds_map_beta(map, 1, last) != face[k])
      return 0;
  }
  for (int k = 0; k < 3; k++) /* the other faces meet each other: what precedes here follows there */
    if (gmds_map_beta(map, 2, gmds_map_beta(map, 0, face[k])) != gmds_map_beta(map, 1, face[k < 2 ? k + 1 : 0]))
      return 0;
  return 1;
}

/* 3 -> 0 and 3 -> 3 of a tetrahedron. */
static gmds_status tetrahedron_adjacent(const gmds_map *map, int j, gmds_id c, const gmds_id face[4], gmds_ids *list)
{
  GMDS_TRY(gmds_ids_reserve(list, 4));
  list->n = 4;
  for (int k = 0; k < 4; k++) {
    const gmds_id beyond = gmds_map_beta(map, 3, face[k]);
    if (j == 3)
      list->data[k] = beyond == GMDS_NONE ? GMDS_NONE : gmds_map_cell(map, 3, beyond);
    else /* where the sides of face 3 begin, and the node that is not on it */
      list->data[k] = gmds_map_cell(map, 0, k < 3 ? face[k] : gmds_map_beta(map, 0, face[0]));
  }
  keep_once(list, 0, j == 3 ? c : GMDS_NONE, 1);
  return GMDS_OK;
}

gmds_status gmds_map_adjacent(const gmds_map *map, int i, int j, gmds_id c, gmds_ids *list)
{
  if (!gmds_cells_has(&map->cells[i], c))
    return GMDS_ERR_CELL;
  const gmds_id d = map->anchor[i][c];
  list->n = 0;
  if (d == GMDS_NONE)
    return GMDS_OK;
  gmds_id face[4];
  if (i == 3 && map->n == 3 && (j == 0 || j == 3) && faces_of_tetrahedron(map, d, face))
    return tetrahedron_adjacent(map, j, c, face, list);
  const int ordered = i == 2 && j < 2;
  const unsigned betas = ordered ? GMDS_BETA(1) : gmds_map_cell_betas(map, i);
  gmds_ids orbit = {.memory = list->memory};
  GMDS_TRY(gmds_map_orbit(map, d, betas, list));
  const size_t n = list->n;
  gmds_status status = GMDS_OK;
  for (size_t k = 0; k < n && status == GMDS_OK; k++)
    status =
        i == j ? push_adjacent(map, i, list->data[k], &orbit, list) : push_incident(map, i, j, list->data[k], list);
  gmds_ids_clear(&orbit);
  if (status == GMDS_OK)
    keep_once(list, n, i == j ? c : GMDS_NONE, ordered);
  return status;
}

static gmds_status fill_adjacent(const gmds_map *map, int i, int j, gmds_ids *list, gmds_csr *csr)
{
  const gmds_cells *cells = &map->cells[i];
  size_t used = 0;
  GMDS_TRY(gmds_csr_begin(csr, cells->end));
  for (size_t c = 0; c < cells->end; c++) {
    csr->begin[c] = used;
    if (!gmds_cells_has(cells, (gmds_id)c))
      continue;
    GMDS_TRY(gmds_map_adjacent(map, i, j, (gmds_id)c, list));
    if (used + list->n > csr->capacity) {
      void *data = csr->data;
      const size_t grown = gmds_grown(csr->capacity, used + list->n);
      if (!gmds_resize(csr->memory, &data, csr->capacity, grown, sizeof *csr->data))
        return GMDS_ERR_MEMORY;
      csr->data = data;
      csr->capacity = grown;
    }
    if (list->n)
      memcpy(csr->data + used, list->data, list->n * sizeof *list->data);
    used += list->n;
  }
  csr->begin[cells->end] = used;
  return GMDS_OK;
}

gmds_status gmds_map_all_adjacent(const gmds_map *map, int i, int j, gmds_csr *csr)
{
  gmds_csr result;
  gmds_ids list = {.memory = csr->memory};
  gmds_csr_init(&result, csr->memory);
  gmds_status status = fill_adjacent(map, i, j, &list, &result);
  gmds_ids_clear(&list);
  if (status == GMDS_OK)
    *csr = result;
  else
    gmds_csr_clear(&result);
  return status;
}

gmds_status gmds_map_count_orbits(const gmds_map *map, unsigned betas, gmds_memory *memory, size_t *count)
{
  gmds_bits seen;
  gmds_ids list = {.memory = memory};
  size_t n = 0;
  GMDS_TRY(gmds_bits_init(&seen, memory, map->darts.end));
  gmds_status status = GMDS_OK;
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE && status == GMDS_OK;
       d = gmds_cells_next(&map->darts, d + 1)) {
    if (gmds_bits_get(&seen, d))
      continue;
    n++;
    status = gmds_map_orbit(map, d, betas, &list);
    for (size_t k = 0; k < list.n && status == GMDS_OK; k++)
      gmds_bits_set(&seen, list.data[k]);
  }
  gmds_ids_clear(&list);
  gmds_bits_clear(&seen);
  if (status == GMDS_OK)
    *count = n;
  return status;
}

gmds_status gmds_map_components(const gmds_map *map, gmds_memory *memory, size_t *count)
{
  return gmds_map_count_orbits(map, GMDS_BETA(map->n + 1) - 1, memory, count);
}
