/* The reference mesh and its queries, by brute force. */
#include "models/reference.h"
#include "harness.h"

int reference_has(const reference *r, int i, gmds_id c)
{
  if (c >= r->end[i])
    return 0;
  return i == 0 ? r->nodes[c].alive : i == 1 ? r->edges[c].alive : r->faces[c].alive;
}

size_t reference_count(const reference *r, int i)
{
  size_t n = 0;
  for (gmds_id c = 0; c < r->end[i]; c++)
    n += (size_t)reference_has(r, i, c);
  return n;
}

gmds_id reference_pick(const reference *r, int i, uint64_t *seed)
{
  size_t n = reference_count(r, i);
  if (!n)
    return GMDS_NONE;
  size_t k = random_below(seed, n);
  for (gmds_id c = 0;; c++)
    if (reference_has(r, i, c) && k-- == 0)
      return c;
}

gmds_id reference_edge_between(const reference *r, gmds_id a, gmds_id b)
{
  for (gmds_id e = 0; e < r->end[1]; e++) {
    const reference_edge *edge = &r->edges[e];
    if (edge->alive && ((edge->a == a && edge->b == b) || (edge->a == b && edge->b == a)))
      return e;
  }
  return GMDS_NONE;
}

int reference_has_side(const reference *r, gmds_id f, gmds_id a, gmds_id b)
{
  const reference_face *face = &r->faces[f];
  for (size_t k = 0; k < face->n; k++) {
    gmds_id p = face->nodes[k], q = face->nodes[(k + 1) % face->n];
    if ((p == a && q == b) || (p == b && q == a))
      return 1;
  }
  return 0;
}

void reference_faces_on(const reference *r, gmds_id a, gmds_id b, answer *out)
{
  out->n = 0;
  for (gmds_id f = 0; f < r->end[2]; f++)
    if (r->faces[f].alive && reference_has_side(r, f, a, b))
      answer_add(out, f);
}

static void around_node(const reference *r, int j, gmds_id v, answer *out)
{
  for (gmds_id e = 0; e < r->end[1]; e++) {
    const reference_edge *edge = &r->edges[e];
    if (edge->alive && (edge->a == v || edge->b == v) && j < 2)
      answer_add(out, j == 1 ? e : edge->a == v ? edge->b : edge->a);
  }
  for (gmds_id f = 0; f < r->end[2]; f++) {
    const reference_face *face = &r->faces[f];
    for (size_t k = 0; face->alive && k < face->n; k++) {
      if (face->nodes[k] != v)
        continue;
      if (j == 2)
        answer_add(out, f);
      if (j == 0) {
        answer_add(out, face->nodes[(k + 1) % face->n]);
        answer_add(out, face->nodes[(k + face->n - 1) % face->n]);
      }
    }
  }
}

static void around_edge(const reference *r, int j, gmds_id e, answer *out)
{
  gmds_id a = r->edges[e].a, b = r->edges[e].b;
  if (j == 2) {
    reference_faces_on(r, a, b, out);
    return;
  }
  if (j == 0) {
    answer_add(out, a);
    answer_add(out, b);
    return;
  }
  for (gmds_id x = 0; x < r->end[1]; x++) {
    const reference_edge *edge = &r->edges[x];
    if (edge->alive && x != e && (edge->a == a || edge->a == b || edge->b == a || edge->b == b))
      answer_add(out, x);
  }
}

static void around_face(const reference *r, int j, gmds_id f, answer *out)
{
  const reference_face *face = &r->faces[f];
  for (size_t k = 0; k < face->n; k++) {
    gmds_id a = face->nodes[k], b = face->nodes[(k + 1) % face->n];
    if (j == 0)
      answer_add(out, a);
    if (j == 1)
      answer_add(out, reference_edge_between(r, a, b));
    for (gmds_id g = 0; j == 2 && g < r->end[2]; g++)
      if (g != f && r->faces[g].alive && reference_has_side(r, g, a, b))
        answer_add(out, g);
  }
}

void reference_query(const reference *r, int i, int j, gmds_id c, answer *out)
{
  out->n = 0;
  if (i == 0)
    around_node(r, j, c, out);
  else if (i == 1)
    around_edge(r, j, c, out);
  else
    around_face(r, j, c, out);
  if (i < 2 || j == 2)
    answer_sort(out);
}

void answer_add(answer *a, gmds_id x)
{
  if (answer_has(a, x))
    return;
  if (a->n == MAX_ANSWER) /* as a rule without Check's macros here: each writes to a file, even when it holds */
    ck_abort_msg("an answer of more than %d cells", MAX_ANSWER);
  a->data[a->n++] = x;
}

int answer_has(const answer *a, gmds_id x)
{
  for (size_t k = 0; k < a->n; k++)
    if (a->data[k] == x)
      return 1;
  return 0;
}

void answer_sort(answer *a)
{
  for (size_t i = 1; i < a->n; i++)
    for (size_t k = i; k > 0 && a->data[k] < a->data[k - 1]; k--) {
      gmds_id swap = a->data[k];
      a->data[k] = a->data[k - 1];
      a->data[k - 1] = swap;
    }
}

int answer_equal(const answer *a, const answer *b)
{
  return a->n == b->n && (a->n == 0 || memcmp(a->data, b->data, a->n * sizeof *a->data) == 0);
}
