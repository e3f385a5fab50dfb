/* Writer of Gmsh's MSH, versions 4.1 and 2.2, ASCII and binary. Nodes and elements are numbered from 1 in the order of
 * the soup. The tags of a cell are the attributes "physical" and "geometrical"; version 4.1 gives them by way of an
 * entity, which is the geometrical tag of a dimension and can have one physical one; where it has several and no
 * version was asked for, it is 2.2. Other attributes are views. */
#include "gmsh.h"
#include "writers.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static int gmsh_number(unsigned type)
{
#define ROW(number, type) [type] = number,
  static const int numbers[GMDS_CELL_TYPE_COUNT] = {GMDS_GMSH_TYPE_LIST(ROW)};
#undef ROW
  return numbers[type];
}

/* Numbers of a row, a blank between them where they are text. */
static void put_int(const gmds_sink *sink, int x)
{
  if (sink->binary)
    gmds_put_word(sink->file, (uint32_t)x, 4, 1);
  else
    fprintf(sink->file, "%d ", x);
}

static void put_size(const gmds_sink *sink, uint64_t x)
{
  if (sink->binary)
    gmds_put_word(sink->file, x, 8, 1);
  else
    fprintf(sink->file, "%" PRIu64 " ", x);
}

static void put_real(const gmds_sink *sink, double x)
{
  char text[GMDS_DOUBLE_TEXT];
  if (sink->binary)
    gmds_put_double(sink->file, x, 1);
  else
    fprintf(sink->file, "%.*s ", (int)gmds_print_value(text, GMDS_DOUBLE, &x), text);
}

/* A node's or element's number: a size in version 4.1, an int in 2.2. */
static void put_number(const gmds_sink *sink, uint64_t x)
{
  if (sink->version < 40 && sink->binary)
    gmds_put_word(sink->file, x, 4, 1);
  else
    put_size(sink, x);
}

static void end_row(const gmds_sink *sink)
{
  if (!sink->binary)
    putc('\n', sink->file);
}

/* Words are followed by the end of a line. */
static void end_section(const gmds_sink *sink, const char *name)
{
  fprintf(sink->file, "%s$End%s\n", sink->binary ? "\n" : "", name);
}

/* What version 4.1 calls an entity: the cells of one geometrical tag and dimension. */
typedef struct entity {
  uint64_t key; /* the dimension in the upper half, the tag in the lower */
  int physical, seen;
  double low[3], high[3];
} entity;

typedef struct mesh {
  gmds_sink *sink;
  const gmds_attribute *physical, *geometrical; /* NULL: there is none */
  entity *entities;
  size_t n, capacity;
} mesh;

static int dimension_of(const mesh *m, size_t cell)
{
  return gmds_cell_type_dimension((gmds_cell_type)m->sink->soup->types[cell]);
}

/* Without any tag all cells of a dimension are one entity, 1; with physical ones alone an entity is a group. */
static int entity_of(const mesh *m, size_t cell)
{
  return m->geometrical ? gmds_reference(m->geometrical, cell) : m->physical ? gmds_reference(m->physical, cell) : 1;
}

static uint64_t key_of(const mesh *m, size_t cell)
{
  return (uint64_t)(unsigned)dimension_of(m, cell) << 32 | (uint32_t)entity_of(m, cell);
}

static int by_key(const void *a, const void *b)
{
  uint64_t x = ((const entity *)a)->key, y = ((const entity *)b)->key;
  return (x > y) - (x < y);
}

static entity *find_entity(const mesh *m, uint64_t key)
{
  entity wanted = {.key = key};
  return bsearch(&wanted, m->entities, m->n, sizeof wanted, by_key);
}

/* Sorts the keys there are and keeps each once. */
static void keep_once(mesh *m)
{
  size_t kept = 0;
  if (m->n > 1)
    qsort(m->entities, m->n, sizeof *m->entities, by_key);
  for (size_t k = 0; k < m->n; k++)
    if (!k || m->entities[k].key != m->entities[kept - 1].key)
      m->entities[kept++] = m->entities[k];
  m->n = kept;
}

