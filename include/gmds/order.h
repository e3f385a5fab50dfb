/* Insertion orders of points: a Hilbert curve in rounds (biased randomised insertion order; Amenta, Choi and Rote
 * 2003), with equal points found on the way. */
#ifndef GMDS_ORDER_H
#define GMDS_ORDER_H

#include <gmds/ids.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The bytes of working space that ordering n points takes: 16 a point, 32 where gmds_id has 64 bits. */
size_t gmds_order_scratch(size_t n);

/* Orders n points for insertion.
 *   memory     where the working space comes from, all freed again
 *   scratch    gmds_order_scratch(n) bytes of the caller's that may be overwritten, aligned for doubles, where there
 *              are some anyway (a first touch of memory costs as much as ten reads); else NULL
 *   threads    how many may work; it does not change the result. 0 counts as 1
 *   dim        2 or 3
 *   n, xy      n × dim coordinates, row major, all finite
 *   order      n entries: the indices of the distinct points in insertion order; of equal points (-0 equals +0) the
 *              lowest index stands for all. Only the first *distinct entries are set
 *   same_as    n entries, or NULL: for each point the index of the point that stands for it (itself as a rule)
 *   distinct   how many distinct points there are
 * GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_COORDINATE (a NaN or infinity: `error` names the first such point);
 * GMDS_ERR_TOO_MANY (n does not fit gmds_id); GMDS_ERR_ARGUMENT (dim). On failure nothing is written.
 * The order depends on the coordinates and their positions alone. O(n) for spread points; points of one cell of the
 * grid that the curve runs through are ordered again within their own box, which for the worst inputs, coordinates of
 * all magnitudes, repeats the work some 130 (in 3D 220) times. Uses up to
 * 100 kB of stack, and with several threads 40 kB each of `memory`. */
gmds_status gmds_order_points(gmds_memory *memory, void *scratch, unsigned threads, int dim, size_t n, const double *xy,
                              gmds_error *error, gmds_id *order, gmds_id *same_as, size_t *distinct);

/* The same without rounds: the distinct points as they follow each other along the Hilbert curve. For numbering what is
 * near with near numbers, not for insertion. */
gmds_status gmds_order_along_curve(gmds_memory *memory, int dim, size_t n, const double *xy, gmds_error *error,
                                   gmds_id *order, gmds_id *same_as, size_t *distinct);

#ifdef __cplusplus
}
#endif
#endif
