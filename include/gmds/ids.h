/* Identifiers and the list of identifiers that queries answer in. */
#ifndef GMDS_IDS_H
#define GMDS_IDS_H

#include <gmds/config.h>
#include <gmds/memory.h>
#include <gmds/status.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A local identifier: cells of one dimension in one mesh are numbered from 0, with holes after deletions. */
#if GMDS_ID_BITS == 32
typedef uint32_t gmds_id;
#  define GMDS_PRIid PRIu32
#  define GMDS_ID_MAX UINT32_MAX
#elif GMDS_ID_BITS == 64
typedef uint64_t gmds_id;
#  define GMDS_PRIid PRIu64
#  define GMDS_ID_MAX UINT64_MAX
#else
#  error "gmds: GMDS_ID_BITS must be 32 or 64"
#endif

/* A global identifier, always 64 bits. */
typedef uint64_t gmds_gid;

/* No cell. */
#define GMDS_NONE GMDS_ID_MAX

/* A list of identifiers. Owned by the caller of queries: one list per thread makes every query thread-safe. Queries
 * replace its content, grow it as they need, and use the room behind the answer as scratch space.
 * Zero-initialised with `memory` set (or by gmds_ids_init) it is an empty list. */
typedef struct gmds_ids {
  gmds_id *data;
  size_t n;        /* how many identifiers the list holds */
  size_t capacity; /* how many fit without growing */
  gmds_memory *memory;
} gmds_ids;

/* An empty list that takes its memory from `memory` (which must outlive it). Allocates nothing. */
void gmds_ids_init(gmds_ids *list, gmds_memory *memory);

/* Frees what the list holds; it is empty and usable again. */
void gmds_ids_clear(gmds_ids *list);

/* Makes room for `capacity` identifiers in all. GMDS_OK or GMDS_ERR_MEMORY (the list is unchanged). */
gmds_status gmds_ids_reserve(gmds_ids *list, size_t capacity);

/* Appends one identifier. GMDS_OK or GMDS_ERR_MEMORY. Amortised constant time. */
static inline gmds_status gmds_ids_push(gmds_ids *list, gmds_id id)
{
  if (list->n == list->capacity)
    GMDS_TRY(gmds_ids_reserve(list, list->n + 1));
  list->data[list->n++] = id;
  return GMDS_OK;
}

/* Whether the list holds `id`. Linear in its length. */
static inline int gmds_ids_has(const gmds_ids *list, gmds_id id)
{
  for (size_t k = 0; k < list->n; k++)
    if (list->data[k] == id)
      return 1;
  return 0;
}

/* Sorts the entries from `first` on and keeps those that occur at least `times` times, once each: the operator Keep of
 * [models] 2.1 over a multiset. The entry `but` is left out (GMDS_NONE: none). O(m log m) for m entries. */
void gmds_ids_keep(gmds_ids *list, size_t first, size_t times, gmds_id but);

/* Defined once in the library for its width of identifiers: a program compiled for another width does not link. */
#if GMDS_ID_BITS == 32
#  define gmds_link_check gmds_compiled_for_32_bit_ids
#else
#  define gmds_link_check gmds_compiled_for_64_bit_ids
#endif
extern const int gmds_link_check;

#ifdef __cplusplus
}
#endif
#endif
