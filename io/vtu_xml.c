/* The XML of VTU: which pieces and arrays there are and where their numbers stand. The numbers themselves are not taken
 * from the XML parser but from the file. What is appended is no XML where it is raw, so parsing ends before it. */
#include "vtu.h"
#include <string.h>
#if GMDS_HAVE_EXPAT
#  include <expat.h>

/* X(name, kind, bytes) */
#  define TYPE_LIST(X)                \
    X("Int8", GMDS_VTK_SIGNED, 1)     \
    X("Int16", GMDS_VTK_SIGNED, 2)    \
    X("Int32", GMDS_VTK_SIGNED, 4)    \
    X("Int64", GMDS_VTK_SIGNED, 8)    \
    X("UInt8", GMDS_VTK_UNSIGNED, 1)  \
    X("UInt16", GMDS_VTK_UNSIGNED, 2) \
    X("UInt32", GMDS_VTK_UNSIGNED, 4) \
    X("UInt64", GMDS_VTK_UNSIGNED, 8) \
    X("Float32", GMDS_VTK_REAL, 4)    \
    X("Float64", GMDS_VTK_REAL, 8)

/* The parser with where it is in the tree: elements are told by their depth and the names of those around them. */
typedef struct tree {
  gmds_vtu *vtu;
  XML_Parser parser;
  gmds_status status;
  int depth; /* of elements that are open: VTKFile is at 0 */
  gmds_vtu_section section;
  int in_piece;
  gmds_vtu_array *array; /* whose content is being read */
} tree;

static void stop(tree *t, gmds_status status)
{
  t->status = status;
  XML_StopParser(t->parser, XML_FALSE);
}

/* The value of an attribute of the element, or NULL. */
static const char *value_of(const char **attributes, const char *name)
{
  for (; *attributes; attributes += 2)
    if (strcmp(attributes[0], name) == 0)
      return attributes[1];
  return NULL;
}

static gmds_token token_of(const char *text)
{
  return (gmds_token){text ? text : "", text ? strlen(text) : 0};
}

static const char *here(const tree *t)
{
  return t->vtu->text->begin + XML_GetCurrentByteIndex(t->parser);
}

static const char *behind(const tree *t)
{
  return here(t) + XML_GetCurrentByteCount(t->parser);
}

/* Room for one more object at the end of a list. */
static gmds_status grow(gmds_vtu *vtu, void **list, size_t n, size_t more, size_t *capacity, size_t size)
{
  size_t wanted = gmds_grown(*capacity, n + more);
  if (n + more <= *capacity)
    return GMDS_OK;
  if (!gmds_resize(vtu->stage->soup.memory, list, *capacity, wanted, size))
    return gmds_text_failed(vtu->text, GMDS_ERR_MEMORY);
  *capacity = wanted;
  return GMDS_OK;
}

/* `<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt64" compressor="...">` */
static gmds_status open_file(gmds_vtu *vtu, const char *name, const char **attributes)
{
  const gmds_text *text = vtu->text;
  gmds_token type = token_of(value_of(attributes, "type")), order = token_of(value_of(attributes, "byte_order"));
  const char *header = value_of(attributes, "header_type"), *compressor = value_of(attributes, "compressor");
  if (strcmp(name, "VTKFile") != 0)
    return gmds_text_expected(text, "VTKFile", token_of(name));
  if (!gmds_token_is(type, "UnstructuredGrid"))
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "type %.40s: only UnstructuredGrid is read", type.at);
  vtu->little = gmds_token_is(order, "LittleEndian");
  if (!vtu->little && !gmds_token_is(order, "BigEndian") && order.n)
    return gmds_text_expected(text, "LittleEndian or BigEndian", order);
  vtu->header_bytes = header && strcmp(header, "UInt64") == 0 ? 8 : 4;
  if (header && vtu->header_bytes == 4 && strcmp(header, "UInt32") != 0)
    return gmds_text_expected(text, "UInt32 or UInt64", token_of(header));
  vtu->compressed = compressor && *compressor;
  if (vtu->compressed && strcmp(compressor, "vtkZLibDataCompressor") != 0)
    return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "%.60s: only vtkZLibDataCompressor is read", compressor);
  return GMDS_OK;
}

