/* Entities, nodes and elements of MSH files, versions 2.2 and 4.1. An element's tags become the attributes "physical"
 * and "geometrical" of its cell: in version 4.1 by way of its entity, whose first physical group it is. */
#include "gmsh.h"

/* What Gmsh calls the elements that are known and not read. X(number, text) */
#define CURVED_LIST(X)                 \
  X(8, "second-order edges")           \
  X(9, "second-order triangles")       \
  X(10, "second-order quadrilaterals") \
  X(11, "second-order tetrahedra")     \
  X(12, "second-order hexahedra")      \
  X(13, "second-order prisms")         \
  X(14, "second-order pyramids")       \
  X(16, "second-order quadrilaterals") \
  X(17, "second-order hexahedra")      \
  X(18, "second-order prisms")         \
  X(19, "second-order pyramids")       \
  X(21, "third-order triangles")       \
  X(26, "third-order edges")           \
  X(29, "third-order tetrahedra")

/* An element: its tags, and its nodes, which stand in stage->corners. */
typedef struct element {
  int type; /* Gmsh's number */
  int physical, geometrical;
} element;

static gmds_status find_type(const gmds_gmsh *gmsh, int number, gmds_cell_type *type)
{
#define ROW(number, type) {number, type},
  static const struct {
    int number;
    gmds_cell_type type;
  } rows[] = {GMDS_GMSH_TYPE_LIST(ROW)};
#undef ROW
#define ROW(number, text) {number, text},
  static const struct {
    int number;
    const char *text;
  } curved[] = {CURVED_LIST(ROW)};
#undef ROW
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (rows[i].number == number) {
      *type = rows[i].type;
      return GMDS_OK;
    }
  for (size_t i = 0; i < sizeof curved / sizeof *curved; i++)
    if (curved[i].number == number)
      return gmds_text_fail(gmsh->text, GMDS_ERR_UNSUPPORTED, -1, "%s (Gmsh's type %d): only the first order is read",
                            curved[i].text, number);
  return gmds_text_fail(gmsh->text, GMDS_ERR_UNSUPPORTED, -1, "elements of Gmsh's type %d are not read", number);
}

/* `numPhysicalTags tag ...`: the first one, or 0. */
static gmds_status read_groups(gmds_gmsh *gmsh, int *first)
{
  uint64_t n = 0;
  *first = 0;
  GMDS_TRY(gmds_gmsh_size(gmsh, "a number of physical groups", &n));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 1, 0, 0, "physical groups"));
  for (uint64_t k = 0; k < n; k++) {
    int group = 0;
    GMDS_TRY(gmds_gmsh_int(gmsh, "a physical group", &group));
    *first = k ? *first : group;
  }
  gmsh->stage->soup.unread += n > 1;
  return GMDS_OK;
}

static uint64_t entity_tag(int dim, int tag)
{
  return (uint64_t)(uint32_t)dim << 32 | (uint32_t)tag;
}

/* `tag` and a point or a box, its groups, and but for points what bounds it. */
static gmds_status read_entity(gmds_gmsh *gmsh, int dim)
{
  int tag = 0, physical = 0, ignored;
  double x;
  GMDS_TRY(gmds_gmsh_int(gmsh, "the number of an entity", &tag));
  for (int k = 0; k < (dim ? 6 : 3); k++)
    GMDS_TRY(gmds_gmsh_value(gmsh, &x));
  GMDS_TRY(read_groups(gmsh, &physical));
  GMDS_TRY(gmds_tags_push(gmsh, &gmsh->entities, entity_tag(dim, tag)));
  if (gmds_ids_push(&gmsh->physical, (gmds_id)(uint32_t)physical) != GMDS_OK)
    return gmds_text_failed(gmsh->text, GMDS_ERR_MEMORY);
  uint64_t n = 0;
  if (dim)
    GMDS_TRY(gmds_gmsh_size(gmsh, "a number of bounding entities", &n));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 1, 0, 0, "bounding entities"));
  for (uint64_t k = 0; k < n; k++)
    GMDS_TRY(gmds_gmsh_int(gmsh, "a bounding entity", &ignored));
  return GMDS_OK;
}

