/* Hops along stored relations and by traversal. */
#include <gmds/hops.h>
#include <string.h>

void gmds_csr_init(gmds_csr *csr, gmds_memory *memory)
{
  *csr = (gmds_csr){.memory = memory};
}

void gmds_csr_clear(gmds_csr *csr)
{
  if (csr->begin)
    gmds_release(csr->memory, csr->begin, csr->n + 1, sizeof *csr->begin);
  gmds_release(csr->memory, csr->data, csr->capacity, sizeof *csr->data);
  gmds_csr_init(csr, csr->memory);
}

static gmds_status append(gmds_ids *list, size_t before, const gmds_id *row, size_t n)
{
  if (gmds_ids_reserve(list, list->n + n) != GMDS_OK) {
    list->n = before;
    return GMDS_ERR_MEMORY;
  }
  for (size_t k = 0; k < n; k++) {
    list->data[list->n] = row[k];
    list->n += row[k] != GMDS_NONE;
  }
  return GMDS_OK;
}

gmds_status gmds_hop_rows(const gmds_rows *rows, gmds_ids *list, size_t first, size_t last)
{
  size_t before = list->n;
  for (size_t i = first; i < last; i++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, list->data[i], &n);
    GMDS_TRY(append(list, before, row, n));
  }
  return GMDS_OK;
}

gmds_status gmds_hop_pairs(const gmds_pairs *pairs, gmds_ids *list, size_t first, size_t last)
{
  size_t before = list->n;
  for (size_t i = first; i < last; i++) {
    size_t n = 0;
    const gmds_id *row = gmds_pairs_get(pairs, list->data[i], &n);
    GMDS_TRY(append(list, before, row, n));
  }
  return GMDS_OK;
}

gmds_status gmds_hop_inline(const gmds_id *data, size_t arity, gmds_ids *list, size_t first, size_t last)
{
  size_t before = list->n;
  for (size_t i = first; i < last; i++)
    GMDS_TRY(append(list, before, data + arity * list->data[i], arity));
  return GMDS_OK;
}

gmds_status gmds_hop_csr(const gmds_csr *csr, gmds_ids *list, size_t first, size_t last)
{
  size_t before = list->n;
  for (size_t i = first; i < last; i++) {
    size_t begin = csr->begin[list->data[i]], end = csr->begin[list->data[i] + 1];
    if (begin < end)
      GMDS_TRY(append(list, before, csr->data + begin, end - begin));
  }
  return GMDS_OK;
}

/* ---- traversals
 *
 * A traversal looks for a few cells among all entries of a relation. Nearly all blocks of entries hold none: they are
 * passed over with one branch each, by comparisons without a branch that compilers vectorise. More cells than FEW are
 * looked for in several passes, many by a filter of 64 bits. */
enum { BLOCK = 64, PART = 16, FEW = 4, MANY = 16, HITS = 24, SHARE = 3 };

static inline int is_among(gmds_id x, const gmds_id *wanted, size_t n)
{
  for (size_t i = 0; i < n; i++)
    if (wanted[i] == x)
      return 1;
  return 0;
}

static inline int block_has(const gmds_id *data, size_t length, const gmds_id *wanted, size_t n)
{
  gmds_id any = 0;
  for (size_t k = 0; k < length; k++)
    for (size_t i = 0; i < n; i++)
      any |= (gmds_id)0 - (gmds_id)(data[k] == wanted[i]);
  return any != 0;
}

/* The first position from `from` on and below `end` that holds one of n cells, or `end`. */
static inline size_t next_of(const gmds_id *data, size_t from, size_t end, const gmds_id *wanted, size_t n)
{
  size_t p = from;
  while (end - p >= BLOCK && !block_has(data + p, BLOCK, wanted, n))
    p += BLOCK;
  while (end - p >= PART && !block_has(data + p, PART, wanted, n))
    p += PART;
  while (p < end && !is_among(data[p], wanted, n))
    p++;
  return p;
}

/* The same for 1 to FEW cells: a loop of its own for each number of them. */
static size_t next_hit(const gmds_id *data, size_t from, size_t end, const gmds_id *cells, size_t n)
{
  const gmds_id w[FEW] = {cells[0], cells[n > 1 ? 1 : 0], cells[n > 2 ? 2 : 0], cells[n > 3 ? 3 : 0]};
  switch (n) {
  case 1:
    return next_of(data, from, end, w, 1);
  case 2:
    return next_of(data, from, end, w, 2);
  case 3:
    return next_of(data, from, end, w, 3);
  default:
    return next_of(data, from, end, w, 4);
  }
}

