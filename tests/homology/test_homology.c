/* Surfaces, and their homology against ranks of boundary matrices. */
#include "surfaces.h"
#include <gmds/io.h>
#include <gmds/threads.h>
#include <limits.h>
#include <math.h>

static gmds_memory memory;

static void begin(void)
{
  gmds_memory_init(&memory, NULL);
}

static gmds_surface surface_of(const face_list *f)
{
  gmds_surface s;
  gmds_surface_init(&s, &memory);
  ck_assert_int_eq(gmds_surface_from_faces(&s, f->n_vertices, f->n, f->begin, f->nodes, 1, NULL), GMDS_OK);
  return s;
}

static void check_surface(const face_list *f, const gmds_surface *s, const truth *t)
{
  char *met = calloc(f->n + 1, 1);
  ck_assert_uint_eq(s->n_faces, f->n);
  ck_assert_uint_eq(s->n_darts, f->begin[f->n]);
  ck_assert_uint_eq(s->n_edges, t->edges);
  ck_assert_uint_eq(s->n_border, t->border);
  gmds_id d = 0;
  for (gmds_id face = 0; face < f->n; face++) {
    const gmds_id listed = gmds_surface_listed(s, face), first = d;
    ck_assert(!met[listed]);
    met[listed] = 1;
    ck_assert_uint_eq(gmds_surface_first(s, face), first);
    for (size_t i = f->begin[listed]; i < f->begin[listed + 1]; i++, d++) {
      const gmds_id e = s->beta2[d], next = gmds_surface_beta1(s, d);
      ck_assert_uint_eq(gmds_surface_face(s, d), face);
      ck_assert_uint_eq(s->origin[d], f->nodes[i]);
      ck_assert_uint_eq(next, i + 1 < f->begin[listed + 1] ? d + 1 : first);
      if (e == GMDS_NONE)
        continue;
      const gmds_id from = s->origin[e], to = s->origin[gmds_surface_beta1(s, e)], a = s->origin[d],
                    b = s->origin[next];
      ck_assert(e != d && s->beta2[e] == d);
      ck_assert((from == a && to == b) || (from == b && to == a));
    }
  }
  free(met);
}

static void check_homology(const face_list *f, const truth *t, const gmds_homology *h)
{
  ck_assert_uint_eq(h->vertices, t->vertices);
  ck_assert_uint_eq(h->edges, t->edges);
  ck_assert_uint_eq(h->faces, f->n);
  ck_assert_uint_eq(h->components, t->betti[0]);
  ck_assert_int_eq(h->closed, t->border == 0);
  ck_assert_int_eq(h->orientable, t->orientable);
  for (int i = 0; i < 3; i++)
    ck_assert_uint_eq(h->betti[i], t->betti[i]);
  ck_assert_uint_eq(h->inner + h->critical + h->border, f->n - t->betti[2]);
  ck_assert_uint_eq(h->dangling + h->contracted, t->vertices - t->betti[0]);
  ck_assert_uint_eq(h->h0.n, t->betti[0]);
  ck_assert_uint_eq(h->h1.n, t->betti[1]);
  ck_assert_uint_eq(h->h2.n, t->betti[2]);
  ck_assert(are_components(f, &h->h0));
  ck_assert(are_generators(f, &h->h1));
  ck_assert(are_closed(f, &h->h2));
}

/* All ways to cluster, the labels drawn. */
static void check_faces(const face_list *f, uint64_t *seed)
{
  gmds_surface s = surface_of(f);
  const truth t = find_truth(f);
  uint16_t *labels = malloc((f->n_vertices + 1) * sizeof *labels);
  check_surface(f, &s, &t);
  for (int way = 0; way < 6; way++) {
    static const unsigned ranges[] = {1, 1, 2, 7, 300, 0};
    gmds_homology_options o = {
        .threads = 1 + (unsigned)way % 3, .ranges = ranges[way], .labels = labels, .generators = 1};
    o.clustering = way == 5 ? GMDS_BY_LABELS : GMDS_BY_RANGES;
    for (size_t v = 0; v < f->n_vertices; v++)
      labels[v] = (uint16_t)random_below(seed, 5);
    gmds_homology h;
    gmds_homology_init(&h, &memory);
    ck_assert_int_eq(gmds_homology_of(&s, &o, &h), GMDS_OK);
    for (size_t k = 0; h.h2.n && k < h.h2.begin[h.h2.n]; k++)
      h.h2.data[k] = gmds_surface_listed(&s, h.h2.data[k]);
    check_homology(f, &t, &h);
    if (way < 2)
      ck_assert_uint_eq(h.critical, 0);
    gmds_homology_clear(&h);
  }
  free(labels);
  gmds_surface_clear(&s);
  ck_assert_uint_eq(memory.live, 0);
}

