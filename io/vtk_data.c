/* Attributes, fields and metadata of VTK's legacy format: skipped, but only where they are as the format has them. */
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

static const gmds_vtk_type colours = {"unsigned_char", GMDS_VTK_UNSIGNED, 1};

/* A name, which may be any token. */
static gmds_status skip_name(gmds_vtk *vtk)
{
  gmds_token token;
  return gmds_text_next_on_line(vtk->text, &token) ? GMDS_OK : gmds_text_expected(vtk->text, "a name", token);
}

/* Skips `tuples` times `width` numbers. */
static gmds_status skip_tuples(gmds_vtk *vtk, gmds_vtk_type type, uint64_t tuples, uint64_t width)
{
  if (width && tuples > UINT64_MAX / width)
    return gmds_text_fail(vtk->text, GMDS_ERR_FORMAT, -1, "%llu tuples of %llu numbers are more than a file holds",
                          (unsigned long long)tuples, (unsigned long long)width);
  return gmds_vtk_skip(vtk, type, tuples * width, "numbers");
}

/* `SCALARS name type [width]`, then `LOOKUP_TABLE name`. */
static gmds_status skip_scalars(gmds_vtk *vtk)
{
  gmds_vtk_type type = {0};
  gmds_token token;
  uint64_t width = 1;
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  if (gmds_text_next_on_line(vtk->text, &token))
    GMDS_TRY(gmds_text_whole(vtk->text, token, "a number of components", &width));
  GMDS_TRY(gmds_text_end_of_line(vtk->text));
  GMDS_TRY(gmds_text_word(vtk->text, "LOOKUP_TABLE"));
  GMDS_TRY(skip_name(vtk));
  return skip_tuples(vtk, type, vtk->tuples, width);
}

/* `TEXTURE_COORDINATES name width type` */
static gmds_status skip_texture(gmds_vtk *vtk)
{
  gmds_vtk_type type = {0};
  uint64_t width = 0;
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &width));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  return skip_tuples(vtk, type, vtk->tuples, width);
}

/* `COLOR_SCALARS name width`: bytes, or numbers as text. */
static gmds_status skip_colours(gmds_vtk *vtk)
{
  uint64_t width = 0;
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &width));
  return skip_tuples(vtk, colours, vtk->tuples, width);
}

/* `LOOKUP_TABLE name n`: n colours of four numbers. */
static gmds_status skip_table(gmds_vtk *vtk)
{
  uint64_t n = 0;
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of colours", &n));
  return skip_tuples(vtk, colours, n, 4);
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
static gmds_status skip_array(gmds_vtk *vtk)
{
  gmds_vtk_type type = {0};
  gmds_token token;
  uint64_t width = 0, tuples = 0;
  gmds_text_next(vtk->text, &token);
  if (gmds_token_is_any_case(token, "METADATA")) {
    GMDS_TRY(skip_metadata(vtk));
    gmds_text_next(vtk->text, &token);
  }
  if (gmds_token_is_any_case(token, "NULL_ARRAY"))
    return GMDS_OK;
  if (!token.n)
    return gmds_text_expected(vtk->text, "the name of an array", token);
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of components", &width));
  GMDS_TRY(gmds_text_next_whole(vtk->text, "a number of tuples", &tuples));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  return skip_tuples(vtk, type, tuples, width);
}

/* `FIELD name n` and n arrays. */
static gmds_status skip_field(gmds_vtk *vtk)
{
  size_t n = 0;
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_text_next_count(vtk->text, 1, "arrays", &n));
  for (size_t k = 0; k < n; k++)
    GMDS_TRY(skip_array(vtk));
  return GMDS_OK;
}

static gmds_status skip_attribute(gmds_vtk *vtk, uint64_t width)
{
  gmds_vtk_type type = {0};
  GMDS_TRY(skip_name(vtk));
  GMDS_TRY(gmds_vtk_next_type(vtk, &type));
  return skip_tuples(vtk, type, vtk->tuples, width);
}

/* `POINT_DATA n` or `CELL_DATA n`: what follows has n tuples. */
static gmds_status start_data(gmds_vtk *vtk)
{
  vtk->has_data = 1;
  return gmds_text_next_whole(vtk->text, "a number of tuples", &vtk->tuples);
}

/* X(keyword, what skips it, whether POINT_DATA or CELL_DATA must come before it) */
#define SECTION_LIST(X)                     \
  X("POINT_DATA", start_data, 0)            \
  X("CELL_DATA", start_data, 0)             \
  X("FIELD", skip_field, 0)                 \
  X("METADATA", skip_metadata, 0)           \
  X("SCALARS", skip_scalars, 1)             \
  X("TEXTURE_COORDINATES", skip_texture, 1) \
  X("COLOR_SCALARS", skip_colours, 1)       \
  X("LOOKUP_TABLE", skip_table, 1)

gmds_status gmds_vtk_skip_section(gmds_vtk *vtk, gmds_token keyword, int *known)
{
#define SECTION(keyword, skip, data) {keyword, skip, data},
  static const struct {
    const char *keyword;
    gmds_status (*skip)(gmds_vtk *);
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
      return sections[i].skip(vtk);
  for (size_t i = 0; i < sizeof attributes / sizeof *attributes; i++)
    if (gmds_token_is_any_case(keyword, attributes[i].keyword) && vtk->has_data)
      return skip_attribute(vtk, attributes[i].width);
  *known = 0;
  return GMDS_OK;
}
