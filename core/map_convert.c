/* A combinatorial map from the nodes of cells, and the nodes of cells from a map. */
#include "map_inside.h"
#include <gmds/checksum.h>
#include <gmds/walls.h>
#include <string.h>

/* ---- to a complex */

/* The faces of one region, or of all. */
typedef struct listing {
  const gmds_map *map;
  gmds_complex *complex;
  gmds_ids orbit, corners; /* of a region: its darts, and the nodes of its faces one after the other */
  gmds_ids walls;          /* its faces, where they are numbered */
  id_table number;         /* of the first dart of each face that is listed, for maps that keep no faces */
  gmds_ids faces;          /* the same faces: begin and nodes, for the complex */
  gmds_ids begin;
} listing;

static void listing_clear(listing *l)
{
  gmds_ids_clear(&l->orbit);
  gmds_ids_clear(&l->corners);
  gmds_ids_clear(&l->walls);
  gmds_ids_clear(&l->faces);
  gmds_ids_clear(&l->begin);
  id_table_clear(&l->number);
}

static gmds_cell_type type_of(size_t nodes, size_t n, const size_t *begin)
{
  size_t triangles = 0, quadrilaterals = 0;
  for (size_t k = 0; k < n && n <= GMDS_SHAPE_FACES; k++) {
    triangles += begin[k + 1] - begin[k] == 3;
    quadrilaterals += begin[k + 1] - begin[k] == 4;
  }
  for (int t = GMDS_TETRAHEDRON; t <= GMDS_HEXAHEDRON; t++) {
    const gmds_shape *s = gmds_shape_of((gmds_cell_type)t);
    size_t three = 0;
    for (int k = 0; k < s->faces; k++)
      three += s->sides[k] == 3;
    if (s->nodes == nodes && s->faces == n && three == triangles && triangles + quadrilaterals == n)
      return (gmds_cell_type)t;
  }
  return GMDS_POLYHEDRON;
}

/* Lists the face of d, as a face of the complex unless the map keeps faces. */
static gmds_status number_wall(listing *l, gmds_id d)
{
  const gmds_map *map = l->map;
  if (map->slot[2])
    return gmds_ids_push(&l->walls, gmds_map_cell(map, 2, d));
  gmds_id least = d, e = d;
  do { /* the smallest dart on both sides of the face */
    const gmds_id beyond = gmds_map_beta(map, 3, e);
    least = e < least ? e : least;
    least = beyond < least ? beyond : least;
    e = gmds_map_beta(map, 1, e);
  } while (e != d);
  const gmds_id *known = id_table_find(&l->number, least);
  if (known)
    return gmds_ids_push(&l->walls, *known);
  const gmds_id fresh = (gmds_id)l->begin.n;
  GMDS_TRY(id_table_put(&l->number, least, fresh));
  GMDS_TRY(gmds_ids_push(&l->begin, (gmds_id)l->faces.n));
  do {
    GMDS_TRY(gmds_ids_push(&l->faces, gmds_map_cell(map, 0, e)));
    e = gmds_map_beta(map, 1, e);
  } while (e != d);
  return gmds_ids_push(&l->walls, fresh);
}

/* The nodes around the faces of the region of d, in l->corners; how many faces, with the beginning of the first few. */
static gmds_status list_walls(listing *l, gmds_id d, size_t *n, size_t begin[GMDS_SHAPE_FACES + 1])
{
  const gmds_map *map = l->map;
  GMDS_TRY(gmds_map_orbit(map, d, gmds_map_cell_betas(map, 3), &l->orbit));
  id_table done = {.memory = l->orbit.memory};
  gmds_status status = GMDS_OK;
  *n = 0;
  begin[0] = 0;
  l->corners.n = 0;
  for (size_t k = 0; k < l->orbit.n && status == GMDS_OK; k++) {
    gmds_id e = l->orbit.data[k];
    if (gmds_map_beta(map, 1, e) == GMDS_NONE || gmds_map_beta(map, 2, e) == GMDS_NONE)
      status = GMDS_ERR_UNSUPPORTED;
    if (id_table_find(&done, e) || status != GMDS_OK)
      continue;
    do {
      status = id_table_put(&done, e, 0);
      if (status == GMDS_OK)
        status = gmds_ids_push(&l->corners, gmds_map_cell(map, 0, e));
      e = gmds_map_next(map, 1, e);
    } while (status == GMDS_OK && e != GMDS_NONE && e != l->orbit.data[k]);
    if (++*n <= GMDS_SHAPE_FACES)
      begin[*n] = l->corners.n;
  }
  id_table_clear(&done);
  return status;
}