gmds_status gmds_gmsh_read_entities(gmds_gmsh *gmsh)
{
  uint64_t n[4] = {0};
  if (gmsh->version < 40)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "$Entities in a file of version 2");
  GMDS_TRY(gmds_gmsh_start_words(gmsh));
  for (int dim = 0; dim < 4; dim++)
    GMDS_TRY(gmds_gmsh_size(gmsh, "a number of entities", &n[dim]));
  for (int dim = 0; dim < 4; dim++) {
    GMDS_TRY(gmds_gmsh_bound(gmsh, n[dim], 1, 1, 3, "entities"));
    for (uint64_t k = 0; k < n[dim]; k++)
      GMDS_TRY(read_entity(gmsh, dim));
  }
  GMDS_TRY(gmds_tags_sort(gmsh, &gmsh->entities, 1, "entities"));
  return gmds_text_word(gmsh->text, "$EndEntities");
}

static gmds_status read_point(gmds_gmsh *gmsh, int more)
{
  double x[3], ignored;
  for (int k = 0; k < 3; k++)
    GMDS_TRY(gmds_gmsh_coordinate(gmsh, gmsh->stage->soup.n_points, &x[k]));
  for (int k = 0; k < more; k++)
    GMDS_TRY(gmds_gmsh_value(gmsh, &ignored));
  return gmds_stage_point(gmsh->stage, gmsh->text, x);
}

/* Version 2: a number of nodes as text, then `number x y z` each. */
static gmds_status read_nodes_2(gmds_gmsh *gmsh)
{
  uint64_t n = 0;
  GMDS_TRY(gmds_text_next_whole(gmsh->text, "a number of nodes", &n));
  GMDS_TRY(gmds_gmsh_start_words(gmsh));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 1, 0, 3, "nodes"));
  GMDS_TRY(gmds_stage_reserve(gmsh->stage, gmsh->text, (size_t)n, 0, 0));
  for (uint64_t k = 0; k < n; k++) {
    int tag = 0;
    GMDS_TRY(gmds_gmsh_int(gmsh, "the number of a node", &tag));
    GMDS_TRY(gmds_tags_push(gmsh, &gmsh->nodes, (uint64_t)(int64_t)tag));
    GMDS_TRY(read_point(gmsh, 0));
  }
  return GMDS_OK;
}

/* Version 4: blocks of nodes, their numbers first, then their coordinates with parameters behind them. */
static gmds_status read_node_block(gmds_gmsh *gmsh, uint64_t *left)
{
  int dim = 0, tag = 0, parametric = 0;
  uint64_t n = 0, node = 0;
  GMDS_TRY(gmds_gmsh_int(gmsh, "the dimension of an entity", &dim));
  GMDS_TRY(gmds_gmsh_int(gmsh, "the number of an entity", &tag));
  GMDS_TRY(gmds_gmsh_int(gmsh, "0 or 1 for parameters", &parametric));
  GMDS_TRY(gmds_gmsh_size(gmsh, "a number of nodes", &n));
  if (dim < 0 || dim > 3)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "expected a dimension from 0 to 3, found %d", dim);
  if (n > *left)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "a block of %llu nodes, but only %llu are left",
                          (unsigned long long)n, (unsigned long long)*left);
  *left -= n;
  for (uint64_t k = 0; k < n; k++) {
    GMDS_TRY(gmds_gmsh_size(gmsh, "the number of a node", &node));
    GMDS_TRY(gmds_tags_push(gmsh, &gmsh->nodes, node));
  }
  for (uint64_t k = 0; k < n; k++)
    GMDS_TRY(read_point(gmsh, parametric ? dim : 0));
  return GMDS_OK;
}

/* `blocks n smallest largest` of nodes or elements. */
static gmds_status read_counts(gmds_gmsh *gmsh, const char *what, uint64_t *blocks, uint64_t *n)
{
  uint64_t ignored;
  GMDS_TRY(gmds_gmsh_start_words(gmsh));
  GMDS_TRY(gmds_gmsh_size(gmsh, "a number of blocks", blocks));
  GMDS_TRY(gmds_gmsh_size(gmsh, what, n));
  GMDS_TRY(gmds_gmsh_size(gmsh, "the smallest number", &ignored));
  return gmds_gmsh_size(gmsh, "the largest number", &ignored);
}