static gmds_status open_piece(gmds_vtu *vtu, const char **attributes)
{
  void *list = vtu->pieces;
  gmds_vtu_piece piece = {.first = vtu->n_arrays, .line = vtu->text->line};
  gmds_status status = grow(vtu, &list, vtu->n_pieces, 1, &vtu->piece_capacity, sizeof *vtu->pieces);
  vtu->pieces = list;
  GMDS_TRY(status);
  GMDS_TRY(
      gmds_text_whole(vtu->text, token_of(value_of(attributes, "NumberOfPoints")), "NumberOfPoints", &piece.points));
  GMDS_TRY(gmds_text_whole(vtu->text, token_of(value_of(attributes, "NumberOfCells")), "NumberOfCells", &piece.cells));
  vtu->pieces[vtu->n_pieces++] = piece;
  return GMDS_OK;
}

static gmds_status read_type(gmds_vtu *vtu, const char *name, gmds_vtk_type *type)
{
#  define ROW(name, kind, bytes) {name, kind, bytes},
  static const gmds_vtk_type rows[] = {TYPE_LIST(ROW)};
#  undef ROW
  for (size_t i = 0; name && i < sizeof rows / sizeof *rows; i++)
    if (strcmp(name, rows[i].name) == 0) {
      *type = rows[i];
      return GMDS_OK;
    }
  return gmds_text_expected(vtu->text, "a type of numbers", token_of(name));
}

static gmds_status read_format(gmds_vtu *vtu, const char **attributes, gmds_vtu_array *a)
{
  gmds_token format = token_of(value_of(attributes, "format"));
  a->format = GMDS_VTU_ASCII;
  if (gmds_token_is(format, "binary"))
    a->format = GMDS_VTU_BINARY;
  else if (gmds_token_is(format, "appended"))
    a->format = GMDS_VTU_APPENDED;
  else if (format.n && !gmds_token_is(format, "ascii"))
    return gmds_text_expected(vtu->text, "ascii, binary or appended", format);
  if (a->format == GMDS_VTU_APPENDED)
    GMDS_TRY(gmds_text_whole(vtu->text, token_of(value_of(attributes, "offset")), "an offset", &a->offset));
  return GMDS_OK;
}

static gmds_status open_array(tree *t, const char **attributes)
{
  gmds_vtu *vtu = t->vtu;
  void *list = vtu->arrays, *names = vtu->names;
  gmds_token name = token_of(value_of(attributes, "Name"));
  const char *components = value_of(attributes, "NumberOfComponents");
  gmds_vtu_array a = {.piece = vtu->n_pieces - 1, .section = t->section, .components = 1, .line = vtu->text->line};
  gmds_status status = grow(vtu, &list, vtu->n_arrays, 1, &vtu->array_capacity, sizeof *vtu->arrays);
  vtu->arrays = list;
  GMDS_TRY(status);
  status = grow(vtu, &names, vtu->n_names, name.n + 1, &vtu->name_capacity, 1);
  vtu->names = names;
  GMDS_TRY(status);
  a.name = vtu->n_names;
  a.name_bytes = name.n;
  memcpy(vtu->names + vtu->n_names, name.at, name.n + 1);
  vtu->n_names += name.n + 1;
  GMDS_TRY(read_type(vtu, value_of(attributes, "type"), &a.type));
  if (components)
    GMDS_TRY(gmds_text_whole(vtu->text, token_of(components), "a number of components", &a.components));
  GMDS_TRY(read_format(vtu, attributes, &a));
  a.begin = behind(t);
  t->array = &vtu->arrays[vtu->n_arrays];
  vtu->arrays[vtu->n_arrays++] = a;
  return GMDS_OK;
}

static gmds_vtu_section section_of(const char *name)
{
  static const char *const names[] = {"Points", "Cells", "PointData", "CellData"};
  int k = 0;
  while (k < GMDS_VTU_OTHER && strcmp(name, names[k]) != 0)
    k++;
  return (gmds_vtu_section)k;
}

/* VTKFile > UnstructuredGrid > Piece > Points, Cells, PointData, CellData > DataArray, and AppendedData beside the
 * grid. */
static gmds_status open_element(tree *t, const char *name, const char **attributes)
{
  gmds_vtu *vtu = t->vtu;
  if (t->depth == 0)
    return open_file(vtu, name, attributes);
  if (t->depth == 1 && strcmp(name, "AppendedData") == 0) {
    gmds_token encoding = token_of(value_of(attributes, "encoding"));
    vtu->appended_base64 = gmds_token_is(encoding, "base64");
    return vtu->appended_base64 || gmds_token_is(encoding, "raw")
               ? GMDS_OK
               : gmds_text_expected(vtu->text, "raw or base64", encoding);
  }
  if (t->depth == 2) {
    t->in_piece = strcmp(name, "Piece") == 0;
    return t->in_piece ? open_piece(vtu, attributes) : GMDS_OK;
  }
  if (t->depth == 3 && t->in_piece)
    t->section = section_of(name);
  int listed = strcmp(name, "DataArray") == 0 || strcmp(name, "Array") == 0;
  if (t->depth == 4 && t->in_piece && t->section != GMDS_VTU_OTHER && strcmp(name, "DataArray") == 0)
    return open_array(t, attributes);
  vtu->stage->soup.unread += (size_t)listed;
  return GMDS_OK;
}

