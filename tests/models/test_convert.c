/* Conversion between models: every model becomes some others and is become from them; after each step all queries are
 * those of the reference, and the check passes. */
#include "models/script.h"
#include <gmds/census.h>

static subject one;

/* The table of a model by its mask and the types of its faces, or NULL. */
static const model *find(const char *text, unsigned faces)
{
  unsigned mask = 0;
  ck_assert_int_eq(gmds_mask_parse(text, NULL, &mask), GMDS_OK);
  for (size_t k = 0; k < n_models; k++)
    if (all_models[k]->mask == mask && all_models[k]->faces == faces && all_models[k]->dim == 2)
      return all_models[k];
  return NULL;
}

/* Each is stored, or ordered, in another way. */
static const char *const few[] = {
    "N|F|F2N",       "N|F|N2F",       "N|F|F2N|F2F",   "N|F|N2F|F2F",       "N|E|F|E2N|F2E",
    "N|E|F|N2E|E2F", "N|E|F|E2F|F2N", "N|E|F|N2F|F2E", "N|E|F|E2N|F2E|F2F", "N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F"};
enum { FEW = sizeof few / sizeof *few };

/* A mesh with holes among its cells, of the faces that the model holds. */
static void grow(subject *s, int kind)
{
  script_grid(s, 3, 3, kind);
  for (int i = 0; i < 8; i++) {
    gmds_id f = reference_pick(&s->ref, 2, &s->seed);
    if (f != GMDS_NONE && i % 2 == 0)
      subject_remove_face(s, f, usual_edges(s->m));
    else
      script_face(s);
  }
}

START_TEST(every_model_becomes_a_few_and_comes_back)
{
  size_t done = 0, refused = 0;
  for (size_t k = 0; k < n_models; k++)
    for (size_t q = 0; q < FEW; q++) {
      const model *from = all_models[k], *to = find(few[q], from->faces == 1 ? 1 : 7);
      subject_begin(&one, from, 10 * k + q);
      grow(&one, from->faces == 1 ? 0 : 2 * (int)(q % 2));
      if (subject_become(&one, to) == GMDS_OK) {
        done++;
        for (int i = 0; i < 4; i++)
          script_step(&one);
        subject_compare(&one);
        done += subject_become(&one, from) == GMDS_OK;
      } else
        refused++;
      subject_end(&one);
    }
  printf("%zu conversions, %zu refused\n", done, refused);
  ck_assert_uint_gt(done, 4000);
}
END_TEST

/* Until it is where nothing tells the way back: then the next begins. */
static size_t wander(unsigned faces, uint64_t seed)
{
  size_t done = 0, refused = 0;
  subject_begin(&one, find("N|F|F2N|F2F", faces), seed);
  grow(&one, faces == 1 ? 0 : 2);
  while (refused < 12) {
    const model *to = all_models[random_below(&seed, n_models)];
    if (to->dim != 2 || (faces == 7 && to->faces != 7) || (faces == 1 && !(to->faces & 1)))
      continue;
    if (subject_become(&one, to) == GMDS_OK)
      done++;
    else
      refused++;
    script_face(&one);
    if (reference_count(&one.ref, 2) > 24)
      subject_remove_face(&one, reference_pick(&one.ref, 2, &one.seed), usual_edges(one.m));
    subject_compare(&one);
  }
  subject_end(&one);
  return done;
}

START_TEST(a_mesh_wanders_through_all_models)
{
  size_t done = 0;
  for (uint64_t seed = 1; seed <= 60; seed++)
    done += wander(1, seed) + wander(7, seed);
  printf("%zu conversions\n", done);
  ck_assert_uint_gt(done, 500);
}
END_TEST

START_TEST(a_conversion_without_memory_changes_nothing)
{
  for (size_t p = 0; p < FEW; p++)
    for (size_t q = 0; q < FEW; q++)
      for (unsigned faces = 1; faces <= 7; faces += 6) {
        subject_begin(&one, find(few[p], faces), 100 * p + q);
        script_grid(&one, 2, 2, faces == 1 ? 0 : 1);
        subject_remove_face(&one, reference_pick(&one.ref, 2, &one.seed), usual_edges(one.m));
        one.inject = 1;
        subject_become(&one, find(few[q], faces));
        one.inject = 0;
        subject_end(&one);
      }
}
END_TEST

START_TEST(parts_are_owned_once)
{
  gmds_parts parts;
  gmds_error error = {0};
  gmds_parts_init(&parts);
  subject_begin(&one, find("N|F|F2N", 1), 3);
  ck_assert_int_eq(one.m->do_take(one.mesh, &parts, &error), GMDS_ERR_ARGUMENT); /* none were given */
  ck_assert_str_eq(error.text, "there are no parts to be taken");
  script_grid(&one, 2, 2, 0);
  one.m->do_give(one.mesh, &parts);
  size_t live = parts.memory.live;
  ck_assert_uint_gt(live, 0);
  ck_assert_uint_eq(one.from.live, live);
  gmds_id v = 0;
  const double x[2] = {0, 0};
  ck_assert_int_eq(one.m->do_add_node(one.mesh, x, &v), GMDS_OK);
  ck_assert_int_eq(one.m->do_take(one.mesh, &parts, &error), GMDS_ERR_ARGUMENT); /* it is not empty */
  ck_assert_uint_eq(parts.memory.live, live);
  ck_assert_int_eq(one.m->do_remove_node(one.mesh, v, GMDS_REFUSE), GMDS_OK);
  ck_assert_int_eq(one.m->do_take(one.mesh, &parts, &error), GMDS_OK);
  subject_compare(&one);
  one.m->do_give(one.mesh, &parts);
  gmds_parts_clear(&parts);
  gmds_parts_clear(&parts);
  ck_assert_uint_eq(one.from.live, 0);
  subject_end(&one);
}
END_TEST

RUN_SUITE("convert", every_model_becomes_a_few_and_comes_back, a_mesh_wanders_through_all_models,
          a_conversion_without_memory_changes_nothing, parts_are_owned_once)
