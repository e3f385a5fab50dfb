/* PLY, ASCII and binary of both orders of bytes: the header says which elements there are and of which numbers each is
 * made. Vertices, faces, edges and strips of triangles become points and cells; their other single numbers become
 * attributes. Lists that are not of points, and other elements, are counted and left out. */
#include "readers.h"
#include "vtk.h"
#include <string.h>

/* X(name, kind, bytes) */
#define TYPE_LIST(X)                \
  X("char", GMDS_VTK_SIGNED, 1)     \
  X("int8", GMDS_VTK_SIGNED, 1)     \
  X("uchar", GMDS_VTK_UNSIGNED, 1)  \
  X("uint8", GMDS_VTK_UNSIGNED, 1)  \
  X("short", GMDS_VTK_SIGNED, 2)    \
  X("int16", GMDS_VTK_SIGNED, 2)    \
  X("ushort", GMDS_VTK_UNSIGNED, 2) \
  X("uint16", GMDS_VTK_UNSIGNED, 2) \
  X("int", GMDS_VTK_SIGNED, 4)      \
  X("int32", GMDS_VTK_SIGNED, 4)    \
  X("uint", GMDS_VTK_UNSIGNED, 4)   \
  X("uint32", GMDS_VTK_UNSIGNED, 4) \
  X("float", GMDS_VTK_REAL, 4)      \
  X("float32", GMDS_VTK_REAL, 4)    \
  X("double", GMDS_VTK_REAL, 8)     \
  X("float64", GMDS_VTK_REAL, 8)

typedef enum ply_kind { VERTICES, FACES, EDGES, STRIPS, OTHER } ply_kind;

/* What a number of a row is: a coordinate, an end of an edge, the list of a face's points, an attribute, or nothing. */
typedef enum use { X, Y, Z, END_1, END_2, CORNERS, ATTRIBUTE, NOTHING } use;

typedef struct property {
  use use;
  int list;
  gmds_vtk_type count, type;
  gmds_attribute *column; /* of ATTRIBUTE */
} property;

/* One element of the header; all its properties are read before its rows. */
typedef struct element {
  ply_kind kind;
  uint64_t n;
  size_t first, end; /* of its properties */
} element;

enum { MOST_PROPERTIES = 200, MOST_ELEMENTS = 100 };

typedef struct ply {
  gmds_text *text;
  gmds_stage *stage;
  gmds_vtk_block block; /* the numbers: its type changes with each */
  element elements[MOST_ELEMENTS];
  size_t n_elements, n_properties;
  property properties[MOST_PROPERTIES];
} ply;

static gmds_status read_format(ply *p)
{
  gmds_token token;
  gmds_text_next_on_line(p->text, &token);
  p->block.binary = !gmds_token_is(token, "ascii");
  p->block.little = gmds_token_is(token, "binary_little_endian");
  if (p->block.binary && !p->block.little && !gmds_token_is(token, "binary_big_endian"))
    return gmds_text_expected(p->text, "ascii, binary_little_endian or binary_big_endian", token);
  gmds_text_next_on_line(p->text, &token);
  return gmds_token_is(token, "1.0") ? GMDS_OK : gmds_text_expected(p->text, "1.0", token);
}

static gmds_status read_type(ply *p, gmds_token token, gmds_vtk_type *type)
{
#define ROW(name, kind, bytes) {name, kind, bytes},
  static const gmds_vtk_type rows[] = {TYPE_LIST(ROW)};
#undef ROW
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is(token, rows[i].name)) {
      *type = rows[i];
      return GMDS_OK;
    }
  return gmds_text_expected(p->text, "a type of numbers", token);
}

/* `element vertex 8` */
static gmds_status read_element(ply *p)
{
  static const char *const names[] = {"vertex", "face", "edge", "tristrips"};
  gmds_token name;
  element e = {.first = p->n_properties, .end = p->n_properties};
  if (p->n_elements == MOST_ELEMENTS)
    return gmds_text_fail(p->text, GMDS_ERR_UNSUPPORTED, -1, "more than %d elements", MOST_ELEMENTS);
  if (!gmds_text_next_on_line(p->text, &name))
    return gmds_text_expected(p->text, "the name of an element", name);
  GMDS_TRY(gmds_text_next_whole(p->text, "a number of elements", &e.n));
  while (e.kind < OTHER && !gmds_token_is(name, names[e.kind]))
    e.kind++;
  for (size_t k = 0; k < p->n_elements; k++)
    if (e.kind == VERTICES && p->elements[k].kind == VERTICES)
      return gmds_text_fail(p->text, GMDS_ERR_FORMAT, -1, "vertices are listed a second time");
  p->stage->soup.unread += e.kind == OTHER;
  p->elements[p->n_elements++] = e;
  return GMDS_OK;
}

