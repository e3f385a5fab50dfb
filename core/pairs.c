/* Rows of two entries as a rule, and the few that are longer. */
#include <gmds/pairs.h>
#include <string.h>

void gmds_pairs_init(gmds_pairs *pairs)
{
  *pairs = (gmds_pairs){.free = GMDS_NONE};
  gmds_rows_init(&pairs->more, 0);
}

void gmds_pairs_clear(gmds_pairs *pairs, gmds_memory *memory)
{
  gmds_column_clear(&pairs->entries, memory);
  gmds_column_clear(&pairs->owner, memory);
  gmds_rows_clear(&pairs->more, memory);
  gmds_pairs_init(pairs);
}

gmds_status gmds_pairs_resize(gmds_pairs *pairs, gmds_memory *memory, size_t n)
{
  size_t had = pairs->entries.capacity;
  if (n > SIZE_MAX / 2)
    return GMDS_ERR_MEMORY;
  GMDS_TRY(gmds_column_resize(&pairs->entries, memory, 2 * n));
  for (size_t k = had; k < 2 * n; k++)
    pairs->entries.data[k] = GMDS_NONE;
  return GMDS_OK;
}

/* A long row that is not in use, with room for n entries. On failure none is taken. */
static gmds_status take_long(gmds_pairs *pairs, gmds_memory *memory, size_t n, gmds_id *number)
{
  gmds_id taken = pairs->free != GMDS_NONE ? pairs->free : pairs->n_more;
  if (taken == pairs->more.n_rows) {
    size_t grown = gmds_grown(taken, (size_t)taken + 1);
    GMDS_TRY(gmds_rows_resize(&pairs->more, memory, grown));
  }
  if (pairs->owner.capacity < pairs->more.n_rows)
    GMDS_TRY(gmds_column_resize(&pairs->owner, memory, pairs->more.n_rows));
  GMDS_TRY(gmds_rows_reserve(&pairs->more, memory, taken, n));
  if (taken == pairs->free)
    pairs->free = pairs->owner.data[taken];
  else
    pairs->n_more++;
  *number = taken;
  return GMDS_OK;
}

static void free_long(gmds_pairs *pairs, gmds_id number)
{
  gmds_rows_release(&pairs->more, number);
  pairs->owner.data[number] = pairs->free;
  pairs->free = number;
}

gmds_status gmds_pairs_reserve_long(gmds_pairs *pairs, gmds_memory *memory, size_t r, size_t n)
{
  gmds_id *row = pairs->entries.data + 2 * r, number = 0;
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    return gmds_rows_reserve(&pairs->more, memory, row[1], n);
  GMDS_TRY(take_long(pairs, memory, n, &number));
  for (int k = 0; k < 2; k++)
    if (row[k] != GMDS_NONE)
      gmds_rows_push(&pairs->more, number, row[k]);
  pairs->owner.data[number] = (gmds_id)r;
  row[0] = GMDS_NONE;
  row[1] = number;
  return GMDS_OK;
}

void gmds_pairs_empty_long(gmds_pairs *pairs, size_t r)
{
  free_long(pairs, pairs->entries.data[2 * r + 1]);
}

/* Whether a long row is in use: a free one has no block. */
static int is_taken(const gmds_pairs *pairs, gmds_id number)
{
  return pairs->more.size[number] != 0;
}

gmds_status gmds_pairs_trim(gmds_pairs *pairs, gmds_memory *memory)
{
  gmds_id kept = 0;
  for (gmds_id number = 0; number < pairs->n_more; number++) {
    size_t n = 0;
    const gmds_id *entry = gmds_rows_get(&pairs->more, number, &n);
    if (!is_taken(pairs, number))
      continue;
    gmds_id *row = pairs->entries.data + 2 * (size_t)pairs->owner.data[number];
    if (n > 2) { /* stays long, under the next number */
      row[1] = kept;
      pairs->owner.data[kept] = pairs->owner.data[number];
      gmds_rows_move(&pairs->more, number, kept++);
    } else {
      for (size_t k = 0; k < 2; k++)
        row[k] = k < n ? entry[k] : GMDS_NONE;
      gmds_rows_release(&pairs->more, number);
    }
  }
  pairs->n_more = kept;
  pairs->free = GMDS_NONE;
  GMDS_TRY(gmds_rows_resize(&pairs->more, memory, kept));
  GMDS_TRY(gmds_column_resize(&pairs->owner, memory, kept));
  return gmds_rows_trim(&pairs->more, memory);
}

static gmds_status fill(gmds_pairs *pairs, gmds_memory *memory, size_t n_rows, const size_t *begin, size_t end,
                        const gmds_id *data)
{
  GMDS_TRY(gmds_pairs_resize(pairs, memory, n_rows));
  for (size_t r = 0; r < end; r++) {
    size_t n = begin[r + 1] - begin[r];
    if (n > 2)
      GMDS_TRY(gmds_pairs_reserve_long(pairs, memory, r, n));
    for (size_t k = 0; k < n; k++)
      gmds_pairs_push(pairs, r, data[begin[r] + k]);
  }
  return pairs->n_more ? gmds_pairs_trim(pairs, memory) : GMDS_OK;
}

gmds_status gmds_pairs_fill(gmds_pairs *pairs, gmds_memory *memory, size_t n_rows, const size_t *begin, size_t end,
                            const gmds_id *data)
{
  gmds_status status = fill(pairs, memory, n_rows, begin, end, data);
  if (status != GMDS_OK)
    gmds_pairs_clear(pairs, memory);
  return status;
}

void gmds_pairs_renumber(gmds_pairs *pairs, size_t end, const gmds_id *row_map, const gmds_id *entry_map)
{
  for (size_t r = 0; r < end; r++) {
    size_t to = row_map ? row_map[r] : r;
    if (to == GMDS_NONE)
      continue;
    gmds_id *from = pairs->entries.data + 2 * r, *row = pairs->entries.data + 2 * to;
    if (to != r) { /* the row at `to` was moved or is empty */
      memcpy(row, from, 2 * sizeof *row);
      from[0] = from[1] = GMDS_NONE;
    }
    if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
      pairs->owner.data[row[1]] = (gmds_id)to;
    else
      for (int k = 0; entry_map && k < 2; k++)
        row[k] = row[k] == GMDS_NONE ? row[k] : entry_map[row[k]];
  }
  gmds_rows_renumber(&pairs->more, pairs->n_more, NULL, entry_map);
}
