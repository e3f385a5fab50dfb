/* Operations on a mesh and on its reference. */
#include "models/subject.h"
#include <limits.h>
#include <stdarg.h>

void subject_fail_at(const subject *s, int line, const char *format, ...)
{
  char text[400];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  ck_abort_msg("%s, after %zu operations, attempt %ld, line %d: %s", s->m->name, s->done + s->refused, s->attempt, line,
               text);
}

/* ---- what a mask implies */

int stores(const model *m, int i, int j)
{
  return (m->mask >> (4 + 4 * i + j)) & 1;
}

int links_edges(const model *m)
{
  return stores(m, 0, 1) || stores(m, 1, 0);
}

int makes_edges(const model *m)
{
  return links_edges(m) || stores(m, 1, 2) || stores(m, 2, 1);
}

int finds_faces(const model *m)
{
  int knows_sides = m->faces == 1 || stores(m, 2, 0);
  return ((stores(m, 0, 2) || stores(m, 2, 0)) && knows_sides) ||
         (links_edges(m) && (stores(m, 1, 2) || stores(m, 2, 1)));
}

int needs_links(const model *m)
{
  return (stores(m, 2, 2) || (makes_edges(m) && !links_edges(m))) && !finds_faces(m);
}

int allows(const model *m, size_t n)
{
  return (n == 3 && m->faces & 1) || (n == 4 && m->faces & 2) || (n >= 3 && m->faces & 4);
}

gmds_edges usual_edges(const model *m)
{
  return makes_edges(m) && !links_edges(m) ? GMDS_DROP_BARE_EDGES : GMDS_KEEP_EDGES;
}

/* ---- life */

void subject_begin(subject *s, const model *m, uint64_t seed)
{
  memset(s, 0, sizeof *s);
  s->m = m;
  s->seed = seed;
  s->mesh = malloc(m->bytes);
  ck_assert_ptr_nonnull(s->mesh);
  s->from.until = LONG_MAX;
  gmds_memory_init(&s->memory, NULL);
  gmds_ids_init(&s->list, &s->memory);
  gmds_allocator allocator = failing_allocator(&s->from);
  m->do_init(s->mesh, &allocator);
  for (int i = 0; i < 3; i++) {
    gmds_attribute *attribute = NULL;
    ck_assert_int_eq(gmds_attribute_add(&m->do_cells(s->mesh)[i], "tag", GMDS_LONG, 1, &attribute), GMDS_OK);
  }
}

void subject_end(subject *s)
{
  ck_assert_uint_eq(s->m->do_memory(s->mesh)->live, s->from.live);
  s->m->do_clear(s->mesh);
  gmds_ids_clear(&s->list);
  if (s->from.live || s->memory.live)
    subject_fail(s, "%zu and %zu bytes leaked", s->from.live, s->memory.live);
  free(s->mesh);
}

void begin_attempts(subject *s)
{
  s->attempt = 0;
  s->from.until = s->inject ? 0 : LONG_MAX;
}

int again(subject *s, gmds_status status)
{
  s->from.until = LONG_MAX;
  if (!s->inject || status != GMDS_ERR_MEMORY)
    return 0;
  subject_compare(s);
  s->from.until = ++s->attempt;
  return 1;
}

static void expect(subject *s, const char *what, gmds_status status, gmds_status expected)
{
  if (status != expected)
    subject_fail(s, "%s gave '%s', expected '%s'", what, gmds_status_text(status), gmds_status_text(expected));
  if (expected == GMDS_OK)
    s->done++;
  else
    s->refused++;
}

/* ---- creation */

/* A new cell has an identifier that was free, the lowest holes first, and attributes of 0; it gets a tag. */
static int64_t enter(subject *s, int i, gmds_id id)
{
  gmds_cells *cells = &s->m->do_cells(s->mesh)[i];
  static const size_t room[3] = {MAX_NODES, MAX_EDGES, MAX_FACES};
  if (id >= room[i] || reference_has(&s->ref, i, id) || !gmds_cells_has(cells, id))
    subject_fail(s, "cell %lu of dimension %d is not new", (unsigned long)id, i);
  int64_t *tag = (int64_t *)gmds_attribute_find(cells, "tag")->data + id;
  if (*tag != 0)
    subject_fail(s, "cell %lu of dimension %d comes with an old attribute", (unsigned long)id, i);
  if (id >= s->ref.end[i])
    s->ref.end[i] = id + (size_t)1;
  return *tag = ++s->tags;
}

