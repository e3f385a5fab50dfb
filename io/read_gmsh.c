/* Gmsh's MSH, versions 2.2 and 4.1, ASCII and binary: the header, and the order of the sections. Names of physical
 * groups, periodic links, partitions and the like are counted and left out; comments are left out. */
#include "gmsh.h"
#include "readers.h"
#include <string.h>

/* `version 0|1 8`, and in a binary file the number 1 as an int, which tells the order of bytes. */
static gmds_status read_format(gmds_gmsh *gmsh)
{
  gmds_text *text = gmsh->text;
  gmds_token token;
  double version = 0;
  uint64_t binary = 0, size = 0;
  GMDS_TRY(gmds_text_word(text, "$MeshFormat"));
  gmds_text_next(text, &token);
  if (gmds_parse_double(token.at, token.n, &version) != GMDS_NUMBER_OK)
    return gmds_text_expected(text, "a version", token);
  gmsh->version = version >= 2 && version < 2.3 ? 22 : version > 4.05 && version < 4.15 ? 41 : 0;
  if (!gmsh->version)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "version %g: only 2.2 and 4.1 are read", version);
  GMDS_TRY(gmds_text_next_whole(text, "0 for text or 1 for binary", &binary));
  GMDS_TRY(gmds_text_next_whole(text, "the size of numbers", &size));
  if (binary > 1 || size != 8)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "expected 0 or 1 and a size of 8, found %llu and %llu",
                          (unsigned long long)binary, (unsigned long long)size);
  gmsh->binary = text->binary = (int)binary;
  GMDS_TRY(gmds_gmsh_start_words(gmsh));
  if (gmsh->binary) {
    if (gmds_text_left(text) < 4 || (memcmp(text->at, "\1\0\0\0", 4) != 0 && memcmp(text->at, "\0\0\0\1", 4) != 0))
      return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected the number 1 as an int");
    gmsh->little = *text->at;
    text->at += 4;
  }
  return gmds_text_word(text, "$EndMeshFormat");
}

/* Goes behind the end of a section: `$End` and its name on a line. */
static gmds_status skip_section(gmds_gmsh *gmsh, gmds_token keyword)
{
  gmds_text *text = gmsh->text;
  while (text->at < text->end) {
    const char *dollar = memchr(text->at, '$', (size_t)(text->end - text->at));
    text->at = dollar ? dollar : text->end;
    if (gmds_text_left(text) >= keyword.n + 3 && memcmp(text->at, "$End", 4) == 0 &&
        memcmp(text->at + 4, keyword.at + 1, keyword.n - 1) == 0) {
      text->at += keyword.n + 3;
      for (const char *at = keyword.at; at < text->at && !text->binary; at++)
        text->line += *at == '\n';
      return GMDS_OK;
    }
    text->at += dollar != NULL;
  }
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "the section %.*s has no end", keyword.n < 40 ? (int)keyword.n : 40,
                        keyword.at);
}

static gmds_status read_section(gmds_gmsh *gmsh, gmds_token keyword)
{
  if (gmds_token_is(keyword, "$Entities"))
    return gmds_gmsh_read_entities(gmsh);
  if (gmds_token_is(keyword, "$Nodes"))
    return gmds_gmsh_read_nodes(gmsh);
  if (gmds_token_is(keyword, "$Elements"))
    return gmds_gmsh_read_elements(gmsh);
  if (gmds_token_is(keyword, "$NodeData"))
    return gmds_gmsh_read_data(gmsh, GMDS_OF_POINTS);
  if (gmds_token_is(keyword, "$ElementData"))
    return gmds_gmsh_read_data(gmsh, GMDS_OF_CELLS);
  if (keyword.n < 2 || *keyword.at != '$' || (keyword.n > 4 && memcmp(keyword.at, "$End", 4) == 0))
    return gmds_text_expected(gmsh->text, "a section of MSH", keyword);
  gmsh->stage->soup.unread += !gmds_token_is(keyword, "$Comments");
  return skip_section(gmsh, keyword);
}

static gmds_status read_sections(gmds_gmsh *gmsh)
{
  gmds_token keyword;
  GMDS_TRY(read_format(gmsh));
  while (gmds_text_next(gmsh->text, &keyword))
    GMDS_TRY(read_section(gmsh, keyword));
  return gmsh->has_nodes ? GMDS_OK : gmds_text_expected(gmsh->text, "$Nodes", keyword);
}

gmds_status gmds_read_gmsh(gmds_text *text, gmds_stage *stage)
{
  gmds_gmsh gmsh = {.text = text, .stage = stage};
  gmds_ids_init(&gmsh.physical, stage->soup.memory);
  gmds_status status = read_sections(&gmsh);
  gmds_tags_clear(&gmsh, &gmsh.nodes);
  gmds_tags_clear(&gmsh, &gmsh.elements);
  gmds_tags_clear(&gmsh, &gmsh.entities);
  gmds_ids_clear(&gmsh.physical);
  return status;
}
