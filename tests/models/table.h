/* Fills the table of the open model (model.h): included by generated files between <gmds/mesh.h> and <gmds/end.h>, once
 * for each model. With TEST_ALGORITHMS the conversions and the Delaunay triangulation are compiled too. */

static void GMDS_FN(do_init)(void *m, const gmds_allocator *allocator)
{
  mesh_init(m, allocator);
}

static void GMDS_FN(do_clear)(void *m)
{
  mesh_clear(m);
}

static gmds_cells *GMDS_FN(do_cells)(void *m)
{
  return ((mesh *)m)->cells;
}

static gmds_memory *GMDS_FN(do_memory)(void *m)
{
  return &((mesh *)m)->memory;
}

static const double *GMDS_FN(do_point)(const void *m, gmds_id v)
{
  return point(m, v);
}

static gmds_status GMDS_FN(do_query)(const void *m, int i, int j, gmds_id c, gmds_ids *out)
{
  (void)m;
  (void)c;
  (void)out;
  switch (3 * i + j) {
#if GMDS_CAN(0, 0)
  case 0:
    return get_adj_0_0(m, c, out);
#endif
#if GMDS_CAN(0, 1)
  case 1:
    return get_adj_0_1(m, c, out);
#endif
#if GMDS_CAN(0, 2)
  case 2:
    return get_adj_0_2(m, c, out);
#endif
#if GMDS_CAN(1, 0)
  case 3:
    return get_adj_1_0(m, c, out);
#endif
#if GMDS_CAN(1, 1)
  case 4:
    return get_adj_1_1(m, c, out);
#endif
#if GMDS_CAN(1, 2)
  case 5:
    return get_adj_1_2(m, c, out);
#endif
#if GMDS_CAN(2, 0)
  case 6:
    return get_adj_2_0(m, c, out);
#endif
#if GMDS_CAN(2, 1)
  case 7:
    return get_adj_2_1(m, c, out);
#endif
#if GMDS_CAN(2, 2)
  case 8:
    return get_adj_2_2(m, c, out);
#endif
  default:
    return GMDS_ERR_UNSUPPORTED;
  }
}

static gmds_status GMDS_FN(do_bulk)(const void *m, int i, int j, gmds_csr *csr)
{
  (void)m;
  (void)csr;
  switch (3 * i + j) {
#if GMDS_CAN(0, 0)
  case 0:
    return all_adj_0_0(m, csr);
#endif
#if GMDS_CAN(0, 1)
  case 1:
    return all_adj_0_1(m, csr);
#endif
#if GMDS_CAN(0, 2)
  case 2:
    return all_adj_0_2(m, csr);
#endif
#if GMDS_CAN(1, 0)
  case 3:
    return all_adj_1_0(m, csr);
#endif
#if GMDS_CAN(1, 1)
  case 4:
    return all_adj_1_1(m, csr);
#endif
#if GMDS_CAN(1, 2)
  case 5:
    return all_adj_1_2(m, csr);
#endif
#if GMDS_CAN(2, 0)
  case 6:
    return all_adj_2_0(m, csr);
#endif
#if GMDS_CAN(2, 1)
  case 7:
    return all_adj_2_1(m, csr);
#endif
#if GMDS_CAN(2, 2)
  case 8:
    return all_adj_2_2(m, csr);
#endif
  default:
    return GMDS_ERR_UNSUPPORTED;
  }
}

static const gmds_id *GMDS_FN(do_view)(const void *m, int i, int j, gmds_id c, size_t *n)
{
  (void)m;
  (void)c;
  (void)n;
  switch (3 * i + j) {
#if GMDS_VIEW(0, 0)
  case 0:
    return view_0_0(m, c, n);
#endif
#if GMDS_VIEW(0, 1)
  case 1:
    return view_0_1(m, c, n);
#endif
#if GMDS_VIEW(0, 2)
  case 2:
    return view_0_2(m, c, n);
#endif
#if GMDS_VIEW(1, 0)
  case 3:
    return view_1_0(m, c, n);
#endif
#if GMDS_VIEW(1, 1)
  case 4:
    return view_1_1(m, c, n);
#endif
#if GMDS_VIEW(1, 2)
  case 5:
    return view_1_2(m, c, n);
#endif
#if GMDS_VIEW(2, 0)
  case 6:
    return view_2_0(m, c, n);
#endif
#if GMDS_VIEW(2, 1)
  case 7:
    return view_2_1(m, c, n);
#endif
  default:
    return NULL;
  }
}