gmds_id subject_add_node(subject *s)
{
  double x[3] = {random_unit(&s->seed), random_unit(&s->seed), random_unit(&s->seed)};
  gmds_id id = GMDS_NONE;
  gmds_status status;
  begin_attempts(s);
  do
    status = s->m->do_add_node(s->mesh, x, &id);
  while (again(s, status));
  expect(s, "add_node", status, GMDS_OK);
  int64_t tag = enter(s, 0, id);
  s->ref.nodes[id] = (reference_node){1, {x[0], x[1], x[2]}, tag};
  return id;
}

static void enter_edge(subject *s, gmds_id e, gmds_id a, gmds_id b)
{
  int64_t tag = enter(s, 1, e);
  s->ref.edges[e] = (reference_edge){1, a, b, tag};
}

void subject_add_edge(subject *s, gmds_id a, gmds_id b)
{
  gmds_id id = GMDS_NONE, known = reference_edge_between(&s->ref, a, b);
  gmds_status status;
  begin_attempts(s);
  do
    status = s->m->do_add_edge(s->mesh, a, b, &id);
  while (again(s, status));
  expect(s, "add_edge", status, GMDS_OK);
  if (known == GMDS_NONE)
    enter_edge(s, id, a, b);
  else if (id != known)
    subject_fail(s, "add_edge(%lu, %lu) made an edge that there is", (unsigned long)a, (unsigned long)b);
}

/* The edges that came with face f, where edges know their nodes: each is found again under its nodes. */
static void enter_linked_edges(subject *s, const reference_face *face)
{
  for (size_t k = 0; k < face->n; k++) {
    gmds_id a = face->nodes[k], b = face->nodes[(k + 1) % face->n], id = GMDS_NONE;
    gmds_id known = reference_edge_between(&s->ref, a, b);
    size_t before = s->m->do_cells(s->mesh)[1].count;
    gmds_status status = s->m->do_add_edge(s->mesh, a, b, &id);
    if (status != GMDS_OK || s->m->do_cells(s->mesh)[1].count != before)
      subject_fail(s, "a face came without its edge (%lu, %lu)", (unsigned long)a, (unsigned long)b);
    if (known == GMDS_NONE)
      enter_edge(s, id, a, b);
    else if (id != known)
      subject_fail(s, "the edge (%lu, %lu) was made twice", (unsigned long)a, (unsigned long)b);
  }
}

static int same_faces(const reference *r, gmds_id e, gmds_id x)
{
  answer p, q;
  reference_query(r, 1, 2, e, &p);
  reference_query(r, 1, 2, x, &q);
  return answer_equal(&p, &q);
}

/* Where edges know faces alone, two edges with the same faces are told apart by nothing: if the model took the other
 * one, their nodes change places in the reference. */
static void swap_alike(subject *s, gmds_id wanted, const answer *ids, const answer *taken)
{
  reference *r = &s->ref;
  for (size_t k = 0; k < ids->n; k++) {
    gmds_id e = ids->data[k];
    if (answer_has(taken, e) || !reference_has(r, 1, e) || !same_faces(r, e, wanted))
      continue;
    reference_edge *p = &r->edges[e], *q = &r->edges[wanted], old = *p;
    p->a = q->a;
    p->b = q->b;
    q->a = old.a;
    q->b = old.b;
    return;
  }
  subject_fail(s, "no edge of a new face is like the edge %lu that it must have", (unsigned long)wanted);
}

/* The edges of a new face where edges know faces alone. `face` is not in the reference yet. */
static void enter_edges_of_faces(subject *s, gmds_id f, const reference_face *face)
{
  answer ids = {0}, taken = {0};
  ck_assert_int_eq(s->m->do_query(s->mesh, 2, 1, f, &s->list), GMDS_OK);
  for (size_t k = 0; k < s->list.n; k++)
    answer_add(&ids, s->list.data[k]);
  if (ids.n != face->n)
    subject_fail(s, "face %lu of %zu sides has %zu edges", (unsigned long)f, face->n, ids.n);
  int exact = stores(s->m, 2, 0) && stores(s->m, 2, 1);
  for (size_t k = 0; k < face->n; k++) {
    gmds_id known = reference_edge_between(&s->ref, face->nodes[k], face->nodes[(k + 1) % face->n]);
    if (known != GMDS_NONE && exact && ids.data[k] != known)
      subject_fail(s, "side %zu of face %lu has another edge than the face beyond", k, (unsigned long)f);
    if (known != GMDS_NONE && answer_has(&ids, known))
      answer_add(&taken, known);
  }
  for (size_t k = 0; k < face->n; k++) {
    gmds_id known = reference_edge_between(&s->ref, face->nodes[k], face->nodes[(k + 1) % face->n]);
    if (known == GMDS_NONE || answer_has(&ids, known))
      continue;
    swap_alike(s, known, &ids, &taken);
    answer_add(&taken, reference_edge_between(&s->ref, face->nodes[k], face->nodes[(k + 1) % face->n]));
  }
  for (size_t k = 0; k < face->n; k++) {
    gmds_id a = face->nodes[k], b = face->nodes[(k + 1) % face->n], fresh = exact ? ids.data[k] : GMDS_NONE;
    if (reference_edge_between(&s->ref, a, b) != GMDS_NONE)
      continue;
    for (size_t q = 0; q < ids.n && !exact; q++)
      if (!answer_has(&taken, ids.data[q]))
        fresh = ids.data[q];
    answer_add(&taken, fresh);
    enter_edge(s, fresh, a, b);
  }
}