/* Lists region r: type and nodes in order, of a polyhedron the faces. */
static gmds_status list_region(listing *l, gmds_id r, gmds_ids *nodes, gmds_ids *walls)
{
  size_t n = 0, begin[GMDS_SHAPE_FACES + 1], distinct = 0;
  gmds_id shaped[GMDS_SHAPE_NODES];
  GMDS_TRY(list_walls(l, l->map->anchor[3][r], &n, begin));
  gmds_ids all = {.memory = l->orbit.memory};
  gmds_status status = GMDS_OK;
  for (size_t k = 0; k < l->corners.n && status == GMDS_OK; k++)
    status = gmds_ids_push(&all, l->corners.data[k]);
  if (status == GMDS_OK) {
    gmds_ids_keep(&all, 0, 1, GMDS_NONE);
    distinct = all.n;
  }
  gmds_cell_type type = n <= GMDS_SHAPE_FACES ? type_of(distinct, n, begin) : GMDS_POLYHEDRON;
  if (type != GMDS_POLYHEDRON && gmds_shape_from_faces(type, begin, l->corners.data, shaped) != GMDS_OK)
    type = GMDS_POLYHEDRON;
  l->complex->types[r] = (uint8_t)type;
  for (size_t k = 0; k < distinct && status == GMDS_OK; k++)
    status = gmds_ids_push(nodes, type == GMDS_POLYHEDRON ? all.data[k] : shaped[k]);
  gmds_ids_clear(&all);
  if (type != GMDS_POLYHEDRON || status != GMDS_OK)
    return status;
  id_table done = {.memory = l->orbit.memory};
  l->walls.n = 0;
  for (size_t k = 0; k < l->orbit.n && status == GMDS_OK; k++) {
    gmds_id e = l->orbit.data[k];
    if (id_table_find(&done, e))
      continue;
    do {
      status = id_table_put(&done, e, 0);
      e = gmds_map_beta(l->map, 1, e);
    } while (status == GMDS_OK && e != l->orbit.data[k]);
    if (status == GMDS_OK)
      status = number_wall(l, e);
  }
  id_table_clear(&done);
  for (size_t k = 0; k < l->walls.n && status == GMDS_OK; k++)
    status = gmds_ids_push(walls, l->walls.data[k]);
  return status;
}

/* A csr from rows that were appended to a list, which it takes over. */
static gmds_status adopt(gmds_csr *csr, const gmds_ids *begin, gmds_ids *data)
{
  GMDS_TRY(gmds_csr_begin(csr, begin->n));
  for (size_t k = 0; k < begin->n; k++)
    csr->begin[k] = begin->data[k];
  csr->begin[begin->n] = data->n;
  csr->data = data->data;
  csr->capacity = data->capacity;
  *data = (gmds_ids){.memory = data->memory};
  return GMDS_OK;
}

