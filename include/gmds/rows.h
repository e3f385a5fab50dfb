/* Rows: relations of variable arity (N2F, polygons) in one pool.
 *
 * Each row is a block of the pool; freed blocks are kept by capacity and used again. A long row of a set (a node with
 * more than GMDS_ROWS_LONG neighbours: the node that stands for infinity in a triangulation has as many as the hull)
 * carries a hash of positions behind its entries, so that finding and removing an entry takes constant time however
 * long the row is. An ordered row keeps its entries in place and may hold GMDS_NONE.
 *
 * Cost: 9 bytes a row (17 with 64-bit identifiers) and its capacity; after gmds_rows_trim the capacity of a row that is
 * not long is its length. */
#ifndef GMDS_ROWS_H
#define GMDS_ROWS_H

#include <gmds/bits.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GMDS_ROWS_LONG 64
#define GMDS_ROWS_CLASSES (GMDS_ROWS_LONG + 1 + 8 * (int)sizeof(gmds_id))

typedef struct gmds_rows {
  gmds_id *pool;
  size_t pool_used, pool_capacity;
  gmds_id *start;  /* where a row's block begins in the pool */
  gmds_id *length; /* entries of a row */
  uint8_t *size;   /* capacity: the number itself up to GMDS_ROWS_LONG, doublings beyond */
  size_t n_rows;
  int ordered;                     /* entries have positions: no hash, no removal of single entries */
  gmds_id free[GMDS_ROWS_CLASSES]; /* the first free block of each capacity; blocks are linked through their entries */
} gmds_rows;

/* A column of identifiers: a relation of fixed arity, inline. */
typedef struct gmds_column {
  gmds_id *data;
  size_t capacity; /* in identifiers */
} gmds_column;

/* Exactly n identifiers (new ones are not set). GMDS_OK or GMDS_ERR_MEMORY (unchanged). */
gmds_status gmds_column_resize(gmds_column *column, gmds_memory *memory, size_t n);
void gmds_column_clear(gmds_column *column, gmds_memory *memory);

/* No rows. Allocates nothing. */
void gmds_rows_init(gmds_rows *rows, int ordered);
void gmds_rows_clear(gmds_rows *rows, gmds_memory *memory);

/* Exactly n rows, new ones empty (rows that go must be empty). GMDS_OK or GMDS_ERR_MEMORY (unchanged). */
gmds_status gmds_rows_resize(gmds_rows *rows, gmds_memory *memory, size_t n);

/* Whether a row carries a hash of positions. */
static inline int gmds_rows_is_hashed(const gmds_rows *rows, size_t r)
{
  return rows->size[r] > GMDS_ROWS_LONG && !rows->ordered;
}

/* Makes sure that row r can grow to n entries without allocating. Its entries stay, their address may change.
 * GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (the entries are unchanged). Amortised O(entries). */
gmds_status gmds_rows_grow(gmds_rows *rows, gmds_memory *memory, size_t r, size_t n);
static inline gmds_status gmds_rows_reserve(gmds_rows *rows, gmds_memory *memory, size_t r, size_t n)
{
  unsigned size = rows->size[r]; /* of a long row, less than it holds */
  return n <= size ? GMDS_OK : gmds_rows_grow(rows, memory, r, n);
}

/* The entries of row r, valid until a row is reserved. */
static inline gmds_id *gmds_rows_get(const gmds_rows *rows, size_t r, size_t *n)
{
  *n = rows->length[r];
  return *n ? rows->pool + rows->start[r] : NULL;
}

/* The position of x in row r, or GMDS_NONE. */
gmds_id gmds_rows_find_hashed(const gmds_rows *rows, size_t r, gmds_id x);
static inline gmds_id gmds_rows_find(const gmds_rows *rows, size_t r, gmds_id x)
{
  if (gmds_rows_is_hashed(rows, r))
    return gmds_rows_find_hashed(rows, r, x);
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(rows, r, &n);
  for (size_t k = 0; k < n; k++)
    if (row[k] == x)
      return (gmds_id)k;
  return GMDS_NONE;
}

