/* The writers, one a format: each puts a soup that the format can hold into an open file. What fails to arrive is seen
 * when the file is closed. */
#ifndef GMDS_WRITERS_H
#define GMDS_WRITERS_H

#include <gmds/io.h>
#include <stdio.h>

/* What a writer is given: where to, what, and how. */
typedef struct gmds_sink {
  FILE *file;
  const gmds_soup *soup;
  int binary;
  int version; /* as in gmds_write_options, never 0 where the format has several */
  int asked;   /* the version was asked for, and is not merely the usual one */
  const char *path;
  gmds_error *error;
} gmds_sink;

gmds_status gmds_write_off(const gmds_sink *sink);
gmds_status gmds_write_obj(const gmds_sink *sink);
gmds_status gmds_write_ply(const gmds_sink *sink);
gmds_status gmds_write_stl(const gmds_sink *sink);
gmds_status gmds_write_vtk(const gmds_sink *sink);
gmds_status gmds_write_vtu(const gmds_sink *sink);
gmds_status gmds_write_medit(const gmds_sink *sink);
gmds_status gmds_write_meshb(const gmds_sink *sink);
gmds_status gmds_write_gmsh(const gmds_sink *sink);
gmds_status gmds_write_node(const gmds_sink *sink);
gmds_status gmds_write_f64(const gmds_sink *sink);
gmds_status gmds_write_text(const gmds_sink *sink);

/* The statuses of a writer with a sentence that names the file. */
#if defined __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
gmds_status
gmds_sink_fail(const gmds_sink *sink, gmds_status status, const char *format, ...);

/* Whether a format has a place for a column; a name that passed can stand in its file. */
int gmds_ply_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);
int gmds_vtk_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);
int gmds_vtu_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);
int gmds_medit_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);
int gmds_gmsh_holds(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);

/* Whether a column is of one whole number that fits an int in every row, and such a number. */
int gmds_is_reference(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);
int gmds_reference(const gmds_attribute *attribute, size_t item); /* 0 where `attribute` is NULL */

/* How many rows the columns of a place have. */
static inline size_t gmds_rows_of(const gmds_soup *soup, gmds_place place)
{
  return place == GMDS_OF_POINTS ? soup->n_points : soup->n_cells;
}

/* VTK's number for a type of cells. */
int gmds_vtk_number(gmds_cell_type type);

/* A coordinate, 0 where the soup has two. */
double gmds_coordinate(const gmds_soup *soup, size_t point, int k);

/* A point's coordinates with a blank between, the third 0 where `dim` is 3 and the soup has two. No end of line. */
void gmds_put_point(FILE *file, const gmds_soup *soup, size_t point, int dim);

/* A blank and an index from `base`, for each corner of a cell; a polyhedron's entries as they are. */
void gmds_put_corners(FILE *file, const gmds_soup *soup, size_t cell, unsigned base);

/* The values of one row of a column with a blank between. */
void gmds_put_row(FILE *file, const gmds_attribute *attribute, size_t row);

/* The lowest `bytes` bytes of a word, the lowest or the highest first, and a double so. */
void gmds_put_word(FILE *file, uint64_t x, int bytes, int little);
void gmds_put_double(FILE *file, double x, int little);

/* One value of a column as a word of its bytes. */
uint64_t gmds_value_word(const gmds_attribute *attribute, size_t k);
#endif
