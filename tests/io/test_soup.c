/* The soup object. */
#include "soup_tools.h"

static const double corner[3] = {1, 2, 3};

START_TEST(every_cell_type_has_its_numbers)
{
  ck_assert_int_eq(gmds_cell_type_dimension(GMDS_VERTEX), 0);
  ck_assert_int_eq(gmds_cell_type_dimension(GMDS_POLYGON), 2);
  ck_assert_int_eq(gmds_cell_type_dimension(GMDS_PRISM), 3);
  ck_assert_int_eq(gmds_cell_type_points(GMDS_POLYGON), 0);
  ck_assert_int_eq(gmds_cell_type_points(GMDS_HEXAHEDRON), 8);
  ck_assert_str_eq(gmds_cell_type_text(GMDS_PYRAMID), "pyramid");
  ck_assert_str_eq(gmds_cell_type_text(GMDS_CELL_TYPE_COUNT), "unknown cell type");
}
END_TEST

START_TEST(what_is_appended_is_there)
{
  held *h = held_new(3);
  for (int p = 0; p < 100; p++)
    ck_assert_int_eq(gmds_soup_add_point(&h->soup, corner), GMDS_OK);
  for (gmds_id c = 0; c < 90; c++) {
    gmds_id corners[5] = {c, c + 1, c + 2, c + 3, c + 4};
    gmds_cell_type type = c % 2 ? GMDS_POLYGON : GMDS_TETRAHEDRON;
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, type, c % 2 ? 5 : 4, corners), GMDS_OK);
  }
  ck_assert_uint_eq(h->soup.begin[90], 45 * 4 + 45 * 5);
  for (size_t c = 0; c < 90; c++)
    ck_assert_uint_eq(h->soup.corners[h->soup.begin[c]], c);
  size_t count[4];
  gmds_soup_count(&h->soup, count);
  ck_assert_uint_eq(count[2], 45);
  ck_assert_uint_eq(count[3], 45);
  gmds_soup_trim(&h->soup);
  ck_assert_uint_eq(h->memory.live, 100 * 3 * sizeof(double) + 90 + 91 * sizeof(size_t) + 405 * sizeof(gmds_id));
  held_free(h);
}
END_TEST

START_TEST(wrong_cells_are_refused_and_nothing_is_appended)
{
  held *h = held_new(2);
  const gmds_id corners[] = {0, 1, 2, 3};
  for (int p = 0; p < 3; p++)
    ck_assert_int_eq(gmds_soup_add_point(&h->soup, corner), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_QUADRILATERAL, 4, corners), GMDS_ERR_CELL);
  ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_TRIANGLE, 2, corners), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_POLYGON, 2, corners), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_CELL_TYPE_COUNT, 3, corners), GMDS_ERR_ARGUMENT);
  ck_assert_uint_eq(h->soup.n_cells, 0);
  ck_assert_ptr_null(h->soup.begin);
  held_free(h);
}
END_TEST

START_TEST(reserve_is_exact_and_enough)
{
  held *h = held_new(2);
  ck_assert_int_eq(gmds_soup_reserve(&h->soup, 10, 5, 15), GMDS_OK);
  size_t reserved = h->memory.live;
  ck_assert_uint_eq(reserved, 10 * 2 * sizeof(double) + 5 + 6 * sizeof(size_t) + 15 * sizeof(gmds_id));
  ck_assert_uint_eq(h->soup.begin[0], 0);
  const gmds_id corners[] = {0, 1, 2};
  for (int p = 0; p < 10; p++)
    ck_assert_int_eq(gmds_soup_add_point(&h->soup, corner), GMDS_OK);
  for (int c = 0; c < 5; c++)
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_TRIANGLE, 3, corners), GMDS_OK);
  ck_assert_uint_eq(h->memory.live, reserved);
  ck_assert_int_eq(gmds_soup_reserve(&h->soup, SIZE_MAX / 8, 0, 0), GMDS_ERR_MEMORY);
  ck_assert_int_eq(gmds_soup_reserve(&h->soup, 0, SIZE_MAX, 0), GMDS_ERR_MEMORY);
  ck_assert_uint_eq(h->memory.live, reserved);
  held_free(h);
}
END_TEST

/* Appends until memory runs out at the k-th call, for every k: what was there stays, and all is given back. */
START_TEST(a_failed_append_changes_nothing)
{
  for (long k = 0; k < 40; k++) {
    failing f = {.until = k};
    gmds_allocator allocator = failing_allocator(&f);
    gmds_memory memory;
    gmds_memory_init(&memory, &allocator);
    gmds_soup soup;
    gmds_soup_init(&soup, &memory, 3);
    gmds_status status = GMDS_OK;
    gmds_attribute *columns[4] = {NULL};
    for (int i = 0; i < 4 && status == GMDS_OK && k > 2; i++) {
      const char name[] = {(char)('a' + i), 0};
      status = gmds_soup_add_attribute(&soup, i % 2 ? GMDS_OF_CELLS : GMDS_OF_POINTS, name, GMDS_ID, 1, &columns[i]);
    }
    while (status == GMDS_OK && soup.n_cells < 2000) {
      size_t points = soup.n_points, cells = soup.n_cells;
      status = gmds_soup_add_point(&soup, corner);
      if (status != GMDS_OK) {
        ck_assert_uint_eq(soup.n_points, points);
        break;
      }
      gmds_id c = (gmds_id)points, corners[] = {c, c, c};
      status = gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, corners);
      if (status != GMDS_OK)
        ck_assert_uint_eq(soup.n_cells, cells);
      for (int i = 0; i < 4 && status == GMDS_OK; i++)
        if (columns[i])
          ((gmds_id *)columns[i]->data)[c] = c;
    }
    for (size_t c = 0; c < soup.n_cells; c++)
      for (int i = 0; i < 4; i++)
        ck_assert(!columns[i] || ((gmds_id *)columns[i]->data)[c] == c);
    for (size_t c = 0; c < soup.n_cells; c++)
      ck_assert_uint_eq(soup.corners[soup.begin[c]], c);
    gmds_soup_trim(&soup);
    gmds_soup_clear(&soup);
    ck_assert_uint_eq(f.live, 0);
  }
}
END_TEST

