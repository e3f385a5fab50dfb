/* Relations of a whole mesh that go over its sides: each pair of nodes is met once, not once for each face. */
#include "derive.h"
#include <string.h>

/* As many entries as may be; those that are not used are given back. */
static gmds_status begin_rows(size_t n, size_t most, gmds_csr *csr)
{
  void *begin = NULL, *data = NULL;
  if (!gmds_resize(csr->memory, &begin, 0, n + 1, sizeof *csr->begin))
    return GMDS_ERR_MEMORY;
  csr->begin = begin;
  csr->n = n;
  csr->begin[0] = 0;
  if (!gmds_resize(csr->memory, &data, 0, most, sizeof *csr->data))
    return GMDS_ERR_MEMORY;
  csr->data = data;
  csr->capacity = most;
  return GMDS_OK;
}

static void end_rows(gmds_csr *csr)
{
  void *data = csr->data;
  size_t used = csr->begin[csr->n];
  if (gmds_resize(csr->memory, &data, csr->capacity, used, sizeof *csr->data)) {
    csr->data = data;
    csr->capacity = used;
  }
}

/* 2 -> 2: the other faces on the sides of each, once where they share several. */
static gmds_status faces_beyond(derived *d, gmds_csr *csr)
{
  const gmds_cells *faces = &d->from->cells[2];
  gmds_csr on;
  size_t most = 0, used = 0;
  void *block = NULL; /* for each face the last one that it was met from */
  gmds_csr_init(&on, d->memory);
  gmds_status status = derive_faces_of_groups(d, &on);
  if (status == GMDS_OK && !gmds_resize(d->memory, &block, 0, faces->end, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  gmds_id *met = block;
  if (met)
    memset(met, 0xff, faces->end * sizeof *met);
  for (size_t g = 0; status == GMDS_OK && g < on.n; g++)
    most += (on.begin[g + 1] - on.begin[g]) * (on.begin[g + 1] - on.begin[g] - (on.begin[g + 1] > on.begin[g]));
  if (status == GMDS_OK)
    status = begin_rows(faces->end, most, csr);
  for (gmds_id f = 0; status == GMDS_OK && f < faces->end; f++) {
    size_t n = 0, base = view_base(&d->nodes, f);
    if (gmds_bits_get(&faces->alive, f))
      view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++)
      for (size_t i = on.begin[d->group[base + k]]; i < on.begin[d->group[base + k] + 1]; i++) {
        gmds_id x = on.data[i];
        if (x != f && met[x] != f) {
          met[x] = f;
          csr->data[used++] = x;
        }
      }
    csr->begin[f + 1] = used;
  }
  gmds_release(d->memory, met, met ? faces->end : 0, sizeof *met);
  gmds_csr_clear(&on);
  return status;
}

/* 2 -> 1: the edges of each, side by side. */
static gmds_status edges_of_faces(derived *d, gmds_csr *csr)
{
  const gmds_cells *faces = &d->from->cells[2];
  size_t used = 0;
  GMDS_TRY(derive_edges_of_sides(d));
  GMDS_TRY(begin_rows(faces->end, d->n_sides, csr));
  for (gmds_id f = 0; f < faces->end; f++) {
    size_t n = 0;
    if (gmds_bits_get(&faces->alive, f))
      view_row(&d->nodes, f, &n);
    for (size_t k = 0; k < n; k++)
      csr->data[used++] = side_edge(d, f, k);
    csr->begin[f + 1] = used;
  }
  return GMDS_OK;
}

/* 1 -> 2: the faces on the nodes of each edge. */
static gmds_status faces_of_edges(derived *d, gmds_csr *csr)
{
  const gmds_cells *edges = &d->from->cells[1];
  gmds_csr on;
  size_t used = 0;
  gmds_csr_init(&on, d->memory);
  gmds_status status = derive_faces_of_groups(d, &on);
  if (status == GMDS_OK)
    status = begin_rows(edges->end, on.begin[on.n], csr);
  for (gmds_id e = 0; status == GMDS_OK && e < edges->end; e++) {
    gmds_id g = d->group[d->n_sides + e];
    for (size_t i = g == GMDS_NONE ? 0 : on.begin[g]; g != GMDS_NONE && i < on.begin[g + 1]; i++)
      csr->data[used++] = on.data[i];
    csr->begin[e + 1] = used;
  }
  gmds_csr_clear(&on);
  return status;
}

/* 0 -> 0: the nodes before and after each in the faces on it, once. `met` has an entry for each node. */
static void enter_neighbours(const derived *d, const view *faces_of_node, gmds_id *met, gmds_csr *csr)
{
  size_t used = 0;
  for (gmds_id v = 0; v < csr->n; v++) {
    size_t n_faces = 0;
    const gmds_id *around = view_row(faces_of_node, v, &n_faces);
    for (size_t i = 0; i < n_faces; i++) {
      size_t n = 0, k = 0;
      const gmds_id *nodes = view_row(&d->nodes, around[i], &n);
      while (nodes[k] != v)
        k++;
      gmds_id pair[2] = {nodes[k + 1 < n ? k + 1 : 0], nodes[k ? k - 1 : n - 1]};
      for (int q = 0; q < 2; q++)
        if (met[pair[q]] != v) {
          met[pair[q]] = v;
          csr->data[used++] = pair[q];
        }
    }
    csr->begin[v + 1] = used;
  }
}

static gmds_status joined_nodes(derived *d, gmds_csr *csr)
{
  size_t n = d->from->cells[0].end, most = 0;
  view faces_of_node = {.csr = {.memory = d->memory}};
  void *met = NULL;
  GMDS_TRY(derive_nodes_of_faces(d));
  gmds_status status = GMDS_OK;
  if (derive_stores(d, 0, 2))
    faces_of_node = derive_stored(d, 0, 2);
  else
    status = derive_inverse(d, 2, &d->nodes, n, &faces_of_node.csr);
  for (gmds_id v = 0; status == GMDS_OK && v < n; v++) {
    size_t n_faces = 0;
    view_row(&faces_of_node, v, &n_faces);
    most += 2 * n_faces;
  }
  if (status == GMDS_OK)
    status = begin_rows(n, most, csr);
  if (status == GMDS_OK && !gmds_resize(d->memory, &met, 0, n, sizeof(gmds_id)))
    status = GMDS_ERR_MEMORY;
  if (status == GMDS_OK) {
    if (n)
      memset(met, 0xff, n * sizeof(gmds_id));
    enter_neighbours(d, &faces_of_node, met, csr);
  }
  gmds_release(d->memory, met, met ? n : 0, sizeof(gmds_id));
  gmds_csr_clear(&faces_of_node.csr);
  return status;
}

gmds_status gmds_parts_over_sides(const gmds_parts *parts, int i, int j, gmds_csr *csr)
{
  derived d;
  derive_begin(&d, parts, csr->memory, NULL);
  gmds_status status = GMDS_OK;
  if (i == 0)
    status = joined_nodes(&d, csr);
  else if (i == 1)
    status = faces_of_edges(&d, csr);
  else
    status = j == 1 ? edges_of_faces(&d, csr) : faces_beyond(&d, csr);
  derive_end(&d);
  if (status == GMDS_OK)
    end_rows(csr);
  else
    gmds_csr_clear(csr);
  return status;
}
