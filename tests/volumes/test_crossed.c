/* The ten named models of volumes: faces with the same nodes in different orders around, regions that are removed
 * together, flat tetrahedra whose order is not stored, and what a soup calls its attributes. */
#include "harness.h"
#include <gmds/cells.h>
#include <gmds/manifold.h>
#include <gmds/predicates.h>

typedef struct subject {
  const char *name;
  size_t bytes;
  void (*begin)(void *m);
  void (*end)(void *m);
  gmds_status (*add_node)(void *m, const double *x, gmds_id *id);
  gmds_status (*add_face)(void *m, size_t n, const gmds_id *nodes, gmds_id *id); /* NULL where none are kept */
  gmds_status (*add_region)(void *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id);
  gmds_status (*remove)(void *m, const gmds_ids *regions);
  gmds_status (*fill)(void *m, const gmds_soup *soup, gmds_error *error);
  gmds_status (*list)(void *m, gmds_soup *soup, gmds_error *error);
  gmds_status (*verify)(void *m, gmds_memory *memory, gmds_error *error);
  gmds_status (*look)(void *m, gmds_volume_report *report);
  size_t (*count)(void *m, int i);
  int compares; /* the model keeps faces, or R2R */
} subject;

#define RUN f1
#define NAMED <gmds/named/f1.h>
#include "volumes/crossed_model.h"
#define RUN f2
#define NAMED <gmds/named/f2.h>
#include "volumes/crossed_model.h"
#define RUN f3
#define NAMED <gmds/named/f3.h>
#include "volumes/crossed_model.h"
#define RUN f4
#define NAMED <gmds/named/f4.h>
#include "volumes/crossed_model.h"
#define RUN f5
#define NAMED <gmds/named/f5.h>
#include "volumes/crossed_model.h"
#define RUN f6
#define NAMED <gmds/named/f6.h>
#include "volumes/crossed_model.h"
#define RUN r1
#define NAMED <gmds/named/r1.h>
#include "volumes/crossed_model.h"
#define RUN r2
#define NAMED <gmds/named/r2.h>
#include "volumes/crossed_model.h"
#define RUN r3
#define NAMED <gmds/named/r3.h>
#include "volumes/crossed_model.h"
#define RUN r4
#define NAMED <gmds/named/r4.h>
#include "volumes/crossed_model.h"

#define RUN f2_tetrahedra
#define NAMED <gmds/named/f2.h>
#define SIMPLICES
#include "volumes/crossed_model.h"

static const subject *const subjects[] = {&f1_subject, &f2_subject, &f3_subject, &f4_subject, &f5_subject,
                                          &f6_subject, &r1_subject, &r2_subject, &r3_subject, &r4_subject};
enum { N_SUBJECTS = sizeof subjects / sizeof *subjects, NODES = 14 };

/* A cube, one on it, and one whose lower face has the nodes of the upper face of the first in another order. */
static const double points[NODES][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1},
                                        {0, 1, 1}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {3, 0, 0}, {3, 1, 0}};
static const gmds_id lower[8] = {0, 1, 2, 3, 4, 5, 6, 7}, upper[8] = {4, 5, 6, 7, 8, 9, 10, 11},
                     crossed[8] = {4, 6, 5, 7, 8, 9, 10, 11};

static gmds_memory memory;

static void *begin(const subject *s)
{
  void *m = malloc(s->bytes);
  s->begin(m);
  for (size_t v = 0; v < NODES; v++) {
    gmds_id id = 0;
    ck_assert_int_eq(s->add_node(m, points[v], &id), GMDS_OK);
  }
  return m;
}

static void finish(const subject *s, void *m)
{
  gmds_error error = {.status = GMDS_OK};
  gmds_memory_init(&memory, NULL);
  ck_assert_msg(s->verify(m, &memory, &error) == GMDS_OK, "%s: %s", s->name, error.text);
  s->end(m);
  free(m);
}

static void counts(const subject *s, void *m, size_t n[4])
{
  for (int i = 0; i < 4; i++)
    n[i] = s->count(m, i);
}

