/* A combinatorial map as bytes that any machine reads, numbers with their lowest byte first:
 *
 *   "gmds map"  version  n  coordinates  kept  width                  8 bytes, then 4 each; kept: bit i for i-cells
 *   darts, nodes, edges, faces, regions                               8 bytes each: how many
 *   beta_1 to beta_n of each dart, then its kept cells                `width` (4 or 8) bytes each, all ones for none
 *   a dart of each cell, dimension by dimension                       `width` bytes each
 *   coordinates of each node                                          8 bytes each, as IEEE 754
 *   for each kept dimension: how many attributes (4), and of each: length of the name (4), the name, type (4),
 *   components (4), the values in the order of the cells: 8 bytes each, bytes 1, floats and ints 4
 *
 * Darts and cells are numbered without holes. What is read is verified before it replaces anything. */
#include "map_inside.h"
#include <string.h>

enum { VERSION = 1, HEADER = 8 + 5 * 4 + 5 * 8 };
static const char magic[] = "gmds map";

void gmds_map_bytes_clear(gmds_map_bytes *bytes)
{
  gmds_release(bytes->memory, bytes->data, bytes->capacity, 1);
  *bytes = (gmds_map_bytes){.memory = bytes->memory};
}

/* ---- writing */

static gmds_status put(gmds_map_bytes *b, uint64_t x, size_t bytes)
{
  if (b->n + bytes > b->capacity) {
    void *data = b->data;
    const size_t grown = gmds_grown(b->capacity, b->n + bytes);
    if (!gmds_resize(b->memory, &data, b->capacity, grown, 1))
      return GMDS_ERR_MEMORY;
    b->data = data;
    b->capacity = grown;
  }
  for (size_t k = 0; k < bytes; k++)
    b->data[b->n++] = (unsigned char)(x >> 8 * k);
  return GMDS_OK;
}

/* How a value is written. */
static size_t written_bytes(gmds_value type)
{
  return type == GMDS_BYTE ? 1 : type == GMDS_FLOAT || type == GMDS_INT ? 4 : 8;
}

static gmds_status put_value(gmds_map_bytes *b, gmds_value type, const void *value)
{
  uint64_t x = 0;
  uint32_t w = 0;
  gmds_id id = 0;
  if (type == GMDS_ID) {
    memcpy(&id, value, sizeof id);
    x = id == GMDS_NONE ? UINT64_MAX : id;
  } else if (written_bytes(type) == 8)
    memcpy(&x, value, sizeof x);
  else if (written_bytes(type) == 4) {
    memcpy(&w, value, sizeof w);
    x = w;
  } else
    x = *(const uint8_t *)value;
  return put(b, x, written_bytes(type));
}

static gmds_status put_attributes(gmds_map_bytes *b, const gmds_cells *cells)
{
  uint64_t n = 0;
  for (const gmds_attribute *a = cells->attributes; a; a = a->next)
    n++;
  GMDS_TRY(put(b, n, 4));
  for (const gmds_attribute *a = cells->attributes; a; a = a->next) {
    const size_t length = strlen(a->name), size = gmds_value_bytes(a->type);
    GMDS_TRY(put(b, length, 4));
    for (size_t k = 0; k < length; k++)
      GMDS_TRY(put(b, (unsigned char)a->name[k], 1));
    GMDS_TRY(put(b, (uint64_t)a->type, 4));
    GMDS_TRY(put(b, a->components, 4));
    for (gmds_id c = gmds_cells_next(cells, 0); c != GMDS_NONE; c = gmds_cells_next(cells, c + 1))
      for (size_t k = 0; k < a->components; k++)
        GMDS_TRY(put_value(b, a->type, (const char *)a->data + c * a->bytes + k * size));
  }
  return GMDS_OK;
}

/* Numbers without holes: of darts, then of the cells of each dimension, in one array. */
typedef struct numbering {
  gmds_id *of[GMDS_MAP_KEPT + 1]; /* the last: of darts */
  size_t n;
} numbering;