static use use_of(ply_kind kind, int list, gmds_token name)
{
  static const struct {
    const char *name;
    use use;
    unsigned char list, kind;
  } rows[] = {{"x", X, 0, VERTICES},
              {"y", Y, 0, VERTICES},
              {"z", Z, 0, VERTICES},
              {"vertex1", END_1, 0, EDGES},
              {"vertex2", END_2, 0, EDGES},
              {"vertex_indices", CORNERS, 1, FACES},
              {"vertex_index", CORNERS, 1, FACES},
              {"vertex_indices", CORNERS, 1, STRIPS},
              {"vertex_index", CORNERS, 1, STRIPS}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (rows[i].kind == kind && rows[i].list == list && gmds_token_is(name, rows[i].name))
      return rows[i].use;
  return list || kind == OTHER ? NOTHING : ATTRIBUTE;
}

/* The column of an attribute, which faces and edges may share. */
static gmds_status find_column(ply *p, ply_kind kind, gmds_token name, property *q)
{
  char text[256];
  gmds_place place = kind == VERTICES ? GMDS_OF_POINTS : GMDS_OF_CELLS;
  gmds_value type = gmds_vtk_value_type(q->type);
  size_t n = name.n < sizeof text ? name.n : 0;
  memcpy(text, name.at, n);
  text[n] = 0;
  q->column = gmds_soup_find_attribute(&p->stage->soup, place, text);
  if (q->column && q->column->type == type) {
    const element *e = &p->elements[p->n_elements - 1];
    for (size_t k = e->first; k < p->n_properties; k++)
      if (p->properties[k].column == q->column) /* refused */
        return gmds_stage_column(p->stage, p->text, place, name, type, 1, &q->column);
    return GMDS_OK;
  }
  return gmds_stage_column(p->stage, p->text, place, name, type, 1, &q->column);
}

/* `property float x`, `property list uchar int vertex_indices` */
static gmds_status read_property(ply *p)
{
  property q = {.list = 0};
  gmds_token token;
  if (!p->n_elements)
    return gmds_text_fail(p->text, GMDS_ERR_FORMAT, -1, "a property before any element");
  if (p->n_properties == MOST_PROPERTIES)
    return gmds_text_fail(p->text, GMDS_ERR_UNSUPPORTED, -1, "more than %d properties", MOST_PROPERTIES);
  element *e = &p->elements[p->n_elements - 1];
  gmds_text_next_on_line(p->text, &token);
  q.list = gmds_token_is(token, "list");
  if (q.list) {
    gmds_text_next_on_line(p->text, &token);
    GMDS_TRY(read_type(p, token, &q.count));
    if (q.count.kind == GMDS_VTK_REAL)
      return gmds_text_expected(p->text, "a type of whole numbers", token);
    gmds_text_next_on_line(p->text, &token);
  }
  GMDS_TRY(read_type(p, token, &q.type));
  if (!gmds_text_next_on_line(p->text, &token))
    return gmds_text_expected(p->text, "the name of a property", token);
  q.use = use_of(e->kind, q.list, token);
  for (size_t k = e->first; k < p->n_properties; k++)
    if (q.use < ATTRIBUTE && p->properties[k].use == q.use)
      return gmds_text_fail(p->text, GMDS_ERR_FORMAT, -1, "a property is there a second time");
  if (q.use == ATTRIBUTE)
    GMDS_TRY(find_column(p, e->kind, token, &q));
  p->stage->soup.unread += q.use == NOTHING && e->kind != OTHER;
  p->properties[p->n_properties++] = q;
  e->end = p->n_properties;
  return GMDS_OK;
}

static gmds_status read_header(ply *p)
{
  gmds_token token;
  gmds_text *text = p->text;
  GMDS_TRY(gmds_text_word(text, "ply"));
  GMDS_TRY(gmds_text_word(text, "format"));
  GMDS_TRY(read_format(p));
  for (;;) {
    gmds_text_next(text, &token);
    if (gmds_token_is(token, "end_header"))
      break;
    if (gmds_token_is(token, "comment") || gmds_token_is(token, "obj_info")) {
      gmds_text_skip_line(text);
      continue;
    }
    if (gmds_token_is(token, "element"))
      GMDS_TRY(read_element(p));
    else if (gmds_token_is(token, "property"))
      GMDS_TRY(read_property(p));
    else
      return gmds_text_expected(text, "element, property or end_header", token);
    GMDS_TRY(gmds_text_end_of_line(text));
  }
  GMDS_TRY(gmds_text_end_of_line(text));
  gmds_text_skip_line(text);
  text->binary = p->block.binary;
  p->block.text = *text;
  return GMDS_OK;
}

/* Makes the block hold one more number of a type, if the file does. */
static gmds_status expect(ply *p, gmds_vtk_type type)
{
  p->block.type = type;
  p->block.left = 1;
  if (p->block.binary && gmds_text_left(&p->block.text) < (size_t)type.bytes)
    return gmds_text_fail(&p->block.text, GMDS_ERR_FORMAT, -1, "expected a number, found the end of the file");
  return GMDS_OK;
}

/* A list that makes no cell. */
static gmds_status skip_list(ply *p, gmds_vtk_type type, uint64_t n)
{
  double ignored;
  int64_t whole;
  for (uint64_t k = 0; k < n; k++) {
    GMDS_TRY(expect(p, type));
    if (type.kind == GMDS_VTK_REAL)
      GMDS_TRY(gmds_vtk_value(&p->block, GMDS_DOUBLE, &ignored));
    else
      GMDS_TRY(gmds_vtk_value(&p->block, GMDS_LONG, &whole));
  }
  return GMDS_OK;
}

/* The indices of a list into stage->corners; -1 ends a strip, and is GMDS_NONE there. */
static gmds_status read_corners(ply *p, const property *q, ply_kind kind, uint64_t n)
{
  size_t points = p->stage->soup.n_points;
  GMDS_TRY(gmds_stage_corners(p->stage, &p->block.text, (size_t)n));
  for (size_t k = 0; k < (size_t)n; k++) {
    int64_t x = 0;
    gmds_id *corner = &p->stage->corners.data[k];
    GMDS_TRY(expect(p, q->type));
    if (kind != STRIPS) {
      GMDS_TRY(gmds_vtk_index(&p->block, points, corner));
      continue;
    }
    GMDS_TRY(gmds_vtk_value(&p->block, GMDS_LONG, &x));
    if (x < -1 || x >= (int64_t)points)
      return gmds_text_fail(&p->block.text, GMDS_ERR_FORMAT, -1, "expected an index below %zu or -1, found %lld",
                            points, (long long)x);
    *corner = x < 0 ? GMDS_NONE : (gmds_id)x;
  }
  return GMDS_OK;
}

static gmds_status read_list(ply *p, const property *q, ply_kind kind)
{
  uint64_t n = 0;
  GMDS_TRY(expect(p, q->count));
  GMDS_TRY(gmds_vtk_whole(&p->block, "a number of a list", &n));
  GMDS_TRY(gmds_text_bound(&p->block.text, n, p->block.binary ? (size_t)q->type.bytes : 2, "numbers of a list"));
  return q->use == CORNERS ? read_corners(p, q, kind, n) : skip_list(p, q->type, n);
}

/* Triangles of a strip, every second one turned around, up to the next GMDS_NONE. */
static gmds_status add_strips(ply *p)
{
  const gmds_ids *corners = &p->stage->corners;
  for (size_t k = 0, first = 0; k < corners->n; k++) {
    if (corners->data[k] == GMDS_NONE)
      first = k + 1;
    if (k < first + 2 || corners->data[k] == GMDS_NONE)
      continue;
    size_t turned = (k - first) % 2;
    const gmds_id run[] = {corners->data[k - 2 + turned], corners->data[k - 1 - turned], corners->data[k]};
    GMDS_TRY(gmds_stage_cell(p->stage, &p->block.text, GMDS_TRIANGLE, 3, run));
  }
  return GMDS_OK;
}

static gmds_status add_item(ply *p, ply_kind kind, const double x[3], const gmds_id ends[2])
{
  gmds_stage *stage = p->stage;
  size_t n = stage->corners.n;
  const gmds_text *text = &p->block.text;
  switch (kind) {
  case VERTICES:
    return gmds_stage_point(stage, text, x);
  case EDGES:
    return gmds_stage_cell(stage, text, GMDS_SEGMENT, 2, ends);
  case STRIPS:
    return add_strips(p);
  case FACES:
    if (n < 3)
      return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)stage->soup.n_cells, "a face of %zu points", n);
    return gmds_stage_cell(stage, text,
                           n == 3   ? GMDS_TRIANGLE
                           : n == 4 ? GMDS_QUADRILATERAL
                                    : GMDS_POLYGON,
                           n, stage->corners.data);
  default:
    return GMDS_OK;
  }
}

