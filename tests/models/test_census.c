/* The census against the numbers and matrices that the paper prints, and the parser and printer of masks. */
#include "harness.h"
#include <gmds/census.h>

enum {
  N2N = GMDS_RELATION_BIT(0, 0),
  N2E = GMDS_RELATION_BIT(0, 1),
  N2F = GMDS_RELATION_BIT(0, 2),
  N2R = GMDS_RELATION_BIT(0, 3),
  E2N = GMDS_RELATION_BIT(1, 0),
  E2F = GMDS_RELATION_BIT(1, 2),
  F2N = GMDS_RELATION_BIT(2, 0),
  F2E = GMDS_RELATION_BIT(2, 1),
  F2F = GMDS_RELATION_BIT(2, 2),
  F2R = GMDS_RELATION_BIT(2, 3),
  R2N = GMDS_RELATION_BIT(3, 0),
  R2F = GMDS_RELATION_BIT(3, 2),
  R2R = GMDS_RELATION_BIT(3, 3)
};

static unsigned mask_of(const char *text)
{
  unsigned mask = 0;
  gmds_error error = {0};
  if (gmds_mask_parse(text, &error, &mask) != GMDS_OK)
    ck_abort_msg("%s", error.text);
  return mask;
}

START_TEST(two_dimensions_have_128_masks_of_which_114_compute_and_96_identify)
{
  size_t computable = 0, identified = 0, paper = 0, no_nodes = 0;
  ck_assert_uint_eq(gmds_census_size(2), 128);
  for (size_t k = 0; k < 128; k++) {
    unsigned mask = gmds_census_mask(2, k);
    gmds_census c = gmds_census_of(mask, 2);
    ck_assert_uint_eq(c.mask, mask);
    for (size_t q = 0; q < k; q++)
      ck_assert_uint_ne(gmds_census_mask(2, q), mask);
    computable += (size_t)c.computable;
    identified += (size_t)c.identified;
    paper += (size_t)c.paper105;
    no_nodes += gmds_path_of(mask, 2, 0).cost == GMDS_COST_NONE;
    ck_assert(c.computable || !c.identified);
    ck_assert(c.computable || !c.paper105);
    ck_assert(c.paper105 || !c.identified);
  }
  ck_assert_uint_eq(computable, 114);
  ck_assert_uint_eq(no_nodes, 14);
  ck_assert_uint_eq(identified, 96);
  ck_assert_uint_eq(paper, 105);
}
END_TEST

START_TEST(three_dimensions_have_8192_masks_of_which_7854_compute_and_5856_identify)
{
  size_t computable = 0, identified = 0;
  ck_assert_uint_eq(gmds_census_size(3), 8192);
  for (size_t k = 0; k < 8192; k++) {
    gmds_census c = gmds_census_of(gmds_census_mask(3, k), 3);
    computable += (size_t)c.computable;
    identified += (size_t)c.identified;
    if (c.paper105)
      ck_abort_msg("mask %zu of dimension 3 is no model of the paper's 105", k);
  }
  ck_assert_uint_eq(computable, 7854);
  ck_assert_uint_eq(identified, 5856);
}
END_TEST