static gmds_status list_regions(listing *l, gmds_error *error)
{
  const gmds_map *map = l->map;
  gmds_complex *c = l->complex;
  gmds_ids begin = {.memory = c->memory}, nodes = begin, walls = begin, first = begin;
  void *types = NULL;
  gmds_status status = GMDS_OK;
  const size_t end = map->cells[3].end;
  if (!gmds_resize(c->memory, &types, 0, end, 1))
    return GMDS_ERR_MEMORY;
  c->types = types;
  c->types_capacity = end;
  for (size_t r = 0; r < end && status == GMDS_OK; r++) {
    c->types[r] = GMDS_TETRAHEDRON;
    status = gmds_ids_push(&begin, (gmds_id)nodes.n);
    if (status == GMDS_OK)
      status = gmds_ids_push(&first, (gmds_id)walls.n);
    if (status == GMDS_OK && gmds_cells_has(&map->cells[3], (gmds_id)r))
      status = list_region(l, (gmds_id)r, &nodes, &walls);
    if (status == GMDS_ERR_UNSUPPORTED)
      gmds_fail(error, status, "region %zu is open: a dart of it is free for beta 1 or 2", r);
  }
  if (status == GMDS_OK)
    status = adopt(&c->nodes[3], &begin, &nodes);
  if (status == GMDS_OK && walls.n)
    status = adopt(&c->walls, &first, &walls);
  if (status == GMDS_OK && !map->slot[2])
    status = adopt(&c->nodes[2], &l->begin, &l->faces);
  gmds_ids_clear(&begin);
  gmds_ids_clear(&nodes);
  gmds_ids_clear(&walls);
  gmds_ids_clear(&first);
  return status;
}

static gmds_status list_cells(const gmds_map *map, gmds_complex *c, gmds_error *error)
{
  if (map->slot[1])
    GMDS_TRY(gmds_map_all_adjacent(map, 1, 0, &c->nodes[1]));
  if (map->slot[2])
    GMDS_TRY(gmds_map_all_adjacent(map, 2, 0, &c->nodes[2]));
  if (map->n < 3)
    return GMDS_OK;
  listing l = {.map = map, .complex = c};
  l.orbit.memory = l.corners.memory = l.walls.memory = l.faces.memory = l.begin.memory = l.number.memory = c->memory;
  gmds_status status = list_regions(&l, error);
  listing_clear(&l);
  return status;
}

static gmds_status to_complex(const gmds_map *map, gmds_complex *complex, gmds_error *error)
{
  gmds_complex result;
  gmds_error first = {.status = GMDS_OK};
  gmds_complex_init(&result, complex->memory, map->cells[0].end);
  gmds_status status = list_cells(map, &result, &first);
  if (status == GMDS_OK) {
    *complex = result;
    return GMDS_OK;
  }
  gmds_complex_clear(&result);
  return gmds_fail(error, status, "%s", first.status ? first.text : gmds_status_text(status));
}

gmds_status gmds_map_get_complex(const gmds_map *map, gmds_complex *complex, gmds_error *error)
{
  GMDS_TRY(to_complex(map, complex, error));
  gmds_status status = gmds_complex_join(complex, error);
  if (status != GMDS_OK)
    gmds_complex_clear(complex);
  return status;
}

/* Copies cells, attributes and coordinates, and lists the nodes of all cells. */
static gmds_status to_volume(const gmds_map *map, gmds_volume *volume, gmds_error *error)
{
  void *points = NULL;
  const size_t n = map->cells[0].end, dim = (size_t)map->coordinates;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    GMDS_TRY(gmds_cells_copy(&map->cells[i], &volume->cells[i]));
  if (!gmds_resize(volume->memory, &points, 0, volume->cells[0].capacity, 3 * sizeof(double)))
    return GMDS_ERR_MEMORY;
  volume->points = points;
  for (size_t v = 0; v < n; v++)
    for (size_t k = 0; k < 3; k++)
      volume->points[3 * v + k] = k < dim ? map->points[dim * v + k] : 0;
  GMDS_TRY(to_complex(map, &volume->complex, error));
  const size_t faces = volume->complex.nodes[2].n; /* those of polyhedra where the map keeps none */
  if (map->slot[2] || !faces)
    return GMDS_OK;
  GMDS_TRY(gmds_cells_resize(&volume->cells[2], faces));
  (void)gmds_cells_take_many(&volume->cells[2], faces);
  return GMDS_OK;
}