/* A tetrahedron of points 0 to 3 as a stream of faces. */
static const gmds_id tetrahedron[] = {4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
enum { STREAM = sizeof tetrahedron / sizeof *tetrahedron };

START_TEST(polyhedra_are_held_against_their_counts)
{
  held *h = held_new(3);
  gmds_ids points;
  gmds_ids_init(&points, &h->memory);
  for (int p = 0; p < 4; p++)
    ck_assert_int_eq(gmds_soup_add_point(&h->soup, corner), GMDS_OK);
  ck_assert_int_eq(gmds_cell_type_dimension(GMDS_POLYHEDRON), 3);
  ck_assert_int_eq(gmds_cell_type_points(GMDS_POLYHEDRON), 0);
  ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_POLYHEDRON, STREAM, tetrahedron), GMDS_OK);
  ck_assert_int_eq(gmds_soup_cell_points(&h->soup, 0, &points), GMDS_OK);
  ck_assert_uint_eq(points.n, 4);
  for (gmds_id k = 0; k < 4; k++)
    ck_assert_uint_eq(points.data[k], k);
  for (size_t n = 0; n < STREAM; n++)
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_POLYHEDRON, n, tetrahedron), GMDS_ERR_ARGUMENT);
  for (size_t k = 0; k < STREAM; k++) { /* a count that is wrong in any way, a point that is not there */
    gmds_id wrong[STREAM];
    memcpy(wrong, tetrahedron, sizeof wrong);
    wrong[k] = GMDS_NONE;
    gmds_status expected = k % 4 == 0 && k == 0 ? GMDS_ERR_ARGUMENT : k % 4 == 1 ? GMDS_ERR_ARGUMENT : GMDS_ERR_CELL;
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_POLYHEDRON, STREAM, wrong), expected);
    wrong[k] = 2;
    if (k % 4 == 1 || !k)
      ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_POLYHEDRON, STREAM, wrong), GMDS_ERR_ARGUMENT);
  }
  ck_assert_uint_eq(h->soup.n_cells, 1);
  gmds_ids_clear(&points);
  held_free(h);
}
END_TEST

START_TEST(attributes_grow_with_points_and_cells)
{
  held *h = held_new(2);
  gmds_attribute *heat = NULL, *tag = NULL, *none = NULL;
  gmds_id c[3] = {0, 0, 0};
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_POINTS, "heat", GMDS_DOUBLE, 3, &heat), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "heat", GMDS_INT, 1, &tag), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "heat", GMDS_INT, 1, &none), GMDS_ERR_CONFLICT);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "", GMDS_INT, 1, &none), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_PLACE_COUNT, "a", GMDS_INT, 1, &none), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_soup_add_attribute(&h->soup, GMDS_OF_CELLS, "a", GMDS_INT, 0, &none), GMDS_ERR_ARGUMENT);
  ck_assert_ptr_null(none);
  for (int k = 0; k < 100; k++) {
    ck_assert_int_eq(gmds_soup_add_point(&h->soup, corner), GMDS_OK);
    ck_assert_int_eq(gmds_soup_add_cell(&h->soup, GMDS_TRIANGLE, 3, c), GMDS_OK);
    ck_assert(((double *)heat->data)[3 * k + 2] == 0 && ((int *)tag->data)[k] == 0);
    ((double *)heat->data)[3 * k + 2] = k;
    ((int *)tag->data)[k] = -k;
  }
  gmds_soup_trim(&h->soup);
  for (int k = 0; k < 100; k++)
    ck_assert(((double *)heat->data)[3 * k + 2] == k && ((int *)tag->data)[k] == -k);
  ck_assert_ptr_eq(gmds_soup_find_attribute(&h->soup, GMDS_OF_POINTS, "heat"), heat);
  size_t with = h->memory.live;
  gmds_soup_remove_attribute(&h->soup, GMDS_OF_POINTS, tag); /* not of this place */
  ck_assert_uint_eq(h->memory.live, with);
  gmds_soup_remove_attribute(&h->soup, GMDS_OF_POINTS, heat);
  ck_assert_uint_eq(h->memory.live, with - sizeof(gmds_attribute) - 5 - 100 * 3 * sizeof(double));
  ck_assert_ptr_null(gmds_soup_find_attribute(&h->soup, GMDS_OF_POINTS, "heat"));
  held_free(h);
}
END_TEST

RUN_SUITE("soup", every_cell_type_has_its_numbers, what_is_appended_is_there,
          wrong_cells_are_refused_and_nothing_is_appended, reserve_is_exact_and_enough, a_failed_append_changes_nothing,
          polyhedra_are_held_against_their_counts, attributes_grow_with_points_and_cells)
