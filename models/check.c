/* The check of stored relations against each other. */
#include <gmds/check.h>
#include <stdlib.h>
#include <string.h>

static const char letter[] = "NEF";
static const char *const word[] = {"node", "edge", "face"};

static int stored(const gmds_relations *all, int i, int j)
{
  return (all->mask >> (4 + 4 * i + j)) & 1;
}

static gmds_status violated(gmds_error *error, int i, int j, size_t c, const char *what, gmds_id found)
{
  gmds_fail(error, GMDS_ERR_INVARIANT, "%c2%c: %s %zu %s %s %lu", letter[i], letter[j], word[i], c, what, word[j],
            (unsigned long)found);
  if (error)
    error->cell = (long long)c;
  return GMDS_ERR_INVARIANT;
}

/* ---- copies */

static gmds_status begin_copy(size_t end, size_t entries, gmds_csr *csr)
{
  void *begin = NULL, *data = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, end + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  if (!gmds_resize(csr->memory, &data, 0, entries, sizeof *csr->data)) {
    gmds_release(csr->memory, begin, end + 1, sizeof *csr->begin);
    return GMDS_ERR_MEMORY;
  }
  csr->begin = begin;
  csr->data = data;
  csr->n = end;
  csr->capacity = entries;
  return GMDS_OK;
}

gmds_status gmds_copy_rows(const gmds_rows *rows, size_t end, gmds_csr *csr)
{
  size_t entries = 0, used = 0;
  for (size_t c = 0; c < end; c++)
    entries += rows->length[c];
  GMDS_TRY(begin_copy(end, entries, csr));
  for (size_t c = 0; c < end; c++) {
    size_t n = 0;
    const gmds_id *row = gmds_rows_get(rows, c, &n);
    csr->begin[c] = used;
    if (n)
      memcpy(csr->data + used, row, n * sizeof *row);
    used += n;
  }
  csr->begin[end] = used;
  return GMDS_OK;
}

gmds_status gmds_copy_pairs(const gmds_pairs *pairs, size_t end, gmds_csr *csr)
{
  size_t entries = 0, used = 0, n = 0;
  for (size_t c = 0; c < end; c++) {
    (void)gmds_pairs_get(pairs, c, &n);
    entries += n;
  }
  GMDS_TRY(begin_copy(end, entries, csr));
  for (size_t c = 0; c < end; c++) {
    const gmds_id *row = gmds_pairs_get(pairs, c, &n);
    csr->begin[c] = used;
    if (n)
      memcpy(csr->data + used, row, n * sizeof *row);
    used += n;
  }
  csr->begin[end] = used;
  return GMDS_OK;
}

gmds_status gmds_copy_inline(const gmds_id *data, size_t arity, const gmds_bits *alive, size_t end, int shift,
                             gmds_csr *csr)
{
  size_t used = 0;
  GMDS_TRY(begin_copy(end, arity * end, csr));
  for (size_t c = 0; c < end; c++) {
    csr->begin[c] = used;
    for (size_t k = 0; gmds_bits_get(alive, c) && k < arity; k++) {
      gmds_id entry = data[arity * c + k];
      csr->data[used++] = entry == GMDS_NONE ? entry : entry >> shift;
    }
  }
  csr->begin[end] = used;
  return GMDS_OK;
}

/* ---- one relation by itself */

static gmds_status check_entries(const gmds_relations *all, int i, int j, gmds_ids *scratch, gmds_error *error)
{
  const gmds_csr *csr = &all->relation[i][j];
  for (size_t c = 0; c < all->end[i]; c++) {
    size_t n = csr->begin[c + 1] - csr->begin[c];
    const gmds_id *row = n ? csr->data + csr->begin[c] : NULL;
    if (n && !gmds_bits_get(all->alive[i], c))
      return violated(error, i, j, c, "was deleted and still names", row[0]);
    for (size_t k = 0; k < n; k++) {
      if (row[k] == GMDS_NONE && i == 2 && j == 2)
        continue;
      if (row[k] >= all->end[j] || !gmds_bits_get(all->alive[j], row[k]))
        return violated(error, i, j, c, "names a cell that does not exist,", row[k]);
      if (i == j && row[k] == c)
        return violated(error, i, j, c, "names itself,", row[k]);
    }
    if (i != 2 || j != 2) {
      scratch->n = 0;
      GMDS_TRY(gmds_ids_reserve(scratch, n));
      if (n)
        memcpy(scratch->data, row, n * sizeof *row);
      scratch->n = n;
      gmds_ids_keep(scratch, 0, 2, GMDS_NONE);
      if (scratch->n)
        return violated(error, i, j, c, "names twice", scratch->data[0]);
    }
    if (gmds_bits_get(all->alive[i], c) && ((i == 1 && j == 0 && n != 2) || (i == 2 && j < 2 && n < 3)))
      return gmds_fail(error, GMDS_ERR_INVARIANT, "%c2%c: %s %zu has %zu entries", letter[i], letter[j], word[i], c, n);
  }
  return GMDS_OK;
}