gmds_status gmds_map_get_volume(const gmds_map *map, gmds_volume *volume, gmds_error *error)
{
  gmds_volume result;
  gmds_error first = {.status = GMDS_OK};
  gmds_volume_init(&result, volume->memory);
  gmds_status status = to_volume(map, &result, &first);
  if (status == GMDS_OK) {
    gmds_volume_clear(volume);
    *volume = result;
    return GMDS_OK;
  }
  gmds_volume_clear(&result);
  return gmds_fail(error, status, "listing the cells of a map: %s",
                   first.status ? first.text : gmds_status_text(status));
}

/* ---- from a complex */

/* Cells that are to become those of a map. A border is a side of a face (n = 2), or a face of a region (n = 3). */
typedef struct building {
  gmds_map *map;
  const gmds_complex *complex;
  gmds_walls walls;
  int n;
  size_t n_cells, n_groups;
  gmds_id *first;  /* 2 a group: the cells with it, and in the highest bit which way they run along it */
  uint8_t *turned; /* a cell: 0 not met, 1 as it is, 2 turned */
  gmds_ids queue;
  gmds_ids corners; /* of one cell, as a frame */
  gmds_ids nodes;
  id_table local;
  size_t *begin;
  size_t begin_capacity;
  gmds_id *dart; /* the first dart of each cell */
} building;

static size_t cell_borders(const building *b, size_t c)
{
  if (b->n == 2)
    return b->complex->nodes[2].begin[c + 1] - b->complex->nodes[2].begin[c];
  return b->complex->first_wall[c + 1] - b->complex->first_wall[c];
}

/* The number of border k of cell c, and which way it is run along there. */
static gmds_id border_of(const building *b, size_t c, size_t k, int *way)
{
  const gmds_complex *x = b->complex;
  if (b->n == 2) {
    size_t n = 0;
    const gmds_id *row = x->nodes[2].data + x->nodes[2].begin[c];
    const gmds_id *edges = gmds_edge_table_row(&x->sides, x->nodes[1].n + c, &n);
    *way = row[k] < row[k + 1 < n ? k + 1 : 0];
    return edges[k];
  }
  const size_t w = x->first_wall[c] + k, n = gmds_wall_sides(&b->walls, w);
  size_t least = 0;
  for (size_t q = 1; q < n; q++)
    if (gmds_wall_node(&b->walls, w, q) < gmds_wall_node(&b->walls, w, least))
      least = q;
  *way = gmds_wall_node(&b->walls, w, (least + 1) % n) < gmds_wall_node(&b->walls, w, (least + n - 1) % n);
  return gmds_wall_group(&b->walls, w);
}

static const char *word_of(const building *b)
{
  return b->n == 2 ? "face" : "region";
}

#define HIGH (GMDS_NONE ^ GMDS_NONE >> 1)

/* Notes which cells are on each border. */
static gmds_status meet_borders(building *b, size_t *failed, gmds_error *error)
{
  for (size_t k = 0; k < 2 * b->n_groups; k++)
    b->first[k] = GMDS_NONE;
  for (size_t c = 0; c < b->n_cells; c++)
    for (size_t k = 0; k < cell_borders(b, c); k++) {
      int way = 0;
      const gmds_id g = border_of(b, c, k, &way), entry = (gmds_id)c | (way ? HIGH : 0);
      gmds_id *pair = b->first + 2 * (size_t)g;
      if (pair[0] == GMDS_NONE)
        pair[0] = entry;
      else if (pair[1] == GMDS_NONE)
        pair[1] = entry;
      else {
        *failed = c;
        return gmds_fail(error, GMDS_ERR_CONFLICT, "%s %zu has a %s that %ss %llu and %llu have too: it is no manifold",
                         word_of(b), c, b->n == 2 ? "side" : "face", word_of(b), (unsigned long long)(pair[0] & ~HIGH),
                         (unsigned long long)(pair[1] & ~HIGH));
      }
    }
  return GMDS_OK;
}

