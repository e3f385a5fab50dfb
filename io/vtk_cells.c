/* Cells in VTK's legacy format: counts and indices in turn (versions up to 4), or OFFSETS and CONNECTIVITY (5), with
 * their types in a block of their own. The blocks are read side by side, so that nothing is stored twice. */
#include "vtk.h"

typedef enum shape {
  WHOLE,   /* the cell as it stands */
  SWAPPED, /* points in the order of an array: the third and fourth of each layer change places */
  CHAIN,   /* a cell for every run of successive points */
  STRIP    /* the same, every second one turned around */
} shape;

/* X(number, text, type, shape). Higher numbers are curved cells, and 0 is none. */
#define CELL_LIST(X)                               \
  X(1, "vertex", GMDS_VERTEX, WHOLE)               \
  X(2, "poly-vertex", GMDS_VERTEX, CHAIN)          \
  X(3, "line", GMDS_SEGMENT, WHOLE)                \
  X(4, "poly-line", GMDS_SEGMENT, CHAIN)           \
  X(5, "triangle", GMDS_TRIANGLE, WHOLE)           \
  X(6, "triangle strip", GMDS_TRIANGLE, STRIP)     \
  X(7, "polygon", GMDS_POLYGON, WHOLE)             \
  X(8, "pixel", GMDS_QUADRILATERAL, SWAPPED)       \
  X(9, "quadrilateral", GMDS_QUADRILATERAL, WHOLE) \
  X(10, "tetrahedron", GMDS_TETRAHEDRON, WHOLE)    \
  X(11, "voxel", GMDS_HEXAHEDRON, SWAPPED)         \
  X(12, "hexahedron", GMDS_HEXAHEDRON, WHOLE)      \
  X(13, "wedge", GMDS_PRISM, WHOLE)                \
  X(14, "pyramid", GMDS_PYRAMID, WHOLE)

typedef struct row {
  const char *text;
  gmds_cell_type type;
  shape shape;
} row;

/* A run of k points for every place where one fits. */
static gmds_status add_runs(gmds_vtk *vtk, const gmds_text *text, const row *r, size_t n, const gmds_id *corners)
{
  size_t k = (size_t)gmds_cell_type_points(r->type);
  for (size_t i = 0; i + k <= n; i++) {
    gmds_id run[3] = {0};
    for (size_t j = 0; j < k; j++)
      run[j] = corners[i + j];
    if (r->shape == STRIP && i % 2) {
      run[0] = corners[i + 1];
      run[1] = corners[i];
    }
    GMDS_TRY(gmds_stage_cell(vtk->stage, text, r->type, k, run));
  }
  return GMDS_OK;
}

static void swap(gmds_id *corners, size_t a, size_t b)
{
  gmds_id x = corners[a];
  corners[a] = corners[b];
  corners[b] = x;
}

/* A polygon of three or four points is what it is. */
static gmds_cell_type type_of_polygon(size_t n)
{
  return n == 3 ? GMDS_TRIANGLE : n == 4 ? GMDS_QUADRILATERAL : GMDS_POLYGON;
}

gmds_status gmds_vtk_add_cell(gmds_vtk *vtk, const gmds_text *text, uint64_t type)
{
#define ROW(number, text, type, shape) [number] = {text, type, shape},
  static const row rows[] = {CELL_LIST(ROW)};
#undef ROW
  gmds_id *corners = vtk->stage->corners.data;
  size_t n = vtk->stage->corners.n;
  if (type == GMDS_VTK_POLYHEDRON)
    return gmds_stage_cell(vtk->stage, text, GMDS_POLYHEDRON, n, corners);
  if (type >= sizeof rows / sizeof *rows || !rows[type].text)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "cells of VTK's type %llu are not read",
                          (unsigned long long)type);
  const row *r = &rows[type];
  size_t least = r->type == GMDS_POLYGON ? 3 : (size_t)gmds_cell_type_points(r->type);
  int any = r->type == GMDS_POLYGON || r->shape == CHAIN || r->shape == STRIP;
  if (n < least || (n > least && !any))
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "a %s has %s%zu points, found %zu", r->text,
                          any ? "at least " : "", least, n);
  if (r->shape == CHAIN || r->shape == STRIP)
    return add_runs(vtk, text, r, n, corners);
  if (r->shape == SWAPPED)
    for (size_t layer = 0; layer < n; layer += 4)
      swap(corners, layer + 2, layer + 3);
  return gmds_stage_cell(vtk->stage, text, r->type == GMDS_POLYGON ? type_of_polygon(n) : r->type, n, corners);
}

/* Reads n indices into stage->corners, or what a polyhedron has in their place. */
static gmds_status read_corners(gmds_vtk *vtk, gmds_vtk_block *cells, uint64_t type, uint64_t n)
{
  if (n > cells->left)
    return gmds_text_fail(&cells->text, GMDS_ERR_FORMAT, -1, "a cell of %llu points, but only %zu indices remain",
                          (unsigned long long)n, cells->left);
  GMDS_TRY(gmds_stage_corners(vtk->stage, &cells->text, (size_t)n));
  for (size_t k = 0; k < (size_t)n; k++) {
    uint64_t x = 0;
    if (type != GMDS_VTK_POLYHEDRON) {
      GMDS_TRY(gmds_vtk_index(cells, vtk->stage->soup.n_points, &vtk->stage->corners.data[k]));
      continue;
    }
    GMDS_TRY(gmds_vtk_whole(cells, "a number of a polyhedron's faces", &x));
    vtk->stage->corners.data[k] = x < GMDS_NONE ? (gmds_id)x : GMDS_NONE;
  }
  return GMDS_OK;
}

