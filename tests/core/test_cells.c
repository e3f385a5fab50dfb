/* Identifiers, their attributes, and the bit arrays behind them. */
#include "harness.h"
#include <gmds/cells.h>

enum { MANY = 3000 };

static unsigned char alive[MANY];

static gmds_id take(gmds_cells *cells)
{
  ck_assert_int_eq(gmds_cells_resize(cells, gmds_cells_needed(cells, 1)), GMDS_OK);
  return gmds_cells_take(cells);
}

static void compare(const gmds_cells *cells)
{
  size_t count = 0, end = 0;
  gmds_id next = gmds_cells_next(cells, 0);
  for (gmds_id c = 0; c < MANY; c++) {
    if (gmds_cells_has(cells, c) != alive[c])
      ck_abort_msg("cell %lu should%s be alive", (unsigned long)c, alive[c] ? "" : " not");
    if (!alive[c])
      continue;
    if (next != c)
      ck_abort_msg("next is %lu, expected %lu", (unsigned long)next, (unsigned long)c);
    next = gmds_cells_next(cells, c + 1);
    count++;
    end = c + (size_t)1;
  }
  ck_assert_uint_eq(next, GMDS_NONE);
  ck_assert_uint_eq(cells->count, count);
  ck_assert_uint_eq(cells->end, end);
}

