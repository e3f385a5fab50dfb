/* From soups to volumes. */
#include "listed.h"
#include "sets.h"
#include <string.h>

/* Which cell of a volume each cell of the soup is: its number among those of its dimension. */
typedef struct taking {
  gmds_volume *volume;
  const gmds_soup *soup;
  gmds_id *cell;
  size_t count[4];
} taking;

static int dimension(const gmds_soup *soup, size_t c)
{
  return gmds_cell_type_dimension((gmds_cell_type)soup->types[c]);
}

static gmds_status take_points(taking *t)
{
  const gmds_soup *soup = t->soup;
  gmds_volume *volume = t->volume;
  void *points = NULL;
  GMDS_TRY(gmds_cells_resize(&volume->cells[0], soup->n_points));
  if (!gmds_resize(volume->memory, &points, 0, soup->n_points, 3 * sizeof(double)))
    return GMDS_ERR_MEMORY;
  volume->points = points;
  (void)gmds_cells_take_many(&volume->cells[0], soup->n_points);
  for (size_t v = 0; v < soup->n_points; v++)
    for (int k = 0; k < 3; k++)
      volume->points[3 * v + (size_t)k] = k < soup->dim ? soup->points[v * (size_t)soup->dim + (size_t)k] : 0;
  return GMDS_OK;
}

/* Whether n points are points of the soup, none twice. */
static gmds_status check_points(const gmds_soup *soup, size_t c, size_t n, const gmds_id *points, gmds_ids *list,
                                gmds_error *error)
{
  const char *text = gmds_cell_type_text((gmds_cell_type)soup->types[c]);
  list->n = 0;
  GMDS_TRY(gmds_ids_reserve(list, n));
  for (size_t k = 0; k < n; k++) {
    if (points[k] >= soup->n_points)
      return gmds_fail(error, GMDS_ERR_CELL, "cell %zu (%s) has point %lu, which does not exist", c, text,
                       (unsigned long)points[k]);
    list->data[list->n++] = points[k];
  }
  gmds_ids_keep(list, 0, 2, GMDS_NONE);
  return list->n ? gmds_fail(error, GMDS_ERR_ARGUMENT, "cell %zu (%s) has point %lu twice", c, text,
                             (unsigned long)list->data[0])
                 : GMDS_OK;
}

static gmds_status check_polyhedron(const gmds_soup *soup, size_t c, gmds_ids *list, gmds_error *error)
{
  const gmds_id *at = soup->corners + soup->begin[c], *end = soup->corners + soup->begin[c + 1];
  size_t faces = at < end ? *at++ : 0;
  int adds_up = faces > 3;
  for (; faces > 0 && adds_up; faces--) {
    const size_t n = at < end ? *at++ : 0;
    adds_up = n > 2 && n <= (size_t)(end - at);
    if (adds_up) {
      GMDS_TRY(check_points(soup, c, n, at, list, error));
      at += n;
    }
  }
  return adds_up && at == end
             ? GMDS_OK
             : gmds_fail(error, GMDS_ERR_ARGUMENT, "cell %zu (polyhedron): the counts of its faces do not add up", c);
}

/* The soup may have been filled by other means than gmds_soup_add_cell. */
static gmds_status check_cells(const gmds_soup *soup, gmds_ids *list, gmds_error *error)
{
  for (size_t c = 0; c < soup->n_cells; c++) {
    const gmds_cell_type type = (gmds_cell_type)soup->types[c];
    const size_t n = soup->begin[c + 1] - soup->begin[c], points = (size_t)gmds_cell_type_points(type);
    if (soup->types[c] >= GMDS_CELL_TYPE_COUNT)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "cell %zu has the type %u, which is none", c, soup->types[c]);
    if (type != GMDS_POLYHEDRON && (type == GMDS_POLYGON ? n < 3 : n != points))
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "cell %zu (%s) has %zu points", c, gmds_cell_type_text(type), n);
    if (type == GMDS_POLYHEDRON)
      GMDS_TRY(check_polyhedron(soup, c, list, error));
    else
      GMDS_TRY(check_points(soup, c, n, soup->corners + soup->begin[c], list, error));
  }
  return GMDS_OK;
}

/* How many faces the polyhedra of the soup have. */
static size_t count_walls(const gmds_soup *soup)
{
  size_t faces = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    if (soup->types[c] == GMDS_POLYHEDRON)
      faces += soup->corners[soup->begin[c]];
  return faces;
}