START_TEST(quotients_of_a_grid_have_their_homology)
{
  uint64_t seed = 11;
  begin();
  for (int k = 0; k < N_SHAPES; k++)
    for (size_t n = 3; n < 8; n++)
      for (int how = 0; how < 3; how++) {
        face_list f = make_shape((shape)k, n, how > 0 && k != PROJECTIVE, how > 1); /* cut, its corners would meet */
        const truth t = find_truth(&f);
        for (int i = 0; i < 3; i++)
          ck_assert_uint_eq(t.betti[i], betti_of_shape[k][i]);
        ck_assert_int_eq(t.orientable, k != MOEBIUS && k != KLEIN && k != PROJECTIVE);
        check_faces(&f, &seed);
        free_faces(&f);
      }
}
END_TEST

START_TEST(drawn_faces_have_the_homology_of_their_boundary_matrices)
{
  uint64_t seed = 12;
  size_t pinched = 0, most_generators = 0;
  begin();
  for (int round = 0; round < 400; round++) {
    face_list f = draw_faces(&seed, 4 + random_below(&seed, 20), random_below(&seed, 90), 3 + (size_t)round % 4);
    const truth t = find_truth(&f);
    pinched += t.betti[2] > 0;
    most_generators = t.betti[1] > most_generators ? t.betti[1] : most_generators;
    check_faces(&f, &seed);
    free_faces(&f);
  }
  ck_assert_uint_ge(pinched, 20); /* the draw is worth something */
  ck_assert_uint_ge(most_generators, 10);
}
END_TEST

/* Faces in random order are sorted, and nothing else changes. */
START_TEST(scattered_faces_are_sorted)
{
  uint64_t seed = 15;
  begin();
  for (int k = 0; k < N_SHAPES; k++) {
    face_list f = make_shape((shape)k, 9, k % 2 && k != PROJECTIVE, 0), g = new_faces(f.n_vertices, f.n, f.begin[f.n]);
    size_t order[200];
    for (size_t i = 0; i < f.n; i++) {
      const size_t at = random_below(&seed, i + 1);
      order[i] = order[at];
      order[at] = i;
    }
    for (size_t i = 0; i < f.n; i++)
      put_face(&g, f.begin[order[i] + 1] - f.begin[order[i]], f.nodes + f.begin[order[i]]);
    gmds_surface in_order = surface_of(&f), s = surface_of(&g);
    ck_assert(!in_order.listed || k >= PROJECTIVE); /* the rims of those have numbers far off */
    ck_assert_ptr_nonnull(s.listed);
    for (gmds_id face = 0, last = 0; face < s.n_faces; face++) {
      gmds_id low = GMDS_NONE;
      for (gmds_id d = gmds_surface_first(&s, face); d < gmds_surface_first(&s, face + 1); d++)
        low = s.origin[d] < low ? s.origin[d] : low;
      ck_assert_uint_ge(low, last);
      last = low;
    }
    gmds_surface_clear(&in_order);
    gmds_surface_clear(&s);
    check_faces(&g, &seed);
    free_faces(&f);
    free_faces(&g);
  }
}
END_TEST