/* One row: its numbers, then what they make, then the attributes of that. */
static gmds_status read_row(ply *p, const element *e)
{
  double x[3] = {0}, values[MOST_PROPERTIES];
  gmds_id ends[2] = {0};
  gmds_place place = e->kind == VERTICES ? GMDS_OF_POINTS : GMDS_OF_CELLS;
  for (size_t k = e->first; k < e->end; k++) {
    const property *q = &p->properties[k];
    if (q->list) {
      GMDS_TRY(read_list(p, q, e->kind));
      continue;
    }
    GMDS_TRY(expect(p, q->type));
    if (q->use <= Z)
      GMDS_TRY(gmds_vtk_real(&p->block, p->stage->soup.n_points, &x[q->use]));
    else if (q->use <= END_2)
      GMDS_TRY(gmds_vtk_index(&p->block, p->stage->soup.n_points, &ends[q->use - END_1]));
    else
      GMDS_TRY(gmds_vtk_value(&p->block, gmds_vtk_value_type(q->type), &values[k]));
  }
  if (e->kind != VERTICES && e->kind != OTHER)
    GMDS_TRY(gmds_stage_mark(p->stage, &p->block.text));
  GMDS_TRY(add_item(p, e->kind, x, ends));
  for (size_t k = e->first; k < e->end; k++)
    if (p->properties[k].use == ATTRIBUTE)
      gmds_stage_row(p->stage, place, p->properties[k].column, gmds_stage_rows(p->stage, place) - 1, &values[k]);
  return GMDS_OK;
}

