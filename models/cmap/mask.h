/* Reads GMDS_MODEL and GMDS_DIM of a combinatorial map and says what follows from them:
 *   GMDS__K_i      1 where i-cells are kept            GMDS__N       the dimension of the map
 *   GMDS__DIM      coordinates of a node               GMDS__STRIDE  identifiers a dart: its betas and its kept cells
 *   GMDS__SLOT_i   where a dart's i-cell stands in its record
 * and what algorithms may ask (models/paths.h). Every query between cells that are kept is answered. */
#include <gmds/models/letters_on.h>

#if (GMDS_MODEL + 0) == 0
#  error "gmds: GMDS_MODEL is empty or misspelt: name the cells that the map keeps, for instance (N|F)"
#  undef GMDS_MODEL
#  define GMDS_MODEL N /* so that nothing more is said */
#endif
#if !defined GMDS_DIM || (GMDS_DIM + 0) < 2 || (GMDS_DIM + 0) > 4
#  error "gmds: define GMDS_DIM, the dimension of the map: 2, 3 or 4"
#  undef GMDS_DIM
#  define GMDS_DIM 2 /* so that nothing more is said */
#endif

/* The compiler reads the mask too: a misspelt letter, 0 to the preprocessor, is an undeclared name to it. */
enum { GMDS_FN(model) = (GMDS_MODEL) };

#if (GMDS_MODEL) & N
#  define GMDS__K_0 1
#else
#  define GMDS__K_0 0
#endif
#if (GMDS_MODEL) & E
#  define GMDS__K_1 1
#else
#  define GMDS__K_1 0
#endif
#if (GMDS_MODEL) & F
#  define GMDS__K_2 1
#else
#  define GMDS__K_2 0
#endif
#if (GMDS_MODEL) & R
#  define GMDS__K_3 1
#else
#  define GMDS__K_3 0
#endif
#if (GMDS_MODEL) & DIM2 && (GMDS_MODEL)&DIM3
#  error "gmds: GMDS_MODEL has both DIM2 and DIM3: a node has two coordinates or three"
#endif
#if (GMDS_MODEL) & DIM3 || (GMDS_DIM > 2 && !((GMDS_MODEL)&DIM2))
#  define GMDS__DIM 3
#else
#  define GMDS__DIM 2
#endif
#if (GMDS_MODEL) & ~(N | E | F | R | DIM2 | DIM3)
#  error "gmds: a combinatorial map stores betas, which answer every query: take the relations out of GMDS_MODEL"
#endif
#include <gmds/models/letters_off.h>

#if !GMDS__K_0
#  error "gmds: a map keeps nodes: add N to GMDS_MODEL"
#endif
#if GMDS__K_3 && GMDS_DIM < 3
#  error "gmds: a 2-map has no regions: define GMDS_DIM 3, or take R out of GMDS_MODEL"
#endif
#if defined GMDS_FACES || defined GMDS_REGIONS
#  error "gmds: a map holds cells of every type: GMDS_FACES and GMDS_REGIONS are for models of stored relations"
#endif

#define GMDS__N GMDS_DIM
#define GMDS__SLOT_0 (GMDS__N + 1)
#define GMDS__SLOT_1 (GMDS__N + 2)
#define GMDS__SLOT_2 (GMDS__N + 2 + GMDS__K_1)
#define GMDS__SLOT_3 (GMDS__N + 2 + GMDS__K_1 + GMDS__K_2)
#define GMDS__STRIDE (GMDS__N + 2 + GMDS__K_1 + GMDS__K_2 + GMDS__K_3)
#define GMDS__MASK                                                                              \
  (GMDS__K_0 * GMDS_CELL_BIT(0) | GMDS__K_1 * GMDS_CELL_BIT(1) | GMDS__K_2 * GMDS_CELL_BIT(2) | \
   GMDS__K_3 * GMDS_CELL_BIT(3))

/* What algorithms ask. Nothing is stored as a relation, but the face beside a side of a face is a step away. */
#define GMDS_TOP (GMDS__N < 3 ? 2 : 3)
#define GMDS_CAN(i, j) (GMDS__K_##i && GMDS__K_##j)
#define GMDS_STORED(i, j) GMDS__S_##i##_##j
#define GMDS__S_0_0 0
#define GMDS__S_0_1 0
#define GMDS__S_0_2 0
#define GMDS__S_0_3 0
#define GMDS__S_1_0 0
#define GMDS__S_1_1 0
#define GMDS__S_1_2 0
#define GMDS__S_1_3 0
#define GMDS__S_2_0 0
#define GMDS__S_2_1 0
#define GMDS__S_2_2 (GMDS__N == 2 && GMDS__K_2)
#define GMDS__S_2_3 0
#define GMDS__S_3_0 0
#define GMDS__S_3_1 0
#define GMDS__S_3_2 0
#define GMDS__S_3_3 0
#define GMDS_VIEW(i, j) 0
#define GMDS_ORDERED_2_0 GMDS__K_2
#define GMDS_ORDERED_3_0 0
#define GMDS_ACROSS (GMDS__N == 2 && GMDS__K_2)
#define GMDS_CONCURRENT_STARS 0
#define GMDS_COORDINATES GMDS__DIM
#define GMDS_SIMPLICIAL 0
#define GMDS_HAS_TRIANGLES 1
#define GMDS_HAS_TETRAHEDRA 1
#define GMDS__HAS_TETRAHEDRA 1
#define GMDS_ADDS_FACES (GMDS__N == 2)
#define GMDS_ADDS_LOCALLY 0 /* a face that touches others at a node alone is refused */
#define GMDS_ADDS_REGIONS (GMDS__N == 3)
#define GMDS_STARS (GMDS__N == 3 && GMDS__K_3 && !GMDS__K_1 && !GMDS__K_2)
#define GMDS_LISTS_CELLS ((GMDS__N == 2 && GMDS__K_2) || (GMDS__N == 3 && GMDS__K_3))

#define GMDS__LETTER_0 "N"
#define GMDS__LETTER_1 "E"
#define GMDS__LETTER_2 "F"
#define GMDS__LETTER_3 "R"
#define GMDS__WORD_0 "nodes"
#define GMDS__WORD_1 "edges"
#define GMDS__WORD_2 "faces"
#define GMDS__WORD_3 "regions"
#define GMDS__NOT_KEPT(i, j, missing) \
  GMDS_UNAVAILABLE("gmds: map '" GMDS_TEXT(GMDS_PREFIX) "' cannot answer " #i "->" #j ": keep " missing)
#define GMDS__KEEP(k) GMDS__KEEP_(k)
#define GMDS__KEEP_(k) GMDS__WORD_##k ": add " GMDS__LETTER_##k " to GMDS_MODEL"
