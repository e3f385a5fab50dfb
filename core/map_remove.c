/* Removal and contraction of cells (Damiand and Lienhardt 2014, chapter 6): the cell's darts go, and a dart that was
 * linked with one of them is linked with what is found by passing through the cell. */
#include "map_inside.h"

/* A cell that goes. */
typedef struct removal {
  const gmds_map *map;
  int i;
  gmds_ids cell; /* its darts */
  id_table in;
  gmds_ids links; /* beta, dart, dart: three by three */
} removal;

static gmds_status removal_begin(removal *r, const gmds_map *map, int i, gmds_id d, gmds_memory *memory)
{
  *r = (removal){.map = map, .i = i};
  r->cell.memory = r->in.memory = r->links.memory = memory;
  GMDS_TRY(gmds_map_orbit(map, d, gmds_map_cell_betas(map, i), &r->cell));
  for (size_t k = 0; k < r->cell.n; k++)
    GMDS_TRY(id_table_put(&r->in, r->cell.data[k], 0));
  return GMDS_OK;
}

static void removal_clear(removal *r)
{
  gmds_ids_clear(&r->cell);
  gmds_ids_clear(&r->links);
  id_table_clear(&r->in);
}

static int is_in(const removal *r, gmds_id d)
{
  return d != GMDS_NONE && id_table_find(&r->in, d) != NULL;
}

static gmds_status note(removal *r, int i, gmds_id d, gmds_id e)
{
  if (e == GMDS_NONE || (i > 1 && d == e)) /* it becomes free */
    return GMDS_OK;
  GMDS_TRY(gmds_ids_push(&r->links, (gmds_id)i));
  GMDS_TRY(gmds_ids_push(&r->links, d));
  return gmds_ids_push(&r->links, e);
}

/* For dart b of the cell: what beta_i^-1(b), outside, is linked with instead; one passes through the cell by
 * beta_`through`. */
static gmds_status note_passage(removal *r, gmds_id b, int through)
{
  const gmds_map *map = r->map;
  const int i = r->i;
  const gmds_id d = gmds_map_beta(map, i == 1 ? 0 : i, b);
  if (d == GMDS_NONE || is_in(r, d))
    return GMDS_OK;
  gmds_id e = b;
  do
    e = gmds_map_next(map, i, through ? gmds_map_beta(map, through, e) : e);
  while (is_in(r, e));
  return note(r, i, d, e);
}

/* A node: for dart b that begins there, the dart before it goes on where b, or the last of those that begin there,
 * ended. */
static gmds_status note_node(removal *r, gmds_id b)
{
  const gmds_map *map = r->map;
  const gmds_id d = gmds_map_beta(map, 0, b);
  if (d == GMDS_NONE || is_in(r, d))
    return GMDS_OK;
  gmds_id last = b, e = gmds_map_beta(map, 1, b);
  while (is_in(r, e)) {
    last = e;
    e = gmds_map_beta(map, 1, e);
  }
  GMDS_TRY(note(r, 1, d, e));
  for (int j = 2; j <= map->n; j++) {
    const gmds_id beyond = gmds_map_beta(map, j, last);
    if (!is_in(r, beyond))
      GMDS_TRY(note(r, j, d, beyond));
  }
  return GMDS_OK;
}

/* Takes the cell out: its darts go, then the links are made. */
static gmds_status take_out(edit *e, const removal *r)
{
  for (size_t k = 0; k < r->cell.n; k++)
    GMDS_TRY(edit_drop(e, r->cell.data[k]));
  for (size_t k = 0; k < r->links.n; k += 3)
    GMDS_TRY(edit_join(e, (int)r->links.data[k], r->links.data[k + 1], r->links.data[k + 2]));
  return GMDS_OK;
}

gmds_status gmds_map_is_removable(const gmds_map *map, int i, gmds_id d, gmds_memory *memory, int *removable)
{
  gmds_ids cell = {.memory = memory};
  int can = 1;
  if (i < 0 || i >= map->n)
    return GMDS_ERR_ARGUMENT;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  gmds_status status = GMDS_OK;
  if (i < map->n - 1)
    status = gmds_map_orbit(map, d, gmds_map_cell_betas(map, i), &cell);
  for (size_t k = 0; k < cell.n && status == GMDS_OK; k++) {
    const gmds_id b = cell.data[k];
    const gmds_id one = gmds_map_next(map, i + 1, gmds_map_beta(map, i + 2, b));
    const gmds_id other = gmds_map_next(map, i + 2, gmds_map_beta(map, i ? i + 1 : 0, b));
    can &= one == other;
  }
  gmds_ids_clear(&cell);
  if (status == GMDS_OK)
    *removable = can;
  return status;
}

gmds_status gmds_map_is_contractible(const gmds_map *map, int i, gmds_id d, gmds_memory *memory, int *contractible)
{
  gmds_ids cell = {.memory = memory};
  int can = 1;
  if (i < 1 || i > map->n)
    return GMDS_ERR_ARGUMENT;
  if (!gmds_map_has(map, d))
    return GMDS_ERR_CELL;
  gmds_status status = GMDS_OK;
  if (i > 1)
    status = gmds_map_orbit(map, d, gmds_map_cell_betas(map, i), &cell);
  for (size_t k = 0; k < cell.n && status == GMDS_OK; k++) {
    const gmds_id b = cell.data[k];
    const gmds_id one = gmds_map_next(map, i - 1, gmds_map_beta(map, i - 2, b));
    const gmds_id other = gmds_map_next(map, i == 2 ? 1 : i == 3 ? 0 : i - 2, gmds_map_beta(map, i - 1, b));
    can &= one == other;
  }
  gmds_ids_clear(&cell);
  if (status == GMDS_OK)
    *contractible = can;
  return status;
}

static gmds_status finish(removal *r, gmds_map *map, gmds_status status)
{
  if (status == GMDS_OK) {
    edit e;
    edit_begin(&e, map);
    status = take_out(&e, r);
    if (status == GMDS_OK && !edit_is_sound(&e)) /* open faces around, whose images would be left without an end */
      status = GMDS_ERR_CONFLICT;
    status = edit_end(&e, status);
  }
  removal_clear(r);
  return status;
}

gmds_status gmds_map_remove_cell(gmds_map *map, int i, gmds_id d)
{
  int can = 0;
  GMDS_TRY(gmds_map_is_removable(map, i, d, &map->memory, &can));
  if (!can)
    return GMDS_ERR_CONFLICT;
  removal r;
  gmds_status status = removal_begin(&r, map, i, d, &map->memory);
  for (size_t k = 0; k < r.cell.n && status == GMDS_OK; k++)
    status = i ? note_passage(&r, r.cell.data[k], i + 1) : note_node(&r, r.cell.data[k]);
  return finish(&r, map, status);
}

gmds_status gmds_map_contract_cell(gmds_map *map, int i, gmds_id d)
{
  int can = 0;
  GMDS_TRY(gmds_map_is_contractible(map, i, d, &map->memory, &can));
  if (!can)
    return GMDS_ERR_CONFLICT;
  removal r;
  gmds_status status = removal_begin(&r, map, i, d, &map->memory);
  for (size_t k = 0; k < r.cell.n && status == GMDS_OK; k++)
    status = note_passage(&r, r.cell.data[k], i > 1 ? i - 1 : 0);
  return finish(&r, map, status);
}
