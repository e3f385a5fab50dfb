/* The comparison of a mesh with its reference. */
#include "models/subject.h"

static void compare_cells(subject *s)
{
  gmds_cells *cells = s->m->do_cells(s->mesh);
  const reference *r = &s->ref;
  for (int i = 0; i < 3; i++) {
    const gmds_attribute *tags = gmds_attribute_find(&cells[i], "tag");
    if (i == 1 && !makes_edges(s->m))
      continue;
    if (cells[i].count != reference_count(r, i))
      subject_fail(s, "%zu cells of dimension %d, expected %zu", cells[i].count, i, reference_count(r, i));
    for (gmds_id c = gmds_cells_next(&cells[i], 0); c != GMDS_NONE; c = gmds_cells_next(&cells[i], c + 1)) {
      if (!reference_has(r, i, c))
        subject_fail(s, "cell %lu of dimension %d should be gone", (unsigned long)c, i);
      int64_t tag = i == 0 ? r->nodes[c].tag : i == 1 ? r->edges[c].tag : r->faces[c].tag;
      if (((const int64_t *)tags->data)[c] != tag)
        subject_fail(s, "the attribute of cell %lu of dimension %d was lost", (unsigned long)c, i);
    }
  }
  for (gmds_id v = 0; v < r->end[0]; v++)
    for (int k = 0; r->nodes[v].alive && k < s->m->dim; k++)
      if (s->m->do_point(s->mesh, v)[k] != r->nodes[v].x[k])
        subject_fail(s, "the coordinates of node %lu were lost", (unsigned long)v);
}

/* One answer against the reference: as a set; in order where the model promises it. */
static void compare_answer(subject *s, int i, int j, gmds_id c, const gmds_id *data, size_t n, const char *what)
{
  answer expected, found = {.n = n};
  int ordered = i == 2 && s->m->ordered && (j == 0 || (j == 1 && stores(s->m, 2, 1)));
  if (n > MAX_ANSWER)
    subject_fail(s, "%s %d->%d of %lu: %zu cells", what, i, j, (unsigned long)c, n);
  if (n)
    memcpy(found.data, data, n * sizeof *data);
  reference_query(&s->ref, i, j, c, &expected);
  if (!ordered) {
    answer_sort(&found);
    answer_sort(&expected);
  }
  if (!answer_equal(&found, &expected))
    subject_fail(s, "%s %d->%d of %lu: %zu cells (%ld %ld %ld ...), expected %zu (%ld %ld %ld ...)", what, i, j,
                 (unsigned long)c, found.n, found.n > 0 ? (long)found.data[0] : -1,
                 found.n > 1 ? (long)found.data[1] : -1, found.n > 2 ? (long)found.data[2] : -1, expected.n,
                 expected.n > 0 ? (long)expected.data[0] : -1, expected.n > 1 ? (long)expected.data[1] : -1,
                 expected.n > 2 ? (long)expected.data[2] : -1);
}

static void compare_query(subject *s, int i, int j)
{
  gmds_csr csr;
  size_t end = s->m->do_cells(s->mesh)[i].end;
  gmds_csr_init(&csr, &s->memory);
  if (s->m->do_bulk(s->mesh, i, j, &csr) != GMDS_OK || csr.n != end)
    subject_fail(s, "all_adj %d->%d has %zu rows, expected %zu", i, j, csr.n, end);
  for (gmds_id c = 0; c < end; c++) {
    size_t begin = csr.begin[c], n = csr.begin[c + 1] - begin;
    gmds_status status = s->m->do_query(s->mesh, i, j, c, &s->list);
    if (!reference_has(&s->ref, i, c)) {
      if (status != GMDS_ERR_CELL || n)
        subject_fail(s, "%d->%d of %lu, which is not alive, is answered", i, j, (unsigned long)c);
      continue;
    }
    if (status != GMDS_OK)
      subject_fail(s, "get_adj %d->%d of %lu: %s", i, j, (unsigned long)c, gmds_status_text(status));
    compare_answer(s, i, j, c, s->list.data, s->list.n, "get_adj");
    compare_answer(s, i, j, c, n ? csr.data + begin : NULL, n, "all_adj");
  }
  gmds_csr_clear(&csr);
}

/* A view shows what the queries answer: the same set, in the order of the sides where it is a face's. */
static void compare_views(subject *s)
{
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      for (gmds_id c = 0; s->m->view[i][j] && c < s->ref.end[i]; c++) {
        size_t n = 0;
        if (!reference_has(&s->ref, i, c))
          continue;
        const gmds_id *row = s->m->do_view(s->mesh, i, j, c, &n);
        compare_answer(s, i, j, c, row, n, "view");
      }
}

