/* Cell complexes: the same edges and faces found among lists of nodes, and all relations from them. */
#include <gmds/complex.h>
#include <string.h>

gmds_status gmds_csr_begin(gmds_csr *csr, size_t n)
{
  void *begin = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  memset(begin, 0, (n + 1) * sizeof *csr->begin);
  csr->begin = begin;
  csr->n = n;
  return GMDS_OK;
}

gmds_status gmds_csr_finish(gmds_csr *csr)
{
  void *data = NULL;
  for (size_t r = 0; r < csr->n; r++)
    csr->begin[r + 1] += csr->begin[r];
  if (!gmds_resize(csr->memory, &data, 0, csr->begin[csr->n], sizeof *csr->data))
    return GMDS_ERR_MEMORY;
  csr->data = data;
  csr->capacity = csr->begin[csr->n];
  return GMDS_OK;
}

static size_t row(const gmds_csr *csr, size_t r, const gmds_id **data)
{
  size_t n = csr->begin[r + 1] - csr->begin[r];
  *data = n ? csr->data + csr->begin[r] : NULL;
  return n;
}

void gmds_complex_init(gmds_complex *c, gmds_memory *memory, size_t n_nodes)
{
  memset(c, 0, sizeof *c);
  c->memory = memory;
  c->n_nodes = n_nodes;
  for (int i = 0; i < 4; i++)
    gmds_csr_init(&c->nodes[i], memory);
  gmds_csr_init(&c->walls, memory);
  gmds_csr_init(&c->rows, memory);
  gmds_edge_table_init(&c->sides, memory);
}

static size_t n_rows(const gmds_complex *c)
{
  return c->nodes[1].n + c->nodes[2].n + c->first_wall[c->nodes[3].n];
}

void gmds_complex_part(gmds_complex *c)
{
  gmds_release(c->memory, c->edge_of, c->edge_of ? c->sides.n : 0, sizeof *c->edge_of);
  gmds_release(c->memory, c->face_of, c->face_of ? c->n_groups : 0, sizeof *c->face_of);
  gmds_release(c->memory, c->group, c->group ? n_rows(c) - c->nodes[1].n : 0, sizeof *c->group);
  gmds_release(c->memory, c->first_wall, c->first_wall ? c->nodes[3].n + 1 : 0, sizeof *c->first_wall);
  c->edge_of = c->face_of = c->group = NULL;
  c->first_wall = NULL;
  gmds_edge_table_clear(&c->sides);
  gmds_csr_clear(&c->rows);
}

void gmds_complex_clear(gmds_complex *c)
{
  gmds_complex_part(c);
  for (int i = 0; i < 4; i++)
    gmds_csr_clear(&c->nodes[i]);
  gmds_csr_clear(&c->walls);
  gmds_release(c->memory, c->types, c->types_capacity, sizeof *c->types);
  gmds_complex_init(c, c->memory, c->n_nodes);
}

/* ---- rows: the nodes of edges, faces, and faces of regions */

static size_t walls_of(const gmds_complex *c, size_t r)
{
  const gmds_id *nodes = NULL;
  if (!row(&c->nodes[3], r, &nodes))
    return 0;
  const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
  return s ? s->faces : c->walls.begin[r + 1] - c->walls.begin[r];
}

static gmds_status check_region(const gmds_complex *c, size_t r, gmds_error *error)
{
  const gmds_id *nodes = NULL, *faces = NULL, *around = NULL;
  const gmds_cell_type type = (gmds_cell_type)c->types[r];
  const gmds_shape *s = gmds_shape_of(type);
  size_t n = row(&c->nodes[3], r, &nodes);
  if (n && s && n != s->nodes)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "region %zu has %zu nodes, a %s has %u", r, n, gmds_cell_type_text(type),
                     s->nodes);
  if (n && !s && (type != GMDS_POLYHEDRON || !c->walls.begin))
    return gmds_fail(error, GMDS_ERR_ARGUMENT,
                     "region %zu is neither a region with a shape nor a polyhedron with faces", r);
  size_t walls = n && !s ? row(&c->walls, r, &faces) : 0;
  for (size_t k = 0; k < walls; k++)
    if (faces[k] >= c->nodes[2].n || !row(&c->nodes[2], faces[k], &around))
      return gmds_fail(error, GMDS_ERR_CELL, "region %zu has face %lu, which does not exist", r,
                       (unsigned long)faces[k]);
  return GMDS_OK;
}

