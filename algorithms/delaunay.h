/* Delaunay triangulation of points of the plane by the algorithm of Bowyer and Watson ([models] 4.1): one text for
 * every model that answers 2 -> 0 and 2 -> 2 on triangles; for models that keep regions that of points in space
 * (delaunay/space.h).
 *
 * A node that stands for infinity (the ghost) makes the triangulation a closed surface, so that the hull is exact. The
 * points go in along a Hilbert curve in rounds (order.h). Each is located by a walk, the triangles whose circles hold
 * it are gathered depth first, which gives the boundary of the cavity in order, and the cavity operator of the model
 * replaces them. Predicates are exact and ties are broken as CGAL does (predicates.h): the set of triangles depends on
 * the points alone.
 *
 * A triangle in hand carries its nodes in counter-clockwise order, and stepping over a side keeps it. So models that
 * keep no order are oriented by what the algorithm knows, not by the mesh.
 *
 *   <prefix>_delaunay(m, n, xy, options, result)
 *     m        an empty mesh; its nodes are the distinct points in the order of insertion, its faces the triangles
 *     n, xy    n × 2 coordinates, row major; n × 3 of points of one plane where a node has three (DIM3)
 *     options  may be NULL
 *     result   may be NULL; cleared first. Points of lower dimension give no faces, but dimension and chain
 *              (delaunay.h)
 *   GMDS_OK; GMDS_ERR_ARGUMENT (the mesh is not empty); GMDS_ERR_COORDINATE (the error names the first point that is
 *   not finite; points in space are not of one plane); GMDS_ERR_TOO_MANY; GMDS_ERR_MEMORY; GMDS_ERR_CANCELLED;
 *   GMDS_ERR_PLATFORM. On failure the mesh is empty (one that was not is left as it was) and the result is empty.
 *   Expected O(n log n) where neighbours are local, else O(n) traversals of the mesh. */
#ifndef GMDS__OPEN
#  error "gmds: include <gmds/mesh.h> for a model before <gmds/algorithms/delaunay.h>"
#endif

#if GMDS_TOP == 3
#  include <gmds/algorithms/delaunay/space.h>
#else
#  include <gmds/delaunay.h>
#  include <gmds/order.h>
#  include <gmds/predicates.h>
#  include <gmds/threads.h>

_Static_assert(GMDS_HAS_TRIANGLES, "gmds: delaunay() makes triangles: add TRIANGLE to GMDS_FACES");
_Static_assert(!GMDS_STORED(1, 1), "gmds: delaunay() does not keep E2E true: take it out of GMDS_MODEL");
_Static_assert(GMDS_CAN(2, 0), "gmds: delaunay() needs 2->0: add F2N, or F2E with E2N, to GMDS_MODEL (the inverse of a "
                               "relation will do)");
_Static_assert(GMDS_CAN(2, 2), "gmds: delaunay() needs 2->2: add F2F, or F2N, or define GMDS_FACES TRIANGLE");
_Static_assert(GMDS_ADDS_FACES,
               "gmds: delaunay() needs to find what is at a side: add F2N, or define GMDS_FACES TRIANGLE");

