/* Exact geometric predicates over all finite doubles, subnormals and the whole range of exponents included.
 *
 * Each takes pointers to `2` (or `3`) coordinates and returns the sign, -1, 0 or 1, of the exact value. NaN and infinity
 * are the caller's to refuse. Nothing is allocated, no state is kept; safe from any thread. A call costs a few flops
 * and a comparison when a floating-point filter decides, exact arithmetic otherwise.
 *
 * Sources: Dekker 1971; Knuth; Shewchuk 1997 (expansions); Devillers and Teillaud 2011 (perturbation). */
#ifndef GMDS_PREDICATES_H
#define GMDS_PREDICATES_H

#include <gmds/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 1 when a, b, c turn counter-clockwise, -1 clockwise, 0 when they lie on one line. */
int gmds_orient2d(const double a[2], const double b[2], const double c[2]);

/* For a, b, c counter-clockwise: 1 when d lies inside their circle, -1 outside, 0 on it. */
int gmds_incircle(const double a[2], const double b[2], const double c[2], const double d[2]);

/* As gmds_incircle, never 0 for a, b, c counter-clockwise and d distinct from them: cocircular points are told apart by
 * the symbolic perturbation that CGAL uses (Devillers and Teillaud 2011; points in lexicographic order, the largest is
 * perturbed most), which makes the Delaunay triangulation of any points unique. */
int gmds_incircle_perturbed(const double a[2], const double b[2], const double c[2], const double d[2]);

/* -1, 0, 1: lexicographic order of two points of `dim` coordinates; -0 and +0 are equal. */
int gmds_compare_points(int dim, const double *a, const double *b);

/* Whether this build and this thread compute as the predicates assume: doubles round to nearest, products and sums are
 * not contracted, subnormals are not flushed. GMDS_OK or GMDS_ERR_PLATFORM. Algorithms call it once at their start. */
gmds_status gmds_predicates_check(void);

#ifdef __cplusplus
}
#endif
#endif