static gmds_status check_nodes(const gmds_complex *c, gmds_error *error)
{
  static const char *const word[] = {"node", "edge", "face", "region"};
  for (int i = 1; i < 4; i++)
    for (size_t x = 0; x < c->nodes[i].n; x++) {
      const gmds_id *nodes = NULL;
      size_t n = row(&c->nodes[i], x, &nodes);
      for (size_t k = 0; k < n; k++)
        if (nodes[k] >= c->n_nodes)
          return gmds_fail(error, GMDS_ERR_CELL, "%s %zu has node %lu, which does not exist", word[i], x,
                           (unsigned long)nodes[k]);
      if (n && (i == 1 ? n != 2 : n < 3))
        return gmds_fail(error, GMDS_ERR_ARGUMENT, "%s %zu has %zu nodes, %s", word[i], x, n,
                         i == 1 ? "an edge has two" : "which is too few");
      if (i == 3)
        GMDS_TRY(check_region(c, x, error));
    }
  return GMDS_OK;
}

static gmds_status list_rows(gmds_complex *c)
{
  const size_t edges = c->nodes[1].n, faces = c->nodes[2].n, regions = c->nodes[3].n;
  const gmds_id *nodes = NULL, *own = NULL;
  void *block = NULL;
  if (!gmds_resize(c->memory, &block, 0, regions + 1, sizeof *c->first_wall))
    return GMDS_ERR_MEMORY;
  c->first_wall = block;
  c->first_wall[0] = 0;
  for (size_t r = 0; r < regions; r++)
    c->first_wall[r + 1] = c->first_wall[r] + walls_of(c, r);
  GMDS_TRY(gmds_csr_begin(&c->rows, edges + faces + c->first_wall[regions]));
  size_t *length = c->rows.begin + 1;
  for (size_t e = 0; e < edges; e++)
    *length++ = row(&c->nodes[1], e, &nodes);
  for (size_t f = 0; f < faces; f++)
    *length++ = row(&c->nodes[2], f, &nodes);
  for (size_t r = 0; r < regions; r++) {
    const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
    const size_t n = walls_of(c, r);
    for (size_t k = 0; k < n; k++)
      *length++ = s ? s->sides[k] : row(&c->nodes[2], c->walls.data[c->walls.begin[r] + k], &nodes);
  }
  GMDS_TRY(gmds_csr_finish(&c->rows));
  gmds_id *to = c->rows.data;
  for (int i = 1; i < 3; i++)
    if (c->nodes[i].n && c->nodes[i].begin[c->nodes[i].n]) {
      memcpy(to, c->nodes[i].data, c->nodes[i].begin[c->nodes[i].n] * sizeof *to);
      to += c->nodes[i].begin[c->nodes[i].n];
    }
  for (size_t r = 0; r < regions; r++) {
    const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
    const size_t n = walls_of(c, r);
    (void)row(&c->nodes[3], r, &own);
    for (size_t k = 0; k < n; k++) {
      size_t sides = s ? s->sides[k] : row(&c->nodes[2], c->walls.data[c->walls.begin[r] + k], &nodes);
      for (size_t q = 0; q < sides; q++)
        *to++ = s ? own[s->face[k][q]] : nodes[q];
    }
  }
  return GMDS_OK;
}

/* ---- the same sets of nodes */

static uint64_t mix(uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

static int same_set(const gmds_id *a, const gmds_id *b, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    size_t k = 0;
    while (k < n && b[k] != a[i])
      k++;
    if (k == n)
      return 0;
  }
  return 1;
}

