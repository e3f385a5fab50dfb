/* The path of each query of the open model, and what the preprocessor can say about it:
 *   GMDS__PATH_i_j   the code of choice.h; 0 where the model cannot answer
 *   GMDS__ROW_i_j    the row of the table (tables.h) that is taken
 *   GMDS__EXACT_i_j  1 when the answer is exact on every cell that the model may hold. On simplices every row is;
 *                    beyond them a multiplicity of nodes does not make a side of a face or a face of a region: only
 *                    cells that keep their nodes in order (F2N, R2N) decide, or what they keep of their edges or faces
 *   GMDS__CAN_i_j    path and exact: get_adj_i_j exists */
#if GMDS__S_0_1 || GMDS__S_1_0
#  define GMDS__PATH_0_0 GMDS_CHOOSE(GMDS_PATHS_0_0_BY_EDGES)
#elif GMDS__S_0_2 || GMDS__S_2_0
#  define GMDS__PATH_0_0 GMDS_CHOOSE(GMDS_PATHS_0_0_BY_FACES)
#else
#  define GMDS__PATH_0_0 GMDS_CHOOSE(GMDS_PATHS_0_0)
#endif
#define GMDS__ROW_0_0 (GMDS__PATH_0_0 / 16)
#define GMDS__PATH_0_1 GMDS_CHOOSE(GMDS_PATHS_0_1)
#define GMDS__ROW_0_1 (GMDS__PATH_0_1 / 16)
#define GMDS__PATH_0_2 GMDS_CHOOSE(GMDS_PATHS_0_2)
#define GMDS__ROW_0_2 (GMDS__PATH_0_2 / 16)
#define GMDS__PATH_0_3 GMDS_CHOOSE(GMDS_PATHS_0_3)
#define GMDS__ROW_0_3 (GMDS__PATH_0_3 / 16)
#define GMDS__PATH_1_0 GMDS_CHOOSE(GMDS_PATHS_1_0)
#define GMDS__ROW_1_0 (GMDS__PATH_1_0 / 16)
#define GMDS__PATH_1_1 GMDS_CHOOSE(GMDS_PATHS_1_1)
#define GMDS__ROW_1_1 (GMDS__PATH_1_1 / 16)
#define GMDS__PATH_1_2 GMDS_CHOOSE(GMDS_PATHS_1_2)
#define GMDS__ROW_1_2 (GMDS__PATH_1_2 / 16)
#define GMDS__PATH_1_3 GMDS_CHOOSE(GMDS_PATHS_1_3)
#define GMDS__ROW_1_3 (GMDS__PATH_1_3 / 16)
#define GMDS__PATH_2_0 GMDS_CHOOSE(GMDS_PATHS_2_0)
#define GMDS__ROW_2_0 (GMDS__PATH_2_0 / 16)
#define GMDS__PATH_2_1 GMDS_CHOOSE(GMDS_PATHS_2_1)
#define GMDS__ROW_2_1 (GMDS__PATH_2_1 / 16)
#define GMDS__PATH_2_2 GMDS_CHOOSE(GMDS_PATHS_2_2)
#define GMDS__ROW_2_2 (GMDS__PATH_2_2 / 16)
#define GMDS__PATH_2_3 GMDS_CHOOSE(GMDS_PATHS_2_3)
#define GMDS__ROW_2_3 (GMDS__PATH_2_3 / 16)
#define GMDS__PATH_3_0 GMDS_CHOOSE(GMDS_PATHS_3_0)
#define GMDS__ROW_3_0 (GMDS__PATH_3_0 / 16)
#define GMDS__PATH_3_1 GMDS_CHOOSE(GMDS_PATHS_3_1)
#define GMDS__ROW_3_1 (GMDS__PATH_3_1 / 16)
#define GMDS__PATH_3_2 GMDS_CHOOSE(GMDS_PATHS_3_2)
#define GMDS__ROW_3_2 (GMDS__PATH_3_2 / 16)
#define GMDS__PATH_3_3 GMDS_CHOOSE(GMDS_PATHS_3_3)
#define GMDS__ROW_3_3 (GMDS__PATH_3_3 / 16)

