/* Links and sewing (Damiand and Lienhardt 2014: sewing two cells is linking the darts of two isomorphic orbits, two by
 * two).
 */
#include "map_inside.h"
#include <string.h>

static int is_beta(const gmds_map *map, int i)
{
  return i >= 1 && i <= map->n;
}

/* What link and sew ask of two darts. */
static gmds_status check_pair(const gmds_map *map, int i, gmds_id d, gmds_id e)
{
  if (!is_beta(map, i) || (i > 1 && d == e))
    return GMDS_ERR_ARGUMENT;
  if (!gmds_map_has(map, d) || !gmds_map_has(map, e))
    return GMDS_ERR_CELL;
  const int inverse = i == 1 ? 0 : i;
  const int free = gmds_map_beta(map, i, d) == GMDS_NONE && gmds_map_beta(map, inverse, e) == GMDS_NONE;
  return free ? GMDS_OK : GMDS_ERR_CONFLICT;
}

gmds_status gmds_map_link(gmds_map *map, int i, gmds_id d, gmds_id e)
{
  GMDS_TRY(check_pair(map, i, d, e));
  gmds_map_record(map, d)[i] = e;
  gmds_map_record(map, e)[i == 1 ? 0 : i] = d;
  return GMDS_OK;
}

gmds_status gmds_map_unlink(gmds_map *map, int i, gmds_id d)
{
  if (!is_beta(map, i))
    return GMDS_ERR_ARGUMENT;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  const gmds_id e = gmds_map_beta(map, i, d);
  if (e == GMDS_NONE)
    return GMDS_ERR_CONFLICT;
  gmds_map_record(map, d)[i] = GMDS_NONE;
  gmds_map_record(map, e)[i == 1 ? 0 : i] = GMDS_NONE;
  return GMDS_OK;
}

/* The pairs of darts that sewing d and e links, found by going through both orbits at once. */
typedef struct pairing {
  const gmds_map *map;
  int i;
  gmds_ids pairs;   /* two by two: beta_i leads from the first to the second */
  id_table partner; /* of each dart; for i = 1 of each first */
  id_table back;    /* for i = 1 the first of each second */
} pairing;

static void pairing_clear(pairing *p)
{
  gmds_ids_clear(&p->pairs);
  id_table_clear(&p->partner);
  id_table_clear(&p->back);
}

/* Appends a pair unless it is there. GMDS_ERR_CONFLICT: one of both is paired otherwise, is not free, or is missing. */
static gmds_status add_pair(pairing *p, gmds_id d, gmds_id e)
{
  if (d == GMDS_NONE && e == GMDS_NONE)
    return GMDS_OK;
  if (d == GMDS_NONE || e == GMDS_NONE || (p->i > 1 && d == e))
    return GMDS_ERR_CONFLICT;
  id_table *back = p->i == 1 ? &p->back : &p->partner;
  const gmds_id *to = id_table_find(&p->partner, d), *from = id_table_find(back, e);
  if (to || from)
    return to && from && *to == e && *from == d ? GMDS_OK : GMDS_ERR_CONFLICT;
  if (gmds_map_beta(p->map, p->i, d) != GMDS_NONE || gmds_map_beta(p->map, p->i == 1 ? 0 : p->i, e) != GMDS_NONE)
    return GMDS_ERR_CONFLICT;
  GMDS_TRY(id_table_put(&p->partner, d, e));
  GMDS_TRY(id_table_put(back, e, d));
  GMDS_TRY(gmds_ids_push(&p->pairs, d));
  return gmds_ids_push(&p->pairs, e);
}

static gmds_status find_pairs(pairing *p, gmds_id d, gmds_id e)
{
  const gmds_map *map = p->map;
  GMDS_TRY(add_pair(p, d, e));
  for (size_t k = 0; k < p->pairs.n; k += 2) {
    const gmds_id *a = gmds_map_record(map, p->pairs.data[k]), *b = gmds_map_record(map, p->pairs.data[k + 1]);
    if (p->i > 2) {
      GMDS_TRY(add_pair(p, a[1], b[0]));
      GMDS_TRY(add_pair(p, a[0], b[1]));
    }
    for (int j = 2; j <= map->n; j++) {
      if (j >= p->i - 1 && j <= p->i + 1)
        continue;
      if (p->i == 1)
        GMDS_TRY(add_pair(p, b[j], a[j]));
      else
        GMDS_TRY(add_pair(p, a[j], b[j]));
    }
  }
  return GMDS_OK;
}

