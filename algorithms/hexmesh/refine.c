/* The octree of a surface, level by level. A level is the cells that are to be refined and the list of their
 * triangles; children are entered in the next level, or are leaves. */
#include <gmds/lattice.h>

typedef struct node {
  uint32_t at[3];
  int32_t winding;
  size_t begin, n; /* its triangles in the list of its level */
} node;

typedef struct level {
  gmds_ids triangles;
  node *nodes;
  size_t n, capacity;
} level;

typedef struct refining {
  const gmds_lattice *lattice;
  unsigned depth;
  gmds_lattice_decision *refine;
  void *user;
  gmds_lattice_leaves *leaves;
} refining;

void gmds_lattice_leaves_init(gmds_lattice_leaves *leaves, gmds_memory *memory)
{
  *leaves = (gmds_lattice_leaves){.memory = memory};
}

void gmds_lattice_leaves_clear(gmds_lattice_leaves *leaves)
{
  gmds_release(leaves->memory, leaves->leaf, leaves->capacity, sizeof *leaves->leaf);
  gmds_lattice_leaves_init(leaves, leaves->memory);
}

static gmds_status add_leaf(gmds_lattice_leaves *to, gmds_lattice_cell cell, gmds_lattice_state state, int32_t winding)
{
  if (to->n == to->capacity) {
    const size_t grown = gmds_grown(to->capacity, to->n + 1);
    void *leaf = to->leaf;
    if (!gmds_resize(to->memory, &leaf, to->capacity, grown, sizeof *to->leaf))
      return GMDS_ERR_MEMORY;
    to->leaf = leaf;
    to->capacity = grown;
  }
  to->leaf[to->n++] = (gmds_lattice_leaf){{cell.at[0], cell.at[1], cell.at[2]}, (uint8_t)cell.level, (uint8_t)state};
  if (state != GMDS_LATTICE_CUT) {
    const int first = !(to->count[GMDS_LATTICE_OUTSIDE] + to->count[GMDS_LATTICE_INSIDE]);
    to->lowest = first || winding < to->lowest ? winding : to->lowest;
    to->highest = first || winding > to->highest ? winding : to->highest;
  }
  to->count[state]++;
  return GMDS_OK;
}

static gmds_status add_node(gmds_memory *memory, level *to, node which)
{
  if (to->n == to->capacity) {
    const size_t grown = gmds_grown(to->capacity, to->n + 1);
    void *nodes = to->nodes;
    if (!gmds_resize(memory, &nodes, to->capacity, grown, sizeof *to->nodes))
      return GMDS_ERR_MEMORY;
    to->nodes = nodes;
    to->capacity = grown;
  }
  to->nodes[to->n++] = which;
  return GMDS_OK;
}

/* A cell that has been found, with its triangles in the list of its level: a leaf, or to be refined. */
static gmds_status enter(const refining *r, level *to, gmds_lattice_cell cell, int cut, int32_t winding, size_t begin,
                         size_t n)
{
  const gmds_lattice_state state = cut ? GMDS_LATTICE_CUT : gmds_lattice_side(winding);
  if (cell.level < r->depth && (r->refine ? r->refine(r->user, cell, state) != 0 : cut))
    return add_node(r->leaves->memory, to, (node){{cell.at[0], cell.at[1], cell.at[2]}, winding, begin, n});
  return add_leaf(r->leaves, cell, state, winding);
}

/* The base cells. The list of their triangles becomes that of the level. */
static gmds_status enter_roots(const refining *r, level *to)
{
  const gmds_lattice *l = r->lattice;
  const uint64_t all = (uint64_t)l->base[0] * l->base[1] * l->base[2];
  gmds_lattice_roots roots;
  if (all > SIZE_MAX)
    return GMDS_ERR_MEMORY;
  gmds_lattice_roots_init(&roots, r->leaves->memory);
  gmds_status status = gmds_lattice_find_roots(l, 0, (size_t)all, &roots);
  for (size_t c = 0; status == GMDS_OK && c < all; c++) {
    const gmds_id *row;
    const size_t n = gmds_csr_row(&roots.triangles, c, &row);
    status = enter(r, to, gmds_lattice_base(l, c), n != 0, roots.winding[c], roots.triangles.begin[c], n);
  }
  to->triangles.data = roots.triangles.data;
  to->triangles.n = to->triangles.capacity = roots.triangles.capacity;
  roots.triangles.data = NULL;
  roots.triangles.capacity = 0;
  gmds_lattice_roots_clear(&roots);
  return status;
}

/* The children of one cell. Triangles are kept where a child is cut and may be refined. */
static gmds_status refine_node(const refining *r, const level *from, const node *which, unsigned depth, level *to)
{
  const gmds_lattice_cell cell = {{which->at[0], which->at[1], which->at[2]}, depth};
  gmds_lattice_octants o;
  const gmds_id *triangles = which->n ? from->triangles.data + which->begin : NULL;
  GMDS_TRY(gmds_lattice_split(r->lattice, cell, which->winding, which->n, triangles, depth + 1 < r->depth ? 0xff : 0,
                              &to->triangles, &o));
  for (unsigned c = 0; c < 8; c++)
    GMDS_TRY(enter(r, to, gmds_lattice_child(cell, c), o.cut >> c & 1, o.winding[c], o.begin[c],
                   o.begin[c + 1] - o.begin[c]));
  return GMDS_OK;
}

static void clear_level(gmds_memory *memory, level *which)
{
  gmds_release(memory, which->nodes, which->capacity, sizeof *which->nodes);
  gmds_ids_clear(&which->triangles);
}

gmds_status gmds_lattice_refine(const gmds_lattice *lattice, unsigned depth, gmds_lattice_decision *refine, void *user,
                                gmds_lattice_leaves *leaves)
{
  if (depth >= lattice->bits)
    return GMDS_ERR_ARGUMENT;
  gmds_memory *memory = leaves->memory;
  const refining r = {lattice, depth, refine, user, leaves};
  level levels[2] = {{.triangles.memory = memory}, {.triangles.memory = memory}};
  gmds_status status = enter_roots(&r, &levels[0]);
  for (unsigned d = 0; status == GMDS_OK && d < depth; d++) {
    level *from = &levels[d % 2], *to = &levels[1 - d % 2];
    to->n = to->triangles.n = 0;
    for (size_t k = 0; status == GMDS_OK && k < from->n; k++)
      status = refine_node(&r, from, &from->nodes[k], d, to);
  }
  clear_level(memory, &levels[0]);
  clear_level(memory, &levels[1]);
  if (status != GMDS_OK)
    gmds_lattice_leaves_clear(leaves);
  return status;
}