/* Turns the neighbours of cell c so that they run against it along what they share. */
static gmds_status turn_neighbours(building *b, size_t c, size_t *failed, gmds_error *error)
{
  for (size_t k = 0; k < cell_borders(b, c); k++) {
    int way = 0;
    const gmds_id *pair = b->first + 2 * (size_t)border_of(b, c, k, &way);
    if (pair[1] == GMDS_NONE)
      continue;
    const int here = (pair[0] & ~HIGH) == c ? 0 : 1;
    const size_t other = pair[!here] & ~HIGH;
    const int same = !((pair[0] ^ pair[1]) & HIGH);
    const uint8_t wanted = (uint8_t)(same ? 3 - b->turned[c] : b->turned[c]);
    if (!b->turned[other]) {
      b->turned[other] = wanted;
      GMDS_TRY(gmds_ids_push(&b->queue, (gmds_id)other));
    } else if (b->turned[other] != wanted) {
      *failed = other;
      return gmds_fail(error, GMDS_ERR_CONFLICT, "%s %zu and %s %zu cannot be turned alike: it is not orientable",
                       word_of(b), c, word_of(b), other);
    }
  }
  return GMDS_OK;
}

static gmds_status turn_cells(building *b, size_t *failed, gmds_error *error)
{
  memset(b->turned, 0, b->n_cells);
  for (size_t c = 0; c < b->n_cells; c++) {
    if (b->turned[c])
      continue;
    b->turned[c] = 1;
    b->queue.n = 0;
    GMDS_TRY(gmds_ids_push(&b->queue, (gmds_id)c));
    for (size_t k = 0; k < b->queue.n; k++)
      GMDS_TRY(turn_neighbours(b, b->queue.data[k], failed, error));
  }
  return GMDS_OK;
}

/* How many sides border cycle k of cell c has (n = 2: there is one), and its node q as the map will have it. */
static size_t cycle_sides(const building *b, size_t c, size_t k)
{
  return b->n == 2 ? cell_borders(b, c) : gmds_wall_sides(&b->walls, b->complex->first_wall[c] + k);
}

/* Where in the listing corner q of a cycle of n comes from; and its side. */
static size_t listed_corner(const building *b, size_t c, size_t n, size_t q)
{
  return b->turned[c] == 2 ? n - 1 - q : q;
}

static size_t listed_side(const building *b, size_t c, size_t n, size_t q)
{
  return b->turned[c] == 2 ? (2 * n - 2 - q) % n : q;
}

static gmds_id node_of(const building *b, size_t c, size_t k, size_t at)
{
  return b->n == 2 ? b->complex->nodes[2].data[b->complex->nodes[2].begin[c] + at]
                   : gmds_wall_node(&b->walls, b->complex->first_wall[c] + k, at);
}

/* The darts of cell c, sewn with nothing. */
static gmds_status build_cell(building *b, size_t c)
{
  const size_t cycles = b->n == 2 ? 1 : cell_borders(b, c);
  void *begin = b->begin;
  b->corners.n = b->nodes.n = 0;
  id_table_empty(&b->local);
  if (cycles + 1 > b->begin_capacity) {
    if (!gmds_resize(&b->map->memory, &begin, b->begin_capacity, cycles + 8, sizeof *b->begin))
      return GMDS_ERR_MEMORY;
    b->begin = begin;
    b->begin_capacity = cycles + 8;
  }
  for (size_t k = 0; k < cycles; k++) {
    const size_t n = cycle_sides(b, c, k);
    b->begin[k] = b->corners.n;
    for (size_t q = 0; q < n; q++) {
      const gmds_id v = node_of(b, c, k, listed_corner(b, c, n, q));
      const gmds_id *known = id_table_find(&b->local, v);
      const gmds_id local = known ? *known : (gmds_id)b->nodes.n;
      if (!known) {
        GMDS_TRY(id_table_put(&b->local, v, local));
        GMDS_TRY(gmds_ids_push(&b->nodes, v));
      }
      GMDS_TRY(gmds_ids_push(&b->corners, local));
    }
  }
  b->begin[cycles] = b->corners.n;
  const gmds_map_frame frame = {b->nodes.n, cycles, b->begin, b->corners.data};
  return gmds_map_make_frame(b->map, &frame, NULL, b->nodes.data, &b->dart[c]);
}