/* The changes of a row that cannot fail. Constant time each, up to GMDS_ROWS_LONG comparisons in a short row. Those of
 * short rows are short enough to stand where they are called. */
void gmds_rows_enter(gmds_rows *rows, size_t r, gmds_id position);      /* into the hash */
static inline void gmds_rows_push(gmds_rows *rows, size_t r, gmds_id x) /* room was reserved */
{
  gmds_id n = rows->length[r]++;
  rows->pool[rows->start[r] + n] = x;
  if (gmds_rows_is_hashed(rows, r))
    gmds_rows_enter(rows, r, n);
}

/* The last entry takes the place of x. */
void gmds_rows_remove_hashed(gmds_rows *rows, size_t r, gmds_id x);
static inline void gmds_rows_remove(gmds_rows *rows, size_t r, gmds_id x)
{
  if (gmds_rows_is_hashed(rows, r)) {
    gmds_rows_remove_hashed(rows, r, x);
    return;
  }
  size_t n = 0;
  gmds_id *row = gmds_rows_get(rows, r, &n);
  size_t at = n;
  for (size_t k = 0; k < n; k++) /* to the end: a row is short, and where x stands cannot be predicted */
    at = row[k] == x ? k : at;
  if (at == n)
    return;
  row[at] = row[n - 1];
  rows->length[r]--;
}

/* The first x becomes y. */
void gmds_rows_replace_hashed(gmds_rows *rows, size_t r, gmds_id x, gmds_id y);
static inline void gmds_rows_replace(gmds_rows *rows, size_t r, gmds_id x, gmds_id y)
{
  if (gmds_rows_is_hashed(rows, r)) {
    gmds_rows_replace_hashed(rows, r, x, y);
    return;
  }
  gmds_id at = gmds_rows_find(rows, r, x);
  if (at != GMDS_NONE)
    rows->pool[rows->start[r] + at] = y;
}

void gmds_rows_empty(gmds_rows *rows, size_t r);              /* keeps its block */
void gmds_rows_release(gmds_rows *rows, size_t r);            /* empties it and frees its block */
void gmds_rows_move(gmds_rows *rows, size_t from, size_t to); /* row `to` has no block, `from` has none any more */

/* Appends to `list` the cells that occur in at least `times` (1 or more) of the rows list[first] to list[last - 1],
 * once each: Keep_times o Adj, for rows that are sets. The longest times - 1 rows (at most three) are looked up
 * in, never listed. GMDS_OK or GMDS_ERR_MEMORY (what was appended is cut off again). O(total length of the other rows),
 * each entry looked up in all. */
gmds_status gmds_rows_meet(const gmds_rows *rows, size_t first, size_t last, size_t times, gmds_ids *list);

/* Packs the pool in the order of the rows, nothing spare. GMDS_OK or GMDS_ERR_MEMORY (unchanged). O(everything). */
gmds_status gmds_rows_trim(gmds_rows *rows, gmds_memory *memory);

/* Fills rows that are empty: n_rows of them, row r < end with the entries (*data)[begin[r]] to (*data)[begin[r + 1] -
 * 1], nothing spare. *data, `capacity` entries from `memory`, becomes the pool and *data NULL where that can be; else
 * it is copied and stays the caller's. GMDS_OK; GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (unchanged). O(rows and
 * entries). */
gmds_status gmds_rows_adopt(gmds_rows *rows, gmds_memory *memory, size_t n_rows, const size_t *begin, size_t end,
                            gmds_id **data, size_t capacity);

/* Renumbers rows and entries: row r becomes row_map[r] (at most r, GMDS_NONE: it is gone and empty), entry x becomes
 * entry_map[x]; a map that is NULL leaves its numbers. `coded`: an entry is 4 times an identifier and two bits more. */
void gmds_rows_renumber(gmds_rows *rows, size_t end, const gmds_id *row_map, const gmds_id *entry_map);
void gmds_column_renumber(gmds_column *column, size_t arity, const gmds_bits *alive, size_t end, const gmds_id *row_map,
                          const gmds_id *entry_map, int coded);

#ifdef __cplusplus
}
#endif
#endif