START_TEST(every_row_of_table_4_is_among_the_105)
{
  static const char *const rows[] = {"DIM2|F|N|N2F|F2N",
                                     "DIM2|F|N|N2F|F2N|F2F",
                                     "DIM2|F|E|N|F2N|N2F|F2E",
                                     "DIM2|F|E|N|F2N|N2F|F2E|F2F",
                                     "DIM2|F|E|N|F2E|E2F|F2N|N2F",
                                     "DIM2|F|E|N|F2N|N2F|N2E|E2F",
                                     "DIM2|F|E|N|F2N|N2F|N2E|E2F|F2F",
                                     "DIM2|F|E|N|F2N|N2F|E2N|N2E|F2E|F2F",
                                     "DIM2|F|E|N|F2N|N2F|E2F|F2E|E2N|N2E|F2F",
                                     "DIM2|F|N|N2F|F2F",
                                     "DIM2|F|E|N|N2F|N2E|F2F",
                                     "DIM2|F|N|N2F",
                                     "DIM2|F|N|F2N",
                                     "DIM2|F|N|F2N|F2F",
                                     "DIM2|F|E|N|E2F|N|N2E",
                                     "DIM2|F|E|N|F2E|E2N",
                                     "DIM2|F|E|N|F2E|E2N|F2F"};
  size_t n = sizeof rows / sizeof *rows;
  ck_assert_uint_eq(n, 17);
  for (size_t k = 0; k < n; k++) {
    unsigned mask = mask_of(rows[k]);
    gmds_census c = gmds_census_of(mask, 2);
    if (!c.paper105)
      ck_abort_msg("row %zu of Table 4, %s, is not among the 105", k + 1, rows[k]);
    int found = 0;
    for (size_t q = 0; q < gmds_census_size(2); q++)
      found += gmds_census_mask(2, q) == (mask & ~(unsigned)GMDS_DIM2);
    ck_assert_int_eq(found, 1);
  }
}
END_TEST

/* 4 × 4 matrices row by row, as the paper prints them. */
static void matrices_are(unsigned mask, const char *direct, const char *indirect)
{
  char d[4][4], x[4][4];
  gmds_matrices(mask, d, x);
  for (int k = 0; k < 16; k++) {
    ck_assert_msg(d[k / 4][k % 4] == direct[k], "direct %d, %d is %c", k / 4, k % 4, d[k / 4][k % 4]);
    ck_assert_msg(x[k / 4][k % 4] == indirect[k], "indirect %d, %d is %c", k / 4, k % 4, x[k / 4][k % 4]);
  }
}

START_TEST(matrices_of_f1_and_r2_are_as_printed)
{
  matrices_are(mask_of("N|E|F|R|N2E|E2N|E2F|F2E|F2R|R2F"), "0100101001010010", "1x11x0x21x1x22x2");
  matrices_are(mask_of("N|R|N2N|N2R|R2N|R2R"), "1001000000001001", "x--x--------x--x");
}
END_TEST

START_TEST(costs_follow_the_priorities_of_the_paper)
{
  static const struct {
    unsigned mask;
    int i, j;
    gmds_cost cost;
    int hops;
    unsigned inverse;
  } cases[] = {
      {F2N, 2, 0, GMDS_COST_DIRECT, 1, 0},
      {F2E | E2N, 2, 0, GMDS_COST_LOCAL, 2, 0},
      {F2E | E2N | N2F, 2, 0, GMDS_COST_LOCAL, 2, 0}, /* before the inverse of N2F */
      {N2F, 2, 0, GMDS_COST_GLOBAL, 1, 1},
      {N2F | F2E | N2E, 2, 0, GMDS_COST_GLOBAL, 1, 1}, /* before a series with a traversal */
      {F2E | N2E, 2, 0, GMDS_COST_MIXED, 2, 2},
      {E2F | N2E, 2, 0, GMDS_COST_MIXED, 2, 3},
      {E2F | E2N, 2, 0, GMDS_COST_MIXED, 2, 1},
      {F2F, 2, 0, GMDS_COST_NONE, 0, 0},
      {F2F, 2, 2, GMDS_COST_DIRECT, 1, 0},
      {F2N, 2, 2, GMDS_COST_MIXED, 2, 2},
      {F2N | N2F, 2, 2, GMDS_COST_LOCAL, 2, 0},
      {F2N | N2F, 0, 0, GMDS_COST_LOCAL, 2, 0},
      {F2N | N2F | E2N, 0, 0, GMDS_COST_MIXED, 2, 1}, /* an edge need not bound a face */
      {R2N | N2R, 3, 3, GMDS_COST_LOCAL, 2, 0},
      {R2F | F2R, 3, 3, GMDS_COST_LOCAL, 2, 0},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    gmds_path path = gmds_path_of(cases[k].mask, cases[k].i, cases[k].j);
    ck_assert_msg(path.cost == cases[k].cost && path.hops == cases[k].hops && path.inverse == cases[k].inverse,
                  "case %zu: %s, %d hops, inverse %u", k, gmds_cost_text(path.cost), path.hops, path.inverse);
  }
}
END_TEST

