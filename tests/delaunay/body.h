/* What the tests ask of a triangulation, in one model: a template like the models themselves. RUN is the prefix. */
#define BODY_CAT_(a, b) a##_##b
#define BODY_CAT(a, b) BODY_CAT_(a, b)
#define OF(name) BODY_CAT(RUN, name)

/* Triangulates, checks every relation, and hands out checksum, counts and triangles (as a soup, may be NULL). */
static gmds_status OF(run)(size_t n, const double *xy, const gmds_delaunay_options *options, outcome *o,
                           gmds_soup *soup)
{
  OF(mesh) m;
  gmds_error error;
  OF(mesh_init)(&m, NULL);
  gmds_delaunay_result_init(&o->result, NULL);
  o->status = OF(delaunay)(&m, n, xy, options, &o->result);
  if (o->status == GMDS_OK) {
    ck_assert_msg(OF(check)(&m, &o->result.memory, &error) == GMDS_OK, "%s", error.text);
    ck_assert_int_eq(OF(checksum)(&m, &o->result.memory, &o->sum), GMDS_OK);
    if (soup)
      ck_assert_int_eq(OF(to_soup)(&m, soup), GMDS_OK);
  }
  o->nodes = OF(count_0)(&m);
  o->edges = OF(count_1)(&m);
  o->faces = OF(count_2)(&m);
  OF(mesh_clear)(&m);
  ck_assert_uint_eq(m.memory.live, 0);
  return o->status;
}
#undef OF
#undef BODY_CAT
#undef BODY_CAT_
#undef RUN
