/* What the parts of the reader of VTU share: the arrays that the XML lists, and their numbers as blocks. */
#ifndef GMDS_VTU_H
#define GMDS_VTU_H

#include "file.h"
#include "vtk.h"

typedef enum gmds_vtu_section {
  GMDS_VTU_POINTS,
  GMDS_VTU_CELLS,
  GMDS_VTU_POINT_DATA,
  GMDS_VTU_CELL_DATA,
  GMDS_VTU_OTHER
} gmds_vtu_section;

typedef enum gmds_vtu_format { GMDS_VTU_ASCII, GMDS_VTU_BINARY, GMDS_VTU_APPENDED } gmds_vtu_format;

/* A DataArray: what its attributes say, and where its content is. */
typedef struct gmds_vtu_array {
  size_t piece;
  gmds_vtu_section section;
  size_t name, name_bytes; /* in gmds_vtu.names */
  gmds_vtk_type type;
  uint64_t components, offset;
  gmds_vtu_format format;
  const char *begin, *end; /* the text between its tags */
  long long line;
} gmds_vtu_array;

typedef struct gmds_vtu_piece {
  uint64_t points, cells;
  size_t first; /* of its arrays; the next piece's begin where they end */
  long long line;
} gmds_vtu_piece;

typedef struct gmds_vtu {
  gmds_text *text;
  gmds_stage *stage;
  int little, compressed;
  size_t header_bytes; /* of the lengths before blocks of bytes: 4 or 8 */
  gmds_vtu_piece *pieces;
  size_t n_pieces, piece_capacity;
  gmds_vtu_array *arrays;
  size_t n_arrays, array_capacity;
  char *names;
  size_t n_names, name_capacity;
  const char *appended, *appended_end; /* behind the underscore; NULL: there is none */
  int appended_base64;
} gmds_vtu;

/* vtu_xml.c: lists pieces and arrays. */
gmds_status gmds_vtu_parse(gmds_vtu *vtu);

/* vtu_bytes.c: the n numbers of an array as a block, which lives as long as `bytes` is not cleared. They are counted
 * where they are words; text is read to its end. */
gmds_status gmds_vtu_open(gmds_vtu *vtu, const gmds_vtu_array *array, uint64_t n, gmds_bytes *bytes,
                          gmds_vtk_block *block);
gmds_status gmds_vtu_close(gmds_vtk_block *block);

/* One past the last array of a piece. */
static inline size_t gmds_vtu_arrays_end(const gmds_vtu *vtu, size_t piece)
{
  return piece + 1 < vtu->n_pieces ? vtu->pieces[piece + 1].first : vtu->n_arrays;
}

/* A scanner of an array's content, for sentences about it. */
gmds_text gmds_vtu_text(const gmds_vtu *vtu, const gmds_vtu_array *array);
#endif