START_TEST(a_crossed_face_is_refused_and_changes_nothing)
{
  static const gmds_id turns[][4] = {{4, 5, 6, 7}, {6, 5, 4, 7}, {5, 6, 7, 4}};
  static const gmds_id other[][4] = {{4, 6, 5, 7}, {4, 5, 7, 6}, {7, 5, 6, 4}};
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    if (!s->add_face)
      continue;
    for (int alone = 0; alone < 2; alone++) {
      void *m = begin(s);
      gmds_id id = 0, first = 0;
      size_t before[4], after[4];
      if (!alone)
        ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, lower, &id), GMDS_OK);
      ck_assert_int_eq(s->add_face(m, 4, turns[0], &first), GMDS_OK);
      counts(s, m, before);
      for (size_t q = 0; q < 3; q++) {
        id = 77;
        ck_assert_msg(s->add_face(m, 4, other[q], &id) == GMDS_ERR_CONFLICT && id == 77, "%s: crossed %zu", s->name, q);
        ck_assert_int_eq(s->add_face(m, 4, turns[q], &id), GMDS_OK);
        ck_assert_uint_eq(id, first);
      }
      counts(s, m, after);
      ck_assert_int_eq(memcmp(before, after, sizeof before), 0);
      finish(s, m);
    }
  }
}
END_TEST

/* Polygons of five may have no side in common. */
START_TEST(a_star_of_five_is_no_pentagon)
{
  static const gmds_id pentagon[5] = {0, 1, 2, 3, 4}, star[5] = {0, 2, 4, 1, 3}, turned[5] = {2, 1, 0, 4, 3};
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    if (!s->add_face)
      continue;
    void *m = begin(s);
    gmds_id id = 0;
    if (s->add_face(m, 5, pentagon, &id) == GMDS_OK) {
      ck_assert_msg(s->add_face(m, 5, star, &id) == GMDS_ERR_CONFLICT, "%s", s->name);
      ck_assert_int_eq(s->add_face(m, 5, turned, &id), GMDS_OK);
      ck_assert_uint_eq(s->count(m, 2), 1);
    }
    finish(s, m);
  }
}
END_TEST

START_TEST(a_region_with_a_crossed_face_is_refused_or_reported)
{
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    void *m = begin(s);
    gmds_id id = 0;
    size_t before[4], after[4];
    gmds_volume_report report;
    ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, lower, &id), GMDS_OK);
    counts(s, m, before);
    id = 77;
    const gmds_status status = s->add_region(m, GMDS_HEXAHEDRON, crossed, &id);
    ck_assert_msg(status == (s->compares ? GMDS_ERR_CONFLICT : GMDS_OK), "%s: %s", s->name, gmds_status_text(status));
    if (s->compares) {
      counts(s, m, after);
      ck_assert(id == 77 && memcmp(before, after, sizeof before) == 0);
      ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, upper, &id), GMDS_OK);
    }
    ck_assert_int_eq(s->look(m, &report), GMDS_OK);
    ck_assert_uint_eq(report.crossed.count, !s->compares);
    ck_assert_int_eq(report.manifold, s->compares);
    ck_assert_uint_eq(report.repeated.count, 0);
    finish(s, m);
  }
}
END_TEST

static void begin_soup(gmds_soup *soup)
{
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(soup, &memory, 3);
  for (size_t v = 0; v < NODES; v++)
    ck_assert_int_eq(gmds_soup_add_point(soup, points[v]), GMDS_OK);
  ck_assert_int_eq(gmds_soup_add_cell(soup, GMDS_HEXAHEDRON, 8, lower), GMDS_OK);
}

START_TEST(a_soup_with_a_crossed_face_is_refused_by_a_sentence)
{
  static const gmds_id face[4] = {4, 5, 6, 7}, again[4] = {4, 6, 5, 7};
  for (size_t k = 0; k < N_SUBJECTS; k++)
    for (int which = 0; which < 3; which++) { /* a second region; a face of a region; a face listed twice */
      const subject *s = subjects[k];
      gmds_soup soup;
      gmds_error error = {.status = GMDS_OK};
      void *m = malloc(s->bytes);
      begin_soup(&soup);
      s->begin(m);
      if (which == 2)
        ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, face), GMDS_OK);
      if (which)
        ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, again), GMDS_OK);
      else
        ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_HEXAHEDRON, 8, crossed), GMDS_OK);
      const gmds_status status = s->fill(m, &soup, &error);
      if (s->compares || which == 2) {
        ck_assert_msg(status == GMDS_ERR_CONFLICT, "%s, %d: %s", s->name, which, gmds_status_text(status));
        ck_assert(error.status == status && strstr(error.text, "order"));
        ck_assert_uint_eq(s->count(m, 0), 0);
      } else
        ck_assert_msg(status == GMDS_OK, "%s: %s", s->name, error.text);
      s->end(m);
      free(m);
      gmds_soup_clear(&soup);
    }
}
END_TEST

