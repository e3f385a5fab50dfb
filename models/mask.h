/* Reads GMDS_MODEL, GMDS_FACES and GMDS_REGIONS into macros that mean the same after the letters are gone:
 *   GMDS__K_i       1 when i-cells are kept            GMDS__S_i_j   1 when i2j is stored
 *   GMDS__MASK      the mask as one integer            GMDS__DIM     coordinates a node
 *   GMDS__SIMPLICIAL  1 when all faces are triangles   GMDS__SIDES   sides of a face, 0 where faces differ
 *                     (and all regions tetrahedra)     GMDS__CORNERS, GMDS__RIMS, GMDS__WALLS  nodes, edges, faces of a
 *                                                                    region, 0 where regions differ
 * and refuses masks that contradict themselves, in one sentence. */
#include <gmds/models/letters_on.h>

#if (GMDS_MODEL + 0) == 0
#  error "gmds: GMDS_MODEL is empty or misspelt: name what the model keeps and stores, for instance (N|F|F2N|F2F)"
#  undef GMDS_MODEL
#  define GMDS_MODEL (N | F) /* so that nothing more is said */
#endif

/* The compiler reads the mask too: a misspelt relation, 0 to the preprocessor, is an undeclared name to it. */
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
#if (GMDS_MODEL) & (R | N2R | E2R | F2R | R2N | R2E | R2F | R2R)
#  define GMDS__K_3 1
#else
#  define GMDS__K_3 0
#endif
#if (GMDS_MODEL) & N2N
#  define GMDS__S_0_0 1
#else
#  define GMDS__S_0_0 0
#endif
#if (GMDS_MODEL) & N2E
#  define GMDS__S_0_1 1
#else
#  define GMDS__S_0_1 0
#endif
#if (GMDS_MODEL) & N2F
#  define GMDS__S_0_2 1
#else
#  define GMDS__S_0_2 0
#endif
#if (GMDS_MODEL) & N2R
#  define GMDS__S_0_3 1
#else
#  define GMDS__S_0_3 0
#endif
#if (GMDS_MODEL) & E2N
#  define GMDS__S_1_0 1
#else
#  define GMDS__S_1_0 0
#endif
#if (GMDS_MODEL) & E2E
#  define GMDS__S_1_1 1
#else
#  define GMDS__S_1_1 0
#endif
#if (GMDS_MODEL) & E2F
#  define GMDS__S_1_2 1
#else
#  define GMDS__S_1_2 0
#endif
#if (GMDS_MODEL) & E2R
#  define GMDS__S_1_3 1
#else
#  define GMDS__S_1_3 0
#endif
#if (GMDS_MODEL) & F2N
#  define GMDS__S_2_0 1
#else
#  define GMDS__S_2_0 0
#endif
#if (GMDS_MODEL) & F2E
#  define GMDS__S_2_1 1
#else
#  define GMDS__S_2_1 0
#endif
#if (GMDS_MODEL) & F2F
#  define GMDS__S_2_2 1
#else
#  define GMDS__S_2_2 0
#endif
#if (GMDS_MODEL) & F2R
#  define GMDS__S_2_3 1
#else
#  define GMDS__S_2_3 0
#endif
#if (GMDS_MODEL) & R2N
#  define GMDS__S_3_0 1
#else
#  define GMDS__S_3_0 0
#endif
#if (GMDS_MODEL) & R2E
#  define GMDS__S_3_1 1
#else
#  define GMDS__S_3_1 0
#endif
#if (GMDS_MODEL) & R2F
#  define GMDS__S_3_2 1
#else
#  define GMDS__S_3_2 0
#endif
#if (GMDS_MODEL) & R2R
#  define GMDS__S_3_3 1
#else
#  define GMDS__S_3_3 0
#endif
#if GMDS__K_3 || ((GMDS_MODEL)&DIM3 && !((GMDS_MODEL)&DIM2))
#  define GMDS__DIM 3
#else
#  define GMDS__DIM 2
#endif

#if GMDS__K_3
#  ifndef GMDS_REGIONS
#    define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON)
#  endif
#  if (GMDS_REGIONS) <= 0 || (GMDS_REGIONS) > 31
#    error \
        "gmds: GMDS_REGIONS must be TETRAHEDRON, PYRAMID, PRISM, HEXAHEDRON, POLYHEDRON, or several with | between them"
