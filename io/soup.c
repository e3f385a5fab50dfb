/* The soup: points and cells in growing arrays, and columns of values that grow with them. */
#include <gmds/soup.h>
#include <string.h>

int gmds_cell_type_dimension(gmds_cell_type type)
{
#define DIMENSION(name, dim, points, text) dim,
  static const int dimensions[] = {GMDS_CELL_TYPE_LIST(DIMENSION)};
#undef DIMENSION
  return (unsigned)type < GMDS_CELL_TYPE_COUNT ? dimensions[type] : 0;
}

int gmds_cell_type_points(gmds_cell_type type)
{
#define POINTS(name, dim, points, text) points,
  static const int counts[] = {GMDS_CELL_TYPE_LIST(POINTS)};
#undef POINTS
  return (unsigned)type < GMDS_CELL_TYPE_COUNT ? counts[type] : 0;
}

const char *gmds_cell_type_text(gmds_cell_type type)
{
#define TEXT(name, dim, points, text) text,
  static const char *const texts[] = {GMDS_CELL_TYPE_LIST(TEXT)};
#undef TEXT
  return (unsigned)type < GMDS_CELL_TYPE_COUNT ? texts[type] : "unknown cell type";
}

/* `begin` has one entry more than there are cells, and none when there is no room for cells. */
static size_t begin_count(size_t cells)
{
  return cells ? cells + 1 : 0;
}

void gmds_soup_init(gmds_soup *soup, gmds_memory *memory, int dim)
{
  *soup = (gmds_soup){.memory = memory, .dim = dim};
}

void gmds_soup_clear(gmds_soup *soup)
{
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    while (soup->attributes[place])
      gmds_soup_remove_attribute(soup, (gmds_place)place, soup->attributes[place]);
  gmds_release(soup->memory, soup->points, soup->point_capacity, (size_t)soup->dim * sizeof *soup->points);
  gmds_release(soup->memory, soup->types, soup->cell_capacity, sizeof *soup->types);
  gmds_release(soup->memory, soup->begin, begin_count(soup->cell_capacity), sizeof *soup->begin);
  gmds_release(soup->memory, soup->corners, soup->corner_capacity, sizeof *soup->corners);
  gmds_soup_init(soup, soup->memory, soup->dim);
}

static size_t place_capacity(const gmds_soup *soup, gmds_place place)
{
  return place == GMDS_OF_POINTS ? soup->point_capacity : soup->cell_capacity;
}

/* Gives every column of a place another capacity. On failure, which happens in growing alone, all have the old one. */
static int resize_columns(gmds_soup *soup, gmds_place place, size_t old, size_t capacity)
{
  for (gmds_attribute *a = soup->attributes[place]; a; a = a->next)
    if (!gmds_resize(soup->memory, &a->data, old, capacity, a->bytes)) {
      for (gmds_attribute *b = soup->attributes[place]; b != a; b = b->next)
        (void)gmds_resize(soup->memory, &b->data, capacity, old, b->bytes);
      return 0;
    }
  return 1;
}

static void empty_row(gmds_soup *soup, gmds_place place, size_t row)
{
  for (gmds_attribute *a = soup->attributes[place]; a; a = a->next)
    memset((char *)a->data + row * a->bytes, 0, a->bytes);
}

static int set_point_capacity(gmds_soup *soup, size_t capacity)
{
  void *points = soup->points;
  if (!resize_columns(soup, GMDS_OF_POINTS, soup->point_capacity, capacity))
    return 0;
  if (!gmds_resize(soup->memory, &points, soup->point_capacity, capacity, (size_t)soup->dim * sizeof *soup->points)) {
    (void)resize_columns(soup, GMDS_OF_POINTS, capacity, soup->point_capacity);
    return 0;
  }
  soup->points = points;
  soup->point_capacity = capacity;
  return 1;
}

static int set_corner_capacity(gmds_soup *soup, size_t capacity)
{
  void *corners = soup->corners;
  if (!gmds_resize(soup->memory, &corners, soup->corner_capacity, capacity, sizeof *soup->corners))
    return 0;
  soup->corners = corners;
  soup->corner_capacity = capacity;
  return 1;
}