/* The table of edges has each side of the faces once, in order, and in the row of each face the edges of its sides: of
 * side k where the model keeps the order, else of some side. */
static void compare_edges(subject *s)
{
  const reference *r = &s->ref;
  gmds_edge_table t;
  size_t sides = 0, n = 0;
  gmds_edge_table_init(&t, &s->memory);
  if (s->m->do_all_edges(s->mesh, &t) != GMDS_OK || t.n_faces != s->m->do_cells(s->mesh)[2].end)
    subject_fail(s, "the table of edges has %zu faces", t.n_faces);
  for (size_t e = 0; e < t.n; e++) {
    gmds_id a = t.nodes[2 * e], b = t.nodes[2 * e + 1];
    answer on;
    reference_faces_on(r, a, b, &on);
    if (a >= b || !on.n)
      subject_fail(s, "edge %zu of the table, from %lu to %lu, is no side", e, (unsigned long)a, (unsigned long)b);
    for (size_t other = 0; other < e; other++)
      if (t.nodes[2 * other] > a || (t.nodes[2 * other] == a && t.nodes[2 * other + 1] == b))
        subject_fail(s, "edge %zu of the table comes after, or is, edge %zu", other, e);
  }
  for (gmds_id f = 0; f < t.n_faces; f++) {
    const gmds_id *row = gmds_edge_table_row(&t, f, &n);
    const reference_face *face = &r->faces[f];
    if (!face->alive) {
      for (size_t k = 0; k < n; k++)
        if (row[k] != GMDS_NONE)
          subject_fail(s, "face %lu of the table is not alive, and has edges", (unsigned long)f);
      continue;
    }
    sides += n;
    if (n != face->n)
      subject_fail(s, "face %lu of the table has %zu edges", (unsigned long)f, n);
    for (size_t k = 0; k < n; k++) {
      gmds_id a = t.nodes[2 * row[k]], b = t.nodes[2 * row[k] + 1];
      gmds_id p = face->nodes[k], q = face->nodes[(k + 1) % n];
      int right = s->m->ordered ? (a == p && b == q) || (a == q && b == p) : reference_has_side(r, f, a, b);
      for (size_t before = 0; before < k; before++)
        right &= row[before] != row[k];
      if (row[k] >= t.n || !right)
        subject_fail(s, "side %zu of face %lu is edge %lu of the table", k, (unsigned long)f, (unsigned long)row[k]);
    }
  }
  size_t expected = 0;
  for (gmds_id f = 0; f < r->end[2]; f++)
    expected += r->faces[f].alive ? r->faces[f].n : 0;
  if (sides != expected)
    subject_fail(s, "the table has %zu sides, expected %zu", sides, expected);
  gmds_edge_table_clear(&t);
}

/* across() names the one other face on a side and the number of the side there, or nothing. */
static void compare_across(subject *s)
{
  const reference *r = &s->ref;
  for (gmds_id f = 0; f < r->end[2]; f++)
    for (unsigned k = 0; r->faces[f].alive && k < r->faces[f].n; k++) {
      const reference_face *face = &r->faces[f];
      gmds_id a = face->nodes[k], b = face->nodes[(k + 1) % face->n];
      unsigned arrival = 0;
      answer on;
      reference_faces_on(r, a, b, &on);
      gmds_id g = s->m->do_across(s->mesh, f, k, &arrival), expected = GMDS_NONE;
      if (on.n == 2)
        expected = on.data[on.data[0] == f];
      if (g != expected)
        subject_fail(s, "beyond side %u of face %lu lies %ld, expected %ld", k, (unsigned long)f, (long)g,
                     (long)expected);
      if (g == GMDS_NONE)
        continue;
      const reference_face *other = &r->faces[g];
      gmds_id p = other->nodes[arrival % other->n], q = other->nodes[(arrival + 1) % other->n];
      if (arrival >= other->n || !((p == a && q == b) || (p == b && q == a)))
        subject_fail(s, "side %u of face %lu arrives at side %u of face %lu", k, (unsigned long)f, arrival,
                     (unsigned long)g);
    }
}

void subject_compare(subject *s)
{
  compare_cells(s);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (s->m->can[i][j])
        compare_query(s, i, j);
  compare_views(s);
  if (s->m->do_all_edges)
    compare_edges(s);
  if (s->m->crosses)
    compare_across(s);
  gmds_error error = {0};
  if (s->m->do_check(s->mesh, &s->memory, &error) != GMDS_OK)
    subject_fail(s, "check: %s", error.text);
  s->list.n = 0;
}
