/* The structure of a mesh of volumes: one column for each stored relation, nothing for the others; its life and its
 * growth.
 *
 * Lists of the stored relations, by the way they are stored:
 *   set       rows of a pool, in no order      ordered   rows of a pool, an entry for each node, edge or face of the
 *             cell
 *   pairs     two inline as a rule (F2R)       inline    columns of fixed arity, where all cells have the same type
 * GMDS__KIND_i_j: 1 rows, 2 pairs, 3 inline. */
#define GMDS__EACH_SET(X) \
  GMDS__IF_0_0(X(0, 0))   \
  GMDS__IF_0_1(X(0, 1))   \
  GMDS__IF_0_2(X(0, 2))   \
  GMDS__IF_0_3(X(0, 3)) GMDS__IF_1_1(X(1, 1)) GMDS__IF_1_2(X(1, 2)) GMDS__IF_1_3(X(1, 3)) GMDS__IF_2_2(X(2, 2))
#define GMDS__EACH_PAIRS(X) GMDS__IF_2_3(X(2, 3))
#define GMDS__EACH_OF_FACES(X) GMDS__IF_2_0(X(2, 0)) GMDS__IF_2_1(X(2, 1))
#define GMDS__EACH_OF_REGIONS(X) GMDS__IF_3_0(X(3, 0)) GMDS__IF_3_1(X(3, 1)) GMDS__IF_3_2(X(3, 2)) GMDS__IF_3_3(X(3, 3))
#if GMDS__INLINE
#  define GMDS__INLINE_FACES(X) GMDS__EACH_OF_FACES(X)
#  define GMDS__ORDERED_FACES(X)
#  define GMDS__KIND_2_0 3
#else
#  define GMDS__INLINE_FACES(X)
#  define GMDS__ORDERED_FACES(X) GMDS__EACH_OF_FACES(X)
#  define GMDS__KIND_2_0 1
#endif
#if GMDS__CORNERS
#  define GMDS__TYPED 0
#  define GMDS__INLINE_REGIONS(X) GMDS__EACH_OF_REGIONS(X)
#  define GMDS__ORDERED_REGIONS(X)
#  define GMDS__KIND_3_0 3
#else
#  define GMDS__TYPED 1 /* a byte for the type of each region */
#  define GMDS__INLINE_REGIONS(X)
#  define GMDS__ORDERED_REGIONS(X) GMDS__EACH_OF_REGIONS(X)
#  define GMDS__KIND_3_0 1
#endif
#define GMDS__EACH_INLINE(X) GMDS__IF_1_0(X(1, 0)) GMDS__INLINE_FACES(X) GMDS__INLINE_REGIONS(X)
#define GMDS__EACH_ORDERED(X) GMDS__ORDERED_FACES(X) GMDS__ORDERED_REGIONS(X)
#define GMDS__EACH_POOLED(X) GMDS__EACH_SET(X) GMDS__EACH_ORDERED(X)
#define GMDS__KIND_0_0 1
#define GMDS__KIND_0_1 1
#define GMDS__KIND_0_2 1
#define GMDS__KIND_0_3 1
#define GMDS__KIND_1_0 3
#define GMDS__KIND_1_1 1
#define GMDS__KIND_1_2 1
#define GMDS__KIND_1_3 1
#define GMDS__KIND_2_1 GMDS__KIND_2_0
#define GMDS__KIND_2_2 1
#define GMDS__KIND_2_3 2
#define GMDS__KIND_3_1 GMDS__KIND_3_0
#define GMDS__KIND_3_2 GMDS__KIND_3_0
#define GMDS__KIND_3_3 GMDS__KIND_3_0
#define GMDS__ARITY_1_0 2
#define GMDS__ARITY_2_0 GMDS__SIDES
#define GMDS__ARITY_2_1 GMDS__SIDES
#define GMDS__ARITY_3_0 GMDS__CORNERS
#define GMDS__ARITY_3_1 GMDS__RIMS
#define GMDS__ARITY_3_2 GMDS__WALLS
#define GMDS__ARITY_3_3 GMDS__WALLS

#define GMDS__ROWS_FIELD(i, j) gmds_rows r_##i##_##j;
#define GMDS__PAIRS_FIELD(i, j) gmds_pairs r_##i##_##j;
#define GMDS__INLINE_FIELD(i, j) gmds_column r_##i##_##j;

struct mesh {
  gmds_memory memory;     /* counts everything that the mesh holds; do not move the structure while it is in use */
  gmds_cells cells[4];    /* nodes, edges, faces, regions */
  double *points;         /* 3 coordinates a node */
  size_t points_capacity; /* in nodes */
#if GMDS__TYPED
  uint8_t *types; /* of regions: gmds_cell_type */
  size_t types_capacity;
#endif
  GMDS__EACH_POOLED(GMDS__ROWS_FIELD)
  GMDS__EACH_PAIRS(GMDS__PAIRS_FIELD)
  GMDS__EACH_INLINE(GMDS__INLINE_FIELD)
  gmds_ids plan, found, more; /* scratch space of operations that change the mesh */
  gmds_csr borrowed[4][4];    /* relations lent to queries of the whole mesh in place of traversals; empty otherwise */
};
#undef GMDS__ROWS_FIELD
#undef GMDS__PAIRS_FIELD
#undef GMDS__INLINE_FIELD