static gmds_status read_nodes_4(gmds_gmsh *gmsh)
{
  uint64_t blocks = 0, n = 0;
  GMDS_TRY(read_counts(gmsh, "a number of nodes", &blocks, &n));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 0, 1, 3, "nodes"));
  GMDS_TRY(gmds_gmsh_bound(gmsh, blocks, 3, 1, 0, "blocks"));
  GMDS_TRY(gmds_stage_reserve(gmsh->stage, gmsh->text, (size_t)n, 0, 0));
  for (uint64_t k = 0; k < blocks; k++)
    GMDS_TRY(read_node_block(gmsh, &n));
  if (n)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "%llu nodes are missing", (unsigned long long)n);
  return GMDS_OK;
}

gmds_status gmds_gmsh_read_nodes(gmds_gmsh *gmsh)
{
  if (gmsh->has_nodes)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "$Nodes are listed a second time");
  gmsh->has_nodes = 1;
  GMDS_TRY((gmsh->version < 40 ? read_nodes_2 : read_nodes_4)(gmsh));
  GMDS_TRY(gmds_tags_sort(gmsh, &gmsh->nodes, 1, "nodes"));
  return gmds_text_word(gmsh->text, "$EndNodes");
}

/* The nodes of an element, ints or sizes, and the cell that they make. */
static gmds_status read_element(gmds_gmsh *gmsh, uint64_t tag, gmds_cell_type type, const element *e)
{
  gmds_id corners[8];
  size_t n = (size_t)gmds_cell_type_points(type), before = gmsh->stage->soup.n_cells;
  for (size_t k = 0; k < n; k++) {
    int number = 0;
    uint64_t node = 0;
    size_t found;
    if (gmsh->version < 40) {
      GMDS_TRY(gmds_gmsh_int(gmsh, "the number of a node", &number));
      node = (uint64_t)(int64_t)number;
    } else {
      GMDS_TRY(gmds_gmsh_size(gmsh, "the number of a node", &node));
    }
    size_t at = gmds_tags_find(&gmsh->nodes, node, &found);
    if (!found)
      return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "no node has the number %lld", (long long)node);
    corners[k] = (gmds_id)gmds_tags_item(&gmsh->nodes, at);
  }
  GMDS_TRY(gmds_tags_push(gmsh, &gmsh->elements, tag));
  GMDS_TRY(gmds_stage_mark(gmsh->stage, gmsh->text));
  GMDS_TRY(gmds_stage_cell(gmsh->stage, gmsh->text, type, n, corners));
  if (gmsh->stage->soup.n_cells == before)
    return GMDS_OK;
  GMDS_TRY(gmds_stage_reference(gmsh->stage, gmsh->text, GMDS_OF_CELLS, "physical", before, e->physical));
  return gmds_stage_reference(gmsh->stage, gmsh->text, GMDS_OF_CELLS, "geometrical", before, e->geometrical);
}

/* The tags of an element of version 2: physical, geometrical, then partitions. */
static gmds_status read_tags(gmds_gmsh *gmsh, int n, element *e)
{
  GMDS_TRY(gmds_gmsh_bound(gmsh, n < 0 ? UINT64_MAX : (uint64_t)n, 1, 0, 0, "tags"));
  for (int k = 0; k < n; k++) {
    int x = 0;
    GMDS_TRY(gmds_gmsh_int(gmsh, "a tag", &x));
    if (k == 0)
      e->physical = x;
    if (k == 1)
      e->geometrical = x;
  }
  return GMDS_OK;
}

/* Text has `number type tags` before each element; words have `type elements tags` before several, `number` before
 * each. */
