/* What exhaustive.sh runs over a chunk of models: the comparisons of test_volumes.c with fewer steps, and meshes filled
 * from the model with all relations, which also reach models that can add no regions. The last model of the list is
 * that one. */
#include "volumes/pool.h"

static subject one, full;

START_TEST(answers_are_exact_while_a_mesh_grows)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    if (!volume_models[k]->adds_regions && !volume_models[k]->do_add_face && !volume_models[k]->do_add_edge)
      continue;
    subject_begin(&one, volume_models[k], 1);
    pool_nodes(&one);
    for (size_t i = 0; i < n_pool; i++) {
      pool_add(&one, &pool[i]);
      if (i % 9 == 8)
        subject_compare(&one);
    }
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

START_TEST(answers_are_exact_after_creation_and_deletion)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    if (!volume_models[k]->adds_regions)
      continue;
    subject_begin(&one, volume_models[k], 1000 + k);
    pool_nodes(&one);
    for (int round = 0; round < 2; round++) {
      for (int i = 0; i < 25; i++)
        pool_step(&one);
      subject_compare(&one);
      subject_compact(&one);
    }
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

START_TEST(a_mesh_filled_from_all_relations_answers_as_they_do)
{
  size_t filled = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    gmds_volume volume;
    gmds_error error = {.status = GMDS_OK};
    subject_begin(&full, volume_models[n_volume_models - 1], 1);
    pool_nodes(&full);
    for (size_t i = 0; i < n_pool; i++)
      if (gmds_cell_type_dimension(pool[i].type) == 3 && m->regions >> (pool[i].type - GMDS_TETRAHEDRON) & 1)
        pool_add(&full, &pool[i]);
    subject_remove_region(&full, 1, GMDS_DROP_BARE);
    gmds_volume_init(&volume, &full.memory);
    ck_assert_int_eq(full.m->do_get_volume(full.mesh, &volume, &error), GMDS_OK);
    subject_begin(&one, m, 1);
    if (m->do_set_volume(one.mesh, &volume, &error) != GMDS_OK)
      subject_fail(&one, "%s", error.text);
    one.ref = full.ref;
    one.ref.makes_edges = m->makes_edges;
    one.ref.makes_faces = m->makes_faces;
    if (!m->makes_edges)
      one.ref.end[1] = 0;
    if (!m->makes_faces)
      one.ref.end[2] = 0;
    subject_compare(&one);
    filled++;
    gmds_volume_clear(&volume);
    subject_end(&one);
    subject_end(&full);
  }
  printf("%zu models\n", filled);
}
END_TEST

RUN_SUITE("every mask of volumes", answers_are_exact_while_a_mesh_grows, answers_are_exact_after_creation_and_deletion,
          a_mesh_filled_from_all_relations_answers_as_they_do)
