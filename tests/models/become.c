/* The conversion of a mesh to another model, and what its reference learns by it. */
#include "models/subject.h"

/* ---- what must come of it */

static int has_edge_without_face(const reference *r)
{
  for (gmds_id e = 0; e < r->end[1]; e++) {
    answer on = {0};
    if (r->edges[e].alive)
      reference_faces_on(r, r->edges[e].a, r->edges[e].b, &on);
    if (r->edges[e].alive && !on.n)
      return 1;
  }
  return 0;
}

static int all_triangles(const reference *r)
{
  for (gmds_id f = 0; f < r->end[2]; f++)
    if (r->faces[f].alive && r->faces[f].n != 3)
      return 0;
  return 1;
}

static int holds_faces(const model *m, const reference *r)
{
  for (gmds_id f = 0; f < r->end[2]; f++)
    if (r->faces[f].alive && !allows(m, r->faces[f].n))
      return 0;
  return 1;
}

static int has_third_face(const reference *r)
{
  for (gmds_id f = 0; f < r->end[2]; f++)
    for (size_t k = 0; r->faces[f].alive && k < r->faces[f].n; k++) {
      answer on = {0};
      reference_faces_on(r, r->faces[f].nodes[k], r->faces[f].nodes[(k + 1) % r->faces[f].n], &on);
      if (on.n > 2)
        return 1;
    }
  return 0;
}

/* Whether the stored relations determine where the nodes of faces and edges are. */
static int determines(const model *from, const model *to, const reference *r)
{
  int by_edges = links_edges(from) && (stores(from, 2, 1) || stores(from, 1, 2));
  int faces = !reference_count(r, 2) || stores(from, 2, 0) || by_edges || (stores(from, 0, 2) && all_triangles(r));
  int edges = !links_edges(to) || !makes_edges(from) || links_edges(from) || !has_edge_without_face(r);
  return faces && edges;
}

static void judge(subject *s, const model *to, gmds_status status, const char *text)
{
  const reference *r = &s->ref;
  int fits = to->dim == s->m->dim && holds_faces(to, r);
  int conflict = stores(to, 2, 2) && has_third_face(r);
  gmds_status expected = !fits                      ? GMDS_ERR_UNSUPPORTED
                         : !determines(s->m, to, r) ? GMDS_ERR_UNSUPPORTED
                         : conflict                 ? GMDS_ERR_CONFLICT
                                                    : GMDS_OK;
  /* what is not determined may not be asked for */
  if (status != expected && (fits ? determines(s->m, to, r) : status == GMDS_OK))
    subject_fail(s, "becoming %s gave '%s' (%s), expected '%s'", to->name, gmds_status_text(status), text,
                 gmds_status_text(expected));
  if (status == GMDS_OK || (status == GMDS_ERR_CONFLICT && conflict) || status == GMDS_ERR_UNSUPPORTED)
    return;
  subject_fail(s, "becoming %s gave '%s' (%s)", to->name, gmds_status_text(status), text);
}

/* ---- what the reference learns */

/* A face that had no order has one now. */
static void learn_order(subject *s)
{
  for (gmds_id f = 0; f < s->ref.end[2]; f++) {
    reference_face *face = &s->ref.faces[f], old = *face;
    if (!face->alive)
      continue;
    if (s->m->do_query(s->mesh, 2, 0, f, &s->list) != GMDS_OK || s->list.n != face->n)
      subject_fail(s, "face %lu has other nodes than before", (unsigned long)f);
    memcpy(face->nodes, s->list.data, face->n * sizeof *face->nodes);
    for (size_t k = 0; k < face->n; k++) { /* the same nodes follow each other */
      size_t at = 0;
      while (at < old.n && old.nodes[at] != face->nodes[k])
        at++;
      gmds_id next = face->nodes[(k + 1) % face->n];
      if (at == old.n || (old.nodes[(at + 1) % old.n] != next && old.nodes[(at + old.n - 1) % old.n] != next))
        subject_fail(s, "face %lu has its nodes in another order", (unsigned long)f);
    }
  }
}

static void set_edge(subject *s, gmds_id e, gmds_id a, gmds_id b)
{
  if (e >= MAX_EDGES)
    subject_fail(s, "edge %lu is out of range", (unsigned long)e);
  s->ref.edges[e].alive = 1;
  s->ref.edges[e].a = a;
  s->ref.edges[e].b = b;
  if (e >= s->ref.end[1])
    s->ref.end[1] = e + (size_t)1;
}

/* The edges of faces where both keep the order. */
static void learn_from_sides(subject *s)
{
  for (gmds_id f = 0; f < s->ref.end[2]; f++) {
    const reference_face *face = &s->ref.faces[f];
    if (!face->alive)
      continue;
    if (s->m->do_query(s->mesh, 2, 1, f, &s->list) != GMDS_OK || s->list.n != face->n)
      subject_fail(s, "face %lu has %zu edges", (unsigned long)f, s->list.n);
    for (size_t k = 0; k < face->n; k++)
      set_edge(s, s->list.data[k], face->nodes[k], face->nodes[(k + 1) % face->n]);
  }
}