START_TEST(a_mesh_that_is_not_empty_is_not_filled)
{
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    gmds_soup soup;
    gmds_error error = {.status = GMDS_OK};
    gmds_id id = 0;
    size_t before[4], after[4];
    begin_soup(&soup);
    void *m = begin(s);
    ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, upper, &id), GMDS_OK);
    counts(s, m, before);
    ck_assert_int_eq(s->fill(m, &soup, &error), GMDS_ERR_ARGUMENT);
    ck_assert(error.status == GMDS_ERR_ARGUMENT && error.text[0]);
    counts(s, m, after);
    ck_assert_int_eq(memcmp(before, after, sizeof before), 0);
    gmds_soup_clear(&soup);
    finish(s, m);
  }
}
END_TEST

/* Every allocation fails in turn: the complex is empty, and the sentence is that of what has failed. */
START_TEST(a_complex_that_cannot_be_listed_is_empty)
{
  size_t listing = 0, joining = 0;
  r1_mesh *m = begin(&r1_subject);
  gmds_id id = 0;
  ck_assert_int_eq(r1_add_region(m, GMDS_HEXAHEDRON, lower, &id), GMDS_OK);
  for (long k = 0, done = 0; !done; k++) {
    failing f = {.until = k};
    const gmds_allocator allocator = failing_allocator(&f);
    gmds_memory scarce;
    gmds_complex c;
    gmds_error error = {.status = GMDS_OK};
    gmds_memory_init(&scarce, &allocator);
    gmds_complex_init(&c, &scarce, 0);
    const gmds_status status = r1_get_complex(m, &c, &error);
    done = status == GMDS_OK;
    ck_assert(done || (status == GMDS_ERR_MEMORY && error.status == status && !c.nodes[3].n && !f.live));
    listing += strstr(error.text, "listing the cells") != NULL;
    joining += strstr(error.text, "joining 0 faces and 1 regions") != NULL;
    ck_assert_uint_eq(listing + joining, (size_t)(done ? k : k + 1));
    gmds_complex_clear(&c);
    ck_assert_uint_eq(f.live, 0);
  }
  ck_assert(listing > 1 && joining > 1);
  finish(&r1_subject, m);
}
END_TEST

START_TEST(regions_with_the_same_nodes_are_reported)
{
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    void *m = begin(s);
    gmds_id id = 0;
    gmds_volume_report report;
    for (int q = 0; q < 2; q++)
      ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, lower, &id), GMDS_OK);
    ck_assert_int_eq(s->look(m, &report), GMDS_OK);
    ck_assert(report.repeated.count == 1 && report.repeated.first[0] == 1);
    ck_assert(!report.border.count && !report.surface.closed); /* nothing is left of the border */
    finish(s, m);
  }
}
END_TEST

START_TEST(regions_are_removed_together_or_not_at_all)
{
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    void *m = begin(s);
    gmds_id all[3] = {0, 0, 0};
    size_t before[4], after[4];
    ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, lower, &all[0]), GMDS_OK);
    ck_assert_int_eq(s->add_region(m, GMDS_HEXAHEDRON, upper, &all[1]), GMDS_OK);
    counts(s, m, before);
    all[2] = all[0];
    ck_assert_int_eq(s->remove(m, &(gmds_ids){.data = all, .n = 3}), GMDS_ERR_ARGUMENT);
    all[2] = 5;
    ck_assert_int_eq(s->remove(m, &(gmds_ids){.data = all, .n = 3}), GMDS_ERR_CELL);
    all[2] = GMDS_NONE;
    ck_assert_int_eq(s->remove(m, &(gmds_ids){.data = all, .n = 3}), GMDS_ERR_CELL);
    counts(s, m, after);
    ck_assert_int_eq(memcmp(before, after, sizeof before), 0);
    ck_assert_int_eq(s->remove(m, &(gmds_ids){.data = all, .n = 0}), GMDS_OK);
    const gmds_status status = s->remove(m, &(gmds_ids){.data = all, .n = 2});
    ck_assert_msg(status == GMDS_OK || status == GMDS_ERR_UNSUPPORTED, "%s", s->name);
    ck_assert_uint_eq(s->count(m, 3), status == GMDS_OK ? 0 : 2);
    finish(s, m);
  }
}
END_TEST

/* ---- flat tetrahedra */

