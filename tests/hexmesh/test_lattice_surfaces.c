/* Claims about whole surfaces on the lattice. */
#include "leaves.h"
#include <limits.h>

START_TEST(made_surfaces_lie_between_their_inside_and_what_they_cut)
{
  static const char *const specs[] = {"torus:20", "torus:61", "sphere:2", "sphere:7", "sphere:24"};
  for (size_t k = 0; k < 5; k++) {
    gmds_memory_init(&memory, NULL);
    gmds_error error = {.status = GMDS_OK};
    gmds_soup soup;
    make(specs[k], &soup);
    for (uint32_t base = 1; base < 4; base++) {
      const gmds_lattice_options o = {.base = {base, 1, base / 2}, .error = &error};
      gmds_lattice l;
      gmds_lattice_leaves leaves;
      wide v[2];
      check_surface(&soup, &o, 5, v, &l, &leaves);
      const wide volume = volume_of(&l);
      ck_assert(v[0] > 0 && v[0] <= volume && volume <= v[0] + v[1]);
      ck_assert(!l.n_turned && leaves.lowest == 0 && leaves.highest == 1);
      gmds_lattice_leaves_clear(&leaves);
      gmds_lattice_clear(&l);
    }
    gmds_soup_clear(&soup);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

static int by_triangle(const void *a, const void *b)
{
  return memcmp(a, b, 9 * sizeof(int32_t));
}

/* Faces in another order, each begun at another corner or turned, points moved by what doubles add exactly. */
START_TEST(order_turn_and_place_change_nothing)
{
  gmds_memory_init(&memory, NULL);
  gmds_error error = {.status = GMDS_OK};
  const gmds_lattice_options o = {.base = {2, 3, 1}, .margin = 0.125, .error = &error};
  gmds_soup soup, other;
  gmds_lattice l, m;
  gmds_lattice_leaves leaves, again;
  uint64_t seed = 5;
  make("torus:30", &soup);
  make("torus:30", &other);
  for (size_t k = 0; k < 3 * soup.n_points; k++) {
    soup.points[k] = rint(soup.points[k] * 0x1p20) * 0x1p-20;
    other.points[k] = soup.points[k] + (double)(k % 3) * 64 - 32;
  }
  for (size_t f = soup.n_cells; f-- > 1;) {
    gmds_id *a = other.corners + 3 * f, *b = other.corners + 3 * random_below(&seed, f + 1), swap[3];
    memcpy(swap, a, sizeof swap);
    memcpy(a, b, sizeof swap);
    for (size_t k = 0, first = random_below(&seed, 3), turn = 1 + random_below(&seed, 2); k < 3; k++)
      b[k] = swap[(first + turn * k) % 3];
  }
  lay(&soup, &o, &l);
  lay(&other, &o, &m);
  ck_assert(m.n_turned && !l.n_turned);
  refine(&l, 4, &leaves);
  refine(&m, 4, &again);
  ck_assert_uint_eq(leaves.n, again.n);
  for (size_t k = 0; k < leaves.n; k++)
    ck_assert(leaves.leaf[k].level == again.leaf[k].level && leaves.leaf[k].state == again.leaf[k].state &&
              !memcmp(leaves.leaf[k].at, again.leaf[k].at, sizeof leaves.leaf[k].at));
  const gmds_lattice_options threads = {.base = {2, 3, 1}, .margin = 0.125, .threads = 3, .error = &error};
  gmds_lattice_clear(&m);
  lay(&soup, &threads, &m);
  qsort(l.triangles, l.n_triangles, 9 * sizeof *l.triangles, by_triangle);
  qsort(m.triangles, m.n_triangles, 9 * sizeof *m.triangles, by_triangle);
  ck_assert_mem_eq(l.triangles, m.triangles, l.n_triangles * 9 * sizeof *l.triangles);
  gmds_lattice_leaves_clear(&leaves);
  gmds_lattice_leaves_clear(&again);
  gmds_lattice_clear(&l);
  gmds_lattice_clear(&m);
  gmds_soup_clear(&soup);
  gmds_soup_clear(&other);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

/* A box from (0, 0, 0) to (x, y, z) of quadrilaterals, turned outwards or inwards, its points from number `first` on.
 */
static void add_box(gmds_soup *soup, double x, double y, double z, double from, int inwards)
{
  static const gmds_id side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const gmds_id first = (gmds_id)soup->n_points;
  for (int k = 0; k < 8; k++) {
    const double p[3] = {from + (k & 1 ? x : 0), from + (k & 2 ? y : 0), from + (k & 4 ? z : 0)};
    ck_assert_int_eq(gmds_soup_add_point(soup, p), GMDS_OK);
  }
  for (int k = 0; k < 6; k++) {
    gmds_id nodes[4];
    for (int i = 0; i < 4; i++)
      nodes[i] = first + side[k][inwards ? 3 - i : i];
    ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_QUADRILATERAL, 4, nodes), GMDS_OK);
  }
}

/* A box in a box, either turned in or out, and two that cross: the winding tells, the parity is what it is. */
START_TEST(windings_tell_what_parity_does_not)
{
  static const struct {
    double second;
    int in[2];
    int32_t lowest, highest;
  } cases[] = {{0.25, {0, 1}, 0, 1}, {0.25, {0, 0}, 0, 2}, {0.25, {1, 1}, -2, 0}, {0.75, {0, 0}, 0, 2}};
  for (size_t k = 0; k < 4; k++) {
    gmds_memory_init(&memory, NULL);
    gmds_error error = {.status = GMDS_OK};
    const gmds_lattice_options o = {.margin = 0.25, .error = &error};
    gmds_soup soup;
    gmds_lattice l;
    gmds_lattice_leaves leaves;
    wide v[2];
    gmds_soup_init(&soup, &memory, 3);
    add_box(&soup, 1, 1, 1, 0, cases[k].in[0]);
    add_box(&soup, 0.5, 0.5, 0.5, cases[k].second, cases[k].in[1]);
    check_surface(&soup, &o, 5, v, &l, &leaves);
    ck_assert_uint_eq(l.n_triangles, 24);
    ck_assert_int_eq(leaves.lowest, cases[k].lowest);
    ck_assert_int_eq(leaves.highest, cases[k].highest);
    const double volume = 6 / (l.step[0] * l.step[1] * l.step[2]) * (k < 3 ? 1 - 0.125 : 1 + 0.125 - 2 * 0.015625);
    ck_assert((double)v[0] <= volume && volume <= (double)(v[0] + v[1]));
    gmds_lattice_leaves_clear(&leaves);
    gmds_lattice_clear(&l);
    gmds_soup_clear(&soup);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

static int near_corner(void *user, gmds_lattice_cell cell, gmds_lattice_state state)
{
  (void)state;
  ++*(size_t *)user;
  return !cell.at[0] && !cell.at[1] && !cell.at[2];
}

START_TEST(a_caller_decides_what_is_refined)
{
  gmds_memory_init(&memory, NULL);
  gmds_error error = {.status = GMDS_OK};
  const gmds_lattice_options o = {.base = {2, 2, 2}, .error = &error};
  gmds_soup soup;
  gmds_lattice l;
  gmds_lattice_leaves leaves;
  size_t asked = 0;
  make("sphere:9", &soup);
  lay(&soup, &o, &l);
  gmds_lattice_leaves_init(&leaves, &memory);
  ck_assert_int_eq(gmds_lattice_refine(&l, 6, near_corner, &asked, &leaves), GMDS_OK);
  ck_assert_uint_eq(asked, 8 * 6);
  ck_assert_uint_eq(leaves.n, 7 * 6 + 8);
  check_neighbours(&l, &leaves, 6);
  check_leaves(&l, &leaves);
  gmds_lattice_leaves_clear(&leaves);
  gmds_lattice_clear(&l);
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(what_has_no_inside_is_refused)
{
  gmds_memory_init(&memory, NULL);
  const gmds_lattice_options o = {.threads = 1};
  const double axis[] = {2, 2, 2};
  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 3);
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "a surface of no faces has no inside");
  add_box(&soup, 1, 1, 1, 0, 0);
  refuse(&soup, (gmds_lattice_options){.margin = -1}, GMDS_ERR_ARGUMENT, "a margin of -1: it can be up to 1");
  refuse(&soup, (gmds_lattice_options){.base = {1, 20000}}, GMDS_ERR_ARGUMENT,
         "20000 base cells along y: there can be from 1 to 16384");
  refuse(&soup, (gmds_lattice_options){.threads = 1000}, GMDS_ERR_ARGUMENT, "1000 threads: there can be from 1 to 256");
  soup.points[3 * 5 + 1] = NAN;
  refuse(&soup, o, GMDS_ERR_COORDINATE, "vertex 5 has a coordinate that is not a finite number");
  soup.points[3 * 5 + 1] = 1e308;
  soup.points[3 * 4 + 1] = -1e308;
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "an extent of inf along y cannot be divided in doubles");
  for (size_t k = 0; k < 8; k++)
    soup.points[3 * k + 1] = k & 2 ? 1e-300 : 0;
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "an extent of 1e-300 along y cannot be divided in doubles");
  for (size_t k = 0; k < 8; k++)
    soup.points[3 * k + 1] = 7;
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "the surface has no extent along y");
  ck_assert_int_eq(gmds_soup_add_point(&soup, axis), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, (const gmds_id[3]){0, 1, 8}), GMDS_OK);
  refuse(&soup, o, GMDS_ERR_CONFLICT, "face 6 is the third on the edge of vertices 0 and 1");
  gmds_soup_clear(&soup);
  gmds_soup_init(&soup, &memory, 3);
  add_box(&soup, 1, 1, 1, 0, 0);
  soup.n_cells--;
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "the surface is open: the edge of vertices 3 and 1 has one face, 0");
  gmds_soup_clear(&soup);
  gmds_soup_init(&soup, &memory, 2);
  refuse(&soup, o, GMDS_ERR_ARGUMENT, "points of 2 coordinates: a closed surface lies in space");
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