static int has_uses(const ply *p, const element *e, unsigned uses)
{
  for (size_t k = e->first; k < e->end; k++)
    uses &= ~(1u << p->properties[k].use);
  return !uses;
}

/* Every row has a number, so many rows are bounded by the bytes that remain. */
static gmds_status read_rows(ply *p, const element *e)
{
  static const unsigned needed[] = {1u << X | 1u << Y, 1u << CORNERS, 1u << END_1 | 1u << END_2, 1u << CORNERS, 0};
  gmds_text *text = &p->block.text;
  if (!has_uses(p, e, needed[e->kind]))
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "an element lacks coordinates or indices of points");
  if (e->first == e->end)
    return GMDS_OK;
  GMDS_TRY(gmds_text_bound(text, e->n, p->block.binary ? 1 : 2, "elements"));
  if (e->kind == VERTICES)
    GMDS_TRY(gmds_stage_reserve(p->stage, text, (size_t)e->n, 0, 0));
  else if (e->kind != OTHER)
    GMDS_TRY(gmds_stage_reserve(p->stage, text, 0, p->stage->soup.n_cells + (size_t)e->n, 0));
  p->stage->corners.n = 0;
  for (uint64_t k = 0; k < e->n; k++)
    GMDS_TRY(read_row(p, e));
  return GMDS_OK;
}

static gmds_status read_elements(ply *p)
{
  GMDS_TRY(read_header(p));
  for (size_t k = 0; k < p->n_elements; k++)
    GMDS_TRY(read_rows(p, &p->elements[k]));
  if (!p->block.binary || !gmds_text_left(&p->block.text))
    return gmds_text_end_of_file(&p->block.text);
  return gmds_text_fail(&p->block.text, GMDS_ERR_FORMAT, -1, "expected the end of the file, found %zu bytes more",
                        gmds_text_left(&p->block.text));
}

gmds_status gmds_read_ply(gmds_text *text, gmds_stage *stage)
{
  void *object = NULL;
  if (!gmds_resize(stage->soup.memory, &object, 0, 1, sizeof(ply)))
    return gmds_text_failed(text, GMDS_ERR_MEMORY);
  ply *p = object;
  p->text = text;
  p->stage = stage;
  p->n_elements = p->n_properties = 0;
  p->block = (gmds_vtk_block){.text = *text};
  gmds_status status = read_elements(p);
  gmds_release(stage->soup.memory, object, 1, sizeof(ply));
  return status;
}