static gmds_status push_entity(mesh *m, uint64_t key)
{
  int full = m->n == m->capacity;
  if (full)
    keep_once(m);
  if (full && m->n >= m->capacity / 2) {
    void *entities = m->entities;
    size_t wanted = gmds_grown(m->capacity, 2 * m->capacity + 1);
    if (!gmds_resize(m->sink->soup->memory, &entities, m->capacity, wanted, sizeof *m->entities))
      return gmds_sink_fail(m->sink, GMDS_ERR_MEMORY, "%s", gmds_status_text(GMDS_ERR_MEMORY));
    m->entities = entities;
    m->capacity = wanted;
  }
  m->entities[m->n++] = (entity){.key = key};
  return GMDS_OK;
}

/* Adds the points of a cell to the box of its entity. */
static void extend_box(const mesh *m, entity *e, size_t cell)
{
  const gmds_soup *soup = m->sink->soup;
  for (size_t i = soup->begin[cell]; i < soup->begin[cell + 1]; i++)
    for (int k = 0; k < 3; k++) {
      double x = gmds_coordinate(soup, soup->corners[i], k);
      int first = !e->seen && i == soup->begin[cell];
      e->low[k] = first || x < e->low[k] ? x : e->low[k];
      e->high[k] = first || x > e->high[k] ? x : e->high[k];
    }
}

/* Gives each entity its physical tag and its box. With two tags for one, the version becomes 2.2 or the call fails. */
static gmds_status describe_entities(mesh *m)
{
  for (size_t c = 0; c < m->sink->soup->n_cells; c++) {
    entity *e = find_entity(m, key_of(m, c));
    int physical = gmds_reference(m->physical, c);
    extend_box(m, e, c);
    if (e->seen && e->physical != physical) {
      if (m->sink->asked)
        return gmds_sink_fail(m->sink, GMDS_ERR_UNSUPPORTED,
                              "cells of dimension %d with the geometrical tag %d have the physical tags %d and %d: "
                              "Gmsh 4.1 has one, 2.2 has any",
                              dimension_of(m, c), entity_of(m, c), e->physical, physical);
      m->sink->version = 22;
      return GMDS_OK;
    }
    e->physical = physical;
    e->seen = 1;
  }
  return GMDS_OK;
}

static gmds_status find_entities(mesh *m)
{
  const gmds_soup *soup = m->sink->soup;
  uint64_t last = 0;
  for (size_t c = 0; c < soup->n_cells; c++) {
    uint64_t key = key_of(m, c);
    if (!c || key != last)
      GMDS_TRY(push_entity(m, key));
    last = key;
  }
  if (!soup->n_cells) /* the nodes must be of one */
    GMDS_TRY(push_entity(m, (uint64_t)(unsigned)soup->dim << 32 | 1));
  keep_once(m);
  return describe_entities(m);
}

static void write_entities(const mesh *m)
{
  const gmds_sink *sink = m->sink;
  size_t n[4] = {0};
  fputs("$Entities\n", sink->file);
  for (size_t k = 0; k < m->n; k++)
    n[m->entities[k].key >> 32]++;
  for (int dim = 0; dim < 4; dim++)
    put_size(sink, n[dim]);
  end_row(sink);
  for (size_t k = 0; k < m->n; k++) {
    const entity *e = &m->entities[k];
    int dim = (int)(e->key >> 32);
    put_int(sink, (int)(int32_t)(uint32_t)e->key);
    for (int j = 0; j < (dim ? 6 : 3); j++)
      put_real(sink, j < 3 ? e->low[j] : e->high[j - 3]);
    put_size(sink, e->physical != 0);
    if (e->physical)
      put_int(sink, e->physical);
    if (dim)
      put_size(sink, 0);
    end_row(sink);
  }
  end_section(sink, "Entities");
}

