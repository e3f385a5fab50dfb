/* From volumes to soups. */
#include "listed.h"

/* Which edges and faces bound something. */
static gmds_status mark_bounds(const gmds_complex *x, gmds_bits bounds[3])
{
  const size_t edges = x->nodes[1].n, faces = x->nodes[2].n;
  GMDS_TRY(gmds_bits_init(&bounds[1], x->memory, edges));
  GMDS_TRY(gmds_bits_init(&bounds[2], x->memory, faces));
  for (size_t k = edges; k < x->rows.n; k++)
    for (size_t q = x->rows.begin[k]; q < x->rows.begin[k + 1]; q++)
      if (x->edge_of[x->sides.edges[q]] != GMDS_NONE)
        gmds_bits_set(&bounds[1], x->edge_of[x->sides.edges[q]]);
  for (size_t k = edges + faces; k < x->rows.n; k++)
    if (x->face_of[x->group[k - edges]] != GMDS_NONE)
      gmds_bits_set(&bounds[2], x->face_of[x->group[k - edges]]);
  return GMDS_OK;
}

typedef struct giving {
  const gmds_volume *volume;
  gmds_soup *soup;
  gmds_id *number; /* of each node, without holes */
  gmds_bits bounds[3];
  gmds_ids list;
} giving;

/* How often each i-cell was listed, or NULL. */
static const int *times_listed(const giving *g, int i)
{
  const gmds_attribute *listed = i < 3 ? gmds_attribute_find(&g->volume->cells[i], GMDS_LISTED) : NULL;
  return listed && listed->type == GMDS_INT && listed->components == 1 ? listed->data : NULL;
}

/* How often an i-cell is written. */
static int times_written(const giving *g, int i, const int *listed, size_t c)
{
  if (!gmds_bits_get(&g->volume->cells[i].alive, c))
    return 0;
  if (listed)
    return listed[c] > 0 ? listed[c] : 0;
  return i == 3 || (i > 0 && !gmds_bits_get(&g->bounds[i], c));
}

static gmds_cell_type type_of(const gmds_complex *x, int i, size_t c, size_t n)
{
  if (i == 3)
    return (gmds_cell_type)x->types[c];
  if (i == 2)
    return n == 3 ? GMDS_TRIANGLE : n == 4 ? GMDS_QUADRILATERAL : GMDS_POLYGON;
  return i == 1 ? GMDS_SEGMENT : GMDS_VERTEX;
}

/* Turns the n nodes in the list as take_turn found them. */
static gmds_status turn_list(giving *g, int i, size_t c, int q)
{
  char room[NAME_SIZE];
  const gmds_attribute *turns = gmds_attribute_find(&g->volume->cells[i], name_of_turns(q, room));
  const size_t n = g->list.n;
  const int turn = turns && turns->type == GMDS_INT && turns->components == 1 ? ((const int *)turns->data)[c] : 0;
  if (turn <= 0 || (size_t)(turn / 2) >= n)
    return GMDS_OK;
  GMDS_TRY(gmds_ids_reserve(&g->list, 2 * n));
  memcpy(g->list.data + n, g->list.data, n * sizeof *g->list.data);
  for (size_t k = 0; k < n; k++)
    g->list.data[k] = g->list.data[n + ((size_t)(turn / 2) + (turn & 1 ? n - k : k)) % n];
  return GMDS_OK;
}

static gmds_status put_cell(giving *g, int i, size_t c, int time)
{
  const gmds_complex *x = &g->volume->complex;
  const gmds_csr *nodes = &x->nodes[i];
  gmds_id vertex = (gmds_id)c;
  const gmds_id *own = i ? nodes->data + nodes->begin[c] : &vertex;
  const size_t n = i ? nodes->begin[c + 1] - nodes->begin[c] : 1;
  g->list.n = 0;
  if (i == 3 && x->types[c] == GMDS_POLYHEDRON) {
    const size_t faces = x->walls.begin[c + 1] - x->walls.begin[c];
    GMDS_TRY(gmds_ids_push(&g->list, (gmds_id)faces));
    for (size_t k = 0; k < faces; k++) {
      const gmds_id f = x->walls.data[x->walls.begin[c] + k];
      GMDS_TRY(gmds_ids_push(&g->list, (gmds_id)(x->nodes[2].begin[f + 1] - x->nodes[2].begin[f])));
      for (size_t q = x->nodes[2].begin[f]; q < x->nodes[2].begin[f + 1]; q++)
        GMDS_TRY(gmds_ids_push(&g->list, g->number[x->nodes[2].data[q]]));
    }
  } else
    for (size_t k = 0; k < n; k++)
      GMDS_TRY(gmds_ids_push(&g->list, g->number[own[k]]));
  if (time && (i == 1 || i == 2))
    GMDS_TRY(turn_list(g, i, c, time));
  return gmds_soup_add_cell(g->soup, type_of(x, i, c, n), g->list.n, g->list.data);
}

