/* Combinatorial maps: life, growth, numbering. */
#include "map_inside.h"
#include <string.h>

void gmds_map_init(gmds_map *map, int n, int coordinates, unsigned kept, const gmds_allocator *allocator)
{
  memset(map, 0, sizeof *map);
  gmds_memory_init(&map->memory, allocator);
  const size_t limit = gmds_link_check == GMDS_ID_BITS ? GMDS_NONE : 0;
  map->n = n;
  map->coordinates = coordinates;
  map->stride = n + 1;
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    if (i <= n && (i == 0 || kept >> i & 1))
      map->slot[i] = map->stride++;
    gmds_cells_init(&map->cells[i], &map->memory, limit);
  }
  gmds_cells_init(&map->darts, &map->memory, limit);
  gmds_ids_init(&map->scratch, &map->memory);
}

void gmds_map_empty(gmds_map *map)
{
  gmds_release(&map->memory, map->records, map->records_capacity, (size_t)map->stride * sizeof *map->records);
  map->records = NULL;
  map->records_capacity = 0;
  gmds_release(&map->memory, map->points, map->points_capacity, (size_t)map->coordinates * sizeof *map->points);
  map->points = NULL;
  map->points_capacity = 0;
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    gmds_release(&map->memory, map->anchor[i], map->anchor_capacity[i], sizeof(gmds_id));
    map->anchor[i] = NULL;
    map->anchor_capacity[i] = 0;
    gmds_cells_empty(&map->cells[i]);
  }
  gmds_cells_empty(&map->darts);
  gmds_ids_clear(&map->scratch);
}

void gmds_map_clear(gmds_map *map)
{
  gmds_map_empty(map);
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    gmds_cells_clear(&map->cells[i]);
  gmds_cells_clear(&map->darts);
  gmds_release(&map->memory, map->rules, map->n_rules, sizeof *map->rules);
  map->rules = NULL;
  map->n_rules = 0;
}

void gmds_map_drop_darts(gmds_map *map)
{
  while (map->darts.count)
    gmds_cells_drop(&map->darts, (gmds_id)(map->darts.end - 1));
  for (int i = 1; i < GMDS_MAP_KEPT; i++)
    while (map->cells[i].count)
      gmds_cells_drop(&map->cells[i], (gmds_id)(map->cells[i].end - 1));
  for (size_t v = 0; v < map->cells[0].end; v++)
    map->anchor[0][v] = GMDS_NONE;
}

/* Each column knows its own room: after a failure some have more than the count says, which is no harm. */
static gmds_status resize_darts(gmds_map *map, size_t capacity)
{
  void *records = map->records;
  if (capacity > map->darts.limit)
    return GMDS_ERR_TOO_MANY;
  if (!gmds_resize(&map->memory, &records, map->records_capacity, capacity, (size_t)map->stride * sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  map->records = records;
  map->records_capacity = capacity;
  return gmds_cells_resize(&map->darts, capacity);
}

static gmds_status resize_cells(gmds_map *map, int i, size_t capacity)
{
  void *darts = map->anchor[i], *points = map->points;
  if (capacity > map->cells[i].limit)
    return GMDS_ERR_TOO_MANY;
  if (!gmds_resize(&map->memory, &darts, map->anchor_capacity[i], capacity, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  map->anchor[i] = darts;
  map->anchor_capacity[i] = capacity;
  if (i == 0) {
    if (!gmds_resize(&map->memory, &points, map->points_capacity, capacity, (size_t)map->coordinates * sizeof(double)))
      return GMDS_ERR_MEMORY;
    map->points = points;
    map->points_capacity = capacity;
  }
  return gmds_cells_resize(&map->cells[i], capacity);
}

gmds_status gmds_map_grow(gmds_map *map, int i, size_t more)
{
  const gmds_cells *cells = i < 0 ? &map->darts : &map->cells[i];
  const size_t needed = gmds_cells_needed(cells, more);
  if (needed == cells->capacity)
    return GMDS_OK;
  return i < 0 ? resize_darts(map, needed) : resize_cells(map, i, needed);
}

gmds_status gmds_map_reserve(gmds_map *map, size_t darts, const size_t cells[GMDS_MAP_KEPT])
{
  if (darts > map->darts.capacity)
    GMDS_TRY(resize_darts(map, darts));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i] && cells[i] > map->cells[i].capacity)
      GMDS_TRY(resize_cells(map, i, cells[i]));
  return GMDS_OK;
}

gmds_status gmds_map_trim(gmds_map *map)
{
  gmds_ids_clear(&map->scratch);
  GMDS_TRY(resize_darts(map, map->darts.end));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i])
      GMDS_TRY(resize_cells(map, i, map->cells[i].end));
  return GMDS_OK;
}

gmds_id gmds_map_take_dart(gmds_map *map)
{
  const gmds_id d = gmds_cells_take(&map->darts);
  gmds_id *record = gmds_map_record(map, d);
  for (int k = 0; k < map->stride; k++)
    record[k] = GMDS_NONE;
  return d;
}