/* Room for as many rows as there are cells: faces first those of the soup, then those of its polyhedra. */
static gmds_status begin_lists(taking *t, size_t more_faces)
{
  gmds_complex *x = &t->volume->complex;
  void *types = NULL;
  for (size_t c = 0; c < t->soup->n_cells; c++)
    t->cell[c] = (gmds_id)t->count[dimension(t->soup, c)]++;
  if (!gmds_resize(x->memory, &types, 0, t->count[3], 1))
    return GMDS_ERR_MEMORY;
  x->types = types;
  x->types_capacity = t->count[3];
  for (int i = 1; i < 4; i++)
    GMDS_TRY(gmds_csr_begin(&x->nodes[i], t->count[i] + (i == 2 ? more_faces : 0)));
  return more_faces ? gmds_csr_begin(&x->walls, t->count[3]) : GMDS_OK;
}

/* Counts the nodes of a row in the first pass, writes them in the second. */
static void put_row(gmds_csr *csr, size_t k, int pass, const gmds_id *nodes, size_t n)
{
  if (pass == 0)
    csr->begin[k + 1] = n;
  else if (n)
    memcpy(csr->data + csr->begin[k], nodes, n * sizeof *nodes);
}

/* Lists region k, a polyhedron, and its faces from *face on. */
static gmds_status list_polyhedron(taking *t, size_t k, const gmds_id *stream, int pass, size_t *face, gmds_ids *list)
{
  gmds_complex *x = &t->volume->complex;
  const gmds_id faces = *stream++;
  list->n = 0;
  if (pass == 0)
    x->walls.begin[k + 1] = faces;
  for (gmds_id f = 0; f < faces; f++) {
    const size_t sides = *stream++;
    if (pass)
      x->walls.data[x->walls.begin[k] + f] = (gmds_id)*face;
    put_row(&x->nodes[2], (*face)++, pass, stream, sides);
    GMDS_TRY(gmds_ids_reserve(list, list->n + sides));
    memcpy(list->data + list->n, stream, sides * sizeof *stream);
    list->n += sides;
    stream += sides;
  }
  gmds_ids_keep(list, 0, 1, GMDS_NONE);
  put_row(&x->nodes[3], k, pass, list->data, list->n);
  return GMDS_OK;
}

static gmds_status list_cells(taking *t, int pass, gmds_ids *list)
{
  const gmds_soup *soup = t->soup;
  gmds_complex *x = &t->volume->complex;
  size_t face = t->count[2];
  for (size_t c = 0; c < soup->n_cells; c++) {
    const int i = dimension(soup, c);
    const size_t k = t->cell[c];
    const gmds_id *at = soup->corners + soup->begin[c];
    if (i == 3)
      x->types[k] = soup->types[c];
    if (soup->types[c] == GMDS_POLYHEDRON)
      GMDS_TRY(list_polyhedron(t, k, at, pass, &face, list));
    else if (i)
      put_row(&x->nodes[i], k, pass, at, soup->begin[c + 1] - soup->begin[c]);
  }
  return GMDS_OK;
}

/* Lists the nodes of all cells, those with the same nodes too. */
static gmds_status list_all(taking *t)
{
  gmds_complex *x = &t->volume->complex;
  const size_t more_faces = count_walls(t->soup);
  gmds_ids list = {.memory = t->volume->memory};
  GMDS_TRY(begin_lists(t, more_faces));
  gmds_status status = list_cells(t, 0, &list);
  for (int i = 1; i < 4 && status == GMDS_OK; i++)
    status = gmds_csr_finish(&x->nodes[i]);
  if (status == GMDS_OK && more_faces)
    status = gmds_csr_finish(&x->walls);
  if (status == GMDS_OK)
    status = list_cells(t, 1, &list);
  gmds_ids_clear(&list);
  return status;
}

/* Leaves out the edges and faces that are the same as one before them; map[k] is the new number of each. */
static void drop_same(gmds_complex *x, int i, const gmds_id *first_of, gmds_id *map)
{
  gmds_csr *nodes = &x->nodes[i];
  size_t kept = 0, used = 0;
  for (size_t k = 0; k < nodes->n; k++) {
    const size_t begin = nodes->begin[k], n = nodes->begin[k + 1] - begin;
    if (first_of[k] != k) { /* the first comes before it */
      map[k] = map[first_of[k]];
      continue;
    }
    map[k] = (gmds_id)kept;
    memmove(nodes->data + used, nodes->data + begin, n * sizeof *nodes->data);
    nodes->begin[kept++] = used;
    used += n;
  }
  void *begin = nodes->begin, *data = nodes->data;
  nodes->begin[kept] = used;
  (void)gmds_resize(x->memory, &begin, nodes->n + 1, kept + 1, sizeof *nodes->begin);
  (void)gmds_resize(x->memory, &data, nodes->capacity, used, sizeof *nodes->data);
  nodes->begin = begin;
  nodes->data = data;
  nodes->capacity = used;
  nodes->n = kept;
}

