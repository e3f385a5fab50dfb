/* The check of a mesh of volumes: one entry of one stored relation is corrupted at a time, in every relation of every
 * compiled model, and must be found wherever the other stored relations say what it should be.
 *
 * Where they do not, nothing can be found, and that is counted and printed: the relation is the only one from which its
 * pair of dimensions is known (the nodes of regions in N|R|R2N: any other four nodes are a tetrahedron too), or the
 * cell is one of which nothing else knows (an edge or a face that bounds nothing), or the model cannot list its cells,
 * so that only relations stored both ways are held against each other. */
#include "volumes/pool.h"
#include <gmds/census.h>
#include <gmds/shapes.h>

static subject one;

/* ---- what is detectable */

/* The model lists the nodes of all cells: every relation is held against them. */
static int lists(const volume_model *m)
{
  return m->do_get_volume != NULL;
}

/* Whether the others give i -> j exactly, so that a change of the set contradicts them. */
static int is_redundant(const subject *s, int i, int j)
{
  const volume_model *m = s->m;
  if (i == j)
    return 1;
  if (subject_stores(s, j, i))
    return 1;
  if (!lists(m) || (i == 1 && !m->makes_edges) || (i == 2 && !m->makes_faces))
    return 0;
  gmds_path path = gmds_path_of(m->mask & ~(unsigned)GMDS_RELATION_BIT(i, j), i, j);
  return path.cost != GMDS_COST_NONE && (m->regions & ~path.exact_regions) == 0;
}

/* Whether an exchange of two different entries must be found: where they stand in the order of another relation. */
static int finds_order(const subject *s, int i, int j)
{
  const int edges = subject_stores(s, 0, 1) || subject_stores(s, 1, 0);
  if (!lists(s->m) || !s->m->ordered_3_0)
    return 0;
  if (i == 3 && j == 3)
    return 1;
  if (i == 3 && (j == 1 || j == 2)) /* the check has the order of edges and faces from that of nodes */
    return subject_stores(s, 3, 0) && !(s->m->regions & 16) && (j == 2 || edges);
  return i == 2 && j == 1 && subject_stores(s, 2, 0) && edges;
}

/* ---- corruption */

typedef enum kind { BEYOND, HOLE, TWICE, ITSELF, WRONG, MISSING, EXTRA, SWAPPED, OTHER_FACE, KINDS } kind;
static const char *const kind_names[] = {"beyond the end", "in a hole", "twice",   "itself",         "wrong",
                                         "missing",        "one more",  "swapped", "by another face"};

typedef struct row {
  gmds_id *data;
  size_t n, room;
  gmds_id *length; /* NULL where the row is inline */
  gmds_id scale;   /* an entry is scale * id + face */
} row;