static inline gmds_status mesh_init(mesh *m, const gmds_allocator *allocator)
{
  memset(m, 0, sizeof *m);
  gmds_memory_init(&m->memory, allocator);
  size_t limit = gmds_link_check == GMDS_ID_BITS ? GMDS_NONE : 0;
  for (int i = 0; i < 4; i++)
    gmds_cells_init(&m->cells[i], &m->memory, limit);
#if GMDS__S_3_3
  m->cells[3].limit = GMDS_NONE / 4; /* an entry may carry a face, and high values mark entries in passing */
#endif
#define GMDS__INIT_SET(i, j) gmds_rows_init(&m->r_##i##_##j, 0);
#define GMDS__INIT_PAIRS(i, j) gmds_pairs_init(&m->r_##i##_##j);
#define GMDS__INIT_ORDERED(i, j) gmds_rows_init(&m->r_##i##_##j, 1);
  GMDS__EACH_SET(GMDS__INIT_SET)
  GMDS__EACH_ORDERED(GMDS__INIT_ORDERED)
  GMDS__EACH_PAIRS(GMDS__INIT_PAIRS)
#undef GMDS__INIT_SET
#undef GMDS__INIT_ORDERED
#undef GMDS__INIT_PAIRS
  gmds_ids_init(&m->plan, &m->memory);
  gmds_ids_init(&m->found, &m->memory);
  gmds_ids_init(&m->more, &m->memory);
  return GMDS_OK;
}

static inline void clear_scratch(mesh *m)
{
  gmds_ids_clear(&m->plan);
  gmds_ids_clear(&m->found);
  gmds_ids_clear(&m->more);
}

static inline void empty(mesh *m)
{
#define GMDS__CLEAR_ROWS(i, j) gmds_rows_clear(&m->r_##i##_##j, &m->memory);
#define GMDS__CLEAR_PAIRS(i, j) gmds_pairs_clear(&m->r_##i##_##j, &m->memory);
#define GMDS__CLEAR_INLINE(i, j) gmds_column_clear(&m->r_##i##_##j, &m->memory);
  GMDS__EACH_POOLED(GMDS__CLEAR_ROWS)
  GMDS__EACH_PAIRS(GMDS__CLEAR_PAIRS)
  GMDS__EACH_INLINE(GMDS__CLEAR_INLINE)
#undef GMDS__CLEAR_ROWS
#undef GMDS__CLEAR_PAIRS
#undef GMDS__CLEAR_INLINE
  gmds_release(&m->memory, m->points, m->points_capacity, 3 * sizeof(double));
  m->points = NULL;
  m->points_capacity = 0;
#if GMDS__TYPED
  gmds_release(&m->memory, m->types, m->types_capacity, 1);
  m->types = NULL;
  m->types_capacity = 0;
#endif
  for (int i = 0; i < 4; i++)
    gmds_cells_empty(&m->cells[i]);
  clear_scratch(m);
}

static inline void mesh_clear(mesh *m)
{
  empty(m);
  for (int i = 0; i < 4; i++)
    gmds_cells_clear(&m->cells[i]);
}

/* Gives every column of the i-cells room for exactly `capacity` cells. Each column knows its own room: after a failure
 * some have more than the count says, which is no harm. */
