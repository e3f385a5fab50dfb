/* Sides joined to chains: walks from the ends of open ones first, then around the loops that are left. */
#include <gmds/chains.h>
#include <string.h>

typedef struct walk {
  size_t n;
  const gmds_id *sides;
  gmds_csr at;    /* the sides at each node */
  gmds_csr found; /* the chains; `rows` of them so far */
  size_t rows;
  gmds_bits used;
} walk;

/* An unused side at v, one that begins there if there is any, or GMDS_NONE. */
static gmds_id next_side(const walk *w, gmds_id v)
{
  gmds_id found = GMDS_NONE;
  for (size_t k = w->at.begin[v]; k < w->at.begin[v + 1]; k++) {
    gmds_id s = w->at.data[k];
    if (gmds_bits_get(&w->used, s))
      continue;
    if (w->sides[2 * (size_t)s] == v)
      return s;
    found = s;
  }
  return found;
}

/* Walks from v until no side is left there or it is back. The chains have room. */
static void follow(walk *w, gmds_id v, int closed)
{
  size_t end = w->found.begin[w->rows];
  gmds_id at = v, s;
  while ((s = next_side(w, at)) != GMDS_NONE) {
    const gmds_id *ends = w->sides + 2 * (size_t)s;
    gmds_bits_set(&w->used, s);
    w->found.data[end++] = at;
    at = ends[0] == at ? ends[1] : ends[0];
    if (closed && at == v)
      break;
  }
  if (at != v)
    w->found.data[end++] = at;
  w->found.begin[++w->rows] = end;
}

static size_t degree(const walk *w, gmds_id v)
{
  size_t n = 0;
  for (size_t k = w->at.begin[v]; k < w->at.begin[v + 1]; k++)
    n += !gmds_bits_get(&w->used, w->at.data[k]);
  return n;
}

static gmds_status take_rows(gmds_csr *csr, size_t rows, size_t entries)
{
  void *begin = NULL, *data = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, rows + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  csr->begin = begin;
  csr->n = rows;
  csr->begin[0] = 0;
  if (!gmds_resize(csr->memory, &data, 0, entries, sizeof *csr->data))
    return GMDS_ERR_MEMORY;
  csr->data = data;
  csr->capacity = entries;
  return GMDS_OK;
}

static gmds_status begin_walk(walk *w, size_t n_nodes)
{
  GMDS_TRY(gmds_bits_init(&w->used, w->at.memory, w->n));
  gmds_bits_fill(&w->used, w->n);
  GMDS_TRY(gmds_invert_inline(w->sides, 2, &w->used, w->n, n_nodes, &w->at));
  if (w->n)
    memset(w->used.words, 0, w->used.n_words * sizeof *w->used.words);
  return take_rows(&w->found, w->n, 2 * w->n); /* a chain of k sides has at most k + 1 nodes */
}

static gmds_status copy_chains(const walk *w, gmds_csr *chains)
{
  size_t entries = w->found.begin[w->rows];
  gmds_csr result;
  gmds_csr_init(&result, chains->memory);
  if (take_rows(&result, w->rows, entries) != GMDS_OK) {
    gmds_csr_clear(&result);
    return GMDS_ERR_MEMORY;
  }
  memcpy(result.begin, w->found.begin, (w->rows + 1) * sizeof *result.begin);
  if (entries)
    memcpy(result.data, w->found.data, entries * sizeof *result.data);
  *chains = result;
  return GMDS_OK;
}

gmds_status gmds_chain_sides(size_t n, const gmds_id *sides, size_t n_nodes, gmds_memory *memory, gmds_csr *chains,
                             size_t *open)
{
  walk w = {.n = n, .sides = sides, .used = {.memory = memory}};
  size_t n_open = 0;
  gmds_csr_init(&w.at, memory);
  gmds_csr_init(&w.found, memory);
  gmds_status status = begin_walk(&w, n_nodes);
  if (status == GMDS_OK) {
    for (size_t v = 0; v < n_nodes; v++)
      if (degree(&w, (gmds_id)v) % 2)
        follow(&w, (gmds_id)v, 0);
    n_open = w.rows;
    for (size_t s = 0; s < n; s++)
      if (!gmds_bits_get(&w.used, s))
        follow(&w, sides[2 * s], 1);
    status = copy_chains(&w, chains);
  }
  gmds_csr_clear(&w.at);
  gmds_csr_clear(&w.found);
  gmds_bits_clear(&w.used);
  if (status == GMDS_OK)
    *open = n_open;
  return status;
}
