/* The check of a mesh: one entry of one stored relation is corrupted at a time, and must be found wherever the other
 * stored relations say what it should be. */
#include "models/script.h"
#include <gmds/census.h>

static subject one;

/* ---- what is detectable */

/* Whether the other relations of a model give i -> j exactly, so that a change of the set contradicts them. */
static int is_redundant(const model *m, int i, int j)
{
  gmds_path path = gmds_path_of(m->mask & ~(unsigned)GMDS_RELATION_BIT(i, j), i, j);
  if (i == 0 && j == 0 && makes_edges(m) && !links_edges(m))
    return 0; /* nodes may be joined by an edge without faces, of which nothing is known */
  return path.cost != GMDS_COST_NONE && (m->faces & ~path.exact) == 0;
}

/* Whether a change of the set i2j of one cell must be found: by the others, or since j-cells name i-cells back. */
static int finds_changes(const model *m, int i, int j)
{
  return i == j || is_redundant(m, i, j);
}

/* Whether a change of the order of a face's entries must be found: of the neighbours when its nodes are kept, of nodes
 * and edges against each other when edges are linked with nodes. */
static int finds_order(const model *m, int j)
{
  return stores(m, 2, 0) && (j == 2 || (stores(m, 2, 1) && links_edges(m)));
}

/* ---- corruption */

typedef enum kind { DEAD, HOLE, TWICE, ITSELF, WRONG, MISSING, SWAPPED, OTHER_SIDE, KINDS } kind;

static const char *const kind_names[] = {"dead",  "in a hole", "twice",   "itself",
                                         "wrong", "missing",   "swapped", "by another side"};

typedef struct row {
  gmds_id *data;
  size_t n;
  gmds_id *length; /* NULL where the row is inline */
  int packed;      /* inline, GMDS_NONE behind the last entry */
  gmds_id scale;   /* an entry is scale * id + side */
} row;

static row row_of(subject *s, int i, int j, gmds_id c)
{
  stored_relation r = s->m->do_stored(s->mesh, i, j);
  row found = {.scale = r.coded ? 4 : 1};
  if (r.rows) {
    found.data = gmds_rows_get(r.rows, c, &found.n);
    found.length = &r.rows->length[c];
  } else if (r.pairs) {
    found.data = gmds_pairs_get(r.pairs, c, &found.n);
    found.packed = 1;
  } else {
    found.data = r.column->data + r.arity * c;
    found.n = r.arity;
  }
  return found;
}

static int names(const row *r, gmds_id id)
{
  for (size_t k = 0; k < r->n; k++)
    if (r->data[k] != GMDS_NONE && r->data[k] / r->scale == id)
      return 1;
  return 0;
}

static gmds_id side_bits(const row *r, size_t k)
{
  return r->data[k] == GMDS_NONE ? 0 : r->data[k] % r->scale;
}

/* Corrupts entry k of c; returns whether the kind applies here and must be found. */
static int corrupt(subject *s, int i, int j, gmds_id c, const row *r, size_t k, kind what)
{
  const model *m = s->m;
  const gmds_cells *cells = &m->do_cells(s->mesh)[j];
  size_t q = (k + 1) % r->n;
  gmds_id old = r->data[k], id = GMDS_NONE;
  int shared = i == 2 && j == 2; /* entries of F2F may be GMDS_NONE, or name a face for two sides */
  switch (what) {
  case DEAD:
    r->data[k] = r->scale * (gmds_id)(cells->end + random_below(&s->seed, 5)) + side_bits(r, k);
    return 1;
  case HOLE:
    id = (gmds_id)gmds_bits_next_unset(&cells->alive, 0, cells->end);
    r->data[k] = r->scale * id + side_bits(r, k);
    return id < cells->end;
  case TWICE:
    r->data[k] = r->data[q];
    return q != k && !shared;
  case ITSELF:
    r->data[k] = r->scale * c + side_bits(r, k);
    return i == j;
  case WRONG:
    id = reference_pick(&s->ref, j, &s->seed);
    if (names(r, id) || (i == j && id == c))
      return 0;
    r->data[k] = r->scale * id + side_bits(r, k);
    return finds_changes(m, i, j);
  case MISSING:
    if (r->packed) {
      r->data[k] = r->data[r->n - 1];
      r->data[r->n - 1] = GMDS_NONE;
      return finds_changes(m, i, j);
    }
    if (shared || !r->length || i == 2) {
      r->data[k] = GMDS_NONE;
      return !shared || (old != GMDS_NONE && finds_changes(m, i, j));
    }
    r->data[k] = r->data[r->n - 1];
    --*r->length;
    return finds_changes(m, i, j);
  case SWAPPED:
    r->data[k] = r->data[q];
    r->data[q] = old;
    return i == 2 && r->data[k] != old && finds_order(m, j);
  default:
    r->data[k] = old == GMDS_NONE ? old : 4 * (old / 4) + (old + 1 + (gmds_id)random_below(&s->seed, 3)) % 4;
    return shared && r->scale == 4 && old != GMDS_NONE;
  }
}

static size_t corrupt_relation(subject *s, int i, int j, kind what)
{
  size_t found = 0;
  for (int sample = 0; sample < 24; sample++) {
    gmds_id c = reference_pick(&s->ref, i, &s->seed), before[MAX_SIDES * 4];
    row r = row_of(s, i, j, c);
    if (!r.n || r.n > MAX_SIDES * 4)
      continue;
    memcpy(before, r.data, r.n * sizeof *before);
    gmds_error error = {0};
    size_t k = random_below(&s->seed, r.n);
    int must = corrupt(s, i, j, c, &r, k, what);
    gmds_status status = s->m->do_check(s->mesh, &s->memory, &error);
    if (must && status != GMDS_ERR_INVARIANT)
      subject_fail(s, "entry %zu of relation %d->%d of cell %lu is %s, and the check says '%s'", k, i, j,
                   (unsigned long)c, kind_names[what], gmds_status_text(status));
    if (status != GMDS_OK && (status != error.status || strlen(error.text) < 20))
      subject_fail(s, "a violation without a sentence: '%s'", error.text);
    found += (size_t)must;
    memcpy(r.data, before, r.n * sizeof *before);
    if (r.length)
      *r.length = (gmds_id)r.n;
  }
  return found;
}

START_TEST(a_corrupted_entry_is_found)
{
  size_t found[KINDS] = {0}, models = 0;
  for (size_t k = 0; k < n_models; k++)
    for (int mesh = 0; mesh < 2; mesh++) {
      subject_begin(&one, all_models[k], 40 + k);
      script_grid(&one, 3, 2, 2 * mesh);
      if (one.m->do_add_edge)
        subject_add_edge(&one, 0, 11);
      subject_remove_node(&one, 13, GMDS_REFUSE);
      script_nodes(&one, 2);
      subject_remove_node(&one, 12, GMDS_REFUSE);
      subject_remove_face(&one, 1, usual_edges(one.m));
      for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
          for (int what = 0; what < KINDS && stores(one.m, i, j); what++)
            found[what] += corrupt_relation(&one, i, j, (kind)what);
      subject_compare(&one); /* everything was put back */
      subject_end(&one);
      models++;
    }
  for (int what = 0; what < KINDS; what++)
    ck_assert_msg(found[what] > models / 8, "%s: only %zu of %zu models", kind_names[what], found[what], models);
}
END_TEST

RUN_SUITE("check", a_corrupted_entry_is_found)