static gmds_status number_all(const gmds_map *map, gmds_memory *memory, numbering *numbers)
{
  void *block = NULL;
  size_t at = 0;
  numbers->n = map->darts.end;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    numbers->n += map->cells[i].end;
  if (!gmds_resize(memory, &block, 0, numbers->n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  for (int i = 0; i <= GMDS_MAP_KEPT; i++) {
    const gmds_cells *cells = i < GMDS_MAP_KEPT ? &map->cells[i] : &map->darts;
    gmds_id next = 0;
    numbers->of[i] = (gmds_id *)block + at;
    for (gmds_id c = gmds_cells_next(cells, 0); c != GMDS_NONE; c = gmds_cells_next(cells, c + 1))
      numbers->of[i][c] = next++;
    at += cells->end;
  }
  return GMDS_OK;
}

static gmds_status put_id(gmds_map_bytes *b, const gmds_id *number, gmds_id id, size_t width)
{
  return put(b, id == GMDS_NONE ? UINT64_MAX : number[id], width);
}

static gmds_status put_map(gmds_map_bytes *b, const gmds_map *map, const numbering *numbers, size_t width)
{
  const gmds_id *darts = numbers->of[GMDS_MAP_KEPT];
  for (gmds_id d = gmds_cells_next(&map->darts, 0); d != GMDS_NONE; d = gmds_cells_next(&map->darts, d + 1)) {
    for (int i = 1; i <= map->n; i++)
      GMDS_TRY(put_id(b, darts, gmds_map_beta(map, i, d), width));
    for (int i = 0; i < GMDS_MAP_KEPT; i++)
      if (map->slot[i])
        GMDS_TRY(put_id(b, numbers->of[i], gmds_map_cell(map, i, d), width));
  }
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    for (gmds_id c = gmds_cells_next(&map->cells[i], 0); c != GMDS_NONE; c = gmds_cells_next(&map->cells[i], c + 1))
      GMDS_TRY(put_id(b, darts, map->anchor[i][c], width));
  for (gmds_id v = gmds_cells_next(&map->cells[0], 0); v != GMDS_NONE; v = gmds_cells_next(&map->cells[0], v + 1))
    for (int k = 0; k < map->coordinates; k++)
      GMDS_TRY(put_value(b, GMDS_DOUBLE, gmds_map_point(map, v) + k));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i])
      GMDS_TRY(put_attributes(b, &map->cells[i]));
  return GMDS_OK;
}

gmds_status gmds_map_write(const gmds_map *map, gmds_map_bytes *bytes)
{
  gmds_map_bytes b = {.memory = bytes->memory};
  numbering numbers;
  uint64_t kept = 0, most = map->darts.count;
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    kept |= map->slot[i] ? 1u << i : 0;
    most = map->cells[i].count > most ? map->cells[i].count : most;
  }
  const size_t width = most < UINT32_MAX ? 4 : 8;
  const uint64_t header[5] = {VERSION, (uint64_t)map->n, (uint64_t)map->coordinates, kept, width};
  GMDS_TRY(number_all(map, bytes->memory, &numbers));
  gmds_status status = GMDS_OK;
  for (size_t k = 0; k < 8 && status == GMDS_OK; k++)
    status = put(&b, (unsigned char)magic[k], 1);
  for (int k = 0; k < 5 && status == GMDS_OK; k++)
    status = put(&b, header[k], 4);
  for (int i = -1; i < GMDS_MAP_KEPT && status == GMDS_OK; i++)
    status = put(&b, i < 0 ? map->darts.count : map->cells[i].count, 8);
  if (status == GMDS_OK)
    status = put_map(&b, map, &numbers, width);
  gmds_release(bytes->memory, numbers.of[0], numbers.n, sizeof(gmds_id));
  if (status == GMDS_OK) {
    gmds_map_bytes_clear(bytes);
    *bytes = b;
  } else
    gmds_map_bytes_clear(&b);
  return status;
}

/* ---- reading */

typedef struct reading {
  const unsigned char *data;
  size_t n, at;
  size_t width;
  size_t count[GMDS_MAP_KEPT + 1]; /* the last: darts */
  gmds_error *error;
} reading;

static gmds_status broken(const reading *r, const char *what)
{
  if (r->error)
    r->error->cell = (long long)r->at;
  return gmds_fail(r->error, GMDS_ERR_FORMAT, "byte %zu: %s", r->at, what);
}

static uint64_t get(reading *r, size_t bytes)
{
  const uint64_t x = read_little(r->data + r->at, bytes);
  r->at += bytes;
  return x;
}