#  if GMDS_HAS_TRIANGLES && !GMDS_STORED(1, 1) && GMDS_CAN(2, 0) && GMDS_CAN(2, 2) && GMDS_ADDS_FACES
#    define insertion GMDS_FN(insertion)
#    define turn_of GMDS_FN(turn_of)
#    define circle_side GMDS_FN(circle_side)
#    define neighbours GMDS_FN(neighbours)
#    define step_over GMDS_FN(step_over)
#    define in_conflict GMDS_FN(in_conflict)
#    define locate GMDS_FN(locate)
#    define grow_cavity GMDS_FN(grow_cavity)
#    define add_side GMDS_FN(add_side)
#    define in_conflict_exactly GMDS_FN(in_conflict_exactly)
#    define pending_side GMDS_FN(pending_side)
#    define leave GMDS_FN(leave)
#    define reserve_cavity GMDS_FN(reserve_cavity)
#    define insert_alone GMDS_FN(insert_alone)
#    define insert_shared GMDS_FN(insert_shared)
#    define insert_point GMDS_FN(insert_point)
#    define face_range GMDS_FN(face_range)
#    define owns GMDS_FN(owns)
#    define defer GMDS_FN(defer)
#    define is_deferred GMDS_FN(is_deferred)
#    define take_fresh GMDS_FN(take_fresh)
#    define concurrent GMDS_FN(concurrent)
#    define strip_of GMDS_FN(strip_of)
#    define count_part GMDS_FN(count_part)
#    define deal_part GMDS_FN(deal_part)
#    define sort_sample GMDS_FN(sort_sample)
#    define cut_strips GMDS_FN(cut_strips)
#    define find_start GMDS_FN(find_start)
#    define insert_strip GMDS_FN(insert_strip)
#    define tell_progress GMDS_FN(tell_progress)
#    define supply GMDS_FN(supply)
#    define assign_strips GMDS_FN(assign_strips)
#    define open_stage GMDS_FN(open_stage)
#    define open_round GMDS_FN(open_round)
#    define close_round GMDS_FN(close_round)
#    define open_rest GMDS_FN(open_rest)
#    define insert_rest GMDS_FN(insert_rest)
#    define insert_strips GMDS_FN(insert_strips)
#    define insert_stage GMDS_FN(insert_stage)
#    define insert_by_threads GMDS_FN(insert_by_threads)
#    define first_part GMDS_FN(first_part)
#    define clear_insertion GMDS_FN(clear_insertion)
#    define threads_for GMDS_FN(threads_for)
#    define placing GMDS_FN(placing)
#    define place_part GMDS_FN(place_part)
#    define place_nodes GMDS_FN(place_nodes)
#    define number_nodes GMDS_FN(number_nodes)
#    define first_triangle GMDS_FN(first_triangle)
#    define triangulate_nodes GMDS_FN(triangulate_nodes)
#    define insert_all GMDS_FN(insert_all)
#    define sort_chain GMDS_FN(sort_chain)
#    define delaunay GMDS_FN(delaunay)
#    include <gmds/algorithms/delaunay/walk.h>
#    include <gmds/algorithms/delaunay/cavity.h>
#    include <gmds/algorithms/delaunay/points.h>
#    include <gmds/algorithms/delaunay/parallel.h>
#    include <gmds/algorithms/delaunay/run.h>
#    undef GMDS__ALONE
#    undef GMDS__SHARED
#    undef insertion
#    undef turn_of
#    undef circle_side
#    undef neighbours
#    undef step_over
#    undef in_conflict
#    undef locate
#    undef grow_cavity
#    undef add_side
#    undef in_conflict_exactly
#    undef pending_side
#    undef leave
#    undef reserve_cavity
#    undef insert_alone
#    undef insert_shared
#    undef insert_point
#    undef face_range
#    undef owns
#    undef defer
#    undef is_deferred
#    undef take_fresh
#    undef concurrent
#    undef strip_of
#    undef count_part
#    undef deal_part
#    undef sort_sample
#    undef cut_strips
#    undef find_start
#    undef insert_strip
#    undef tell_progress
#    undef supply
#    undef assign_strips
#    undef open_stage
#    undef open_round
#    undef close_round
#    undef open_rest
#    undef insert_rest
#    undef insert_strips
#    undef insert_stage
#    undef insert_by_threads
#    undef first_part
#    undef clear_insertion
#    undef threads_for
#    undef placing
#    undef place_part
#    undef place_nodes
#    undef number_nodes
#    undef first_triangle
#    undef triangulate_nodes
#    undef insert_all
#    undef sort_chain
#    undef delaunay
#  endif
#endif /* the plane */