START_TEST(the_lowest_hole_is_taken_first)
{
  gmds_memory memory;
  gmds_cells cells;
  uint64_t seed = 1;
  memset(alive, 0, sizeof alive);
  gmds_memory_init(&memory, NULL);
  gmds_cells_init(&cells, &memory, MANY);
  for (int i = 0; i < 20000; i++) {
    if (cells.count < MANY && random_below(&seed, 100) < (i < 10000 ? 60u : 45u)) {
      gmds_id lowest = 0, id = take(&cells);
      while (alive[lowest])
        lowest++;
      if (id != lowest)
        ck_abort_msg("took %lu, the lowest hole is %lu", (unsigned long)id, (unsigned long)lowest);
      alive[id] = 1;
    } else if (cells.count) {
      gmds_id id = gmds_cells_next(&cells, (gmds_id)random_below(&seed, cells.end));
      gmds_cells_drop(&cells, id);
      alive[id] = 0;
    }
    if (i % 500 == 0)
      compare(&cells);
  }
  compare(&cells);
  gmds_cells_clear(&cells);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(a_loop_meets_what_stays_once_whatever_is_deleted)
{
  gmds_memory memory;
  gmds_cells cells;
  unsigned char met[MANY] = {0};
  uint64_t seed = 2;
  gmds_memory_init(&memory, NULL);
  gmds_cells_init(&cells, &memory, MANY);
  for (int i = 0; i < 1000; i++)
    take(&cells);
  for (gmds_id c = gmds_cells_next(&cells, 0); c != GMDS_NONE; c = gmds_cells_next(&cells, c + 1)) {
    ck_assert_int_eq(met[c]++, 0);
    if (c % 3 == 0)
      gmds_cells_drop(&cells, c);
    else if (random_below(&seed, 2) && cells.count < MANY - 10)
      take(&cells);
  }
  for (gmds_id c = 0; c < 1000; c++)
    ck_assert_int_eq(met[c], 1);
  gmds_cells_clear(&cells);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(more_cells_than_the_limit_are_refused)
{
  gmds_memory memory;
  gmds_cells cells;
  gmds_memory_init(&memory, NULL);
  gmds_cells_init(&cells, &memory, 10);
  for (int i = 0; i < 10; i++)
    take(&cells);
  ck_assert_int_eq(gmds_cells_resize(&cells, gmds_cells_needed(&cells, 1)), GMDS_ERR_TOO_MANY);
  gmds_cells_drop(&cells, 4);
  ck_assert_uint_eq(take(&cells), 4);
  gmds_cells_drop(&cells, 9);
  cells.limit = 9; /* below the room there is */
  ck_assert_int_eq(gmds_cells_resize(&cells, gmds_cells_needed(&cells, 1)), GMDS_ERR_TOO_MANY);
  ck_assert_uint_gt(gmds_cells_needed(&cells, SIZE_MAX), 9);
  gmds_cells_clear(&cells);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

/* Every byte of a cell's value says whose it is. */
static void sign(const gmds_attribute *a, gmds_id c, int id)
{
  memset((char *)a->data + c * a->bytes, 1 + id % 200, a->bytes);
}

static int is_signed(const gmds_attribute *a, gmds_id c, int id)
{
  for (size_t k = 0; k < a->bytes; k++)
    if (((const unsigned char *)a->data)[c * a->bytes + k] != 1 + id % 200)
      return 0;
  return 1;
}

START_TEST(attributes_of_every_type_grow_and_move_with_their_cells)
{
  gmds_memory memory;
  gmds_cells cells;
  gmds_attribute *a[GMDS_VALUE_COUNT + 1];
  static const size_t bytes[GMDS_VALUE_COUNT] = {8, 4, sizeof(int), 8, 1, sizeof(gmds_id)};
  gmds_memory_init(&memory, NULL);
  gmds_cells_init(&cells, &memory, MANY);
  for (int t = 0; t < GMDS_VALUE_COUNT; t++) {
    ck_assert_uint_eq(gmds_value_bytes((gmds_value)t), bytes[t]);
    ck_assert_int_eq(
        gmds_attribute_add(&cells, gmds_value_text((gmds_value)t), (gmds_value)t, 1 + (size_t)t % 3, &a[t]), GMDS_OK);
  }
  for (int i = 0; i < 200; i++) {
    gmds_id c = take(&cells);
    for (int t = 0; t < GMDS_VALUE_COUNT; t++) {
      for (size_t k = 0; k < a[t]->bytes; k++)
        ck_assert_int_eq(((char *)a[t]->data)[c * a[t]->bytes + k], 0);
      sign(a[t], c, i);
    }
  }
  ck_assert_int_eq(gmds_attribute_add(&cells, "late", GMDS_DOUBLE, 2, &a[GMDS_VALUE_COUNT]), GMDS_OK);
  for (gmds_id c = 0; c < 200; c++)
    ck_assert(((double *)a[GMDS_VALUE_COUNT]->data)[2 * c] == 0);
  gmds_id map[200], fresh = 0;
  for (gmds_id c = 0; c < 200; c++) {
    if (c % 5 == 1)
      gmds_cells_drop(&cells, c);
    map[c] = c % 5 == 1 ? GMDS_NONE : fresh++;
  }
  gmds_cells_renumber(&cells, map);
  ck_assert_uint_eq(cells.count, fresh);
  ck_assert_uint_eq(cells.end, fresh);
  ck_assert_int_eq(gmds_cells_resize(&cells, fresh), GMDS_OK);
  for (gmds_id c = 0; c < 200; c++)
    for (int t = 0; t < GMDS_VALUE_COUNT && map[c] != GMDS_NONE; t++)
      ck_assert_msg(is_signed(a[t], map[c], (int)c), "%s of cell %lu", a[t]->name, (unsigned long)c);
  ck_assert_ptr_eq(gmds_attribute_find(&cells, "late"), a[GMDS_VALUE_COUNT]);
  gmds_attribute_remove(&cells, a[GMDS_VALUE_COUNT]);
  gmds_attribute_remove(&cells, a[2]);
  ck_assert_ptr_null(gmds_attribute_find(&cells, "late"));
  ck_assert_ptr_null(gmds_attribute_find(&cells, "int"));
  ck_assert_ptr_eq(gmds_attribute_find(&cells, "byte"), a[4]);
  gmds_cells_empty(&cells);
  ck_assert_ptr_eq(gmds_attribute_find(&cells, "byte"), a[4]);
  ck_assert_uint_eq(take(&cells), 0);
  gmds_cells_clear(&cells);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(an_attribute_that_cannot_be_is_refused)
{
  failing f = {.until = 1000};
  gmds_allocator allocator = failing_allocator(&f);
  gmds_memory memory;
  gmds_cells cells;
  gmds_attribute *a = NULL;
  gmds_memory_init(&memory, &allocator);
  gmds_cells_init(&cells, &memory, MANY);
  take(&cells);
  ck_assert_int_eq(gmds_attribute_add(&cells, "", GMDS_INT, 1, &a), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_attribute_add(&cells, NULL, GMDS_INT, 1, &a), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_attribute_add(&cells, "x", GMDS_INT, 0, &a), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_attribute_add(&cells, "x", GMDS_INT, SIZE_MAX / 2, &a), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_attribute_add(&cells, "x", GMDS_VALUE_COUNT, 1, &a), GMDS_ERR_ARGUMENT);
  size_t before = f.live;
  for (f.until = 0; gmds_attribute_add(&cells, "x", GMDS_INT, 3, &a) == GMDS_ERR_MEMORY;) {
    static long k = 0;
    ck_assert_uint_eq(f.live, before);
    ck_assert_ptr_null(a);
    f.until = ++k;
  }
  ck_assert_int_eq(gmds_attribute_add(&cells, "x", GMDS_BYTE, 1, &a), GMDS_ERR_CONFLICT);
  ((int *)a->data)[2] = 5;
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    f.until = k;
    status = gmds_cells_resize(&cells, 500);
    ck_assert_int_eq(((int *)a->data)[2], 5);
    ck_assert_uint_eq(cells.capacity == 500, status == GMDS_OK);
  }
  gmds_cells_clear(&cells);
  ck_assert_uint_eq(f.live, 0);
}
END_TEST

RUN_SUITE("cells", the_lowest_hole_is_taken_first, a_loop_meets_what_stays_once_whatever_is_deleted,
          more_cells_than_the_limit_are_refused, attributes_of_every_type_grow_and_move_with_their_cells,
          an_attribute_that_cannot_be_is_refused)
