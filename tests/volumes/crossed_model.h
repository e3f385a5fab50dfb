/* Opens a named model of volumes (NAMED) with what test_crossed.c asks of it: RUN is the prefix, SIMPLICES says that it
 * holds tetrahedra alone. */
#define GMDS_PREFIX RUN
#if defined SIMPLICES
#  define GMDS_REGIONS TETRAHEDRON
#else
#  define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON)
#endif
#define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#include NAMED
#include <gmds/algorithms/manifold.h>
enum { GMDS_FN(compares) = GMDS__MAKES_FACES || GMDS__S_3_3 };
#if GMDS__MAKES_FACES
#  define HAS_FACES 1
#else
#  define HAS_FACES 0
#endif
#include <gmds/end.h>
#define MODEL_CAT_(a, b) a##_##b
#define MODEL_CAT(a, b) MODEL_CAT_(a, b)
#define OF(name) MODEL_CAT(RUN, name)

static void OF(begin)(void *m)
{
  (void)OF(mesh_init)(m, NULL);
}

static void OF(end)(void *m)
{
  OF(mesh_clear)(m);
}

static gmds_status OF(put_node)(void *m, const double *x, gmds_id *id)
{
  return OF(add_node)(m, x, id);
}

#if HAS_FACES
static gmds_status OF(put_face)(void *m, size_t n, const gmds_id *nodes, gmds_id *id)
{
  return OF(add_face)(m, n, nodes, id);
}
#endif

static gmds_status OF(put_region)(void *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id)
{
  return OF(add_region)(m, type, nodes, id);
}

static gmds_status OF(drop_regions)(void *m, const gmds_ids *regions)
{
  return OF(remove_regions)(m, regions, GMDS_KEEP_BARE);
}

static gmds_status OF(fill)(void *m, const gmds_soup *soup, gmds_error *error)
{
  return OF(from_soup)(m, soup, error);
}

static gmds_status OF(list)(void *m, gmds_soup *soup, gmds_error *error)
{
  return OF(to_soup)(m, soup, error);
}

static gmds_status OF(verify)(void *m, gmds_memory *counted, gmds_error *error)
{
  return OF(check)(m, counted, error);
}

static gmds_status OF(look)(void *m, gmds_volume_report *report)
{
  return OF(manifold)(m, report);
}

static size_t OF(count)(void *m, int i)
{
  return i == 0 ? OF(count_0)(m) : i == 1 ? OF(count_1)(m) : i == 2 ? OF(count_2)(m) : OF(count_3)(m);
}

static const subject OF(subject) = {.name = GMDS_TEXT(RUN),
                                    .bytes = sizeof(OF(mesh)),
                                    .begin = OF(begin),
                                    .end = OF(end),
                                    .add_node = OF(put_node),
#if HAS_FACES
                                    .add_face = OF(put_face),
#endif
                                    .add_region = OF(put_region),
                                    .remove = OF(drop_regions),
                                    .fill = OF(fill),
                                    .list = OF(list),
                                    .verify = OF(verify),
                                    .look = OF(look),
                                    .count = OF(count),
                                    .compares = OF(compares)};
#undef HAS_FACES
#undef OF
#undef MODEL_CAT
#undef MODEL_CAT_
#undef NAMED
#undef SIMPLICES
#undef RUN
