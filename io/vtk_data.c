/* Attributes, fields and metadata of VTK's legacy format. Numbers that stand beside the points or the cells become
 * attributes of the soup; strings, fields of the whole data set, arrays of another length and tables of colours have no
 * place there: they are checked to be as the format has them, counted and left out. Metadata is left out. */
#include "vtk.h"
#include <string.h>

/* X(keyword, numbers a tuple): `keyword name type` */
#define ATTRIBUTE_LIST(X) \
  X("VECTORS", 3)         \
  X("NORMALS", 3)         \
  X("TENSORS", 9)         \
  X("TENSORS6", 6)        \
  X("GLOBAL_IDS", 1)      \
  X("PEDIGREE_IDS", 1)    \
  X("EDGE_FLAGS", 1)

/* An array: its name as it stands in the file, and what it is made of. */
typedef struct array {
  gmds_token name;
  gmds_vtk_type type;
  uint64_t tuples, width;
} array;

/* A name, which may be any token. */
static gmds_status read_name(gmds_vtk *vtk, gmds_token *name)
{
  return gmds_text_next_on_line(vtk->text, name) ? GMDS_OK : gmds_text_expected(vtk->text, "a name", *name);
}

static int hexadecimal(char c)
{
  static const char digits[] = "0123456789abcdef";
  const char *at = c ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
  return at ? (int)(at - digits) : -1;
}

/* A name with what it cannot hold as `%` and two digits. */
static gmds_token decoded(gmds_token name, char text[256])
{
  size_t n = 0;
  for (size_t k = 0; k < name.n && n < 256; k++) {
    int high = name.at[k] == '%' && k + 2 < name.n ? hexadecimal(name.at[k + 1]) : -1;
    int low = high >= 0 ? hexadecimal(name.at[k + 2]) : -1;
    int byte = low >= 0 ? high << 4 | low : name.at[k];
    text[n++] = (char)byte;
    k += low >= 0 ? 2 : 0;
  }
  return (gmds_token){text, n};
}

/* The numbers of an array that has a row for every row of a place. */
static gmds_status read_rows(gmds_vtk *vtk, const array *a)
{
  char text[256], row[8 * GMDS_MOST_COMPONENTS];
  gmds_vtk_block block;
  gmds_attribute *attribute = NULL;
  gmds_value type = gmds_vtk_value_type(a->type);
  size_t bytes = gmds_value_bytes(type);
  GMDS_TRY(gmds_vtk_start(vtk, a->type, a->tuples * a->width, "numbers", &block));
  GMDS_TRY(
      gmds_stage_column(vtk->stage, vtk->text, vtk->place, decoded(a->name, text), type, (size_t)a->width, &attribute));
  for (size_t k = 0; k < (size_t)a->tuples; k++) {
    for (size_t j = 0; j < (size_t)a->width; j++)
      GMDS_TRY(gmds_vtk_value(&block, type, row + j * bytes));
    gmds_stage_row(vtk->stage, vtk->place, attribute, k, row);
  }
  *vtk->text = block.text;
  return GMDS_OK;
}

/* Bits of a BINARY file are packed; as values they are 0 and 1. */
static gmds_status read_bits(gmds_vtk *vtk, const array *a)
{
  char text[256];
  uint8_t row[GMDS_MOST_COMPONENTS];
  gmds_attribute *attribute = NULL;
  gmds_text before = *vtk->text;
  GMDS_TRY(gmds_vtk_skip(vtk, a->type, a->tuples * a->width, "numbers"));
  GMDS_TRY(gmds_stage_column(vtk->stage, &before, vtk->place, decoded(a->name, text), GMDS_BYTE, (size_t)a->width,
                             &attribute));
  uint64_t n = a->tuples * a->width;
  const char *bits = vtk->text->at - (n / 8 + (n % 8 != 0));
  for (size_t k = 0, bit = 0; k < (size_t)a->tuples; k++) {
    for (size_t j = 0; j < (size_t)a->width; j++, bit++)
      row[j] = (uint8_t)((unsigned char)bits[bit / 8] >> (7 - bit % 8) & 1);
    gmds_stage_row(vtk->stage, vtk->place, attribute, k, row);
  }
  return GMDS_OK;
}

