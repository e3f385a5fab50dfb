/* Rows of variable length in one pool. */
#include <gmds/rows.h>
#include <string.h>

/* What a capacity class holds, and how many entries of the pool its block takes: a long block of a set has a table of
 * twice as many positions behind it (half full at most, linear probing, position + 1, 0 for empty). */
static size_t entries_of(unsigned size)
{
  return size <= GMDS_ROWS_LONG ? size : (size_t)GMDS_ROWS_LONG << (size - GMDS_ROWS_LONG);
}

static size_t block_of(const gmds_rows *rows, unsigned size)
{
  size_t n = entries_of(size);
  return size > GMDS_ROWS_LONG && !rows->ordered ? 3 * n : n;
}

/* Capacities grow as 2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 128, ... */
static unsigned class_for(size_t n, int exact)
{
  static const unsigned char steps[] = {2, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  if (n <= GMDS_ROWS_LONG) {
    if (exact)
      return (unsigned)n;
    for (size_t k = 0;; k++)
      if (steps[k] >= n)
        return steps[k];
  }
  unsigned size = GMDS_ROWS_LONG + 1;
  while (entries_of(size) < n)
    size++;
  return size;
}

static size_t hash(gmds_id x, size_t mask)
{
  return (size_t)(((uint64_t)x * UINT64_C(0x9e3779b97f4a7c15)) >> 32) & mask;
}

/* The slot of the table that holds the position of x, or the empty slot where it would go. */
static gmds_id *slot_of(const gmds_rows *rows, size_t r, gmds_id x)
{
  gmds_id *row = rows->pool + rows->start[r];
  size_t n = entries_of(rows->size[r]), mask = 2 * n - 1;
  gmds_id *table = row + n;
  size_t k = hash(x, mask);
  while (table[k] && row[table[k] - 1] != x)
    k = (k + 1) & mask;
  return table + k;
}

void gmds_rows_enter(gmds_rows *rows, size_t r, gmds_id position)
{
  gmds_id *row = rows->pool + rows->start[r];
  size_t n = entries_of(rows->size[r]), mask = 2 * n - 1, k = hash(row[position], mask);
  while (row[n + k])
    k = (k + 1) & mask;
  row[n + k] = position + 1;
}

static void build_table(gmds_rows *rows, size_t r)
{
  gmds_id *row = rows->pool + rows->start[r];
  size_t n = entries_of(rows->size[r]);
  memset(row + n, 0, 2 * n * sizeof *row);
  for (gmds_id k = 0; k < rows->length[r]; k++)
    gmds_rows_enter(rows, r, k);
}

/* Empties a slot and closes the gap in its chain (Knuth 6.4, algorithm R). */
static void erase_slot(gmds_rows *rows, size_t r, const gmds_id *slot)
{
  gmds_id *row = rows->pool + rows->start[r];
  size_t n = entries_of(rows->size[r]), mask = 2 * n - 1;
  gmds_id *table = row + n;
  size_t hole = (size_t)(slot - table), k = hole;
  for (;;) {
    k = (k + 1) & mask;
    if (!table[k])
      break;
    size_t home = hash(row[table[k] - 1], mask);
    if (((k - home) & mask) >= ((k - hole) & mask)) {
      table[hole] = table[k];
      hole = k;
    }
  }
  table[hole] = 0;
}

void gmds_rows_init(gmds_rows *rows, int ordered)
{
  *rows = (gmds_rows){.ordered = ordered};
  for (int c = 0; c < GMDS_ROWS_CLASSES; c++)
    rows->free[c] = GMDS_NONE;
}

void gmds_rows_clear(gmds_rows *rows, gmds_memory *memory)
{
  gmds_release(memory, rows->pool, rows->pool_capacity, sizeof *rows->pool);
  gmds_release(memory, rows->start, rows->n_rows, sizeof *rows->start);
  gmds_release(memory, rows->length, rows->n_rows, sizeof *rows->length);
  gmds_release(memory, rows->size, rows->n_rows, sizeof *rows->size);
  gmds_rows_init(rows, rows->ordered);
}

static gmds_status resize_part(gmds_memory *memory, void **block, size_t had, size_t n, size_t bytes)
{
  if (!gmds_resize(memory, block, had, n, bytes))
    return GMDS_ERR_MEMORY;
  if (n > had)
    memset((char *)*block + had * bytes, 0, (n - had) * bytes);
  return GMDS_OK;
}

gmds_status gmds_rows_resize(gmds_rows *rows, gmds_memory *memory, size_t n)
{
  void *part[3] = {rows->start, rows->length, rows->size};
  const size_t bytes[3] = {sizeof *rows->start, sizeof *rows->length, sizeof *rows->size};
  size_t had = rows->n_rows;
  gmds_status status = GMDS_OK;
  int done = 0;
  while (done < 3 && (status = resize_part(memory, &part[done], had, n, bytes[done])) == GMDS_OK)
    done++;
  if (status != GMDS_OK)
    for (int k = 0; k < done; k++) /* what had grown goes back, which cannot fail */
      (void)gmds_resize(memory, &part[k], n, had, bytes[k]);
  else
    rows->n_rows = n;
  rows->start = part[0];
  rows->length = part[1];
  rows->size = part[2];
  return status;
}

gmds_status gmds_column_resize(gmds_column *column, gmds_memory *memory, size_t n)
{
  void *data = column->data;
  if (!gmds_resize(memory, &data, column->capacity, n, sizeof *column->data))
    return GMDS_ERR_MEMORY;
  column->data = data;
  column->capacity = n;
  return GMDS_OK;
}

void gmds_column_clear(gmds_column *column, gmds_memory *memory)
{
  gmds_release(memory, column->data, column->capacity, sizeof *column->data);
  *column = (gmds_column){NULL, 0};
}

static void free_block(gmds_rows *rows, size_t r)
{
  unsigned size = rows->size[r];
  if (!size)
    return;
  rows->pool[rows->start[r]] = rows->free[size];
  rows->free[size] = rows->start[r];
}

static gmds_status take_block(gmds_rows *rows, gmds_memory *memory, unsigned size, gmds_id *start)
{
  if (rows->free[size] != GMDS_NONE) {
    *start = rows->free[size];
    rows->free[size] = rows->pool[*start];
    return GMDS_OK;
  }
  size_t needed = rows->pool_used + block_of(rows, size);
  if (needed >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  if (needed > rows->pool_capacity) {
    size_t grown = gmds_grown(rows->pool_capacity, needed);
    void *pool = rows->pool;
    if (!gmds_resize(memory, &pool, rows->pool_capacity, grown, sizeof *rows->pool))
      return GMDS_ERR_MEMORY;
    rows->pool = pool;
    rows->pool_capacity = grown;
  }
  *start = (gmds_id)rows->pool_used;
  rows->pool_used = needed;
  return GMDS_OK;
}

gmds_status gmds_rows_grow(gmds_rows *rows, gmds_memory *memory, size_t r, size_t n)
{
  if (n <= entries_of(rows->size[r]))
    return GMDS_OK;
  if (n >= GMDS_NONE / 4)
    return GMDS_ERR_TOO_MANY;
  unsigned size = class_for(n, rows->ordered && n <= GMDS_ROWS_LONG);
  gmds_id start = 0;
  GMDS_TRY(take_block(rows, memory, size, &start));
  if (rows->length[r])
    memcpy(rows->pool + start, rows->pool + rows->start[r], rows->length[r] * sizeof *rows->pool);
  free_block(rows, r);
  rows->start[r] = start;
  rows->size[r] = (uint8_t)size;
  if (gmds_rows_is_hashed(rows, r))
    build_table(rows, r);
  return GMDS_OK;
}

gmds_id gmds_rows_find_hashed(const gmds_rows *rows, size_t r, gmds_id x)
{
  gmds_id position = *slot_of(rows, r, x);
  return position ? position - 1 : GMDS_NONE;
}

void gmds_rows_remove_hashed(gmds_rows *rows, size_t r, gmds_id x)
{
  gmds_id *slot = slot_of(rows, r, x), *row = rows->pool + rows->start[r];
  if (!*slot)
    return;
  gmds_id at = *slot - 1, last = rows->length[r] - 1;
  erase_slot(rows, r, slot);
  if (at != last)
    *slot_of(rows, r, row[last]) = at + 1;
  row[at] = row[last];
  rows->length[r] = last;
}

void gmds_rows_replace_hashed(gmds_rows *rows, size_t r, gmds_id x, gmds_id y)
{
  gmds_id *slot = slot_of(rows, r, x);
  if (!*slot)
    return;
  gmds_id at = *slot - 1;
  erase_slot(rows, r, slot);
  rows->pool[rows->start[r] + at] = y;
  gmds_rows_enter(rows, r, at);
}

void gmds_rows_empty(gmds_rows *rows, size_t r)
{
  rows->length[r] = 0;
  if (gmds_rows_is_hashed(rows, r))
    build_table(rows, r);
}

void gmds_rows_release(gmds_rows *rows, size_t r)
{
  free_block(rows, r);
  rows->start[r] = 0;
  rows->length[r] = 0;
  rows->size[r] = 0;
}

void gmds_rows_move(gmds_rows *rows, size_t from, size_t to)
{
  if (from == to)
    return;
  rows->start[to] = rows->start[from];
  rows->length[to] = rows->length[from];
  rows->size[to] = rows->size[from];
  rows->start[from] = rows->length[from] = 0;
  rows->size[from] = 0;
}

/* Whether row r has x. A short row is looked through to its end, many entries at once. */
static int row_has(const gmds_rows *rows, size_t r, gmds_id x)
{
  if (gmds_rows_is_hashed(rows, r))
    return gmds_rows_find_hashed(rows, r, x) != GMDS_NONE;
  size_t n = 0;
  const gmds_id *row = gmds_rows_get(rows, r, &n);
  unsigned has = 0;
  for (size_t k = 0; k < n; k++)
    has |= row[k] == x;
  return (int)has;
}

static int is_among(size_t k, size_t n, const size_t *list)
{
  int is = 0;
  for (size_t i = 0; i < n; i++)
    is |= list[i] == k;
  return is;
}

/* The longest of the rows first .. last of a list that is not among the n in `but`. */
static size_t longest_row(const gmds_rows *rows, size_t first, size_t last, const gmds_ids *list, size_t n,
                          const size_t *but)
{
  size_t longest = last;
  for (size_t k = first; k < last; k++)
    if (!is_among(k, n, but) && (longest == last || rows->length[list->data[k]] > rows->length[list->data[longest]]))
      longest = k;
  return longest;
}

/* Whether x, an entry of row `at` of first .. last, occurs in `times` of them, and in no row before that is listed
 * too. */
static int meets(const gmds_rows *rows, size_t first, size_t last, const gmds_ids *list, size_t at, gmds_id x,
                 size_t times, size_t n_skipped, const size_t *skipped)
{
  size_t copies = 0;
  for (size_t k = first; k < last && copies + (last - k) >= times; k++)
    if (row_has(rows, list->data[k], x)) {
      if (k < at && !is_among(k, n_skipped, skipped))
        return 0;
      copies++;
    }
  return copies >= times;
}

gmds_status gmds_rows_meet(const gmds_rows *rows, size_t first, size_t last, size_t times, gmds_ids *list)
{
  enum { MOST = 3 };
  /* what occurs in `times` rows is in one of them without the longest times - 1 */
  size_t before = list->n, skipped[MOST] = {0}, n_skipped = 0;
  for (; n_skipped + 1 < times && n_skipped < MOST; n_skipped++)
    skipped[n_skipped] = longest_row(rows, first, last, list, n_skipped, skipped);
  for (size_t k = first; k < last; k++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, list->data[k], &n);
    if (is_among(k, n_skipped, skipped) || !n)
      continue;
    if (gmds_ids_reserve(list, list->n + n) != GMDS_OK) {
      list->n = before;
      return GMDS_ERR_MEMORY;
    }
    for (size_t i = 0; i < n; i++)
      if (times == 1 || meets(rows, first, last, list, k, row[i], times, n_skipped, skipped))
        list->data[list->n++] = row[i];
  }
  gmds_ids_keep(list, before, 1, GMDS_NONE);
  return GMDS_OK;
}

gmds_status gmds_rows_trim(gmds_rows *rows, gmds_memory *memory)
{
  size_t needed = 0;
  for (size_t r = 0; r < rows->n_rows; r++)
    if (rows->length[r])
      needed += block_of(rows, class_for(rows->length[r], 1));
  if (needed == rows->pool_capacity)
    return GMDS_OK;
  void *block = NULL;
  if (!gmds_resize(memory, &block, 0, needed, sizeof *rows->pool))
    return GMDS_ERR_MEMORY;
  gmds_id *old = rows->pool;
  size_t old_capacity = rows->pool_capacity, used = 0;
  rows->pool = block;
  for (size_t r = 0; r < rows->n_rows; r++) {
    gmds_id length = rows->length[r];
    unsigned size = length ? class_for(length, 1) : 0;
    if (length)
      memcpy(rows->pool + used, old + rows->start[r], length * sizeof *old);
    rows->start[r] = length ? (gmds_id)used : 0;
    rows->size[r] = (uint8_t)size;
    if (gmds_rows_is_hashed(rows, r))
      build_table(rows, r);
    used += block_of(rows, size);
  }
  rows->pool_used = rows->pool_capacity = used;
  for (int c = 0; c < GMDS_ROWS_CLASSES; c++)
    rows->free[c] = GMDS_NONE;
  gmds_release(memory, old, old_capacity, sizeof *old);
  return GMDS_OK;
}

static gmds_id renamed(gmds_id x, const gmds_id *map)
{
  return x == GMDS_NONE || !map ? x : map[x];
}

void gmds_rows_renumber(gmds_rows *rows, size_t end, const gmds_id *row_map, const gmds_id *entry_map)
{
  for (size_t r = 0; r < end; r++) {
    size_t to = row_map ? row_map[r] : r;
    if (to == GMDS_NONE)
      continue;
    gmds_rows_move(rows, r, to); /* the row at `to` was moved or is empty */
    size_t n = 0;
    gmds_id *row = gmds_rows_get(rows, to, &n);
    for (size_t k = 0; entry_map && k < n; k++)
      row[k] = renamed(row[k], entry_map);
    if (entry_map && gmds_rows_is_hashed(rows, to))
      build_table(rows, to);
  }
}

void gmds_column_renumber(gmds_column *column, size_t arity, const gmds_bits *alive, size_t end, const gmds_id *row_map,
                          const gmds_id *entry_map, int coded)
{
  for (size_t r = 0; r < end; r++) {
    if (!gmds_bits_get(alive, r))
      continue;
    const gmds_id *from = column->data + arity * r;
    gmds_id *to = column->data + arity * (row_map ? row_map[r] : r);
    for (size_t k = 0; k < arity; k++)
      to[k] = coded && from[k] != GMDS_NONE ? 4 * renamed(from[k] >> 2, entry_map) + (from[k] & 3)
                                            : renamed(from[k], entry_map);
  }
}

gmds_status gmds_rows_adopt(gmds_rows *rows, gmds_memory *memory, size_t n_rows, const size_t *begin, size_t end,
                            gmds_id **data, size_t capacity)
{
  size_t needed = 0;
  int moves = 1; /* the entries already lie as they would in the pool */
  for (size_t r = 0; r < end; r++) {
    size_t n = begin[r + 1] - begin[r], block = n ? block_of(rows, class_for(n, 1)) : 0;
    moves &= block == n;
    needed += block;
  }
  if (needed >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  GMDS_TRY(gmds_rows_resize(rows, memory, n_rows));
  void *pool = NULL;
  moves &= needed == capacity;
  if (moves)
    pool = *data;
  else if (!gmds_resize(memory, &pool, 0, needed, sizeof *rows->pool)) {
    gmds_rows_clear(rows, memory);
    return GMDS_ERR_MEMORY;
  }
  rows->pool = pool;
  rows->pool_used = rows->pool_capacity = needed;
  for (size_t r = 0, used = 0; r < end; r++) {
    size_t n = begin[r + 1] - begin[r];
    if (!n)
      continue;
    unsigned size = class_for(n, 1);
    if (!moves)
      memcpy(rows->pool + used, *data + begin[r], n * sizeof **data);
    rows->start[r] = (gmds_id)used;
    rows->length[r] = (gmds_id)n;
    rows->size[r] = (uint8_t)size;
    if (size > GMDS_ROWS_LONG && !rows->ordered)
      build_table(rows, r);
    used += block_of(rows, size);
  }
  if (moves)
    *data = NULL;
  return GMDS_OK;
}
