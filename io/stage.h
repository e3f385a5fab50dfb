/* Where a reader builds aside: a soup in space that becomes the caller's only when the whole file was read. */
#ifndef GMDS_STAGE_H
#define GMDS_STAGE_H

#include "text.h"
#include <gmds/soup.h>

typedef struct gmds_stage {
  gmds_soup soup;   /* three coordinates a point while the file is read */
  int dim;          /* what the caller asked for: 2, 3, or 0 for as many as there are */
  int points_only;  /* cells are not wanted */
  gmds_ids corners; /* of the cell at hand: a reader's own */
  gmds_ids sorted;  /* the same, to find a repeated one */
  size_t columns;   /* that were made */
  gmds_ids first;   /* the cells of the file, where a reader marks them: the first cell of the soup that each became,
                       which may be none or several */
} gmds_stage;

void gmds_stage_init(gmds_stage *stage, gmds_memory *memory, int dim, int points_only);
void gmds_stage_clear(gmds_stage *stage);

/* As the calls on a soup, with a sentence on failure. A cell of which two corners are the same is counted and left out.
 */
gmds_status gmds_stage_reserve(gmds_stage *stage, const gmds_text *text, size_t points, size_t cells, size_t corners);
gmds_status gmds_stage_point(gmds_stage *stage, const gmds_text *text, const double x[3]);
gmds_status gmds_stage_cell(gmds_stage *stage, const gmds_text *text, gmds_cell_type type, size_t n,
                            const gmds_id *corners);

/* Makes room for n corners in stage->corners, and makes that its length. */
gmds_status gmds_stage_corners(gmds_stage *stage, const gmds_text *text, size_t n);

/* The next cell of the file begins: cells added from here on are made of it. */
gmds_status gmds_stage_mark(gmds_stage *stage, const gmds_text *text);

/* A tuple that is longer is no value of a point or a cell; this bounds what a line of a file can become. */
enum { GMDS_MOST_COMPONENTS = 1000 };

/* A file with more attributes is refused: a new name is compared with all that there are. */
enum { GMDS_MOST_COLUMNS = 10000 };

/* A new column of attributes. The name may hold any byte but 0, and must not be there. */
gmds_status gmds_stage_column(gmds_stage *stage, const gmds_text *text, gmds_place place, gmds_token name,
                              gmds_value type, size_t components, gmds_attribute **attribute);

/* Puts one row of a column where it belongs: that of a point, or that of a cell of the file, which must be marked. */
void gmds_stage_row(gmds_stage *stage, gmds_place place, gmds_attribute *attribute, size_t row, const void *values);

/* How many rows a file has at a place. */
static inline size_t gmds_stage_rows(const gmds_stage *stage, gmds_place place)
{
  return place == GMDS_OF_POINTS ? stage->soup.n_points : stage->first.n;
}

/* Puts the reference number of a point or a cell of the soup into a column of one int, which is made when the first one
 * comes that is not 0. */
gmds_status gmds_stage_reference(gmds_stage *stage, const gmds_text *text, gmds_place place, const char *name,
                                 size_t item, int value);

/* Gives the points the dimension asked for and moves everything to `soup`, which is empty. */
gmds_status gmds_stage_commit(gmds_stage *stage, const gmds_text *text, gmds_soup *soup);

/* Moves the content of `from` (which is empty then) to `to` (whose content is dropped). */
static inline void gmds_soup_move(gmds_soup *to, gmds_soup *from)
{
  gmds_soup_clear(to);
  *to = *from;
  gmds_soup_init(from, from->memory, from->dim);
}
#endif
