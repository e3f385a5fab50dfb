/* Operations on a mesh and the reference, and their comparison. */
#include "volumes/subject.h"
#include <gmds/relations.h>
#include <limits.h>
#include <stdarg.h>

void subject_begin(subject *s, const volume_model *m, uint64_t seed)
{
  memset(s, 0, sizeof *s);
  s->m = m;
  s->seed = seed;
  s->mesh = malloc(m->bytes);
  s->ref.makes_edges = m->makes_edges;
  s->ref.makes_faces = m->makes_faces;
  s->from.until = LONG_MAX;
  const gmds_allocator allocator = failing_allocator(&s->from);
  m->do_init(s->mesh, &allocator);
  gmds_memory_init(&s->memory, NULL);
  gmds_ids_init(&s->list, &s->memory);
}

void subject_end(subject *s)
{
  s->m->do_clear(s->mesh);
  ck_assert_uint_eq(s->m->do_memory(s->mesh)->live, 0);
  ck_assert_uint_eq(s->from.live, 0);
  gmds_ids_clear(&s->list);
  free(s->mesh);
}

void subject_fail(const subject *s, const char *format, ...)
{
  char text[512];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  ck_abort_msg("%s: %s", s->m->name, text);
  abort();
}

/* ---- operations without memory */

static void mix_in(uint64_t *sum, uint64_t x)
{
  uint64_t state = *sum ^ x;
  *sum = random_bits(&state);
}

uint64_t subject_fingerprint(subject *s)
{
  const gmds_cells *cells = s->m->do_cells(s->mesh);
  uint64_t sum = 0;
  for (int i = 0; i < 4; i++) {
    mix_in(&sum, cells[i].count);
    mix_in(&sum, cells[i].end);
    for (gmds_id c = gmds_cells_next(&cells[i], 0); c != GMDS_NONE; c = gmds_cells_next(&cells[i], c + 1)) {
      mix_in(&sum, c);
      for (const gmds_attribute *a = cells[i].attributes; a; a = a->next)
        for (size_t k = 0; k < a->bytes; k++)
          mix_in(&sum, ((const unsigned char *)a->data)[c * a->bytes + k]);
      if (i == 3)
        mix_in(&sum, (uint64_t)s->m->do_type(s->mesh, c));
      for (int k = 0; i == 0 && k < 3; k++) {
        uint64_t bits = 0;
        memcpy(&bits, s->m->do_point(s->mesh, c) + k, sizeof bits);
        mix_in(&sum, bits);
      }
      for (int j = 0; j < 4; j++) {
        size_t n = 0;
        const gmds_id *row = subject_stores(s, i, j) ? s->m->do_view(s->mesh, i, j, c, &n) : NULL;
        mix_in(&sum, n);
        for (size_t k = 0; k < n; k++)
          mix_in(&sum, row[k]);
      }
    }
  }
  return sum;
}

void subject_attempt(subject *s)
{
  s->attempt = 0;
  if (!s->inject)
    return;
  s->before = subject_fingerprint(s);
  s->from.until = 0;
}

int subject_again(subject *s, gmds_status status)
{
  s->from.until = LONG_MAX;
  if (!s->inject || status != GMDS_ERR_MEMORY)
    return 0;
  if (subject_fingerprint(s) != s->before)
    subject_fail(s, "an operation that fails at allocation %ld changes the mesh", s->attempt + 1);
  if (s->m->do_memory(s->mesh)->live != s->from.live)
    subject_fail(s, "%zu bytes are held, %zu counted", s->from.live, s->m->do_memory(s->mesh)->live);
  s->from.until = ++s->attempt;
  return 1;
}

int subject_allows(const subject *s, gmds_cell_type type)
{
  return (s->m->regions >> ((int)type - (int)GMDS_TETRAHEDRON) & 1) && s->m->adds_regions;
}

int subject_allows_face(const subject *s, size_t n)
{
  return s->m->do_add_face && ((n == 3 && s->m->faces & 1) || (n == 4 && s->m->faces & 2) || s->m->faces & 4);
}

