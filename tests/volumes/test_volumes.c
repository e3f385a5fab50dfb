/* Every query of models of volumes against brute force: on regular meshes, where shared nodes mislead, and after random
 * creation and deletion; every row of the tables taken by a model. */
#include "volumes/pool.h"
#include <gmds/census.h>

static subject one;

START_TEST(paths_of_the_preprocessor_are_those_of_the_census)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    const volume_model *m = volume_models[k];
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < 4; j++) {
        gmds_path path = gmds_path_of(m->mask, i, j);
        int can = path.cost != GMDS_COST_NONE && (m->regions & ~path.exact_regions) == 0;
        if (m->path[i][j] != path.code || m->can[i][j] != can)
          ck_abort_msg("%s %d->%d: compiled as path %d, can %d; the census says %d, %d", m->name, i, j, m->path[i][j],
                       m->can[i][j], path.code, can);
      }
    ck_assert_msg(m->adds_regions || (m->regions & ~1u), "%s cannot add tetrahedra", m->name);
  }
}
END_TEST

/* Every path that a mask of the census takes, and every row of the tables, is taken by a compiled model, which the
 * other tests hold against brute force. */
START_TEST(every_path_is_taken)
{
  static int met[16][256], taken[16][256];
  size_t codes = 0, missing = 0;
  for (size_t k = 0; k < gmds_census_size(3); k++) {
    unsigned mask = gmds_census_mask(3, k);
    for (int q = 0; q < 16 && gmds_census_of(mask, 3).identified; q++)
      taken[q][gmds_path_of(mask, q / 4, q % 4).code] = 1;
  }
  taken[0][16] = taken[5][16] = taken[10][16] = 1; /* N2N, E2E and F2F themselves, which the census leaves out */
  for (size_t k = 0; k < n_volume_models; k++)
    for (int q = 0; q < 16; q++)
      met[q][volume_models[k]->path[q / 4][q % 4]] += volume_models[k]->can[q / 4][q % 4];
  for (int q = 0; q < 16; q++) {
    printf("%d->%d:", q / 4, q % 4);
    for (int code = 16; code < 256; code++) {
      if (met[q][code])
        printf(" %d.%d", code / 16, code % 16);
      codes += met[q][code] > 0;
      if (taken[q][code] && !met[q][code]) {
        printf(" (%d.%d missing)", code / 16, code % 16);
        missing++;
      }
    }
    printf("\n");
  }
  printf("%zu paths\n", codes);
  ck_assert_uint_eq(missing, 0);
}
END_TEST

/* ---- fixed meshes */

START_TEST(answers_are_exact_while_a_mesh_grows)
{
  for (size_t k = 0; k < n_volume_models; k++) {
    subject_begin(&one, volume_models[k], 1);
    subject_compare(&one);
    pool_nodes(&one);
    for (size_t i = 0; i < n_pool; i++) {
      pool_add(&one, &pool[i]);
      if (i % 5 == 4 || one.m->regions != 1)
        subject_compare(&one);
    }
    pool_add_polyhedra(&one);
    subject_compare(&one);
    subject_end(&one);
  }
}
END_TEST

/* ---- random meshes */

START_TEST(answers_are_exact_after_creation_and_deletion)
{
  size_t done = 0, refused = 0, unsupported = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    subject_begin(&one, volume_models[k], 1000 + k);
    pool_nodes(&one);
    for (int round = 0; round < 4; round++) {
      for (int i = 0; i < 40; i++) {
        pool_step(&one);
        if (i % 10 == 9)
          subject_compare(&one);
      }
      subject_compact(&one);
      subject_compare(&one);
      pool_nodes(&one);
    }
    done += one.done;
    refused += one.refused;
    unsupported += one.unsupported;
    if (one.m->regions == 1 && one.unsupported)
      subject_fail(&one, "%zu operations are not supported", one.unsupported);
    subject_end(&one);
  }
  printf("%zu operations done, %zu refused, %zu not supported\n", done, refused, unsupported);
}
END_TEST

RUN_SUITE("volumes", paths_of_the_preprocessor_are_those_of_the_census, every_path_is_taken,
          answers_are_exact_while_a_mesh_grows, answers_are_exact_after_creation_and_deletion)
