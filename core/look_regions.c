/* The report on a complex of regions: faces by their groups, fans by joining what regions have in common there. */
#include "finding.h"
#include "forest.h"
#include "sets.h"
#include "solid.h"
#include <gmds/predicates.h>
#include <string.h>

/* What regions have of nodes, or of edges: an element for each region and each of its keys. */
typedef struct fans {
  const gmds_walls *walls;
  const gmds_id *keys; /* a node or an edge for each entry of the rows of the complex */
  size_t n_keys;
  gmds_id *element; /* of each entry of the walls */
  gmds_id *key_of;  /* of each element */
  gmds_id *mark;    /* of each key: an element */
  size_t n_entries, n_elements;
  size_t *leader; /* of each group a wall, and 1 more; 0 for none */
  forest joined;
} fans;

static size_t wall_begin(const gmds_walls *walls, size_t w)
{
  return walls->complex->rows.begin[walls->first + w];
}

static gmds_status begin_fans(fans *f)
{
  const gmds_complex *c = f->walls->complex;
  void *element = NULL, *key_of = NULL, *mark = NULL, *leader = NULL;
  f->n_entries = wall_begin(f->walls, c->first_wall[c->nodes[3].n]) - wall_begin(f->walls, 0);
  int ok = gmds_resize(c->memory, &element, 0, f->n_entries, sizeof *f->element) &&
           gmds_resize(c->memory, &key_of, 0, f->n_entries, sizeof *f->key_of) &&
           gmds_resize(c->memory, &mark, 0, f->n_keys, sizeof *f->mark) &&
           gmds_resize(c->memory, &leader, 0, c->n_groups, sizeof *f->leader);
  f->element = element;
  f->key_of = key_of;
  f->mark = mark;
  f->leader = leader;
  if (!ok)
    return GMDS_ERR_MEMORY;
  if (f->n_keys)
    memset(mark, 0xff, f->n_keys * sizeof *f->mark);
  if (c->n_groups)
    memset(leader, 0, c->n_groups * sizeof *f->leader);
  return GMDS_OK;
}

static void end_fans(fans *f)
{
  const gmds_complex *c = f->walls->complex;
  gmds_release(c->memory, f->element, f->element ? f->n_entries : 0, sizeof *f->element);
  gmds_release(c->memory, f->key_of, f->key_of ? f->n_entries : 0, sizeof *f->key_of);
  gmds_release(c->memory, f->mark, f->mark ? f->n_keys : 0, sizeof *f->mark);
  gmds_release(c->memory, f->leader, f->leader ? c->n_groups : 0, sizeof *f->leader);
  forest_clear(&f->joined);
}

static void number_elements(fans *f)
{
  const gmds_complex *c = f->walls->complex;
  const size_t base = wall_begin(f->walls, 0);
  for (size_t r = 0; r < c->nodes[3].n; r++) {
    const size_t own = f->n_elements, to = wall_begin(f->walls, c->first_wall[r + 1]);
    for (size_t q = wall_begin(f->walls, c->first_wall[r]); q < to; q++) {
      gmds_id *mark = &f->mark[f->keys[q]];
      if (*mark == GMDS_NONE || *mark < own) {
        f->key_of[f->n_elements] = f->keys[q];
        *mark = (gmds_id)f->n_elements++;
      }
      f->element[q - base] = *mark;
    }
  }
}

/* Joins what the walls of one face have in common: not every side, where these list its nodes in other orders. */
static void join_walls(fans *f)
{
  const gmds_complex *c = f->walls->complex;
  const size_t base = wall_begin(f->walls, 0);
  if (f->n_keys)
    memset(f->mark, 0xff, f->n_keys * sizeof *f->mark);
  for (size_t w = 0; w < c->first_wall[c->nodes[3].n]; w++) {
    size_t *leader = &f->leader[gmds_wall_group(f->walls, w)];
    if (!*leader) {
      *leader = w + 1;
      continue;
    }
    for (size_t q = wall_begin(f->walls, *leader - 1); q < wall_begin(f->walls, *leader); q++)
      f->mark[f->keys[q]] = f->element[q - base];
    for (size_t q = wall_begin(f->walls, w); q < wall_begin(f->walls, w + 1); q++)
      if (f->mark[f->keys[q]] != GMDS_NONE)
        (void)forest_join(&f->joined, f->mark[f->keys[q]], f->element[q - base], 0);
    for (size_t q = wall_begin(f->walls, *leader - 1); q < wall_begin(f->walls, *leader); q++)
      f->mark[f->keys[q]] = GMDS_NONE;
  }
}