START_TEST(exactness_depends_on_what_keeps_the_sides)
{
  const unsigned all = 7, triangles = 1;
  ck_assert_uint_eq(gmds_path_of(F2N | N2F, 2, 2).exact, all);
  ck_assert_uint_eq(gmds_path_of(N2F, 2, 2).exact, triangles);
  ck_assert_uint_eq(gmds_path_of(N2F, 0, 0).exact, triangles);
  ck_assert_uint_eq(gmds_path_of(N2F, 2, 0).exact, all);
  ck_assert_uint_eq(gmds_path_of(N2F | E2N, 1, 2).exact, triangles);
  ck_assert_uint_eq(gmds_path_of(N2F | E2N | F2N, 1, 2).exact, all);
  ck_assert_uint_eq(gmds_path_of(N2F | E2N | E2F, 1, 2).exact, all);
  ck_assert_uint_eq(gmds_path_of(R2N, 3, 0).exact, 0);
}
END_TEST

START_TEST(full_and_complete_are_as_defined)
{
  gmds_census c = gmds_census_of(mask_of("N|E|F|N2E|E2N|E2F|F2E"), 2);
  ck_assert(c.full && c.complete);
  c = gmds_census_of(mask_of("N|F|F2N|N2F"), 2);
  ck_assert(!c.full && c.complete);
  c = gmds_census_of(mask_of("N|F|F2N|F2F"), 2);
  ck_assert(!c.full && !c.complete);
  c = gmds_census_of(mask_of("N|E|F|N2E|E2F|F2N"), 2);
  ck_assert(c.full && !c.complete);
}
END_TEST

/* ---- text */

START_TEST(masks_are_printed_as_they_are_read)
{
  static const unsigned spaces[] = {0, GMDS_DIM2, GMDS_DIM3};
  for (int dim = 2; dim <= 3; dim++)
    for (size_t k = 0; k < gmds_census_size(dim); k++) {
      char text[128];
      unsigned mask = gmds_census_mask(dim, k) | spaces[k % 3], back = 0;
      gmds_mask_text(mask, sizeof text, text);
      if (gmds_mask_parse(text, NULL, &back) != GMDS_OK || back != mask)
        ck_abort_msg("%s is read as another mask", text);
    }
  char text[128];
  gmds_mask_text(mask_of("f2f|F2N"), sizeof text, text);
  ck_assert_str_eq(text, "N|F|F2N|F2F");
  gmds_mask_text(GMDS_DIM3 | 0xfffff, sizeof text, text);
  ck_assert_str_eq(text, "DIM3|N|E|F|R|N2N|N2E|N2F|N2R|E2N|E2E|E2F|E2R|F2N|F2E|F2F|F2R|R2N|R2E|R2F|R2R");
  char little[6];
  gmds_mask_text(mask_of("N|F|F2N"), sizeof little, little);
  ck_assert_uint_lt(strlen(little), sizeof little);
}
END_TEST

START_TEST(masks_are_read_with_blanks_in_any_order_and_case)
{
  ck_assert_uint_eq(mask_of("N|F|F2N"), GMDS_N | GMDS_F | F2N);
  ck_assert_uint_eq(mask_of("  f2n \t| n|F "), GMDS_N | GMDS_F | F2N);
  ck_assert_uint_eq(mask_of("F2E"), GMDS_E | GMDS_F | F2E);
  ck_assert_uint_eq(mask_of("N|N|N2N"), GMDS_N | N2N);
  ck_assert_uint_eq(mask_of("R2R|DIM3"), GMDS_R | R2R | GMDS_DIM3);
}
END_TEST