/* Four points near a plane: a tilted one, rounded; one through a diagonal but for the last bits; one of a grid. */
static void make_flat(size_t kind, uint64_t *seed, double x[4][3])
{
  for (int k = 0; k < 4; k++) {
    const double a = random_unit(seed), b = random_unit(seed), last = 0x1p-52 * (double)random_below(seed, 3);
    const double i = (double)random_below(seed, 9), j = (double)random_below(seed, 9);
    const double of_kind[3][3] = {{a, b, 0.3 * a + 0.7 * b}, {1 + a, b, 1 + a + last}, {i, j, i + 2 * j}};
    memcpy(x[k], of_kind[kind], sizeof of_kind[kind]);
  }
}

static void tetrahedra_are_turned(const subject *s)
{
  enum { ROUNDS = 3000 };
  gmds_soup soup;
  gmds_volume_report report;
  uint64_t seed = 71;
  size_t flat = 0;
  void *m = malloc(s->bytes);
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 3);
  s->begin(m);
  for (size_t k = 0; k < ROUNDS; k++) {
    double x[4][3];
    gmds_id v[4], id = 0;
    make_flat(k % 3, &seed, x);
    for (int q = 0; q < 4; q++)
      ck_assert_int_eq(s->add_node(m, x[q], &v[q]), GMDS_OK);
    if (gmds_orient3d(x[0], x[1], x[2], x[3]) < 0) { /* models that store the order keep this one */
      const gmds_id swap = v[0];
      v[0] = v[1];
      v[1] = swap;
    }
    ck_assert_int_eq(s->add_region(m, GMDS_TETRAHEDRON, v, &id), GMDS_OK);
  }
  ck_assert_int_eq(s->list(m, &soup, NULL), GMDS_OK);
  for (size_t c = 0; c < ROUNDS; c++) {
    const gmds_id *v = soup.corners + soup.begin[c];
    const double *p = soup.points;
    const int sign = gmds_orient3d(p + 3 * v[0], p + 3 * v[1], p + 3 * v[2], p + 3 * v[3]);
    ck_assert_msg(sign >= 0, "%s: tetrahedron %zu is inverted", s->name, c);
    flat += sign == 0;
  }
  ck_assert_int_eq(s->look(m, &report), GMDS_OK);
  ck_assert_uint_eq(report.inverted.count, 0);
  ck_assert_uint_eq(report.degenerate.count, flat);
  ck_assert_msg(flat >= ROUNDS / 3 && flat < ROUNDS / 2, "%zu of %d are flat", flat, ROUNDS);
  s->end(m);
  free(m);
  gmds_soup_clear(&soup);
}

START_TEST(flat_tetrahedra_come_back_turned_outwards)
{
  for (size_t k = 0; k < N_SUBJECTS; k++)
    tetrahedra_are_turned(subjects[k]);
  tetrahedra_are_turned(&f2_tetrahedra_subject);
}
END_TEST

/* ---- what a soup calls its attributes */

static void set_cells(gmds_soup *soup, const char *name, double from)
{
  gmds_attribute *a = NULL;
  ck_assert_int_eq(gmds_soup_add_attribute(soup, GMDS_OF_CELLS, name, GMDS_DOUBLE, 1, &a), GMDS_OK);
  for (size_t c = 0; c < soup->n_cells; c++)
    ((double *)a->data)[c] = from + (double)c;
}

START_TEST(attributes_come_back_under_any_name)
{
  static const char *const names[] = {"stress", "stress (MPa)",  "stress (2)", "listed",      "listed (2)",
                                      "vertex", "vertex normal", "T (K)",      "T",           "again T",
                                      "normal", "turn 2",        "vertex T",   "vertex T (2)"};
  enum { N_NAMES = sizeof names / sizeof *names };
  static const gmds_id face[4] = {4, 5, 6, 7}, turned[4] = {6, 5, 4, 7}, vertex = 12;
  for (size_t k = 0; k < N_SUBJECTS; k++) {
    const subject *s = subjects[k];
    gmds_soup soup, back;
    gmds_error error = {.status = GMDS_OK};
    void *m = malloc(s->bytes);
    begin_soup(&soup);
    gmds_soup_init(&back, &memory, 3);
    s->begin(m);
    soup.n_cells = 0; /* in the order in which they come back */
    for (int q = 0; q < 2; q++)
      ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_VERTEX, 1, &vertex), GMDS_OK);
    if (s->add_face) {
      ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, face), GMDS_OK);
      ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_QUADRILATERAL, 4, turned), GMDS_OK);
    }
    ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_HEXAHEDRON, 8, lower), GMDS_OK);
    for (size_t a = 0; a < N_NAMES; a++)
      set_cells(&soup, names[a], 100.0 * (double)a);
    ck_assert_msg(s->fill(m, &soup, &error) == GMDS_OK, "%s: %s", s->name, error.text);
    ck_assert_msg(s->list(m, &back, &error) == GMDS_OK, "%s: %s", s->name, error.text);
    ck_assert_uint_eq(back.n_cells, soup.n_cells);
    ck_assert_mem_eq(back.corners, soup.corners,
                     soup.begin[soup.n_cells - 1] * sizeof *soup.corners); /* but the region */
    size_t n = 0;
    for (const gmds_attribute *a = back.attributes[GMDS_OF_CELLS]; a; a = a->next)
      n++;
    ck_assert_uint_eq(n, N_NAMES);
    ck_assert_ptr_null(back.attributes[GMDS_OF_POINTS]);
    for (size_t a = 0; a < N_NAMES; a++) {
      const gmds_attribute *column = gmds_soup_find_attribute(&back, GMDS_OF_CELLS, names[a]);
      ck_assert_msg(column != NULL, "%s: %s is lost", s->name, names[a]);
      for (size_t c = 0; c < soup.n_cells; c++)
        ck_assert_msg(((const double *)column->data)[c] == 100.0 * (double)a + (double)c, "%s: %s of cell %zu is %g",
                      s->name, names[a], c, ((const double *)column->data)[c]);
    }
    s->end(m);
    free(m);
    gmds_soup_clear(&soup);
    gmds_soup_clear(&back);
  }
}
END_TEST

