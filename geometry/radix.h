/* Stable sorting of points by 32-bit keys: by digits from the lowest when there are many, by merging when few. */
#ifndef GMDS_GEOMETRY_RADIX_H
#define GMDS_GEOMETRY_RADIX_H

#include <gmds/ids.h>
#include <string.h>

typedef struct item {
  uint32_t key;
  gmds_id id;
} item;

/* Three digits of 11 bits: 2048 places of writing still fit the second-level address cache of common processors. */
enum { DIGITS = 3, DIGIT_BITS = 11, BUCKETS = 1 << DIGIT_BITS };

/* Where the next item of each digit goes. Lent by the caller, whose recursion must not stack it up. */
typedef struct radix_counts {
  gmds_id start[DIGITS][BUCKETS];
} radix_counts;

static inline unsigned digit_of(item it, int digit)
{
  return it.key >> digit * DIGIT_BITS & (BUCKETS - 1);
}

/* Sorts n items, 1 <= n < GMDS_NONE; the value is where they are then, `items` or `scratch`. O(n). */
static inline item *radix_sort(radix_counts *counts, size_t n, item *items, item *scratch)
{
  memset(counts, 0, sizeof *counts);
  for (size_t i = 0; i < n; i++)
    for (int digit = 0; digit < DIGITS; digit++)
      counts->start[digit][digit_of(items[i], digit)]++;
  for (int digit = 0; digit < DIGITS; digit++) {
    gmds_id *start = counts->start[digit], sum = 0;
    if (start[digit_of(items[0], digit)] == n)
      continue;
    for (int b = 0; b < BUCKETS; b++) {
      gmds_id count = start[b];
      start[b] = sum;
      sum += count;
    }
    for (size_t i = 0; i < n; i++)
      scratch[start[digit_of(items[i], digit)]++] = items[i];
    item *sorted = scratch;
    scratch = items;
    items = sorted;
  }
  return items;
}

/* As radix_sort, O(n log n), without its tables. */
static inline item *merge_sort(size_t n, item *items, item *scratch)
{
  for (size_t run = 1; run < n; run *= 2) {
    for (size_t begin = 0; begin < n; begin += 2 * run) {
      size_t middle = begin + run < n ? begin + run : n, end = middle + run < n ? middle + run : n;
      size_t a = begin, b = middle;
      for (size_t i = begin; i < end; i++) {
        int first = a < middle && (b == end || items[a].key <= items[b].key);
        scratch[i] = items[first ? a : b];
        a += first != 0;
        b += first == 0;
      }
    }
    item *sorted = scratch;
    scratch = items;
    items = sorted;
  }
  return items;
}

#endif