/* Groups the rows from the first face on by their sets of nodes: open addressing, the key of a set a sum over its nodes. */
static gmds_status group_rows(gmds_complex *c)
{
  const size_t first = c->nodes[1].n, n = c->rows.n - first;
  size_t capacity = 16;
  void *table_block = NULL, *leader_block = NULL, *group_block = NULL;
  while (capacity < 2 * n)
    capacity *= 2;
  int ok = gmds_resize(c->memory, &table_block, 0, capacity, sizeof(gmds_id)) &&
           gmds_resize(c->memory, &leader_block, 0, n, sizeof(size_t)) &&
           gmds_resize(c->memory, &group_block, 0, n, sizeof(gmds_id));
  if (ok) {
    gmds_id *table = table_block, *group = group_block;
    size_t *leader = leader_block; /* of each group a row */
    memset(table, 0xff, capacity * sizeof *table);
    c->n_groups = 0;
    for (size_t k = 0; k < n; k++) {
      const gmds_id *nodes = NULL, *other = NULL;
      const size_t sides = row(&c->rows, first + k, &nodes);
      uint64_t key = sides;
      group[k] = GMDS_NONE;
      if (!sides)
        continue;
      for (size_t q = 0; q < sides; q++)
        key += mix((uint64_t)nodes[q] + 1);
      size_t at = (size_t)mix(key) & (capacity - 1);
      while (table[at] != GMDS_NONE &&
             (row(&c->rows, leader[table[at]], &other) != sides || !same_set(nodes, other, sides)))
        at = (at + 1) & (capacity - 1);
      if (table[at] == GMDS_NONE) {
        leader[c->n_groups] = first + k;
        table[at] = (gmds_id)c->n_groups++;
      }
      group[k] = table[at];
    }
    c->group = group;
    group_block = NULL;
  }
  gmds_release(c->memory, table_block, table_block ? capacity : 0, sizeof(gmds_id));
  gmds_release(c->memory, leader_block, leader_block ? n : 0, sizeof(size_t));
  gmds_release(c->memory, group_block, group_block ? n : 0, sizeof(gmds_id));
  return ok ? GMDS_OK : GMDS_ERR_MEMORY;
}