/* Types and begins change together or not at all, so both are made anew before the old ones go. */
static int set_cell_capacity(gmds_soup *soup, size_t capacity)
{
  if (capacity == SIZE_MAX)
    return 0;
  void *types = NULL, *begin = NULL;
  if (!gmds_resize(soup->memory, &types, 0, capacity, sizeof *soup->types))
    return 0;
  if (!gmds_resize(soup->memory, &begin, 0, begin_count(capacity), sizeof *soup->begin)) {
    gmds_release(soup->memory, types, capacity, sizeof *soup->types);
    return 0;
  }
  if (!resize_columns(soup, GMDS_OF_CELLS, soup->cell_capacity, capacity)) {
    gmds_release(soup->memory, types, capacity, sizeof *soup->types);
    gmds_release(soup->memory, begin, begin_count(capacity), sizeof *soup->begin);
    return 0;
  }
  if (soup->n_cells) {
    memcpy(types, soup->types, soup->n_cells * sizeof *soup->types);
    memcpy(begin, soup->begin, (soup->n_cells + 1) * sizeof *soup->begin);
  } else if (begin) {
    *(size_t *)begin = 0;
  }
  gmds_release(soup->memory, soup->types, soup->cell_capacity, sizeof *soup->types);
  gmds_release(soup->memory, soup->begin, begin_count(soup->cell_capacity), sizeof *soup->begin);
  soup->types = types;
  soup->begin = begin;
  soup->cell_capacity = capacity;
  return 1;
}

gmds_status gmds_soup_reserve(gmds_soup *soup, size_t points, size_t cells, size_t corners)
{
  if (points > soup->point_capacity && !set_point_capacity(soup, points))
    return GMDS_ERR_MEMORY;
  if (cells > soup->cell_capacity && !set_cell_capacity(soup, cells))
    return GMDS_ERR_MEMORY;
  if (corners > soup->corner_capacity && !set_corner_capacity(soup, corners))
    return GMDS_ERR_MEMORY;
  return GMDS_OK;
}

