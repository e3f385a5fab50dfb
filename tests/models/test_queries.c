/* Every query of every compiled model against brute force: on fixed meshes where sharing nodes is not sharing a side,
 * and after random creation and deletion. */
#include "models/script.h"
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

START_TEST(answers_are_exact_on_regular_meshes)
{
  for (size_t k = 0; k < n_models; k++)
    for (int kind = 0; kind < (all_models[k]->faces == 1 ? 1 : 3); kind++) {
      subject_begin(&one, all_models[k], 1);
      subject_compare(&one);
      script_grid(&one, 3, 3, kind);
      subject_compare(&one);
      subject_end(&one);
    }
}
END_TEST

/* Meshes on which multiplicities of nodes mislead. Faces as lists of nodes, 0 ends one (so nodes count from 1); a list
 * of two is an edge without a face, added in models where edges know nodes. */
static const unsigned char traps[][8][8] = {
    /* a quadrilateral whose diagonals are sides and edges elsewhere */
    {{1, 2, 3, 4}, {1, 3, 5}, {2, 4}, {1, 3, 6, 7}},
    /* faces that share two nodes and no side */
    {{1, 2, 3, 4}, {1, 5, 3, 6}, {2, 5, 4, 6}},
    /* triangles around a hole that is no face */
    {{1, 2, 4}, {2, 3, 5}, {3, 1, 6}},
    /* faces that share two sides */
    {{1, 2, 3, 4}, {1, 2, 3, 5}, {1, 2, 6}, {2, 6, 3}},
    /* two triangles on the same nodes */
    {{1, 2, 3}, {1, 3, 2}, {4, 5, 6}, {4, 5, 6}},
    /* three faces on one side */
    {{1, 2, 3}, {1, 2, 4}, {2, 1, 5}, {1, 2, 6, 7}},
    /* edges without faces, and isolated nodes */
    {{1, 2}, {2, 3}, {3, 1}, {1, 2, 4}, {5, 6}, {1, 5}},
    /* a polygon whose chord is an edge */
    {{1, 2, 3, 4, 5}, {1, 3}, {2, 4, 6}, {5, 3, 7}, {4, 5, 8}},
};

START_TEST(answers_are_exact_where_shared_nodes_mislead)
{
  size_t refused = 0;
  for (size_t k = 0; k < n_models; k++)
    for (size_t t = 0; t < sizeof traps / sizeof *traps; t++) {
      subject_begin(&one, all_models[k], 1);
      script_nodes(&one, 10);
      for (size_t c = 0; c < 8 && traps[t][c][0]; c++) {
        gmds_id nodes[8];
        size_t n = 0;
        for (; n < 8 && traps[t][c][n]; n++)
          nodes[n] = traps[t][c][n];
        if (n > 2)
          refused += script_add(&one, n, nodes) == GMDS_ERR_CONFLICT;
        else if (links_edges(one.m))
          subject_add_edge(&one, nodes[0], nodes[1]);
        subject_compare(&one);
      }
      subject_end(&one);
    }
  ck_assert_uint_gt(refused, 0);
}
END_TEST

/* ---- faces at once */

static void add_trap(subject *s, size_t t)
{
  script_nodes(s, 10);
  for (size_t c = 0; c < 8 && traps[t][c][0]; c++) {
    gmds_id nodes[8];
    size_t n = 0;
    for (; n < 8 && traps[t][c][n]; n++)
      nodes[n] = traps[t][c][n];
    if (n > 2 && allows(s->m, n))
      subject_add_face(s, n, nodes, KNOWS_BOTH);
  }
}

START_TEST(faces_added_at_once_are_those_added_one_by_one)
{
  static subject two;
  static face_list list;
  for (size_t k = 0; k < n_models; k++)
    for (size_t t = 0; t < 3 + sizeof traps / sizeof *traps; t++) {
      size_t failed = 99;
      subject_begin(&one, all_models[k], 5);
      subject_begin(&two, all_models[k], 5);
      if (t < 3)
        script_grid(&one, 3, 2, (int)t);
      else
        add_trap(&one, t - 3);
      script_nodes(&two, one.ref.end[0]);
      script_list(&one, &list);
      if (script_at_once(&two, &one, &list, &failed) != GMDS_OK)
        subject_fail(&two, "face %zu of %zu is refused", failed, list.n);
      ck_assert_uint_eq(failed, 99);
      subject_compare(&two);
      if (list.n && two.m->do_add_faces(two.mesh, list.n, list.begin, list.nodes, NULL) != GMDS_ERR_ARGUMENT)
        subject_fail(&two, "faces are added to faces");
      subject_compare(&two);
      subject_end(&two);
      subject_end(&one);
    }
}
END_TEST