/* Appends `found` once for each of the cells list[first .. last) that is x. */
static gmds_status push_matches(gmds_ids *list, size_t first, size_t last, size_t before, gmds_id x, gmds_id found)
{
  for (size_t i = first; i < last; i++)
    if (list->data[i] == x && gmds_ids_push(list, found) != GMDS_OK) {
      list->n = before;
      return GMDS_ERR_MEMORY;
    }
  return GMDS_OK;
}

/* One bit for each of the cells: an entry whose bit is not set is none of them. */
static uint64_t filter_of(const gmds_ids *list, size_t first, size_t last)
{
  uint64_t bits = 0;
  for (size_t i = first; i < last; i++)
    bits |= UINT64_C(1) << (list->data[i] & 63);
  return bits;
}

static int passes(uint64_t filter, gmds_id x)
{
  return (int)(filter >> (x & 63) & 1);
}

/* ---- the rows that positions of the pool belong to */

static int owns(const gmds_rows *rows, size_t r, gmds_id p)
{
  return (gmds_id)(p - rows->start[r]) < rows->length[r];
}

/* Blocks often lie in the order of their rows (always after trimming, and where a block is never outgrown): a bisection
 * finds the row then. Otherwise it ends anywhere: `end`. */
static size_t bisect_owner(const gmds_rows *rows, size_t end, gmds_id p)
{
  size_t low = 0; /* the row is among n from here */
  for (size_t n = end; n > 1; n -= n / 2)
    low = rows->start[low + n / 2] <= p ? low + n / 2 : low; /* a move, not a branch that is mispredicted */
  return low < end && owns(rows, low, p) ? low : end;
}

/* Whether a block of rows may own one of n positions. Where the pool is not too long for signed differences
 * d = position - start, (d - length) & ~d is negative just for 0 <= d < length, which needs no comparison. */
static inline int block_owns(const gmds_id *start, const gmds_id *length, size_t n_rows, const gmds_id *p, size_t n)
{
  gmds_id any = 0;
  for (size_t r = 0; r < n_rows; r++)
    for (size_t i = 0; i < n; i++) {
      gmds_id d = p[i] - start[r];
      any |= (d - length[r]) & ~d;
    }
  return any > GMDS_ID_MAX / 2;
}

/* One traversal of the rows for 1 to SHARE positions; owners are `end` where no row is found. */
static inline void search_owners(const gmds_rows *rows, size_t end, const gmds_id *p, size_t n, size_t *owners)
{
  const int filtered = rows->pool_used <= GMDS_ID_MAX / 2;
  size_t left = n;
  for (size_t base = 0; base < end && left; base += BLOCK) {
    size_t length = end - base < BLOCK ? end - base : BLOCK;
    if (filtered && length == BLOCK && !block_owns(rows->start + base, rows->length + base, BLOCK, p, n))
      continue;
    for (size_t i = 0; i < n; i++)
      for (size_t r = base; r < base + length; r++)
        if (owns(rows, r, p[i])) {
          owners[i] = r;
          left--;
        }
  }
}

/* The rows of some positions, `end` for those in free blocks, which hold old entries. */
static void owners_of(const gmds_rows *rows, size_t end, const gmds_id *positions, size_t n, size_t *owners)
{
  gmds_id p[SHARE] = {0};
  size_t at[SHARE], found[SHARE], n_open = 0;
  for (size_t i = 0; i < n; i++) {
    owners[i] = bisect_owner(rows, end, positions[i]);
    if (owners[i] == end) {
      p[n_open] = positions[i];
      found[n_open] = end;
      at[n_open++] = i;
    }
    if (!n_open || (n_open < SHARE && i + 1 < n))
      continue;
    if (n_open == SHARE)
      search_owners(rows, end, p, SHARE, found);
    else
      for (size_t k = 0; k < n_open; k++)
        search_owners(rows, end, p + k, 1, found + k);
    for (size_t k = 0; k < n_open; k++)
      owners[at[k]] = found[k];
    n_open = 0;
  }
}

/* What a traversal of a pool has found and not told yet. */
typedef struct hits {
  gmds_id positions[HITS];
  size_t n;
} hits;

static gmds_status push_hits(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last,
                             size_t before, hits *h)
{
  size_t owners[HITS];
  owners_of(rows, end, h->positions, h->n, owners);
  for (size_t i = 0; i < h->n; i++)
    if (owners[i] < end)
      GMDS_TRY(push_matches(list, first, last, before, rows->pool[h->positions[i]], (gmds_id)owners[i]));
  h->n = 0;
  return GMDS_OK;
}