#if GMDS_ORDERED_2_0 || (GMDS_CAN(2, 0) && GMDS__SIMPLICIAL)
static gmds_status GMDS_FN(do_all_edges)(const void *m, gmds_edge_table *table)
{
  return all_edges(m, table);
}
#endif

static gmds_id GMDS_FN(do_across)(const void *m, gmds_id f, unsigned k, unsigned *arrival)
{
#if GMDS_ACROSS
  return across(m, f, k, arrival);
#else
  (void)m;
  (void)f;
  (void)k;
  (void)arrival;
  return GMDS_NONE;
#endif
}

static gmds_status GMDS_FN(do_add_node)(void *m, const double *x, gmds_id *id)
{
  return add_node(m, x, id);
}

#if GMDS_STORED(0, 1) || GMDS_STORED(1, 0)
static gmds_status GMDS_FN(do_add_edge)(void *m, gmds_id a, gmds_id b, gmds_id *id)
{
  return add_edge(m, a, b, id);
}
#endif

static gmds_status GMDS_FN(do_add_face)(void *m, size_t n, const gmds_id *nodes, const gmds_links *links, gmds_id *id)
{
  return links ? add_face_linked(m, n, nodes, links, id) : add_face(m, n, nodes, id);
}

static gmds_status GMDS_FN(do_add_faces)(void *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed)
{
  return add_faces(m, n, begin, nodes, failed);
}

static gmds_status GMDS_FN(do_remove_face)(void *m, gmds_id f, gmds_edges edges)
{
  return remove_face(m, f, edges);
}

#if GMDS__K_1
static gmds_status GMDS_FN(do_remove_edge)(void *m, gmds_id e, gmds_around around)
{
  return remove_edge(m, e, around);
}
#endif

static gmds_status GMDS_FN(do_remove_node)(void *m, gmds_id v, gmds_around around)
{
  return remove_node(m, v, around);
}

static gmds_status GMDS_FN(do_trim)(void *m)
{
  return trim(m);
}

static gmds_status GMDS_FN(do_compact)(void *m, gmds_id *maps[3])
{
  return compact(m, maps);
}

static gmds_status GMDS_FN(do_check)(const void *m, gmds_memory *memory, gmds_error *error)
{
  return check(m, memory, error);
}

static void GMDS_FN(do_give)(void *m, gmds_parts *parts)
{
  give_parts(m, parts);
}

static gmds_status GMDS_FN(do_take)(void *m, gmds_parts *parts, gmds_error *error)
{
  return take_parts(m, parts, error);
}

static stored_relation GMDS_FN(do_stored)(void *m, int i, int j)
{
  mesh *own = m;
  stored_relation s = {NULL, NULL, NULL, 0, GMDS__CODED && i == 2 && j == 2};
  (void)own;
#define TEST_ROWS(a, b) \
  if (i == a && j == b) \
    s.rows = &own->r_##a##_##b;
#define TEST_PAIRS(a, b) \
  if (i == a && j == b)  \
    s.pairs = &own->r_##a##_##b;
#define TEST_COLUMN(a, b)         \
  if (i == a && j == b) {         \
    s.column = &own->r_##a##_##b; \
    s.arity = GMDS__ARITY_##a;    \
  }
  GMDS__EACH_POOLED(TEST_ROWS)
  GMDS__EACH_PAIRS(TEST_PAIRS)
  GMDS__EACH_INLINE(TEST_COLUMN)
#undef TEST_ROWS
#undef TEST_PAIRS
#undef TEST_COLUMN
  return s;
}

#if TEST_ALGORITHMS
static gmds_status GMDS_FN(do_from_soup)(void *m, const gmds_soup *soup, gmds_error *error)
{
  return from_soup(m, soup, error);
}

#  if GMDS_ORDERED_2_0 || (GMDS_CAN(2, 0) && GMDS__SIMPLICIAL)
static gmds_status GMDS_FN(do_to_soup)(const void *m, gmds_soup *soup)
{
  return to_soup(m, soup);
}
#  endif

#  if GMDS_CAN(2, 0)
static gmds_status GMDS_FN(do_checksum)(const void *m, gmds_memory *memory, uint64_t *sum)
{
  return checksum(m, memory, sum);
}
#  endif

