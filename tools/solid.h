/* Reads a soup of volumes into the open model and looks at it: included between <gmds/mesh.h> and <gmds/end.h>. */
#include <gmds/algorithms/components.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>

static gmds_status GMDS_FN(count_components)(mesh *m, size_t *count)
{
  void *block = NULL;
  const size_t n = end_3(m);
  if (!gmds_resize(mesh_memory(m), &block, 0, n, sizeof(gmds_id)))
    return GMDS_ERR_MEMORY;
  gmds_status status = GMDS_FN(components)(m, block, count);
  gmds_release(mesh_memory(m), block, n, sizeof(gmds_id));
  return status;
}

static gmds_status GMDS_FN(look)(mesh *m, const gmds_soup *soup, solid_findings *f, gmds_error *error)
{
  GMDS_TRY(from_soup(m, soup, error));
  GMDS_TRY(check(m, mesh_memory(m), error));
  gmds_status status = GMDS_FN(manifold)(m, &f->report);
  if (status == GMDS_OK)
    status = GMDS_FN(quality)(m, NULL, NULL, &f->measured);
  if (status == GMDS_OK)
    status = GMDS_FN(count_components)(m, &f->components);
  f->nodes = count_0(m);
  return status == GMDS_OK ? status : gmds_fail(error, status, "%s", gmds_status_text(status));
}

static gmds_status GMDS_FN(inspect)(const gmds_soup *soup, solid_findings *f, gmds_error *error)
{
  mesh m;
  mesh_init(&m, NULL);
  gmds_status status = GMDS_FN(look)(&m, soup, f, error);
  mesh_clear(&m);
  return status;
}
