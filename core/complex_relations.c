/* The relations between the cells of a complex that is joined. */
#include <gmds/complex.h>
#include <string.h>

/* What is needed to list the cells of one cell after the other. */
typedef struct listing {
  const gmds_complex *c;
  int aligned;  /* 2: 3 -> 3 as 4 * region + face */
  gmds_csr up;  /* i = j: the cells that each node, number of an edge, or group of a face has */
  gmds_id *met; /* the last cell that met this one; i = j: of the i-cells, 3 -> 1: of the edges */
  size_t n_met, *where;
  gmds_ids list;
} listing;

static gmds_status push(listing *l, gmds_id x)
{
  return x != GMDS_NONE || l->aligned ? gmds_ids_push(&l->list, x) : GMDS_OK;
}

static gmds_status sides_of_face(listing *l, size_t f)
{
  const gmds_complex *c = l->c;
  const size_t k = c->nodes[1].n + f;
  for (size_t q = c->rows.begin[k]; q < c->rows.begin[k + 1]; q++)
    GMDS_TRY(push(l, c->edge_of[c->sides.edges[q]]));
  return GMDS_OK;
}

static size_t row_of_wall(const gmds_complex *c, size_t wall)
{
  return c->nodes[1].n + c->nodes[2].n + wall;
}

static gmds_status edges_of_region(listing *l, size_t r)
{
  const gmds_complex *c = l->c;
  const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
  const size_t walls = c->first_wall[r + 1] - c->first_wall[r], from = l->list.n;
  GMDS_TRY(gmds_ids_reserve(&l->list, from + GMDS_SHAPE_EDGES));
  if (s && walls)
    l->list.n += s->edges;
  for (size_t k = 0; k < walls; k++) {
    const size_t w = row_of_wall(c, c->first_wall[r] + k), n = c->rows.begin[w + 1] - c->rows.begin[w];
    for (size_t q = 0; q < n; q++) {
      gmds_id e = c->edge_of[c->sides.edges[c->rows.begin[w] + q]];
      if (s)
        l->list.data[from + s->border[k][q]] = e;
      else if (e != GMDS_NONE)
        GMDS_TRY(gmds_ids_push(&l->list, e));
    }
  }
  if (!s || !l->aligned) {
    size_t kept = from; /* once each, in the order in which they come */
    for (size_t i = from; i < l->list.n; i++) {
      const gmds_id e = l->list.data[i];
      if (e == GMDS_NONE || l->met[e] == r)
        continue;
      l->met[e] = (gmds_id)r;
      l->list.data[kept++] = e;
    }
    l->list.n = kept;
  }
  return GMDS_OK;
}

static gmds_id group_of_wall(const gmds_complex *c, size_t wall)
{
  return c->group[c->nodes[2].n + wall];
}

static gmds_status faces_of_region(listing *l, size_t r)
{
  const gmds_complex *c = l->c;
  for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++)
    GMDS_TRY(push(l, c->face_of[group_of_wall(c, w)]));
  return GMDS_OK;
}

/* The others of row k of l->up, those met for this cell already left out. */
static gmds_status others(listing *l, size_t k, gmds_id x)
{
  for (size_t q = l->up.begin[k]; q < l->up.begin[k + 1]; q++) {
    const gmds_id y = l->up.data[q];
    if (y == x || l->met[y] == x)
      continue;
    l->met[y] = x;
    GMDS_TRY(gmds_ids_push(&l->list, y));
  }
  return GMDS_OK;
}

static gmds_status edges_beside(listing *l, size_t e)
{
  const gmds_id *ends = NULL;
  size_t n = gmds_csr_row(&l->c->nodes[1], e, &ends);
  for (size_t k = 0; k < n; k++)
    GMDS_TRY(others(l, ends[k], (gmds_id)e));
  return GMDS_OK;
}

static gmds_status faces_beside(listing *l, size_t f)
{
  const gmds_complex *c = l->c;
  const size_t k = c->nodes[1].n + f;
  for (size_t q = c->rows.begin[k]; q < c->rows.begin[k + 1]; q++)
    GMDS_TRY(others(l, c->sides.edges[q], (gmds_id)f));
  return GMDS_OK;
}

static gmds_status regions_beside(listing *l, size_t r)
{
  const gmds_complex *c = l->c;
  for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
    const size_t g = group_of_wall(c, w), n = l->up.begin[g + 1] - l->up.begin[g];
    const gmds_id *on = l->up.data + l->up.begin[g];
    if (!l->aligned) {
      GMDS_TRY(others(l, g, (gmds_id)r));
      continue;
    }
    if (n > 2) {
      *l->where = r;
      return GMDS_ERR_CONFLICT;
    }
    gmds_id s = n < 2 ? GMDS_NONE : on[on[0] == r];
    if (s != GMDS_NONE && l->aligned == 2) {
      size_t k = 0;
      while (group_of_wall(c, c->first_wall[s] + k) != g)
        k++;
      s = 4 * s + (gmds_id)k;
    }
    GMDS_TRY(gmds_ids_push(&l->list, s));
  }
  return GMDS_OK;
}

