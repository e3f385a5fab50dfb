/* Nodes, faces and regions upon nodes, as of any model. */

static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id)
{
  return gmds_map_add_node(&m->map, x, id);
}

static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first)
{
  return gmds_map_add_nodes(&m->map, n, x, first);
}

static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around)
{
  return gmds_map_remove_node(&m->map, v, around);
}

#if GMDS__N == 2
static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  gmds_id d = GMDS_NONE;
  GMDS_TRY(gmds_map_add_face(&m->map, n, nodes, &d));
  *id = cell_of(m, 2, d);
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

#  if GMDS__K_2
static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_edges edges)
{
  (void)edges; /* an edge that bounds nothing is on no dart */
  return has_2(m, f) ? gmds_map_delete_cells(&m->map, 1, &m->map.anchor[2][f], 1) : GMDS_ERR_CELL;
}
#  endif
#endif

#if GMDS__N == 3
static inline gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id)
{
  gmds_id d = GMDS_NONE;
  GMDS_TRY(gmds_map_add_region(&m->map, type, nodes, &d));
  *id = cell_of(m, 3, d);
  return GMDS_OK;
}

static inline gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id)
{
  const gmds_id nodes[4] = {a, b, c, d};
  return add_region(m, GMDS_TETRAHEDRON, nodes, id);
}
#endif

#if GMDS__N == 3 && GMDS__K_3
static inline gmds_status remove_region(mesh *m, gmds_id r, gmds_bare bare)
{
  (void)bare; /* what bounds nothing is on no dart */
  return has_3(m, r) ? gmds_map_delete_cells(&m->map, 1, &m->map.anchor[3][r], 1) : GMDS_ERR_CELL;
}
#endif
