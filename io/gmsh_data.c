/* $NodeData and $ElementData of MSH files: attributes of doubles under the name of their view; a second one under a
 * name is told by its time step. Nodes and elements that a section does not list have 0. */
#include "gmsh.h"
#include <stdio.h>
#include <string.h>

/* The tags before the rows: the name of the view, the time step, components a row, rows. */
typedef struct view {
  gmds_token name;
  int step, components, rows;
} view;

/* A number of tags, which is text in binary files too. */
static gmds_status read_count(gmds_gmsh *gmsh, const char *what, uint64_t *n)
{
  GMDS_TRY(gmds_text_next_whole(gmsh->text, what, n));
  return gmds_text_bound(gmsh->text, *n, 2, "tags");
}

/* The rest of a line without its quotes. */
static gmds_status read_string(gmds_gmsh *gmsh, gmds_token *string)
{
  gmds_text *text = gmsh->text;
  gmds_token token;
  if (!gmds_text_next(text, &token))
    return gmds_text_expected(text, "a name", token);
  const char *end = memchr(token.at, '\n', (size_t)(text->end - token.at));
  end = end ? end : text->end;
  text->at = end;
  while (end > token.at && (end[-1] == '\r' || end[-1] == ' ' || end[-1] == '\t'))
    end--;
  *string = (gmds_token){token.at, (size_t)(end - token.at)};
  if (string->n > 1 && *string->at == '"' && end[-1] == '"')
    *string = (gmds_token){string->at + 1, string->n - 2};
  return GMDS_OK;
}

static gmds_status read_view(gmds_gmsh *gmsh, view *v)
{
  uint64_t n = 0;
  gmds_token string;
  double ignored;
  int *const integers[] = {&v->step, &v->components, &v->rows};
  gmds_gmsh text = *gmsh; /* tags are text */
  text.binary = 0;
  *v = (view){.name = {"view", 4}, .components = 1};
  GMDS_TRY(read_count(gmsh, "a number of string tags", &n));
  for (uint64_t k = 0; k < n; k++)
    GMDS_TRY(read_string(gmsh, k ? &string : &v->name));
  GMDS_TRY(read_count(gmsh, "a number of real tags", &n));
  for (uint64_t k = 0; k < n; k++)
    GMDS_TRY(gmds_text_next_value(gmsh->text, GMDS_DOUBLE, &ignored));
  GMDS_TRY(read_count(gmsh, "a number of integer tags", &n));
  for (uint64_t k = 0; k < n; k++) {
    int x = 0;
    GMDS_TRY(gmds_gmsh_int(&text, "an integer tag", &x));
    if (k < 3)
      *integers[k] = x;
  }
  if (n < 3 || v->rows < 0 || v->components < 1)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "expected a time step, components and a number of rows");
  return gmds_gmsh_start_words(gmsh);
}

static gmds_status make_column(gmds_gmsh *gmsh, gmds_place place, const view *v, gmds_attribute **column)
{
  char name[300];
  size_t n = v->name.n < 256 ? v->name.n : 256; /* a longer one is refused */
  memcpy(name, v->name.at, n);
  name[n] = 0;
  if (gmds_soup_find_attribute(&gmsh->stage->soup, place, name))
    n += (size_t)snprintf(name + n, sizeof name - n, " %d", v->step);
  return gmds_stage_column(gmsh->stage, gmsh->text, place, (gmds_token){name, n}, GMDS_DOUBLE, (size_t)v->components,
                           column);
}

gmds_status gmds_gmsh_read_data(gmds_gmsh *gmsh, gmds_place place)
{
  view v;
  double row[GMDS_MOST_COMPONENTS];
  gmds_attribute *column = NULL;
  const gmds_tags *tags = place == GMDS_OF_POINTS ? &gmsh->nodes : &gmsh->elements;
  const char *what = place == GMDS_OF_POINTS ? "node" : "element";
  GMDS_TRY(read_view(gmsh, &v));
  GMDS_TRY(gmds_gmsh_bound(gmsh, (uint64_t)v.rows, 1, 0, (size_t)v.components, "rows"));
  GMDS_TRY(make_column(gmsh, place, &v, &column));
  for (int k = 0; k < v.rows; k++) {
    int tag = 0;
    size_t n;
    GMDS_TRY(gmds_gmsh_int(gmsh, "the number of a node or an element", &tag));
    for (int j = 0; j < v.components; j++)
      GMDS_TRY(gmds_gmsh_value(gmsh, &row[j]));
    size_t at = gmds_tags_find(tags, (uint64_t)(int64_t)tag, &n);
    if (!n)
      return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "no %s has the number %d", what, tag);
    for (size_t i = 0; i < n; i++)
      gmds_stage_row(gmsh->stage, place, column, gmds_tags_item(tags, at + i), row);
  }
  return gmds_text_word(gmsh->text, place == GMDS_OF_POINTS ? "$EndNodeData" : "$EndElementData");
}
