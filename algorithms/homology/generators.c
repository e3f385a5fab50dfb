/* Generators as a file shows them. */
#include <gmds/homology.h>
#include <string.h>

/* Room in an empty soup for the points of a surface and all cells of its generators. */
static gmds_status reserve_generators(const gmds_surface *s, const gmds_homology *h, gmds_soup *soup)
{
  size_t segments = 0, faces = 0, corners = 0;
  for (size_t k = 0; k < h->h1.n; k++)
    segments += h->h1.begin[k + 1] - h->h1.begin[k];
  for (size_t k = 0; k < h->h2.n; k++)
    for (size_t i = h->h2.begin[k]; i < h->h2.begin[k + 1]; i++) {
      faces++;
      corners += gmds_surface_first(s, h->h2.data[i] + 1) - gmds_surface_first(s, h->h2.data[i]);
    }
  return gmds_soup_reserve(soup, s->n_vertices, h->h0.n + segments + faces, h->h0.n + 2 * segments + corners);
}

static gmds_status add_face(const gmds_surface *s, gmds_id f, gmds_soup *soup)
{
  const gmds_id first = gmds_surface_first(s, f);
  const size_t n = gmds_surface_first(s, (size_t)f + 1) - first;
  const gmds_cell_type type = n == 3 ? GMDS_TRIANGLE : n == 4 ? GMDS_QUADRILATERAL : GMDS_POLYGON;
  return gmds_soup_add_cell(soup, type, n, s->origin + first);
}

/* The edges of a closed chain. */
static gmds_status add_chain(size_t n, const gmds_id *vertices, gmds_soup *soup)
{
  for (size_t k = 0; k < n; k++) {
    const gmds_id ends[2] = {vertices[k], vertices[k + 1 < n ? k + 1 : 0]};
    GMDS_TRY(gmds_soup_add_cell(soup, GMDS_SEGMENT, 2, ends));
  }
  return GMDS_OK;
}

/* The cells of generator k of dimension i. */
static gmds_status add_generator(const gmds_surface *s, const gmds_homology *h, int i, size_t k, gmds_soup *soup)
{
  if (i == 0)
    return gmds_soup_add_cell(soup, GMDS_VERTEX, 1, h->h0.data + k);
  if (i == 1)
    return add_chain(h->h1.begin[k + 1] - h->h1.begin[k], h->h1.data + h->h1.begin[k], soup);
  for (size_t at = h->h2.begin[k]; at < h->h2.begin[k + 1]; at++)
    GMDS_TRY(add_face(s, h->h2.data[at], soup));
  return GMDS_OK;
}

static gmds_status add_generators(const gmds_surface *s, const gmds_homology *h, const double *points, gmds_soup *soup)
{
  const size_t rows[3] = {h->h0.n, h->h1.n, h->h2.n};
  gmds_attribute *dimension = NULL, *generator = NULL;
  GMDS_TRY(reserve_generators(s, h, soup));
  for (size_t v = 0; v < s->n_vertices; v++)
    GMDS_TRY(gmds_soup_add_point(soup, points + 3 * v));
  GMDS_TRY(gmds_soup_add_attribute(soup, GMDS_OF_CELLS, "dimension", GMDS_INT, 1, &dimension));
  GMDS_TRY(gmds_soup_add_attribute(soup, GMDS_OF_CELLS, "generator", GMDS_INT, 1, &generator));
  for (int i = 0; i < 3; i++)
    for (size_t k = 0; k < rows[i]; k++) {
      const size_t first = soup->n_cells;
      GMDS_TRY(add_generator(s, h, i, k, soup));
      for (size_t c = first; c < soup->n_cells; c++) {
        ((int *)dimension->data)[c] = i;
        ((int *)generator->data)[c] = (int)k;
      }
    }
  return GMDS_OK;
}

gmds_status gmds_homology_to_soup(const gmds_surface *surface, const gmds_homology *homology, const double *points,
                                  gmds_soup *soup)
{
  gmds_soup made;
  if (soup->n_points || soup->n_cells || soup->dim != 3)
    return GMDS_ERR_ARGUMENT;
  gmds_soup_init(&made, soup->memory, 3);
  gmds_status status = add_generators(surface, homology, points, &made);
  if (status != GMDS_OK) {
    gmds_soup_clear(&made);
    return status;
  }
  gmds_soup_clear(soup);
  *soup = made;
  return GMDS_OK;
}
