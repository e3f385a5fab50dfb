/* A mesh as parts, and back: columns are handed over as they are; parts.h converts them. */

static inline gmds_layout mesh_layout(const mesh *m)
{
  gmds_layout l = {.mask = GMDS__MASK,
                   .faces = GMDS__TRIANGLES | GMDS__QUADRILATERALS << 1 | GMDS__POLYGONS << 2,
                   .dim = GMDS__DIM,
                   .limit = {m->cells[0].limit, m->cells[1].limit, m->cells[2].limit}};
#define GMDS__SET_HOW(i, j) l.relation[i][j] = (gmds_stored){.storage = GMDS_IN_ROWS};
#define GMDS__ORDERED_HOW(i, j) l.relation[i][j] = (gmds_stored){.storage = GMDS_IN_ROWS, .ordered = 1};
#define GMDS__PAIRS_HOW(i, j) l.relation[i][j] = (gmds_stored){.storage = GMDS_IN_PAIRS};
#define GMDS__INLINE_HOW(i, j) \
  l.relation[i][j] = (gmds_stored){GMDS_IN_COLUMN, GMDS__ARITY_##i, 0, GMDS__CODED && i == 2 && j == 2};
  GMDS__EACH_SET(GMDS__SET_HOW)
  GMDS__EACH_ORDERED(GMDS__ORDERED_HOW)
  GMDS__EACH_PAIRS(GMDS__PAIRS_HOW)
  GMDS__EACH_INLINE(GMDS__INLINE_HOW)
#undef GMDS__SET_HOW
#undef GMDS__ORDERED_HOW
#undef GMDS__PAIRS_HOW
#undef GMDS__INLINE_HOW
  return l;
}

/* Lets `parts` name what the mesh holds. */
static inline void view_parts(const mesh *m, gmds_parts *parts)
{
  parts->memory = m->memory;
  parts->layout = mesh_layout(m);
  for (int i = 0; i < 3; i++) {
    parts->cells[i] = m->cells[i];
    for (int j = 0; j < 3; j++)
      parts->relation[i][j].how = parts->layout.relation[i][j];
  }
  parts->points = m->points;
  parts->points_capacity = m->points_capacity;
#define GMDS__VIEW_ROWS(i, j) parts->relation[i][j].rows = m->r_##i##_##j;
#define GMDS__VIEW_PAIRS(i, j) parts->relation[i][j].pairs = m->r_##i##_##j;
#define GMDS__VIEW_INLINE(i, j) parts->relation[i][j].column = m->r_##i##_##j;
  GMDS__EACH_POOLED(GMDS__VIEW_ROWS)
  GMDS__EACH_PAIRS(GMDS__VIEW_PAIRS)
  GMDS__EACH_INLINE(GMDS__VIEW_INLINE)
#undef GMDS__VIEW_ROWS
#undef GMDS__VIEW_PAIRS
#undef GMDS__VIEW_INLINE
}

static inline void give_parts(mesh *m, gmds_parts *parts)
{
  const gmds_allocator allocator = m->memory.allocator;
  const size_t limit = m->memory.limit;
  gmds_ids_clear(&m->plan);
  gmds_ids_clear(&m->found);
  gmds_parts_clear(parts);
  view_parts(m, parts);
  for (int i = 0; i < 3; i++)
    parts->cells[i].alive.memory = &parts->memory;
  mesh_init(m, &allocator);
  m->memory.limit = limit;
}

static inline gmds_status take_parts(mesh *m, gmds_parts *parts, gmds_error *error)
{
  if (m->cells[0].count || m->cells[1].count || m->cells[2].count)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "the mesh that is to take the parts is not empty");
  const gmds_layout to = mesh_layout(m);
  GMDS_TRY(gmds_parts_convert(parts, &to, error));
  mesh_clear(m);
  m->memory = parts->memory;
  for (int i = 0; i < 3; i++) {
    m->cells[i] = parts->cells[i];
    m->cells[i].alive.memory = &m->memory;
  }
  m->points = parts->points;
  m->points_capacity = parts->points_capacity;
#define GMDS__TAKE_ROWS(i, j) m->r_##i##_##j = parts->relation[i][j].rows;
#define GMDS__TAKE_PAIRS(i, j) m->r_##i##_##j = parts->relation[i][j].pairs;
#define GMDS__TAKE_INLINE(i, j) m->r_##i##_##j = parts->relation[i][j].column;
  GMDS__EACH_POOLED(GMDS__TAKE_ROWS)
  GMDS__EACH_PAIRS(GMDS__TAKE_PAIRS)
  GMDS__EACH_INLINE(GMDS__TAKE_INLINE)
#undef GMDS__TAKE_ROWS
#undef GMDS__TAKE_PAIRS
#undef GMDS__TAKE_INLINE
  gmds_parts_init(parts);
  return GMDS_OK;
}

static inline gmds_status permute(mesh *m, gmds_id *const maps[3])
{
  gmds_parts old, renumbered;
  gmds_parts_init(&old);
  view_parts(m, &old);
  GMDS_TRY(gmds_parts_copy_as(&old, maps, &renumbered));
  const size_t peak = m->memory.live + renumbered.memory.peak;
  renumbered.memory.limit = m->memory.limit;
  renumbered.memory.peak = peak > m->memory.peak ? peak : m->memory.peak;
  gmds_parts_init(&old);
  give_parts(m, &old);
  gmds_status status = take_parts(m, &renumbered, NULL);
  if (status != GMDS_OK)
    (void)take_parts(m, &old, NULL); /* allocates nothing */
  gmds_parts_clear(&old);
  gmds_parts_clear(&renumbered);
  return status;
}
