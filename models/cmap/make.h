/* Making cells, and matching them. */

static inline gmds_status make_edge(mesh *m, const double *x, gmds_id *d)
{
  return gmds_map_make_edge(&m->map, x, d);
}

static inline gmds_status make_polygon(mesh *m, size_t k, const double *x, gmds_id *d)
{
  return gmds_map_make_polygon(&m->map, k, x, NULL, d);
}

static inline gmds_status place_polygon(mesh *m, size_t k, const gmds_id *nodes, gmds_id *d)
{
  return gmds_map_make_polygon(&m->map, k, NULL, nodes, d);
}

#if GMDS__N > 2
static inline gmds_status make_tetrahedron(mesh *m, const double *x, gmds_id *d)
{
  return gmds_map_make_shape(&m->map, GMDS_TETRAHEDRON, x, NULL, d);
}

static inline gmds_status make_pyramid(mesh *m, const double *x, gmds_id *d)
{
  return gmds_map_make_shape(&m->map, GMDS_PYRAMID, x, NULL, d);
}

static inline gmds_status make_prism(mesh *m, const double *x, gmds_id *d)
{
  return gmds_map_make_shape(&m->map, GMDS_PRISM, x, NULL, d);
}

static inline gmds_status make_hexahedron(mesh *m, const double *x, gmds_id *d)
{
  return gmds_map_make_shape(&m->map, GMDS_HEXAHEDRON, x, NULL, d);
}

static inline gmds_status make_polyhedron(mesh *m, size_t n_nodes, const double *x, size_t n_faces, const size_t *begin,
                                          const gmds_id *corners, gmds_id *d)
{
  const gmds_map_frame frame = {n_nodes, n_faces, begin, corners};
  return n_faces < 3 ? GMDS_ERR_ARGUMENT : gmds_map_make_frame(&m->map, &frame, x, NULL, d);
}

static inline gmds_status place_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *d)
{
  return gmds_map_make_shape(&m->map, type, NULL, nodes, d);
}
#endif

#if GMDS__N < 4
static inline gmds_status match_nodes(mesh *m, size_t *sewn)
{
  return gmds_map_match(&m->map, GMDS_BY_NODES, sewn);
}

static inline gmds_status match_points(mesh *m, size_t *sewn)
{
  return gmds_map_match(&m->map, GMDS_BY_COORDINATES, sewn);
}
#endif