static gmds_status name_cells(gmds_complex *c)
{
  void *edge_block = NULL, *face_block = NULL;
  if (!gmds_resize(c->memory, &edge_block, 0, c->sides.n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  c->edge_of = edge_block;
  if (!gmds_resize(c->memory, &face_block, 0, c->n_groups, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  c->face_of = face_block;
  if (c->sides.n)
    memset(c->edge_of, 0xff, c->sides.n * sizeof *c->edge_of);
  if (c->n_groups)
    memset(c->face_of, 0xff, c->n_groups * sizeof *c->face_of);
  for (size_t e = c->nodes[1].n; e-- > 0;)
    if (c->rows.begin[e + 1] > c->rows.begin[e])
      c->edge_of[c->sides.edges[c->rows.begin[e]]] = (gmds_id)e;
  for (size_t f = c->nodes[2].n; f-- > 0;)
    if (c->group[f] != GMDS_NONE)
      c->face_of[c->group[f]] = (gmds_id)f;
  return GMDS_OK;
}

/* Whether the faces of every polyhedron close: each of its edges is on two of them, and none is there twice. */
static gmds_status check_closed(const gmds_complex *c, gmds_error *error)
{
  gmds_ids list = {.memory = c->memory};
  gmds_status status = GMDS_OK;
  for (size_t r = 0; c->walls.begin && r < c->nodes[3].n && status == GMDS_OK; r++) {
    const size_t first = c->nodes[1].n + c->nodes[2].n + c->first_wall[r], n = walls_of(c, r);
    if (!n || gmds_shape_of((gmds_cell_type)c->types[r]))
      continue;
    const size_t begin = c->rows.begin[first], entries = c->rows.begin[first + n] - begin;
    size_t kept[3]; /* faces, edges of two faces or more, of three or more */
    for (size_t k = 0; k < 3 && status == GMDS_OK; k++) {
      const size_t m = k ? entries : n;
      list.n = 0;
      status = gmds_ids_reserve(&list, m);
      if (status != GMDS_OK)
        break;
      memcpy(list.data, k ? c->sides.edges + begin : c->group + first - c->nodes[1].n, m * sizeof *list.data);
      list.n = m;
      gmds_ids_keep(&list, 0, k + 1, GMDS_NONE);
      kept[k] = list.n;
    }
    if (status == GMDS_OK && (n < 4 || kept[0] != n || 2 * kept[1] != entries || kept[2]))
      status = gmds_fail(error, GMDS_ERR_ARGUMENT, "the faces of region %zu, a polyhedron, do not close", r);
  }
  gmds_ids_clear(&list);
  return status;
}

gmds_status gmds_complex_join(gmds_complex *c, gmds_error *error)
{
  GMDS_TRY(check_nodes(c, error));
  gmds_status status = list_rows(c);
  if (status == GMDS_OK && (c->rows.n >= GMDS_NONE || c->rows.begin[c->rows.n] >= GMDS_NONE))
    status = GMDS_ERR_TOO_MANY;
  if (status == GMDS_OK)
    status = gmds_edges_of_rows(c->n_nodes, c->rows.n, c->rows.begin, c->rows.data, &c->sides);
  if (status == GMDS_OK)
    status = group_rows(c);
  if (status == GMDS_OK)
    status = name_cells(c);
  if (status == GMDS_OK)
    status = check_closed(c, error);
  if (status == GMDS_ERR_ARGUMENT) { /* the sentence says which region */
    gmds_complex_part(c);
    return status;
  }
  if (status != GMDS_OK) {
    gmds_complex_part(c);
    gmds_fail(error, status, "joining %zu faces and %zu regions: %s", c->nodes[2].n, c->nodes[3].n,
              gmds_status_text(status));
  }
  return status;
}

/* ---- what is missing */

/* Room for more rows of nodes behind those there are, which are empty until they are written. */
static gmds_status extend(gmds_csr *csr, size_t more, size_t entries)
{
  void *begin = csr->begin, *data = csr->data;
  const size_t n = csr->n, used = csr->begin ? csr->begin[n] : 0;
  if (!gmds_resize(csr->memory, &data, csr->capacity, used + entries, sizeof *csr->data))
    return GMDS_ERR_MEMORY;
  csr->data = data;
  csr->capacity = used + entries;
  if (!gmds_resize(csr->memory, &begin, csr->begin ? n + 1 : 0, n + more + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  if (!csr->begin)
    ((size_t *)begin)[0] = 0;
  csr->begin = begin;
  for (size_t r = n; r < n + more; r++)
    csr->begin[r + 1] = used;
  csr->n = n + more;
  return GMDS_OK;
}

static gmds_status make_edges(gmds_complex *c)
{
  size_t missing = 0, made = c->nodes[1].n;
  gmds_csr *nodes = &c->nodes[1];
  for (size_t k = 0; k < c->sides.n; k++)
    missing += c->edge_of[k] == GMDS_NONE;
  GMDS_TRY(extend(nodes, missing, 2 * missing));
  for (size_t k = 0; k < c->sides.n; k++) {
    if (c->edge_of[k] != GMDS_NONE)
      continue;
    size_t at = nodes->begin[made++];
    nodes->data[at] = c->sides.nodes[2 * k];
    nodes->data[at + 1] = c->sides.nodes[2 * k + 1];
    nodes->begin[made] = at + 2;
  }
  return GMDS_OK;
}

static gmds_status make_faces(gmds_complex *c, size_t n_edges)
{
  size_t missing = 0, entries = 0, made = c->nodes[2].n;
  const size_t first = n_edges + made;
  gmds_csr *nodes = &c->nodes[2];
  const gmds_id *around = NULL;
  gmds_bits seen;
  GMDS_TRY(gmds_bits_init(&seen, c->memory, c->n_groups));
  for (int pass = 0; pass < 2; pass++) {
    gmds_status status = pass ? extend(nodes, missing, entries) : GMDS_OK;
    for (size_t k = first; k < c->rows.n && status == GMDS_OK; k++) {
      const gmds_id g = c->group[k - n_edges];
      if (c->face_of[g] != GMDS_NONE || gmds_bits_get(&seen, g) != pass)
        continue;
      size_t n = row(&c->rows, k, &around);
      if (pass) {
        size_t at = nodes->begin[made++];
        memcpy(nodes->data + at, around, n * sizeof *around);
        nodes->begin[made] = at + n;
        gmds_bits_unset(&seen, g);
      } else {
        gmds_bits_set(&seen, g);
        missing++;
        entries += n;
      }
    }
    if (status != GMDS_OK) {
      gmds_bits_clear(&seen);
      return status;
    }
  }
  gmds_bits_clear(&seen);
  return GMDS_OK;
}

/* Takes rows at the end away again. */
static void shorten(gmds_csr *csr, size_t n)
{
  void *begin = csr->begin, *data = csr->data;
  if (n == csr->n)
    return;
  const size_t used = csr->begin[n];
  (void)gmds_resize(csr->memory, &begin, csr->n + 1, n + 1, sizeof *csr->begin);
  (void)gmds_resize(csr->memory, &data, csr->capacity, used, sizeof *csr->data);
  csr->begin = begin;
  csr->data = data;
  csr->capacity = used;
  csr->n = n;
}

gmds_status gmds_complex_make(gmds_complex *c, int edges, int faces, gmds_error *error)
{
  const size_t had[2] = {c->nodes[1].n, c->nodes[2].n};
  gmds_status status = edges ? make_edges(c) : GMDS_OK;
  if (status == GMDS_OK && faces)
    status = make_faces(c, had[0]);
  if (status != GMDS_OK) {
    shorten(&c->nodes[1], had[0]);
    return gmds_fail(error, status, "making the edges and faces of %zu regions: %s", c->nodes[3].n,
                     gmds_status_text(status));
  }
  if (c->nodes[1].n == had[0] && c->nodes[2].n == had[1])
    return GMDS_OK;
  const size_t now[2] = {c->nodes[1].n, c->nodes[2].n};
  c->nodes[1].n = had[0]; /* what was found is as long as it was */
  c->nodes[2].n = had[1];
  gmds_complex_part(c);
  c->nodes[1].n = now[0];
  c->nodes[2].n = now[1];
  return gmds_complex_join(c, error);
}

/* ---- relations */

/* What is needed to list the cells of one cell after the other. */
typedef struct listing {
  const gmds_complex *c;
  int aligned;  /* 2: 3 -> 3 as 4 * region + face */
  gmds_csr up;  /* i = j: the cells that each node, number of an edge, or group of a face has */
  gmds_id *met; /* i = j: the last cell that met this one */
  size_t *where;
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
      size_t q = from;
      while (q < kept && l->list.data[q] != l->list.data[i])
        q++;
      if (q == kept && l->list.data[i] != GMDS_NONE)
        l->list.data[kept++] = l->list.data[i];
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
  size_t n = row(&l->c->nodes[1], e, &ends);
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
    csr->begin[x + 1] = row(from, x, &nodes);
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

/* Which cells each node, number of an edge or group of a face has: the inverse of rows that lie in `data`. */
static gmds_status begin_beside(listing *l, int i)
{
  const gmds_complex *c = l->c;
  const size_t edges = c->nodes[1].n, faces = c->nodes[2].n;
  const size_t n = c->nodes[i].n, keys = i == 1 ? c->n_nodes : i == 2 ? c->sides.n : c->n_groups;
  gmds_csr rows = {.n = n, .begin = c->nodes[i].begin, .data = c->nodes[i].data};
  void *met = NULL;
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
  if (!gmds_resize(c->memory, &met, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  memset(met, 0xff, n * sizeof(gmds_id));
  l->met = met;
  return GMDS_OK;
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
  else if (i != j)
    status = list_all(&l, c->nodes[i].n, i == 2 ? sides_of_face : j == 1 ? edges_of_region : faces_of_region, csr);
  else {
    status = begin_beside(&l, i);
    if (status == GMDS_OK)
      status = list_all(&l, c->nodes[i].n, i == 1 ? edges_beside : i == 2 ? faces_beside : regions_beside, csr);
    gmds_csr_clear(&l.up);
    gmds_release(c->memory, l.met, l.met ? c->nodes[i].n : 0, sizeof *l.met);
  }
  gmds_ids_clear(&l.list);
  return status;
}