int subject_stores(const subject *s, int i, int j)
{
  return (s->m->mask & (unsigned)GMDS_RELATION_BIT(i, j)) != 0;
}

static void expect(subject *s, gmds_status status, gmds_status expected, gmds_id id, gmds_id expected_id,
                   const char *what)
{
  if (status != expected)
    subject_fail(s, "%s: '%s', not '%s'", what, gmds_status_text(status), gmds_status_text(expected));
  if (status == GMDS_OK && id != expected_id)
    subject_fail(s, "%s got the number %lu, not %lu", what, (unsigned long)id, (unsigned long)expected_id);
  if (status == GMDS_OK)
    s->done++;
  else
    s->refused++;
}

void subject_add_node(subject *s)
{
  const double x[3] = {random_unit(&s->seed), random_unit(&s->seed), random_unit(&s->seed)};
  gmds_id id = 0;
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_add_node(s->mesh, x, &id);
  while (subject_again(s, status));
  expect(s, status, GMDS_OK, id, reference_add_node(&s->ref), "a node");
}

void subject_add_edge(subject *s, gmds_id a, gmds_id b)
{
  gmds_id id = 0;
  if (!s->m->do_add_edge)
    return;
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_add_edge(s->mesh, a, b, &id);
  while (subject_again(s, status));
  expect(s, status, GMDS_OK, id, reference_add_edge(&s->ref, a, b), "an edge");
}

void subject_add_face(subject *s, const cycle *c)
{
  gmds_id id = 0;
  if (!subject_allows_face(s, c->n))
    return;
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_add_face(s->mesh, c->n, c->nodes, &id);
  while (subject_again(s, status));
  expect(s, status, GMDS_OK, id, reference_add_face(&s->ref, c), "a face");
}

static gmds_status room_for(const subject *s, size_t n, const cycle *walls)
{
  for (size_t k = 0; k < n && subject_stores(s, 3, 3); k++)
    if (reference_regions_on(&s->ref, &walls[k]) > 1)
      return GMDS_ERR_CONFLICT;
  return GMDS_OK;
}

void subject_add_region(subject *s, gmds_cell_type type, const gmds_id *nodes)
{
  cycle walls[MAX_WALLS];
  gmds_id id = 0;
  if (!subject_allows(s, type))
    return;
  gmds_status expected = room_for(s, reference_walls(type, nodes, walls), walls);
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_add_region(s->mesh, type, nodes, &id);
  while (subject_again(s, status));
  expect(s, status, expected, id, expected == GMDS_OK ? reference_add_region(&s->ref, type, nodes) : 0, "a region");
}

void subject_add_polyhedron(subject *s, size_t n, const cycle *walls)
{
  gmds_id id = 0, faces[MAX_WALLS];
  if (!s->m->do_add_polyhedron)
    return;
  for (size_t k = 0; k < n; k++) {
    subject_add_face(s, &walls[k]);
    faces[k] = reference_face(&s->ref, &walls[k]);
  }
  gmds_status expected = room_for(s, n, walls), status;
  subject_attempt(s);
  do
    status = s->m->do_add_polyhedron(s->mesh, n, faces, &id);
  while (subject_again(s, status));
  expect(s, status, expected, id, expected == GMDS_OK ? reference_add_polyhedron(&s->ref, n, faces) : 0,
         "a polyhedron");
}

/* ---- removal; models that cannot tell what to forget say so, and nothing has happened */

static int is_unsupported(subject *s, gmds_status status)
{
  s->unsupported += status == GMDS_ERR_UNSUPPORTED;
  return status == GMDS_ERR_UNSUPPORTED;
}

void subject_remove_region(subject *s, gmds_id r, gmds_bare bare)
{
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_remove_region(s->mesh, r, bare);
  while (subject_again(s, status));
  if (is_unsupported(s, status))
    return;
  expect(s, status, GMDS_OK, 0, 0, "removal of a region");
  reference_remove_region(&s->ref, r, bare);
}

