/* Memory: one gmds_memory per mesh, through which everything that the mesh or an algorithm on it allocates goes. It
 * counts live and peak bytes exactly (the bytes asked for, without the overhead of the system's allocator) and can be
 * given a limit. */
#ifndef GMDS_MEMORY_H
#define GMDS_MEMORY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A user's allocator: `resize` behaves as realloc, is told the old size, and frees when new_bytes is 0 (returning
 * NULL). It returns NULL when there is no memory for more bytes, leaving the old block as it was. A call for fewer
 * bytes does not fail: an allocator that cannot cut a block returns it as it is, and is told the smaller size from then
 * on. */
typedef struct gmds_allocator {
  void *(*resize)(void *user, void *block, size_t old_bytes, size_t new_bytes);
  void *user;
} gmds_allocator;

typedef struct gmds_memory {
  gmds_allocator allocator;
  size_t live;  /* bytes held now */
  size_t peak;  /* the largest `live` was */
  size_t limit; /* `live` never grows beyond it: SIZE_MAX unless set, may be changed at any time */
} gmds_memory;

/* Starts counting from zero; `allocator` NULL stands for the C library's. */
void gmds_memory_init(gmds_memory *memory, const gmds_allocator *allocator);

/* Resizes *block from old_count to new_count elements of `size` bytes; NULL and 0 stand for each other.
 * On failure (product overflows, limit, allocator) returns 0 and *block is unchanged; otherwise returns 1. */
int gmds_resize(gmds_memory *memory, void **block, size_t old_count, size_t new_count, size_t size);

/* Frees a block of `count` elements of `size` bytes. */
void gmds_release(gmds_memory *memory, void *block, size_t count, size_t size);

/* The capacity to grow to from `capacity` when `needed` elements must fit: half as much again, at least 8. */
size_t gmds_grown(size_t capacity, size_t needed);

#ifdef __cplusplus
}
#endif
#endif