static inline gmds_status resize_columns(mesh *m, int i, size_t capacity)
{
  if (capacity == m->cells[i].capacity)
    return GMDS_OK;
  if (capacity > m->cells[i].limit)
    return GMDS_ERR_TOO_MANY;
  if (i == 0) {
    void *points = m->points;
    if (!gmds_resize(&m->memory, &points, m->points_capacity, capacity, 3 * sizeof(double)))
      return GMDS_ERR_MEMORY;
    m->points = points;
    m->points_capacity = capacity;
  }
#if GMDS__TYPED
  if (i == 3) {
    void *types = m->types;
    if (!gmds_resize(&m->memory, &types, m->types_capacity, capacity, 1))
      return GMDS_ERR_MEMORY;
    m->types = types;
    m->types_capacity = capacity;
  }
#endif
#define GMDS__RESIZE_ROWS(a, b) \
  if (i == a)                   \
    GMDS_TRY(gmds_rows_resize(&m->r_##a##_##b, &m->memory, capacity));
#define GMDS__RESIZE_PAIRS(a, b) \
  if (i == a)                    \
    GMDS_TRY(gmds_pairs_resize(&m->r_##a##_##b, &m->memory, capacity));
#define GMDS__RESIZE_INLINE(a, b) \
  if (i == a)                     \
    GMDS_TRY(gmds_column_resize(&m->r_##a##_##b, &m->memory, GMDS__ARITY_##a##_##b *capacity));
  GMDS__EACH_POOLED(GMDS__RESIZE_ROWS)
  GMDS__EACH_PAIRS(GMDS__RESIZE_PAIRS)
  GMDS__EACH_INLINE(GMDS__RESIZE_INLINE)
#undef GMDS__RESIZE_ROWS
#undef GMDS__RESIZE_PAIRS
#undef GMDS__RESIZE_INLINE
  return gmds_cells_resize(&m->cells[i], capacity);
}

static inline gmds_status grow(mesh *m, int i, size_t more)
{
  return resize_columns(m, i, gmds_cells_needed(&m->cells[i], more));
}

static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces, size_t regions)
{
  const size_t wanted[4] = {nodes, GMDS__K_1 ? edges : 0, GMDS__K_2 ? faces : 0, regions};
  for (int i = 0; i < 4; i++)
    if (wanted[i] > m->cells[i].capacity)
      GMDS_TRY(resize_columns(m, i, wanted[i]));
  return GMDS_OK;
}

static inline gmds_status trim(mesh *m)
{
  clear_scratch(m);
  for (int i = 0; i < 4; i++)
    GMDS_TRY(resize_columns(m, i, m->cells[i].end));
#define GMDS__TRIM_ROWS(i, j) GMDS_TRY(gmds_rows_trim(&m->r_##i##_##j, &m->memory));
#define GMDS__TRIM_PAIRS(i, j) GMDS_TRY(gmds_pairs_trim(&m->r_##i##_##j, &m->memory));
  GMDS__EACH_POOLED(GMDS__TRIM_ROWS)
  GMDS__EACH_PAIRS(GMDS__TRIM_PAIRS)
#undef GMDS__TRIM_ROWS
#undef GMDS__TRIM_PAIRS
  return GMDS_OK;
}

static inline size_t count_0(const mesh *m)
{
  return m->cells[0].count;
}

static inline size_t count_1(const mesh *m)
{
  return m->cells[1].count;
}

static inline size_t count_2(const mesh *m)
{
  return m->cells[2].count;
}

static inline size_t count_3(const mesh *m)
{
  return m->cells[3].count;
}

static inline int has_0(const mesh *m, gmds_id v)
{
  return gmds_cells_has(&m->cells[0], v);
}

static inline int has_1(const mesh *m, gmds_id e)
{
  return gmds_cells_has(&m->cells[1], e);
}

static inline int has_2(const mesh *m, gmds_id f)
{
  return gmds_cells_has(&m->cells[2], f);
}

static inline int has_3(const mesh *m, gmds_id r)
{
  return gmds_cells_has(&m->cells[3], r);
}

static inline gmds_id next_0(const mesh *m, gmds_id v)
{
  return gmds_cells_next(&m->cells[0], v);
}

static inline gmds_id next_1(const mesh *m, gmds_id e)
{
  return gmds_cells_next(&m->cells[1], e);
}

static inline gmds_id next_2(const mesh *m, gmds_id f)
{
  return gmds_cells_next(&m->cells[2], f);
}

static inline gmds_id next_3(const mesh *m, gmds_id r)
{
  return gmds_cells_next(&m->cells[3], r);
}

static inline size_t end_0(const mesh *m)
{
  return m->cells[0].end;
}

static inline size_t end_1(const mesh *m)
{
  return m->cells[1].end;
}

static inline size_t end_2(const mesh *m)
{
  return m->cells[2].end;
}

static inline size_t end_3(const mesh *m)
{
  return m->cells[3].end;
}

static inline gmds_memory *mesh_memory(mesh *m)
{
  return &m->memory;
}

static inline gmds_status add_attribute(mesh *m, int i, const char *name, gmds_value type, size_t components,
                                        gmds_attribute **attribute)
{
  if (i < 0 || i > 3)
    return GMDS_ERR_ARGUMENT;
  return gmds_attribute_add(&m->cells[i], name, type, components, attribute);
}

static inline gmds_attribute *find_attribute(const mesh *m, int i, const char *name)
{
  return i < 0 || i > 3 ? NULL : gmds_attribute_find(&m->cells[i], name);
}

static inline void remove_attribute(mesh *m, int i, gmds_attribute *attribute)
{
  if (i >= 0 && i <= 3)
    gmds_attribute_remove(&m->cells[i], attribute);
}

static inline const double *point(const mesh *m, gmds_id v)
{
  return m->points + 3 * (size_t)v;
}

static inline double *coordinates(mesh *m)
{
  return m->points;
}

static inline void set_point(mesh *m, gmds_id v, const double *x)
{
  memcpy(m->points + 3 * (size_t)v, x, 3 * sizeof *x);
}
