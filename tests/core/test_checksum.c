/* The checksum of cells against values computed from its definition, by another hand. */
#include "harness.h"
#include <gmds/checksum.h>

/* splitmix64 of the harness adds its constant, then finalises: mix64((h ^ w) + constant) is its next value from h ^ w.
 */
static uint64_t step(uint64_t h, double x)
{
  uint64_t w = 0;
  memcpy(&w, &x, sizeof w);
  uint64_t state = h ^ w;
  return random_bits(&state);
}

START_TEST(a_triangle_has_the_sum_of_its_sorted_points)
{
  const double xy[] = {1, 0, 0, 0, 0, 1};
  const double sorted[] = {0, 0, 0, 1, 1, 0};
  uint64_t expected = 0, h = 0;
  for (size_t k = 0; k < 6; k++)
    expected = step(expected, sorted[k]);
  gmds_id nodes[3] = {0, 1, 2};
  ck_assert_int_eq(gmds_checksum_cell(2, xy, 3, nodes, &h), GMDS_OK);
  ck_assert_uint_eq(h, expected);
}
END_TEST

START_TEST(one_value_is_pinned)
{
  /* mix64(0x9e3779b97f4a7c15), the first value of splitmix64 from 0: a cell of one point has two steps */
  const double xy[] = {0, 0};
  uint64_t h = 0, state = UINT64_C(0xe220a8397b1dcdaf);
  gmds_id node = 0;
  ck_assert_int_eq(gmds_checksum_cell(2, xy, 1, &node, &h), GMDS_OK);
  ck_assert_uint_eq(h, random_bits(&state));
}
END_TEST

START_TEST(the_order_of_nodes_and_the_sign_of_zero_do_not_matter)
{
  const double a[] = {0.5, -0.0, 0.5, 3, -1, 2, 0.5, 1}, b[] = {-1, 2, 0.5, 0.0, 0.5, 1, 0.5, 3};
  static const gmds_id turns[4][4] = {{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}, {1, 3, 0, 2}};
  uint64_t first = 0, h = 0;
  gmds_id nodes[4] = {0, 1, 2, 3};
  ck_assert_int_eq(gmds_checksum_cell(2, b, 4, nodes, &first), GMDS_OK);
  for (int t = 0; t < 4; t++) {
    memcpy(nodes, turns[t], sizeof nodes);
    ck_assert_int_eq(gmds_checksum_cell(2, a, 4, nodes, &h), GMDS_OK);
    ck_assert_uint_eq(h, first);
  }
  nodes[0] = 1;
  ck_assert_int_eq(gmds_checksum_cell(2, a, 3, nodes, &h), GMDS_OK);
  ck_assert_uint_ne(h, first);
}
END_TEST

START_TEST(three_coordinates_are_taken_in_their_order)
{
  const double xyz[] = {1, 2, 3, 1, 2, -3, 0, 9, 9};
  const size_t sorted[] = {2, 1, 0};
  uint64_t expected = 0, h = 0;
  for (size_t k = 0; k < 3; k++)
    for (size_t c = 0; c < 3; c++)
      expected = step(expected, xyz[3 * sorted[k] + c]);
  gmds_id nodes[3] = {0, 1, 2};
  ck_assert_int_eq(gmds_checksum_cell(3, xyz, 3, nodes, &h), GMDS_OK);
  ck_assert_uint_eq(h, expected);
  h = 8;
  ck_assert_int_eq(gmds_checksum_cell(4, xyz, 3, nodes, &h), GMDS_ERR_ARGUMENT);
  ck_assert_uint_eq(h, 8);
}
END_TEST

RUN_SUITE("checksum", a_triangle_has_the_sum_of_its_sorted_points, one_value_is_pinned,
          the_order_of_nodes_and_the_sign_of_zero_do_not_matter, three_coordinates_are_taken_in_their_order)
