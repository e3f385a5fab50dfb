/* Edits of a combinatorial map: links are changed at once and written down. At the end the cells around what changed
 * are found anew: an orbit keeps the first of its cells that no orbit before it has, what is left over has gone into
 * the orbit where it was met first, and an orbit without a cell gets a new one, a part of the cell that its darts had.
 * All room is taken before a cell changes; when there is none, the links are taken back. */
#include "map_inside.h"
#include <string.h>

void edit_begin(edit *e, gmds_map *map)
{
  *e = (edit){.map = map,
              .log = {.memory = &map->memory},
              .made = {.memory = &map->memory},
              .gone = {.memory = &map->memory},
              .goes = {.memory = &map->memory}};
}

/* Sets one entry and writes down what it was. */
static gmds_status set_beta(edit *e, int i, gmds_id d, gmds_id f)
{
  gmds_id *entry = gmds_map_record(e->map, d) + i;
  if (*entry == f)
    return GMDS_OK;
  GMDS_TRY(gmds_ids_reserve(&e->log, e->log.n + 3));
  e->log.data[e->log.n++] = d;
  e->log.data[e->log.n++] = (gmds_id)i;
  e->log.data[e->log.n++] = *entry;
  *entry = f;
  e->betas |= GMDS_BETA(i);
  return GMDS_OK;
}

gmds_status edit_join(edit *e, int i, gmds_id d, gmds_id f)
{
  const int inverse = i < 2 ? 1 - i : i;
  const gmds_id d_had = gmds_map_beta(e->map, i, d);
  if (d_had == f)
    return GMDS_OK;
  const gmds_id f_had = gmds_map_next(e->map, inverse, f);
  if (d_had != GMDS_NONE)
    GMDS_TRY(set_beta(e, inverse, d_had, GMDS_NONE));
  if (f_had != GMDS_NONE)
    GMDS_TRY(set_beta(e, i, f_had, GMDS_NONE));
  GMDS_TRY(set_beta(e, i, d, f));
  return f == GMDS_NONE ? GMDS_OK : set_beta(e, inverse, f, d);
}

gmds_status edit_make(edit *e, gmds_id *d)
{
  GMDS_TRY(gmds_ids_reserve(&e->made, e->made.n + 1));
  GMDS_TRY(gmds_map_grow(e->map, -1, 1));
  *d = gmds_map_take_dart(e->map);
  return gmds_ids_push(&e->made, *d);
}

gmds_status edit_drop(edit *e, gmds_id d)
{
  for (int i = 0; i <= e->map->n; i++)
    GMDS_TRY(edit_join(e, i, d, GMDS_NONE));
  GMDS_TRY(id_table_put(&e->goes, d, 0));
  return gmds_ids_push(&e->gone, d);
}

static void take_back(edit *e)
{
  while (e->log.n) {
    const gmds_id *entry = e->log.data + (e->log.n -= 3);
    gmds_map_record(e->map, entry[0])[entry[1]] = entry[2];
  }
  while (e->made.n)
    gmds_cells_drop(&e->map->darts, e->made.data[--e->made.n]);
}

/* Whether beta_j after beta_i is an involution at d, j >= i + 2, and no involution fixes it. */
static int is_sound_at(const gmds_map *map, gmds_id d)
{
  for (int i = 1; i <= map->n; i++) {
    const gmds_id a = gmds_map_beta(map, i, d);
    if (a == GMDS_NONE)
      continue;
    if (i > 1 && a == d)
      return 0;
    for (int j = i + 2; j <= map->n; j++) {
      const gmds_id b = gmds_map_beta(map, j, d), beyond = gmds_map_beta(map, j, a);
      if ((b != GMDS_NONE || beyond != GMDS_NONE) && (b == GMDS_NONE || gmds_map_next(map, i, beyond) != b))
        return 0;
    }
  }
  return 1;
}

int edit_is_sound(const edit *e)
{
  const gmds_map *map = e->map;
  for (size_t k = 0; k < e->log.n; k++) {
    const gmds_id d = e->log.data[k];
    if (k % 3 == 1 || d == GMDS_NONE || id_table_find(&e->goes, d))
      continue;
    if (!is_sound_at(map, d))
      return 0;
    for (int i = 0; i <= map->n; i++)
      if (gmds_map_beta(map, i, d) != GMDS_NONE && !is_sound_at(map, gmds_map_beta(map, i, d)))
        return 0;
  }
  return 1;
}

/* ---- what becomes of the cells */