/* Which pairs of dimensions are linked, one way or the other. */
#define GMDS__LINKED_0_1 (GMDS__S_0_1 || GMDS__S_1_0)
#define GMDS__LINKED_0_2 (GMDS__S_0_2 || GMDS__S_2_0)
#define GMDS__LINKED_0_3 (GMDS__S_0_3 || GMDS__S_3_0)
#define GMDS__LINKED_1_2 (GMDS__S_1_2 || GMDS__S_2_1)
#define GMDS__LINKED_1_3 (GMDS__S_1_3 || GMDS__S_3_1)
#define GMDS__LINKED_2_3 (GMDS__S_2_3 || GMDS__S_3_2)

/* What is known of a cell's own cells by their nodes: the sides of a face, the faces (walls) of a region. */
#define GMDS__KNOWS_SIDES (GMDS__SIMPLICIAL || GMDS__S_2_0)
#define GMDS__KNOWS_BORDERS (GMDS__KNOWS_SIDES || (GMDS__K_3 && GMDS__LINKED_1_2)) /* of a face and an edge */
#define GMDS__KNOWS_WALLS                                                                   \
  (GMDS__TETRAHEDRA || (GMDS__S_3_0 && !GMDS__POLYHEDRA) || (GMDS__S_3_2 && GMDS__S_2_0) || \
   (GMDS__S_3_1 && GMDS__S_1_0 && !GMDS__POLYHEDRA))

#define GMDS__EXACT_0_0 ((GMDS__ROW_0_0 != 3 || GMDS__KNOWS_SIDES) && (GMDS__ROW_0_0 != 4 || GMDS__KNOWS_WALLS))
#define GMDS__EXACT_0_1 1
#define GMDS__EXACT_0_2 1
#define GMDS__EXACT_0_3 1
#define GMDS__EXACT_1_0 1
#define GMDS__EXACT_1_1 1
#define GMDS__EXACT_1_2 (GMDS__ROW_1_2 != 2 || GMDS__KNOWS_BORDERS)
#define GMDS__EXACT_1_3                                                                                          \
  ((GMDS__ROW_1_3 != 3 || GMDS__KNOWS_WALLS || GMDS__LINKED_1_3 || (GMDS__LINKED_2_3 && GMDS__KNOWS_BORDERS)) && \
   (GMDS__ROW_1_3 != 4 || GMDS__KNOWS_BORDERS))
#define GMDS__EXACT_2_0 1
#define GMDS__EXACT_2_1 (GMDS__ROW_2_1 != 2 || GMDS__KNOWS_BORDERS)
#if GMDS__K_3
#  define GMDS__EXACT_2_2 (GMDS__ROW_2_2 != 3 || GMDS__KNOWS_SIDES || GMDS__LINKED_1_2)
#else
#  define GMDS__EXACT_2_2 \
    (GMDS__KNOWS_SIDES || (GMDS__ROW_2_2 != 3 && GMDS__ROW_2_2 != 5 && !(GMDS__ROW_2_2 == 4 && !GMDS__S_2_1)))
#endif
#define GMDS__EXACT_2_3 (GMDS__ROW_2_3 < 2 || GMDS__KNOWS_WALLS || GMDS__LINKED_2_3)
#define GMDS__EXACT_3_0 1
#define GMDS__EXACT_3_1                                                                                          \
  ((GMDS__ROW_3_1 != 3 || GMDS__KNOWS_WALLS || GMDS__LINKED_1_3 || (GMDS__LINKED_2_3 && GMDS__KNOWS_BORDERS)) && \
   (GMDS__ROW_3_1 != 4 || GMDS__KNOWS_WALLS || GMDS__LINKED_1_3 || GMDS__KNOWS_BORDERS))
#define GMDS__EXACT_3_2 (GMDS__ROW_3_2 < 2 || GMDS__KNOWS_WALLS || GMDS__LINKED_2_3)
#define GMDS__EXACT_3_3 \
  ((GMDS__ROW_3_3 != 3 && GMDS__ROW_3_3 != 4 && GMDS__ROW_3_3 != 9) || GMDS__KNOWS_WALLS || GMDS__LINKED_2_3)
