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

/* A traversal asks of every entry whether it is among a few cells: 64 bits of them are tried first, so that nearly all
 * entries cost one test. */
typedef struct few {
  uint64_t bits;
  size_t first, last;
} few;

static few few_of(const gmds_ids *list, size_t first, size_t last)
{
  few f = {0, first, last};
  for (size_t i = first; i < last; i++)
    f.bits |= UINT64_C(1) << (list->data[i] & 63);
  return f;
}

static int may_have(const few *f, gmds_id x)
{
  return (int)(f->bits >> (x & 63) & 1);
}

static gmds_status push_matches(const few *f, gmds_ids *list, size_t before, gmds_id x, gmds_id found)
{
  for (size_t i = f->first; i < f->last; i++)
    if (list->data[i] == x && gmds_ids_push(list, found) != GMDS_OK) {
      list->n = before;
      return GMDS_ERR_MEMORY;
    }
  return GMDS_OK;
}

/* Blocks of entries in which nothing matches are passed over with one branch; compilers vectorise the inner loop. */
enum { BLOCK = 64, FEW = 4 };

/* Four of the wanted cells, the last repeated where there are fewer. */
typedef struct four {
  gmds_id id[4];
} four;

static four four_of(const gmds_ids *list, size_t first, size_t last)
{
  four w = {{GMDS_NONE, GMDS_NONE, GMDS_NONE, GMDS_NONE}};
  for (size_t k = 0; k < 4 && first < last; k++)
    w.id[k] = list->data[first + k < last ? first + k : last - 1];
  return w;
}

static int block_matches(const gmds_id *data, const four *w)
{
  gmds_id any = 0;
  const gmds_id w0 = w->id[0], w1 = w->id[1], w2 = w->id[2], w3 = w->id[3];
  for (size_t k = 0; k < BLOCK; k++)
    any |= (gmds_id)(data[k] == w0) | (gmds_id)(data[k] == w1) | (gmds_id)(data[k] == w2) | (gmds_id)(data[k] == w3);
  return any != 0;
}

static int is_among(const few *f, const gmds_ids *list, gmds_id x)
{
  for (size_t i = f->first; i < f->last; i++)
    if (list->data[i] == x)
      return 1;
  return 0;
}

/* The row whose entries include position p of the pool, or n_rows: free blocks hold old entries. */
static size_t owner_of(const gmds_rows *rows, size_t end, size_t p)
{
  for (size_t base = 0; base < end; base += BLOCK) {
    size_t n = end - base < BLOCK ? end - base : BLOCK;
    unsigned any = 0;
    for (size_t r = base; r < base + n; r++)
      any |= (gmds_id)(p - rows->start[r]) < rows->length[r];
    for (size_t r = base; any && r < base + n; r++)
      if ((gmds_id)(p - rows->start[r]) < rows->length[r])
        return r;
  }
  return end;
}

/* For a few cells the pool is searched as one array, and the rows only for what is found; else row by row. */
gmds_status gmds_scan_rows(const gmds_rows *rows, size_t end, gmds_ids *list, size_t first, size_t last)
{
  const few f = few_of(list, first, last);
  const four wanted = four_of(list, first, last);
  size_t before = list->n;
  for (size_t base = 0; last - first <= FEW && base < rows->pool_used; base += BLOCK) {
    size_t n = rows->pool_used - base < BLOCK ? rows->pool_used - base : BLOCK;
    if (n == BLOCK && !block_matches(rows->pool + base, &wanted))
      continue;
    for (size_t p = base; p < base + n; p++) {
      gmds_id x = rows->pool[p];
      if (!may_have(&f, x) || !is_among(&f, list, x))
        continue;
      size_t c = owner_of(rows, end, p);
      if (c < end)
        GMDS_TRY(push_matches(&f, list, before, x, (gmds_id)c));
    }
  }
  for (size_t c = 0; last - first > FEW && c < end; c++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, c, &n);
    for (size_t k = 0; k < n; k++)
      if (may_have(&f, row[k]))
        GMDS_TRY(push_matches(&f, list, before, row[k], (gmds_id)c));
  }
  return GMDS_OK;
}

gmds_status gmds_scan_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, gmds_ids *list,
                             size_t first, size_t last)
{
  const few f = few_of(list, first, last);
  const four wanted = four_of(list, first, last);
  size_t before = list->n, entries = end * arity;
  for (size_t base = 0; base < entries; base += BLOCK) {
    size_t n = entries - base < BLOCK ? entries - base : BLOCK;
    if (n == BLOCK && last - first <= FEW && !block_matches(data + base, &wanted))
      continue;
    for (size_t e = base; e < base + n; e++)
      if (may_have(&f, data[e]) && gmds_bits_get(alive, e / arity))
        GMDS_TRY(push_matches(&f, list, before, data[e], (gmds_id)(e / arity)));
  }
  return GMDS_OK;
}

/* The pairs as one array, in which a long row shows as the number it has; then the long rows. */
gmds_status gmds_scan_pairs(const gmds_pairs *pairs, size_t end, gmds_ids *list, size_t first, size_t last)
{
  const few f = few_of(list, first, last);
  const four wanted = four_of(list, first, last);
  const gmds_id *data = pairs->entries.data;
  size_t before = list->n, entries = 2 * end;
  for (size_t base = 0; base < entries; base += BLOCK) {
    size_t n = entries - base < BLOCK ? entries - base : BLOCK;
    if (n == BLOCK && last - first <= FEW && !block_matches(data + base, &wanted))
      continue;
    for (size_t e = base; e < base + n; e++)
      if (may_have(&f, data[e]) && data[e - e % 2] != GMDS_NONE)
        GMDS_TRY(push_matches(&f, list, before, data[e], (gmds_id)(e / 2)));
  }
  for (gmds_id number = 0; number < pairs->n_more; number++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(&pairs->more, number, &n);
    for (size_t k = 0; k < n; k++)
      if (may_have(&f, row[k]))
        GMDS_TRY(push_matches(&f, list, before, row[k], pairs->owner.data[number]));
  }
  return GMDS_OK;
}

gmds_id gmds_find_pair(const gmds_id *data, const gmds_bits *alive, size_t end, gmds_id a, gmds_id b)
{
  for (size_t base = 0; base < end; base += BLOCK) {
    size_t n = end - base < BLOCK ? end - base : BLOCK;
    unsigned any = 0;
    for (size_t c = base; c < base + n; c++)
      any |= ((data[2 * c] == a) & (data[2 * c + 1] == b)) | ((data[2 * c] == b) & (data[2 * c + 1] == a));
    for (size_t c = base; any && c < base + n; c++)
      if (((data[2 * c] == a && data[2 * c + 1] == b) || (data[2 * c] == b && data[2 * c + 1] == a)) &&
          gmds_bits_get(alive, c))
        return (gmds_id)c;
  }
  return GMDS_NONE;
}

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