static int has(const reading *r, size_t bytes)
{
  return bytes <= r->n - r->at;
}

/* An identifier below `end`, or none. */
static gmds_status get_id(reading *r, size_t end, gmds_id *id)
{
  const uint64_t x = get(r, r->width), none = r->width == 8 ? UINT64_MAX : UINT32_MAX;
  if (x != none && x >= end) {
    r->at -= r->width;
    return broken(r, "a dart or cell that does not exist");
  }
  *id = x == none ? GMDS_NONE : (gmds_id)x;
  return GMDS_OK;
}

static gmds_status get_header(reading *r, const gmds_map *map)
{
  unsigned kept = 0;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    kept |= map->slot[i] ? 1u << i : 0;
  if (!has(r, HEADER) || memcmp(r->data, magic, 8))
    return broken(r, "these bytes do not begin as a map does");
  r->at = 8;
  const uint64_t version = get(r, 4), n = get(r, 4), coordinates = get(r, 4), cells = get(r, 4);
  if (version != VERSION)
    return gmds_fail(r->error, GMDS_ERR_UNSUPPORTED, "version %llu of the bytes of a map", (unsigned long long)version);
  if (n != (uint64_t)map->n || coordinates != (uint64_t)map->coordinates || cells != kept)
    return gmds_fail(r->error, GMDS_ERR_UNSUPPORTED,
                     "a map of dimension %llu with %llu coordinates and cells %llu, to be read into %d, %d, %u",
                     (unsigned long long)n, (unsigned long long)coordinates, (unsigned long long)cells, map->n,
                     map->coordinates, kept);
  r->width = (size_t)get(r, 4);
  if (r->width != 4 && r->width != 8)
    return broken(r, "identifiers have 4 bytes or 8");
  for (int i = 0; i <= GMDS_MAP_KEPT; i++) {
    const int of = i ? i - 1 : GMDS_MAP_KEPT;
    const uint64_t count = get(r, 8);
    if (count >= GMDS_NONE)
      return gmds_fail(r->error, GMDS_ERR_TOO_MANY, "%llu darts or cells", (unsigned long long)count);
    if (count > r->n || (of < GMDS_MAP_KEPT && !map->slot[of] && count))
      return broken(r, "more darts or cells than there are bytes");
    r->count[of] = (size_t)count;
  }
  size_t needed = r->count[GMDS_MAP_KEPT] * (size_t)(map->stride - 1) * r->width;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    needed += r->count[i] * (r->width + (i ? 0 : (size_t)map->coordinates * 8));
  return r->n > SIZE_MAX / 256 || !has(r, needed) ? broken(r, "fewer bytes than the darts and cells need") : GMDS_OK;
}

static gmds_status get_darts(reading *r, gmds_map *map)
{
  const size_t n = r->count[GMDS_MAP_KEPT];
  for (size_t d = 0; d < n; d++) {
    (void)gmds_map_take_dart(map);
    for (int i = 0; i <= map->n; i++)
      gmds_map_record(map, (gmds_id)d)[i] = GMDS_NONE;
  }
  for (size_t d = 0; d < n; d++) {
    gmds_id *record = gmds_map_record(map, (gmds_id)d);
    for (int i = 1; i <= map->n; i++)
      GMDS_TRY(get_id(r, n, &record[i]));
    if (record[1] != GMDS_NONE)
      gmds_map_record(map, record[1])[0] = (gmds_id)d; /* the check finds two that lead to one dart */
    for (int i = 0; i < GMDS_MAP_KEPT; i++)
      if (map->slot[i])
        GMDS_TRY(get_id(r, r->count[i], &record[map->slot[i]]));
  }
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    for (size_t c = 0; c < r->count[i]; c++)
      GMDS_TRY(get_id(r, n, &map->anchor[i][c]));
  for (size_t k = 0; k < r->count[0] * (size_t)map->coordinates; k++) {
    const uint64_t w = get(r, 8);
    memcpy(map->points + k, &w, sizeof w);
  }
  return GMDS_OK;
}