#define GMDS__CAN_0_0 (GMDS__PATH_0_0 != 0 && GMDS__EXACT_0_0)
#define GMDS__CAN_0_1 (GMDS__PATH_0_1 != 0 && GMDS__EXACT_0_1)
#define GMDS__CAN_0_2 (GMDS__PATH_0_2 != 0 && GMDS__EXACT_0_2)
#define GMDS__CAN_0_3 (GMDS__PATH_0_3 != 0 && GMDS__EXACT_0_3)
#define GMDS__CAN_1_0 (GMDS__PATH_1_0 != 0 && GMDS__EXACT_1_0)
#define GMDS__CAN_1_1 (GMDS__PATH_1_1 != 0 && GMDS__EXACT_1_1)
#define GMDS__CAN_1_2 (GMDS__PATH_1_2 != 0 && GMDS__EXACT_1_2)
#define GMDS__CAN_1_3 (GMDS__PATH_1_3 != 0 && GMDS__EXACT_1_3)
#define GMDS__CAN_2_0 (GMDS__PATH_2_0 != 0 && GMDS__EXACT_2_0)
#define GMDS__CAN_2_1 (GMDS__PATH_2_1 != 0 && GMDS__EXACT_2_1)
#define GMDS__CAN_2_2 (GMDS__PATH_2_2 != 0 && GMDS__EXACT_2_2)
#define GMDS__CAN_2_3 (GMDS__PATH_2_3 != 0 && GMDS__EXACT_2_3)
#define GMDS__CAN_3_0 (GMDS__PATH_3_0 != 0 && GMDS__EXACT_3_0)
#define GMDS__CAN_3_1 (GMDS__PATH_3_1 != 0 && GMDS__EXACT_3_1)
#define GMDS__CAN_3_2 (GMDS__PATH_3_2 != 0 && GMDS__EXACT_3_2)
#define GMDS__CAN_3_3 (GMDS__PATH_3_3 != 0 && GMDS__EXACT_3_3)

/* The sentence of a query that does not exist, made of the rows of the tables. Ways through regions are left out where
 * none are kept; and E2E, which needs a link that is a way already. */
#define GMDS__LETTER_0 "N"
#define GMDS__LETTER_1 "E"
#define GMDS__LETTER_2 "F"
#define GMDS__LETTER_3 "R"
#define GMDS__W1(id, i, j) GMDS__LETTER_##i "2" GMDS__LETTER_##j
#define GMDS__W2(id, t, i, k, j, n) GMDS__VIA_##k(i, j)
#define GMDS__VIA_0(i, j) GMDS__VIA(i, 0, j)
#define GMDS__VIA_1(i, j) GMDS__VIA(i, 1, j)
#define GMDS__VIA_2(i, j) GMDS__VIA(i, 2, j)
#if GMDS__K_3
#  define GMDS__VIA_3(i, j) GMDS__VIA(i, 3, j)
#else
#  define GMDS__VIA_3(i, j)
#endif
#define GMDS__VIA(i, k, j) ", or " GMDS__LETTER_##i "2" GMDS__LETTER_##k " with " GMDS__LETTER_##k "2" GMDS__LETTER_##j
#define GMDS__W3(id, t, i, k, l, j, o, n)
#define GMDS__W4(id, t, i, k, l, m, j, o, p, n)
#define GMDS__SORRY(i, j, PATHS) GMDS__CANNOT(i, j, PATHS(GMDS__W1, GMDS__W2, GMDS__W3, GMDS__W4))
#define GMDS__CANNOT(i, j, advice)                               \
  GMDS_UNAVAILABLE("gmds: model '" GMDS_TEXT(                    \
      GMDS_PREFIX) "' cannot answer " #i "->" #j ": add " advice \
                   " to GMDS_MODEL (the inverse of a relation will do, at the cost of a traversal)")
#if GMDS__K_3
#  define GMDS__UNDECIDED(i, j)                                                                                        \
    GMDS_UNAVAILABLE("gmds: model '" GMDS_TEXT(GMDS_PREFIX) "' cannot decide " #i "->" #j                              \
                                                            " on cells that are no simplices: add R2N (where it asks " \
                                                            "for faces, F2N) to GMDS_MODEL, or define GMDS_REGIONS "   \
                                                            "TETRAHEDRON")