static size_t times(const gmds_csr *csr, size_t c, gmds_id x)
{
  size_t n = 0;
  for (size_t k = csr->begin[c]; k < csr->begin[c + 1]; k++)
    n += csr->data[k] == x;
  return n;
}

static int has(const gmds_csr *csr, size_t c, gmds_id x)
{
  return times(csr, c, x) > 0;
}

/* ---- one relation against its inverse, and against what the others give */

/* Sorted rows of distinct entries without GMDS_NONE, so that sets can be compared. */
static int by_id(const void *a, const void *b)
{
  gmds_id x = *(const gmds_id *)a, y = *(const gmds_id *)b;
  return (x > y) - (x < y);
}

static gmds_status sorted_row(const gmds_csr *csr, size_t c, gmds_ids *list)
{
  list->n = 0;
  for (size_t k = csr->begin[c]; k < csr->begin[c + 1]; k++)
    if (csr->data[k] != GMDS_NONE)
      GMDS_TRY(gmds_ids_push(list, csr->data[k]));
  if (list->n > 1)
    qsort(list->data, list->n, sizeof *list->data, by_id);
  size_t kept = 0;
  for (size_t k = 0; k < list->n; k++)
    if (!kept || list->data[kept - 1] != list->data[k])
      list->data[kept++] = list->data[k];
  list->n = kept;
  return GMDS_OK;
}

static gmds_status compare(int i, int j, size_t c, const gmds_ids *found, const gmds_ids *expected, gmds_error *error)
{
  for (size_t f = 0, e = 0; f < found->n || e < expected->n; f++, e++) { /* both are sorted */
    if (f == found->n || (e < expected->n && expected->data[e] < found->data[f]))
      return violated(error, i, j, c, "lacks", expected->data[e]);
    if (e == expected->n || found->data[f] < expected->data[e])
      return violated(error, i, j, c, "should not name", found->data[f]);
  }
  return GMDS_OK;
}

/* The hop a -> b of the extended model for the cells list[first ..): stored, or the inverse that was built for it. */
static gmds_status hop(const gmds_relations *all, gmds_csr inverse[3][3], int a, int b, gmds_ids *list, size_t first,
                       size_t last)
{
  return gmds_hop_csr(stored(all, a, b) ? &all->relation[a][b] : &inverse[a][b], list, first, last);
}

static gmds_status compose(const gmds_relations *all, gmds_csr inverse[3][3], const gmds_path *path, size_t c,
                           gmds_ids *list)
{
  size_t first = 0;
  list->n = 0;
  GMDS_TRY(gmds_ids_push(list, (gmds_id)c));
  for (int s = 0; s < path->hops; s++) {
    size_t last = list->n;
    GMDS_TRY(hop(all, inverse, path->cells[s], path->cells[s + 1], list, first, last));
    gmds_id but = s + 1 == path->hops && path->cells[0] == path->cells[path->hops] ? (gmds_id)c : GMDS_NONE;
    gmds_ids_keep(list, last, (size_t)path->keep[s], but);
    first = last;
  }
  memmove(list->data, list->data + first, (list->n - first) * sizeof *list->data);
  list->n -= first;
  return GMDS_OK;
}

static int all_triangles(const gmds_relations *all)
{
  if (all->triangles)
    return 1;
  for (int j = 0; j < 3; j++)
    if (stored(all, 2, j)) {
      for (size_t f = 0; f < all->end[2]; f++)
        if (gmds_bits_get(all->alive[2], f) && all->relation[2][j].begin[f + 1] - all->relation[2][j].begin[f] != 3)
          return 0;
      return 1;
    }
  return 0;
}

/* The path by which the other relations give i -> j, where its plain multiplicities decide. */
static gmds_path other_path(const gmds_relations *all, int i, int j, int triangles)
{
  gmds_path path = gmds_path_of(all->mask & ~(unsigned)GMDS_RELATION_BIT(i, j), i, j);
  for (int s = 0; s < path.hops && !triangles; s++)
    if (path.keep[s] > 1 || (i == 0 && path.cells[s] == 2 && path.cells[s + 1] == 0))
      path.code = 0; /* beyond triangles this row needs the sides: check_sides */
  if (i == 0 && j == 0 && path.code && path.cells[1] == 2 && (all->mask & GMDS_E))
    path.code = 0; /* an edge without faces joins nodes too */
  return path;
}