/* The values of a cell of the volume go to the cell that a dart has. */
static void carry(gmds_map *map, int i, const gmds_cells *from, gmds_id listed, gmds_id d)
{
  const gmds_id c = gmds_map_cell(map, i, d);
  const gmds_attribute *a = from->attributes;
  for (gmds_attribute *to = map->cells[i].attributes; to && listed != GMDS_NONE; to = to->next, a = a->next)
    memcpy((char *)to->data + c * to->bytes, (const char *)a->data + listed * a->bytes, to->bytes);
}

/* Columns for the attributes of the volume, in the same order. */
static gmds_status make_columns(gmds_map *map, int i, const gmds_cells *from)
{
  gmds_attribute *made = NULL;
  for (const gmds_attribute *a = from->attributes; a; a = a->next)
    GMDS_TRY(gmds_attribute_add(&map->cells[i], a->name, a->type, a->components, &made));
  return GMDS_OK;
}

/* The attributes of edges, faces and regions. Darts were numbered cell by cell, cycle by cycle. */
static gmds_status carry_attributes(const building *b, const gmds_volume *volume)
{
  gmds_map *map = b->map;
  const gmds_complex *x = b->complex;
  for (int i = 1; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i])
      GMDS_TRY(make_columns(map, i, &volume->cells[i]));
  for (size_t c = 0; c < b->n_cells; c++) {
    gmds_id d = b->dart[c];
    const size_t cycles = !cell_borders(b, c) ? 0 : b->n == 2 ? 1 : cell_borders(b, c);
    for (size_t k = 0; k < cycles; k++) {
      const size_t n = cycle_sides(b, c, k);
      size_t sides = 0;
      const size_t row = x->nodes[1].n + (b->n == 2 ? c : x->nodes[2].n + x->first_wall[c] + k);
      const gmds_id *edges = gmds_edge_table_row(&x->sides, row, &sides);
      const int inwards =
          b->n == 3 && b->walls.inwards.n_words && gmds_bits_get(&b->walls.inwards, x->first_wall[c] + k);
      if (map->slot[2])
        carry(map, 2, &volume->cells[2],
              b->n == 2 ? (gmds_id)c : x->face_of[gmds_wall_group(&b->walls, x->first_wall[c] + k)], d);
      for (size_t q = 0; q < n; q++, d++) {
        size_t side = listed_side(b, c, n, q);
        if (inwards)
          side = (2 * n - 2 - side) % n;
        if (map->slot[1])
          carry(map, 1, &volume->cells[1], x->edge_of[edges[side]], d);
      }
    }
    if (map->slot[3] && cycles)
      carry(map, 3, &volume->cells[3], (gmds_id)c, b->dart[c]);
  }
  return GMDS_OK;
}