START_TEST(what_is_no_surface_is_refused_with_its_place)
{
  static const gmds_id book[] = {0, 1, 2, 1, 0, 3, 0, 1, 4}, twice[] = {0, 1, 2, 2, 3, 3},
                       beyond[] = {0, 1, 2, 1, 2, 9};
  static const size_t rows[] = {0, 3, 6, 9}, digon[] = {0, 3, 5};
  gmds_surface s;
  gmds_error error;
  begin();
  gmds_surface_init(&s, &memory);
  ck_assert_int_eq(gmds_surface_from_faces(&s, 5, 3, rows, book, 1, &error), GMDS_ERR_CONFLICT);
  ck_assert_ptr_nonnull(strstr(error.text, "third on the edge of vertices 0 and 1"));
  ck_assert_int_eq(gmds_surface_from_faces(&s, 5, 3, NULL, book, 2, &error), GMDS_ERR_CONFLICT);
  ck_assert_int_eq(gmds_surface_from_faces(&s, 4, 2, rows, twice, 1, &error), GMDS_ERR_ARGUMENT);
  ck_assert_str_eq(error.text, "face 1 has vertex 3 twice in a row");
  ck_assert_int_eq(gmds_surface_from_faces(&s, 9, 2, rows, beyond, 1, &error), GMDS_ERR_CELL);
  ck_assert_str_eq(error.text, "face 1 has vertex 9, but there are 9");
  ck_assert_int_eq(gmds_surface_from_faces(&s, 9, 2, digon, book, 1, &error), GMDS_ERR_ARGUMENT);
  ck_assert_str_eq(error.text, "face 1 has fewer than three vertices");
  ck_assert_int_eq(gmds_surface_from_faces(&s, 9, 1, NULL, book, 0, &error), GMDS_ERR_ARGUMENT);
  ck_assert_uint_eq(s.n_faces, 0);
  ck_assert_uint_eq(memory.live, 0);

  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 3);
  const double x[3] = {0, 0, 0};
  for (int k = 0; k < 5; k++)
    ck_assert_int_eq(gmds_soup_add_point(&soup, x), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TRIANGLE, 3, book), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_TETRAHEDRON, 4, book + 5), GMDS_OK);
  ck_assert_int_eq(gmds_surface_from_soup(&s, &soup, 1, &error), GMDS_ERR_UNSUPPORTED);
  ck_assert_str_eq(error.text, "cell 1 is a tetrahedron: a surface has faces only");
  ck_assert_int_eq(gmds_surface_take_soup(&s, &soup, 1, &error), GMDS_ERR_UNSUPPORTED);
  ck_assert_uint_eq(soup.n_cells, 0);
  ck_assert_uint_eq(memory.live, 0);
}
END_TEST

START_TEST(options_out_of_range_are_refused)
{
  face_list f = make_shape(TORUS, 4, 1, 0);
  gmds_homology h;
  gmds_error error = {.status = GMDS_OK};
  begin();
  gmds_surface s = surface_of(&f);
  const gmds_homology_options wrong[] = {{.threads = GMDS_MAX_THREADS + 1, .error = &error},
                                         {.clustering = GMDS_BY_RANGES, .ranges = 65537, .error = &error},
                                         {.clustering = GMDS_BY_LABELS, .error = &error},
                                         {.clustering = (gmds_clustering)2, .error = &error}};
  gmds_homology_init(&h, &memory);
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    error.text[0] = 0;
    ck_assert_int_eq(gmds_homology_of(&s, &wrong[k], &h), GMDS_ERR_ARGUMENT);
    ck_assert(error.text[0] && !h.faces);
  }
  ck_assert_int_eq(gmds_homology_of(&s, NULL, &h), GMDS_OK);
  ck_assert_uint_eq(h.betti[1], 2);
  ck_assert_uint_eq(h.h1.n, 0);
  gmds_homology_clear(&h);
  gmds_surface_clear(&s);
  free_faces(&f);
}
END_TEST