static int is_blank(const char *from, const char *to)
{
  while (from < to && (*from == ' ' || *from == '\t' || *from == '\r' || *from == '\n'))
    from++;
  return from == to;
}

static void XMLCALL on_start(void *user, const char *name, const char **attributes)
{
  tree *t = user;
  t->vtu->text->line = (long long)XML_GetCurrentLineNumber(t->parser);
  if (t->array && !t->array->end && !is_blank(t->array->begin, here(t)))
    t->array->end = here(t); /* information keys may stand before the numbers or behind them */
  gmds_status status = open_element(t, name, attributes);
  t->depth++;
  if (status != GMDS_OK)
    stop(t, status);
}

static void XMLCALL on_end(void *user, const char *name)
{
  tree *t = user;
  (void)name;
  t->depth--;
  if (!t->array || t->array->end) {
    if (t->depth <= 4)
      t->array = NULL;
    return;
  }
  if (t->depth > 4) { /* of something in the array */
    t->array->begin = behind(t);
    return;
  }
  t->array->end = here(t) < t->array->begin ? t->array->begin : here(t);
  t->array = NULL;
}

static const char *find(const char *at, const char *end, const char *word)
{
  size_t n = strlen(word);
  for (; (size_t)(end - at) >= n; at++) {
    at = memchr(at, *word, (size_t)(end - at) - n + 1);
    if (!at)
      return NULL;
    if (!memcmp(at, word, n))
      return at;
  }
  return NULL;
}

/* Where the XML ends: behind the tag of what is appended, or with the file. */
static const char *end_of_xml(gmds_vtu *vtu)
{
  const gmds_text *text = vtu->text;
  const char *tag = find(text->begin, text->end, "<AppendedData");
  const char *last = tag ? memchr(tag, '>', (size_t)(text->end - tag)) : NULL;
  const char *underscore = last ? memchr(last, '_', (size_t)(text->end - last)) : NULL;
  if (!underscore)
    return text->end;
  vtu->appended = underscore + 1;
  vtu->appended_end = text->end;
  return last + 1;
}

static gmds_status parse(tree *t)
{
  gmds_text *text = t->vtu->text;
  const char *end = end_of_xml(t->vtu);
  enum { CHUNK = 1 << 28 };
  for (const char *at = text->begin; at < end || at == text->begin;) {
    size_t n = end - at < CHUNK ? (size_t)(end - at) : CHUNK;
    int last = at + n == end;
    enum XML_Status result = XML_Parse(t->parser, at, (int)n, last && end == text->end);
    if (t->status != GMDS_OK)
      return t->status;
    if (result != XML_STATUS_OK) {
      enum XML_Error code = XML_GetErrorCode(t->parser);
      text->line = (long long)XML_GetCurrentLineNumber(t->parser);
      if (code == XML_ERROR_NO_MEMORY)
        return gmds_text_failed(text, GMDS_ERR_MEMORY);
      return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "this is not XML: %s", XML_ErrorString(code));
    }
    at += n;
    if (last)
      break;
  }
  if (end == text->end || t->depth == 2) /* every array has its end */
    return GMDS_OK;
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "AppendedData is not behind the grid");
}

gmds_status gmds_vtu_parse(gmds_vtu *vtu)
{
  tree t = {.vtu = vtu, .parser = XML_ParserCreate(NULL), .section = GMDS_VTU_OTHER};
  if (!t.parser)
    return gmds_text_failed(vtu->text, GMDS_ERR_MEMORY);
  XML_SetUserData(t.parser, &t);
  XML_SetElementHandler(t.parser, on_start, on_end);
  gmds_status status = parse(&t);
  XML_ParserFree(t.parser);
  return status;
}
#else
gmds_status gmds_vtu_parse(gmds_vtu *vtu)
{
  return gmds_text_fail(vtu->text, GMDS_ERR_UNSUPPORTED, -1,
                        "this library was built without Expat, which reading VTU needs");
}
#endif /* GMDS_HAVE_EXPAT */