#    define GMDS__REFUSED 1
#    undef GMDS_REGIONS
#    define GMDS_REGIONS TETRAHEDRON
#  endif
enum { GMDS_FN(regions) = (GMDS_REGIONS) };
#  if (GMDS_REGIONS) == TETRAHEDRON
#    define GMDS__TETRAHEDRA 1
#    define GMDS__CORNERS 4
#    define GMDS__RIMS 6
#    define GMDS__WALLS 4
#  elif (GMDS_REGIONS) == PYRAMID
#    define GMDS__CORNERS 5
#    define GMDS__RIMS 8
#    define GMDS__WALLS 5
#  elif (GMDS_REGIONS) == PRISM
#    define GMDS__CORNERS 6
#    define GMDS__RIMS 9
#    define GMDS__WALLS 5
#  elif (GMDS_REGIONS) == HEXAHEDRON
#    define GMDS__CORNERS 8
#    define GMDS__RIMS 12
#    define GMDS__WALLS 6
#  endif
#  ifndef GMDS__CORNERS
#    define GMDS__CORNERS 0
#    define GMDS__RIMS 0
#    define GMDS__WALLS 0
#  endif
#  ifndef GMDS__TETRAHEDRA
#    define GMDS__TETRAHEDRA 0
#  endif
#  if (GMDS_REGIONS) & TETRAHEDRON
#    define GMDS__HAS_TETRAHEDRA 1
#  else
#    define GMDS__HAS_TETRAHEDRA 0
#  endif
#  if (GMDS_REGIONS) & POLYHEDRON
#    define GMDS__POLYHEDRA 1
#  else
#    define GMDS__POLYHEDRA 0
#  endif
#  ifndef GMDS_FACES
#    if GMDS__TETRAHEDRA
#      define GMDS_FACES TRIANGLE
#    elif GMDS__CORNERS == 8
#      define GMDS_FACES QUADRILATERAL
#    elif GMDS__POLYHEDRA
#      define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#    else
#      define GMDS_FACES (TRIANGLE | QUADRILATERAL)
#    endif
#  endif
#  if GMDS__K_2 && (GMDS_FACES) > 0 && (GMDS_FACES) < 8 &&                                           \
      (((GMDS_REGIONS) != HEXAHEDRON && (GMDS_REGIONS) != POLYHEDRON && !((GMDS_FACES)&TRIANGLE)) || \
       ((GMDS_REGIONS)&14 && !((GMDS_FACES)&QUADRILATERAL)))
#    error "gmds: GMDS_FACES leaves out a type of face that the regions of the model have"
#    define GMDS__REFUSED 1
#  endif
#else
#  define GMDS__TETRAHEDRA 0
#  define GMDS__HAS_TETRAHEDRA 0
#  define GMDS__CORNERS 0
#  define GMDS__RIMS 0
#  define GMDS__WALLS 0
#  define GMDS__POLYHEDRA 0
#endif

#ifndef GMDS_FACES
#  define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#endif
#if (GMDS_FACES) == TRIANGLE
#  define GMDS__SIDES 3
#  define GMDS__SIMPLICIAL (!GMDS__K_3 || GMDS__TETRAHEDRA)
#elif (GMDS_FACES) == QUADRILATERAL
#  define GMDS__SIDES 4
#  define GMDS__SIMPLICIAL 0
#elif (GMDS_FACES) > 0 && (GMDS_FACES) < 8
#  define GMDS__SIDES 0
#  define GMDS__SIMPLICIAL 0
#else
#  error "gmds: GMDS_FACES must be TRIANGLE, QUADRILATERAL, POLYGON, or several with | between them"
#  undef GMDS_FACES
#  define GMDS_FACES TRIANGLE /* so that nothing more is said */
#  define GMDS__SIDES 3
#  define GMDS__SIMPLICIAL 1
#endif
enum { GMDS_FN(faces) = (GMDS_FACES) };
#if (GMDS_FACES) & TRIANGLE
#  define GMDS__TRIANGLES 1
#else
#  define GMDS__TRIANGLES 0
#endif
#if (GMDS_FACES) & QUADRILATERAL
#  define GMDS__QUADRILATERALS 1
#else
#  define GMDS__QUADRILATERALS 0
#endif
#if (GMDS_FACES) & POLYGON
#  define GMDS__POLYGONS 1
#else
#  define GMDS__POLYGONS 0
#endif