/* Makes an array an attribute, or leaves it out. */
static gmds_status read_array(gmds_vtk *vtk, const array *a)
{
  if (a->width && a->tuples > UINT64_MAX / a->width)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "%llu tuples of %llu numbers are more than a file holds",
                          (unsigned long long)a->tuples, (unsigned long long)a->width);
  if (vtk->has_data && a->type.kind != GMDS_VTK_STRING && a->width && a->tuples == vtk->tuples)
    return a->type.kind == GMDS_VTK_BIT && vtk->binary ? read_bits(vtk, a) : read_rows(vtk, a);
  vtk->stage->soup.unread++;
  return gmds_vtk_skip(vtk, a->type, a->tuples * a->width, "numbers");
}

/* `SCALARS name type [width]`, then `LOOKUP_TABLE name`. */
static gmds_status read_scalars(gmds_vtk *vtk)
{
  array a = {.tuples = vtk->tuples, .width = 1};
  gmds_token token;
  GMDS_TRY(read_name(vtk, &a.name));
  GMDS_TRY(gmds_vtk_next_type(vtk, &a.type));
  if (gmds_text_next_on_line(vtk->text, &token))
    GMDS_TRY(gmds_text_whole(vtk->text, token, "a number of components", &a.width));
  GMDS_TRY(gmds_text_end_of_line(vtk->text));
  GMDS_TRY(gmds_text_word(vtk->text, "LOOKUP_TABLE"));
  GMDS_TRY(read_name(vtk, &token));
  return read_array(vtk, &a);
}

/* `TEXTURE_COORDINATES name width type` */
static gmds_status read_texture(gmds_vtk *vtk)
{
  array a = {.tuples = vtk->tuples};
  GMDS_TRY(read_name(vtk, &a.name));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &a.width));
  GMDS_TRY(gmds_vtk_next_type(vtk, &a.type));
  return read_array(vtk, &a);
}

/* Bytes, or numbers from 0 to 1 as text. */
static gmds_vtk_type type_of_colours(const gmds_vtk *vtk)
{
  static const gmds_vtk_type binary = {"unsigned_char", GMDS_VTK_UNSIGNED, 1}, text = {"float", GMDS_VTK_REAL, 4};
  return vtk->binary ? binary : text;
}

/* `COLOR_SCALARS name width` */
static gmds_status read_colours(gmds_vtk *vtk)
{
  array a = {.tuples = vtk->tuples, .type = type_of_colours(vtk)};
  GMDS_TRY(read_name(vtk, &a.name));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &a.width));
  return read_array(vtk, &a);
}

/* `LOOKUP_TABLE name n`: n colours of four numbers. */
static gmds_status skip_table(gmds_vtk *vtk)
{
  uint64_t n = 0;
  gmds_token name;
  GMDS_TRY(read_name(vtk, &name));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of colours", &n));
  GMDS_TRY(gmds_text_bound(vtk->text, n, 4, "colours"));
  vtk->stage->soup.unread++;
  return gmds_vtk_skip(vtk, type_of_colours(vtk), 4 * n, "numbers");
}

/* Lines up to an empty one. */
static gmds_status skip_metadata(gmds_vtk *vtk)
{
  gmds_token token;
  gmds_text_skip_line(vtk->text);
  while (gmds_text_next_on_line(vtk->text, &token))
    gmds_text_skip_line(vtk->text);
  return GMDS_OK;
}