static size_t above(const subject *s, int i, gmds_id c)
{
  size_t n = 0;
  answer around;
  for (int j = i + 1; j < 4; j++) {
    reference_query(&s->ref, i, j, c, &around);
    n += around.n;
  }
  return n;
}

void subject_remove_face(subject *s, gmds_id f, gmds_around around, gmds_bare bare)
{
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_remove_face(s->mesh, f, around, bare);
  while (subject_again(s, status));
  if (is_unsupported(s, status))
    return;
  answer regions;
  reference_query(&s->ref, 2, 3, f, &regions);
  expect(s, status, around == GMDS_REFUSE && regions.n ? GMDS_ERR_CONFLICT : GMDS_OK, 0, 0, "removal of a face");
  if (status != GMDS_OK)
    return;
  for (size_t k = 0; k < regions.n; k++)
    reference_remove_region(&s->ref, regions.cells[k], GMDS_KEEP_BARE);
  reference_remove_face(&s->ref, f, bare);
}

void subject_remove_edge(subject *s, gmds_id e, gmds_around around)
{
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_remove_edge(s->mesh, e, around);
  while (subject_again(s, status));
  if (is_unsupported(s, status))
    return;
  expect(s, status, around == GMDS_REFUSE && above(s, 1, e) ? GMDS_ERR_CONFLICT : GMDS_OK, 0, 0, "removal of an edge");
  if (status == GMDS_OK)
    reference_remove(&s->ref, 1, e);
}

void subject_remove_node(subject *s, gmds_id v, gmds_around around)
{
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_remove_node(s->mesh, v, around);
  while (subject_again(s, status));
  if (is_unsupported(s, status))
    return;
  expect(s, status, around == GMDS_REFUSE && above(s, 0, v) ? GMDS_ERR_CONFLICT : GMDS_OK, 0, 0, "removal of a node");
  if (status == GMDS_OK)
    reference_remove(&s->ref, 0, v);
}

/* ---- compaction */

static void rename_cycle(cycle *c, const gmds_id *map)
{
  for (size_t k = 0; k < c->n; k++)
    c->nodes[k] = map[c->nodes[k]];
}

static void renumber(reference *r, gmds_id *const maps[4])
{
  for (int i = 1; i < 4; i++)
    for (gmds_id c = 0; c < r->end[i]; c++) {
      reference_cell *cell = &r->cells[i][c];
      if (!cell->alive)
        continue;
      rename_cycle(&cell->nodes, maps[0]);
      for (size_t k = 0; k < cell->n_walls; k++)
        rename_cycle(&cell->walls[k], maps[0]);
      for (size_t k = 0; k < cell->n_corners; k++)
        cell->corners[k] = maps[0][cell->corners[k]];
    }
  for (int i = 0; i < 4; i++) {
    gmds_id n = (gmds_id)reference_count(r, i);
    for (gmds_id c = 0; c < r->end[i]; c++)
      if (r->cells[i][c].alive && maps[i][c] != c) {
        r->cells[i][maps[i][c]] = r->cells[i][c];
        r->cells[i][c].alive = 0;
      }
    r->end[i] = n;
  }
}

void subject_compact(subject *s)
{
  static gmds_id rooms[4][MAX_CELLS];
  gmds_id *maps[4] = {rooms[0], rooms[1], rooms[2], rooms[3]};
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_compact(s->mesh, maps);
  while (subject_again(s, status));
  ck_assert_int_eq(status, GMDS_OK);
  renumber(&s->ref, maps);
  subject_trim(s);
}

void subject_trim(subject *s)
{
  gmds_status status;
  subject_attempt(s);
  do
    status = s->m->do_trim(s->mesh);
  while (subject_again(s, status));
  ck_assert_int_eq(status, GMDS_OK);
}

/* ---- comparison */

static int by_id(const void *a, const void *b)
{
  gmds_id x = *(const gmds_id *)a, y = *(const gmds_id *)b;
  return (x > y) - (x < y);
}