gmds_status subject_add_face(subject *s, size_t n, const gmds_id *nodes, knows known)
{
  reference_face face = {.alive = 1, .n = n};
  gmds_id edges[MAX_SIDES], faces[MAX_SIDES], id = GMDS_NONE;
  int third = 0;
  for (size_t k = 0; k < n; k++) {
    answer on = {0};
    face.nodes[k] = nodes[k];
    edges[k] = reference_edge_between(&s->ref, nodes[k], nodes[(k + 1) % n]);
    reference_faces_on(&s->ref, nodes[k], nodes[(k + 1) % n], &on);
    faces[k] = on.n ? on.data[0] : GMDS_NONE;
    third |= on.n > 1;
  }
  const gmds_links links = {known & KNOWS_EDGES ? edges : NULL, known & KNOWS_FACES ? faces : NULL};
  gmds_status status, expected = third && stores(s->m, 2, 2) ? GMDS_ERR_CONFLICT : GMDS_OK;
  int looks = (stores(s->m, 2, 2) && !links.faces) || (makes_edges(s->m) && !links_edges(s->m) && !links.edges);
  if (looks && !finds_faces(s->m))
    expected = GMDS_ERR_UNSUPPORTED;
  else if (expected == GMDS_ERR_CONFLICT && links.faces && !s->m->ordered)
    return GMDS_ERR_CONFLICT; /* what the caller says is believed: no third face may be named here */
  begin_attempts(s);
  do
    status = s->m->do_add_face(s->mesh, n, nodes, known == KNOWS_NOTHING ? NULL : &links, &id);
  while (again(s, status));
  expect(s, "add_face", status, expected);
  if (status != GMDS_OK)
    return status;
  if (links_edges(s->m))
    enter_linked_edges(s, &face);
  else if (makes_edges(s->m))
    enter_edges_of_faces(s, id, &face);
  face.tag = enter(s, 2, id);
  s->ref.faces[id] = face;
  return GMDS_OK;
}

/* ---- deletion */

/* What remove_face gives: nothing may be forgotten that the model cannot find. */
static gmds_status removal(const model *m, gmds_edges edges)
{
  int drops = edges == GMDS_DROP_BARE_EDGES;
  if (stores(m, 0, 0) && !links_edges(m) && (!m->can[2][0] || ((!makes_edges(m) || drops) && !finds_faces(m))))
    return GMDS_ERR_UNSUPPORTED;
  if (makes_edges(m) && drops && (!m->can[2][1] || !m->can[1][2]))
    return GMDS_ERR_UNSUPPORTED;
  return GMDS_OK;
}

static void forget_face(subject *s, gmds_id f, gmds_edges edges)
{
  reference_face *face = &s->ref.faces[f];
  face->alive = 0;
  if (!makes_edges(s->m) || edges == GMDS_KEEP_EDGES)
    return;
  for (size_t k = 0; k < face->n; k++) {
    gmds_id e = reference_edge_between(&s->ref, face->nodes[k], face->nodes[(k + 1) % face->n]);
    answer on;
    reference_query(&s->ref, 1, 2, e, &on);
    if (!on.n)
      s->ref.edges[e].alive = 0;
  }
}

void subject_remove_face(subject *s, gmds_id f, gmds_edges edges)
{
  gmds_status status;
  begin_attempts(s);
  do
    status = s->m->do_remove_face(s->mesh, f, edges);
  while (again(s, status));
  expect(s, "remove_face", status, removal(s->m, edges));
  if (status == GMDS_OK)
    forget_face(s, f, edges);
}