/* The orbits of one dimension around the edit. */
typedef struct settling {
  gmds_map *map;
  int cell;
  size_t n_orbits, n_fresh;
  gmds_ids darts;       /* of all orbits, one after the other */
  gmds_ids begin;       /* where each begins, and the end */
  gmds_ids owner;       /* of each orbit: the cell it keeps, or GMDS_NONE */
  gmds_ids kept_anchor; /* of each orbit: the dart that its cell had */
  id_table seen;        /* of each dart met: nothing */
  id_table met;         /* of each cell met: the orbit where it was met first */
  id_table kept;        /* of each cell that is kept: its orbit */
} settling;

static void settling_begin(settling *s, gmds_map *map, int cell)
{
  gmds_memory *memory = &map->memory;
  *s = (settling){.map = map, .cell = cell};
  s->darts.memory = s->begin.memory = s->owner.memory = s->kept_anchor.memory = memory;
  s->seen.memory = s->met.memory = s->kept.memory = memory;
}

static void settling_clear(settling *s)
{
  gmds_ids_clear(&s->darts);
  gmds_ids_clear(&s->begin);
  gmds_ids_clear(&s->owner);
  gmds_ids_clear(&s->kept_anchor);
  id_table_clear(&s->seen);
  id_table_clear(&s->met);
  id_table_clear(&s->kept);
}

static gmds_status meet(settling *s, gmds_id d, gmds_id orbit)
{
  const gmds_id c = gmds_map_cell(s->map, s->cell, d);
  return c == GMDS_NONE || id_table_find(&s->met, c) ? GMDS_OK : id_table_put(&s->met, c, orbit);
}

/* Gathers the orbit of d unless it was met. */
static gmds_status gather_orbit(settling *s, gmds_id d)
{
  const unsigned betas = gmds_map_cell_betas(s->map, s->cell);
  if (id_table_find(&s->seen, d))
    return GMDS_OK;
  const gmds_id orbit = (gmds_id)s->n_orbits++;
  gmds_id keeps = GMDS_NONE;
  GMDS_TRY(gmds_ids_push(&s->begin, (gmds_id)s->darts.n));
  GMDS_TRY(id_table_put(&s->seen, d, 0));
  GMDS_TRY(gmds_ids_push(&s->darts, d));
  for (size_t k = s->begin.data[orbit]; k < s->darts.n; k++) {
    gmds_id to[MAP_MOVES];
    const gmds_id f = s->darts.data[k], c = gmds_map_cell(s->map, s->cell, f);
    if (keeps == GMDS_NONE && c != GMDS_NONE && !id_table_find(&s->kept, c)) {
      keeps = c;
      GMDS_TRY(id_table_put(&s->kept, c, orbit));
    }
    GMDS_TRY(meet(s, f, orbit));
    const int n = map_moves(s->map, betas, f, to);
    for (int q = 0; q < n; q++)
      if (to[q] != GMDS_NONE && !id_table_find(&s->seen, to[q])) {
        GMDS_TRY(id_table_put(&s->seen, to[q], 0));
        GMDS_TRY(gmds_ids_push(&s->darts, to[q]));
      }
  }
  s->n_fresh += keeps == GMDS_NONE;
  GMDS_TRY(gmds_ids_push(&s->kept_anchor, GMDS_NONE));
  return gmds_ids_push(&s->owner, keeps);
}

/* The orbit of a dart and those of its neighbours. */
static gmds_status gather_around(settling *s, const edit *e, gmds_id d)
{
  if (d == GMDS_NONE || id_table_find(&e->goes, d))
    return GMDS_OK;
  GMDS_TRY(gather_orbit(s, d));
  for (int i = 0; i <= s->map->n; i++)
    if (gmds_map_beta(s->map, i, d) != GMDS_NONE)
      GMDS_TRY(gather_orbit(s, gmds_map_beta(s->map, i, d)));
  return GMDS_OK;
}

static gmds_status plan_settling(settling *s, const edit *e)
{
  for (size_t k = 0; k < e->log.n; k += 3) { /* first the orbits of the darts that the caller named */
    GMDS_TRY(gather_around(s, e, e->log.data[k]));
    GMDS_TRY(gather_around(s, e, e->log.data[k + 2]));
  }
  for (size_t k = 0; k < e->made.n; k++)
    GMDS_TRY(gather_around(s, e, e->made.data[k]));
  for (size_t k = 0; k < e->gone.n; k++)
    GMDS_TRY(meet(s, e->gone.data[k], GMDS_NONE));
  GMDS_TRY(gmds_ids_push(&s->begin, (gmds_id)s->darts.n));
  return gmds_map_grow(s->map, s->cell, s->n_fresh);
}