START_TEST(grid_labels_are_the_boxes_of_points)
{
  uint64_t seed = 13;
  enum { N = 500 };
  double x[3 * N];
  uint16_t labels[N], again[N];
  gmds_error error;
  for (int dim = 2; dim <= 3; dim++)
    for (unsigned boxes = 1; boxes < 10; boxes++) {
      for (int k = 0; k < 3 * N; k++)
        x[k] = (double)random_below(&seed, 2 * boxes + 1) / 2; /* the box of x is the floor of x, but for the last */
      for (int k = 0; k < dim; k++) {
        x[k] = 0;
        x[dim + k] = boxes;
      }
      ck_assert_int_eq(gmds_grid_labels(N, dim, x, boxes, 1, labels, NULL), GMDS_OK);
      ck_assert_int_eq(gmds_grid_labels(N, dim, x, boxes, 3, again, NULL), GMDS_OK);
      ck_assert_mem_eq(labels, again, sizeof labels);
      for (int v = 0; v < N; v++) {
        unsigned label = 0;
        for (int k = dim; k-- > 0;) {
          const double here = x[v * dim + k];
          label = label * boxes + (here < boxes ? (unsigned)here : boxes - 1);
        }
        ck_assert_uint_eq(labels[v], label);
      }
    }
  for (int k = 0; k < 3 * N; k++) /* points of no extent, and of too large a one */
    x[k] = k % 3 == 0 ? 1 : k % 2 ? 1.7e308 : -1.7e308;
  ck_assert_int_eq(gmds_grid_labels(N, 3, x, 0, 1, labels, NULL), GMDS_OK);
  for (int v = 0; v < N; v++)
    ck_assert_uint_lt(labels[v], 512);
  ck_assert_int_eq(gmds_grid_labels(N, 3, x, 41, 1, labels, &error), GMDS_ERR_ARGUMENT);
  ck_assert_int_eq(gmds_grid_labels(N, 4, x, 8, 1, labels, &error), GMDS_ERR_ARGUMENT);
  x[4] = (double)NAN;
  ck_assert_int_eq(gmds_grid_labels(N, 3, x, 8, 1, labels, &error), GMDS_ERR_ARGUMENT);
  ck_assert_str_eq(error.text, "point 1 has a coordinate that is not a finite number");
}
END_TEST

START_TEST(no_memory_leaves_nothing_behind)
{
  failing from = {.until = LONG_MAX};
  const gmds_allocator allocator = failing_allocator(&from);
  uint64_t seed = 14;
  size_t failures = 0;
  for (int round = 0; round < 12; round++) {
    face_list f =
        round < 6 ? make_shape((shape)round, 4, round % 2, 1) : draw_faces(&seed, 14, 40, 3 + (size_t)round % 3);
    uint16_t labels[64] = {0, 1, 2, 3, 0, 1, 2, 3};
    gmds_status status = GMDS_ERR_MEMORY;
    gmds_memory_init(&memory, &allocator);
    for (long k = 0; status == GMDS_ERR_MEMORY; k++, failures++) {
      gmds_surface s;
      gmds_homology h;
      gmds_error error = {.status = GMDS_OK};
      const gmds_homology_options o = {.threads = 1 + (unsigned)round % 3,
                                       .clustering = round % 3 == 2 ? GMDS_BY_LABELS : GMDS_BY_RANGES,
                                       .ranges = (unsigned)round % 3,
                                       .labels = labels,
                                       .generators = 1,
                                       .error = &error};
      from.until = k;
      gmds_surface_init(&s, &memory);
      gmds_homology_init(&h, &memory);
      status = gmds_surface_from_faces(&s, f.n_vertices, f.n, f.begin, f.nodes, o.threads, &error);
      ck_assert(status == GMDS_OK || !s.n_darts);
      if (status == GMDS_OK)
        status = gmds_homology_of(&s, &o, &h);
      ck_assert(status == GMDS_OK || (!h.faces && !h.h1.n && error.text[0]));
      gmds_soup soup;
      gmds_soup_init(&soup, &memory, 3);
      double *points = calloc(3 * f.n_vertices + 1, sizeof *points);
      if (status == GMDS_OK)
        status = gmds_homology_to_soup(&s, &h, points, &soup);
      ck_assert(status == GMDS_OK || !soup.n_points);
      free(points);
      gmds_soup_clear(&soup);
      gmds_homology_clear(&h);
      gmds_surface_clear(&s);
      ck_assert_uint_eq(memory.live, 0);
    }
    ck_assert_int_eq(status, GMDS_OK);
    free_faces(&f);
  }
  ck_assert_uint_ge(failures, 100);
}
END_TEST