/* Counts the keys that regions have, and those whose regions are not one fan. ends: two nodes a key, or NULL. */
static gmds_status count_fans(const gmds_walls *walls, const gmds_id *keys, size_t n_keys, const gmds_id *ends,
                              size_t *n, gmds_finding *pinched)
{
  const gmds_complex *c = walls->complex;
  fans f = {.walls = walls, .keys = keys, .n_keys = n_keys, .joined = {.memory = c->memory}};
  gmds_status status = begin_fans(&f);
  if (status == GMDS_OK) {
    number_elements(&f);
    status = forest_begin(&f.joined, c->memory, f.n_elements);
  }
  if (status == GMDS_OK) {
    join_walls(&f);
    if (n_keys)
      memset(f.mark, 0, n_keys * sizeof *f.mark); /* becomes the number of fans */
    for (size_t x = 0; x < f.n_elements; x++)
      f.mark[f.key_of[x]] += f.joined.parent[x] == x;
    for (size_t k = 0; k < n_keys; k++) {
      *n += f.mark[k] > 0;
      if (f.mark[k] > 1)
        found(pinched, ends ? ends[2 * k] : (gmds_id)k, ends ? ends[2 * k + 1] : GMDS_NONE);
    }
  }
  end_fans(&f);
  return status;
}

/* Whether two walls of one face run around it the same way. */
static int run_alike(const gmds_walls *walls, size_t v, size_t w)
{
  const size_t n = gmds_wall_sides(walls, w);
  size_t k = 0;
  while (k < n && gmds_wall_node(walls, v, k) != gmds_wall_node(walls, w, 0))
    k++;
  return k < n && gmds_wall_node(walls, v, (k + 1) % n) == gmds_wall_node(walls, w, 1);
}

/* Whether two walls of one face list its nodes around in the same order, either way. */
static int have_the_same_sides(const gmds_walls *walls, size_t v, size_t w)
{
  const gmds_csr *rows = &walls->complex->rows;
  const size_t n = gmds_wall_sides(walls, w);
  return n < 4 || gmds_same_cycle(rows->data + wall_begin(walls, v), rows->data + wall_begin(walls, w), n);
}

static gmds_status look_at_walls(const gmds_walls *walls, gmds_volume_report *report)
{
  const gmds_complex *c = walls->complex;
  void *block = NULL;
  uint8_t *count = NULL;
  if (!gmds_resize(c->memory, &block, 0, c->n_groups, sizeof(size_t)))
    return GMDS_ERR_MEMORY;
  size_t *first = block;
  gmds_status status = gmds_walls_count(walls, c->memory, &count);
  if (c->n_groups)
    memset(block, 0xff, c->n_groups * sizeof *first);
  for (size_t r = 0; r < c->nodes[3].n && status == GMDS_OK; r++)
    for (size_t w = c->first_wall[r]; w < c->first_wall[r + 1]; w++) {
      const gmds_id g = gmds_wall_group(walls, w), k = (gmds_id)(w - c->first_wall[r]);
      const int again = first[g] != SIZE_MAX;
      report->faces += !again;
      if (again && !have_the_same_sides(walls, first[g], w))
        found(&report->crossed, (gmds_id)r, k);
      else if (count[g] == 2 && again && run_alike(walls, first[g], w))
        found(&report->turned, (gmds_id)r, k);
      if (count[g] == 1)
        found(&report->border, (gmds_id)r, k);
      else if (count[g] > 2 && !again)
        found(&report->crowded, (gmds_id)r, k);
      if (!again)
        first[g] = w;
    }
  gmds_release(c->memory, count, count ? c->n_groups : 0, 1);
  gmds_release(c->memory, block, c->n_groups, sizeof *first);
  return status;
}