START_TEST(faces_that_cannot_be_added_leave_the_nodes_alone)
{
  static const struct {
    size_t n, begin[5], bad;
    gmds_id nodes[16];
    gmds_status status; /* GMDS_ERR_CONFLICT: in models that store F2F */
  } cases[] = {{2, {0, 3, 6}, 1, {0, 1, 2, 2, 3, 2}, GMDS_ERR_ARGUMENT},
               {2, {0, 3, 6}, 1, {0, 1, 2, 2, 3, 77}, GMDS_ERR_CELL},
               {2, {0, 3, 5}, 1, {0, 1, 2, 2, 3}, GMDS_ERR_ARGUMENT},
               {2, {0, 3, 2}, 1, {0, 1, 2, 2, 3}, GMDS_ERR_ARGUMENT},
               {4, {0, 3, 6, 9, 12}, 2, {0, 1, 2, 1, 0, 3, 0, 1, 4, 5, 6, 7}, GMDS_ERR_CONFLICT},
               {2, {0, 4, 8}, 1, {0, 1, 2, 3, 3, 2, 1, 3}, GMDS_ERR_ARGUMENT}};
  for (size_t k = 0; k < n_models; k++)
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
      size_t failed = 99;
      const model *m = all_models[k];
      if (!allows(m, cases[c].begin[1]) || (cases[c].status == GMDS_ERR_CONFLICT && !stores(m, 2, 2)))
        continue;
      subject_begin(&one, m, 5);
      script_nodes(&one, 10);
      gmds_status status = m->do_add_faces(one.mesh, cases[c].n, cases[c].begin, cases[c].nodes, &failed);
      if (status != cases[c].status || failed != cases[c].bad)
        subject_fail(&one, "faces %zu: '%s', face %zu", c, gmds_status_text(status), failed);
      subject_compare(&one);
      script_grid(&one, 2, 2, 0);
      subject_compare(&one);
      subject_end(&one);
    }
}
END_TEST

/* ---- edges of many faces */

START_TEST(an_edge_may_have_any_number_of_faces)
{
  enum { MANY = 20 };
  for (size_t k = 0; k < n_models; k++) {
    const model *m = all_models[k];
    if (!allows(m, 3) || stores(m, 2, 2)) /* F2F holds two faces a side */
      continue;
    subject_begin(&one, m, 3);
    script_nodes(&one, MANY + 2);
    for (gmds_id v = 2; v < MANY + 2; v++) {
      const gmds_id nodes[3] = {0, 1, v};
      subject_add_face(&one, 3, nodes, KNOWS_BOTH);
      if (v < 6)
        subject_compare(&one);
    }
    subject_compare(&one);
    size_t most = m->do_memory(one.mesh)->live;
    for (gmds_id f = 0; f < MANY; f++) {
      if (f % 10 == 4) /* two stay */
        continue;
      subject_remove_face(&one, f, usual_edges(m));
      if (f > MANY - 6)
        subject_compare(&one);
    }
    subject_compact(&one);
    ck_assert_int_eq(m->do_trim(one.mesh), GMDS_OK);
    subject_compare(&one);
    ck_assert_uint_lt(m->do_memory(one.mesh)->live, most);
    subject_end(&one);
  }
}
END_TEST

/* ---- random meshes */

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
      script_face(s);
  }
  for (gmds_id f = 0; f < MAX_FACES; f++)
    ck_assert(!stays[f] || met[f]);
}

START_TEST(answers_are_exact_after_creation_and_deletion)
{
  size_t done = 0, refused = 0;
  for (size_t k = 0; k < n_models; k++) {
    subject_begin(&one, all_models[k], 1000 + k);
    script_nodes(&one, 7);
    for (int round = 0; round < 6; round++) {
      for (int i = 0; i < 60; i++) {
        script_step(&one);
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
          answers_are_exact_where_shared_nodes_mislead, faces_added_at_once_are_those_added_one_by_one,
          faces_that_cannot_be_added_leave_the_nodes_alone, an_edge_may_have_any_number_of_faces,
          answers_are_exact_after_creation_and_deletion)
