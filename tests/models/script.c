/* Regular meshes and random operations. */
#include "models/script.h"

/* How a face is to be added to a model: as the script says where it can be, else with all that the reference knows. */
static knows knowing(const subject *s, knows wanted)
{
  if (needs_links(s->m))
    return KNOWS_BOTH;
  return wanted;
}

gmds_status script_add(subject *s, size_t n, const gmds_id *nodes)
{
  return allows(s->m, n) ? subject_add_face(s, n, nodes, knowing(s, KNOWS_NOTHING)) : GMDS_ERR_ARGUMENT;
}

void script_nodes(subject *s, size_t n)
{
  while (n-- > 0)
    subject_add_node(s);
}

/* A strip of w by h squares, cut in two, whole, or joined to hexagons, as the model and `kind` allow; two isolated
 * nodes at the end. */
void script_grid(subject *s, gmds_id w, gmds_id h, int kind)
{
  gmds_id row = w + 1, first = (gmds_id)s->ref.end[0];
  script_nodes(s, (size_t)row * (h + 1) + 2);
  for (gmds_id y = 0; y < h; y++)
    for (gmds_id x = 0; x < w; x++) {
      gmds_id a = first + y * row + x, b = a + 1, c = b + row, d = a + row;
      const gmds_id lower[3] = {a, b, c}, upper[3] = {a, c, d}, whole[4] = {a, b, c, d};
      const gmds_id joined[6] = {a, b, b + 1, c + 1, c, d};
      if (kind == 2 && x % 2 == 0 && x + 1 < w && allows(s->m, 6)) {
        script_add(s, 6, joined);
        x++;
      } else if (allows(s->m, 4) && (kind == 1 || (kind == 2 && y % 2) || !allows(s->m, 3)))
        script_add(s, 4, whole);
      else {
        script_add(s, 3, lower);
        script_add(s, 3, upper);
      }
    }
}

void script_list(const subject *s, face_list *list)
{
  list->n = list->begin[0] = 0;
  for (gmds_id f = 0; f < s->ref.end[2]; f++) {
    const reference_face *face = &s->ref.faces[f];
    if (!face->alive)
      continue;
    memcpy(list->nodes + list->begin[list->n], face->nodes, face->n * sizeof *face->nodes);
    list->begin[list->n + 1] = list->begin[list->n] + face->n;
    list->n++;
  }
}

/* Where edges know no nodes, which edge of the mesh is which of the reference: by the sides of the faces where they
 * keep edges in order, else one with the same faces. */
static void match_edges(subject *s)
{
  static reference_edge edges[MAX_EDGES];
  reference *r = &s->ref;
  answer faces, found = {0};
  memcpy(edges, r->edges, sizeof edges);
  for (gmds_id e = 0; e < r->end[1]; e++)
    r->edges[e].alive = 0;
  for (gmds_id f = 0; s->m->ordered && stores(s->m, 2, 1) && f < r->end[2]; f++) {
    ck_assert_int_eq(s->m->do_query(s->mesh, 2, 1, f, &s->list), GMDS_OK);
    for (size_t k = 0; k < r->faces[f].n; k++)
      r->edges[s->list.data[k]] =
          (reference_edge){1, r->faces[f].nodes[k], r->faces[f].nodes[(k + 1) % r->faces[f].n], 0};
  }
  for (gmds_id e = 0; s->m->can[1][2] && e < r->end[1]; e++) {
    ck_assert_int_eq(s->m->do_query(s->mesh, 1, 2, e, &s->list), GMDS_OK);
    found.n = s->list.n;
    memcpy(found.data, s->list.data, found.n * sizeof *found.data);
    answer_sort(&found);
    for (gmds_id x = 0; !r->edges[e].alive && x < r->end[1]; x++) {
      reference_faces_on(r, edges[x].a, edges[x].b, &faces);
      if (edges[x].alive && answer_equal(&faces, &found)) {
        r->edges[e] = edges[x];
        edges[x].alive = 0;
      }
    }
  }
  const int64_t *tags = gmds_attribute_find(&s->m->do_cells(s->mesh)[1], "tag")->data;
  for (gmds_id e = 0; e < r->end[1]; e++)
    r->edges[e].tag = tags[e];
}

gmds_status script_at_once(subject *s, const subject *like, const face_list *list, size_t *failed)
{
  gmds_status status;
  begin_attempts(s);
  do
    status = s->m->do_add_faces(s->mesh, list->n, list->begin, list->nodes, failed);
  while (again(s, status));
  if (status != GMDS_OK)
    return status;
  gmds_cells *cells = s->m->do_cells(s->mesh);
  const gmds_cells *source = s->m->do_cells(like->mesh);
  s->ref = like->ref;
  for (int i = 0; i < 3; i++)
    if (s->ref.end[i] && s->ref.end[i] <= cells[i].end) /* else the comparison says it */
      memcpy(gmds_attribute_find(&cells[i], "tag")->data, gmds_attribute_find(&source[i], "tag")->data,
             s->ref.end[i] * sizeof(int64_t));
  if (makes_edges(s->m) && !links_edges(s->m))
    match_edges(s);
  return status;
}

void script_face(subject *s)
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

void script_step(subject *s)
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
    script_face(s);
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