static void write_point(const gmds_sink *sink, size_t point)
{
  for (int k = 0; k < 3; k++)
    put_real(sink, gmds_coordinate(sink->soup, point, k));
  end_row(sink);
}

/* All nodes are of one entity of the highest dimension. */
static void write_nodes_4(const mesh *m)
{
  const gmds_sink *sink = m->sink;
  size_t n = sink->soup->n_points, first = m->n - 1;
  while (first && m->entities[first - 1].key >> 32 == m->entities[first].key >> 32)
    first--;
  fputs("$Nodes\n", sink->file);
  put_size(sink, n != 0);
  put_size(sink, n);
  put_size(sink, n != 0);
  put_size(sink, n);
  end_row(sink);
  if (n) {
    put_int(sink, (int)(m->entities[first].key >> 32));
    put_int(sink, (int)(int32_t)(uint32_t)m->entities[first].key);
    put_int(sink, 0);
    put_size(sink, n);
    end_row(sink);
  }
  for (size_t p = 0; p < n; p++) {
    put_size(sink, p + 1);
    end_row(sink);
  }
  for (size_t p = 0; p < n; p++)
    write_point(sink, p);
  end_section(sink, "Nodes");
}

static void write_nodes_2(const gmds_sink *sink)
{
  fprintf(sink->file, "$Nodes\n%zu\n", sink->soup->n_points);
  for (size_t p = 0; p < sink->soup->n_points; p++) {
    put_number(sink, p + 1);
    write_point(sink, p);
  }
  end_section(sink, "Nodes");
}

/* How many cells from this one on go in one block: of one type, in version 4.1 of one entity. */
static size_t run_of(const mesh *m, size_t cell)
{
  const gmds_soup *soup = m->sink->soup;
  size_t c = cell + 1;
  while (c < soup->n_cells && soup->types[c] == soup->types[cell] &&
         (m->sink->version < 40 || key_of(m, c) == key_of(m, cell)))
    c++;
  return c - cell;
}

static void write_corners(const gmds_sink *sink, size_t cell)
{
  const gmds_soup *soup = sink->soup;
  for (size_t k = soup->begin[cell]; k < soup->begin[cell + 1]; k++)
    put_number(sink, (uint64_t)soup->corners[k] + 1);
  end_row(sink);
}

static void write_elements_4(const mesh *m)
{
  const gmds_sink *sink = m->sink;
  const gmds_soup *soup = sink->soup;
  size_t blocks = 0;
  for (size_t c = 0; c < soup->n_cells; c += run_of(m, c))
    blocks++;
  fputs("$Elements\n", sink->file);
  put_size(sink, blocks);
  put_size(sink, soup->n_cells);
  put_size(sink, soup->n_cells != 0);
  put_size(sink, soup->n_cells);
  end_row(sink);
  for (size_t c = 0, n; c < soup->n_cells; c += n) {
    n = run_of(m, c);
    put_int(sink, dimension_of(m, c));
    put_int(sink, entity_of(m, c));
    put_int(sink, gmsh_number(soup->types[c]));
    put_size(sink, n);
    end_row(sink);
    for (size_t k = c; k < c + n; k++) {
      put_size(sink, k + 1);
      write_corners(sink, k);
    }
  }
  end_section(sink, "Elements");
}

/* Two tags an element; 0 is none. */
static void write_elements_2(const mesh *m)
{
  const gmds_sink *sink = m->sink;
  const gmds_soup *soup = sink->soup;
  fprintf(sink->file, "$Elements\n%zu\n", soup->n_cells);
  for (size_t c = 0, n; c < soup->n_cells; c += n) {
    n = sink->binary ? run_of(m, c) : 1;
    if (!sink->binary)
      put_number(sink, c + 1);
    put_int(sink, gmsh_number(soup->types[c]));
    if (sink->binary)
      put_int(sink, (int)n);
    put_int(sink, 2);
    for (size_t k = c; k < c + n; k++) {
      if (sink->binary)
        put_number(sink, k + 1);
      put_int(sink, gmds_reference(m->physical, k));
      put_int(sink, gmds_reference(m->geometrical, k));
      write_corners(sink, k);
    }
  }
  end_section(sink, "Elements");
}