/* For a few cells the pool is searched as one array, and the rows only for what is found; else row by row. */
gmds_status gmds_scan_rows(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last)
{
  size_t before = list->n;
  if (last - first <= MANY) {
    for (size_t some = first; some < last; some += FEW) {
      hits h = {.n = 0};
      size_t n = last - some < FEW ? last - some : FEW;
      for (size_t p = 0; (p = next_hit(rows->pool, p, rows->pool_used, list->data + some, n)) < rows->pool_used; p++) {
        h.positions[h.n++] = (gmds_id)p;
        if (h.n == HITS)
          GMDS_TRY(push_hits(rows, end, list, some, some + n, before, &h));
      }
      GMDS_TRY(push_hits(rows, end, list, some, some + n, before, &h));
    }
    return GMDS_OK;
  }
  const uint64_t filter = filter_of(list, first, last);
  for (size_t c = 0; c < end; c++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, c, &n);
    for (size_t k = 0; k < n; k++)
      if (passes(filter, row[k]))
        GMDS_TRY(push_matches(list, first, last, before, row[k], (gmds_id)c));
  }
  return GMDS_OK;
}

gmds_status gmds_scan_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, gmds_ids *list,
                             size_t first, size_t last)
{
  size_t before = list->n, entries = end * arity;
  if (last - first <= MANY) {
    for (size_t some = first; some < last; some += FEW) {
      size_t n = last - some < FEW ? last - some : FEW;
      for (size_t p = 0; (p = next_hit(data, p, entries, list->data + some, n)) < entries; p++)
        if (gmds_bits_get(alive, p / arity))
          GMDS_TRY(push_matches(list, some, some + n, before, data[p], (gmds_id)(p / arity)));
    }
    return GMDS_OK;
  }
  const uint64_t filter = filter_of(list, first, last);
  for (size_t p = 0; p < entries; p++)
    if (passes(filter, data[p]) && gmds_bits_get(alive, p / arity))
      GMDS_TRY(push_matches(list, first, last, before, data[p], (gmds_id)(p / arity)));
  return GMDS_OK;
}

/* How many entries of a row, which is a set, are among the cells list[first .. last). */
static size_t common(const gmds_id *row, size_t n, const gmds_ids *list, size_t first, size_t last)
{
  size_t count = 0;
  for (size_t k = 0; k < n; k++)
    count += (size_t)is_among(row[k], list->data + first, last - first);
  return count;
}

/* A cell with `times` of n others has one of any n - times + 1 of them: only so many are looked for. */
static size_t looked_for(size_t n, size_t times)
{
  return n < times ? 0 : n - times + 1;
}

gmds_status gmds_scan_meet_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, gmds_ids *list,
                                  size_t first, size_t last, size_t times)
{
  size_t before = list->n, entries = end * arity, n = looked_for(last - first, times);
  if (n > FEW) {
    GMDS_TRY(gmds_scan_inline(data, arity, alive, end, list, first, last));
    gmds_ids_keep(list, before, times, GMDS_NONE);
    return GMDS_OK;
  }
  for (size_t p = 0; n && (p = next_hit(data, p, entries, list->data + first, n)) < entries;) {
    size_t c = p / arity;
    p = (c + 1) * arity;
    if (common(data + c * arity, arity, list, first, last) >= times && gmds_bits_get(alive, c) &&
        gmds_ids_push(list, (gmds_id)c) != GMDS_OK) {
      list->n = before;
      return GMDS_ERR_MEMORY;
    }
  }
  return GMDS_OK;
}

gmds_status gmds_scan_meet_rows(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last,
                                size_t times)
{
  size_t before = list->n, n = looked_for(last - first, times);
  if (!n)
    return GMDS_OK;
  GMDS_TRY(gmds_scan_rows(rows, end, list, first, first + n));
  gmds_ids_keep(list, before, 1, GMDS_NONE);
  size_t kept = before;
  for (size_t i = before; i < list->n; i++) {
    size_t length = 0;
    const gmds_id *row = gmds_rows_get(rows, list->data[i], &length);
    if (common(row, length, list, first, last) >= times)
      list->data[kept++] = list->data[i];
  }
  list->n = kept;
  return GMDS_OK;
}

/* The pairs as one array, in which a long row shows as the number that it has; then the long rows. */
gmds_status gmds_scan_pairs(const gmds_pairs *pairs, size_t end, gmds_ids *list, size_t first, size_t last)
{
  const gmds_id *data = pairs->entries.data;
  const size_t before = list->n, entries = 2 * end;
  if (last - first <= MANY)
    for (size_t some = first; some < last; some += FEW) {
      size_t n = last - some < FEW ? last - some : FEW;
      for (size_t p = 0; (p = next_hit(data, p, entries, list->data + some, n)) < entries; p++)
        if (data[p - p % 2] != GMDS_NONE)
          GMDS_TRY(push_matches(list, some, some + n, before, data[p], (gmds_id)(p / 2)));
    }
  else {
    const uint64_t filter = filter_of(list, first, last);
    for (size_t p = 0; p < entries; p++)
      if (passes(filter, data[p]) && data[p - p % 2] != GMDS_NONE)
        GMDS_TRY(push_matches(list, first, last, before, data[p], (gmds_id)(p / 2)));
  }
  size_t of_long = list->n;
  gmds_status status = gmds_scan_rows(&pairs->more, pairs->n_more, list, first, last);
  if (status != GMDS_OK)
    list->n = before;
  for (size_t i = of_long; i < list->n; i++)
    list->data[i] = pairs->owner.data[list->data[i]];
  return status;
}