/* Fills the csr row by row. */
static gmds_status list_all(listing *l, size_t n, gmds_status (*rows)(listing *, size_t), gmds_csr *csr)
{
  void *data = NULL;
  size_t capacity = 0;
  gmds_status status = gmds_csr_begin(csr, n);
  for (size_t x = 0; x < n && status == GMDS_OK; x++) {
    const size_t used = csr->begin[x];
    l->list.n = 0;
    status = rows(l, x);
    if (status == GMDS_OK && used + l->list.n > capacity) {
      size_t grown = gmds_grown(capacity, used + l->list.n);
      if (gmds_resize(csr->memory, &data, capacity, grown, sizeof *csr->data))
        capacity = grown;
      else
        status = GMDS_ERR_MEMORY;
    }
    if (status == GMDS_OK && l->list.n)
      memcpy((gmds_id *)data + used, l->list.data, l->list.n * sizeof *csr->data);
    csr->begin[x + 1] = used + l->list.n;
  }
  csr->data = data;
  csr->capacity = capacity;
  if (status != GMDS_OK)
    gmds_csr_clear(csr);
  return status;
}

static gmds_status copy_csr(const gmds_csr *from, gmds_csr *csr)
{
  const gmds_id *nodes = NULL;
  GMDS_TRY(gmds_csr_begin(csr, from->n));
  for (size_t x = 0; x < from->n; x++)
    csr->begin[x + 1] = gmds_csr_row(from, x, &nodes);
  gmds_status status = gmds_csr_finish(csr);
  if (status != GMDS_OK)
    gmds_csr_clear(csr);
  else if (csr->begin[csr->n])
    memcpy(csr->data, from->data, csr->begin[csr->n] * sizeof *csr->data);
  return status;
}

gmds_status gmds_complex_joined(const gmds_complex *c, int edges, int faces, gmds_csr *csr)
{
  const size_t first = edges ? 0 : c->nodes[1].n, middle = c->nodes[1].n,
               last = faces ? middle : middle + c->nodes[2].n;
  gmds_bits by; /* which edges join */
  GMDS_TRY(gmds_bits_init(&by, c->memory, c->sides.n));
  for (size_t q = c->rows.begin[first]; q < c->rows.begin[c->rows.n]; q++)
    if (q < c->rows.begin[middle] || q >= c->rows.begin[last])
      gmds_bits_set(&by, c->sides.edges[q]);
  gmds_status status = gmds_csr_begin(csr, c->n_nodes);
  for (size_t k = 0; k < 2 * c->sides.n && status == GMDS_OK; k++)
    csr->begin[c->sides.nodes[k] + 1] += (size_t)gmds_bits_get(&by, k / 2);
  if (status == GMDS_OK)
    status = gmds_csr_finish(csr);
  if (status == GMDS_OK) {
    for (size_t k = 0; k < 2 * c->sides.n; k++) /* each row's beginning moves to its end, and back */
      if (gmds_bits_get(&by, k / 2))
        csr->data[csr->begin[c->sides.nodes[k]]++] = c->sides.nodes[k ^ 1];
    for (size_t v = c->n_nodes; v-- > 0;)
      csr->begin[v + 1] = csr->begin[v];
    csr->begin[0] = 0;
  } else
    gmds_csr_clear(csr);
  gmds_bits_clear(&by);
  return status;
}

/* Marks for n cells that no cell has met. */
static gmds_status begin_met(listing *l, size_t n)
{
  void *met = NULL;
  if (!gmds_resize(l->c->memory, &met, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  if (n)
    memset(met, 0xff, n * sizeof(gmds_id));
  l->met = met;
  l->n_met = n;
  return GMDS_OK;
}

/* Which cells each node, number of an edge or group of a face has: the inverse of rows that lie in `data`. */
static gmds_status begin_beside(listing *l, int i)
{
  const gmds_complex *c = l->c;
  const size_t edges = c->nodes[1].n, faces = c->nodes[2].n;
  const size_t n = c->nodes[i].n, keys = i == 1 ? c->n_nodes : i == 2 ? c->sides.n : c->n_groups;
  gmds_csr rows = {.n = n, .begin = c->nodes[i].begin, .data = c->nodes[i].data};
  if (i == 2) {
    rows.begin = c->rows.begin + edges;
    rows.data = c->sides.edges;
  } else if (i == 3) {
    rows.begin = c->first_wall;
    rows.data = c->group + faces;
  }
  if (!n)
    return GMDS_OK;
  GMDS_TRY(gmds_invert_csr(&rows, keys, &l->up));
  return begin_met(l, n);
}

gmds_status gmds_complex_relation(const gmds_complex *c, int i, int j, int aligned, gmds_csr *csr, size_t *where)
{
  size_t nowhere = 0;
  listing l = {.c = c, .aligned = aligned, .where = where ? where : &nowhere, .list = {.memory = c->memory}};
  gmds_status status = GMDS_OK;
  gmds_csr_init(&l.up, c->memory);
  if (i < j) {
    gmds_csr down;
    gmds_csr_init(&down, c->memory);
    GMDS_TRY(gmds_complex_relation(c, j, i, 0, &down, where));
    status = gmds_invert_csr(&down, i ? c->nodes[i].n : c->n_nodes, csr);
    gmds_csr_clear(&down);
  } else if (i == 0)
    status = gmds_complex_joined(c, 1, 1, csr);
  else if (j == 0)
    status = copy_csr(&c->nodes[i], csr);
  else if (i != j) {
    status = i == 3 && j == 1 ? begin_met(&l, c->nodes[1].n) : GMDS_OK;
    if (status == GMDS_OK)
      status = list_all(&l, c->nodes[i].n, i == 2 ? sides_of_face : j == 1 ? edges_of_region : faces_of_region, csr);
  } else {
    status = begin_beside(&l, i);
    if (status == GMDS_OK)
      status = list_all(&l, c->nodes[i].n, i == 1 ? edges_beside : i == 2 ? faces_beside : regions_beside, csr);
    gmds_csr_clear(&l.up);
  }
  gmds_release(c->memory, l.met, l.met ? l.n_met : 0, sizeof *l.met);
  gmds_ids_clear(&l.list);
  return status;
}
