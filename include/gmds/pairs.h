/* Pairs: rows that hold two entries as a rule (E2F: an edge bounds two faces, one at the border), inline. A row that
 * grows beyond two, an edge that is not manifold, moves to a row of variable length (rows.h), so nothing limits it.
 *
 * Cost: two identifiers a row. A row of more than two entries also takes what a row of rows.h takes, and an
 * identifier. */
#ifndef GMDS_PAIRS_H
#define GMDS_PAIRS_H

#include <gmds/rows.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct gmds_pairs {
  gmds_column entries; /* two a row: the entries and then GMDS_NONE; or GMDS_NONE and the number of a long row */
  gmds_rows more;      /* the long rows */
  gmds_column owner;   /* of a long row the row that it belongs to, of a free one the next free one */
  gmds_id n_more;      /* long rows that have been in use; `more` may have room for others */
  gmds_id free;        /* the first free long row below n_more, or GMDS_NONE */
} gmds_pairs;

/* No rows. Allocates nothing. */
void gmds_pairs_init(gmds_pairs *pairs);
void gmds_pairs_clear(gmds_pairs *pairs, gmds_memory *memory);

/* Exactly n rows, new ones empty (rows that go must be empty). GMDS_OK or GMDS_ERR_MEMORY (unchanged). */
gmds_status gmds_pairs_resize(gmds_pairs *pairs, gmds_memory *memory, size_t n);

/* The entries of row r, valid until a row changes. */
static inline gmds_id *gmds_pairs_get(const gmds_pairs *pairs, size_t r, size_t *n)
{
  gmds_id *row = pairs->entries.data + 2 * r;
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    return gmds_rows_get(&pairs->more, row[1], n);
  *n = (size_t)(row[0] != GMDS_NONE) + (row[1] != GMDS_NONE);
  return *n ? row : NULL;
}

/* Makes sure that row r can grow to n entries without allocating: it moves to a long row when n is more than two.
 * GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (the entries are unchanged). */
gmds_status gmds_pairs_reserve_long(gmds_pairs *pairs, gmds_memory *memory, size_t r, size_t n);
static inline gmds_status gmds_pairs_reserve(gmds_pairs *pairs, gmds_memory *memory, size_t r, size_t n)
{
  return n <= 2 ? GMDS_OK : gmds_pairs_reserve_long(pairs, memory, r, n);
}

/* The changes of a row that cannot fail. Constant time where a row is not long, else as rows.h. */
static inline void gmds_pairs_push(gmds_pairs *pairs, size_t r, gmds_id x) /* room was reserved */
{
  gmds_id *row = pairs->entries.data + 2 * r;
  if (row[0] != GMDS_NONE)
    row[1] = x;
  else if (row[1] == GMDS_NONE)
    row[0] = x;
  else
    gmds_rows_push(&pairs->more, row[1], x);
}

/* The first x becomes y. */
static inline void gmds_pairs_replace(gmds_pairs *pairs, size_t r, gmds_id x, gmds_id y)
{
  gmds_id *row = pairs->entries.data + 2 * r;
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    gmds_rows_replace(&pairs->more, row[1], x, y);
  else if (row[0] == x)
    row[0] = y;
  else if (row[1] == x)
    row[1] = y;
}

/* The last entry takes the place of x. */
static inline void gmds_pairs_remove(gmds_pairs *pairs, size_t r, gmds_id x)
{
  gmds_id *row = pairs->entries.data + 2 * r;
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    gmds_rows_remove(&pairs->more, row[1], x);
  else if (row[0] == x) {
    row[0] = row[1];
    row[1] = GMDS_NONE;
  } else if (row[1] == x)
    row[1] = GMDS_NONE;
}

/* Empties a row; a long one is freed. */
void gmds_pairs_empty_long(gmds_pairs *pairs, size_t r);
static inline void gmds_pairs_empty(gmds_pairs *pairs, size_t r)
{
  gmds_id *row = pairs->entries.data + 2 * r;
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    gmds_pairs_empty_long(pairs, r);
  row[0] = row[1] = GMDS_NONE;
}

/* Moves row `from` to row `to`, which is empty. */
static inline void gmds_pairs_move(gmds_pairs *pairs, size_t from, size_t to)
{
  gmds_id *row = pairs->entries.data + 2 * from, *target = pairs->entries.data + 2 * to;
  target[0] = row[0];
  target[1] = row[1];
  if (row[0] == GMDS_NONE && row[1] != GMDS_NONE)
    pairs->owner.data[row[1]] = (gmds_id)to;
  row[0] = row[1] = GMDS_NONE;
}

/* Nothing spare: long rows of two entries or fewer become inline again. GMDS_OK or GMDS_ERR_MEMORY (valid, trimmed in
 * part). O(long rows). */
gmds_status gmds_pairs_trim(gmds_pairs *pairs, gmds_memory *memory);

/* Fills pairs that hold no row: n_rows of them, row r < end with the entries data[begin[r]] to data[begin[r + 1] - 1],
 * nothing spare. GMDS_OK; GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (they hold no row). O(rows and entries). */
gmds_status gmds_pairs_fill(gmds_pairs *pairs, gmds_memory *memory, size_t n_rows, const size_t *begin, size_t end,
                            const gmds_id *data);

/* Renumbers rows and entries as gmds_rows_renumber does. */
void gmds_pairs_renumber(gmds_pairs *pairs, size_t end, const gmds_id *row_map, const gmds_id *entry_map);

#ifdef __cplusplus
}
#endif
#endif