/* A new cell with the values of `from`, if that is one. */
static gmds_id split_cell(gmds_map *map, int i, gmds_id from)
{
  const gmds_id c = gmds_cells_take(&map->cells[i]);
  const size_t dim = (size_t)map->coordinates;
  if (i == 0 && from == GMDS_NONE)
    memset(map->points + dim * c, 0, dim * sizeof *map->points);
  if (from == GMDS_NONE)
    return c;
  if (i == 0)
    memcpy(map->points + dim * c, map->points + dim * from, dim * sizeof *map->points);
  for (gmds_attribute *a = map->cells[i].attributes; a; a = a->next)
    memcpy((char *)a->data + c * a->bytes, (char *)a->data + from * a->bytes, a->bytes);
  for (size_t k = 0; k < map->n_rules; k++) {
    const gmds_map_rule *rule = &map->rules[k];
    if (rule->cell == i && rule->split)
      rule->split(rule->user, (char *)rule->attribute->data + from * rule->attribute->bytes,
                  (char *)rule->attribute->data + c * rule->attribute->bytes);
  }
  return c;
}

static void merge_cell(gmds_map *map, int i, gmds_id kept, gmds_id gone)
{
  for (size_t k = 0; k < map->n_rules; k++) {
    const gmds_map_rule *rule = &map->rules[k];
    if (rule->cell == i && rule->merge)
      rule->merge(rule->user, (char *)rule->attribute->data + kept * rule->attribute->bytes,
                  (const char *)rule->attribute->data + gone * rule->attribute->bytes);
  }
}

/* The first cell that a dart of an orbit had. */
static gmds_id cell_of_orbit(const settling *s, size_t orbit)
{
  for (size_t k = s->begin.data[orbit]; k < s->begin.data[orbit + 1]; k++) {
    const gmds_id c = gmds_map_cell(s->map, s->cell, s->darts.data[k]);
    if (c != GMDS_NONE)
      return c;
  }
  return GMDS_NONE;
}

static void commit_settling(settling *s, int keep_nodes)
{
  gmds_map *map = s->map;
  const int i = s->cell;
  for (size_t o = 0; o < s->n_orbits; o++) /* splits first: they read cells as they were */
    if (s->owner.data[o] == GMDS_NONE)
      s->owner.data[o] = split_cell(map, i, cell_of_orbit(s, o));
    else
      s->kept_anchor.data[o] = map->anchor[i][s->owner.data[o]];
  for (size_t o = 0; o < s->n_orbits; o++) {
    const gmds_id c = s->owner.data[o];
    int has_anchor = 0; /* a cell keeps its dart while it is on it: sides are counted from there */
    for (size_t k = s->begin.data[o]; k < s->begin.data[o + 1]; k++) {
      gmds_map_record(map, s->darts.data[k])[map->slot[i]] = c;
      has_anchor |= s->kept_anchor.data[o] == s->darts.data[k];
    }
    if (!has_anchor)
      map->anchor[i][c] = s->darts.data[s->begin.data[o]];
  }
  for (size_t k = 0; k < s->met.capacity; k++) {
    const gmds_id c = s->met.slots[2 * k], orbit = s->met.slots[2 * k + 1];
    if (c == GMDS_NONE || id_table_find(&s->kept, c))
      continue;
    if (orbit != GMDS_NONE)
      merge_cell(map, i, s->owner.data[orbit], c);
    else if (i == 0 && keep_nodes) {
      map->anchor[0][c] = GMDS_NONE;
      continue;
    }
    gmds_cells_drop(&map->cells[i], c);
  }
}

/* Whether i-cells can have changed. */
static int concerns(const edit *e, int i)
{
  const unsigned own = i == 1 ? GMDS_BETA(0) | GMDS_BETA(1) : i ? GMDS_BETA(i) : 0;
  return e->map->slot[i] && (e->made.n || e->gone.n || e->betas & ~own);
}

gmds_status edit_end(edit *e, gmds_status status)
{
  settling all[GMDS_MAP_KEPT];
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    settling_begin(&all[i], e->map, i);
  for (int i = 0; i < GMDS_MAP_KEPT && status == GMDS_OK; i++)
    if (concerns(e, i))
      status = plan_settling(&all[i], e);
  if (status == GMDS_OK) {
    for (int i = 0; i < GMDS_MAP_KEPT; i++)
      if (concerns(e, i))
        commit_settling(&all[i], e->keep_nodes);
    for (size_t k = 0; k < e->gone.n; k++)
      gmds_cells_drop(&e->map->darts, e->gone.data[k]);
  } else
    take_back(e);
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    settling_clear(&all[i]);
  gmds_ids_clear(&e->log);
  gmds_ids_clear(&e->made);
  gmds_ids_clear(&e->gone);
  id_table_clear(&e->goes);
  return status;
}
