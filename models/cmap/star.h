/* The cavity operators. In 2-maps a triangle keeps its three darts, linked as they are: of those that are used again
 * only nodes and what is beyond their sides change. */

#if GMDS__N == 2 && GMDS__K_2
/* The darts of a triangle that is used again, or of a fresh one: taken one after the other and linked in themselves. */
static inline void triangle_darts(mesh *m, gmds_id f, int is_fresh, gmds_id d[3])
{
  if (!is_fresh) {
    const gmds_id *record = m->map.records + (size_t)(d[0] = dart_of(m, 2, f)) * GMDS__STRIDE;
    d[1] = record[1];
    d[2] = record[0];
    return;
  }
  for (int k = 0; k < 3; k++)
    d[k] = gmds_map_take_dart(&m->map);
  for (int k = 0; k < 3; k++) {
    gmds_id *record = m->map.records + (size_t)d[k] * GMDS__STRIDE;
    record[0] = d[k > 0 ? k - 1 : 2];
    record[1] = d[k < 2 ? k + 1 : 0];
    record[GMDS__SLOT_2] = f;
  }
  m->map.anchor[2][f] = d[0];
}

/* The dart beyond side i of a cavity, or GMDS_NONE. */
static inline gmds_id dart_outside(const mesh *m, const gmds_cavity_side *s)
{
  return s->out == GMDS_NONE ? GMDS_NONE : side_dart(m, s->out, s->out_side);
}

#  if GMDS__K_1
/* The edges of a cavity: on each side, and in edge[n_sides ..) those inside it, with three new ones. */
static inline void list_star_edges(mesh *m, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                                   const gmds_cavity_side *sides, gmds_id *edge)
{
  for (size_t i = 0; i < n_sides; i++) {
    const gmds_cavity_face *in = &faces[sides[i].in];
    edge[i] = cell_of(m, 1, side_dart(m, in->face, (in->side + sides[i].in_side) % 3));
  }
  for (size_t j = 1; j < n_faces; j++)
    edge[n_sides + j - 1] = cell_of(m, 1, side_dart(m, faces[j].face, faces[j].side));
  for (size_t j = n_faces - 1; j < n_sides; j++)
    edge[n_sides + j] = gmds_cells_take(&m->map.cells[1]);
}

/* Edge i on side i, edge n_sides + i from sides[i].a to the apex. */
static inline void write_star_edges(mesh *m, size_t n_sides, const gmds_id *ids, const gmds_id *edge)
{
  for (size_t i = 0; i < n_sides; i++) {
    const gmds_id d = dart_of(m, 2, ids[i]);
    const gmds_id on[3] = {edge[i], edge[n_sides + (i + 1 < n_sides ? i + 1 : 0)], edge[n_sides + i]};
    for (int k = 0; k < 3; k++) {
      const gmds_id dart = k ? beta(m, k < 2 ? 1 : 0, d) : d;
      m->map.records[(size_t)dart * GMDS__STRIDE + GMDS__SLOT_1] = on[k];
      m->map.anchor[1][on[k]] = dart;
    }
  }
}
#  endif

/* Writes triangle i of a star, between sides[i] and the apex, but for what is beyond its side 2; the value is its dart
 * 1. */
static inline gmds_id write_star_face(mesh *m, gmds_id apex, const gmds_cavity_side *s, gmds_id outside, gmds_id f,
                                      int is_fresh, gmds_id *last)
{
  gmds_id d[3], *const records = m->map.records, *const dart_of_node = m->map.anchor[0];
  triangle_darts(m, f, is_fresh, d);
  gmds_id *side = records + (size_t)d[0] * GMDS__STRIDE;
  side[2] = outside;
  side[GMDS__SLOT_0] = s->a;
  records[(size_t)d[1] * GMDS__STRIDE + GMDS__SLOT_0] = s->b;
  records[(size_t)d[2] * GMDS__STRIDE + GMDS__SLOT_0] = apex;
  dart_of_node[s->a] = d[0];
  dart_of_node[apex] = d[2];
  if (outside != GMDS_NONE)
    records[(size_t)outside * GMDS__STRIDE + 2] = d[0];
  *last = d[2];
  return d[1];
}

static inline gmds_status star(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                               const gmds_cavity_side *sides, gmds_id *ids)
{
  if (!n_faces || n_sides != n_faces + 2)
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(gmds_map_grow(&m->map, 2, 2));
  GMDS_TRY(gmds_map_grow(&m->map, -1, 6));
#  if GMDS__K_1
  GMDS_TRY(gmds_map_grow(&m->map, 1, 3));
  GMDS_TRY(gmds_ids_reserve(&m->map.scratch, 2 * n_sides));
  list_star_edges(m, n_faces, faces, n_sides, sides, m->map.scratch.data);
#  endif
  gmds_id first = GMDS_NONE, before = GMDS_NONE, last = GMDS_NONE;
  for (size_t i = 0; i < n_sides; i++) {
    const int is_fresh = i >= n_faces;
    const gmds_id outside = dart_outside(m, &sides[i]);
    ids[i] = is_fresh ? gmds_cells_take(&m->map.cells[2]) : faces[i].face;
    const gmds_id d = write_star_face(m, apex, &sides[i], outside, ids[i], is_fresh, &last);
    if (i) { /* what leads to the apex, and what comes from it */
      m->map.records[(size_t)before * GMDS__STRIDE + 2] = last;
      m->map.records[(size_t)last * GMDS__STRIDE + 2] = before;
    } else
      first = last;
    before = d;
  }
  m->map.records[(size_t)before * GMDS__STRIDE + 2] = first;
  m->map.records[(size_t)first * GMDS__STRIDE + 2] = before;
#  if GMDS__K_1
  write_star_edges(m, n_sides, ids, m->map.scratch.data);
#  endif
  return GMDS_OK;
}
#elif GMDS_STARS
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                               gmds_id *ids)
{
  return gmds_map_star(&m->map, apex, n_regions, n_walls, walls, ids);
}
#endif
