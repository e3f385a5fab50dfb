/* Delaunay triangulation of points in space: what <gmds/algorithms/delaunay.h> is for models that keep regions. One
 * text for every model that answers 3 -> 0 and 3 -> 3 on tetrahedra.
 *
 * As in the plane a node that stands for infinity (the ghost) closes the triangulation, points go in along a Hilbert
 * curve in rounds, and ties are broken as CGAL does: the set of tetrahedra depends on the points alone. A point is
 * located by a walk that crosses any face it is beyond; the tetrahedra whose spheres hold it are gathered breadth
 * first, tested two at a time; the cavity operator of the model joins the walls of the cavity to it. Several threads do
 * so as in the plane, each within a slab of space. Arguments, statuses and result as in the
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
#  define owns GMDS_FN(owns)
#  define owns_all GMDS_FN(owns_all)
#  define defer GMDS_FN(defer)
#  define is_deferred GMDS_FN(is_deferred)
#  define number_at GMDS_FN(number_at)
#  define renew_numbers GMDS_FN(renew_numbers)
#  define remember_star GMDS_FN(remember_star)
#  define grow_alone GMDS_FN(grow_alone)
#  define find_walls_alone GMDS_FN(find_walls_alone)
#  define insert_alone GMDS_FN(insert_alone)
#  define locate_shared GMDS_FN(locate_shared)
#  define grow_shared GMDS_FN(grow_shared)
#  define find_walls_shared GMDS_FN(find_walls_shared)
#  define insert_shared GMDS_FN(insert_shared)
#  define supply GMDS_FN(supply)
#  define push_spare GMDS_FN(push_spare)
#  define pop_spare GMDS_FN(pop_spare)
#  define supply_star GMDS_FN(supply_star)
#  define concurrent GMDS_FN(concurrent)
#  define strip_of GMDS_FN(strip_of)
#  define count_part GMDS_FN(count_part)
#  define deal_part GMDS_FN(deal_part)
#  define sort_sample GMDS_FN(sort_sample)
#  define cut_strips GMDS_FN(cut_strips)
#  define assign_strips GMDS_FN(assign_strips)
#  define find_start GMDS_FN(find_start)
#  define open_stage GMDS_FN(open_stage)
#  define open_round GMDS_FN(open_round)
#  define close_round GMDS_FN(close_round)
#  define open_rest GMDS_FN(open_rest)
#  define tell_progress GMDS_FN(tell_progress)
#  define insert_strip GMDS_FN(insert_strip)
#  define insert_strips GMDS_FN(insert_strips)
#  define insert_rest GMDS_FN(insert_rest)
#  define insert_stage GMDS_FN(insert_stage)
#  define insert_by_threads GMDS_FN(insert_by_threads)
#  define threads_for GMDS_FN(threads_for)
#  define first_part GMDS_FN(first_part)
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
#  include <gmds/algorithms/delaunay/space/parallel.h>
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
#  undef GMDS__ALONE
#  undef GMDS__SHARED
#  undef GMDS__OF_GHOST
#  undef owns
#  undef owns_all
#  undef defer
#  undef is_deferred
#  undef number_at
#  undef renew_numbers
#  undef remember_star
#  undef grow_alone
#  undef find_walls_alone
#  undef insert_alone
#  undef locate_shared
#  undef grow_shared
#  undef find_walls_shared
#  undef insert_shared
#  undef supply
#  undef push_spare
#  undef pop_spare
#  undef supply_star
#  undef concurrent
#  undef strip_of
#  undef count_part
#  undef deal_part
#  undef sort_sample
#  undef cut_strips
#  undef assign_strips
#  undef find_start
#  undef open_stage
#  undef open_round
#  undef close_round
#  undef open_rest
#  undef tell_progress
#  undef insert_strip
#  undef insert_strips
#  undef insert_rest
#  undef insert_stage
#  undef insert_by_threads
#  undef threads_for
#  undef first_part
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
