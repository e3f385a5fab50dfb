/* VTU: unstructured grids of VTK in XML, their arrays as text, in base64 or appended, compressed by zlib or not. Pieces
 * are joined; an attribute that a piece lacks is 0 there. Fields of the whole grid and strings are counted and left
 * out. */
#include "vtu.h"
#include "readers.h"
#include <string.h>

static const gmds_vtu_array *find_array(const gmds_vtu *vtu, size_t piece, gmds_vtu_section section, const char *name)
{
  for (size_t k = vtu->pieces[piece].first; k < gmds_vtu_arrays_end(vtu, piece); k++) {
    const gmds_vtu_array *a = &vtu->arrays[k];
    if (a->section == section && (!name || strcmp(vtu->names + a->name, name) == 0))
      return a;
  }
  return NULL;
}

/* The same, where there must be one; a piece without cells may have none. */
static gmds_status need_array(gmds_vtu *vtu, size_t piece, gmds_vtu_section section, const char *name,
                              const gmds_vtu_array **array)
{
  *array = find_array(vtu, piece, section, name);
  if (*array)
    return GMDS_OK;
  vtu->text->line = vtu->pieces[piece].line;
  return gmds_text_fail(vtu->text, GMDS_ERR_FORMAT, -1, "the piece has no array of %s", name ? name : "Points");
}

static gmds_status add_points(gmds_vtu *vtu, gmds_vtk_block *block, size_t n)
{
  size_t before = vtu->stage->soup.n_points;
  if (n > GMDS_NONE - before)
    return gmds_text_failed(&block->text, GMDS_ERR_TOO_MANY);
  GMDS_TRY(gmds_stage_reserve(vtu->stage, &block->text, before + n, 0, 0));
  for (size_t p = 0; p < n; p++) {
    double x[3];
    for (int k = 0; k < 3; k++)
      GMDS_TRY(gmds_vtk_real(block, before + p, &x[k]));
    GMDS_TRY(gmds_stage_point(vtu->stage, &block->text, x));
  }
  return gmds_vtu_close(block);
}

static gmds_status read_points(gmds_vtu *vtu, size_t piece)
{
  const gmds_vtu_array *array = NULL;
  gmds_bytes bytes;
  gmds_vtk_block block;
  uint64_t n = vtu->pieces[piece].points;
  if (!n)
    return GMDS_OK;
  GMDS_TRY(need_array(vtu, piece, GMDS_VTU_POINTS, NULL, &array));
  gmds_text text = gmds_vtu_text(vtu, array);
  if (array->components != 3)
    return gmds_text_fail(&text, GMDS_ERR_FORMAT, -1, "expected points of 3 components, found %llu",
                          (unsigned long long)array->components);
  if (n > UINT64_MAX / 3)
    return gmds_text_failed(&text, GMDS_ERR_TOO_MANY);
  GMDS_TRY(gmds_vtu_open(vtu, array, 3 * n, &bytes, &block));
  gmds_status status = add_points(vtu, &block, (size_t)n);
  gmds_bytes_clear(&bytes);
  return status;
}

enum { CONNECTIVITY, OFFSETS, TYPES, FACES, FACE_OFFSETS, CELL_ARRAYS };

/* The cells of a piece: its arrays side by side, and how far the streams of faces were read. */
typedef struct cells {
  gmds_vtk_block block[CELL_ARRAYS];
  int has_faces;
  size_t first, n_points; /* the piece's points in the soup */
  uint64_t corners, faces;
} cells;

/* The last number of an array of offsets, the largest for offsets of faces, of which -1 is none: what they count. */
static gmds_status last_offset(gmds_vtk_block block, size_t n, int may_lack, uint64_t *last)
{
  *last = 0;
  for (size_t k = 0; k < n; k++) {
    int64_t x = 0;
    GMDS_TRY(gmds_vtk_value(&block, GMDS_LONG, &x));
    if (x < 0 && !(may_lack && x == -1))
      return gmds_text_fail(&block.text, GMDS_ERR_FORMAT, -1, "expected an offset, found %lld", (long long)x);
    if (x >= 0)
      *last = (uint64_t)x;
  }
  return GMDS_OK;
}

/* Puts the stream of a polyhedron into stage->corners, its points moved to those of the soup. */
static gmds_status take_stream(gmds_vtu *vtu, cells *c, uint64_t end)
{
  gmds_vtk_block *faces = &c->block[FACES];
  gmds_ids *corners = &vtu->stage->corners;
  if (end < c->faces || end - c->faces > faces->left)
    return gmds_text_fail(&c->block[TYPES].text, GMDS_ERR_FORMAT, -1, "a polyhedron without faces");
  GMDS_TRY(gmds_stage_corners(vtu->stage, &faces->text, (size_t)(end - c->faces)));
  c->faces = end;
  uint64_t count = 0; /* points of the face that are still to come */
  for (size_t k = 0; k < corners->n; k++) {
    uint64_t x = 0;
    gmds_id id = 0;
    if (k && count) {
      GMDS_TRY(gmds_vtk_index(faces, c->n_points, &id));
      corners->data[k] = (gmds_id)(id + c->first);
      count--;
      continue;
    }
    GMDS_TRY(gmds_vtk_whole(faces, "a number of a polyhedron's faces", &x));
    corners->data[k] = x < GMDS_NONE ? (gmds_id)x : GMDS_NONE;
    count = k ? x : 0;
  }
  return GMDS_OK;
}

