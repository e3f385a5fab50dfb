/* Opens a model of volumes with all algorithms and what the tests ask of them: RUN is the prefix. */
#define GMDS_PREFIX RUN
#include <gmds/mesh.h>
#include <gmds/algorithms/boundary.h>
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/algorithms/relations.h>
#include <gmds/algorithms/renumber.h>
#include <gmds/algorithms/smoothing.h>
enum { GMDS_FN(is_ordered) = GMDS_ORDERED_3_0 };
#include <gmds/end.h>
#define BODY_CAT_(a, b) a##_##b
#define BODY_CAT(a, b) BODY_CAT_(a, b)
#define OF(name) BODY_CAT(RUN, name)

static void OF(begin)(void *m, const gmds_allocator *allocator)
{
  OF(mesh_init)(m, allocator);
}

static void OF(end)(void *m)
{
  OF(mesh_clear)(m);
}

static gmds_status OF(fill)(void *m, const gmds_soup *soup, gmds_error *error)
{
  return OF(from_soup)(m, soup, error);
}

static gmds_status OF(verify)(void *m, gmds_memory *memory, gmds_error *error)
{
  return OF(check)(m, memory, error);
}

static gmds_memory *OF(memory)(void *m)
{
  return OF(mesh_memory)(m);
}

static double *OF(points)(void *m)
{
  return OF(coordinates)(m);
}

static gmds_status OF(bound)(void *m, gmds_csr *faces, gmds_ids *on)
{
  return OF(boundary)(m, faces, on);
}

static gmds_status OF(part)(void *m, gmds_id *component, size_t *count)
{
  return OF(components)(m, component, count);
}

static gmds_status OF(look)(void *m, gmds_volume_report *report)
{
  return OF(manifold)(m, report);
}

static gmds_status OF(measure)(void *m, double *values, double *sizes, gmds_quality *summary)
{
  return OF(quality)(m, values, sizes, summary);
}

static gmds_status OF(relate)(void *m, int i, int j, gmds_complex *cells, gmds_csr *csr)
{
  return OF(relation)(m, i, j, cells, csr);
}

static gmds_status OF(soften)(void *m, size_t sweeps, size_t *moved)
{
  return OF(smooth)(m, sweeps, moved);
}

static gmds_status OF(number)(void *m, gmds_id *const *maps)
{
  return OF(renumber)(m, maps, NULL);
}

static gmds_status OF(list)(const void *m, gmds_soup *soup)
{
  return OF(to_soup)(m, soup, NULL);
}

static gmds_attribute *OF(attribute)(void *m, int i)
{
  gmds_attribute *a = NULL;
  return OF(add_attribute)(m, i, "number", GMDS_ID, 1, &a) == GMDS_OK ? a : OF(find_attribute)(m, i, "number");
}

static size_t OF(end_of)(const void *m, int i)
{
  return i == 0 ? OF(end_0)(m) : i == 1 ? OF(end_1)(m) : i == 2 ? OF(end_2)(m) : OF(end_3)(m);
}

static const subject OF(subject) = {GMDS_TEXT(RUN), sizeof(OF(mesh)), OF(is_ordered), OF(begin),  OF(end),
                                    OF(fill),       OF(verify),       OF(memory),     OF(points), OF(bound),
                                    OF(part),       OF(look),         OF(measure),    OF(relate), OF(soften),
                                    OF(number),     OF(list),         OF(attribute),  OF(end_of)};
#undef OF
#undef BODY_CAT
#undef BODY_CAT_
#undef RUN
