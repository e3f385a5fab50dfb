/* Creation: a plan (plan.h), which may fail, is carried out (link.h), which cannot. */

static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id)
{
  GMDS_TRY(grow(m, 0, 1));
  gmds_id v = gmds_cells_take(&m->cells[0]);
  set_point(m, v, x);
  *id = v;
  return GMDS_OK;
}

static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first)
{
  const gmds_cells *nodes = &m->cells[0];
  if (n > nodes->limit || nodes->end > nodes->limit - n)
    return GMDS_ERR_TOO_MANY;
  if (nodes->end + n > nodes->capacity)
    GMDS_TRY(resize_columns(m, 0, nodes->end + n));
  *first = gmds_cells_take_many(&m->cells[0], n);
  if (n && x)
    memcpy(m->points + 3 * (size_t)*first, x, 3 * n * sizeof *x);
  return GMDS_OK;
}

/* Whether n nodes are alive and distinct. */
static inline gmds_status check_nodes(mesh *m, size_t n, const gmds_id *nodes)
{
  enum { FEW = 32 };
  for (size_t k = 0; k < n; k++) {
    if (!has_0(m, nodes[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; n <= FEW && q < k; q++)
      if (nodes[q] == nodes[k])
        return GMDS_ERR_ARGUMENT;
  }
  if (n <= FEW)
    return GMDS_OK;
  GMDS_TRY(start_with(&m->found, nodes, n));
  gmds_ids_keep(&m->found, 0, 2, GMDS_NONE);
  return m->found.n ? GMDS_ERR_ARGUMENT : GMDS_OK;
}

/* ---- cells */

/* Finds, takes and makes room for what the plan is made of. On failure nothing is left of it. */
static inline gmds_status prepare_plan(mesh *m, cell_plan *p)
{
  GMDS_TRY(find_planned(m, p));
  gmds_status status = take_planned(m, p);
  if (status == GMDS_OK)
    status = reserve_planned(m, p);
  if (status != GMDS_OK)
    drop_planned(m, p);
  return status;
}

#if GMDS__LINKED_0_1
static inline gmds_status add_edge(mesh *m, gmds_id a, gmds_id b, gmds_id *id)
{
  cell_plan p;
  if (!has_0(m, a) || !has_0(m, b))
    return GMDS_ERR_CELL;
  if (a == b)
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(plan_edge(m, a, b, &p));
  GMDS_TRY(prepare_plan(m, &p));
  link_planned(m, &p);
  *id = p.edge[0];
  return GMDS_OK;
}
#endif

#if GMDS_ADDS_FACES && GMDS__MAKES_FACES
static inline int allows_sides(size_t n)
{
  return (n == 3 && GMDS__TRIANGLES) || (n == 4 && GMDS__QUADRILATERALS) || (n >= 3 && GMDS__POLYGONS);
}

static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  cell_plan p;
  if (!allows_sides(n))
    return GMDS_ERR_ARGUMENT;
  GMDS_TRY(check_nodes(m, n, nodes));
  GMDS_TRY(plan_polygon(m, n, nodes, &p));
  GMDS_TRY(prepare_plan(m, &p));
  link_planned(m, &p);
  *id = p.face[0];
  return GMDS_OK;
}

static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id)
{
  const gmds_id nodes[3] = {a, b, c};
  return add_face(m, 3, nodes, id);
}

static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_face(m, 4, nodes, id);
}
#endif

#if GMDS_ADDS_REGIONS
static inline int allows_type(gmds_cell_type type)
{
  return type >= GMDS_TETRAHEDRON && type <= GMDS_HEXAHEDRON &&
         ((unsigned)GMDS_FN(regions) >> (type - GMDS_TETRAHEDRON) & 1);
}

/* Makes the region of a plan whose edges and faces are ready. On failure they are given back. */
static inline gmds_status finish_region(mesh *m, gmds_cell_type type, cell_plan *p, gmds_id *id)
{
  gmds_status status = grow(m, 3, 1);
  if (status == GMDS_OK) {
    gmds_id r = gmds_cells_take(&m->cells[3]);
    status = reserve_region(m, r, p);
    if (status == GMDS_OK) {
      link_planned(m, p);
      link_region(m, r, type, p);
      *id = r;
      return GMDS_OK;
    }
    drop_region(m, r);
  }
  drop_planned(m, p);
  return status;
}