static gmds_status check_composed(const gmds_relations *all, int i, int j, gmds_memory *memory, gmds_error *error)
{
  gmds_path path = other_path(all, i, j, all_triangles(all));
  if (!path.code)
    return GMDS_OK;
  gmds_csr inverse[3][3];
  gmds_ids found = {.memory = memory}, expected = {.memory = memory};
  gmds_status status = GMDS_OK;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++)
      gmds_csr_init(&inverse[a][b], memory);
  for (int s = 0; s < path.hops && status == GMDS_OK; s++) {
    int a = path.cells[s], b = path.cells[s + 1];
    if (!stored(all, a, b) || (a == i && b == j))
      status = gmds_invert_csr(&all->relation[b][a], all->end[a], &inverse[a][b]);
  }
  gmds_relations others = *all;
  others.mask &= ~(unsigned)GMDS_RELATION_BIT(i, j);
  for (size_t c = 0; c < all->end[i] && status == GMDS_OK; c++) {
    if (!gmds_bits_get(all->alive[i], c))
      continue;
    status = sorted_row(&all->relation[i][j], c, &found);
    if (status == GMDS_OK)
      status = compose(&others, inverse, &path, c, &expected);
    if (status == GMDS_OK)
      status = compare(i, j, c, &found, &expected, error);
  }
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++)
      gmds_csr_clear(&inverse[a][b]);
  gmds_ids_clear(&found);
  gmds_ids_clear(&expected);
  return status;
}

/* i2i against itself: x names y as often as y names x. */
static gmds_status check_symmetric(const gmds_relations *all, int i, gmds_error *error)
{
  const gmds_csr *csr = &all->relation[i][i];
  for (size_t c = 0; c < all->end[i]; c++)
    for (size_t k = csr->begin[c]; k < csr->begin[c + 1]; k++)
      if (csr->data[k] != GMDS_NONE && times(csr, csr->data[k], (gmds_id)c) != times(csr, c, csr->data[k]))
        return violated(error, i, i, c, "is not named back as often by", csr->data[k]);
  return GMDS_OK;
}

/* ---- sides: what faces that keep their nodes in order say */

typedef struct side {
  gmds_id a, b, face, k;
} side;

static int by_ends(const void *p, const void *q)
{
  const side *x = p, *y = q;
  if (x->a != y->a)
    return x->a < y->a ? -1 : 1;
  if (x->b != y->b)
    return x->b < y->b ? -1 : 1;
  return x->face < y->face ? -1 : x->face > y->face;
}

/* The edge between nodes a and b, or GMDS_NONE; `edges` is N2E, stored or the inverse of E2N. */
static gmds_id edge_between(const gmds_csr *edges, gmds_id a, gmds_id b)
{
  for (size_t k = edges->begin[a]; k < edges->begin[a + 1]; k++)
    if (has(edges, b, edges->data[k]))
      return edges->data[k];
  return GMDS_NONE;
}

/* What edges say of one side, that of the n entries s. */
static gmds_status check_edge_of_side(const gmds_relations *all, const gmds_csr *edges, const side *s, size_t n,
                                      gmds_error *error)
{
  const gmds_csr *f2e = &all->relation[2][1], *e2f = &all->relation[1][2];
  int linked = stored(all, 0, 1) || stored(all, 1, 0);
  gmds_id edge = linked ? edge_between(edges, s->a, s->b) : f2e->data[f2e->begin[s->face] + s->k];
  if (edge == GMDS_NONE)
    return violated(error, 2, 0, s->face, "has a side that is no edge, from", s->a);
  for (size_t i = 0; i < n; i++) {
    gmds_id f = s[i].face;
    gmds_id found = stored(all, 2, 1) ? f2e->data[f2e->begin[f] + s[i].k] : edge;
    if (found != edge)
      return violated(error, 2, 1, f, "has on one of its sides another edge,", found);
    if (stored(all, 1, 2) && !has(e2f, edge, f))
      return violated(error, 1, 2, edge, "lacks", f);
  }
  if (stored(all, 1, 2) && e2f->begin[edge + 1] - e2f->begin[edge] != n)
    return violated(error, 1, 2, edge, "has faces that are not on it, beside", s->face);
  return GMDS_OK;
}

static gmds_status check_group(const gmds_relations *all, const gmds_csr *edges, const side *s, size_t n,
                               gmds_error *error)
{
  if (stored(all, 0, 1) || stored(all, 1, 0) || stored(all, 2, 1))
    GMDS_TRY(check_edge_of_side(all, edges, s, n, error));
  for (size_t i = 0; i < n; i++) {
    gmds_id f = s[i].face;
    if (stored(all, 0, 0) && !has(&all->relation[0][0], s[i].a, s[i].b))
      return violated(error, 0, 0, s[i].a, "lacks, though a face joins them,", s[i].b);
    if (!stored(all, 2, 2))
      continue;
    if (n > 2)
      return violated(error, 2, 2, f, "is one of more than two on a side, with", s[i ? 0 : 1].face);
    gmds_id expected = n == 2 ? s[1 - i].face : GMDS_NONE;
    gmds_id found = all->relation[2][2].data[all->relation[2][2].begin[f] + s[i].k];
    if (all->aligned && found != expected)
      return violated(error, 2, 2, f, "has beyond one of its sides", found);
  }
  return GMDS_OK;
}