gmds_status gmds_map_add_dart(gmds_map *map, gmds_id *d)
{
  edit e;
  gmds_id made = GMDS_NONE;
  edit_begin(&e, map);
  gmds_status status = edit_end(&e, edit_make(&e, &made));
  if (status == GMDS_OK)
    *d = made;
  return status;
}

gmds_status gmds_map_remove_dart(gmds_map *map, gmds_id d)
{
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  for (int i = 0; i <= map->n; i++)
    if (gmds_map_beta(map, i, d) != GMDS_NONE)
      return GMDS_ERR_CONFLICT;
  edit e;
  edit_begin(&e, map);
  return edit_end(&e, edit_drop(&e, d));
}

gmds_status gmds_map_add_node(gmds_map *map, const double *x, gmds_id *id)
{
  GMDS_TRY(gmds_map_grow(map, 0, 1));
  const gmds_id v = gmds_cells_take(&map->cells[0]);
  const size_t dim = (size_t)map->coordinates;
  map->anchor[0][v] = GMDS_NONE;
  if (x)
    memcpy(map->points + dim * v, x, dim * sizeof *x);
  else
    memset(map->points + dim * v, 0, dim * sizeof *x);
  *id = v;
  return GMDS_OK;
}

gmds_status gmds_map_add_nodes(gmds_map *map, size_t n, const double *x, gmds_id *first)
{
  const size_t end = map->cells[0].end, dim = (size_t)map->coordinates;
  if (n > map->cells[0].limit || end > map->cells[0].limit - n)
    return GMDS_ERR_TOO_MANY;
  if (end + n > map->cells[0].capacity)
    GMDS_TRY(resize_cells(map, 0, end + n));
  *first = gmds_cells_take_many(&map->cells[0], n);
  for (size_t v = end; v < end + n; v++)
    map->anchor[0][v] = GMDS_NONE;
  if (x && n)
    memcpy(map->points + dim * end, x, dim * n * sizeof *x);
  return GMDS_OK;
}

void gmds_map_remove_attribute(gmds_map *map, int i, gmds_attribute *attribute)
{
  size_t k = 0;
  while (k < map->n_rules && map->rules[k].attribute != attribute)
    k++;
  if (k < map->n_rules) {
    void *rules = map->rules;
    map->rules[k] = map->rules[map->n_rules - 1];
    (void)gmds_resize(&map->memory, &rules, map->n_rules, map->n_rules - 1, sizeof *map->rules); /* fewer bytes */
    map->rules = rules;
    map->n_rules--;
  }
  gmds_attribute_remove(&map->cells[i], attribute);
}

gmds_status gmds_map_set_rule(gmds_map *map, int i, const gmds_attribute *attribute, gmds_merge merge, gmds_split split,
                              void *user)
{
  size_t k = 0;
  if (i < 0 || i >= GMDS_MAP_KEPT || !map->slot[i])
    return GMDS_ERR_ARGUMENT;
  while (k < map->n_rules && (map->rules[k].attribute != attribute || map->rules[k].cell != i))
    k++;
  if (k == map->n_rules) {
    void *rules = map->rules;
    if (!gmds_resize(&map->memory, &rules, map->n_rules, map->n_rules + 1, sizeof *map->rules))
      return GMDS_ERR_MEMORY;
    map->rules = rules;
    map->n_rules++;
  }
  map->rules[k] = (gmds_map_rule){i, attribute, merge, split, user};
  return GMDS_OK;
}

/* Writes the new numbers of i-cells into all darts, and moves what is beside the cells; map[c] is not above c or all
 * are permuted into `fresh` columns by the caller. */
static void rename_in_darts(gmds_map *map, int i, const gmds_id *number)
{
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    gmds_id *cell = gmds_map_record(map, d) + map->slot[i];
    if (*cell != GMDS_NONE)
      *cell = number[*cell];
  }
}

/* Moves i-cells into holes. */
static void close_cells(gmds_map *map, int i, const gmds_id *number)
{
  gmds_cells *cells = &map->cells[i];
  const size_t dim = (size_t)map->coordinates;
  rename_in_darts(map, i, number);
  for (gmds_id c = gmds_cells_next(cells, (gmds_id)cells->count); c != GMDS_NONE; c = gmds_cells_next(cells, c + 1)) {
    map->anchor[i][number[c]] = map->anchor[i][c];
    if (i == 0)
      memcpy(map->points + dim * number[c], map->points + dim * c, dim * sizeof *map->points);
  }
  gmds_cells_renumber(cells, number);
}

static void close_darts(gmds_map *map, const gmds_id *number)
{
  const size_t count = map->darts.count;
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    gmds_id *from = gmds_map_record(map, d), *to = gmds_map_record(map, number[d]);
    for (int i = 0; i <= map->n; i++)
      to[i] = from[i] == GMDS_NONE ? GMDS_NONE : number[from[i]];
    for (int k = map->n + 1; k < map->stride; k++)
      to[k] = from[k];
  }
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    for (gmds_id c = gmds_cells_next(&map->cells[i], 0); c != GMDS_NONE && map->slot[i];
         c = gmds_cells_next(&map->cells[i], c + 1))
      if (map->anchor[i][c] >= count && map->anchor[i][c] != GMDS_NONE)
        map->anchor[i][c] = number[map->anchor[i][c]];
  gmds_cells_renumber(&map->darts, number);
}

