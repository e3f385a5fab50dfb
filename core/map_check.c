/* The check of a combinatorial map: axioms of an n-map, then the cells of darts against their orbits. */
#include "map_inside.h"
#include <stdio.h>

static const char *const rule_text[] = {
#define TEXT(name, text) text,
    GMDS_MAP_RULE_LIST(TEXT)
#undef TEXT
};

/* Fills report and error; the value is GMDS_ERR_INVARIANT. */
static gmds_status violated(gmds_map_report found, gmds_map_report *report, gmds_error *error)
{
  char expected[32] = "none", is[32] = "none";
  if (report)
    *report = found;
  if (found.expected != GMDS_NONE)
    snprintf(expected, sizeof expected, "%llu", (unsigned long long)found.expected);
  if (found.found != GMDS_NONE)
    snprintf(is, sizeof is, "%llu", (unsigned long long)found.found);
  const int of_cell = found.rule == GMDS_MAP_NO_DART || found.rule == GMDS_MAP_WRONG_DART;
  if (of_cell)
    return gmds_fail(error, GMDS_ERR_INVARIANT, "%d-cell %llu: %s: expected %s, found %s", found.i,
                     (unsigned long long)found.dart, rule_text[found.rule], expected, is);
  const int of_betas = found.rule <= GMDS_MAP_NO_MAP;
  return gmds_fail(error, GMDS_ERR_INVARIANT, "dart %llu, %s %d: %s: expected %s, found %s",
                   (unsigned long long)found.dart, of_betas ? "beta" : "cell of dimension", found.i,
                   rule_text[found.rule], expected, is);
}

/* The axioms at one dart. */
static gmds_map_report look_at_links(const gmds_map *map, gmds_id d)
{
  const gmds_id *beta = gmds_map_record(map, d);
  for (int i = 0; i <= map->n; i++) {
    const gmds_id e = beta[i];
    if (e == GMDS_NONE)
      continue;
    if (!gmds_map_has(map, e))
      return (gmds_map_report){GMDS_MAP_LINK_TO_NONE, i, -1, d, GMDS_NONE, e};
    const gmds_id back = gmds_map_beta(map, i < 2 ? 1 - i : i, e);
    if (back != d)
      return (gmds_map_report){i < 2 ? GMDS_MAP_NO_INVERSE : GMDS_MAP_NO_INVOLUTION, i, -1, d, d, back};
    if (i > 1 && e == d)
      return (gmds_map_report){GMDS_MAP_FIXED_POINT, i, -1, d, GMDS_NONE, d};
  }
  return (gmds_map_report){.rule = GMDS_MAP_SOUND};
}

/* beta_j(beta_i(d)) undone by the same: where both links are there, beta_i(beta_j(beta_i(d))) leads to beta_j(d). */
static gmds_map_report look_at_squares(const gmds_map *map, gmds_id d)
{
  for (int i = 1; i + 2 <= map->n; i++)
    for (int j = i + 2; j <= map->n; j++) {
      const gmds_id a = gmds_map_beta(map, i, d), b = gmds_map_beta(map, j, d);
      if (a == GMDS_NONE)
        continue;
      const gmds_id beyond = gmds_map_beta(map, j, a);
      if (b == GMDS_NONE && beyond == GMDS_NONE)
        continue;
      const gmds_id back = gmds_map_next(map, i, beyond);
      if (back != b || b == GMDS_NONE)
        return (gmds_map_report){GMDS_MAP_NO_MAP, i, j, d, b, back};
    }
  return (gmds_map_report){.rule = GMDS_MAP_SOUND};
}

/* The i-cells: `seen` is of darts, `met` of cells. */
static gmds_status look_at_cells(const gmds_map *map, int i, gmds_bits *seen, gmds_bits *met, gmds_ids *orbit,
                                 gmds_map_report *report)
{
  const unsigned betas = gmds_map_cell_betas(map, i);
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    if (gmds_bits_get(seen, d))
      continue;
    const gmds_id c = gmds_map_cell(map, i, d);
    if (!gmds_cells_has(&map->cells[i], c)) {
      *report = (gmds_map_report){GMDS_MAP_DEAD_CELL, i, -1, d, GMDS_NONE, c};
      return GMDS_OK;
    }
    if (gmds_bits_get(met, c)) {
      *report = (gmds_map_report){GMDS_MAP_TWO_ORBITS, i, -1, d, GMDS_NONE, c};
      return GMDS_OK;
    }
    gmds_bits_set(met, c);
    int has_dart = 0;
    GMDS_TRY(gmds_map_orbit(map, d, betas, orbit));
    for (size_t k = 0; k < orbit->n; k++) {
      const gmds_id e = orbit->data[k];
      gmds_bits_set(seen, e);
      has_dart |= e == map->anchor[i][c];
      if (gmds_map_cell(map, i, e) != c) {
        *report = (gmds_map_report){GMDS_MAP_TWO_CELLS, i, -1, e, c, gmds_map_cell(map, i, e)};
        return GMDS_OK;
      }
    }
    if (!has_dart) {
      *report = (gmds_map_report){GMDS_MAP_WRONG_DART, i, -1, c, d, map->anchor[i][c]};
      return GMDS_OK;
    }
  }
  for (gmds_id c = gmds_cells_next(&map->cells[i], 0); c != GMDS_NONE; c = gmds_cells_next(&map->cells[i], c + 1))
    if (!gmds_bits_get(met, c) && (i || map->anchor[0][c] != GMDS_NONE)) {
      *report = (gmds_map_report){GMDS_MAP_NO_DART, i, -1, c, GMDS_NONE, map->anchor[i][c]};
      return GMDS_OK;
    }
  return GMDS_OK;
}

static gmds_status look_at_all_cells(const gmds_map *map, gmds_memory *memory, gmds_map_report *report)
{
  gmds_ids orbit = {.memory = memory};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < GMDS_MAP_KEPT && status == GMDS_OK && report->rule == GMDS_MAP_SOUND; i++) {
    gmds_bits seen, met = {.memory = memory};
    if (!map->slot[i])
      continue;
    status = gmds_bits_init(&seen, memory, map->darts.end);
    if (status == GMDS_OK)
      status = gmds_bits_init(&met, memory, map->cells[i].end);
    if (status == GMDS_OK)
      status = look_at_cells(map, i, &seen, &met, &orbit, report);
    gmds_bits_clear(&seen);
    gmds_bits_clear(&met);
  }
  gmds_ids_clear(&orbit);
  return status;
}

gmds_status gmds_map_check(const gmds_map *map, gmds_memory *memory, gmds_map_report *report, gmds_error *error)
{
  gmds_map_report found = {.rule = GMDS_MAP_SOUND, .i = -1, .j = -1};
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    found = look_at_links(map, d);
    if (found.rule != GMDS_MAP_SOUND)
      return violated(found, report, error);
  }
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    found = look_at_squares(map, d);
    if (found.rule != GMDS_MAP_SOUND)
      return violated(found, report, error);
  }
  gmds_status status = look_at_all_cells(map, memory, &found);
  if (status != GMDS_OK)
    return gmds_fail(error, status, "out of memory while checking a map of %zu darts", map->darts.count);
  if (found.rule != GMDS_MAP_SOUND)
    return violated(found, report, error);
  if (report)
    *report = (gmds_map_report){.rule = GMDS_MAP_SOUND, .i = -1, .j = -1, .dart = GMDS_NONE};
  return GMDS_OK;
}
