/* Identifiers of the cells of one dimension, and their attributes. */
#include <gmds/cells.h>
#include <string.h>

size_t gmds_value_bytes(gmds_value type)
{
#define BYTES(name, ctype, text) sizeof(ctype),
  static const size_t bytes[] = {GMDS_VALUE_LIST(BYTES)};
#undef BYTES
  return (unsigned)type < GMDS_VALUE_COUNT ? bytes[type] : 0;
}

const char *gmds_value_text(gmds_value type)
{
#define TEXT(name, ctype, text) text,
  static const char *const texts[] = {GMDS_VALUE_LIST(TEXT)};
#undef TEXT
  return (unsigned)type < GMDS_VALUE_COUNT ? texts[type] : "unknown";
}

void gmds_cells_init(gmds_cells *cells, gmds_memory *memory, size_t limit)
{
  *cells = (gmds_cells){.alive = {.memory = memory}, .limit = limit};
}

void gmds_cells_clear(gmds_cells *cells)
{
  while (cells->attributes)
    gmds_attribute_remove(cells, cells->attributes);
  gmds_bits_clear(&cells->alive);
  gmds_cells_init(cells, cells->alive.memory, cells->limit);
}

void gmds_cells_empty(gmds_cells *cells)
{
  for (gmds_attribute *a = cells->attributes; a; a = a->next) {
    gmds_release(cells->alive.memory, a->data, cells->capacity, a->bytes);
    a->data = NULL;
  }
  gmds_bits_clear(&cells->alive);
  cells->end = cells->count = cells->capacity = cells->hole = 0;
}

gmds_status gmds_cells_resize(gmds_cells *cells, size_t capacity)
{
  if (capacity > cells->limit)
    return GMDS_ERR_TOO_MANY;
  GMDS_TRY(gmds_bits_resize(&cells->alive, capacity));
  for (gmds_attribute *a = cells->attributes; a; a = a->next)
    if (!gmds_resize(cells->alive.memory, &a->data, cells->capacity, capacity, a->bytes)) {
      /* give back what the columns before it have grown by, which cannot fail */
      for (gmds_attribute *b = cells->attributes; b != a; b = b->next)
        (void)gmds_resize(cells->alive.memory, &b->data, capacity, cells->capacity, b->bytes);
      (void)gmds_bits_resize(&cells->alive, cells->capacity);
      return GMDS_ERR_MEMORY;
    }
  cells->capacity = capacity;
  return GMDS_OK;
}

size_t gmds_cells_needed(const gmds_cells *cells, size_t more)
{
  size_t holes = cells->end - cells->count;
  size_t room = cells->capacity < cells->limit ? cells->capacity : cells->limit; /* the limit may have been lowered */
  if (more <= holes || (cells->end <= room && more - holes <= room - cells->end))
    return cells->capacity;
  if (more - holes > SIZE_MAX - cells->end)
    return SIZE_MAX;
  size_t needed = cells->end + (more - holes), grown = gmds_grown(cells->capacity, needed);
  return needed <= cells->limit && grown > cells->limit ? cells->limit : grown;
}

gmds_id gmds_cells_take(gmds_cells *cells)
{
  size_t id = cells->end;
  if (cells->count < cells->end) {
    id = gmds_bits_next_unset(&cells->alive, cells->hole, cells->end);
    cells->hole = id + 1;
  } else {
    cells->end++;
    cells->hole = cells->end;
  }
  gmds_bits_set(&cells->alive, id);
  cells->count++;
  for (gmds_attribute *a = cells->attributes; a; a = a->next)
    memset((char *)a->data + id * a->bytes, 0, a->bytes);
  return (gmds_id)id;
}

void gmds_cells_drop(gmds_cells *cells, gmds_id id)
{
  gmds_bits_unset(&cells->alive, id);
  cells->count--;
  if (id < cells->hole)
    cells->hole = id;
  while (cells->end > 0 && !gmds_bits_get(&cells->alive, cells->end - 1))
    cells->end--;
  if (cells->hole > cells->end)
    cells->hole = cells->end;
}

gmds_id gmds_cells_take_many(gmds_cells *cells, size_t n)
{
  size_t first = cells->end;
  for (size_t id = first; id < first + n;) { /* word by word */
    const size_t room = 64 - (id & 63), some = first + n - id < room ? first + n - id : room;
    cells->alive.words[id >> 6] |= (~UINT64_C(0) >> (64 - some)) << (id & 63);
    id += some;
  }
  if (cells->hole == first)
    cells->hole = first + n;
  cells->end += n;
  cells->count += n;
  for (gmds_attribute *a = n ? cells->attributes : NULL; a; a = a->next)
    memset((char *)a->data + first * a->bytes, 0, n * a->bytes);
  return (gmds_id)first;
}