static gmds_status read_elements_2(gmds_gmsh *gmsh)
{
  uint64_t n = 0;
  int tag = 0, tags = 0, follow = 0;
  element e = {0};
  GMDS_TRY(gmds_text_next_whole(gmsh->text, "a number of elements", &n));
  GMDS_TRY(gmds_gmsh_start_words(gmsh));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 2, 0, 0, "elements"));
  GMDS_TRY(gmds_stage_reserve(gmsh->stage, gmsh->text, 0, (size_t)n, 0));
  for (uint64_t k = 0; k < n; k++) {
    gmds_cell_type type = GMDS_VERTEX;
    if (!gmsh->binary)
      GMDS_TRY(gmds_gmsh_int(gmsh, "the number of an element", &tag));
    if (!follow) {
      GMDS_TRY(gmds_gmsh_int(gmsh, "a type of elements", &e.type));
      follow = 1;
      if (gmsh->binary)
        GMDS_TRY(gmds_gmsh_int(gmsh, "a number of elements", &follow));
      GMDS_TRY(gmds_gmsh_int(gmsh, "a number of tags", &tags));
      if (follow < 1)
        return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "expected one element or more, found %d", follow);
    }
    if (gmsh->binary)
      GMDS_TRY(gmds_gmsh_int(gmsh, "the number of an element", &tag));
    follow--;
    GMDS_TRY(find_type(gmsh, e.type, &type));
    e.physical = e.geometrical = 0;
    GMDS_TRY(read_tags(gmsh, tags, &e));
    GMDS_TRY(read_element(gmsh, (uint64_t)(int64_t)tag, type, &e));
  }
  if (follow)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "a block of %d elements more than there are", follow);
  return GMDS_OK;
}

static gmds_status read_element_block(gmds_gmsh *gmsh, uint64_t *left)
{
  int dim = 0;
  uint64_t n = 0, tag = 0;
  size_t found;
  element e = {0};
  gmds_cell_type type = GMDS_VERTEX;
  GMDS_TRY(gmds_gmsh_int(gmsh, "the dimension of an entity", &dim));
  GMDS_TRY(gmds_gmsh_int(gmsh, "the number of an entity", &e.geometrical));
  GMDS_TRY(gmds_gmsh_int(gmsh, "a type of elements", &e.type));
  GMDS_TRY(gmds_gmsh_size(gmsh, "a number of elements", &n));
  if (n > *left)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "a block of %llu elements, but only %llu are left",
                          (unsigned long long)n, (unsigned long long)*left);
  *left -= n;
  size_t at = gmds_tags_find(&gmsh->entities, entity_tag(dim, e.geometrical), &found);
  if (found)
    e.physical = (int)(int32_t)(uint32_t)gmsh->physical.data[gmds_tags_item(&gmsh->entities, at)];
  if (n)
    GMDS_TRY(find_type(gmsh, e.type, &type));
  for (uint64_t k = 0; k < n; k++) {
    GMDS_TRY(gmds_gmsh_size(gmsh, "the number of an element", &tag));
    GMDS_TRY(read_element(gmsh, tag, type, &e));
  }
  return GMDS_OK;
}

static gmds_status read_elements_4(gmds_gmsh *gmsh)
{
  uint64_t blocks = 0, n = 0;
  GMDS_TRY(read_counts(gmsh, "a number of elements", &blocks, &n));
  GMDS_TRY(gmds_gmsh_bound(gmsh, n, 0, 2, 0, "elements"));
  GMDS_TRY(gmds_gmsh_bound(gmsh, blocks, 3, 1, 0, "blocks"));
  GMDS_TRY(gmds_stage_reserve(gmsh->stage, gmsh->text, 0, (size_t)n, 0));
  for (uint64_t k = 0; k < blocks; k++)
    GMDS_TRY(read_element_block(gmsh, &n));
  if (n)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "%llu elements are missing", (unsigned long long)n);
  return GMDS_OK;
}

/* Version 2 may list an element once for each of its groups. */
enum { MOST_OF_ONE_NUMBER = 64 };

gmds_status gmds_gmsh_read_elements(gmds_gmsh *gmsh)
{
  if (gmsh->has_elements)
    return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "$Elements are listed a second time");
  gmsh->has_elements = 1;
  GMDS_TRY((gmsh->version < 40 ? read_elements_2 : read_elements_4)(gmsh));
  GMDS_TRY(gmds_tags_sort(gmsh, &gmsh->elements, MOST_OF_ONE_NUMBER, "elements"));
  return gmds_text_word(gmsh->text, "$EndElements");
}
