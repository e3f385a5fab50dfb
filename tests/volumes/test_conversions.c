/* Conversion between models of volumes, and what the check finds. */
#include "volumes/pool.h"
#include <gmds/relations.h>

static subject one, two;

/* The reference of a mesh from the nodes of its cells. */
static void refer_to(subject *s, const gmds_volume *volume)
{
  reference *r = &s->ref;
  const gmds_complex *c = &volume->complex;
  for (int i = 0; i < 4; i++) {
    r->end[i] = (gmds_id)s->m->do_cells(s->mesh)[i].end;
    ck_assert_uint_le(r->end[i], MAX_CELLS);
    for (gmds_id x = 0; x < r->end[i]; x++) {
      reference_cell *cell = &r->cells[i][x];
      *cell = (reference_cell){.alive = gmds_cells_has(&volume->cells[i], x)};
      if (!i || !cell->alive)
        continue;
      const gmds_id *nodes = c->nodes[i].data + c->nodes[i].begin[x];
      const size_t n = c->nodes[i].begin[x + 1] - c->nodes[i].begin[x];
      if (i < 3) {
        cell->nodes.n = n;
        memcpy(cell->nodes.nodes, nodes, n * sizeof *nodes);
        continue;
      }
      cell->type = (gmds_cell_type)c->types[x];
      if (cell->type != GMDS_POLYHEDRON) {
        cell->n_walls = reference_walls(cell->type, nodes, cell->walls);
        cell->n_corners = n;
        memcpy(cell->corners, nodes, n * sizeof *nodes);
        continue;
      }
      for (size_t k = c->walls.begin[x]; k < c->walls.begin[x + 1]; k++) {
        const gmds_id f = c->walls.data[k];
        cycle *w = &cell->walls[cell->n_walls++];
        w->n = c->nodes[2].begin[f + 1] - c->nodes[2].begin[f];
        memcpy(w->nodes, c->nodes[2].data + c->nodes[2].begin[f], w->n * sizeof *nodes);
      }
    }
  }
}

static void fill(subject *s, const volume_model *m, uint64_t seed)
{
  subject_begin(s, m, seed);
  pool_nodes(s);
  for (int i = 0; i < 40; i++)
    pool_step(s);
}

/* Attributes of every dimension: the number of the cell. */
static void number_cells(subject *s)
{
  for (int i = 0; i < 4; i++) {
    gmds_attribute *a = NULL;
    gmds_cells *cells = &s->m->do_cells(s->mesh)[i];
    ck_assert_int_eq(gmds_attribute_add(cells, "number", GMDS_ID, 1, &a), GMDS_OK);
    for (size_t c = 0; c < cells->end; c++)
      ((gmds_id *)a->data)[c] = (gmds_id)c + 1;
  }
}

START_TEST(a_mesh_becomes_one_of_another_model)
{
  uint64_t seed = 7;
  size_t converted = 0, refused = 0;
  for (size_t k = 0; k < n_volume_models; k++) {
    if (!volume_models[k]->do_get_volume)
      continue;
    const volume_model *to = volume_models[random_below(&seed, n_volume_models)];
    gmds_volume volume, back;
    gmds_error error = {.status = GMDS_OK};
    fill(&one, volume_models[k], 50 + k);
    number_cells(&one);
    gmds_volume_init(&volume, &one.memory);
    gmds_status status = one.m->do_get_volume(one.mesh, &volume, &error);
    if (status != GMDS_OK)
      subject_fail(&one, "is not listed: %s", error.text);
    subject_begin(&two, to, 1);
    status = to->do_set_volume(two.mesh, &volume, &error);
    if (status != GMDS_OK) {
      if (status != GMDS_ERR_UNSUPPORTED && status != GMDS_ERR_CONFLICT)
        subject_fail(&two, "from %s: %s", one.m->name, error.text);
      ck_assert(error.text[0]);
      refused++;
    } else {
      converted++;
      if (to->do_check(two.mesh, &two.memory, &error) != GMDS_OK)
        subject_fail(&two, "from %s: %s", one.m->name, error.text);
      uint64_t sum = 0, expected = 1;
      ck_assert_int_eq(one.m->do_checksum(one.mesh, &one.memory, &expected), GMDS_OK);
      ck_assert_int_eq(to->do_checksum(two.mesh, &two.memory, &sum), GMDS_OK);
      ck_assert_uint_eq(sum, expected);
      const gmds_cells *now = to->do_cells(two.mesh);
      for (int i = 0; i < 4; i++) { /* numbers and attributes stay where both models keep the cells */
        const gmds_attribute *a = gmds_attribute_find(&now[i], "number");
        const int kept =
            (i != 1 || (one.m->makes_edges && to->makes_edges)) && (i != 2 || (one.m->makes_faces && to->makes_faces));
        for (gmds_id c = 0; c < one.ref.end[i] && kept; c++) {
          ck_assert_int_eq(gmds_cells_has(&now[i], c), reference_has(&one.ref, i, c));
          if (reference_has(&one.ref, i, c))
            ck_assert_uint_eq(((const gmds_id *)a->data)[c], c + 1);
        }
      }
      if (to->do_get_volume) {
        gmds_volume_init(&back, &two.memory);
        ck_assert_int_eq(to->do_get_volume(two.mesh, &back, &error), GMDS_OK);
        refer_to(&two, &back);
        gmds_volume_clear(&back);
        subject_compare(&two);
        for (int i = 0; i < 10; i++)
          pool_step(&two); /* it goes on as any other */
        subject_compare(&two);
      }
    }
    gmds_volume_clear(&volume);
    subject_end(&two);
    subject_end(&one);
  }
  printf("%zu conversions, %zu refused\n", converted, refused);
  ck_assert_uint_gt(converted, 100);
}
END_TEST

RUN_SUITE("conversions", a_mesh_becomes_one_of_another_model)