gmds_id gmds_find_pair(const gmds_id *data, const gmds_bits *alive, size_t end, gmds_id a, gmds_id b)
{
  for (size_t p = 0; (p = next_hit(data, p, 2 * end, &a, 1)) < 2 * end; p++)
    if (data[p ^ 1] == b && gmds_bits_get(alive, p / 2))
      return (gmds_id)(p / 2);
  return GMDS_NONE;
}

/* ---- inverses */

/* Counting sort: count, sum, place. begin[c + 1] holds the place of the next entry of c while they are placed. */
static gmds_status begin_invert(size_t n, gmds_csr *csr)
{
  void *begin = NULL;
  if (n > SIZE_MAX - 2 || !gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  csr->begin = begin;
  csr->n = n;
  memset(csr->begin, 0, (n + 1) * sizeof *csr->begin);
  return GMDS_OK;
}

static gmds_status sum_counts(gmds_csr *csr)
{
  size_t total = 0;
  for (size_t c = 0; c <= csr->n; c++) {
    size_t count = csr->begin[c];
    csr->begin[c] = total;
    total += count;
  }
  void *data = NULL;
  if (!gmds_resize(csr->memory, &data, 0, total, sizeof *csr->data)) {
    gmds_csr_clear(csr);
    return GMDS_ERR_MEMORY;
  }
  csr->data = data;
  csr->capacity = total;
  return GMDS_OK;
}

static void end_invert(gmds_csr *csr)
{
  for (size_t c = csr->n; c > 0; c--)
    csr->begin[c] = csr->begin[c - 1];
  csr->begin[0] = 0;
}

/* Counts (csr->data NULL) or places the entries of one row. */
static void invert_row(const gmds_id *row, size_t n, size_t from, gmds_csr *csr)
{
  for (size_t k = 0; k < n; k++)
    if (row[k] == GMDS_NONE)
      continue;
    else if (csr->data)
      csr->data[csr->begin[row[k]]++] = (gmds_id)from;
    else
      csr->begin[row[k]]++;
}

gmds_status gmds_invert_rows(const gmds_rows *rows, size_t end, size_t n, gmds_csr *csr)
{
  GMDS_TRY(begin_invert(n, csr));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t c = 0; c < end; c++) {
      size_t length = 0;
      const gmds_id *row = gmds_rows_get(rows, c, &length);
      invert_row(row, length, c, csr);
    }
    if (pass == 0)
      GMDS_TRY(sum_counts(csr));
    if (!csr->data)
      break;
  }
  end_invert(csr);
  return GMDS_OK;
}

gmds_status gmds_invert_pairs(const gmds_pairs *pairs, size_t end, size_t n, gmds_csr *csr)
{
  GMDS_TRY(begin_invert(n, csr));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t c = 0; c < end; c++) {
      size_t length = 0;
      const gmds_id *row = gmds_pairs_get(pairs, c, &length);
      invert_row(row, length, c, csr);
    }
    if (pass == 0)
      GMDS_TRY(sum_counts(csr));
    if (!csr->data)
      break;
  }
  end_invert(csr);
  return GMDS_OK;
}

gmds_status gmds_invert_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, size_t n,
                               gmds_csr *csr)
{
  GMDS_TRY(begin_invert(n, csr));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t c = 0; c < end; c++)
      if (gmds_bits_get(alive, c))
        invert_row(data + arity * c, arity, c, csr);
    if (pass == 0)
      GMDS_TRY(sum_counts(csr));
    if (!csr->data)
      break;
  }
  end_invert(csr);
  return GMDS_OK;
}

gmds_status gmds_invert_csr(const gmds_csr *relation, size_t n, gmds_csr *csr)
{
  GMDS_TRY(begin_invert(n, csr));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t c = 0; c < relation->n; c++)
      if (relation->begin[c] < relation->begin[c + 1])
        invert_row(relation->data + relation->begin[c], relation->begin[c + 1] - relation->begin[c], c, csr);
    if (pass == 0)
      GMDS_TRY(sum_counts(csr));
    if (!csr->data)
      break;
  }
  end_invert(csr);
  return GMDS_OK;
}
