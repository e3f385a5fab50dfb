/* Counted memory. */
#include <gmds/memory.h>
#include <stdint.h>
#include <stdlib.h>

static void *system_resize(void *user, void *block, size_t old_bytes, size_t new_bytes)
{
  (void)user;
  if (!new_bytes) {
    free(block);
    return NULL;
  }
  void *moved = realloc(block, new_bytes);
  return moved || new_bytes > old_bytes ? moved : block;
}

void gmds_memory_init(gmds_memory *memory, const gmds_allocator *allocator)
{
  *memory = (gmds_memory){.allocator = {system_resize, NULL}, .limit = SIZE_MAX};
  if (allocator)
    memory->allocator = *allocator;
}

int gmds_resize(gmds_memory *memory, void **block, size_t old_count, size_t new_count, size_t size)
{
  if (new_count == old_count)
    return 1;
  if (size && new_count > SIZE_MAX / size)
    return 0;
  size_t old_bytes = old_count * size, new_bytes = new_count * size;
  if (new_bytes > old_bytes && (memory->live > memory->limit || new_bytes - old_bytes > memory->limit - memory->live))
    return 0;
  void *moved = memory->allocator.resize(memory->allocator.user, *block, old_bytes, new_bytes);
  if (!moved && new_bytes > old_bytes)
    return 0;
  if (!moved && new_bytes)
    moved = *block; /* a call for fewer bytes does not fail */
  *block = moved;
  memory->live = memory->live - old_bytes + new_bytes;
  if (memory->live > memory->peak)
    memory->peak = memory->live;
  return 1;
}

void gmds_release(gmds_memory *memory, void *block, size_t count, size_t size)
{
  (void)gmds_resize(memory, &block, count, 0, size);
}

size_t gmds_grown(size_t capacity, size_t needed)
{
  size_t more = capacity > SIZE_MAX - capacity / 2 ? SIZE_MAX : capacity + capacity / 2;
  if (more < 8)
    more = 8;
  return more > needed ? more : needed;
}
