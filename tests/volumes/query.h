/* The cases of table.h's switch for the cells of dimension TEST_A. */
#define TEST_JOIN_(x, a, b) x##_##a##_##b
#define TEST_JOIN(x, a, b) TEST_JOIN_(x, a, b)
#if TEST_JOIN(GMDS__CAN, TEST_A, 0)
case 4 * TEST_A + 0:
return TEST_JOIN(get_adj, TEST_A, 0)(m, c, out);
#endif
#if TEST_JOIN(GMDS__CAN, TEST_A, 1)
case 4 * TEST_A + 1:
return TEST_JOIN(get_adj, TEST_A, 1)(m, c, out);
#endif
#if TEST_JOIN(GMDS__CAN, TEST_A, 2)
case 4 * TEST_A + 2:
return TEST_JOIN(get_adj, TEST_A, 2)(m, c, out);
#endif
#if TEST_JOIN(GMDS__CAN, TEST_A, 3)
case 4 * TEST_A + 3:
return TEST_JOIN(get_adj, TEST_A, 3)(m, c, out);
#endif
#undef TEST_JOIN
#undef TEST_JOIN_
#undef TEST_A
