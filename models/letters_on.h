/* Gives the letters of a mask their meaning while <gmds/mesh.h> reads GMDS_MODEL, GMDS_FACES and GMDS_REGIONS. What a
 * user may have called N or F is put aside and comes back with letters_off.h. */
#pragma push_macro("N")
#pragma push_macro("E")
#pragma push_macro("F")
#pragma push_macro("R")
#pragma push_macro("DIM2")
#pragma push_macro("DIM3")
#pragma push_macro("N2N")
#pragma push_macro("N2E")
#pragma push_macro("N2F")
#pragma push_macro("N2R")
#pragma push_macro("E2N")
#pragma push_macro("E2E")
#pragma push_macro("E2F")
#pragma push_macro("E2R")
#pragma push_macro("F2N")
#pragma push_macro("F2E")
#pragma push_macro("F2F")
#pragma push_macro("F2R")
#pragma push_macro("R2N")
#pragma push_macro("R2E")
#pragma push_macro("R2F")
#pragma push_macro("R2R")
#pragma push_macro("TRIANGLE")
#pragma push_macro("QUADRILATERAL")
#pragma push_macro("POLYGON")
#pragma push_macro("TETRAHEDRON")
#pragma push_macro("PYRAMID")
#pragma push_macro("PRISM")
#pragma push_macro("HEXAHEDRON")
#pragma push_macro("POLYHEDRON")
#undef N
#undef E
#undef F
#undef R
#undef DIM2
#undef DIM3
#undef N2N
#undef N2E
#undef N2F
#undef N2R
#undef E2N
#undef E2E
#undef E2F
#undef E2R
#undef F2N
#undef F2E
#undef F2F
#undef F2R
#undef R2N
#undef R2E
#undef R2F
#undef R2R
#undef TRIANGLE
#undef QUADRILATERAL
#undef POLYGON
#undef TETRAHEDRON
#undef PYRAMID
#undef PRISM
#undef HEXAHEDRON
#undef POLYHEDRON
#define N GMDS_N
#define E GMDS_E
#define F GMDS_F
#define R GMDS_R
#define DIM2 GMDS_DIM2
#define DIM3 GMDS_DIM3
#define N2N GMDS_RELATION_BIT(0, 0)
#define N2E GMDS_RELATION_BIT(0, 1)
#define N2F GMDS_RELATION_BIT(0, 2)
#define N2R GMDS_RELATION_BIT(0, 3)
#define E2N GMDS_RELATION_BIT(1, 0)
#define E2E GMDS_RELATION_BIT(1, 1)
#define E2F GMDS_RELATION_BIT(1, 2)
#define E2R GMDS_RELATION_BIT(1, 3)
#define F2N GMDS_RELATION_BIT(2, 0)
#define F2E GMDS_RELATION_BIT(2, 1)
#define F2F GMDS_RELATION_BIT(2, 2)
#define F2R GMDS_RELATION_BIT(2, 3)
#define R2N GMDS_RELATION_BIT(3, 0)
#define R2E GMDS_RELATION_BIT(3, 1)
#define R2F GMDS_RELATION_BIT(3, 2)
#define R2R GMDS_RELATION_BIT(3, 3)
#define TRIANGLE 1
#define QUADRILATERAL 2
#define POLYGON 4
#define TETRAHEDRON 1
#define PYRAMID 2
#define PRISM 4
#define HEXAHEDRON 8
#define POLYHEDRON 16