static inline gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id)
{
  cell_plan p;
  if (!allows_type(type))
    return GMDS_ERR_ARGUMENT;
  const gmds_shape *s = gmds_shape_of(type);
  GMDS_TRY(check_nodes(m, s->nodes, nodes));
  GMDS_TRY(plan_shape(m, s, nodes, &p));
  GMDS_TRY(find_planned(m, &p));
#  if GMDS__S_3_3
  GMDS_TRY(find_beyond(m, &p));
#  endif
  gmds_status status = take_planned(m, &p);
  if (status == GMDS_OK)
    status = reserve_planned(m, &p);
  if (status != GMDS_OK) {
    drop_planned(m, &p);
    return status;
  }
  return finish_region(m, type, &p, id);
}

static inline gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_region(m, GMDS_TETRAHEDRON, nodes, id);
}

#  if GMDS__POLYHEDRA
/* Lists the sides of the faces of a polyhedron: each of its edges once, with how many faces have it in p->fresh. */
static inline void plan_sides(const mesh *m, cell_plan *p)
{
  size_t corners = 0, edges = 0, nodes = 0;
  gmds_id *own = p->slot + p->n_faces;
  for (size_t k = 0; k < p->n_faces; k++) {
    size_t n = 0;
    const gmds_id *row = row_2_0(m, p->face[k], &n);
    p->begin[k] = (gmds_id)corners;
    for (size_t i = 0; i < n; i++) {
      const gmds_id a = row[i], b = row[i + 1 < n ? i + 1 : 0];
      size_t e = 0, v = 0;
      while (e < edges && !(p->ends[2 * e] == a && p->ends[2 * e + 1] == b) &&
             !(p->ends[2 * e] == b && p->ends[2 * e + 1] == a))
        e++;
      if (e == edges) {
        p->ends[2 * e] = a;
        p->ends[2 * e + 1] = b;
        p->fresh[edges++] = 0;
      }
      p->fresh[e]++;
      while (v < nodes && own[v] != a)
        v++;
      if (v == nodes)
        own[nodes++] = a;
      p->corner[corners] = a;
      p->border[corners++] = (gmds_id)e;
    }
  }
  p->begin[p->n_faces] = (gmds_id)corners;
  p->n_edges = edges;
  p->n_nodes = nodes;
  p->node = own;
}

static inline gmds_status add_polyhedron(mesh *m, size_t n, const gmds_id *faces, gmds_id *id)
{
  size_t corners = 0;
  cell_plan p;
  for (size_t k = 0; k < n; k++) {
    if (!has_2(m, faces[k]))
      return GMDS_ERR_CELL;
    for (size_t q = 0; q < k; q++)
      if (faces[q] == faces[k])
        return GMDS_ERR_ARGUMENT;
    corners += m->r_2_0.length[faces[k]];
  }
  GMDS_TRY(n < 4 ? GMDS_ERR_ARGUMENT : begin_plan(m, corners, NULL, corners, n, corners, &p));
  GMDS_TRY(gmds_ids_reserve(&m->plan, m->plan.n + corners));
  GMDS_TRY(begin_plan(m, corners, NULL, corners, n, corners, &p)); /* where the list is now */
  for (size_t k = 0; k < n; k++) {
    p.face[k] = faces[k];
    p.made[k] = p.slot[k] = 0;
    p.beyond[k] = GMDS_NONE;
  }
  plan_sides(m, &p);
  for (size_t e = 0; e < p.n_edges; e++) {
    if (p.fresh[e] != 2) /* the faces do not close */
      return GMDS_ERR_ARGUMENT;
    p.fresh[e] = 0;
    p.edge[e] = GMDS_NONE;
#    if GMDS__MAKES_EDGES && GMDS__LINKED_0_1
    p.edge[e] = find_edge(m, p.ends[2 * e], p.ends[2 * e + 1]);
    if (p.edge[e] == GMDS_NONE)
      return GMDS_ERR_INVARIANT;
#    endif
  }
#    if GMDS__S_3_3
  GMDS_TRY(find_beyond(m, &p));
#    endif
#    if GMDS__S_0_0
  GMDS_TRY(reserve_planned(m, &p));
#    endif
  return finish_region(m, GMDS_POLYHEDRON, &p, id);
}
#  endif
#endif
