/* Claims about operations: scripts of them from fixed seeds, in dimension 2, 3 and 4, against links as plain arrays and
 * orbits by brute force (brute.h). Every step is tried with each of its allocations failing first: nothing has changed
 * then. */
#include "brute.h"
#include "harness.h"

enum { STEPS = 120, MANY = 110 };

typedef struct script {
  gmds_map map;
  failing f;
  gmds_memory memory; /* what snapshots are written to */
  uint64_t seed;
  brute expected;
  int decides; /* `expected` says which links there are afterwards, and `refused` whether */
  int refused;
  size_t done[16], denied[16];
} script;

static gmds_id any_dart(script *s)
{
  if (!s->map.darts.count)
    return GMDS_NONE;
  gmds_id d = gmds_cells_next(&s->map.darts, (gmds_id)random_below(&s->seed, s->map.darts.end));
  return d == GMDS_NONE ? gmds_cells_next(&s->map.darts, 0) : d;
}

static gmds_status make_something(script *s, uint64_t what, gmds_id *d)
{
  const gmds_cell_type types[] = {GMDS_TETRAHEDRON, GMDS_PYRAMID, GMDS_PRISM, GMDS_HEXAHEDRON};
  if (what % 8 == 7)
    return gmds_map_add_dart(&s->map, d);
  if (what % 8 == 6)
    return gmds_map_make_edge(&s->map, NULL, d);
  if (s->map.n > 2 && what % 8 < 3)
    return gmds_map_make_shape(&s->map, types[what / 8 % 4], NULL, NULL, d);
  return gmds_map_make_polygon(&s->map, 3 + what / 8 % 3, NULL, NULL, d);
}

typedef enum step { MAKE, SEW, UNSEW, EDGE, FACE, ACROSS, DANGLE, WALL, REMOVE, CONTRACT, CLOSE, STEP_KINDS } step;

/* A closed path around a vertex of a volume, or the border of a face: what a wall can follow. */
static size_t path_from(const gmds_map *map, gmds_id d, gmds_id path[8])
{
  size_t n = 0;
  gmds_id e = d;
  do {
    if (n == 8)
      return n;
    path[n++] = e;
    e = gmds_map_beta(map, 1, e);
  } while (e != GMDS_NONE && e != d);
  return n;
}

static gmds_status take_step(script *s, step kind, int i, gmds_id d, gmds_id e, uint64_t what)
{
  gmds_map *map = &s->map;
  gmds_id made = GMDS_NONE, path[8];
  size_t n = 0;
  switch (kind) {
  case MAKE:
    return make_something(s, what, &made);
  case SEW:
    return gmds_map_sew(map, i, d, e);
  case UNSEW:
    return gmds_map_unsew(map, i, d);
  case EDGE:
    return gmds_map_insert_vertex_in_edge(map, d, NULL, &made);
  case FACE:
    return gmds_map_insert_vertex_in_face(map, d, NULL, &made);
  case ACROSS:
    return gmds_map_insert_edge_in_face(map, d, e, &made);
  case DANGLE:
    return gmds_map_insert_dangling_edge(map, d, NULL, &made);
  case WALL:
    n = path_from(map, d, path);
    return map->n == 3 ? gmds_map_insert_face_in_volume(map, n, path, &made) : GMDS_OK;
  case REMOVE:
    return gmds_map_remove_cell(map, i, d);
  case CONTRACT:
    return gmds_map_contract_cell(map, i, d);
  default:
    return gmds_map_close(map, i, &n);
  }
}

/* What the links must be afterwards, where the definitions say so. */
static void foresee(script *s, step kind, int i, gmds_id d, gmds_id e)
{
  s->decides = kind == SEW || kind == UNSEW || kind == REMOVE || kind == CONTRACT;
  brute_copy(&s->expected, &s->map);
  int can = 1;
  if (kind == SEW)
    can = (i == 1 || d != e) && brute_sew(&s->expected, i, d, e);
  else if (kind == UNSEW)
    can = brute_unsew(&s->expected, i, d);
  else if (kind == REMOVE)
    can = brute_remove(&s->expected, i, d);
  else if (kind == CONTRACT)
    can = brute_contract(&s->expected, i, d);
  s->refused = !can;
}

