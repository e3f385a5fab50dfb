/* Every query of every compiled model against brute force: on fixed meshes where sharing nodes is not sharing a side,
 * and after random creation and deletion. */
#include "models/subject.h"
#include <gmds/census.h>

static subject one;

START_TEST(paths_of_the_preprocessor_are_those_of_the_census)
{
  ck_assert_uint_ge(n_models, 2 * 128 + 2 * 64);
  for (size_t k = 0; k < n_models; k++) {
    const model *m = all_models[k];
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        gmds_path path = gmds_path_of(m->mask, i, j);
        int can = path.cost != GMDS_COST_NONE && (m->faces & ~path.exact) == 0;
        if (m->path[i][j] != path.code || m->can[i][j] != can)
          ck_abort_msg("%s %d->%d: compiled as path %d, can %d; the census says %d, %d", m->name, i, j, m->path[i][j],
                       m->can[i][j], path.code, can);
      }
  }
}
END_TEST

/* ---- fixed meshes */

/* How a face is to be added to a model: as the script says where it can be, else with all that the reference knows. */
static knows knowing(const subject *s, knows wanted)
{
  if (needs_links(s->m))
    return KNOWS_BOTH;
  return wanted;
}

static gmds_status add(subject *s, size_t n, const gmds_id *nodes)
{
  return allows(s->m, n) ? subject_add_face(s, n, nodes, knowing(s, KNOWS_NOTHING)) : GMDS_ERR_ARGUMENT;
}

static void add_nodes(subject *s, size_t n)
{
  while (n-- > 0)
    subject_add_node(s);
}

/* A strip of w by h squares, cut in two, whole, or joined to hexagons, as the model and `kind` allow; two isolated
 * nodes at the end. */
static void add_grid(subject *s, gmds_id w, gmds_id h, int kind)
{
  gmds_id row = w + 1, first = (gmds_id)s->ref.end[0];
  add_nodes(s, (size_t)row * (h + 1) + 2);
  for (gmds_id y = 0; y < h; y++)
    for (gmds_id x = 0; x < w; x++) {
      gmds_id a = first + y * row + x, b = a + 1, c = b + row, d = a + row;
      const gmds_id lower[3] = {a, b, c}, upper[3] = {a, c, d}, whole[4] = {a, b, c, d};
      const gmds_id joined[6] = {a, b, b + 1, c + 1, c, d};
      if (kind == 2 && x % 2 == 0 && x + 1 < w && allows(s->m, 6)) {
        add(s, 6, joined);
        x++;
      } else if (allows(s->m, 4) && (kind == 1 || (kind == 2 && y % 2) || !allows(s->m, 3)))
        add(s, 4, whole);
      else {
        add(s, 3, lower);
        add(s, 3, upper);
      }
    }
}

START_TEST(answers_are_exact_on_regular_meshes)
{
  for (size_t k = 0; k < n_models; k++)
    for (int kind = 0; kind < (all_models[k]->faces == 1 ? 1 : 3); kind++) {
      subject_begin(&one, all_models[k], 1);
      subject_compare(&one);
      add_grid(&one, 3, 3, kind);
      subject_compare(&one);
      subject_end(&one);
    }
}
END_TEST

/* Meshes on which multiplicities of nodes mislead. Faces as lists of nodes, 0 ends one (so nodes count from 1); a list
 * of two is an edge without a face, added in models where edges know nodes. */
typedef struct trap {
  const char *name;
  unsigned char cells[8][8];
} trap;

static const trap traps[] = {
    {"a quadrilateral whose diagonals are sides and edges elsewhere", {{1, 2, 3, 4}, {1, 3, 5}, {2, 4}, {1, 3, 6, 7}}},
    {"faces that share two nodes and no side", {{1, 2, 3, 4}, {1, 5, 3, 6}, {2, 5, 4, 6}}},
    {"triangles around a hole that is no face", {{1, 2, 4}, {2, 3, 5}, {3, 1, 6}}},
    {"faces that share two sides", {{1, 2, 3, 4}, {1, 2, 3, 5}, {1, 2, 6}, {2, 6, 3}}},
    {"two triangles on the same nodes", {{1, 2, 3}, {1, 3, 2}, {4, 5, 6}, {4, 5, 6}}},
    {"three faces on one side", {{1, 2, 3}, {1, 2, 4}, {2, 1, 5}, {1, 2, 6, 7}}},
    {"edges without faces, and isolated nodes", {{1, 2}, {2, 3}, {3, 1}, {1, 2, 4}, {5, 6}, {1, 5}}},
    {"a polygon whose chord is an edge", {{1, 2, 3, 4, 5}, {1, 3}, {2, 4, 6}, {5, 3, 7}, {4, 5, 8}}},
};

