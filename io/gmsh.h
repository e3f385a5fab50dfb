/* What the parts of the reader of Gmsh's MSH share: numbers as text or as words, and the numbers that nodes, elements
 * and entities bear in a file, which need be neither in order nor without gaps. */
#ifndef GMDS_GMSH_H
#define GMDS_GMSH_H

#include "stage.h"
#include "value.h"

/* X(Gmsh's number, type): first order, listed as VTK lists them */
#define GMDS_GMSH_TYPE_LIST(X) \
  X(15, GMDS_VERTEX)           \
  X(1, GMDS_SEGMENT)           \
  X(2, GMDS_TRIANGLE)          \
  X(3, GMDS_QUADRILATERAL)     \
  X(4, GMDS_TETRAHEDRON)       \
  X(5, GMDS_HEXAHEDRON)        \
  X(6, GMDS_PRISM)             \
  X(7, GMDS_PYRAMID)

typedef struct gmds_tag {
  uint64_t tag;
  size_t item; /* which one it was */
} gmds_tag;

/* Tags of items that come one after the other. While they are consecutive, nothing is stored. */
typedef struct gmds_tags {
  uint64_t first;
  size_t n, capacity;
  gmds_tag *pairs; /* by tag once they are sorted; NULL while consecutive */
} gmds_tags;

typedef struct gmds_gmsh {
  gmds_text *text;
  gmds_stage *stage;
  int binary, little;
  int version; /* 22 or 41 */
  int has_nodes, has_elements;
  gmds_tags nodes, elements, entities; /* tags of entities hold their dimension in the upper half */
  gmds_ids physical;                   /* of every entity, the number of its first physical group as 32 bits */
} gmds_gmsh;

/* gmsh_numbers.c */

/* The next number: an int, a size (text, or 8 bytes), a coordinate, a value of any kind. */
gmds_status gmds_gmsh_int(gmds_gmsh *gmsh, const char *what, int *x);
gmds_status gmds_gmsh_size(gmds_gmsh *gmsh, const char *what, uint64_t *x);
gmds_status gmds_gmsh_coordinate(gmds_gmsh *gmsh, size_t point, double *x);
gmds_status gmds_gmsh_value(gmds_gmsh *gmsh, double *x);

/* A number of rows, each of some ints, sizes and doubles, held against the bytes that remain. */
gmds_status gmds_gmsh_bound(const gmds_gmsh *gmsh, uint64_t n, size_t ints, size_t sizes, size_t doubles,
                            const char *what);

/* Goes behind the end of the line, where words begin. */
gmds_status gmds_gmsh_start_words(gmds_gmsh *gmsh);

/* Tags: the next item's; order for the search, in which at most so many items may have one tag; and the items of a tag,
 * `*n` of them from the one returned. */
gmds_status gmds_tags_push(gmds_gmsh *gmsh, gmds_tags *tags, uint64_t tag);
gmds_status gmds_tags_sort(gmds_gmsh *gmsh, gmds_tags *tags, size_t most, const char *what);
size_t gmds_tags_find(const gmds_tags *tags, uint64_t tag, size_t *n);
size_t gmds_tags_item(const gmds_tags *tags, size_t found);
void gmds_tags_clear(gmds_gmsh *gmsh, gmds_tags *tags);

/* gmsh_mesh.c, gmsh_data.c: what follows the keyword of a section, up to its end */
gmds_status gmds_gmsh_read_entities(gmds_gmsh *gmsh);
gmds_status gmds_gmsh_read_nodes(gmds_gmsh *gmsh);
gmds_status gmds_gmsh_read_elements(gmds_gmsh *gmsh);
gmds_status gmds_gmsh_read_data(gmds_gmsh *gmsh, gmds_place place);
#endif