gmds_status gmds_map_is_sewable(const gmds_map *map, int i, gmds_id d, gmds_id e, gmds_memory *memory, int *sewable)
{
  pairing p = {.map = map, .i = i};
  p.pairs.memory = p.partner.memory = p.back.memory = memory;
  gmds_status status = check_pair(map, i, d, e);
  if (status == GMDS_OK)
    status = find_pairs(&p, d, e);
  pairing_clear(&p);
  if (status != GMDS_OK && status != GMDS_ERR_CONFLICT)
    return status;
  *sewable = status == GMDS_OK;
  return GMDS_OK;
}

gmds_status gmds_map_sew(gmds_map *map, int i, gmds_id d, gmds_id e)
{
  pairing p = {.map = map, .i = i};
  p.pairs.memory = p.partner.memory = p.back.memory = &map->memory;
  gmds_status status = check_pair(map, i, d, e);
  if (status == GMDS_OK)
    status = find_pairs(&p, d, e);
  if (status == GMDS_OK) {
    edit change;
    edit_begin(&change, map);
    for (size_t k = 0; k < p.pairs.n && status == GMDS_OK; k += 2)
      status = edit_join(&change, i, p.pairs.data[k], p.pairs.data[k + 1]);
    status = edit_end(&change, status);
  }
  pairing_clear(&p);
  return status;
}

/* The i-links that unsewing d takes away: first darts only. */
static gmds_status find_links(pairing *p, gmds_id d)
{
  const gmds_map *map = p->map;
  GMDS_TRY(gmds_ids_push(&p->pairs, d));
  GMDS_TRY(id_table_put(&p->partner, d, 0));
  for (size_t k = 0; k < p->pairs.n; k++) {
    const gmds_id *a = gmds_map_record(map, p->pairs.data[k]);
    const gmds_id *b = gmds_map_record(map, a[p->i]);
    for (int j = p->i > 2 ? 0 : 2; j <= map->n; j++) {
      if (j >= p->i - 1 && j <= p->i + 1)
        continue;
      const gmds_id next = p->i == 1 ? b[j] : a[j];
      if (next == GMDS_NONE || id_table_find(&p->partner, next) || gmds_map_beta(map, p->i, next) == GMDS_NONE)
        continue;
      GMDS_TRY(id_table_put(&p->partner, next, 0));
      GMDS_TRY(gmds_ids_push(&p->pairs, next));
    }
  }
  return GMDS_OK;
}

gmds_status gmds_map_unsew(gmds_map *map, int i, gmds_id d)
{
  if (!is_beta(map, i))
    return GMDS_ERR_ARGUMENT;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  if (gmds_map_beta(map, i, d) == GMDS_NONE)
    return GMDS_ERR_CONFLICT;
  pairing p = {.map = map, .i = i};
  p.pairs.memory = p.partner.memory = p.back.memory = &map->memory;
  gmds_status status = find_links(&p, d);
  if (status == GMDS_OK) {
    edit change;
    edit_begin(&change, map);
    for (size_t k = 0; k < p.pairs.n && status == GMDS_OK; k++)
      status = edit_join(&change, i, p.pairs.data[k], GMDS_NONE);
    status = edit_end(&change, status);
  }
  pairing_clear(&p);
  return status;
}

/* ---- cells from orbits, whatever the links are */

/* The number of its orbit for each dart, and the first dart of each. */
static gmds_status number_orbits(const gmds_map *map, int i, gmds_memory *memory, gmds_id *orbit_of, gmds_ids *first)
{
  gmds_ids list = {.memory = memory};
  gmds_status status = GMDS_OK;
  for (size_t d = 0; d < map->darts.end; d++)
    orbit_of[d] = GMDS_NONE;
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE && status == GMDS_OK;
       d = gmds_cells_next(&map->darts, d + 1)) {
    if (orbit_of[d] != GMDS_NONE)
      continue;
    status = gmds_map_orbit(map, d, gmds_map_cell_betas(map, i), &list);
    for (size_t k = 0; k < list.n && status == GMDS_OK; k++)
      orbit_of[list.data[k]] = (gmds_id)first->n;
    if (status == GMDS_OK)
      status = gmds_ids_push(first, d);
  }
  gmds_ids_clear(&list);
  return status;
}

/* What becomes of i-cells: found first, for all dimensions, then carried out. */
typedef struct restoring {
  gmds_id *orbit_of;  /* of each dart */
  gmds_ids first;     /* the first dart of each orbit */
  gmds_ids owner;     /* the cell that each orbit keeps, or GMDS_NONE */
  gmds_ids was_there; /* whether it keeps one */
  gmds_bits taken;    /* cells that an orbit keeps */
  gmds_bits met;      /* cells that a dart has */
} restoring;

