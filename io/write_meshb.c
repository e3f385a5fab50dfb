/* Writer of Medit's .meshb: version 3, little-endian, which has doubles, indices of 32 bits and positions of 64. */
#include "writers.h"

/* X(type, code) */
#define CODE_LIST(X)       \
  X(GMDS_SEGMENT, 5)       \
  X(GMDS_TRIANGLE, 6)      \
  X(GMDS_QUADRILATERAL, 7) \
  X(GMDS_TETRAHEDRON, 8)   \
  X(GMDS_PYRAMID, 49)      \
  X(GMDS_PRISM, 9)         \
  X(GMDS_HEXAHEDRON, 10)

typedef struct meshb {
  const gmds_sink *sink;
  uint64_t position; /* of the next keyword */
} meshb;

static void put_int(const meshb *m, uint64_t x)
{
  gmds_put_word(m->sink->file, x, 4, 1);
}

/* A code, where the keyword behind its n rows of so many bytes begins, and n. */
static void begin(meshb *m, int code, size_t n, size_t bytes)
{
  m->position += 4 + 8 + 4 + (uint64_t)n * bytes;
  put_int(m, (uint64_t)code);
  gmds_put_word(m->sink->file, m->position, 8, 1);
  put_int(m, n);
}

static const gmds_attribute *references(const gmds_soup *soup, gmds_place place)
{
  const gmds_attribute *a = gmds_soup_find_attribute(soup, place, "ref");
  return a && gmds_medit_holds(soup, place, a) ? a : NULL;
}

static void write_cells(meshb *m, gmds_cell_type type, int code)
{
  const gmds_soup *soup = m->sink->soup;
  const gmds_attribute *reference = references(soup, GMDS_OF_CELLS);
  size_t n = 0;
  for (size_t c = 0; c < soup->n_cells; c++)
    n += soup->types[c] == type;
  if (!n)
    return;
  begin(m, code, n, 4 * ((size_t)gmds_cell_type_points(type) + 1));
  for (size_t c = 0; c < soup->n_cells; c++) {
    if (soup->types[c] != type)
      continue;
    for (size_t k = soup->begin[c]; k < soup->begin[c + 1]; k++)
      put_int(m, (uint64_t)soup->corners[k] + 1);
    put_int(m, (uint32_t)gmds_reference(reference, c));
  }
}

gmds_status gmds_write_meshb(const gmds_sink *sink)
{
  const gmds_soup *soup = sink->soup;
  const gmds_attribute *reference = references(soup, GMDS_OF_POINTS);
  meshb m = {.sink = sink, .position = 4 + 4 + 4 + 8 + 4};
  if (soup->n_points > INT32_MAX || soup->n_cells > INT32_MAX)
    return gmds_sink_fail(sink, GMDS_ERR_UNSUPPORTED, "version 3 of Medit has indices of 32 bits, which are too few");
  put_int(&m, 1);
  put_int(&m, 3);
  put_int(&m, 3); /* the keyword of the dimension */
  gmds_put_word(sink->file, m.position, 8, 1);
  put_int(&m, (uint64_t)soup->dim);
  begin(&m, 4, soup->n_points, 8 * (size_t)soup->dim + 4);
  for (size_t p = 0; p < soup->n_points; p++) {
    for (int k = 0; k < soup->dim; k++)
      gmds_put_double(sink->file, gmds_coordinate(soup, p, k), 1);
    put_int(&m, (uint32_t)gmds_reference(reference, p));
  }
#define WRITE(type, code) write_cells(&m, type, code);
  CODE_LIST(WRITE)
#undef WRITE
  put_int(&m, 54);
  gmds_put_word(sink->file, 0, 8, 1);
  return GMDS_OK;
}