#  if GMDS__DIM == 2 && GMDS__TRIANGLES && !GMDS_STORED(1, 1) && GMDS_CAN(2, 0) && GMDS_CAN(2, 2) && GMDS_ADDS_FACES
#    define TEST_DELAUNAY 1
#    include <gmds/algorithms/delaunay.h>
static gmds_status GMDS_FN(do_delaunay)(void *m, size_t n, const double *xy, const gmds_delaunay_options *options,
                                        gmds_delaunay_result *result)
{
  return GMDS_FN(delaunay)(m, n, xy, options, result);
}
#  else
#    define TEST_DELAUNAY 0
#  endif

static const model_algorithms GMDS_FN(algorithms) = {
    .do_from_soup = GMDS_FN(do_from_soup),
#  if GMDS_ORDERED_2_0 || (GMDS_CAN(2, 0) && GMDS__SIMPLICIAL)
    .do_to_soup = GMDS_FN(do_to_soup),
#  endif
#  if GMDS_CAN(2, 0)
    .do_checksum = GMDS_FN(do_checksum),
#  endif
#  if TEST_DELAUNAY
    .do_delaunay = GMDS_FN(do_delaunay),
#  endif
};
#  undef TEST_DELAUNAY
#endif

const model GMDS_FN(table) = {
    .name = GMDS_TEXT(GMDS_MODEL) " " GMDS_TEXT(GMDS_FACES),
    .mask = GMDS__MASK,
    .faces = GMDS__TRIANGLES | GMDS__QUADRILATERALS << 1 | GMDS__POLYGONS << 2,
    .dim = GMDS__DIM,
    .bytes = sizeof(mesh),
    .path = {{GMDS__PATH_0_0, GMDS__PATH_0_1, GMDS__PATH_0_2},
             {GMDS__PATH_1_0, GMDS__PATH_1_1, GMDS__PATH_1_2},
             {GMDS__PATH_2_0, GMDS__PATH_2_1, GMDS__PATH_2_2}},
    .can = {{GMDS_CAN(0, 0), GMDS_CAN(0, 1), GMDS_CAN(0, 2)},
            {GMDS_CAN(1, 0), GMDS_CAN(1, 1), GMDS_CAN(1, 2)},
            {GMDS_CAN(2, 0), GMDS_CAN(2, 1), GMDS_CAN(2, 2)}},
    .ordered = GMDS_ORDERED_2_0,
    .crosses = GMDS_ACROSS,
    .do_init = GMDS_FN(do_init),
    .do_clear = GMDS_FN(do_clear),
    .do_cells = GMDS_FN(do_cells),
    .do_memory = GMDS_FN(do_memory),
    .do_point = GMDS_FN(do_point),
    .do_query = GMDS_FN(do_query),
    .do_bulk = GMDS_FN(do_bulk),
    .view = {{GMDS_VIEW(0, 0), GMDS_VIEW(0, 1), GMDS_VIEW(0, 2)},
             {GMDS_VIEW(1, 0), GMDS_VIEW(1, 1), GMDS_VIEW(1, 2)},
             {GMDS_VIEW(2, 0), GMDS_VIEW(2, 1), GMDS_VIEW(2, 2)}},
    .do_view = GMDS_FN(do_view),
#if GMDS_ORDERED_2_0 || (GMDS_CAN(2, 0) && GMDS__SIMPLICIAL)
    .do_all_edges = GMDS_FN(do_all_edges),
#endif
    .do_across = GMDS_FN(do_across),
    .do_add_node = GMDS_FN(do_add_node),
#if GMDS_STORED(0, 1) || GMDS_STORED(1, 0)
    .do_add_edge = GMDS_FN(do_add_edge),
#endif
    .do_add_face = GMDS_FN(do_add_face),
    .do_add_faces = GMDS_FN(do_add_faces),
    .adds_locally = GMDS_ADDS_LOCALLY,
    .do_remove_face = GMDS_FN(do_remove_face),
#if GMDS__K_1
    .do_remove_edge = GMDS_FN(do_remove_edge),
#endif
    .do_remove_node = GMDS_FN(do_remove_node),
    .do_trim = GMDS_FN(do_trim),
    .do_compact = GMDS_FN(do_compact),
    .do_check = GMDS_FN(do_check),
    .do_give = GMDS_FN(do_give),
    .do_take = GMDS_FN(do_take),
    .do_stored = GMDS_FN(do_stored),
#if TEST_ALGORITHMS
    .algorithms = &GMDS_FN(algorithms),
#endif
};