/* The edge or face of the complex that each row of the i-cells is. */
static gmds_id same_as(const gmds_complex *x, int i, size_t k)
{
  if (i == 1)
    return x->edge_of[x->sides.edges[x->rows.begin[k]]];
  return x->face_of[x->group[k]];
}

/* GMDS_ERR_CONFLICT where face k is not listed around as the one before it with the same nodes. */
static gmds_status check_order(const gmds_complex *x, size_t k, gmds_id first, gmds_error *error)
{
  const gmds_id *a = NULL, *b = NULL;
  const size_t n = gmds_csr_row(&x->nodes[2], k, &a);
  (void)gmds_csr_row(&x->nodes[2], first, &b);
  if (first == k || gmds_same_cycle(a, b, n))
    return GMDS_OK;
  return gmds_fail(error, GMDS_ERR_CONFLICT, "a face is listed twice in different orders: points %lu %lu %lu %lu%s",
                   (unsigned long)a[0], (unsigned long)a[1], (unsigned long)a[2], (unsigned long)a[3],
                   n > 4 ? " ..." : "");
}

/* Finds for every edge and face the first that is the same; *any: whether one is not its own. */
static gmds_status find_first(const gmds_complex *x, gmds_id *first[3], int *any, gmds_error *error)
{
  for (int i = 1; i < 3; i++)
    for (size_t k = 0; k < x->nodes[i].n; k++) {
      first[i][k] = same_as(x, i, k);
      *any |= first[i][k] != k;
      if (i == 2)
        GMDS_TRY(check_order(x, k, first[i][k], error));
    }
  return GMDS_OK;
}

/* Leaves out what is the same as something before it, and joins the rest. */
static gmds_status drop_repeated(taking *t, gmds_id *first[3], gmds_id *map[3], gmds_error *error)
{
  gmds_complex *x = &t->volume->complex;
  gmds_complex_part(x);
  for (int i = 1; i < 3; i++)
    drop_same(x, i, first[i], map[i]);
  for (size_t k = 0; x->walls.begin && k < x->walls.begin[x->walls.n]; k++)
    x->walls.data[k] = map[2][x->walls.data[k]];
  for (size_t c = 0; c < t->soup->n_cells; c++) {
    const int i = dimension(t->soup, c);
    if (i == 1 || i == 2)
      t->cell[c] = map[i][t->cell[c]];
  }
  return gmds_complex_join(x, error);
}

static gmds_status merge_cells(taking *t, gmds_error *error)
{
  gmds_complex *x = &t->volume->complex;
  GMDS_TRY(gmds_complex_join(x, error));
  const size_t n[3] = {0, x->nodes[1].n, x->nodes[2].n};
  gmds_id *first[3] = {NULL, NULL, NULL}, *map[3] = {NULL, NULL, NULL};
  gmds_status status = GMDS_OK;
  int any = 0;
  for (int i = 1; i < 3; i++) {
    void *a = NULL, *b = NULL;
    if (!gmds_resize(x->memory, &a, 0, n[i], sizeof(gmds_id)) || !gmds_resize(x->memory, &b, 0, n[i], sizeof(gmds_id)))
      status = GMDS_ERR_MEMORY;
    first[i] = a;
    map[i] = b;
  }
  if (status == GMDS_OK)
    status = find_first(x, first, &any, error);
  if (status == GMDS_OK && any)
    status = drop_repeated(t, first, map, error);
  for (int i = 1; i < 3; i++) {
    gmds_release(x->memory, first[i], first[i] ? n[i] : 0, sizeof(gmds_id));
    gmds_release(x->memory, map[i], map[i] ? n[i] : 0, sizeof(gmds_id));
  }
  return status;
}

/* Writes what the soup has of cell c, listed for the q-th time, into the columns of the i-cells. */
static gmds_status take_values(taking *t, gmds_cells *cells, int i, size_t k, size_t c, int q)
{
  for (const gmds_attribute *a = t->soup->attributes[GMDS_OF_CELLS]; a; a = a->next) {
    char room[NAME_SIZE];
    const char *name = name_on_cells(a->name, i, q, room);
    gmds_attribute *own = gmds_attribute_find(cells, name);
    if (!own)
      GMDS_TRY(gmds_attribute_add(cells, name, a->type, a->components, &own));
    if (own->type == a->type && own->components == a->components)
      memcpy((char *)own->data + k * a->bytes, (const char *)a->data + c * a->bytes, a->bytes);
  }
  return GMDS_OK;
}

/* How the nodes of an edge or face were listed another time: twice the place of its first node, and 1 when they go the
 * other way round. */
static int turn_of(const gmds_id *first, const gmds_id *again, size_t n)
{
  size_t at = 0;
  while (at + 1 < n && first[at] != again[0])
    at++;
  return (int)(2 * at) + (first[(at + 1) % n] != again[1]);
}

