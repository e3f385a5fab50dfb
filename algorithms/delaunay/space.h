/* Delaunay triangulation of points in space: what <gmds/algorithms/delaunay.h> is for models that keep regions. One text
 * for every model that answers 3 -> 0 and 3 -> 3 on tetrahedra.
 *
 * As in the plane a node that stands for infinity (the ghost) closes the triangulation, points go in along a Hilbert curve
 * in rounds, and ties are broken as CGAL does: the set of tetrahedra depends on the points alone. A point is located by a
 * walk that crosses any face it is beyond; the tetrahedra whose spheres hold it are gathered breadth first, tested two at a
 * time; the cavity operator of the model joins the walls of the cavity to it. Arguments, statuses and result as in the
 * plane, with n × 3 coordinates; points of one plane give no tetrahedra, but result->triangles. */
#include <gmds/delaunay.h>
#include <gmds/order.h>
#include <gmds/predicates.h>
#include <gmds/threads.h>

_Static_assert(GMDS__HAS_TETRAHEDRA, "gmds: delaunay() makes tetrahedra: add TETRAHEDRON to GMDS_REGIONS");
_Static_assert(GMDS_CAN(3, 0), "gmds: delaunay() needs 3->0: add R2N, or R2F with F2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_CAN(3, 3), "gmds: delaunay() needs 3->3: add R2R, or N2R, or define GMDS_REGIONS TETRAHEDRON");
_Static_assert(GMDS_STARS,
               "gmds: delaunay() needs to tell edges and faces by their nodes: add E2N where edges are kept, "
               "F2N where faces are, to GMDS_MODEL");

#if GMDS__HAS_TETRAHEDRA && GMDS_CAN(3, 0) && GMDS_CAN(3, 3) && GMDS_STARS
#  define tetrahedron GMDS_FN(tetrahedron)
#  define candidate GMDS_FN(candidate)
#  define insertion GMDS_FN(insertion)
#  define face_nodes GMDS_FN(face_nodes)
#  define opposite_node GMDS_FN(opposite_node)
#  define is_finite GMDS_FN(is_finite)
#  define load GMDS_FN(load)
#  define load_around GMDS_FN(load_around)
#  define region_beyond GMDS_FN(region_beyond)
#  define face_beyond GMDS_FN(face_beyond)
#  define candidate_of GMDS_FN(candidate_of)
#  define append GMDS_FN(append)
#  define nodes_of GMDS_FN(nodes_of)
#  define locate GMDS_FN(locate)
#  define in_conflict_exactly GMDS_FN(in_conflict_exactly)
#  define in_conflict GMDS_FN(in_conflict)
#  define reserve_cavity GMDS_FN(reserve_cavity)
#  define reserve_marks GMDS_FN(reserve_marks)
#  define grow_cavity GMDS_FN(grow_cavity)
#  define number_of GMDS_FN(number_of)
#  define find_sides GMDS_FN(find_sides)
#  define find_walls GMDS_FN(find_walls)
#  define insert_point GMDS_FN(insert_point)
#  define first_four GMDS_FN(first_four)
#  define begin_with GMDS_FN(begin_with)
#  define insert_all GMDS_FN(insert_all)
#  define clear_insertion GMDS_FN(clear_insertion)
#  define triangulate_nodes GMDS_FN(triangulate_nodes)
#  define finish_flat GMDS_FN(finish_flat)
#  define placing GMDS_FN(placing)
#  define place_part GMDS_FN(place_part)
#  define place_nodes GMDS_FN(place_nodes)
#  define number_nodes GMDS_FN(number_nodes)
#  define sort_chain GMDS_FN(sort_chain)
#  define delaunay GMDS_FN(delaunay)
#  include <gmds/algorithms/delaunay/space/walk.h>
#  include <gmds/algorithms/delaunay/space/cavity.h>
#  include <gmds/algorithms/delaunay/points.h>
#  include <gmds/algorithms/delaunay/space/run.h>
#  undef tetrahedron
#  undef candidate
#  undef insertion
#  undef face_nodes
#  undef opposite_node
#  undef is_finite
#  undef load
#  undef load_around
#  undef region_beyond
#  undef face_beyond
#  undef candidate_of
#  undef append
#  undef nodes_of
#  undef locate
#  undef in_conflict_exactly
#  undef in_conflict
#  undef reserve_cavity
#  undef reserve_marks
#  undef grow_cavity
#  undef number_of
#  undef find_sides
#  undef find_walls
#  undef insert_point
#  undef first_four
#  undef begin_with
#  undef insert_all
#  undef clear_insertion
#  undef triangulate_nodes
#  undef finish_flat
#  undef placing
#  undef place_part
#  undef place_nodes
#  undef number_nodes
#  undef sort_chain
#  undef delaunay
#endif