/* Finds regions whose nodes are those of one before them. */
static gmds_status look_for_repetitions(const gmds_complex *c, gmds_volume_report *report)
{
  const gmds_csr *nodes = &c->nodes[3];
  void *group_block = NULL, *leader_block = NULL;
  size_t n_groups = 0;
  gmds_status status = GMDS_ERR_MEMORY;
  if (!nodes->n)
    return GMDS_OK;
  if (gmds_resize(c->memory, &group_block, 0, nodes->n, sizeof(gmds_id)) &&
      gmds_resize(c->memory, &leader_block, 0, nodes->n, sizeof(gmds_id)))
    status = gmds_group_sets(c->n_nodes, nodes->n, nodes->begin, nodes->data, c->memory, group_block, leader_block,
                             &n_groups);
  const gmds_id *group = group_block, *leader = leader_block;
  for (size_t r = 0; r < nodes->n && status == GMDS_OK; r++)
    if (group[r] != GMDS_NONE && leader[group[r]] != r)
      found(&report->repeated, (gmds_id)r, GMDS_NONE);
  gmds_release(c->memory, group_block, group_block ? nodes->n : 0, sizeof(gmds_id));
  gmds_release(c->memory, leader_block, leader_block ? nodes->n : 0, sizeof(gmds_id));
  return status;
}

static int repeats(const gmds_id *nodes, size_t n)
{
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < i; k++)
      if (nodes[i] == nodes[k])
        return 1;
  return 0;
}

static void look_at_shape(const gmds_walls *walls, const double *points, size_t r, gmds_volume_report *report)
{
  const gmds_complex *c = walls->complex;
  const gmds_id *nodes = c->nodes[3].data + c->nodes[3].begin[r];
  const size_t n = c->nodes[3].begin[r + 1] - c->nodes[3].begin[r];
  const gmds_cell_type type = (gmds_cell_type)c->types[r];
  uint8_t corner[SOLID_CORNERS][4];
  const size_t corners = solid_corners(type, corner);
  int lowest = 1;
  for (size_t k = 0; k < corners; k++) {
    const uint8_t *v = corner[k];
    int sign = gmds_orient3d(points + 3 * (size_t)nodes[v[0]], points + 3 * (size_t)nodes[v[1]],
                             points + 3 * (size_t)nodes[v[2]], points + 3 * (size_t)nodes[v[3]]);
    lowest = sign < lowest ? sign : lowest;
  }
  if (type == GMDS_POLYHEDRON ? !(solid_volume(walls, points, r) > 0) : repeats(nodes, n))
    lowest = 0;
  report->regions++;
  if (lowest < 1)
    found(lowest < 0 ? &report->inverted : &report->degenerate, (gmds_id)r, GMDS_NONE);
}

static gmds_status look_at_border(const gmds_walls *walls, gmds_volume_report *report)
{
  gmds_csr faces;
  gmds_ids on = {.memory = walls->complex->memory};
  gmds_csr_init(&faces, walls->complex->memory);
  gmds_status status = gmds_walls_boundary(walls, &faces, &on);
  if (status == GMDS_OK)
    status = gmds_look_at_faces(walls->complex->n_nodes, &faces, 1, walls->complex->memory, &report->surface);
  gmds_ids_clear(&on);
  gmds_csr_clear(&faces);
  return status;
}

gmds_status gmds_look_at_regions(const gmds_complex *c, const double *points, gmds_volume_report *report)
{
  gmds_walls walls;
  gmds_volume_report r = {.border = nothing_found,
                          .crowded = nothing_found,
                          .turned = nothing_found,
                          .crossed = nothing_found,
                          .repeated = nothing_found,
                          .pinched_edges = nothing_found,
                          .pinched_nodes = nothing_found,
                          .inverted = nothing_found,
                          .degenerate = nothing_found};
  GMDS_TRY(gmds_walls_init(&walls, c, points));
  gmds_status status = look_at_walls(&walls, &r);
  if (status == GMDS_OK)
    status = look_for_repetitions(c, &r);
  if (status == GMDS_OK)
    status = count_fans(&walls, c->rows.data, c->n_nodes, NULL, &r.nodes, &r.pinched_nodes);
  if (status == GMDS_OK)
    status = count_fans(&walls, c->sides.edges, c->sides.n, c->sides.nodes, &r.edges, &r.pinched_edges);
  if (status == GMDS_OK)
    status = look_at_border(&walls, &r);
  for (size_t x = 0; x < c->nodes[3].n && status == GMDS_OK; x++)
    if (c->nodes[3].begin[x] < c->nodes[3].begin[x + 1])
      look_at_shape(&walls, points, x, &r);
  gmds_walls_clear(&walls);
  r.manifold = !r.crowded.count && !r.crossed.count && !r.pinched_edges.count && !r.pinched_nodes.count;
  if (status == GMDS_OK)
    *report = r;
  return status;
}