/* Names have 480 bytes at most: what a mesh adds to them must fit. */
START_TEST(a_name_that_is_too_long_is_refused)
{
  enum { LONGEST = 480 };
  for (size_t more = 0; more < 2; more++) {
    char name[LONGEST + 2];
    gmds_soup soup, back;
    gmds_error error = {.status = GMDS_OK};
    r3_mesh m;
    memset(name, 'x', sizeof name);
    name[LONGEST + more] = 0;
    begin_soup(&soup);
    gmds_soup_init(&back, &memory, 3);
    r3_mesh_init(&m, NULL);
    for (int q = 0; q < 2; q++) /* the second time needs the longest names */
      ck_assert_int_eq(gmds_soup_add_cell(&soup, GMDS_VERTEX, 1, &upper[0]), GMDS_OK);
    set_cells(&soup, name, 5);
    ck_assert_int_eq(r3_from_soup(&m, &soup, &error), more ? GMDS_ERR_ARGUMENT : GMDS_OK);
    ck_assert(!more || strstr(error.text, "a name of more than 480 bytes"));
    if (!more) {
      ck_assert_int_eq(r3_to_soup(&m, &back, &error), GMDS_OK);
      const gmds_attribute *a = gmds_soup_find_attribute(&back, GMDS_OF_CELLS, name);
      ck_assert(a && ((const double *)a->data)[0] == 6 && ((const double *)a->data)[1] == 7);
    }
    r3_mesh_clear(&m);
    gmds_soup_clear(&soup);
    gmds_soup_clear(&back);
  }
}
END_TEST

START_TEST(a_reserved_name_is_refused)
{
  for (int place = 0; place < GMDS_PLACE_COUNT; place++) {
    gmds_soup soup;
    gmds_attribute *a = NULL;
    gmds_error error = {.status = GMDS_OK};
    f1_mesh m;
    begin_soup(&soup);
    f1_mesh_init(&m, NULL);
    ck_assert_int_eq(gmds_soup_add_attribute(&soup, (gmds_place)place, "gmds:listed", GMDS_INT, 1, &a), GMDS_OK);
    ck_assert_int_eq(f1_from_soup(&m, &soup, &error), GMDS_ERR_ARGUMENT);
    ck_assert_msg(strstr(error.text, "'gmds:listed'") && strstr(error.text, "reserved"), "%s", error.text);
    f1_mesh_clear(&m);
    gmds_soup_clear(&soup);
  }
}
END_TEST

RUN_SUITE("crossed faces", a_crossed_face_is_refused_and_changes_nothing, a_star_of_five_is_no_pentagon,
          a_region_with_a_crossed_face_is_refused_or_reported, a_soup_with_a_crossed_face_is_refused_by_a_sentence,
          a_mesh_that_is_not_empty_is_not_filled, a_complex_that_cannot_be_listed_is_empty,
          regions_with_the_same_nodes_are_reported, regions_are_removed_together_or_not_at_all,
          flat_tetrahedra_come_back_turned_outwards, attributes_come_back_under_any_name,
          a_name_that_is_too_long_is_refused, a_reserved_name_is_refused)