/* `<keyword> type` and n whole numbers of it; the file is left behind them. */
static gmds_status find_block(gmds_vtk *vtk, const char *keyword, uint64_t n, gmds_vtk_block *block)
{
  gmds_vtk_type type = {0};
  GMDS_TRY(gmds_text_word(vtk->text, keyword));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  if (type.kind != GMDS_VTK_SIGNED && type.kind != GMDS_VTK_UNSIGNED)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "%s: expected whole numbers, found %s", keyword, type.name);
  GMDS_TRY(gmds_vtk_start(vtk, type, n, keyword, block));
  return gmds_vtk_pass(vtk, block);
}

static int next_is(const gmds_text *text, const char *word)
{
  gmds_text ahead = *text;
  gmds_token token;
  return gmds_text_next(&ahead, &token) && gmds_token_is_any_case(token, word);
}

static const gmds_vtk_type int32 = {"int", GMDS_VTK_SIGNED, 4};

/* Finds the blocks of a section of cells behind its keyword, and the number of cells. */
static gmds_status find_cells(gmds_vtk *vtk, gmds_vtk_cells *cells)
{
  uint64_t n = 0, size = 0;
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of cells", &n));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of indices", &size));
  cells->offsets = next_is(vtk->text, "OFFSETS");
  if (cells->offsets) {
    GMDS_TRY(find_block(vtk, "OFFSETS", n, &cells->begins));
    GMDS_TRY(find_block(vtk, "CONNECTIVITY", size, &cells->corners));
    cells->n = n ? (size_t)n - 1 : 0;
    return GMDS_OK;
  }
  if (n > size)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "%llu cells in %llu numbers", (unsigned long long)n,
                          (unsigned long long)size);
  GMDS_TRY(gmds_vtk_start(vtk, int32, size, "numbers", &cells->corners));
  cells->n = (size_t)n;
  return gmds_vtk_pass(vtk, &cells->corners);
}

/* The number of points of the next cell: a difference of offsets, or the number before the indices. */
static gmds_status next_size(gmds_vtk_cells *cells, uint64_t *last, uint64_t *size)
{
  uint64_t next = 0;
  if (!cells->offsets)
    return gmds_vtk_whole(&cells->corners, "a number of points", size);
  GMDS_TRY(gmds_vtk_whole(&cells->begins, "an offset", &next));
  if (next < *last)
    return gmds_text_fail(&cells->begins.text, GMDS_ERR_FORMAT, -1, "expected an offset from %llu, found %llu",
                          (unsigned long long)*last, (unsigned long long)next);
  *size = next - *last;
  *last = next;
  return GMDS_OK;
}

/* Adds the cells of a section, their types taken from a block, or all of one type where that is NULL. */
static gmds_status add_cells(gmds_vtk *vtk, gmds_vtk_cells *cells, gmds_vtk_block *types, uint64_t type)
{
  uint64_t last = 0, size = 0;
  const gmds_soup *soup = &vtk->stage->soup;
  GMDS_TRY(gmds_stage_reserve(vtk->stage, vtk->text, 0, soup->n_cells + cells->n, 0));
  if (cells->offsets && cells->begins.left)
    GMDS_TRY(gmds_vtk_whole(&cells->begins, "an offset", &last));
  if (last)
    return gmds_text_fail(&cells->begins.text, GMDS_ERR_FORMAT, -1, "expected 0 as the first offset, found %llu",
                          (unsigned long long)last);
  for (size_t c = 0; c < cells->n; c++) {
    GMDS_TRY(next_size(cells, &last, &size));
    if (types)
      GMDS_TRY(gmds_vtk_whole(types, "a type of a cell", &type));
    GMDS_TRY(read_corners(vtk, &cells->corners, type, size));
    GMDS_TRY(gmds_stage_mark(vtk->stage, &cells->corners.text));
    GMDS_TRY(gmds_vtk_add_cell(vtk, &cells->corners.text, type));
  }
  if (cells->corners.left)
    return gmds_text_fail(&cells->corners.text, GMDS_ERR_FORMAT, -1, "numbers left behind the last cell: %zu",
                          cells->corners.left);
  return GMDS_OK;
}

gmds_status gmds_vtk_read_polydata(gmds_vtk *vtk, unsigned type)
{
  gmds_vtk_cells cells;
  GMDS_TRY(find_cells(vtk, &cells));
  return add_cells(vtk, &cells, NULL, type);
}

gmds_status gmds_vtk_find_cells(gmds_vtk *vtk)
{
  if (vtk->has_cells)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "CELLS are listed a second time");
  vtk->has_cells = 1;
  return find_cells(vtk, &vtk->cells);
}

gmds_status gmds_vtk_read_types(gmds_vtk *vtk)
{
  uint64_t n = 0;
  gmds_vtk_block types;
  if (!vtk->has_cells || vtk->has_types)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "CELL_TYPES %s",
                          vtk->has_types ? "are listed a second time" : "without CELLS before them");
  vtk->has_types = 1;
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of cells", &n));
  if (n != vtk->cells.n)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "expected the types of %zu cells, found those of %llu",
                          vtk->cells.n, (unsigned long long)n);
  GMDS_TRY(gmds_vtk_start(vtk, int32, n, "types of cells", &types));
  gmds_vtk_block behind = types;
  GMDS_TRY(gmds_vtk_pass(vtk, &behind));
  return add_cells(vtk, &vtk->cells, &types, 0);
}