static row row_of(const subject *s, int i, int j, gmds_id c)
{
  stored_relation r = s->m->do_stored(s->mesh, i, j);
  row found = {.scale = r.coded ? 4 : 1};
  if (r.rows) {
    found.data = gmds_rows_get(r.rows, c, &found.n);
    found.length = &r.rows->length[c];
    found.room = r.rows->size[c];
  } else if (r.pairs) {
    const gmds_id *inlined = r.pairs->entries.data + 2 * (size_t)c;
    found.data = gmds_pairs_get(r.pairs, c, &found.n);
    found.room = 2;
    if (inlined[0] == GMDS_NONE && inlined[1] != GMDS_NONE) {
      found.length = &r.pairs->more.length[inlined[1]];
      found.room = r.pairs->more.size[inlined[1]];
    }
  } else {
    found.data = r.column->data + r.arity * c;
    found.n = found.room = r.arity;
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

/* Corrupts entry k of cell c. 0: the kind does not apply here; 1: it may be found; 2: it must. */
static int corrupt(subject *s, int i, int j, gmds_id c, const row *r, size_t k, kind what)
{
  const gmds_cells *cells = &s->m->do_cells(s->mesh)[j];
  const int set = 1 + is_redundant(s, i, j), beyond = i == 3 && j == 3;
  const size_t q = (k + 1) % r->n;
  const gmds_id old = r->data[k], face = old == GMDS_NONE ? 0 : old % r->scale;
  gmds_id id = GMDS_NONE;
  switch (what) {
  case BEYOND:
    r->data[k] = r->scale * (gmds_id)(cells->end + random_below(&s->seed, 5)) + face;
    return 2;
  case HOLE:
    id = (gmds_id)gmds_bits_next_unset(&cells->alive, 0, cells->end);
    r->data[k] = r->scale * id + face;
    return id < cells->end ? 2 : 0;
  case TWICE:
    r->data[k] = r->data[q];
    return q == k || beyond ? 0 : 2;
  case ITSELF:
    r->data[k] = r->scale * c + face;
    return i == j ? 2 : 0;
  case WRONG:
    id = reference_pick(&s->ref, j, &s->seed);
    if (id == GMDS_NONE || names(r, id) || (i == j && id == c))
      return 0;
    r->data[k] = r->scale * id + face;
    return set;
  case MISSING:
    if (!r->length) {
      if (old == GMDS_NONE)
        return 0;
      if (i == 2 && j == 3) { /* its entries lie at the beginning */
        r->data[k] = r->data[r->n - 1];
        r->data[r->n - 1] = GMDS_NONE;
        return set;
      }
      r->data[k] = GMDS_NONE;
      return beyond ? set : 2;
    }
    if (beyond && old == GMDS_NONE)
      return 0;
    r->data[k] = r->data[r->n - 1];
    --*r->length;
    return set;
  case EXTRA:
    id = reference_pick(&s->ref, j, &s->seed);
    if (id == GMDS_NONE || names(r, id) || (i == j && id == c))
      return 0;
    if (beyond) { /* where there is none */
      r->data[k] = r->scale * id + face;
      return old == GMDS_NONE ? set : 0;
    }
    if (r->n == r->room)
      return 0;
    r->data[r->n] = id;
    if (r->length)
      ++*r->length;
    return set;
  case SWAPPED:
    r->data[k] = r->data[q];
    r->data[q] = old;
    return r->data[k] == old ? 0 : 1 + finds_order(s, i, j);
  default:
    r->data[k] = old == GMDS_NONE ? old : 4 * (old / 4) + (old + 1 + (gmds_id)random_below(&s->seed, 3)) % 4;
    return r->scale == 4 && old != GMDS_NONE ? 2 : 0;
  }
}

/* Whether a sentence begins with the name of a stored relation, or is one of those about cells. */
static int names_what_is_wrong(const subject *s, const char *text)
{
  static const char letters[] = "NEFR";
  static const char *const others[] = {
      "no edge joins", "is no face of the mesh", "have the same nodes",    "do not make a region",
      " nodes, ",      "do not close",           "in another order around"};
  for (int q = 0; q < 16; q++) {
    const char name[] = {letters[q / 4], '2', letters[q % 4], ':', 0};
    if (subject_stores(s, q / 4, q % 4) && !strncmp(text, name, 4))
      return 1;
  }
  for (size_t k = 0; k < sizeof others / sizeof *others; k++)
    if (strstr(text, others[k]))
      return 1;
  return 0;
}

typedef struct tally {
  size_t must, may, unseen, unlisted; /* not found; not found by models that cannot list their cells */
} tally;
static tally kinds[KINDS], relations[16];

static void corrupt_relation(subject *s, int i, int j, kind what)
{
  static const char letters[] = "NEFR";
  const int entries = what <= ITSELF;
  for (int sample = 0; sample < 10; sample++) {
    gmds_id c = reference_pick(&s->ref, i, &s->seed), before[64], length = 0;
    if (c == GMDS_NONE)
      return;
    row r = row_of(s, i, j, c);
    if (!r.n || r.n >= 60)
      continue;
    const size_t n = r.n < r.room ? r.n + 1 : r.n, k = random_below(&s->seed, r.n);
    memcpy(before, r.data, n * sizeof *before);
    length = r.length ? *r.length : 0;
    const int finds = corrupt(s, i, j, c, &r, k, what);
    gmds_error error = {.status = GMDS_OK};
    gmds_status status = finds ? s->m->do_check(s->mesh, &s->memory, &error) : GMDS_OK;
    const char name[] = {letters[i], '2', letters[j], ':', 0};
    if (finds == 2 && status != GMDS_ERR_INVARIANT)
      subject_fail(s, "entry %zu of %s cell %lu is %s, and the check says '%s'", k, name, (unsigned long)c,
                   kind_names[what], gmds_status_text(status));
    if (status != GMDS_OK && (status != error.status || !names_what_is_wrong(s, error.text) ||
                              (entries && finds == 2 && strncmp(error.text, name, 4))))
      subject_fail(s, "entry %zu of %s cell %lu is %s, and the check says '%s'", k, name, (unsigned long)c,
                   kind_names[what], error.text);
    kinds[what].must += finds == 2;
    kinds[what].may += finds == 1 && status != GMDS_OK;
    kinds[what].unseen += finds == 1 && status == GMDS_OK && lists(s->m);
    kinds[what].unlisted += finds == 1 && status == GMDS_OK && !lists(s->m);
    relations[4 * i + j].must += finds == 2;
    relations[4 * i + j].may += finds == 1 && status != GMDS_OK;
    relations[4 * i + j].unseen += finds == 1 && status == GMDS_OK && lists(s->m);
    relations[4 * i + j].unlisted += finds == 1 && status == GMDS_OK && !lists(s->m);
    memcpy(r.data, before, n * sizeof *before);
    if (r.length)
      *r.length = length;
  }
}

/* A mesh of all types that the model holds, with holes in every dimension where it can make them. */
static void fill(subject *s, const volume_model *m, uint64_t seed)
{
  subject_begin(s, m, seed);
  pool_nodes(s);
  for (size_t i = 0; i < n_pool; i++)
    pool_add(s, &pool[i]);
  pool_add_polyhedra(s);
  for (int i = 0; i < 25; i++)
    pool_step(s);
  while (reference_count(&s->ref, 3) > 6) {
    subject_remove_region(s, reference_pick(&s->ref, 3, &s->seed), GMDS_DROP_BARE);
    if (s->unsupported)
      break;
  }
  subject_remove_node(s, 20, GMDS_CASCADE);
}

START_TEST(a_corrupted_entry_is_found)
{
  static const char letters[] = "NEFR";
  for (size_t k = 0; k < n_volume_models; k++) {
    fill(&one, volume_models[k], 40 + k);
    for (int q = 0; q < 16; q++)
      for (int what = 0; what < KINDS && subject_stores(&one, q / 4, q % 4); what++)
        corrupt_relation(&one, q / 4, q % 4, (kind)what);
    subject_compare(&one); /* everything was put back */
    subject_end(&one);
  }
  printf("%-16s %9s %9s %9s %9s\n", "", "must", "found too", "not found", "unlisted");
  for (int what = 0; what < KINDS; what++)
    printf("%-16s %9zu %9zu %9zu %9zu\n", kind_names[what], kinds[what].must, kinds[what].may, kinds[what].unseen,
           kinds[what].unlisted);
  for (int q = 0; q < 16; q++)
    printf("%c2%c              %9zu %9zu %9zu %9zu\n", letters[q / 4], letters[q % 4], relations[q].must,
           relations[q].may, relations[q].unseen, relations[q].unlisted);
  for (int what = 0; what < KINDS; what++)
    ck_assert_uint_gt(kinds[what].must, what == OTHER_FACE ? 20 : n_volume_models);
  for (int q = 0; q < 16; q++)
    ck_assert_uint_gt(relations[q].must, 0);
}
END_TEST

RUN_SUITE("check of volumes", a_corrupted_entry_is_found)