/* Puts the points of the next cell into stage->corners. */
static gmds_status take_corners(gmds_vtu *vtu, cells *c, uint64_t end)
{
  gmds_vtk_block *block = &c->block[CONNECTIVITY];
  if (end < c->corners || end - c->corners > block->left)
    return gmds_text_fail(&c->block[OFFSETS].text, GMDS_ERR_FORMAT, -1, "expected an offset from %llu, found %llu",
                          (unsigned long long)c->corners, (unsigned long long)end);
  GMDS_TRY(gmds_stage_corners(vtu->stage, &block->text, (size_t)(end - c->corners)));
  c->corners = end;
  for (size_t k = 0; k < vtu->stage->corners.n; k++) {
    GMDS_TRY(gmds_vtk_index(block, c->n_points, &vtu->stage->corners.data[k]));
    vtu->stage->corners.data[k] = (gmds_id)(vtu->stage->corners.data[k] + c->first);
  }
  return GMDS_OK;
}

static gmds_status add_cells(gmds_vtu *vtu, cells *c, size_t n)
{
  gmds_vtk vtk = {.stage = vtu->stage};
  for (size_t k = 0; k < n; k++) {
    uint64_t end = 0, type = 0;
    int64_t faces = -1;
    GMDS_TRY(gmds_vtk_whole(&c->block[OFFSETS], "an offset", &end));
    GMDS_TRY(gmds_vtk_whole(&c->block[TYPES], "a type of a cell", &type));
    GMDS_TRY(take_corners(vtu, c, end));
    if (c->has_faces)
      GMDS_TRY(gmds_vtk_value(&c->block[FACE_OFFSETS], GMDS_LONG, &faces));
    if (type == GMDS_VTK_POLYHEDRON)
      GMDS_TRY(take_stream(vtu, c, faces < 0 ? 0 : (uint64_t)faces));
    GMDS_TRY(gmds_stage_mark(vtu->stage, &c->block[CONNECTIVITY].text));
    GMDS_TRY(gmds_vtk_add_cell(&vtk, &c->block[CONNECTIVITY].text, type));
  }
  for (int k = 0; k < (c->has_faces ? CELL_ARRAYS : FACES); k++)
    GMDS_TRY(gmds_vtu_close(&c->block[k]));
  return GMDS_OK;
}

/* Whether one of the cells is a polyhedron; some programs write empty arrays of faces where none is. */
static gmds_status find_polyhedra(gmds_vtk_block types, size_t n, int *found)
{
  for (size_t k = 0; k < n; k++) {
    uint64_t type = 0;
    GMDS_TRY(gmds_vtk_whole(&types, "a type of a cell", &type));
    *found |= type == GMDS_VTK_POLYHEDRON;
  }
  return GMDS_OK;
}

/* Opens the arrays of cells one after the other, offsets before what they count. */
static gmds_status open_cells(gmds_vtu *vtu, size_t piece, gmds_bytes bytes[CELL_ARRAYS], cells *c)
{
  static const char *const names[] = {"connectivity", "offsets", "types", "faces", "faceoffsets"};
  static const int order[] = {OFFSETS, CONNECTIVITY, TYPES, FACE_OFFSETS, FACES};
  uint64_t n = vtu->pieces[piece].cells;
  for (int k = 0; k < (c->has_faces ? CELL_ARRAYS : FACES); k++) {
    int which = order[k];
    const gmds_vtu_array *array = NULL;
    uint64_t count = n;
    GMDS_TRY(need_array(vtu, piece, GMDS_VTU_CELLS, names[which], &array));
    gmds_text text = gmds_vtu_text(vtu, array);
    if (array->type.kind == GMDS_VTK_REAL)
      return gmds_text_fail(&text, GMDS_ERR_FORMAT, -1, "%s: expected whole numbers, found %s", names[which],
                            array->type.name);
    if (which == CONNECTIVITY)
      GMDS_TRY(last_offset(c->block[OFFSETS], (size_t)n, 0, &count));
    if (which == FACES)
      GMDS_TRY(last_offset(c->block[FACE_OFFSETS], (size_t)n, 1, &count));
    GMDS_TRY(gmds_vtu_open(vtu, array, count, &bytes[which], &c->block[which]));
    if (which == TYPES)
      GMDS_TRY(find_polyhedra(c->block[TYPES], (size_t)n, &c->has_faces));
  }
  return GMDS_OK;
}