START_TEST(made_surfaces_are_what_they_are_called)
{
  begin();
  static const struct {
    const char *spec;
    size_t vertices, faces, b1;
  } made[] = {{"torus:3", 9, 18, 2},
              {"torus:10", 100, 200, 2},
              {"torus:40", 1600, 3200, 2},
              {"sphere:2", 6, 8, 0},
              {"sphere:9", 146, 288, 0}};
  for (size_t k = 0; k < sizeof made / sizeof *made; k++) {
    gmds_soup soup;
    gmds_surface s;
    gmds_homology h;
    gmds_soup_init(&soup, &memory, 3);
    gmds_surface_init(&s, &memory);
    gmds_homology_init(&h, &memory);
    ck_assert_int_eq(gmds_make_surface(made[k].spec, NULL, &soup), GMDS_OK);
    double volume = 0; /* six times it: positive where faces are turned outwards */
    for (size_t c = 0; c < soup.n_cells; c++) {
      const double *a = soup.points + 3 * soup.corners[3 * c], *b = soup.points + 3 * soup.corners[3 * c + 1],
                   *d = soup.points + 3 * soup.corners[3 * c + 2];
      volume +=
          a[0] * (b[1] * d[2] - b[2] * d[1]) - a[1] * (b[0] * d[2] - b[2] * d[0]) + a[2] * (b[0] * d[1] - b[1] * d[0]);
    }
    ck_assert_double_gt(volume, 0);
    ck_assert_int_eq(gmds_surface_take_soup(&s, &soup, 1, NULL), GMDS_OK);
    ck_assert_int_eq(gmds_homology_of(&s, NULL, &h), GMDS_OK);
    ck_assert_uint_eq(h.vertices, made[k].vertices);
    ck_assert_uint_eq(h.faces, made[k].faces);
    ck_assert(h.closed && h.orientable && s.n_turned == 0);
    ck_assert_uint_eq(h.betti[0], 1);
    ck_assert_uint_eq(h.betti[1], made[k].b1);
    ck_assert_uint_eq(h.betti[2], 1);
    gmds_homology_clear(&h);
    gmds_surface_clear(&s);
    gmds_soup_clear(&soup);
  }
  static const char *const wrong[] = {"torus:2",  "torus:",    "torus:x",       "torus:3:1",
                                      "sphere:1", "sphere:-4", "torus:99999999"};
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    gmds_soup soup;
    gmds_error error;
    gmds_soup_init(&soup, &memory, 3);
    gmds_status status = gmds_make_surface(wrong[k], &error, &soup);
    ck_assert_int_eq(status, k == 6 ? GMDS_ERR_TOO_MANY : GMDS_ERR_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, wrong[k]));
    ck_assert_uint_eq(memory.live, 0);
  }
}
END_TEST

START_TEST(generators_make_a_mesh)
{
  begin();
  face_list f = make_shape(TORUS, 5, 0, 0);
  double points[108];
  for (int k = 0; k < 108; k++)
    points[k] = k;
  gmds_surface s = surface_of(&f);
  gmds_homology h;
  gmds_soup soup;
  gmds_homology_init(&h, &memory);
  gmds_soup_init(&soup, &memory, 3);
  const gmds_homology_options o = {.generators = 1};
  ck_assert_int_eq(gmds_homology_of(&s, &o, &h), GMDS_OK);
  ck_assert_int_eq(gmds_homology_to_soup(&s, &h, points, &soup), GMDS_OK);
  ck_assert_uint_eq(soup.n_points, 36);
  ck_assert_mem_eq(soup.points, points, sizeof points);
  const int *dimension = gmds_soup_find_attribute(&soup, GMDS_OF_CELLS, "dimension")->data;
  const int *generator = gmds_soup_find_attribute(&soup, GMDS_OF_CELLS, "generator")->data;
  size_t count[3] = {0, 0, 0};
  for (size_t c = 0; c < soup.n_cells; c++) {
    ck_assert_int_eq(dimension[c], gmds_cell_type_dimension((gmds_cell_type)soup.types[c]));
    ck_assert_int_lt(generator[c], (int)h.betti[dimension[c]]);
    count[dimension[c]]++;
  }
  ck_assert_uint_eq(count[0], 1);
  ck_assert_uint_eq(count[1], h.h1.begin[2]);
  ck_assert_uint_eq(count[2], 25);
  ck_assert_int_eq(gmds_homology_to_soup(&s, &h, points, &soup), GMDS_ERR_ARGUMENT);
  gmds_soup_clear(&soup);
  gmds_homology_clear(&h);
  gmds_surface_clear(&s);
  free_faces(&f);
}
END_TEST

RUN_SUITE("homology", quotients_of_a_grid_have_their_homology, drawn_faces_have_the_homology_of_their_boundary_matrices,
          scattered_faces_are_sorted, what_is_no_surface_is_refused_with_its_place, options_out_of_range_are_refused,
          grid_labels_are_the_boxes_of_points, no_memory_leaves_nothing_behind, made_surfaces_are_what_they_are_called,
          generators_make_a_mesh)
