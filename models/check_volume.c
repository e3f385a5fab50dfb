/* The check of meshes of volumes. */
#include <gmds/check_volume.h>
#include <gmds/relations.h>
#include <stdlib.h>
#include <string.h>

static const char letter[] = "NEFR";
static const char *const word[] = {"node", "edge", "face", "region"};

static int stored(const gmds_stored_relations *all, int i, int j)
{
  return (all->mask & (unsigned)GMDS_RELATION_BIT(i, j)) != 0;
}

static gmds_status violated(gmds_error *error, int i, int j, size_t c, const char *what, gmds_id found)
{
  gmds_fail(error, GMDS_ERR_INVARIANT, "%c2%c: %s %zu %s %s %lu", letter[i], letter[j], word[i], c, what, word[j],
            (unsigned long)found);
  if (error)
    error->cell = (long long)c;
  return GMDS_ERR_INVARIANT;
}

/* The row of a cell, sorted, without repetition and without GMDS_NONE. */
static gmds_status as_set(const gmds_csr *csr, size_t c, gmds_ids *list)
{
  const gmds_id *data = NULL;
  const size_t n = gmds_csr_row(csr, c, &data);
  list->n = 0;
  for (size_t k = 0; k < n; k++)
    if (data[k] != GMDS_NONE)
      GMDS_TRY(gmds_ids_push(list, data[k]));
  gmds_ids_keep(list, 0, 1, GMDS_NONE);
  return GMDS_OK;
}

/* ---- entries */

static gmds_status check_row(const gmds_stored_relations *all, int i, int j, size_t c, gmds_ids *list,
                             gmds_error *error)
{
  const gmds_id *data = NULL;
  const size_t n = gmds_csr_row(&all->relation[i][j], c, &data);
  if (n && !gmds_bits_get(all->alive[i], c))
    return violated(error, i, j, c, "was deleted and still names", data[0]);
  list->n = 0;
  for (size_t k = 0; k < n; k++) {
    if (data[k] == GMDS_NONE && i == 3 && j == 3)
      continue;
    if (data[k] >= all->end[j] || !gmds_bits_get(all->alive[j], data[k]))
      return violated(error, i, j, c, "names a cell that does not exist,", data[k]);
    if (i == j && data[k] == c)
      return violated(error, i, j, c, "names itself,", data[k]);
    GMDS_TRY(gmds_ids_push(list, data[k]));
  }
  if (i == 3 && j == 3)
    return GMDS_OK; /* two regions may share several faces */
  gmds_ids_keep(list, 0, 2, GMDS_NONE);
  return list->n ? violated(error, i, j, c, "names twice", list->data[0]) : GMDS_OK;
}

gmds_status gmds_check_entries(const gmds_stored_relations *all, gmds_memory *memory, gmds_error *error)
{
  gmds_ids list = {.memory = memory};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++)
      for (size_t c = 0; stored(all, i, j) && c < all->end[i] && status == GMDS_OK; c++)
        status = check_row(all, i, j, c, &list, error);
  gmds_ids_clear(&list);
  return status;
}

/* ---- against the nodes of cells */

static gmds_status compare(int i, int j, size_t c, const gmds_ids *found, const gmds_ids *expected, gmds_error *error)
{
  for (size_t f = 0, e = 0; f < found->n || e < expected->n; f++, e++) {
    if (f == found->n || (e < expected->n && expected->data[e] < found->data[f]))
      return violated(error, i, j, c, "lacks", expected->data[e]);
    if (e == expected->n || found->data[f] < expected->data[e])
      return violated(error, i, j, c, "should not name", found->data[f]);
  }
  return GMDS_OK;
}

static size_t times(const gmds_id *row, size_t n, gmds_id x)
{
  size_t found = 0;
  for (size_t k = 0; k < n; k++)
    found += row[k] == x;
  return found;
}

/* Whether each row of `found` is that of `expected`, entry by entry where positions count; regions that share several
 * faces name each other as often. */
static gmds_status compare_all(const gmds_stored_relations *all, int i, int j, const gmds_csr *expected, int positions,
                               gmds_ids *lists, gmds_error *error)
{
  for (size_t c = 0; c < all->end[i]; c++) {
    if (!gmds_bits_get(all->alive[i], c))
      continue;
    GMDS_TRY(as_set(&all->relation[i][j], c, &lists[0]));
    GMDS_TRY(as_set(expected, c, &lists[1]));
    GMDS_TRY(compare(i, j, c, &lists[0], &lists[1], error));
    const gmds_id *a = NULL, *b = NULL;
    const size_t n = gmds_csr_row(&all->relation[i][j], c, &a);
    const size_t m = gmds_csr_row(expected, c, &b);
    for (size_t k = 0; positions && n == m && k < n; k++)
      if (a[k] != b[k])
        return violated(error, i, j, c, "has in the wrong place", a[k]);
    for (size_t k = 0; i == 3 && j == 3 && k < m; k++)
      if (times(a, n, b[k]) != times(b, m, b[k]) && b[k] != GMDS_NONE)
        return violated(error, i, j, c, "shares another number of faces with", b[k]);
  }
  return GMDS_OK;
}

