/* The quality and the size of cells: what quality() of a mesh asks (algorithms/quality.h).
 *
 * 1 is the best value of a measure, 0 and below are for cells that are degenerate or inverted:
 *
 *   triangle       mean ratio: 4 sqrt(3) area / sum of squared sides (Bank and Smith 1997; Knupp 2001)
 *   quadrilateral  scaled Jacobian: the least sine of a corner, against the normal of the whole (Knupp 2000; Verdict)
 *   polygon        isoperimetric quotient against the regular polygon of n sides: 4 n tan(pi / n) area / perimeter^2
 *   tetrahedron    mean ratio: 12 (3 volume)^(2/3) / sum of squared edges (Liu and Joe 1994)
 *   pyramid        the least mean ratio of a corner of its base, against the pyramid of eight equal edges (Knupp 2001)
 *   prism          scaled Jacobian: the least of its corners, over that of the prism on an equilateral triangle
 *   hexahedron     scaled Jacobian: the least triple product of the unit edges at a corner (Knupp 2000; Verdict)
 *   polyhedron     isoperimetric quotient 36 pi volume^2 / area^3: 1 for a ball, 0.52 for a cube
 *
 * Values of triangles and polygons carry the sign of the area in the plane, those of tetrahedra and polyhedra that of
 * the volume; faces in space are not negative, quadrilaterals can be where they fold back. */
#ifndef GMDS_QUALITY_H
#define GMDS_QUALITY_H

#include <gmds/walls.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GMDS_QUALITY_BINS = 10 };

typedef struct gmds_quality {
  size_t cells;
  size_t inverted;                /* values of 0 or less, and what is no number */
  size_t bins[GMDS_QUALITY_BINS]; /* the others: bin k from k / 10 on, the last with 1 */
  double min, max, mean;          /* of all values that are numbers; 0 where there is none */
  double size;                    /* of all cells */
  gmds_id worst;                  /* the first cell of the least value, or GMDS_NONE */
} gmds_quality;

/* The measure of one face of n nodes, 3 or more, and its area. dim: 2 or 3 coordinates a node. In space the area is
 * that of the triangles of its sides with the mean of its nodes, added as vectors. O(n). */
double gmds_face_quality(int dim, const double *points, size_t n, const gmds_id *nodes);
double gmds_face_area(int dim, const double *points, size_t n, const gmds_id *nodes);

/* The measure of region r, which exists, and its volume: that within its walls, which count as the triangles of their
 * sides with the mean of their nodes. O(its walls). */
double gmds_region_quality(const gmds_walls *walls, const double *points, size_t r);
double gmds_region_volume(const gmds_walls *walls, const double *points, size_t r);

/* Both for all faces whose nodes are listed around them, and for all regions of a complex: an entry a row, 0 for an
 * empty one, and what they come to; each of the three may be NULL. ordered: which way faces are listed means something,
 * else areas are taken as positive. Nothing is allocated. O(entries). */
void gmds_quality_of_faces(int dim, const double *points, const gmds_csr *faces, int ordered, double *values,
                           double *sizes, gmds_quality *summary);
void gmds_quality_of_regions(const gmds_walls *walls, const double *points, double *values, double *sizes,
                             gmds_quality *summary);

#ifdef __cplusplus
}
#endif
#endif
