/* Shared by the test programs: the main of a program of Check cases, reproducible random numbers, the data folder, and
 * an allocator that fails on demand. */
#ifndef GMDS_TESTS_HARNESS_H
#define GMDS_TESTS_HARNESS_H

#include <check.h>
#include <gmds/memory.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Runs the cases of one suite; the value is what main returns. A case may run for minutes under a sanitizer. */
static inline int run_suite(const char *name, const TTest *const *tests, size_t n)
{
  Suite *suite = suite_create(name);
  TCase *cases = tcase_create("claims");
  tcase_set_timeout(cases, 0);
  for (size_t i = 0; i < n; i++)
    tcase_add_test(cases, tests[i]);
  suite_add_tcase(suite, cases);
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_NORMAL);
  int failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  return failed != 0;
}

#define RUN_SUITE(name, ...)                                     \
  int main(void)                                                 \
  {                                                              \
    const TTest *const tests[] = {__VA_ARGS__};                  \
    return run_suite(name, tests, sizeof tests / sizeof *tests); \
  }

/* splitmix64: every random test states its seed. */
static inline uint64_t random_bits(uint64_t *state)
{
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

static inline double random_unit(uint64_t *state)
{
  return (double)(random_bits(state) >> 11) * 0x1p-53;
}

static inline size_t random_below(uint64_t *state, size_t n)
{
  return (size_t)(random_bits(state) % n);
}

/* The folder of real data, or NULL after a word about what is skipped. */
static inline const char *data_folder(const char *what)
{
  const char *folder = getenv("GMDS_DATA_DIR");
  if (folder && *folder)
    return folder;
  printf("skipped, GMDS_DATA_DIR is not set: %s\n", what);
  return NULL;
}

/* An allocator whose k-th call that asks for more memory fails (k from 1), and every later one too. */
typedef struct failing {
  long until; /* calls left that succeed */
  size_t live;
} failing;

static inline void *failing_resize(void *user, void *block, size_t old_bytes, size_t new_bytes)
{
  failing *f = user;
  if (new_bytes > old_bytes && f->until-- <= 0)
    return NULL;
  f->live += new_bytes - old_bytes;
  if (new_bytes)
    return realloc(block, new_bytes);
  free(block);
  return NULL;
}

static inline gmds_allocator failing_allocator(failing *f)
{
  gmds_allocator a = {failing_resize, f};
  return a;
}
#endif