static void set_value(gmds_value type, uint64_t x, void *value)
{
  const uint32_t w = (uint32_t)x;
  const gmds_id id = x >= GMDS_NONE ? GMDS_NONE : (gmds_id)x;
  if (type == GMDS_ID)
    memcpy(value, &id, sizeof id);
  else if (written_bytes(type) == 8)
    memcpy(value, &x, sizeof x);
  else if (written_bytes(type) == 4)
    memcpy(value, &w, sizeof w);
  else
    *(uint8_t *)value = (uint8_t)x;
}

static gmds_status get_attribute(reading *r, gmds_map *map, int i)
{
  char name[256];
  gmds_attribute *a = NULL;
  if (!has(r, 4))
    return broken(r, "the name of an attribute is missing");
  const uint64_t length = get(r, 4);
  if (!length || length >= sizeof name || !has(r, (size_t)length + 8))
    return broken(r, "the name of an attribute is empty, too long or cut");
  memcpy(name, r->data + r->at, (size_t)length);
  name[length] = '\0';
  r->at += (size_t)length;
  const uint64_t type = get(r, 4), components = get(r, 4);
  if (strlen(name) != length || type >= GMDS_VALUE_COUNT || !components)
    return broken(r, "an attribute of no known type");
  const size_t each = written_bytes((gmds_value)type), size = gmds_value_bytes((gmds_value)type);
  const uint64_t values = components * (r->count[i] ? r->count[i] : 1);
  if (components > r->n + 256 ||
      (r->count[i] && (values / r->count[i] != components || values > (r->n - r->at) / each)))
    return broken(r, "fewer bytes than the values of an attribute need");
  gmds_status status = gmds_attribute_add(&map->cells[i], name, (gmds_value)type, (size_t)components, &a);
  if (status == GMDS_ERR_CONFLICT)
    return broken(r, "two attributes of one name");
  for (size_t k = 0; status == GMDS_OK && k < r->count[i] * (size_t)components; k++)
    set_value((gmds_value)type, get(r, each), (char *)a->data + k * size);
  return status;
}

static gmds_status get_map(reading *r, gmds_map *map)
{
  GMDS_TRY(gmds_map_reserve(map, r->count[GMDS_MAP_KEPT], r->count));
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    if (map->slot[i])
      (void)gmds_cells_take_many(&map->cells[i], r->count[i]);
  GMDS_TRY(get_darts(r, map));
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    if (!map->slot[i])
      continue;
    if (!has(r, 4))
      return broken(r, "the number of attributes is missing");
    for (uint64_t n = get(r, 4); n; n--)
      GMDS_TRY(get_attribute(r, map, i));
  }
  if (r->at != r->n)
    return broken(r, "there are more bytes than the map has");
  gmds_error first = {.status = GMDS_OK};
  gmds_status status = gmds_map_check(map, &map->memory, NULL, &first);
  return status == GMDS_ERR_INVARIANT ? gmds_fail(r->error, GMDS_ERR_FORMAT, "what was read is no map: %s", first.text)
                                      : status;
}

gmds_status gmds_map_read(gmds_map *map, size_t n, const unsigned char *data, gmds_error *error)
{
  gmds_error first = {.status = GMDS_OK, .cell = -1};
  reading r = {.data = data, .n = n, .error = &first};
  gmds_map other;
  unsigned kept = 0;
  for (int i = 0; i < GMDS_MAP_KEPT; i++) {
    kept |= map->slot[i] ? 1u << i : 0;
    if (map->cells[i].count || map->cells[i].attributes || map->darts.count)
      return gmds_fail(error, GMDS_ERR_ARGUMENT, "the map to be read into is not empty, or has attributes");
  }
  gmds_map_init(&other, map->n, map->coordinates, kept, &map->memory.allocator);
  other.memory.limit = map->memory.limit;
  for (int i = 0; i < GMDS_MAP_KEPT; i++)
    other.cells[i].limit = map->cells[i].limit;
  other.darts.limit = map->darts.limit;
  gmds_status status = get_header(&r, map);
  if (status == GMDS_OK)
    status = get_map(&r, &other);
  if (status == GMDS_OK) {
    gmds_map_become(map, &other);
    return GMDS_OK;
  }
  gmds_map_clear(&other);
  if (error && first.status != GMDS_OK)
    *error = first;
  else
    gmds_fail(error, status, "reading a map: %s", gmds_status_text(status));
  return status;
}