static gmds_status read_cells(gmds_vtu *vtu, size_t piece, size_t first)
{
  const gmds_soup *soup = &vtu->stage->soup;
  gmds_bytes bytes[CELL_ARRAYS];
  cells c = {.first = first, .n_points = soup->n_points - first};
  if (!vtu->pieces[piece].cells)
    return GMDS_OK;
  for (int k = 0; k < CELL_ARRAYS; k++)
    bytes[k] = (gmds_bytes){.memory = soup->memory};
  for (int k = 0; k < CELL_ARRAYS; k++)
    c.block[k].text = *vtu->text;
  gmds_status status = open_cells(vtu, piece, bytes, &c);
  if (status == GMDS_OK)
    status = add_cells(vtu, &c, (size_t)vtu->pieces[piece].cells);
  for (int k = 0; k < CELL_ARRAYS; k++)
    gmds_bytes_clear(&bytes[k]);
  return status;
}

/* The column of an array, made by the first piece that has it. */
static gmds_status find_column(gmds_vtu *vtu, const gmds_vtu_array *array, gmds_place place, gmds_attribute **column)
{
  gmds_text text = gmds_vtu_text(vtu, array);
  gmds_value type = gmds_vtk_value_type(array->type);
  gmds_token name = {vtu->names + array->name, array->name_bytes};
  *column = array->piece ? gmds_soup_find_attribute(&vtu->stage->soup, place, name.at) : NULL;
  if (!*column)
    return gmds_stage_column(vtu->stage, &text, place, name, type, (size_t)array->components, column);
  if ((*column)->type == type && (*column)->components == array->components)
    return GMDS_OK;
  return gmds_text_fail(&text, GMDS_ERR_FORMAT, -1, "the array '%.60s' was another one in a piece before", name.at);
}

static gmds_status fill_column(gmds_vtu *vtu, const gmds_vtu_array *array, gmds_vtk_block *block, gmds_place place,
                               size_t first, size_t rows)
{
  char row[8 * GMDS_MOST_COMPONENTS];
  gmds_attribute *column = NULL;
  GMDS_TRY(find_column(vtu, array, place, &column));
  size_t bytes = gmds_value_bytes(column->type);
  for (size_t k = 0; k < rows; k++) {
    for (size_t j = 0; j < column->components; j++)
      GMDS_TRY(gmds_vtk_value(block, column->type, row + j * bytes));
    gmds_stage_row(vtu->stage, place, column, first + k, row);
  }
  return gmds_vtu_close(block);
}

/* The attributes of a piece, whose points or cells begin at `first`. */
static gmds_status read_attributes(gmds_vtu *vtu, size_t piece, gmds_place place, size_t first)
{
  gmds_vtu_section section = place == GMDS_OF_POINTS ? GMDS_VTU_POINT_DATA : GMDS_VTU_CELL_DATA;
  size_t rows = gmds_stage_rows(vtu->stage, place) - first;
  for (size_t k = vtu->pieces[piece].first; k < gmds_vtu_arrays_end(vtu, piece); k++) {
    const gmds_vtu_array *array = &vtu->arrays[k];
    gmds_bytes bytes;
    gmds_vtk_block block;
    if (array->section != section)
      continue;
    gmds_text text = gmds_vtu_text(vtu, array);
    if (!array->components || array->components > GMDS_MOST_COMPONENTS)
      return gmds_text_fail(&text, GMDS_ERR_UNSUPPORTED, -1, "expected an attribute of 1 to %d components, found %llu",
                            GMDS_MOST_COMPONENTS, (unsigned long long)array->components);
    GMDS_TRY(gmds_vtu_open(vtu, array, rows * array->components, &bytes, &block));
    gmds_status status = fill_column(vtu, array, &block, place, first, rows);
    gmds_bytes_clear(&bytes);
    GMDS_TRY(status);
  }
  return GMDS_OK;
}

static gmds_status read_pieces(gmds_vtu *vtu)
{
  GMDS_TRY(gmds_vtu_parse(vtu));
  for (size_t piece = 0; piece < vtu->n_pieces; piece++) {
    size_t first_point = vtu->stage->soup.n_points, first_cell = vtu->stage->first.n;
    GMDS_TRY(read_points(vtu, piece));
    GMDS_TRY(read_cells(vtu, piece, first_point));
    GMDS_TRY(read_attributes(vtu, piece, GMDS_OF_POINTS, first_point));
    GMDS_TRY(read_attributes(vtu, piece, GMDS_OF_CELLS, first_cell));
  }
  return GMDS_OK;
}

gmds_status gmds_read_vtu(gmds_text *text, gmds_stage *stage)
{
  gmds_vtu vtu = {.text = text, .stage = stage};
  gmds_memory *memory = stage->soup.memory;
  gmds_status status = read_pieces(&vtu);
  gmds_release(memory, vtu.pieces, vtu.piece_capacity, sizeof *vtu.pieces);
  gmds_release(memory, vtu.arrays, vtu.array_capacity, sizeof *vtu.arrays);
  gmds_release(memory, vtu.names, vtu.name_capacity, 1);
  return status;
}
