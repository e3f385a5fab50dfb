/* The writers, one a format: each puts a soup that the format can hold into an open file. What fails to arrive is seen
 * when the file is closed. */
#ifndef GMDS_WRITERS_H
#define GMDS_WRITERS_H

#include <gmds/soup.h>
#include <stdio.h>

void gmds_write_off(FILE *file, const gmds_soup *soup);
void gmds_write_vtk(FILE *file, const gmds_soup *soup);
void gmds_write_medit(FILE *file, const gmds_soup *soup);
void gmds_write_node(FILE *file, const gmds_soup *soup);
void gmds_write_f64(FILE *file, const gmds_soup *soup);
void gmds_write_text(FILE *file, const gmds_soup *soup);

/* A point's coordinates with a blank between, the third 0 where `dim` is 3 and the soup has two. No end of line. */
void gmds_put_point(FILE *file, const gmds_soup *soup, size_t point, int dim);

/* A blank and an index from `base`, for each corner of a cell. */
void gmds_put_corners(FILE *file, const gmds_soup *soup, size_t cell, unsigned base);
#endif