static gmds_status begin_building(building *b, gmds_map *map, const gmds_complex *complex, const double *points)
{
  gmds_memory *memory = &map->memory;
  void *first = NULL, *turned = NULL, *dart = NULL;
  *b = (building){.map = map, .complex = complex, .n = map->n};
  b->queue.memory = b->corners.memory = b->nodes.memory = b->local.memory = memory;
  b->walls.inwards.memory = complex->memory;
  b->n_cells = complex->nodes[map->n].n;
  b->n_groups = map->n == 2 ? complex->sides.n : complex->n_groups;
  if (map->n == 3)
    GMDS_TRY(gmds_walls_init(&b->walls, complex, points));
  if (!gmds_resize(memory, &first, 0, b->n_groups, 2 * sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  b->first = first;
  if (!gmds_resize(memory, &turned, 0, b->n_cells, 1))
    return GMDS_ERR_MEMORY;
  b->turned = turned;
  if (!gmds_resize(memory, &dart, 0, b->n_cells, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  b->dart = dart;
  return GMDS_OK;
}

static void end_building(building *b)
{
  gmds_memory *memory = &b->map->memory;
  gmds_release(memory, b->first, b->first ? b->n_groups : 0, 2 * sizeof(gmds_id));
  gmds_release(memory, b->turned, b->turned ? b->n_cells : 0, 1);
  gmds_release(memory, b->dart, b->dart ? b->n_cells : 0, sizeof(gmds_id));
  gmds_release(memory, b->begin, b->begin_capacity, sizeof *b->begin);
  gmds_ids_clear(&b->queue);
  gmds_ids_clear(&b->corners);
  gmds_ids_clear(&b->nodes);
  id_table_clear(&b->local);
  if (b->n == 3)
    gmds_walls_clear(&b->walls);
}

/* Builds the cells of a joined complex in a map that has nodes and no darts. volume may be NULL. */
static gmds_status build(gmds_map *map, const gmds_complex *complex, const double *points, const gmds_volume *volume,
                         size_t *failed, gmds_error *error)
{
  building b;
  gmds_status status = begin_building(&b, map, complex, points);
  if (status == GMDS_OK)
    status = meet_borders(&b, failed, error);
  if (status == GMDS_OK)
    status = turn_cells(&b, failed, error);
  for (size_t c = 0; c < b.n_cells && status == GMDS_OK; c++) {
    if (!cell_borders(&b, c))
      continue;
    status = build_cell(&b, c);
    if (status == GMDS_ERR_ARGUMENT) {
      *failed = c;
      gmds_fail(error, status, "%s %zu is no single cell: a node or an edge of it is met twice", word_of(&b), c);
    }
  }
  if (status == GMDS_OK && volume)
    status = carry_attributes(&b, volume);
  if (status == GMDS_OK)
    status = gmds_map_match(map, GMDS_BY_NODES, NULL);
  if (status == GMDS_OK)
    status = gmds_map_restore_cells(map);
  end_building(&b);
  return status;
}

/* Nodes with the identifiers and attributes of the volume, and their coordinates. */
static gmds_status take_nodes(gmds_map *map, const gmds_volume *volume, gmds_error *error)
{
  const size_t dim = (size_t)map->coordinates;
  GMDS_TRY(gmds_cells_copy(&volume->cells[0], &map->cells[0]));
  const size_t capacity = map->cells[0].capacity, end = map->cells[0].end;
  void *points = NULL, *darts = NULL;
  if (!gmds_resize(&map->memory, &points, 0, capacity, dim * sizeof(double)))
    return GMDS_ERR_MEMORY;
  map->points = points;
  map->points_capacity = capacity;
  if (!gmds_resize(&map->memory, &darts, 0, capacity, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  map->anchor[0] = darts;
  map->anchor_capacity[0] = capacity;
  for (size_t v = 0; v < end; v++) {
    const double *x = volume->points + 3 * v;
    map->anchor[0][v] = GMDS_NONE;
    memcpy(map->points + dim * v, x, dim * sizeof *x);
    if (dim == 2 && gmds_cells_has(&map->cells[0], (gmds_id)v) && x[2] != 0)
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "point %zu has a third coordinate, nodes of this model have two",
                       v);
  }
  return GMDS_OK;
}

static gmds_status fill(gmds_map *map, gmds_volume *volume, gmds_error *error)
{
  size_t failed = 0;
  if (map->n == 2 && volume->cells[3].count)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "a 2-map holds no regions, the volume has %zu",
                     volume->cells[3].count);
  GMDS_TRY(take_nodes(map, volume, error));
  if (!volume->complex.sides.begin)
    GMDS_TRY(gmds_complex_join(&volume->complex, error));
  return build(map, &volume->complex, volume->points, volume, &failed, error);
}

gmds_status gmds_map_set_volume(gmds_map *map, gmds_volume *volume, gmds_error *error)
{
  if (map->darts.count || map->cells[0].count)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the map to be filled is not empty");
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->cells[i].attributes)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "the map to be filled has attributes");
  gmds_error first = {.status = GMDS_OK};
  gmds_map_empty(map);
  gmds_status status = fill(map, volume, &first);
  if (status == GMDS_OK)
    return GMDS_OK;
  gmds_map_clear(map);
  return gmds_fail(error, status, "%s", first.status ? first.text : gmds_status_text(status));
}

gmds_status gmds_map_add_faces(gmds_map *map, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed)
{
  gmds_complex c;
  size_t bad = n;
  if (map->darts.count || map->n != 2)
    return GMDS_ERR_ARGUMENT;
  gmds_complex_init(&c, &map->memory, map->cells[0].end);
  gmds_status status = gmds_csr_begin(&c.nodes[2], n);
  for (size_t f = 0; f < n && status == GMDS_OK; f++) {
    const size_t sides = begin ? begin[f + 1] - begin[f] : 3;
    if ((begin && begin[f + 1] < begin[f]) || sides < 3)
      status = GMDS_ERR_ARGUMENT;
    else
      c.nodes[2].begin[f + 1] = sides;
    bad = status == GMDS_OK ? n : f;
  }
  if (status == GMDS_OK)
    status = gmds_csr_finish(&c.nodes[2]);
  const size_t used = status == GMDS_OK ? c.nodes[2].begin[n] : 0;
  for (size_t f = 0, k = 0; k < used && status == GMDS_OK; k++) {
    const gmds_id v = nodes[(begin ? begin[0] : 0) + k];
    while (k >= c.nodes[2].begin[f + 1])
      f++;
    c.nodes[2].data[k] = v;
    int twice = 0;
    for (size_t q = c.nodes[2].begin[f]; q < k; q++)
      twice |= c.nodes[2].data[q] == v;
    if (!gmds_cells_has(&map->cells[0], v) || twice) {
      status = twice ? GMDS_ERR_ARGUMENT : GMDS_ERR_CELL;
      bad = f;
    }
  }
  if (status == GMDS_OK)
    status = gmds_complex_join(&c, NULL);
  if (status == GMDS_OK) {
    status = build(map, &c, NULL, NULL, &bad, NULL);
    if (status != GMDS_OK && map->darts.count)
      gmds_map_drop_darts(map);
  }
  gmds_complex_clear(&c);
  if (status != GMDS_OK && failed)
    *failed = bad;
  return status;
}

/* ---- soups, checksum */

gmds_status gmds_map_to_soup(const gmds_map *map, gmds_soup *soup, gmds_error *error)
{
  gmds_volume volume;
  gmds_soup result;
  gmds_volume_init(&volume, soup->memory);
  gmds_soup_init(&result, soup->memory, 3);
  gmds_status status = gmds_map_get_volume(map, &volume, error);
  if (status == GMDS_OK)
    status = gmds_volume_to_soup(&volume, &result, error);
  gmds_volume_clear(&volume);
  if (status != GMDS_OK) {
    gmds_soup_clear(&result);
    return status;
  }
  if (map->coordinates == 2) { /* the same room, shorter rows */
    void *points = result.points;
    for (size_t v = 0; v < result.n_points; v++)
      memmove(result.points + 2 * v, result.points + 3 * v, 2 * sizeof(double));
    (void)gmds_resize(soup->memory, &points, 3 * result.point_capacity, 2 * result.point_capacity, sizeof(double));
    result.points = points;
    result.dim = 2;
  }
  gmds_soup_clear(soup);
  *soup = result;
  return GMDS_OK;
}

gmds_status gmds_map_cells_checksum(const gmds_map *map, gmds_memory *memory, uint64_t *sum)
{
  gmds_ids nodes = {.memory = memory};
  uint64_t total = 0;
  gmds_status status = GMDS_OK;
  const gmds_cells *cells = &map->cells[map->n];
  for (gmds_id c = gmds_cells_next(cells, 0); c != GMDS_NONE && status == GMDS_OK; c = gmds_cells_next(cells, c + 1)) {
    uint64_t h = 0;
    status = gmds_map_adjacent(map, map->n, 0, c, &nodes);
    if (status == GMDS_OK)
      status = gmds_checksum_cell(map->coordinates, map->points, nodes.n, nodes.data, &h);
    total += h;
  }
  gmds_ids_clear(&nodes);
  if (status == GMDS_OK)
    *sum = total;
  return status;
}
