/* What the parts of the reader of VTK's legacy format share. The text between blocks of numbers is tokens in both of
 * its forms; the numbers are tokens too (ASCII) or big-endian words from the next line on (BINARY). */
#ifndef GMDS_VTK_H
#define GMDS_VTK_H

#include "stage.h"
#include "value.h"

typedef enum gmds_vtk_kind {
  GMDS_VTK_SIGNED,
  GMDS_VTK_UNSIGNED,
  GMDS_VTK_REAL,
  GMDS_VTK_BIT,
  GMDS_VTK_STRING
} gmds_vtk_kind;

/* X(name, kind, bytes in a BINARY file) */
#define GMDS_VTK_TYPE_LIST(X)               \
  X("bit", GMDS_VTK_BIT, 0)                 \
  X("char", GMDS_VTK_SIGNED, 1)             \
  X("signed_char", GMDS_VTK_SIGNED, 1)      \
  X("unsigned_char", GMDS_VTK_UNSIGNED, 1)  \
  X("short", GMDS_VTK_SIGNED, 2)            \
  X("unsigned_short", GMDS_VTK_UNSIGNED, 2) \
  X("int", GMDS_VTK_SIGNED, 4)              \
  X("unsigned_int", GMDS_VTK_UNSIGNED, 4)   \
  X("vtkidtype", GMDS_VTK_SIGNED, 4)        \
  X("long", GMDS_VTK_SIGNED, 8)             \
  X("unsigned_long", GMDS_VTK_UNSIGNED, 8)  \
  X("vtktypeint64", GMDS_VTK_SIGNED, 8)     \
  X("vtktypeuint64", GMDS_VTK_UNSIGNED, 8)  \
  X("float", GMDS_VTK_REAL, 4)              \
  X("double", GMDS_VTK_REAL, 8)             \
  X("string", GMDS_VTK_STRING, 1)

typedef struct gmds_vtk_type {
  const char *name;
  gmds_vtk_kind kind;
  int bytes;
} gmds_vtk_type;

/* A place in the file where numbers of one type are read from: several can be read side by side. */
typedef struct gmds_vtk_block {
  gmds_text text;
  int binary;
  gmds_vtk_type type;
  size_t left; /* numbers not read yet */
  int little;  /* words are little-endian, which they never are in a legacy file */
} gmds_vtk_block;

/* A section of cells: where its numbers are. */
typedef struct gmds_vtk_cells {
  size_t n;
  int offsets;            /* OFFSETS and CONNECTIVITY; otherwise sizes and indices in turn */
  gmds_vtk_block begins;  /* OFFSETS */
  gmds_vtk_block corners; /* CONNECTIVITY, or sizes and indices */
} gmds_vtk_cells;

typedef struct gmds_vtk {
  gmds_text *text;
  gmds_stage *stage;
  int binary;
  int polydata;                         /* otherwise UNSTRUCTURED_GRID */
  int has_points, has_cells, has_types; /* POINTS, CELLS, CELL_TYPES were seen */
  gmds_vtk_cells cells;                 /* of CELLS */
  int has_data;                         /* POINT_DATA or CELL_DATA was seen */
  gmds_place place;                     /* the last of these */
  uint64_t tuples;                      /* of it */
  size_t last_kind;                     /* of POLYDATA: the kind of cells that was listed last */
} gmds_vtk;

/* vtk_numbers.c: blocks of numbers */

/* The next token on this line as the name of a type. */
gmds_status gmds_vtk_next_type(gmds_vtk *vtk, gmds_vtk_type *type);

/* A block of n numbers from here, held against the bytes that remain. The file stays where the block begins;
 * gmds_vtk_pass leaves it behind, and gmds_vtk_skip does both. */
gmds_status gmds_vtk_start(gmds_vtk *vtk, gmds_vtk_type type, uint64_t n, const char *what, gmds_vtk_block *block);
gmds_status gmds_vtk_pass(gmds_vtk *vtk, const gmds_vtk_block *block);
gmds_status gmds_vtk_skip(gmds_vtk *vtk, gmds_vtk_type type, uint64_t n, const char *what);

/* The next number of a block: a whole one from 0, an index below n, or a coordinate. */
gmds_status gmds_vtk_whole(gmds_vtk_block *block, const char *what, uint64_t *x);
gmds_status gmds_vtk_index(gmds_vtk_block *block, size_t n, gmds_id *id);
gmds_status gmds_vtk_real(gmds_vtk_block *block, size_t point, double *x);

/* The type of a column that holds numbers of a type without loss, and the next number of a block as a value of it. */
gmds_value gmds_vtk_value_type(gmds_vtk_type type);
gmds_status gmds_vtk_value(gmds_vtk_block *block, gmds_value type, void *at);

/* VTK's number for a polyhedron, whose indices are a stream of faces. */
enum { GMDS_VTK_POLYHEDRON = 42 };

/* vtk_cells.c: what follows CELLS, CELL_TYPES, and the keyword of cells of one of VTK's types */
gmds_status gmds_vtk_find_cells(gmds_vtk *vtk);
gmds_status gmds_vtk_read_types(gmds_vtk *vtk);
gmds_status gmds_vtk_read_polydata(gmds_vtk *vtk, unsigned type);

/* Adds a cell of VTK's type with the points in stage->corners, which are given another order where VTK has another.
 * `text` is where they ended. */
gmds_status gmds_vtk_add_cell(gmds_vtk *vtk, const gmds_text *text, uint64_t type);

/* vtk_data.c: what is not geometry. `*known` tells whether the keyword was one of these. */
gmds_status gmds_vtk_read_data(gmds_vtk *vtk, gmds_token keyword, int *known);
#endif