START_TEST(answers_are_exact_where_shared_nodes_mislead)
{
  size_t refused = 0;
  for (size_t k = 0; k < n_models; k++)
    for (size_t t = 0; t < sizeof traps / sizeof *traps; t++) {
      subject_begin(&one, all_models[k], 1);
      add_nodes(&one, 10);
      for (size_t c = 0; c < 8 && traps[t].cells[c][0]; c++) {
        gmds_id nodes[8];
        size_t n = 0;
        for (; n < 8 && traps[t].cells[c][n]; n++)
          nodes[n] = traps[t].cells[c][n];
        if (n > 2)
          refused += add(&one, n, nodes) == GMDS_ERR_CONFLICT;
        else if (links_edges(one.m))
          subject_add_edge(&one, nodes[0], nodes[1]);
        subject_compare(&one);
      }
      subject_end(&one);
    }
  ck_assert_uint_gt(refused, 0);
}
END_TEST

/* ---- random meshes */

static void random_face(subject *s)
{
  static const size_t sizes[] = {3, 3, 3, 4, 4, 5, 6};
  gmds_id nodes[MAX_SIDES];
  size_t n = sizes[random_below(&s->seed, sizeof sizes / sizeof *sizes)];
  if (!allows(s->m, n))
    n = allows(s->m, 3) ? 3 : 4;
  if (reference_count(&s->ref, 0) < n || reference_count(&s->ref, 2) > 30)
    return;
  for (size_t k = 0; k < n;) {
    size_t q = 0;
    nodes[k] = reference_pick(&s->ref, 0, &s->seed);
    while (q < k && nodes[q] != nodes[k])
      q++;
    k += q == k;
  }
  knows known = (knows)random_below(&s->seed, 4);
  subject_add_face(s, n, nodes, knowing(s, known));
}

static void random_step(subject *s)
{
  gmds_id v = reference_pick(&s->ref, 0, &s->seed), w = reference_pick(&s->ref, 0, &s->seed);
  gmds_id e = reference_pick(&s->ref, 1, &s->seed), f = reference_pick(&s->ref, 2, &s->seed);
  size_t what = random_below(&s->seed, 100);
  gmds_edges edges = random_below(&s->seed, 2) ? GMDS_DROP_BARE_EDGES : usual_edges(s->m);
  gmds_around around = random_below(&s->seed, 3) ? GMDS_REFUSE : GMDS_CASCADE;
  if (what < 10) {
    if (reference_count(&s->ref, 0) < 12)
      subject_add_node(s);
  } else if (what < 65)
    random_face(s);
  else if (what < 70) {
    if (links_edges(s->m) && v != w)
      subject_add_edge(s, v, w);
  } else if (what < 86) {
    if (f != GMDS_NONE)
      subject_remove_face(s, f, edges);
  } else if (what < 94) {
    if (e != GMDS_NONE && makes_edges(s->m))
      subject_remove_edge(s, e, around);
  } else if (v != GMDS_NONE)
    subject_remove_node(s, v, around);
}

/* Removes every second face while it goes over them, adding others: those that stay are met once. */
static void thin_out(subject *s)
{
  static int stays[MAX_FACES], met[MAX_FACES];
  const gmds_cells *faces = &s->m->do_cells(s->mesh)[2];
  for (gmds_id f = 0; f < MAX_FACES; f++) {
    stays[f] = reference_has(&s->ref, 2, f);
    met[f] = 0;
  }
  for (gmds_id f = gmds_cells_next(faces, 0); f != GMDS_NONE; f = gmds_cells_next(faces, f + 1)) {
    ck_assert(!met[f]);
    met[f] = 1;
    if (random_below(&s->seed, 2)) {
      subject_remove_face(s, f, usual_edges(s->m));
      stays[f] = reference_has(&s->ref, 2, f);
    } else
      random_face(s);
  }
  for (gmds_id f = 0; f < MAX_FACES; f++)
    ck_assert(!stays[f] || met[f]);
}

START_TEST(answers_are_exact_after_creation_and_deletion)
{
  size_t done = 0, refused = 0;
  for (size_t k = 0; k < n_models; k++) {
    subject_begin(&one, all_models[k], 1000 + k);
    add_nodes(&one, 7);
    for (int round = 0; round < 6; round++) {
      for (int i = 0; i < 60; i++) {
        random_step(&one);
        if (i % 10 == 9)
          subject_compare(&one);
      }
      thin_out(&one);
      subject_compare(&one);
      subject_compact(&one);
      subject_compare(&one);
      ck_assert_int_eq(one.m->do_trim(one.mesh), GMDS_OK);
      subject_compare(&one);
    }
    done += one.done;
    refused += one.refused;
    subject_end(&one);
  }
  printf("%zu operations done, %zu refused\n", done, refused);
}
END_TEST

RUN_SUITE("queries", paths_of_the_preprocessor_are_those_of_the_census, answers_are_exact_on_regular_meshes,
          answers_are_exact_where_shared_nodes_mislead, answers_are_exact_after_creation_and_deletion)
