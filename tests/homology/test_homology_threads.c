/* The homology of a surface does not depend on the number of threads: not one number, not one generator. */
#include "surfaces.h"
#include <gmds/io.h>

static gmds_memory memory;

static void check_same(const gmds_homology *a, const gmds_homology *b)
{
  ck_assert_mem_eq(a, b, offsetof(gmds_homology, h0));
  ck_assert_uint_eq(a->h0.n, b->h0.n);
  ck_assert_uint_eq(a->h1.n, b->h1.n);
  ck_assert_uint_eq(a->h2.n, b->h2.n);
  if (a->h0.n)
    ck_assert_mem_eq(a->h0.data, b->h0.data, a->h0.n * sizeof *a->h0.data);
  if (a->h1.n) {
    ck_assert_mem_eq(a->h1.begin, b->h1.begin, (a->h1.n + 1) * sizeof *a->h1.begin);
    ck_assert_mem_eq(a->h1.data, b->h1.data, a->h1.begin[a->h1.n] * sizeof *a->h1.data);
  }
  if (a->h2.n)
    ck_assert_mem_eq(a->h2.data, b->h2.data, a->h2.begin[a->h2.n] * sizeof *a->h2.data);
}

static void check_threads(const gmds_surface *s, gmds_homology_options o)
{
  static const unsigned threads[] = {2, 3, 4, 8, 31};
  gmds_homology one, more;
  gmds_homology_init(&one, &memory);
  o.generators = 1;
  ck_assert_int_eq(gmds_homology_of(s, &o, &one), GMDS_OK);
  for (size_t k = 0; k < sizeof threads / sizeof *threads; k++) {
    o.threads = threads[k];
    gmds_homology_init(&more, &memory);
    ck_assert_int_eq(gmds_homology_of(s, &o, &more), GMDS_OK);
    check_same(&one, &more);
    gmds_homology_clear(&more);
  }
  gmds_homology_clear(&one);
}

static void check_clusterings(const gmds_surface *s, const uint16_t *labels)
{
  check_threads(s, (gmds_homology_options){.clustering = GMDS_BY_RANGES, .ranges = 1});
  check_threads(s, (gmds_homology_options){.clustering = GMDS_BY_RANGES});
  check_threads(s, (gmds_homology_options){.clustering = GMDS_BY_LABELS, .labels = labels});
}

START_TEST(made_surfaces)
{
  static const char *const specs[] = {"torus:3", "torus:60", "torus:210", "sphere:80"};
  for (size_t k = 0; k < sizeof specs / sizeof *specs; k++) {
    gmds_soup soup;
    gmds_surface one, more;
    gmds_memory_init(&memory, NULL);
    gmds_soup_init(&soup, &memory, 3);
    gmds_surface_init(&one, &memory);
    gmds_surface_init(&more, &memory);
    ck_assert_int_eq(gmds_make_surface(specs[k], NULL, &soup), GMDS_OK);
    uint16_t *labels = malloc(soup.n_points * sizeof *labels);
    ck_assert_int_eq(gmds_grid_labels(soup.n_points, 3, soup.points, 8, 3, labels, NULL), GMDS_OK);
    ck_assert_int_eq(gmds_surface_from_soup(&one, &soup, 1, NULL), GMDS_OK);
    ck_assert_int_eq(gmds_surface_take_soup(&more, &soup, 5, NULL), GMDS_OK);
    ck_assert_mem_eq(one.beta2, more.beta2, one.n_darts * sizeof *one.beta2);
    check_clusterings(&more, labels);
    gmds_surface_clear(&one);
    gmds_surface_clear(&more);
    free(labels);
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

/* Among them many trees whose last edge two threads peel from both ends. */
START_TEST(drawn_surfaces)
{
  uint64_t seed = 21;
  gmds_memory_init(&memory, NULL);
  for (int round = 0; round < 60; round++) {
    const size_t n = 3 + random_below(&seed, 400);
    face_list f = round % 3 ? draw_faces(&seed, n, 2 * n * n / 3 % 3000, 3 + (size_t)round % 3)
                            : make_shape((shape)(round / 3 % N_SHAPES), 3 + (size_t)round % 20, round % 2, 1);
    gmds_surface s;
    gmds_surface_init(&s, &memory);
    ck_assert_int_eq(gmds_surface_from_faces(&s, f.n_vertices, f.n, f.begin, f.nodes, 1 + (unsigned)round % 7, NULL),
                     GMDS_OK);
    uint16_t *labels = malloc((f.n_vertices + 1) * sizeof *labels);
    for (size_t v = 0; v < f.n_vertices; v++)
      labels[v] = (uint16_t)random_below(&seed, 40);
    check_clusterings(&s, labels);
    gmds_surface_clear(&s);
    free(labels);
    free_faces(&f);
  }
}
END_TEST

RUN_SUITE("homology threads", made_surfaces, drawn_surfaces)