START_TEST(a_mask_that_is_wrong_is_refused_with_the_word_named)
{
  static const struct {
    const char *text, *word;
  } cases[] = {{"N|F|F2M", "'F2M'"},  {"N|F|", "''"},       {"", "''"},       {"N||F", "''"},
               {"N F", "before 'F'"}, {"N,F", "'N,F'"},     {"N|F2", "'F2'"}, {"2F|N", "'2F'"},
               {"N|DIM4", "'DIM4'"},  {"N|F2NN", "'F2NN'"}, {"|N", "''"},     {"N|F2N|GHOST", "'GHOST'"}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    gmds_error error = {0};
    unsigned mask = 12345;
    ck_assert_int_eq(gmds_mask_parse(cases[k].text, &error, &mask), GMDS_ERR_ARGUMENT);
    ck_assert_uint_eq(mask, 12345);
    ck_assert_int_eq(error.status, GMDS_ERR_ARGUMENT);
    if (!strstr(error.text, cases[k].word))
      ck_abort_msg("'%s': the sentence does not name %s: %s", cases[k].text, cases[k].word, error.text);
    ck_assert_int_eq(gmds_mask_parse(cases[k].text, NULL, &mask), GMDS_ERR_ARGUMENT);
  }
  char endless[2000];
  memset(endless, 'X', sizeof endless);
  endless[sizeof endless - 1] = 0;
  gmds_error error = {0};
  unsigned mask = 0;
  ck_assert_int_eq(gmds_mask_parse(endless, &error, &mask), GMDS_ERR_ARGUMENT);
  ck_assert_uint_lt(strlen(error.text), sizeof error.text);
}
END_TEST

START_TEST(advice_names_what_makes_the_query_possible)
{
  char text[256];
  gmds_path_advice(2, 0, sizeof text, text);
  ck_assert_str_eq(text, "add F2N, or F2E with E2N (the inverse of a relation will do, at the cost of a traversal)");
  gmds_path_advice(0, 1, sizeof text, text);
  ck_assert_str_eq(text, "add N2E (the inverse of a relation will do, at the cost of a traversal)");
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {
      gmds_path_advice(i, j, sizeof text, text);
      ck_assert_uint_lt(strlen(text) + 1, sizeof text);
      ck_assert_int_eq(strncmp(text, "add ", 4), 0);
      char *note = strstr(text, " (");
      ck_assert_ptr_nonnull(note);
      *note = 0;
      unsigned mask = 0;
      size_t ways = 0;
      for (char *word = strtok(text + 4, " ,"); word; word = strtok(NULL, " ,")) {
        if (strcmp(word, "with") == 0)
          continue;
        if (strcmp(word, "or") == 0) {
          ck_assert_int_le(gmds_path_of(mask, i, j).cost, GMDS_COST_LOCAL);
          mask = 0;
        } else
          mask |= mask_of(word);
        ways++;
      }
      ck_assert_uint_gt(ways, 0);
      ck_assert_int_le(gmds_path_of(mask, i, j).cost, GMDS_COST_LOCAL);
    }
}
END_TEST

START_TEST(every_cost_has_a_word)
{
  static const char *const words[] = {"direct", "local", "global", "mixed", "none"};
  for (int c = 0; c < GMDS_COST_COUNT; c++)
    ck_assert_str_eq(gmds_cost_text((gmds_cost)c), words[c]);
  ck_assert_ptr_nonnull(gmds_cost_text(GMDS_COST_COUNT));
}
END_TEST

RUN_SUITE("census", two_dimensions_have_128_masks_of_which_114_compute_and_96_identify,
          three_dimensions_have_8192_masks_of_which_7854_compute_and_5856_identify,
          every_row_of_table_4_is_among_the_105, matrices_of_f1_and_r2_are_as_printed,
          costs_follow_the_priorities_of_the_paper, exactness_depends_on_what_keeps_the_sides,
          full_and_complete_are_as_defined, masks_are_printed_as_they_are_read,
          masks_are_read_with_blanks_in_any_order_and_case, a_mask_that_is_wrong_is_refused_with_the_word_named,
          advice_names_what_makes_the_query_possible, every_cost_has_a_word)