/* Sorts the sides of all faces, so that those between the same nodes follow each other, and checks each group. */
static gmds_status check_sorted_sides(const gmds_relations *all, const gmds_csr *edges, side *sides, size_t n,
                                      gmds_error *error)
{
  if (n)
    qsort(sides, n, sizeof *sides, by_ends);
  for (size_t begin = 0, end; begin < n; begin = end) {
    for (end = begin + 1; end < n && sides[end].a == sides[begin].a && sides[end].b == sides[begin].b;)
      end++;
    GMDS_TRY(check_group(all, edges, sides + begin, end - begin, error));
  }
  const gmds_csr *e2f = &all->relation[1][2];
  if (stored(all, 1, 2) && e2f->begin[e2f->n] != n)
    return gmds_fail(error, GMDS_ERR_INVARIANT, "E2F: %zu entries, but faces have %zu sides", e2f->begin[e2f->n], n);
  return GMDS_OK;
}

static gmds_status check_sides(const gmds_relations *all, gmds_memory *memory, gmds_error *error)
{
  const gmds_csr *nodes = &all->relation[2][0];
  gmds_csr edges;
  void *block = NULL;
  size_t n = 0, total = nodes->begin[nodes->n];
  gmds_csr_init(&edges, memory);
  if (!stored(all, 0, 1) && stored(all, 1, 0))
    GMDS_TRY(gmds_invert_csr(&all->relation[1][0], all->end[0], &edges));
  if (!gmds_resize(memory, &block, 0, total, sizeof(side))) {
    gmds_csr_clear(&edges);
    return GMDS_ERR_MEMORY;
  }
  side *sides = block;
  for (size_t f = 0; f < nodes->n; f++) {
    size_t begin = nodes->begin[f], count = nodes->begin[f + 1] - begin;
    for (size_t k = 0; k < count; k++) {
      gmds_id p = nodes->data[begin + k], q = nodes->data[begin + (k + 1) % count];
      sides[n++] = (side){p < q ? p : q, p < q ? q : p, (gmds_id)f, (gmds_id)k};
    }
  }
  gmds_status status = check_sorted_sides(all, stored(all, 0, 1) ? &all->relation[0][1] : &edges, sides, n, error);
  gmds_release(memory, block, total, sizeof(side));
  gmds_csr_clear(&edges);
  return status;
}

/* A face has as many nodes as edges as entries for neighbours. */
static gmds_status check_lengths(const gmds_relations *all, gmds_error *error)
{
  int first = stored(all, 2, 0) ? 0 : stored(all, 2, 1) ? 1 : 2;
  for (int j = first + 1; j < 3; j++)
    for (size_t f = 0; stored(all, 2, j) && f < all->end[2]; f++) {
      const gmds_csr *p = &all->relation[2][first], *q = &all->relation[2][j];
      size_t n = p->begin[f + 1] - p->begin[f], found = q->begin[f + 1] - q->begin[f];
      if (n != found)
        return gmds_fail(error, GMDS_ERR_INVARIANT, "F2%c: face %zu has %zu entries, but %zu sides", letter[j], f,
                         found, n);
    }
  return GMDS_OK;
}

static gmds_status check_all(const gmds_relations *all, gmds_memory *memory, gmds_ids *scratch, gmds_error *error)
{
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (stored(all, i, j))
        GMDS_TRY(check_entries(all, i, j, scratch, error));
  GMDS_TRY(check_lengths(all, error));
  for (int i = 0; i < 3; i++)
    if (stored(all, i, i))
      GMDS_TRY(check_symmetric(all, i, error));
  if (stored(all, 2, 0))
    GMDS_TRY(check_sides(all, memory, error));
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (stored(all, i, j))
        GMDS_TRY(check_composed(all, i, j, memory, error));
  return GMDS_OK;
}

gmds_status gmds_check_relations(const gmds_relations *all, gmds_memory *memory, gmds_error *error)
{
  gmds_ids scratch = {.memory = memory};
  gmds_status status = check_all(all, memory, &scratch, error);
  gmds_ids_clear(&scratch);
  if (status == GMDS_ERR_MEMORY)
    gmds_fail(error, status, "out of memory while checking");
  return status;
}