void gmds_cells_move(gmds_cells *cells, gmds_id from, gmds_id to)
{
  for (gmds_attribute *a = cells->attributes; a; a = a->next)
    memcpy((char *)a->data + to * a->bytes, (char *)a->data + from * a->bytes, a->bytes);
  gmds_bits_set(&cells->alive, to);
  gmds_bits_unset(&cells->alive, from);
}

void gmds_cells_close(gmds_cells *cells)
{
  cells->end = cells->hole = cells->count;
}

void gmds_cells_plan(const gmds_cells *cells, gmds_id *map)
{
  size_t hole = 0;
  for (size_t c = 0; c < cells->end; c++) {
    map[c] = gmds_cells_has(cells, (gmds_id)c) ? (gmds_id)c : GMDS_NONE;
    if (c >= cells->count && map[c] != GMDS_NONE) {
      hole = gmds_bits_next_unset(&cells->alive, hole, cells->count);
      map[c] = (gmds_id)hole++;
    }
  }
}

void gmds_cells_renumber(gmds_cells *cells, const gmds_id *map)
{
  for (gmds_attribute *a = cells->attributes; a; a = a->next)
    for (gmds_id c = gmds_cells_next(cells, 0); c != GMDS_NONE; c = gmds_cells_next(cells, c + 1))
      if (map[c] != c)
        memcpy((char *)a->data + map[c] * a->bytes, (char *)a->data + c * a->bytes, a->bytes);
  cells->end = cells->hole = cells->count;
  gmds_bits_fill(&cells->alive, cells->count);
}

gmds_attribute *gmds_attribute_find(const gmds_cells *cells, const char *name)
{
  for (gmds_attribute *a = cells->attributes; a; a = a->next)
    if (strcmp(a->name, name) == 0)
      return a;
  return NULL;
}

gmds_status gmds_attribute_make(gmds_memory *memory, const char *name, gmds_value type, size_t components,
                                size_t capacity, gmds_attribute **attribute)
{
  size_t bytes = gmds_value_bytes(type);
  if (!name || !*name || !bytes || !components || components > SIZE_MAX / bytes)
    return GMDS_ERR_ARGUMENT;
  void *object = NULL, *text = NULL, *data = NULL;
  size_t name_bytes = strlen(name) + 1;
  bytes *= components;
  if (!gmds_resize(memory, &object, 0, 1, sizeof(gmds_attribute)))
    return GMDS_ERR_MEMORY;
  if (!gmds_resize(memory, &text, 0, name_bytes, 1) || !gmds_resize(memory, &data, 0, capacity, bytes)) {
    if (text)
      gmds_release(memory, text, name_bytes, 1);
    gmds_release(memory, object, 1, sizeof(gmds_attribute));
    return GMDS_ERR_MEMORY;
  }
  memcpy(text, name, name_bytes);
  if (capacity)
    memset(data, 0, capacity * bytes);
  gmds_attribute *a = object;
  *a = (gmds_attribute){NULL, text, name_bytes, type, components, bytes, data};
  *attribute = a;
  return GMDS_OK;
}

void gmds_attribute_free(gmds_memory *memory, gmds_attribute *attribute, size_t capacity)
{
  gmds_release(memory, attribute->data, capacity, attribute->bytes);
  gmds_release(memory, attribute->name, attribute->name_bytes, 1);
  gmds_release(memory, attribute, 1, sizeof *attribute);
}

gmds_status gmds_attribute_add(gmds_cells *cells, const char *name, gmds_value type, size_t components,
                               gmds_attribute **attribute)
{
  gmds_attribute *a = NULL;
  if (name && gmds_attribute_find(cells, name))
    return GMDS_ERR_CONFLICT;
  GMDS_TRY(gmds_attribute_make(cells->alive.memory, name, type, components, cells->capacity, &a));
  a->next = cells->attributes;
  cells->attributes = a;
  *attribute = a;
  return GMDS_OK;
}

void gmds_attribute_remove(gmds_cells *cells, gmds_attribute *attribute)
{
  gmds_attribute **link = &cells->attributes;
  while (*link && *link != attribute)
    link = &(*link)->next;
  if (!*link)
    return;
  *link = attribute->next;
  gmds_attribute_free(cells->alive.memory, attribute, cells->capacity);
}
