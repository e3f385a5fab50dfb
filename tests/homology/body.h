/* What the test asks of one model: RUN is the prefix, TRIANGLES whether it holds nothing else. */
#define BODY_CAT_(a, b) a##_##b
#define BODY_CAT(a, b) BODY_CAT_(a, b)
#define OF(name) BODY_CAT(RUN, name)

/* Faces of a mesh from which every fourth was removed, against ranks; every allocation may fail. */
static void OF(run)(const face_list *f, uint64_t *seed)
{
  gmds_soup soup;
  OF(mesh) m;
  gmds_error error = {.status = GMDS_OK};
  failing from = {.until = LONG_MAX};
  const gmds_allocator allocator = failing_allocator(&from);
  gmds_memory own;
  gmds_memory_init(&own, NULL);
  make_soup(f, &own, &soup);
  OF(mesh_init)(&m, &allocator);
  ck_assert_msg(OF(from_soup)(&m, &soup, &error) == GMDS_OK, "%s", error.text);
  gmds_soup_clear(&soup);
  for (gmds_id face = 0; face < OF(end_2)(&m); face++)
    if (random_below(seed, 4) == 0)
      ck_assert_int_eq(OF(remove_face)(&m, face, GMDS_KEEP_EDGES), GMDS_OK);
  gmds_csr nodes;
  gmds_csr_init(&nodes, &own);
  ck_assert_int_eq(OF(all_adj_2_0)(&m, &nodes), GMDS_OK);
  face_list left = new_faces(OF(end_0)(&m), f->n, f->begin[f->n]);
  gmds_id *number = malloc((OF(end_2)(&m) + 1) * sizeof *number);
  for (gmds_id face = 0; face < OF(end_2)(&m); face++) {
    number[face] = (gmds_id)left.n;
    if (OF(has_2)(&m, face))
      put_face(&left, nodes.begin[face + 1] - nodes.begin[face], nodes.data + nodes.begin[face]);
  }
  gmds_csr_clear(&nodes);
  const truth t = find_truth(&left);
  const size_t live = from.live;
  gmds_status status = GMDS_ERR_MEMORY;
  gmds_homology h;
  gmds_homology_init(&h, &own);
  const gmds_homology_options o = {.generators = 1, .clustering = GMDS_BY_RANGES, .ranges = 5, .error = &error};
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    error.text[0] = 0;
    from.until = k;
    status = OF(homology)(&m, &o, &h);
    ck_assert(status == GMDS_OK || (!h.faces && error.text[0]));
    ck_assert_uint_eq(from.live, live);
  }
  ck_assert_msg(status == GMDS_OK, "%s", error.text);
  for (int i = 0; i < 3; i++)
    ck_assert_uint_eq(h.betti[i], t.betti[i]);
  ck_assert_uint_eq(h.vertices, t.vertices);
  ck_assert_uint_eq(h.edges, t.edges);
  ck_assert(are_components(&left, &h.h0));
  ck_assert(are_generators(&left, &h.h1));
  for (size_t k = 0; h.h2.n && k < h.h2.begin[h.h2.n]; k++)
    h.h2.data[k] = number[h.h2.data[k]];
  ck_assert(are_closed(&left, &h.h2));
  gmds_homology_clear(&h);
  from.until = LONG_MAX;
  OF(mesh_clear)(&m);
  free(number);
  free_faces(&left);
}
#undef BODY_CAT_
#undef BODY_CAT
#undef OF
#undef RUN