/* Points that snapping makes one: flat triangles are counted, and nothing else is different. */
START_TEST(flat_triangles_are_counted_and_do_no_harm)
{
  gmds_memory_init(&memory, NULL);
  gmds_error error = {.status = GMDS_OK};
  const gmds_lattice_options o = {.base = {1, 2, 1}, .error = &error};
  gmds_soup soup;
  gmds_lattice l;
  gmds_lattice_leaves leaves;
  wide v[2];
  make("torus:24", &soup);
  for (size_t k = 0; k < soup.n_points; k += 3) /* beside the next */
    for (int a = 0; a < 3; a++)
      soup.points[3 * k + (size_t)a] = soup.points[3 * k + 3 + (size_t)a] + 0x1p-40;
  check_surface(&soup, &o, 5, v, &l, &leaves);
  ck_assert_uint_gt(l.n_degenerate, 100);
  ck_assert(v[0] <= volume_of(&l) && volume_of(&l) <= v[0] + v[1]);
  gmds_lattice_leaves_clear(&leaves);
  gmds_lattice_clear(&l);
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(points_are_the_same_by_whatever_midpoints)
{
  gmds_memory_init(&memory, NULL);
  gmds_error error = {.status = GMDS_OK};
  const gmds_lattice_options o = {.base = {3, 1, 7}, .error = &error};
  gmds_soup soup;
  gmds_lattice l;
  make("sphere:5", &soup);
  lay(&soup, &o, &l);
  ck_assert_uint_eq(l.bits, 27);
  ck_assert_uint_eq((uint64_t)l.base[2] << l.bits, 7u << 27);
  double first[3], last[3];
  const uint32_t none[3] = {0, 0, 0}, all[3] = {3u << 27, 1u << 27, 7u << 27};
  gmds_lattice_point(&l, none, first);
  gmds_lattice_point(&l, all, last);
  for (size_t k = 0; k < soup.n_points; k++)
    for (size_t a = 0; a < 3; a++)
      ck_assert(first[a] < soup.points[3 * k + a] && soup.points[3 * k + a] < last[a]);
  for (uint32_t k = 1; k < 64; k++) {
    const uint32_t a[3] = {k << 20, k << 15, k << 21};
    double x[3], y[3];
    gmds_lattice_point(&l, a, x);
    for (int i = 0; i < 3; i++)
      y[i] = l.low[i] + (double)a[i] * l.step[i];
    ck_assert_mem_eq(x, y, sizeof x);
  }
  gmds_lattice_clear(&l);
  gmds_soup_clear(&soup);
}
END_TEST

START_TEST(no_memory_leaves_nothing_behind)
{
  failing from = {.until = LONG_MAX};
  const gmds_allocator allocator = failing_allocator(&from);
  const gmds_lattice_options o = {.base = {2, 1, 1}};
  gmds_memory plain;
  gmds_soup soup;
  gmds_memory_init(&plain, NULL);
  gmds_memory_init(&memory, &allocator);
  gmds_soup_init(&soup, &plain, 3);
  ck_assert_int_eq(gmds_make_surface("sphere:6", NULL, &soup), GMDS_OK);
  gmds_status status = GMDS_ERR_MEMORY;
  long failures = 0;
  for (; status == GMDS_ERR_MEMORY; failures++) {
    gmds_lattice l;
    gmds_lattice_leaves leaves;
    from.until = failures;
    gmds_lattice_init(&l, &memory);
    gmds_lattice_leaves_init(&leaves, &memory);
    status = gmds_lattice_of_soup(&l, &soup, &o);
    ck_assert(status == GMDS_OK || !l.triangles);
    if (status == GMDS_OK)
      status = gmds_lattice_refine(&l, 4, NULL, NULL, &leaves);
    ck_assert(status == GMDS_OK || (!leaves.n && !leaves.leaf));
    gmds_ids list;
    gmds_ids_init(&list, &memory);
    if (status == GMDS_OK) {
      gmds_id all[8] = {0, 1, 2, 3, 4, 5, 6, 7};
      gmds_lattice_octants octants;
      gmds_ids_push(&list, 5);
      from.until = 0;
      const size_t capacity = list.capacity;
      while (gmds_ids_push(&list, 5) == GMDS_OK)
        ;
      ck_assert_uint_eq(list.n, capacity);
      ck_assert_int_eq(gmds_lattice_split(&l, gmds_lattice_base(&l, 0), 0, 8, all, 0xff, &list, &octants),
                       GMDS_ERR_MEMORY);
      ck_assert_uint_eq(list.n, capacity);
    }
    gmds_ids_clear(&list);
    gmds_lattice_leaves_clear(&leaves);
    gmds_lattice_clear(&l);
    ck_assert_uint_eq(memory.live, 0);
  }
  ck_assert_int_eq(status, GMDS_OK);
  ck_assert_int_gt(failures, 15);
  gmds_soup_clear(&soup);
}
END_TEST

RUN_SUITE("surfaces on the lattice", made_surfaces_lie_between_their_inside_and_what_they_cut,
          order_turn_and_place_change_nothing, windings_tell_what_parity_does_not, a_caller_decides_what_is_refined,
          what_has_no_inside_is_refused, flat_triangles_are_counted_and_do_no_harm,
          points_are_the_same_by_whatever_midpoints, no_memory_leaves_nothing_behind)
