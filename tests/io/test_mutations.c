/* Files with bytes changed, left out and put in: whatever comes of them is a valid soup or an error in a sentence. */
#include "samples.h"
#include <math.h>

/* Changes a few bytes; digits are more likely than others to get a file past its header. */
static size_t mutate(char *bytes, size_t n, size_t room, uint64_t *seed)
{
  static const char likely[] = "0123456789-+.e \n\n,#nanOFF";
  for (size_t k = 1 + random_below(seed, 4); k-- > 0;) {
    size_t at = random_below(seed, n + 1);
    char byte = random_below(seed, 4) ? likely[random_below(seed, sizeof likely - 1)] : (char)random_bits(seed);
    switch (random_below(seed, 5)) {
    case 0:
      if (n < room) {
        memmove(bytes + at + 1, bytes + at, n - at);
        bytes[at] = byte;
        n++;
      }
      break;
    case 1: {
      size_t cut = random_below(seed, 8) ? 1 : random_below(seed, 40);
      cut = cut < n - at ? cut : n - at;
      memmove(bytes + at, bytes + at + cut, n - at - cut);
      n -= cut;
      break;
    }
    case 2:
      if (at < n)
        bytes[at] = (char)(bytes[at] ^ 1 << random_below(seed, 8));
      break;
    default:
      if (at < n)
        bytes[at] = byte;
    }
  }
  return n;
}

static void check_soup(const gmds_soup *soup)
{
  gmds_ids points;
  volatile double sum = 0;
  gmds_ids_init(&points, soup->memory);
  ck_assert(soup->dim == 2 || soup->dim == 3);
  for (size_t i = 0; i < soup->n_points * (size_t)soup->dim; i++)
    ck_assert(isfinite(soup->points[i]));
  for (size_t c = 0; c < soup->n_cells; c++) {
    ck_assert_uint_lt(soup->types[c], GMDS_CELL_TYPE_COUNT);
    ck_assert_int_eq(gmds_soup_cell_points(soup, c, &points), GMDS_OK);
    for (size_t k = 0; k < points.n; k++)
      ck_assert_uint_lt(points.data[k], soup->n_points);
  }
  gmds_ids_clear(&points);
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next)
      for (size_t k = 0; k < a->components * (place ? soup->n_cells : soup->n_points); k++)
        sum += attribute_value(a, k);
  (void)sum; /* every value was there to be read */
}

START_TEST(changed_files_give_a_valid_soup_or_an_error)
{
  uint64_t seed = 20240117;
  size_t accepted[N_SAMPLES] = {0}, refused[N_SAMPLES] = {0};
  for (size_t i = 0; i < N_SAMPLES; i++) {
    const sample original = sample_at(i);
    for (int round = 0; round < 20000; round++) {
      held *h = held_new(2);
      char bytes[sizeof original.bytes + 8];
      memcpy(bytes, original.bytes, original.n);
      size_t n = mutate(bytes, original.n, sizeof bytes, &seed);
      char *exact = malloc(n ? n : 1); /* so that a sanitizer sees a read beyond the end */
      ck_assert_ptr_nonnull(exact);
      memcpy(exact, bytes, n);
      if (read_bytes(h, original.format, exact, n, original.dim) == GMDS_OK) {
        accepted[i]++;
        check_soup(&h->soup);
      } else {
        refused[i]++;
        ck_assert_int_eq(strncmp(h->error.text, "name:", 5), 0);
        ck_assert_uint_eq(h->soup.n_points + h->soup.n_cells, 0);
      }
      ck_assert_uint_lt(h->memory.peak, 100000);
      free(exact);
      held_free(h);
    }
    ck_assert_uint_gt(accepted[i], 100);
    ck_assert_uint_gt(refused[i], 100);
  }
}
END_TEST

RUN_SUITE("mutations", changed_files_give_a_valid_soup_or_an_error)
