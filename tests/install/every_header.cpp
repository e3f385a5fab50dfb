// Every public header that is no template, seen from C++: a call of each kind, defined inline and in the library.
#include "every_header.h"
#include <cstdio>
#include <cstring>

static int failures = 0;

static void expect(bool holds, const char *claim)
{
  if (!holds) {
    std::fprintf(stderr, "does not hold: %s\n", claim);
    failures++;
  }
}

static void lists(gmds_memory *memory)
{
  gmds_ids ids;
  gmds_bits bits;
  gmds_csr csr;
  gmds_rows rows;
  gmds_cells cells;
  gmds_attribute *heat = nullptr;
  gmds_ids_init(&ids, memory);
  expect(gmds_ids_push(&ids, 7) == GMDS_OK && gmds_ids_has(&ids, 7), "a list holds what was put in");
  gmds_ids_clear(&ids);
  expect(gmds_bits_init(&bits, memory, 100) == GMDS_OK && !gmds_bits_get(&bits, 99), "bits begin unset");
  gmds_bits_clear(&bits);
  gmds_csr_init(&csr, memory);
  gmds_csr_clear(&csr);
  gmds_rows_init(&rows, 0);
  gmds_rows_clear(&rows, memory);
  gmds_cells_init(&cells, memory, 10);
  expect(gmds_attribute_add(&cells, "heat", GMDS_DOUBLE, 1, &heat) == GMDS_OK && heat, "cells take attributes");
  gmds_cells_clear(&cells);
}

static void geometry(gmds_memory *memory)
{
  const double a[] = {0, 0}, b[] = {1, 0}, c[] = {0, 1}, d[] = {1, 1};
  const double xy[] = {0, 0, 1, 0, 0, 0};
  gmds_id order[3];
  size_t distinct = 0;
  expect(gmds_predicates_check() == GMDS_OK, "this platform computes as the predicates assume");
  expect(gmds_orient2d(a, b, c) == 1, "a, b, c turn left");
  expect(gmds_incircle(a, b, c, d) == 0, "the corners of a square lie on a circle");
  expect(gmds_order_points(memory, nullptr, 1, 2, 3, xy, nullptr, order, nullptr, &distinct) == GMDS_OK &&
             distinct == 2,
         "equal points are found");
}

static void soups(gmds_memory *memory)
{
  gmds_soup soup;
  gmds_error error = {};
  gmds_id corners[] = {0, 1, 2};
  uint64_t h = 0;
  gmds_soup_init(&soup, memory, 2);
  expect(gmds_make_points("grid:2", 2, &error, &soup) == GMDS_OK && soup.n_points == 4, "a grid of two points a side");
  expect(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, corners) == GMDS_OK, "a soup takes a triangle");
  expect(gmds_checksum_cell(2, soup.points, 3, corners, &h) == GMDS_OK && h != 0, "a triangle has a checksum");
  expect(gmds_read_soup("no such file.off", 0, &error, &soup) != GMDS_OK, "a soup that is not empty is refused");
  expect(std::strlen(error.text) > 0, "a failure has a sentence");
  gmds_soup_clear(&soup);
}

static void volumes(gmds_memory *memory)
{
  gmds_complex complex;
  gmds_volume volume;
  gmds_soup soup;
  gmds_csr csr;
  gmds_stored_relations stored = {};
  const double x[] = {0, 0, 0};
  const gmds_id corners[] = {0, 1, 2, 3};
  expect(gmds_shape_of(GMDS_PRISM)->faces == 5 && !gmds_shape_of(GMDS_POLYHEDRON), "a prism has five faces");
  gmds_soup_init(&soup, memory, 3);
  for (int k = 0; k < 4; k++)
    expect(gmds_soup_add_point(&soup, x) == GMDS_OK, "a soup takes points in space");
  expect(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, corners) == GMDS_OK, "a soup takes a tetrahedron");
  gmds_volume_init(&volume, memory);
  expect(gmds_volume_from_soup(&volume, &soup, nullptr) == GMDS_OK, "a volume is made from a soup");
  gmds_csr_init(&csr, memory);
  expect(gmds_complex_relation(&volume.complex, 0, 3, 0, &csr, nullptr) == GMDS_OK && csr.begin[4] == 4,
         "four nodes are on the tetrahedron");
  expect(gmds_check_entries(&stored, memory, nullptr) == GMDS_OK, "nothing stored, nothing wrong");
  gmds_csr_clear(&csr);
  gmds_volume_clear(&volume);
  gmds_soup_clear(&soup);
  gmds_complex_init(&complex, memory, 0);
  gmds_complex_clear(&complex);
}

#define COUNT_NAMED(name, mask, when) +1
static void models()
{
  unsigned mask = 0;
  expect(gmds_mask_parse("N|F|F2N|F2F", nullptr, &mask) == GMDS_OK, "a mask is read");
  expect(mask == (GMDS_N | GMDS_F | GMDS_RELATION_BIT(2, 0) | GMDS_RELATION_BIT(2, 2)), "and is what was written");
  expect(gmds_path_of(mask, 2, 0).cost == GMDS_COST_DIRECT, "F2N answers 2->0");
  expect(gmds_census_size(2) == 128, "the census of the plane has 128 masks");
  expect(0 GMDS_NAMED_LIST(COUNT_NAMED) == 10, "ten models of volumes have names");
}

int main()
{
  gmds_memory memory;
  gmds_delaunay_result result;
  gmds_links links = {nullptr, nullptr};
  gmds_relations none = {};
  gmds_memory_init(&memory, nullptr);
  lists(&memory);
  geometry(&memory);
  soups(&memory);
  volumes(&memory);
  models();
  gmds_delaunay_result_init(&result, nullptr);
  gmds_delaunay_result_clear(&result);
  expect(links.edges == nullptr && none.mask == 0, "structures can be made");
  expect(memory.live == 0, "all memory is given back");
  expect(std::strcmp(gmds_status_text(GMDS_OK), "done") == 0, "a status has words");
  expect(std::strlen(GMDS_VERSION) > 0 && gmds_link_check == GMDS_ID_BITS, "library and headers belong together");
  return failures != 0;
}