static void play(script *s, step kind)
{
  gmds_map_bytes before = {.memory = &s->memory}, after = before;
  gmds_error error = {.text = ""};
  const uint64_t what = random_bits(&s->seed);
  const int n = s->map.n, i = kind == REMOVE  ? (int)random_below(&s->seed, (size_t)n)
                              : kind == CLOSE ? 2 + (int)random_below(&s->seed, (size_t)n - 1)
                                              : 1 + (int)random_below(&s->seed, (size_t)n);
  const gmds_id d = any_dart(s);
  gmds_id e = any_dart(s);
  if (kind == ACROSS && what % 4) { /* more often than not one of the same face */
    e = d;
    for (size_t k = 1 + what / 4 % 4; k-- && gmds_map_beta(&s->map, 1, e) != GMDS_NONE;)
      e = gmds_map_beta(&s->map, 1, e);
  }
  static brute was;
  brute_copy(&was, &s->map);
  foresee(s, kind, i, d, e);
  ck_assert_int_eq(gmds_map_write(&s->map, &before), GMDS_OK);
  gmds_status status = GMDS_ERR_MEMORY;
  for (long k = 0; status == GMDS_ERR_MEMORY; k++) {
    s->f.until = k;
    status = take_step(s, kind, i, d, e, what);
    s->f.until = 1000000;
    if (status == GMDS_OK)
      break;
    const gmds_status written = gmds_map_write(&s->map, &after);
    if (k > 5000 || !brute_equals(&was, &s->map) || written != GMDS_OK || before.n != after.n ||
        memcmp(before.data, after.data, before.n))
      ck_abort_msg("step %d, status %d at allocation %ld: something has changed", kind, status, k);
  }
  ck_assert(status == GMDS_OK || status == GMDS_ERR_CONFLICT || status == GMDS_ERR_ARGUMENT);
  if (s->decides) {
    ck_assert_msg((status != GMDS_OK) == s->refused, "step %d of beta %d: status %d", kind, i, status);
    if (status == GMDS_OK)
      ck_assert_msg(brute_equals(&s->expected, &s->map), "step %d of beta %d: other links", kind, i);
  }
  *(status == GMDS_OK ? &s->done[kind] : &s->denied[kind]) += 1;
  ck_assert_msg(gmds_map_check(&s->map, &s->memory, NULL, &error) == GMDS_OK, "step %d, %d: %s", kind, i, error.text);
  brute_check_cells(&s->map);
  gmds_map_bytes_clear(&before);
  gmds_map_bytes_clear(&after);
}

static void run_script(int n, uint64_t seed, size_t done[STEP_KINDS])
{
  static script s;
  memset(&s, 0, sizeof s);
  s.seed = seed;
  s.f.until = 1000000;
  gmds_allocator allocator = failing_allocator(&s.f);
  gmds_memory_init(&s.memory, NULL);
  gmds_map_init(&s.map, n, n == 2 ? 2 : 3, 15, &allocator);
  for (int k = 0; k < 3; k++)
    play(&s, MAKE);
  for (int k = 0; k < STEPS; k++) {
    step kind = (step)random_below(&s.seed, STEP_KINDS);
    if (s.map.darts.count < 4)
      kind = MAKE;
    else if (s.map.darts.count > MANY)
      kind = random_below(&s.seed, 2) ? REMOVE : CONTRACT;
    else if (kind == CLOSE && random_below(&s.seed, 3))
      kind = SEW;
    play(&s, kind);
  }
  for (int k = 0; k < STEP_KINDS; k++)
    done[k] += s.done[k];
  gmds_map_clear(&s.map);
  ck_assert_uint_eq(s.f.live, 0);
  ck_assert_uint_eq(s.memory.live, 0);
}

static void run_scripts(int n)
{
  size_t done[STEP_KINDS] = {0};
  for (uint64_t seed = 1; seed <= 60; seed++)
    run_script(n, 1000 * (uint64_t)n + seed, done);
  for (int k = 0; k < STEP_KINDS; k++)
    ck_assert_msg(done[k] > 0 || (k == WALL && n != 3), "step %d was never taken in dimension %d", k, n);
}

START_TEST(scripts_of_operations_agree_with_brute_force_in_2_maps)
{
  run_scripts(2);
}
END_TEST

START_TEST(scripts_of_operations_agree_with_brute_force_in_3_maps)
{
  run_scripts(3);
}
END_TEST

START_TEST(scripts_of_operations_agree_with_brute_force_in_4_maps)
{
  run_scripts(4);
}
END_TEST

RUN_SUITE("maps by brute force", scripts_of_operations_agree_with_brute_force_in_2_maps,
          scripts_of_operations_agree_with_brute_force_in_3_maps,
          scripts_of_operations_agree_with_brute_force_in_4_maps)