static gmds_status check_relation(const gmds_stored_relations *all, const gmds_complex *complex, int i, int j,
                                  gmds_ids *lists, gmds_error *error)
{
  const int local = (i == 3 && (j == 1 || j == 2) && all->local) || (i == 2 && j == 1 && all->sides),
            beyond = i == 3 && j == 3;
  gmds_csr expected;
  size_t where = 0;
  gmds_csr_init(&expected, complex->memory);
  gmds_status status = gmds_complex_relation(complex, i, j, local || beyond, &expected, &where);
  if (status == GMDS_ERR_CONFLICT)
    return gmds_fail(error, GMDS_ERR_INVARIANT, "R2R: region %zu has a face that two others have too", where);
  if (status == GMDS_OK)
    status = compare_all(all, i, j, &expected, local || (beyond && all->aligned), lists, error);
  gmds_csr_clear(&expected);
  return status;
}

/* No two cells of dimension i have the same nodes, and none is missing. */
static gmds_status check_told(const gmds_stored_relations *all, const gmds_complex *c, int i, gmds_error *error)
{
  const size_t n = i == 1 ? c->sides.n : c->n_groups;
  const gmds_id *of = i == 1 ? c->edge_of : c->face_of;
  for (size_t k = 0; k < n; k++)
    if (of[k] == GMDS_NONE && i == 1)
      return gmds_fail(error, GMDS_ERR_INVARIANT,
                       "no edge joins nodes %lu and %lu, though a cell has them side by side",
                       (unsigned long)c->sides.nodes[2 * k], (unsigned long)c->sides.nodes[2 * k + 1]);
  for (size_t r = 0; i == 2 && r < c->nodes[3].n; r++)
    for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++)
      if (of[c->group[c->nodes[2].n + w]] == GMDS_NONE)
        return gmds_fail(error, GMDS_ERR_INVARIANT, "face %zu of region %zu is no face of the mesh",
                         w - c->first_wall[r], r);
  for (size_t x = 0; x < c->nodes[i].n; x++) {
    if (!gmds_bits_get(all->alive[i], x))
      continue;
    const gmds_id same = i == 1 ? of[c->sides.edges[c->rows.begin[x]]] : of[c->group[x]];
    if (same != x)
      return gmds_fail(error, GMDS_ERR_INVARIANT, "%ss %lu and %zu have the same nodes", word[i], (unsigned long)same,
                       x);
  }
  return GMDS_OK;
}

gmds_status gmds_check_complex(const gmds_stored_relations *all, gmds_complex *complex, gmds_error *error)
{
  gmds_ids lists[2] = {{.memory = complex->memory}, {.memory = complex->memory}};
  gmds_status status = gmds_complex_join(complex, error);
  if (status == GMDS_OK && (all->keeps_faces || stored(all, 3, 3)))
    status = gmds_complex_uncrossed(complex, error);
  if (status == GMDS_ERR_CELL || status == GMDS_ERR_ARGUMENT || status == GMDS_ERR_CONFLICT) {
    status = GMDS_ERR_INVARIANT; /* the sentence says which cell */
    if (error)
      error->status = status;
  }
  if (status == GMDS_OK && all->keeps_edges)
    status = check_told(all, complex, 1, error);
  if (status == GMDS_OK && all->keeps_faces)
    status = check_told(all, complex, 2, error);
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4 && status == GMDS_OK; j++)
      if (stored(all, i, j))
        status = check_relation(all, complex, i, j, lists, error);
  gmds_ids_clear(&lists[0]);
  gmds_ids_clear(&lists[1]);
  return status;
}

/* ---- against each other */

/* Regions name each other as often. */
static gmds_status check_neighbours(const gmds_csr *csr, gmds_error *error)
{
  for (size_t r = 0; r < csr->n; r++) {
    const gmds_id *own = NULL, *back = NULL;
    const size_t n = gmds_csr_row(csr, r, &own);
    for (size_t k = 0; k < n; k++) {
      const size_t m = own[k] == GMDS_NONE ? 0 : gmds_csr_row(csr, own[k], &back);
      if (own[k] != GMDS_NONE && times(back, m, (gmds_id)r) != times(own, n, own[k]))
        return violated(error, 3, 3, r, "is not named as often as it names", own[k]);
    }
  }
  return GMDS_OK;
}

gmds_status gmds_check_inverses(const gmds_stored_relations *all, gmds_memory *memory, gmds_error *error)
{
  gmds_ids lists[2] = {{.memory = memory}, {.memory = memory}};
  gmds_status status = GMDS_OK;
  for (int i = 0; i < 4; i++)
    for (int j = i; j < 4 && status == GMDS_OK; j++) {
      gmds_csr inverse;
      if (!stored(all, i, j) || !stored(all, j, i))
        continue;
      if (i == 3) {
        status = check_neighbours(&all->relation[3][3], error);
        continue;
      }
      gmds_csr_init(&inverse, memory);
      status = gmds_invert_csr(&all->relation[j][i], all->end[i], &inverse);
      if (status == GMDS_OK)
        status = compare_all(all, i, j, &inverse, 0, lists, error);
      gmds_csr_clear(&inverse);
    }
  gmds_ids_clear(&lists[0]);
  gmds_ids_clear(&lists[1]);
  return status;
}
