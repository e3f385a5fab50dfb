/* What the files of combinatorial maps share: tables of identifiers, and edits that are made whole or not at all. */
#ifndef GMDS_MAP_INSIDE_H
#define GMDS_MAP_INSIDE_H

#include <gmds/map.h>

/* A table from identifiers to identifiers: open addressing, linear probing, at most half full. */
typedef struct id_table {
  gmds_id *slots; /* key and value, `capacity` of them, a power of two */
  size_t capacity, n;
  gmds_memory *memory;
} id_table;

void id_table_clear(id_table *table);
void id_table_empty(id_table *table); /* keeps the room */

/* The value of a key, or NULL; valid until the next entry. */
gmds_id *id_table_find(const id_table *table, gmds_id key);

/* Sets the value of a key. GMDS_OK or GMDS_ERR_MEMORY (unchanged). */
gmds_status id_table_put(id_table *table, gmds_id key, gmds_id value);

enum { MAP_MOVES = 16 };

/* Where the generators of an orbit lead from d: how many, GMDS_NONE among them. */
int map_moves(const gmds_map *map, unsigned betas, gmds_id d, gmds_id to[MAP_MOVES]);

/* A change of a map. Links are set at once and written down; edit_end finds which cells became one or more, or, when
 * something failed, takes everything back. */
typedef struct edit {
  gmds_map *map;
  gmds_ids log;   /* dart, beta, what it was; three by three */
  gmds_ids made;  /* darts */
  gmds_ids gone;  /* darts that go at the end */
  id_table goes;  /* the same, to be asked */
  unsigned betas; /* which were changed */
  int keep_nodes; /* nodes without darts stay */
} edit;

void edit_begin(edit *e, gmds_map *map);

/* beta_i(d) = f and its inverse, after whatever d and f were linked with by it is free. f may be GMDS_NONE. */
gmds_status edit_join(edit *e, int i, gmds_id d, gmds_id f);
gmds_status edit_make(edit *e, gmds_id *d); /* a new dart, all free */
gmds_status edit_drop(edit *e, gmds_id d);  /* frees it, and removes it at the end */

/* Whether the axioms of an n-map hold around what was changed so far. */
int edit_is_sound(const edit *e);

/* Commits where status is GMDS_OK and the cells can be found, else takes back; the status of the whole. */
gmds_status edit_end(edit *e, gmds_status status);

/* Reads a number of `bytes` bytes, the lowest first. */
static inline uint64_t read_little(const unsigned char *p, size_t bytes)
{
  uint64_t x = 0;
  for (size_t k = 0; k < bytes; k++)
    x |= (uint64_t)p[k] << 8 * k;
  return x;
}

static inline uint64_t mix64(uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

#endif