/* An array of a field: `name width tuples type`, or NULL_ARRAY; metadata may stand before it. */
static gmds_status read_field_array(gmds_vtk *vtk)
{
  array a = {.tuples = 0};
  gmds_text_next(vtk->text, &a.name);
  if (gmds_token_is_any_case(a.name, "METADATA")) {
    GMDS_TRY(skip_metadata(vtk));
    gmds_text_next(vtk->text, &a.name);
  }
  if (gmds_token_is_any_case(a.name, "NULL_ARRAY"))
    return GMDS_OK;
  if (!a.name.n)
    return gmds_text_expected(vtk->text, "the name of an array", a.name);
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &a.width));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of tuples", &a.tuples));
  GMDS_TRY(gmds_vtk_next_type(vtk, &a.type));
  return read_array(vtk, &a);
}

/* `FIELD name n` and n arrays. */
static gmds_status read_field(gmds_vtk *vtk)
{
  size_t n = 0;
  gmds_token name;
  GMDS_TRY(read_name(vtk, &name));
  GMDS_TRY(gmds_text_next_count(vtk->text, 1, "arrays", &n));
  for (size_t k = 0; k < n; k++)
    GMDS_TRY(read_field_array(vtk));
  return GMDS_OK;
}

static gmds_status read_attribute(gmds_vtk *vtk, uint64_t width)
{
  array a = {.tuples = vtk->tuples, .width = width};
  GMDS_TRY(read_name(vtk, &a.name));
  GMDS_TRY(gmds_vtk_next_type(vtk, &a.type));
  return read_array(vtk, &a);
}

/* `POINT_DATA n` or `CELL_DATA n`: what follows has n tuples, as many as there are points or cells. */
static gmds_status start_data(gmds_vtk *vtk, gmds_place place, const char *what)
{
  size_t rows = gmds_stage_rows(vtk->stage, place);
  vtk->has_data = 1;
  vtk->place = place;
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of tuples", &vtk->tuples));
  if (vtk->tuples == rows)
    return GMDS_OK;
  return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "expected the attributes of %zu %s, found those of %llu", rows,
                        what, (unsigned long long)vtk->tuples);
}

static gmds_status start_point_data(gmds_vtk *vtk)
{
  return start_data(vtk, GMDS_OF_POINTS, "points");
}

static gmds_status start_cell_data(gmds_vtk *vtk)
{
  return start_data(vtk, GMDS_OF_CELLS, "cells");
}

/* X(keyword, what reads it, whether POINT_DATA or CELL_DATA must come before it) */
#define SECTION_LIST(X)                     \
  X("POINT_DATA", start_point_data, 0)      \
  X("CELL_DATA", start_cell_data, 0)        \
  X("FIELD", read_field, 0)                 \
  X("METADATA", skip_metadata, 0)           \
  X("SCALARS", read_scalars, 1)             \
  X("TEXTURE_COORDINATES", read_texture, 1) \
  X("COLOR_SCALARS", read_colours, 1)       \
  X("LOOKUP_TABLE", skip_table, 1)

gmds_status gmds_vtk_read_data(gmds_vtk *vtk, gmds_token keyword, int *known)
{
#define SECTION(keyword, read, data) {keyword, read, data},
  static const struct {
    const char *keyword;
    gmds_status (*read)(gmds_vtk *);
    int data;
  } sections[] = {SECTION_LIST(SECTION)};
#undef SECTION
#define ATTRIBUTE(keyword, width) {keyword, width},
  static const struct {
    const char *keyword;
    unsigned width;
  } attributes[] = {ATTRIBUTE_LIST(ATTRIBUTE)};
#undef ATTRIBUTE
  *known = 1;
  for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
    if (gmds_token_is_any_case(keyword, sections[i].keyword) && (!sections[i].data || vtk->has_data))
      return sections[i].read(vtk);
  for (size_t i = 0; i < sizeof attributes / sizeof *attributes; i++)
    if (gmds_token_is_any_case(keyword, attributes[i].keyword) && vtk->has_data)
      return read_attribute(vtk, attributes[i].width);
  *known = 0;
  return GMDS_OK;
}