#else
#  define GMDS__UNDECIDED(i, j)                    \
    GMDS_UNAVAILABLE("gmds: model '" GMDS_TEXT(    \
        GMDS_PREFIX) "' cannot decide " #i "->" #j \
                     " on faces that are no triangles: add F2N to GMDS_MODEL, or define GMDS_FACES TRIANGLE")
#endif

/* The same for dimensions that are macros. */
#define GMDS__UNDECIDED_AT(i, j) GMDS__UNDECIDED(i, j)
#define GMDS__NOT_STORED_AT(i, j) GMDS__NOT_STORED(i, j)

#define GMDS__NOT_STORED(i, j)                        \
  GMDS_UNAVAILABLE("gmds: model '" GMDS_TEXT(         \
      GMDS_PREFIX) "' stores no relation " #i "->" #j \
                   " to view: add " GMDS__W1(1, i, j) " to GMDS_MODEL, or ask get_adj_" #i "_" #j "()")
#define GMDS__NO_VIEW \
  GMDS_UNAVAILABLE(   \
      "gmds: 2->2 has no view: an entry of F2F may be empty and carry a side: ask across() or get_adj_2_2()")
#define GMDS__NO_VIEW_3 \
  GMDS_UNAVAILABLE(     \
      "gmds: 3->3 has no view: an entry of R2R may be empty and carry a face: ask across() or get_adj_3_3()")

/* What an algorithm may ask of the open model at compile time:
 *   GMDS_CAN(i, j)     get_adj_i_j exists
 *   GMDS_STORED(i, j)  it is a stored relation
 *   GMDS_VIEW(i, j)    view_i_j exists
 *   GMDS_ORDERED_2_0   get_adj_2_0 gives the nodes of a face in their order around it
 *   GMDS_COORDINATES   of a node: 2 or 3
 *   GMDS_SIMPLICIAL    faces are triangles and nothing else
 *   GMDS_HAS_TRIANGLES faces may be triangles
 *   GMDS_CONCURRENT_STARS  stars may be made by several threads at once (interface.h)
 *   GMDS_ACROSS        across() gives the face beyond side k of a face, in time that does not grow with the mesh
 * and of one that keeps regions:
 *   GMDS_ORDERED_3_0   the nodes of a region come in the order of its type (shapes.h)
 *   GMDS_HAS_TETRAHEDRA  regions may be tetrahedra
 *   GMDS_TOP           the dimension: 2 or 3 */
#define GMDS_CAN(i, j) GMDS__CAN_##i##_##j
#define GMDS_STORED(i, j) GMDS__S_##i##_##j
#define GMDS_VIEW(i, j) (GMDS__S_##i##_##j && !((i) == GMDS_TOP && (j) == GMDS_TOP))
#define GMDS_ORDERED_2_0 (GMDS__S_2_0 || (GMDS__S_2_1 && GMDS__S_1_0))
#if GMDS__K_3
#  define GMDS_TOP 3
#  define GMDS_ORDERED_3_0 (!GMDS__POLYHEDRA && (GMDS__S_3_0 || (GMDS__S_3_1 && GMDS__S_1_0)))
#  define GMDS_HAS_TETRAHEDRA GMDS__HAS_TETRAHEDRA
#  define GMDS_ACROSS (GMDS__TETRAHEDRA && GMDS__S_3_0 && GMDS__S_3_3)
#  define GMDS_CONCURRENT_STARS \
    (GMDS__TETRAHEDRA && GMDS__S_3_0 && GMDS__S_3_3 && !GMDS__K_1 && !GMDS__K_2 && !GMDS__S_0_0 && !GMDS__S_0_3)
#else
#  define GMDS_TOP 2
#  define GMDS_ACROSS \
    (GMDS_ORDERED_2_0 && (GMDS__S_2_2 || (GMDS__S_2_1 && GMDS__S_1_2) || GMDS__S_0_2 || (GMDS__S_0_1 && GMDS__S_1_2)))
#  define GMDS_CONCURRENT_STARS \
    (GMDS__TRIANGLES && GMDS__CODED && !GMDS__K_1 && !GMDS__S_0_0 && !GMDS__S_0_1 && !GMDS__S_0_2)
#endif
#define GMDS_COORDINATES GMDS__DIM
#define GMDS_SIMPLICIAL GMDS__SIMPLICIAL
#define GMDS_HAS_TRIANGLES GMDS__TRIANGLES