static gmds_status plan_restoring(gmds_map *map, int i, restoring *r)
{
  void *block = NULL;
  size_t fresh = 0;
  r->first.memory = r->owner.memory = r->was_there.memory = &map->memory;
  GMDS_TRY(gmds_bits_init(&r->taken, &map->memory, map->cells[i].end));
  GMDS_TRY(gmds_bits_init(&r->met, &map->memory, map->cells[i].end));
  if (!gmds_resize(&map->memory, &block, 0, map->darts.end, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  r->orbit_of = block;
  GMDS_TRY(number_orbits(map, i, &map->memory, r->orbit_of, &r->first));
  GMDS_TRY(gmds_ids_reserve(&r->owner, r->first.n));
  r->owner.n = r->first.n;
  for (size_t o = 0; o < r->first.n; o++)
    r->owner.data[o] = GMDS_NONE;
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    const gmds_id c = gmds_map_cell(map, i, d), o = r->orbit_of[d];
    if (!gmds_cells_has(&map->cells[i], c))
      continue;
    gmds_bits_set(&r->met, c);
    if (r->owner.data[o] != GMDS_NONE || gmds_bits_get(&r->taken, c))
      continue;
    r->owner.data[o] = c;
    gmds_bits_set(&r->taken, c);
  }
  GMDS_TRY(gmds_ids_reserve(&r->was_there, r->first.n));
  for (size_t o = 0; o < r->first.n; o++) {
    r->was_there.data[o] = r->owner.data[o] != GMDS_NONE;
    fresh += r->owner.data[o] == GMDS_NONE;
  }
  return gmds_map_grow(map, i, fresh);
}

static void commit_restoring(gmds_map *map, int i, restoring *r)
{
  const size_t end = map->cells[i].end, dim = (size_t)map->coordinates;
  for (size_t o = 0; o < r->first.n; o++) {
    const gmds_id d = r->first.data[o], from = gmds_map_cell(map, i, d);
    if (!r->was_there.data[o]) {
      const gmds_id c = r->owner.data[o] = gmds_cells_take(&map->cells[i]);
      if (c < end)
        gmds_bits_set(&r->taken, c);
      const int copies = from != GMDS_NONE && from < end && gmds_bits_get(&r->met, from);
      if (i == 0 && copies)
        memcpy(map->points + dim * c, map->points + dim * from, dim * sizeof *map->points);
      else if (i == 0)
        memset(map->points + dim * c, 0, dim * sizeof *map->points);
      for (gmds_attribute *a = map->cells[i].attributes; a && copies; a = a->next)
        memcpy((char *)a->data + c * a->bytes, (char *)a->data + from * a->bytes, a->bytes);
    }
    const gmds_id had = map->anchor[i][r->owner.data[o]];
    if (!r->was_there.data[o] || !gmds_map_has(map, had) || r->orbit_of[had] != o)
      map->anchor[i][r->owner.data[o]] = d;
  }
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1))
    gmds_map_record(map, d)[map->slot[i]] = r->owner.data[r->orbit_of[d]];
  for (size_t c = end; c-- > 0;) {
    if (!gmds_cells_has(&map->cells[i], (gmds_id)c) || gmds_bits_get(&r->taken, c))
      continue;
    if (i == 0 && !gmds_bits_get(&r->met, c))
      map->anchor[0][c] = GMDS_NONE; /* a node that no dart had stays one */
    else
      gmds_cells_drop(&map->cells[i], (gmds_id)c);
  }
}

gmds_status gmds_map_restore_cells(gmds_map *map)
{
  restoring all[GMDS_MAP_KEPT];
  gmds_status status = GMDS_OK;
  const size_t darts = map->darts.end;
  memset(all, 0, sizeof all);
  for (int i = 0; i < GMDS_MAP_KEPT && status == GMDS_OK; i++)
    if (map->slot[i])
      status = plan_restoring(map, i, &all[i]);
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    if (map->slot[i] && status == GMDS_OK)
      commit_restoring(map, i, &all[i]);
    gmds_release(&map->memory, all[i].orbit_of, all[i].orbit_of ? darts : 0, sizeof(gmds_id));
    if (all[i].first.memory) {
      gmds_ids_clear(&all[i].first);
      gmds_ids_clear(&all[i].owner);
      gmds_ids_clear(&all[i].was_there);
    }
    if (all[i].taken.memory)
      gmds_bits_clear(&all[i].taken);
    if (all[i].met.memory)
      gmds_bits_clear(&all[i].met);
  }
  return status;
}