void subject_remove_edge(subject *s, gmds_id e, gmds_around around)
{
  answer faces;
  reference_query(&s->ref, 1, 2, e, &faces);
  gmds_status status, expected = GMDS_OK;
  if (!s->m->can[1][2]) {
    expected = s->m->path[1][2] ? GMDS_ERR_UNSUPPORTED : GMDS_OK;
    if (faces.n && !s->m->path[1][2])
      return; /* the model does not know of the faces there */
  } else if (faces.n && around == GMDS_REFUSE)
    expected = GMDS_ERR_CONFLICT;
  else if (!links_edges(s->m))
    return; /* it would leave edges that nothing tells apart */
  begin_attempts(s);
  do
    status = s->m->do_remove_edge(s->mesh, e, around);
  while (again(s, status));
  expect(s, "remove_edge", status, expected);
  if (status != GMDS_OK)
    return;
  for (size_t k = 0; k < faces.n; k++)
    forget_face(s, faces.data[k], GMDS_KEEP_EDGES);
  s->ref.edges[e].alive = 0;
}

void subject_remove_node(subject *s, gmds_id v, gmds_around around)
{
  answer faces, edges;
  gmds_edges kept = links_edges(s->m) ? GMDS_KEEP_EDGES : GMDS_DROP_BARE_EDGES;
  reference_query(&s->ref, 0, 2, v, &faces);
  reference_query(&s->ref, 0, 1, v, &edges);
  gmds_status status, expected = GMDS_OK;
  if (faces.n && !s->m->can[0][2])
    return; /* the model does not know of the faces there */
  if (around == GMDS_REFUSE && (faces.n || (links_edges(s->m) && edges.n)))
    expected = GMDS_ERR_CONFLICT;
  else if (faces.n)
    expected = removal(s->m, kept);
  begin_attempts(s);
  do
    status = s->m->do_remove_node(s->mesh, v, around);
  while (again(s, status));
  expect(s, "remove_node", status, expected);
  if (status != GMDS_OK)
    return;
  for (size_t k = 0; k < faces.n; k++)
    forget_face(s, faces.data[k], kept);
  for (size_t k = 0; k < edges.n; k++)
    s->ref.edges[edges.data[k]].alive = 0;
  s->ref.nodes[v].alive = 0;
}

/* ---- renumbering */

static gmds_id renamed(const gmds_id *map, gmds_id c)
{
  return map[c];
}

void subject_compact(subject *s)
{
  static gmds_id map[3][MAX_EDGES];
  gmds_id *maps[3] = {map[0], map[1], map[2]};
  reference *r = &s->ref, old = *r;
  gmds_status status;
  for (int i = 0; i < 3; i++)
    r->end[i] = s->m->do_cells(s->mesh)[i].end; /* beyond are holes only */
  begin_attempts(s);
  do
    status = s->m->do_compact(s->mesh, maps);
  while (again(s, status));
  expect(s, "compact", status, GMDS_OK);
  for (int i = 0; i < 3; i++) {
    gmds_id count = (gmds_id)reference_count(&old, i), hole = 0;
    for (gmds_id c = 0; c < r->end[i]; c++) {
      gmds_id expected = reference_has(&old, i, c) ? c : GMDS_NONE;
      if (expected != GMDS_NONE && c >= count) {
        while (reference_has(&old, i, hole))
          hole++;
        expected = hole++;
      }
      if (map[i][c] != expected)
        subject_fail(s, "compact maps cell %lu of dimension %d to %lu", (unsigned long)c, i, (unsigned long)map[i][c]);
    }
    if (s->m->do_cells(s->mesh)[i].end != count)
      subject_fail(s, "compact leaves holes among cells of dimension %d", i);
  }
  *r = (reference){.end = {reference_count(&old, 0), reference_count(&old, 1), reference_count(&old, 2)}};
  for (gmds_id v = 0; v < old.end[0]; v++)
    if (old.nodes[v].alive)
      r->nodes[map[0][v]] = old.nodes[v];
  for (gmds_id e = 0; e < old.end[1]; e++)
    if (old.edges[e].alive) {
      reference_edge *edge = &r->edges[map[1][e]];
      *edge = old.edges[e];
      edge->a = renamed(map[0], edge->a);
      edge->b = renamed(map[0], edge->b);
    }
  for (gmds_id f = 0; f < old.end[2]; f++)
    if (old.faces[f].alive) {
      reference_face *face = &r->faces[map[2][f]];
      *face = old.faces[f];
      for (size_t k = 0; k < face->n; k++)
        face->nodes[k] = renamed(map[0], face->nodes[k]);
    }
}