static gmds_status put_cells(giving *g)
{
  const gmds_cells *nodes = &g->volume->cells[0];
  gmds_id fresh = 0;
  for (gmds_id v = gmds_cells_next(nodes, 0); v != GMDS_NONE; v = gmds_cells_next(nodes, v + 1)) {
    g->number[v] = fresh++;
    GMDS_TRY(gmds_soup_add_point(g->soup, g->volume->points + 3 * (size_t)v));
  }
  for (int i = 0; i < 4; i++) {
    const int *listed = times_listed(g, i);
    for (size_t c = 0; c < g->volume->cells[i].end; c++)
      for (int q = 0, n = times_written(g, i, listed, c); q < n; q++)
        GMDS_TRY(put_cell(g, i, c, q));
  }
  return GMDS_OK;
}

/* The column of the soup under a name, found or made. */
static gmds_status find_column(giving *g, int i, gmds_place place, const char *name, const gmds_attribute *a,
                               gmds_attribute **column, gmds_error *error)
{
  *column = gmds_soup_find_attribute(g->soup, place, name);
  if (!*column)
    return gmds_soup_add_attribute(g->soup, place, name, a->type, a->components, column);
  if ((*column)->type == a->type && (*column)->components == a->components)
    return GMDS_OK;
  return gmds_fail(error, GMDS_ERR_CONFLICT, "attribute '%s' has another type on cells of dimension %d", name, i);
}

/* Writes an attribute of the i-cells, NAME in the soup, beside the cells that begin at `at`. */
static void put_values(giving *g, int i, const gmds_attribute *a, const char *name, gmds_attribute *column, size_t at)
{
  const gmds_cells *cells = &g->volume->cells[i];
  const int *listed = times_listed(g, i);
  for (size_t c = 0; c < cells->end; c++) {
    const int n = times_written(g, i, listed, c);
    for (int q = 0; q < n; q++) {
      char room[NAME_SIZE];
      const gmds_attribute *from = q ? gmds_attribute_find(cells, name_on_cells(name, i, q, room)) : a;
      if (!from || from->type != a->type || from->components != a->components)
        from = a;
      memcpy((char *)column->data + at++ * a->bytes, (const char *)from->data + c * a->bytes, a->bytes);
    }
  }
}

static void put_point_values(giving *g, const gmds_attribute *a, gmds_attribute *column)
{
  const gmds_cells *nodes = &g->volume->cells[0];
  for (gmds_id v = gmds_cells_next(nodes, 0); v != GMDS_NONE; v = gmds_cells_next(nodes, v + 1))
    memcpy((char *)column->data + g->number[v] * a->bytes, (const char *)a->data + v * a->bytes, a->bytes);
}

static gmds_status put_attributes(giving *g, gmds_error *error)
{
  size_t before = 0; /* cells of lower dimension */
  for (int i = 0; i < 4; i++) {
    const gmds_cells *cells = &g->volume->cells[i];
    const int *listed = times_listed(g, i);
    for (const gmds_attribute *a = cells->attributes; a; a = a->next) {
      gmds_attribute *column = NULL;
      const int of_vertex = i == 0 && listed && !strncmp(a->name, VERTEX, strlen(VERTEX));
      const char *name = of_vertex ? a->name + strlen(VERTEX) : a->name;
      if (is_reserved(a->name) && !of_vertex)
        continue;
      GMDS_TRY(find_column(g, i, i || of_vertex ? GMDS_OF_CELLS : GMDS_OF_POINTS, name, a, &column, error));
      if (i || of_vertex)
        put_values(g, i, a, name, column, before);
      else
        put_point_values(g, a, column);
    }
    for (size_t c = 0; c < cells->end; c++)
      before += (size_t)times_written(g, i, listed, c);
  }
  return GMDS_OK;
}

gmds_status gmds_volume_to_soup(gmds_volume *volume, gmds_soup *soup, gmds_error *error)
{
  gmds_soup result;
  giving g = {.volume = volume, .soup = &result, .list = {.memory = soup->memory}};
  void *number = NULL;
  gmds_error first = {.status = GMDS_OK};
  gmds_soup_init(&result, soup->memory, 3);
  gmds_status status = volume->complex.rows.begin ? GMDS_OK : gmds_complex_join(&volume->complex, &first);
  if (status == GMDS_OK)
    status = mark_bounds(&volume->complex, g.bounds);
  if (status == GMDS_OK && !gmds_resize(soup->memory, &number, 0, volume->cells[0].end, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  g.number = number;
  if (status == GMDS_OK)
    status = put_cells(&g);
  if (status == GMDS_OK)
    status = put_attributes(&g, &first);
  gmds_release(soup->memory, number, number ? volume->cells[0].end : 0, sizeof(gmds_id));
  gmds_ids_clear(&g.list);
  for (int i = 1; i < 3; i++)
    if (g.bounds[i].memory)
      gmds_bits_clear(&g.bounds[i]);
  if (status == GMDS_OK) {
    gmds_soup_clear(soup);
    *soup = result;
    return status;
  }
  gmds_soup_clear(&result);
  if (first.status == GMDS_OK)
    gmds_fail(&first, status, "writing a mesh of volumes into a soup: %s", gmds_status_text(status));
  if (error)
    *error = first;
  return status;
}
