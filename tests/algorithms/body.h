/* What the tests ask of the algorithms in one model: a template like the models themselves. RUN is the prefix. */
#define BODY_CAT_(a, b) a##_##b
#define BODY_CAT(a, b) BODY_CAT_(a, b)
#define OF(name) BODY_CAT(RUN, name)

/* The nine relations of a small mesh, each against brute force; only that they are built where `compare` is 0. */
static gmds_status OF(relate)(OF(mesh) * m, int compare)
{
  gmds_complex cells;
  gmds_complex_init(&cells, &m->memory, 0);
  gmds_status status = GMDS_OK;
  for (int ij = 0; ij < 9 && status == GMDS_OK; ij++) {
    gmds_csr csr;
    gmds_csr_init(&csr, &m->memory);
    status = OF(relation)(m, ij / 3, ij % 3, &cells, &csr);
    if (status == GMDS_OK && compare)
      brute_check_relation(NULL, &cells, ij / 3, ij % 3, &csr);
    gmds_csr_clear(&csr);
  }
  gmds_complex_clear(&cells);
  return status;
}

/* Renumbers a mesh: the maps are one to one, coordinates, attributes and the nodes of faces go along. */
static void OF(renumber_all)(OF(mesh) * m, failing *from, int inject)
{
  const size_t end[3] = {OF(end_0)(m), OF(end_1)(m), OF(end_2)(m)};
  gmds_id *maps[3];
  gmds_csr before, after;
  gmds_memory own;
  gmds_memory_init(&own, NULL);
  gmds_csr_init(&before, &own);
  gmds_csr_init(&after, &own);
  double *old = malloc((2 * end[0] + 1) * sizeof *old);
  if (end[0])
    memcpy(old, m->points, 2 * end[0] * sizeof *old);
  ck_assert_int_eq(OF(all_adj_2_0)(m, &before), GMDS_OK);
  for (int i = 0; i < 3; i++) {
    gmds_attribute *a = NULL;
    ck_assert_int_eq(OF(add_attribute)(m, i, "number", GMDS_ID, 1, &a), GMDS_OK);
    maps[i] = malloc((end[i] + 1) * sizeof *maps[i]);
    for (size_t c = 0; c < end[i]; c++)
      ((gmds_id *)a->data)[c] = (gmds_id)c + 1;
  }
  const size_t live = from->live;
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from->until = k;
    status = OF(renumber)(m, maps, NULL);
    ck_assert(status == GMDS_OK || (from->live == live && m->memory.live == live));
  }
  from->until = LONG_MAX;
  ck_assert_int_eq(status, GMDS_OK);
  ck_assert_uint_eq(from->live, m->memory.live);
  ck_assert_int_eq(OF(check)(m, &own, NULL), GMDS_OK);
  ck_assert_int_eq(OF(all_adj_2_0)(m, &after), GMDS_OK);
  for (int i = 0; i < 3; i++)
    check_numbers(OF(find_attribute)(m, i, "number")->data, maps[i], end[i]);
  for (size_t v = 0; v < end[0]; v++)
    ck_assert(memcmp(old + 2 * v, m->points + 2 * maps[0][v], 2 * sizeof *old) == 0);
  check_faces(&before, &after, maps, end[2], OF(is_ordered));
  gmds_csr_clear(&before);
  gmds_csr_clear(&after);
  for (int i = 0; i < 3; i++)
    free(maps[i]);
  free(old);
}

/* Runs the algorithms on the faces of a soup and keeps what they give in `o`, whose memory does not fail; `from` is the
 * allocator of the mesh: with `inject` each call is repeated with one more allocation granted until it succeeds. */
static void OF(run)(const gmds_soup *soup, int inject, outcome *o)
{
  OF(mesh) m;
  gmds_error error = {0};
  failing from = {.until = LONG_MAX};
  gmds_allocator allocator = failing_allocator(&from);
  OF(mesh_init)(&m, &allocator);
  ck_assert_msg(OF(from_soup)(&m, soup, &error) == GMDS_OK, "%s", error.text);
  size_t live = m.memory.live;
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(boundary)(&m, &o->chains, &o->open);
    ck_assert(status == GMDS_OK || !o->chains.begin);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  status = GMDS_ERR_MEMORY;
  o->component = calloc(soup->n_cells + 1, sizeof *o->component);
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(components)(&m, o->component, &o->count);
    ck_assert(status == GMDS_OK || !o->component[0]);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  status = GMDS_ERR_MEMORY;
  o->ordered = OF(is_ordered);
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(manifold)(&m, &o->report);
    ck_assert(status == GMDS_OK || !o->report.faces);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  status = GMDS_ERR_MEMORY;
  o->values = calloc(2 * soup->n_cells + 2, sizeof *o->values);
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(quality)(&m, o->values, o->values + soup->n_cells, &o->summary);
    ck_assert(status == GMDS_OK || !o->summary.cells);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  status = GMDS_ERR_MEMORY;
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(relate)(&m, soup->n_cells < 60 && !inject);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  status = GMDS_ERR_MEMORY;
  for (long k = inject ? 0 : LONG_MAX - 1; status == GMDS_ERR_MEMORY; k++) {
    from.until = k;
    status = OF(smooth)(&m, SWEEPS, &o->moved);
    ck_assert(status == GMDS_OK || memcmp(m.points, soup->points, 2 * soup->n_points * sizeof(double)) == 0);
    ck_assert_uint_eq(m.memory.live, live);
  }
  ck_assert_int_eq(status, GMDS_OK);
  from.until = LONG_MAX;
  o->points = malloc((2 * soup->n_points + 1) * sizeof *o->points);
  if (soup->n_points)
    memcpy(o->points, m.points, 2 * soup->n_points * sizeof *o->points);
  ck_assert_msg(OF(check)(&m, &o->memory, &error) == GMDS_OK, "%s", error.text);
  if (inject || soup->n_cells < 60)
    OF(renumber_all)(&m, &from, inject);
  OF(mesh_clear)(&m);
  ck_assert_uint_eq(from.live, 0);
}
#undef OF
#undef BODY_CAT
#undef BODY_CAT_
#undef RUN