/* One sentence, and then the model is taken for one that has everything, so that nothing more is said. */
#ifdef GMDS__REFUSED
#elif (GMDS_MODEL) >> 22
#  error "gmds: GMDS_MODEL holds something that is neither a cell, a relation, DIM2 nor DIM3"
#  define GMDS__REFUSED 1
#elif (GMDS_MODEL) & DIM2 && (GMDS_MODEL)&DIM3
#  error "gmds: GMDS_MODEL has both DIM2 and DIM3: a node has two coordinates or three"
#  define GMDS__REFUSED 1
#elif GMDS__K_3 && !((GMDS_MODEL)&R)
#  error "gmds: GMDS_MODEL stores a relation of regions but keeps none: add R"
#  define GMDS__REFUSED 1
#elif GMDS__K_3 && (GMDS_MODEL)&DIM2
#  error "gmds: a model of volumes has nodes of three coordinates: take DIM2 out of GMDS_MODEL"
#  define GMDS__REFUSED 1
#elif !GMDS__K_0 || !(GMDS__K_2 || GMDS__K_3)
#  error "gmds: a model keeps nodes and faces, or nodes and regions: add N|F or N|R to GMDS_MODEL"
#  define GMDS__REFUSED 1
#elif !GMDS__K_1 && \
    (GMDS__S_0_1 || GMDS__S_1_0 || GMDS__S_1_1 || GMDS__S_1_2 || GMDS__S_1_3 || GMDS__S_2_1 || GMDS__S_3_1)
#  error "gmds: GMDS_MODEL stores a relation of edges but keeps none: add E"
#  define GMDS__REFUSED 1
#elif !GMDS__K_2 && \
    (GMDS__S_0_2 || GMDS__S_1_2 || GMDS__S_2_0 || GMDS__S_2_1 || GMDS__S_2_2 || GMDS__S_2_3 || GMDS__S_3_2)
#  error "gmds: GMDS_MODEL stores a relation of faces but keeps none: add F"
#  define GMDS__REFUSED 1
#elif GMDS__POLYHEDRA && !(GMDS__S_3_2 && GMDS__S_2_0)
#  error "gmds: a polyhedron is known by its faces and their nodes: add R2F|F2N to GMDS_MODEL"
#  define GMDS__REFUSED 1
#elif GMDS__S_1_1 && !GMDS__S_0_1 && !GMDS__S_1_0
#  error "gmds: E2E can be kept true only where edges and nodes are linked: add E2N or N2E to GMDS_MODEL"
#  define GMDS__REFUSED 1
#endif
#include <gmds/models/letters_off.h>
#ifdef GMDS__REFUSED
#  include <gmds/models/mask_refused.h>
#endif

#define GMDS__MASK                                                                                                \
  (GMDS__K_0 * GMDS_CELL_BIT(0) | GMDS__K_1 * GMDS_CELL_BIT(1) | GMDS__K_2 * GMDS_CELL_BIT(2) |                   \
   GMDS__K_3 * GMDS_CELL_BIT(3) | GMDS__S_0_0 * GMDS_RELATION_BIT(0, 0) | GMDS__S_0_1 * GMDS_RELATION_BIT(0, 1) | \
   GMDS__S_0_2 * GMDS_RELATION_BIT(0, 2) | GMDS__S_0_3 * GMDS_RELATION_BIT(0, 3) |                                \
   GMDS__S_1_0 * GMDS_RELATION_BIT(1, 0) | GMDS__S_1_1 * GMDS_RELATION_BIT(1, 1) |                                \
   GMDS__S_1_2 * GMDS_RELATION_BIT(1, 2) | GMDS__S_1_3 * GMDS_RELATION_BIT(1, 3) |                                \
   GMDS__S_2_0 * GMDS_RELATION_BIT(2, 0) | GMDS__S_2_1 * GMDS_RELATION_BIT(2, 1) |                                \
   GMDS__S_2_2 * GMDS_RELATION_BIT(2, 2) | GMDS__S_2_3 * GMDS_RELATION_BIT(2, 3) |                                \
   GMDS__S_3_0 * GMDS_RELATION_BIT(3, 0) | GMDS__S_3_1 * GMDS_RELATION_BIT(3, 1) |                                \
   GMDS__S_3_2 * GMDS_RELATION_BIT(3, 2) | GMDS__S_3_3 * GMDS_RELATION_BIT(3, 3))

/* How a relation of faces is stored: inline when all faces have the same number of sides. */
#if GMDS__SIDES
#  define GMDS__INLINE 1
#else
#  define GMDS__INLINE 0
#endif
/* F2F of inline faces that keep their nodes also remembers the side one arrives by: 4 * face + side. R2R of tetrahedra
 * that keep theirs likewise: 4 * region + face. Where there are regions, F2F is a set: an edge has any number of
 * faces. */
#if GMDS__K_3
#  define GMDS__CODED (GMDS__TETRAHEDRA && GMDS__S_3_0 && GMDS__S_3_3)
#else
#  define GMDS__CODED (GMDS__INLINE && GMDS__S_2_0 && GMDS__S_2_2)
#endif
