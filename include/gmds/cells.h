/* The cells of one dimension: which identifiers are alive, and the attributes that users attach to them.
 *
 * Identifiers run from 0 to `end` - 1 with holes where cells were deleted; a new cell takes a hole where there is
 * one. */
#ifndef GMDS_CELLS_H
#define GMDS_CELLS_H

#include <gmds/bits.h>

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, C type, text) */
#define GMDS_VALUE_LIST(X)         \
  X(GMDS_DOUBLE, double, "double") \
  X(GMDS_FLOAT, float, "float")    \
  X(GMDS_INT, int, "int")          \
  X(GMDS_LONG, int64_t, "long")    \
  X(GMDS_BYTE, uint8_t, "byte")    \
  X(GMDS_ID, gmds_id, "id")

#define GMDS_VALUE_ENUM_(name, type, text) name,
typedef enum gmds_value { GMDS_VALUE_LIST(GMDS_VALUE_ENUM_) GMDS_VALUE_COUNT } gmds_value;
#undef GMDS_VALUE_ENUM_

/* A named column of values beside the cells: `components` values of one type a cell, those of cell c from
 * c * components on. A new cell's values are 0. The object stays where it is until it is removed; `data` moves when
 * the cells grow. */
typedef struct gmds_attribute {
  struct gmds_attribute *next;
  char *name;
  size_t name_bytes;
  gmds_value type;
  size_t components;
  size_t bytes; /* of one cell: components times the size of the type */
  void *data;
} gmds_attribute;

typedef struct gmds_cells {
  gmds_bits alive;
  size_t end;      /* one past the largest identifier in use */
  size_t count;    /* how many are alive */
  size_t capacity; /* how many identifiers the columns have room for */
  size_t limit;    /* how many the index type holds; may be lowered */
  size_t hole;     /* no hole is below this identifier */
  gmds_attribute *attributes;
} gmds_cells;

void gmds_cells_init(gmds_cells *cells, gmds_memory *memory, size_t limit);
void gmds_cells_clear(gmds_cells *cells);

/* Removes every cell; the attributes stay, without values. */
void gmds_cells_empty(gmds_cells *cells);

/* Gives the liveness and every attribute room for exactly `capacity` cells (not below `end`). GMDS_OK; GMDS_ERR_MEMORY
 * (nothing is lost; some columns may have grown); GMDS_ERR_TOO_MANY. */
gmds_status gmds_cells_resize(gmds_cells *cells, size_t capacity);

/* The capacity that must be provided so that `more` cells can be taken; the current one when they fit. */
size_t gmds_cells_needed(const gmds_cells *cells, size_t more);

/* Takes an identifier, its attributes 0; room was provided. Constant time without holes, else O(end / 64) at worst. */
gmds_id gmds_cells_take(gmds_cells *cells);

/* Takes n identifiers from `end` on, without a gap, whatever the holes; room was provided. The first of them. O(n). */
gmds_id gmds_cells_take_many(gmds_cells *cells, size_t n);

/* Gives an identifier back. */
void gmds_cells_drop(gmds_cells *cells, gmds_id id);

static inline int gmds_cells_has(const gmds_cells *cells, gmds_id id)
{
  return id < cells->end && gmds_bits_get(&cells->alive, id);
}

/* The first live cell from `id` on, or GMDS_NONE. Whatever is deleted or created between two calls, a loop
 * `for (c = next(0); c != GMDS_NONE; c = next(c + 1))` meets every cell that is alive all along once. */
static inline gmds_id gmds_cells_next(const gmds_cells *cells, gmds_id id)
{
  if (gmds_cells_has(cells, id)) /* as a rule */
    return id;
  size_t next = gmds_bits_next(&cells->alive, id, cells->end);
  return next < cells->end ? (gmds_id)next : GMDS_NONE;
}

/* Moves the attributes and the liveness of one cell into a hole. */
void gmds_cells_move(gmds_cells *cells, gmds_id from, gmds_id to);

/* Sets `end` to the count: after moves that left no hole below it. */
void gmds_cells_close(gmds_cells *cells);

/* map[c] for every c below `end`: where cell c goes so that there is no hole. Below the count it stays, else it takes
 * the next hole; GMDS_NONE for holes. */
void gmds_cells_plan(const gmds_cells *cells, gmds_id *map);

/* Moves the attributes and the liveness to new identifiers: map[old] = new, which is old or a hole below the count. */
void gmds_cells_renumber(gmds_cells *cells, const gmds_id *map);

/* Adds a column under a name not in use. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_ARGUMENT (no name, no component or unknown
 * type); GMDS_ERR_CONFLICT (the name is taken). */
gmds_status gmds_attribute_add(gmds_cells *cells, const char *name, gmds_value type, size_t components,
                               gmds_attribute **attribute);

/* The column of a name, or NULL. */
gmds_attribute *gmds_attribute_find(const gmds_cells *cells, const char *name);

/* Removes a column of these cells and frees it. */
void gmds_attribute_remove(gmds_cells *cells, gmds_attribute *attribute);

/* A column that is in no list, its `capacity` rows 0, and its end: for lists of columns beside other things than cells.
 * Status as gmds_attribute_add. */
gmds_status gmds_attribute_make(gmds_memory *memory, const char *name, gmds_value type, size_t components,
                                size_t capacity, gmds_attribute **attribute);
void gmds_attribute_free(gmds_memory *memory, gmds_attribute *attribute, size_t capacity);

/* The bytes of one value of a type. */
size_t gmds_value_bytes(gmds_value type);
const char *gmds_value_text(gmds_value type); /* never NULL */

#ifdef __cplusplus
}
#endif
#endif
