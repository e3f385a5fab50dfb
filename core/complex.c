/* Cell complexes: the same edges and faces found among lists of nodes, and all relations from them. */
#include "sets.h"
#include <gmds/complex.h>
#include <stdio.h>
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
  c->crossed[0] = c->crossed[1] = 0;
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
  if (!gmds_csr_row(&c->nodes[3], r, &nodes))
    return 0;
  const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
  return s ? s->faces : c->walls.begin[r + 1] - c->walls.begin[r];
}

static gmds_status check_region(const gmds_complex *c, size_t r, gmds_error *error)
{
  const gmds_id *nodes = NULL, *faces = NULL, *around = NULL;
  const gmds_cell_type type = (gmds_cell_type)c->types[r];
  const gmds_shape *s = gmds_shape_of(type);
  size_t n = gmds_csr_row(&c->nodes[3], r, &nodes);
  if (n && s && n != s->nodes)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "region %zu has %zu nodes, a %s has %u", r, n, gmds_cell_type_text(type),
                     s->nodes);
  if (n && !s && (type != GMDS_POLYHEDRON || !c->walls.begin))
    return gmds_fail(error, GMDS_ERR_ARGUMENT,
                     "region %zu is neither a region with a shape nor a polyhedron with faces", r);
  size_t walls = n && !s ? gmds_csr_row(&c->walls, r, &faces) : 0;
  for (size_t k = 0; k < walls; k++)
    if (faces[k] >= c->nodes[2].n || !gmds_csr_row(&c->nodes[2], faces[k], &around))
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
      size_t n = gmds_csr_row(&c->nodes[i], x, &nodes);
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
    *length++ = gmds_csr_row(&c->nodes[1], e, &nodes);
  for (size_t f = 0; f < faces; f++)
    *length++ = gmds_csr_row(&c->nodes[2], f, &nodes);
  for (size_t r = 0; r < regions; r++) {
    const gmds_shape *s = gmds_shape_of((gmds_cell_type)c->types[r]);
    const size_t n = walls_of(c, r);
    for (size_t k = 0; k < n; k++)
      *length++ = s ? s->sides[k] : gmds_csr_row(&c->nodes[2], c->walls.data[c->walls.begin[r] + k], &nodes);
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
    (void)gmds_csr_row(&c->nodes[3], r, &own);
    for (size_t k = 0; k < n; k++) {
      size_t sides = s ? s->sides[k] : gmds_csr_row(&c->nodes[2], c->walls.data[c->walls.begin[r] + k], &nodes);
      for (size_t q = 0; q < sides; q++)
        *to++ = s ? own[s->face[k][q]] : nodes[q];
    }
  }
  return GMDS_OK;
}

/* ---- the same sets of nodes */

/* Remembers the first face, of the complex or of a region, whose nodes another lists around in another order. */
static void find_crossed(gmds_complex *c, const gmds_id *leader)
{
  const size_t first = c->nodes[1].n;
  const gmds_id *nodes = NULL, *other = NULL;
  c->crossed[0] = c->crossed[1] = 0;
  for (size_t k = first; k < c->rows.n; k++) {
    const size_t n = gmds_csr_row(&c->rows, k, &nodes), l = n ? first + leader[c->group[k - first]] : k;
    if (n < 4 || l == k)
      continue;
    (void)gmds_csr_row(&c->rows, l, &other);
    if (!gmds_same_cycle(nodes, other, n)) {
      c->crossed[0] = l;
      c->crossed[1] = k;
      return;
    }
  }
}

/* Groups the rows from the first face on by their sets of nodes. */
static gmds_status group_rows(gmds_complex *c)
{
  const size_t first = c->nodes[1].n, n = c->rows.n - first;
  void *leader = NULL, *group = NULL;
  if (!gmds_resize(c->memory, &group, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  c->group = group;
  if (!gmds_resize(c->memory, &leader, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_status status =
      gmds_group_sets(c->n_nodes, n, c->rows.begin + first, c->rows.data, c->memory, c->group, leader, &c->n_groups);
  if (status == GMDS_OK)
    find_crossed(c, leader);
  gmds_release(c->memory, leader, n, sizeof(gmds_id));
  return status;
}

/* What row k is: a face of the complex, or one of a region. */
static void name_row(const gmds_complex *c, size_t k, size_t size, char *text)
{
  const size_t first = c->nodes[1].n + c->nodes[2].n;
  size_t r = 0;
  if (k < first) {
    snprintf(text, size, "face %zu", k - c->nodes[1].n);
    return;
  }
  while (c->first_wall[r + 1] <= k - first)
    r++;
  snprintf(text, size, "face %zu of region %zu", k - first - c->first_wall[r], r);
}

gmds_status gmds_complex_uncrossed(const gmds_complex *c, gmds_error *error)
{
  char a[80], b[80];
  if (!c->crossed[1])
    return GMDS_OK;
  name_row(c, c->crossed[0], sizeof a, a);
  name_row(c, c->crossed[1], sizeof b, b);
  return gmds_fail(error, GMDS_ERR_CONFLICT, "%s has the nodes of %s, in another order around", b, a);
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
      size_t n = gmds_csr_row(&c->rows, k, &around);
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

/* Joins the longer lists beside what was found of them before, which goes when that has succeeded. */
static gmds_status join_again(gmds_complex *c, const size_t had[2], gmds_error *error)
{
  gmds_complex next = *c;
  next.edge_of = next.face_of = next.group = NULL;
  next.first_wall = NULL;
  next.n_groups = 0;
  gmds_csr_init(&next.rows, c->memory);
  gmds_edge_table_init(&next.sides, c->memory);
  GMDS_TRY(gmds_complex_join(&next, error));
  c->nodes[1].n = had[0]; /* what was found before is as long as that was */
  c->nodes[2].n = had[1];
  gmds_complex_part(c);
  *c = next;
  return GMDS_OK;
}

gmds_status gmds_complex_make(gmds_complex *c, int edges, int faces, gmds_error *error)
{
  const size_t had[2] = {c->nodes[1].n, c->nodes[2].n};
  gmds_status status = edges ? make_edges(c) : GMDS_OK;
  if (status == GMDS_OK && faces)
    status = make_faces(c, had[0]);
  if (status != GMDS_OK)
    gmds_fail(error, status, "making the edges and faces of %zu regions: %s", c->nodes[3].n, gmds_status_text(status));
  else if (c->nodes[1].n != had[0] || c->nodes[2].n != had[1])
    status = join_again(c, had, error);
  if (status != GMDS_OK) {
    shorten(&c->nodes[1], had[0]);
    shorten(&c->nodes[2], had[1]);
  }
  return status;
}