static void compare_set(const subject *s, int i, int j, gmds_id c, const gmds_id *found, size_t n, const char *how)
{
  static gmds_id sorted[8 * MAX_CELLS];
  static answer expected;
  reference_query(&s->ref, i, j, c, &expected);
  if (n)
    memcpy(sorted, found, n * sizeof *found);
  qsort(sorted, n, sizeof *sorted, by_id);
  int same = n == expected.n;
  for (size_t k = 0; k < n && same; k++)
    same = sorted[k] == expected.cells[k];
  if (same)
    return;
  char text[400] = "";
  for (size_t k = 0; k < n && k < 12; k++)
    snprintf(text + strlen(text), 12, " %lu", (unsigned long)sorted[k]);
  strcat(text, ", not");
  for (size_t k = 0; k < expected.n && k < 12; k++)
    snprintf(text + strlen(text), 12, " %lu", (unsigned long)expected.cells[k]);
  subject_fail(s, "%d->%d of %lu (%s, path %d) gives%s", i, j, (unsigned long)c, how, s->m->path[i][j], text);
}

static void compare_order(const subject *s, int i, gmds_id c)
{
  const reference_cell *cell = &s->ref.cells[i][c];
  const size_t n = i == 3 ? cell->n_corners : cell->nodes.n;
  const gmds_id *expected = i == 3 ? cell->corners : cell->nodes.nodes;
  if ((i == 2 && !s->m->ordered_2_0) || (i == 3 && !s->m->ordered_3_0) || i < 2)
    return;
  size_t shift = 0; /* a face begins anywhere */
  while (i == 2 && shift < n && s->list.data[shift] != expected[0])
    shift++;
  int same = s->list.n == n, back = same;
  for (size_t k = 0; k < n; k++) {
    same &= s->list.data[(k + shift) % n] == expected[k];
    back &= s->list.data[(shift + n - k) % n] == expected[k];
  }
  if (!same && !(i == 2 && back))
    subject_fail(s, "the nodes of %lu are not in order", (unsigned long)c);
}

static void compare_pair(subject *s, int i, int j)
{
  gmds_csr all;
  gmds_csr_init(&all, &s->memory);
  if (s->m->do_bulk(s->mesh, i, j, &all) != GMDS_OK)
    subject_fail(s, "%d->%d of the whole mesh", i, j);
  for (gmds_id c = 0; c < s->ref.end[i]; c++) {
    gmds_status status = s->m->do_query(s->mesh, i, j, c, &s->list);
    if (!s->ref.cells[i][c].alive) {
      ck_assert_int_eq(status, GMDS_ERR_CELL);
      ck_assert_uint_eq(all.begin[c], all.begin[c + 1]);
      continue;
    }
    if (status != GMDS_OK)
      subject_fail(s, "%d->%d of %lu: %s", i, j, (unsigned long)c, gmds_status_text(status));
    compare_set(s, i, j, c, s->list.data, s->list.n, "alone");
    if (j == 0)
      compare_order(s, i, c);
    compare_set(s, i, j, c, all.data ? all.data + all.begin[c] : NULL, all.begin[c + 1] - all.begin[c], "all");
  }
  gmds_csr_clear(&all);
}

void subject_compare(subject *s)
{
  gmds_error error = {.status = GMDS_OK};
  const gmds_cells *cells = s->m->do_cells(s->mesh);
  for (int i = 0; i < 4; i++) {
    if (cells[i].count != reference_count(&s->ref, i) || cells[i].end != s->ref.end[i])
      subject_fail(s, "%zu cells of dimension %d below %zu, not %zu below %lu", cells[i].count, i, cells[i].end,
                   reference_count(&s->ref, i), (unsigned long)s->ref.end[i]);
    for (int j = 0; j < 4; j++)
      if (s->m->can[i][j])
        compare_pair(s, i, j);
  }
  for (gmds_id r = 0; r < s->ref.end[3]; r++)
    if (s->ref.cells[3][r].alive)
      ck_assert_int_eq(s->m->do_type(s->mesh, r), s->ref.cells[3][r].type);
  if (s->m->do_check && s->m->do_check(s->mesh, &s->memory, &error) != GMDS_OK)
    subject_fail(s, "%s", error.text);
}