/* Remembers it in an attribute, where it is not as the first time. */
static gmds_status take_turn(taking *t, gmds_cells *cells, int i, size_t k, size_t c, int q)
{
  const gmds_csr *nodes = &t->volume->complex.nodes[i];
  char room[NAME_SIZE];
  const int turn = turn_of(nodes->data + nodes->begin[k], t->soup->corners + t->soup->begin[c],
                           nodes->begin[k + 1] - nodes->begin[k]);
  if (!turn)
    return GMDS_OK;
  const char *name = name_of_turns(q, room);
  gmds_attribute *own = gmds_attribute_find(cells, name);
  if (!own)
    GMDS_TRY(gmds_attribute_add(cells, name, GMDS_INT, 1, &own));
  ((int *)own->data)[k] = turn;
  return GMDS_OK;
}

/* The i-cells of the volume, with the attributes that the soup has of its cells, and how often it listed them. */
static gmds_status take_cells(taking *t, int i)
{
  const gmds_soup *soup = t->soup;
  gmds_cells *cells = &t->volume->cells[i];
  gmds_attribute *listed = NULL;
  if (i) {
    GMDS_TRY(gmds_cells_resize(cells, t->volume->complex.nodes[i].n));
    (void)gmds_cells_take_many(cells, t->volume->complex.nodes[i].n);
  }
  if (t->count[i] && i < 3)
    GMDS_TRY(gmds_attribute_add(cells, GMDS_LISTED, GMDS_INT, 1, &listed));
  for (size_t c = 0; t->count[i] && c < soup->n_cells; c++) {
    if (dimension(soup, c) != i)
      continue;
    const size_t k = i ? t->cell[c] : soup->corners[soup->begin[c]];
    const int q = listed ? ((int *)listed->data)[k]++ : 0;
    if (q && i)
      GMDS_TRY(take_turn(t, cells, i, k, c, q));
    GMDS_TRY(take_values(t, cells, i, k, c, q));
  }
  return GMDS_OK;
}

static gmds_status take_point_attributes(taking *t)
{
  for (const gmds_attribute *a = t->soup->attributes[GMDS_OF_POINTS]; a; a = a->next) {
    gmds_attribute *own = NULL;
    GMDS_TRY(gmds_attribute_add(&t->volume->cells[0], a->name, a->type, a->components, &own));
    if (t->soup->n_points)
      memcpy(own->data, a->data, t->soup->n_points * a->bytes);
  }
  return GMDS_OK;
}

/* Whether no attribute of the soup has a name that the volume needs, or one too long to be marked. */
static gmds_status check_names(const gmds_soup *soup, gmds_error *error)
{
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next) {
      if (is_reserved(a->name))
        return gmds_fail(error, GMDS_ERR_ARGUMENT,
                         "attribute '%.80s': names that begin with " GMDS_RESERVED " are reserved", a->name);
      if (strlen(a->name) > NAME_SIZE - NAME_MARKS)
        return gmds_fail(error, GMDS_ERR_ARGUMENT, "attribute '%.80s...' has a name of more than %d bytes", a->name,
                         NAME_SIZE - NAME_MARKS);
    }
  return GMDS_OK;
}

gmds_status gmds_volume_from_soup(gmds_volume *volume, const gmds_soup *soup, gmds_error *error)
{
  taking t = {.volume = volume, .soup = soup};
  gmds_ids list = {.memory = volume->memory};
  void *block = NULL;
  gmds_error first = {.status = GMDS_OK};
  gmds_status status = check_names(soup, &first);
  if (status == GMDS_OK)
    status = check_cells(soup, &list, &first);
  gmds_ids_clear(&list);
  if (status == GMDS_OK && !gmds_resize(volume->memory, &block, 0, soup->n_cells, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  t.cell = block;
  volume->complex.n_nodes = soup->n_points;
  if (status == GMDS_OK)
    status = take_points(&t);
  if (status == GMDS_OK)
    status = list_all(&t);
  if (status == GMDS_OK)
    status = merge_cells(&t, &first);
  if (status == GMDS_OK)
    status = take_point_attributes(&t);
  for (int i = 0; i < 4 && status == GMDS_OK; i++)
    status = take_cells(&t, i);
  gmds_release(volume->memory, block, block ? soup->n_cells : 0, sizeof(gmds_id));
  if (status != GMDS_OK) {
    gmds_volume_clear(volume);
    if (first.status == GMDS_OK)
      gmds_fail(&first, status, "a mesh of %zu points and %zu cells: %s", soup->n_points, soup->n_cells,
                gmds_status_text(status));
    if (error)
      *error = first;
  }
  return status;
}