/* Where edges know faces alone: two nodes that just the same faces join, and no edge yet. */
static int learn_from_faces(subject *s, gmds_id e, const answer *faces, const gmds_bits *known)
{
  const reference_face *face = &s->ref.faces[faces->data[0]];
  for (size_t k = 0; k < face->n; k++) {
    gmds_id a = face->nodes[k], b = face->nodes[(k + 1) % face->n];
    answer on = {0};
    int taken = 0;
    reference_faces_on(&s->ref, a, b, &on);
    for (gmds_id x = 0; x < s->ref.end[1]; x++) {
      const reference_edge *edge = &s->ref.edges[x];
      taken |=
          edge->alive && gmds_bits_get(known, x) && ((edge->a == a && edge->b == b) || (edge->a == b && edge->b == a));
    }
    if (taken || !answer_equal(&on, faces))
      continue;
    set_edge(s, e, a, b);
    return 1;
  }
  return 0;
}

static void learn_edges(subject *s)
{
  const gmds_cells *edges = &s->m->do_cells(s->mesh)[1];
  gmds_bits known;
  ck_assert_int_eq(gmds_bits_init(&known, &s->memory, MAX_EDGES), GMDS_OK);
  for (gmds_id e = gmds_cells_next(edges, 0); e != GMDS_NONE; e = gmds_cells_next(edges, e + 1)) {
    answer faces = {0};
    if (s->m->do_query(s->mesh, 1, links_edges(s->m) ? 0 : 2, e, &s->list) != GMDS_OK)
      subject_fail(s, "edge %lu does not answer", (unsigned long)e);
    for (size_t k = 0; k < s->list.n; k++)
      answer_add(&faces, s->list.data[k]);
    answer_sort(&faces);
    if (links_edges(s->m) && faces.n == 2)
      set_edge(s, e, faces.data[0], faces.data[1]);
    else if (links_edges(s->m) || (faces.n && !learn_from_faces(s, e, &faces, &known)))
      subject_fail(s, "edge %lu lies nowhere", (unsigned long)e);
    gmds_bits_set(&known, e);
  }
  gmds_bits_clear(&known);
}

/* Edges have come, gone, or shown where they are. */
static void learn(subject *s, const model *before)
{
  const model *now = s->m;
  gmds_cells *edges = &now->do_cells(s->mesh)[1];
  if (!before->ordered && now->ordered)
    learn_order(s);
  if (!makes_edges(now) || !makes_edges(before)) {
    memset(s->ref.edges, 0, sizeof s->ref.edges);
    s->ref.end[1] = 0;
  }
  if (!makes_edges(now))
    return;
  if (!makes_edges(before) || (!links_edges(before) && links_edges(now)))
    learn_edges(s);
  if (stores(now, 2, 0) && stores(now, 2, 1) && !links_edges(before))
    learn_from_sides(s);
  if (makes_edges(before))
    return;
  gmds_attribute *tags = gmds_attribute_find(edges, "tag");
  for (gmds_id e = gmds_cells_next(edges, 0); e != GMDS_NONE; e = gmds_cells_next(edges, e + 1)) {
    int64_t *tag = (int64_t *)tags->data + e;
    if (*tag != 0)
      subject_fail(s, "edge %lu comes with an old attribute", (unsigned long)e);
    s->ref.edges[e].tag = *tag = ++s->tags;
  }
}

/* An edge without faces would be told by nothing in a model that does not link edges with nodes. */
static void remove_bare_edges(subject *s)
{
  for (gmds_id e = 0; e < s->ref.end[1]; e++) {
    answer on = {0};
    if (!s->ref.edges[e].alive)
      continue;
    reference_faces_on(&s->ref, s->ref.edges[e].a, s->ref.edges[e].b, &on);
    if (!on.n)
      subject_remove_edge(s, e, GMDS_REFUSE);
  }
}

gmds_status subject_become(subject *s, const model *to)
{
  if (links_edges(s->m) && makes_edges(to) && !links_edges(to)) {
    remove_bare_edges(s);
    if (has_edge_without_face(&s->ref)) /* the model cannot tell that nothing is at this edge */
      return GMDS_ERR_UNSUPPORTED;
  }
  gmds_parts parts;
  gmds_error error = {.status = GMDS_OK};
  gmds_allocator allocator = failing_allocator(&s->from);
  const model *before = s->m;
  void *mesh = malloc(to->bytes);
  ck_assert_ptr_nonnull(mesh);
  gmds_parts_init(&parts);
  to->do_init(mesh, &allocator);
  gmds_status status;
  begin_attempts(s);
  do {
    before->do_give(s->mesh, &parts);
    if (before->do_memory(s->mesh)->live || before->do_cells(s->mesh)[2].end || before->do_memory(mesh)->live)
      subject_fail(s, "what gave its parts, or is to take them, is not empty");
    status = to->do_take(mesh, &parts, &error);
    if (status != GMDS_OK && before->do_take(s->mesh, &parts, NULL) != GMDS_OK)
      subject_fail(s, "parts are not taken by the mesh that gave them");
  } while (again(s, status));
  judge(s, to, status, error.text);
  void *left = status == GMDS_OK ? s->mesh : mesh;
  (status == GMDS_OK ? before : to)->do_clear(left);
  free(left);
  if (status == GMDS_OK) {
    s->m = to;
    s->mesh = mesh;
    learn(s, before);
  }
  subject_compare(s);
  return status;
}