gmds_status gmds_soup_add_point(gmds_soup *soup, const double *x)
{
  if (soup->n_points >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  if (soup->n_points == soup->point_capacity &&
      !set_point_capacity(soup, gmds_grown(soup->point_capacity, soup->n_points + 1)))
    return GMDS_ERR_MEMORY;
  memcpy(soup->points + soup->n_points * (size_t)soup->dim, x, (size_t)soup->dim * sizeof *x);
  empty_row(soup, GMDS_OF_POINTS, soup->n_points++);
  return GMDS_OK;
}

/* Whether the n entries are a polyhedron's: its faces, their counts, and nothing behind them. */
static int is_polyhedron(size_t n, const gmds_id *stream)
{
  if (!n || stream[0] < 4)
    return 0;
  size_t at = 1;
  for (gmds_id face = 0; face < stream[0]; face++) {
    if (at == n || stream[at] < 3 || stream[at] > n - at - 1)
      return 0;
    at += 1 + (size_t)stream[at];
  }
  return at == n;
}

static int are_points(const gmds_soup *soup, size_t n, const gmds_id *corners)
{
  for (size_t k = 0; k < n; k++)
    if (corners[k] >= soup->n_points)
      return 0;
  return 1;
}

static gmds_status check_cell(const gmds_soup *soup, gmds_cell_type type, size_t n, const gmds_id *corners)
{
  if ((unsigned)type >= GMDS_CELL_TYPE_COUNT)
    return GMDS_ERR_ARGUMENT;
  if (type == GMDS_POLYHEDRON) {
    if (!is_polyhedron(n, corners))
      return GMDS_ERR_ARGUMENT;
    for (size_t at = 1; at < n; at += 1 + (size_t)corners[at])
      if (!are_points(soup, corners[at], corners + at + 1))
        return GMDS_ERR_CELL;
    return GMDS_OK;
  }
  if (type == GMDS_POLYGON ? n < 3 : n != (size_t)gmds_cell_type_points(type))
    return GMDS_ERR_ARGUMENT;
  return are_points(soup, n, corners) ? GMDS_OK : GMDS_ERR_CELL;
}

gmds_status gmds_soup_add_cell(gmds_soup *soup, gmds_cell_type type, size_t n, const gmds_id *corners)
{
  GMDS_TRY(check_cell(soup, type, n, corners));
  size_t used = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  if (soup->n_cells >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  if (n > SIZE_MAX - used)
    return GMDS_ERR_MEMORY;
  if (soup->n_cells == soup->cell_capacity &&
      !set_cell_capacity(soup, gmds_grown(soup->cell_capacity, soup->n_cells + 1)))
    return GMDS_ERR_MEMORY;
  if (used + n > soup->corner_capacity && !set_corner_capacity(soup, gmds_grown(soup->corner_capacity, used + n)))
    return GMDS_ERR_MEMORY;
  memcpy(soup->corners + used, corners, n * sizeof *corners);
  soup->types[soup->n_cells] = (uint8_t)type;
  empty_row(soup, GMDS_OF_CELLS, soup->n_cells++);
  soup->begin[soup->n_cells] = used + n;
  return GMDS_OK;
}

gmds_status gmds_soup_cell_points(const gmds_soup *soup, size_t cell, gmds_ids *points)
{
  const gmds_id *corners = soup->corners + soup->begin[cell];
  size_t n = soup->begin[cell + 1] - soup->begin[cell];
  GMDS_TRY(gmds_ids_reserve(points, n));
  points->n = 0;
  if (soup->types[cell] != GMDS_POLYHEDRON) {
    memcpy(points->data, corners, n * sizeof *corners);
    points->n = n;
    return GMDS_OK;
  }
  for (size_t at = 1; at < n; at += 1 + (size_t)corners[at]) {
    memcpy(points->data + points->n, corners + at + 1, corners[at] * sizeof *corners);
    points->n += corners[at];
  }
  gmds_ids_keep(points, 0, 1, GMDS_NONE);
  return GMDS_OK;
}

gmds_attribute *gmds_soup_find_attribute(const gmds_soup *soup, gmds_place place, const char *name)
{
  gmds_attribute *a = (unsigned)place < GMDS_PLACE_COUNT ? soup->attributes[place] : NULL;
  while (a && strcmp(a->name, name) != 0)
    a = a->next;
  return a;
}

gmds_status gmds_soup_add_attribute(gmds_soup *soup, gmds_place place, const char *name, gmds_value type,
                                    size_t components, gmds_attribute **attribute)
{
  if ((unsigned)place >= GMDS_PLACE_COUNT)
    return GMDS_ERR_ARGUMENT;
  if (name && gmds_soup_find_attribute(soup, place, name))
    return GMDS_ERR_CONFLICT;
  GMDS_TRY(gmds_attribute_make(soup->memory, name, type, components, place_capacity(soup, place), attribute));
  gmds_attribute **link = &soup->attributes[place];
  while (*link)
    link = &(*link)->next;
  *link = *attribute;
  return GMDS_OK;
}

void gmds_soup_remove_attribute(gmds_soup *soup, gmds_place place, gmds_attribute *attribute)
{
  gmds_attribute **link = &soup->attributes[place];
  while (*link && *link != attribute)
    link = &(*link)->next;
  if (!*link)
    return;
  *link = attribute->next;
  gmds_attribute_free(soup->memory, attribute, place_capacity(soup, place));
}

void gmds_soup_trim(gmds_soup *soup)
{
  if (soup->point_capacity > soup->n_points)
    (void)set_point_capacity(soup, soup->n_points);
  if (soup->corner_capacity > (soup->n_cells ? soup->begin[soup->n_cells] : 0))
    (void)set_corner_capacity(soup, soup->n_cells ? soup->begin[soup->n_cells] : 0);
  if (soup->cell_capacity > soup->n_cells)
    (void)set_cell_capacity(soup, soup->n_cells);
}

gmds_id *gmds_soup_give_corners(gmds_soup *soup, size_t *n)
{
  *n = soup->n_cells ? soup->begin[soup->n_cells] : 0;
  (void)set_corner_capacity(soup, *n); /* fewer: it does not fail */
  gmds_id *corners = soup->corners;
  soup->corners = NULL;
  soup->corner_capacity = 0;
  soup->n_cells = 0;
  (void)set_cell_capacity(soup, 0);
  return corners;
}

void gmds_soup_count(const gmds_soup *soup, size_t count[4])
{
  for (int d = 0; d < 4; d++)
    count[d] = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    count[gmds_cell_type_dimension((gmds_cell_type)soup->types[c])]++;
}