/* `"name"`, one real tag, three integer tags, then a number and the values of each row. */
static void write_view(const mesh *m, gmds_place place, const gmds_attribute *a, const char *section)
{
  const gmds_sink *sink = m->sink;
  size_t rows = gmds_rows_of(sink->soup, place), bytes = gmds_value_bytes(a->type);
  fprintf(sink->file, "$%s\n1\n\"%s\"\n1\n0\n3\n0\n%zu\n%zu\n", section, a->name, a->components, rows);
  for (size_t row = 0; row < rows; row++) {
    put_int(sink, (int)(row + 1));
    for (size_t k = 0; k < a->components; k++)
      put_real(sink, gmds_value_real(a->type, (const char *)a->data + row * a->bytes + k * bytes));
    end_row(sink);
  }
  end_section(sink, section);
}

static gmds_status write_sections(mesh *m)
{
  const gmds_sink *sink = m->sink;
  if (sink->version > 40)
    GMDS_TRY(find_entities(m));
  fprintf(sink->file, "$MeshFormat\n%s %d 8\n", sink->version < 40 ? "2.2" : "4.1", sink->binary);
  if (sink->binary)
    put_int(sink, 1);
  end_section(sink, "MeshFormat");
  if (sink->version < 40) {
    write_nodes_2(sink);
    write_elements_2(m);
  } else {
    write_entities(m);
    write_nodes_4(m);
    write_elements_4(m);
  }
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = sink->soup->attributes[place]; a; a = a->next)
      if (a != m->physical && a != m->geometrical && gmds_gmsh_holds(sink->soup, (gmds_place)place, a))
        write_view(m, (gmds_place)place, a, place == GMDS_OF_POINTS ? "NodeData" : "ElementData");
  return GMDS_OK;
}

/* The column of a name where it can be tags. */
static const gmds_attribute *tags_of(const gmds_soup *soup, const char *name)
{
  const gmds_attribute *a = gmds_soup_find_attribute(soup, GMDS_OF_CELLS, name);
  return a && gmds_is_reference(soup, GMDS_OF_CELLS, a) ? a : NULL;
}

gmds_status gmds_write_gmsh(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  gmds_sink own = *sink;
  mesh m = {.sink = &own, .physical = tags_of(soup, "physical"), .geometrical = tags_of(soup, "geometrical")};
  if (soup->n_points > INT32_MAX || soup->n_cells > INT32_MAX)
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "Gmsh has numbers of 32 bits, which are too few");
  gmds_status status = write_sections(&m);
  gmds_release(soup->memory, m.entities, m.capacity, sizeof *m.entities);
  return status;
}

int gmds_gmsh_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  int is_tag = strcmp(attribute->name, "physical") == 0 || strcmp(attribute->name, "geometrical") == 0;
  if (place == GMDS_OF_CELLS && is_tag && gmds_is_reference(soup, place, attribute))
    return 1;
  if (attribute->components != 1 && attribute->components != 3 && attribute->components != 9)
    return 0;
  for (const char *s = attribute->name; *s; s++)
    if ((unsigned char)*s < ' ' || *s == '"')
      return 0;
  size_t n = gmds_rows_of(soup, place) * attribute->components, bytes = gmds_value_bytes(attribute->type);
  for (size_t k = 0; k < n; k++)
    if (!gmds_value_is_double(attribute->type, (const char *)attribute->data + k * bytes))
      return 0;
  return gmds_vtk_holds(soup, place, attribute);
}