gmds_status gmds_map_compact(gmds_map *map, gmds_id *const maps[GMDS_MAP_KEPT], gmds_id *dart_map)
{
  void *plan[GMDS_MAP_KEPT + 1] = {NULL};
  size_t end[GMDS_MAP_KEPT + 1] = {0};
  gmds_status status = GMDS_OK;
  for (int i = 0; i <= GMDS_MAP_KEPT && status == GMDS_OK; i++) {
    const gmds_cells *cells = i < GMDS_MAP_KEPT ? &map->cells[i] : &map->darts;
    end[i] = cells->end;
    if (cells->count == cells->end)
      continue;
    if (!gmds_resize(&map->memory, &plan[i], 0, end[i], sizeof(gmds_id)))
      status = GMDS_ERR_MEMORY;
    else
      gmds_cells_plan(cells, plan[i]);
  }
  for (int i = 0; i <= GMDS_MAP_KEPT && status == GMDS_OK; i++) {
    gmds_id *to = i == GMDS_MAP_KEPT ? dart_map : maps ? maps[i] : NULL;
    if (to)
      gmds_cells_plan(i < GMDS_MAP_KEPT ? &map->cells[i] : &map->darts, to);
  }
  for (int i = 0; i < GMDS_MAP_KEPT && status == GMDS_OK; i++)
    if (plan[i])
      close_cells(map, i, plan[i]);
  if (status == GMDS_OK && plan[GMDS_MAP_KEPT])
    close_darts(map, plan[GMDS_MAP_KEPT]);
  for (int i = 0; i <= GMDS_MAP_KEPT; i++)
    gmds_release(&map->memory, plan[i], plan[i] ? end[i] : 0, sizeof(gmds_id));
  return status;
}

/* Fills an empty map of the same kind with cells under other numbers, beside the same darts. */
static gmds_status copy_permuted(const gmds_map *from, gmds_id *const maps[GMDS_MAP_KEPT], gmds_map *to)
{
  const size_t dim = (size_t)from->coordinates;
  GMDS_TRY(gmds_cells_copy(&from->darts, &to->darts));
  GMDS_TRY(resize_darts(to, to->darts.capacity));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (from->slot[i]) {
      GMDS_TRY(gmds_cells_copy_as(&from->cells[i], maps[i], &to->cells[i]));
      GMDS_TRY(resize_cells(to, i, to->cells[i].capacity));
      for (gmds_id c = gmds_cells_next(&from->cells[i], 0); c != GMDS_NONE;
           c = gmds_cells_next(&from->cells[i], c + 1)) {
        to->anchor[i][maps[i][c]] = from->anchor[i][c];
        if (i == 0)
          memcpy(to->points + dim * maps[0][c], from->points + dim * c, dim * sizeof(double));
      }
    }
  if (from->darts.end)
    memcpy(to->records, from->records, from->darts.end * (size_t)from->stride * sizeof(gmds_id));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (to->slot[i])
      rename_in_darts(to, i, maps[i]);
  return GMDS_OK;
}

void gmds_map_become(gmds_map *map, gmds_map *other)
{
  gmds_ids_clear(&other->scratch);
  const gmds_memory had = map->memory;
  gmds_map_rule *rules = map->rules;
  const size_t n_rules = map->n_rules;
  map->rules = NULL;
  map->n_rules = 0;
  const size_t live = had.live, peak = live + other->memory.peak;
  gmds_map_clear(map);
  const size_t rule_bytes = map->memory.live; /* what the rules take */
  *map = *other;
  map->memory.limit = had.limit;
  map->memory.live += rule_bytes;
  map->memory.peak = peak > had.peak ? peak : had.peak;
  map->rules = rules;
  map->n_rules = n_rules;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    map->cells[i].alive.memory = &map->memory;
  map->darts.alive.memory = &map->memory;
  gmds_ids_init(&map->scratch, &map->memory);
}

/* Points the rules at the columns of the same names in another map. */
static void carry_rules(gmds_map *map, const gmds_map *other)
{
  for (size_t k = 0; k < map->n_rules; k++)
    map->rules[k].attribute = gmds_attribute_find(&other->cells[map->rules[k].cell], map->rules[k].attribute->name);
}

gmds_status gmds_map_permute(gmds_map *map, gmds_id *const maps[GMDS_MAP_KEPT])
{
  gmds_map other;
  unsigned kept = 0;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    kept |= map->slot[i] ? 1u << i : 0;
  gmds_map_init(&other, map->n, map->coordinates, kept, &map->memory.allocator);
  other.memory.limit = map->memory.limit - map->memory.live;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    other.cells[i].limit = map->cells[i].limit;
  other.darts.limit = map->darts.limit;
  gmds_status status = copy_permuted(map, maps, &other);
  if (status != GMDS_OK) {
    gmds_map_clear(&other);
    return status;
  }
  carry_rules(map, &other);
  gmds_map_become(map, &other);
  return GMDS_OK;
}
