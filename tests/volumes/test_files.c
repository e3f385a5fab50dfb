/* Every mesh of volumes of the data folder: read, made a mesh with all sixteen relations, checked, written and read
 * back. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "harness.h"
#include <gmds/io.h>
#include <unistd.h>

#define GMDS_PREFIX whole
#define GMDS_MODEL \
  (N | E | F | R | N2N | N2E | N2F | N2R | E2N | E2E | E2F | E2R | F2N | F2E | F2F | F2R | R2N | R2E | R2F | R2R)
#define GMDS_FACES (TRIANGLE | QUADRILATERAL | POLYGON)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON | POLYHEDRON)
#include <gmds/mesh.h>
#include <gmds/end.h>

/* The census of the folder: nodes in use, edges, faces, regions. */
typedef struct file {
  const char *name, *extension;
  size_t edges, faces, regions;
} file;
static const file files[] = {{"cinolib_rockerarm_hex", ".mesh", 35989, 33838, 10600},
                             {"gmds072_easy2_polydata", ".vtk", 16827, 11218, 0},
                             {"gmds_B80", ".vtk", 4111, 6195, 2832},
                             {"gmds_ElipticSmoothTest2_quads", ".vtk", 13453, 6633, 0},
                             {"gmds_HolesInSquare2", ".mesh", 3261, 2120, 0},
                             {"gmds_HolesInSquare2", ".vtk", 3261, 2120, 0},
                             {"gmds_mambo_B31", ".vtk", 76821, 123588, 59058},
                             {"gmds_several_types", ".vtk", 0, 0, 4},
                             {"gmds_tet_in_box", ".vtk", 113, 146, 61},
                             {"hexsmoothing_mixedElementMesh", ".vtk", 3916, 4344, 1628},
                             {"libigl_hand", ".mesh", 42009, 64774, 29998},
                             {"mfem_homology.asc.v22", ".msh", 10821, 16252, 7392},
                             {"mmg_naca", ".mesh", 45201, 30100, 0},
                             {"polyfem_microstructure_P1", ".msh", 8890, 13709, 6414}};

static char scratch[256];
static gmds_memory memory;

static const char *unpack(const char *folder, const file *f)
{
  static char path[600];
  char command[1400];
  snprintf(path, sizeof path, "%s/volumes/%s%s", folder, f->name, f->extension);
  if (access(path, R_OK) == 0)
    return path;
  snprintf(command, sizeof command, "xz -dc '%s.xz' > '%s/in%s'", path, scratch, f->extension);
  ck_assert_int_eq(system(command), 0);
  snprintf(path, sizeof path, "%s/in%s", scratch, f->extension);
  return path;
}

/* One line a cell: type, nodes, and the bytes of every attribute; sorted, so that soups can be compared. */
typedef struct line {
  size_t n;
  unsigned char *bytes;
} line;

static int by_bytes(const void *a, const void *b)
{
  const line *x = a, *y = b;
  int order = memcmp(x->bytes, y->bytes, x->n < y->n ? x->n : y->n);
  return order ? order : (x->n > y->n) - (x->n < y->n);
}

static void put(line *l, const void *bytes, size_t n)
{
  l->bytes = realloc(l->bytes, l->n + n);
  memcpy(l->bytes + l->n, bytes, n);
  l->n += n;
}

static void put_attributes(line *l, const gmds_soup *s, gmds_place place, size_t item, const gmds_soup *names)
{
  for (const gmds_attribute *a = names->attributes[place]; a; a = a->next) {
    const gmds_attribute *own = gmds_soup_find_attribute(s, place, a->name);
    ck_assert_msg(own && own->type == a->type && own->components == a->components, "attribute '%s' is lost", a->name);
    put(l, (const char *)own->data + item * own->bytes, own->bytes);
  }
}

static line *lines_of(const gmds_soup *s, const gmds_soup *names)
{
  line *lines = calloc(s->n_cells + 1, sizeof *lines);
  for (size_t c = 0; c < s->n_cells; c++) {
    put(&lines[c], &s->types[c], 1);
    put(&lines[c], s->corners + s->begin[c], (s->begin[c + 1] - s->begin[c]) * sizeof *s->corners);
    put_attributes(&lines[c], s, GMDS_OF_CELLS, c, names);
  }
  qsort(lines, s->n_cells, sizeof *lines, by_bytes);
  return lines;
}

static void compare_points(const gmds_soup *a, const gmds_soup *b)
{
  ck_assert_uint_eq(a->n_points, b->n_points);
  for (size_t v = 0; v < a->n_points; v++) {
    for (int k = 0; k < 3; k++) {
      const double x = k < a->dim ? a->points[v * (size_t)a->dim + (size_t)k] : 0;
      const double y = k < b->dim ? b->points[v * (size_t)b->dim + (size_t)k] : 0;
      ck_assert(memcmp(&x, &y, sizeof x) == 0 || (x == 0 && y == 0));
    }
    line p = {0, NULL}, q = {0, NULL};
    put_attributes(&p, a, GMDS_OF_POINTS, v, a);
    put_attributes(&q, b, GMDS_OF_POINTS, v, a);
    ck_assert(p.n == q.n && (!p.n || !memcmp(p.bytes, q.bytes, p.n)));
    free(p.bytes);
    free(q.bytes);
  }
}

/* Equal coordinates, cells and attributes; cells in any order. */
static void compare_soups(const gmds_soup *a, const gmds_soup *b)
{
  compare_points(a, b);
  line *p = lines_of(a, a), *q = lines_of(b, a);
  size_t i = 0, j = 0;
  while (i < a->n_cells && j < b->n_cells) {
    if (by_bytes(&p[i], &q[j]) != 0)
      ck_abort_msg("cell %zu of %zu differs from %zu of %zu (type %d and %d)", i, a->n_cells, j, b->n_cells,
                   p[i].bytes[0], q[j].bytes[0]);
    i++;
    j++;
  }
  ck_assert_uint_eq(i, a->n_cells);
  ck_assert_uint_eq(j, b->n_cells);
  for (size_t c = 0; c < a->n_cells; c++)
    free(p[c].bytes);
  for (size_t c = 0; c < b->n_cells; c++)
    free(q[c].bytes);
  free(p);
  free(q);
}

/* How many edges and faces the cells of the highest dimension have: what the census counts. */
static size_t bounding(const whole_mesh *m, int i, int top)
{
  size_t n = 0;
  gmds_ids list = {.memory = &memory};
  for (gmds_id c = 0; c < (i == 1 ? whole_end_1(m) : whole_end_2(m)); c++) {
    gmds_status status = i == 1 ? top == 3 ? whole_get_adj_1_3(m, c, &list) : whole_get_adj_1_2(m, c, &list)
                                : whole_get_adj_2_3(m, c, &list);
    n += status == GMDS_OK && list.n > 0;
  }
  gmds_ids_clear(&list);
  return n;
}

static void go_through(const char *path, const file *f)
{
  gmds_soup soup, back, again;
  whole_mesh m;
  gmds_error error = {.status = GMDS_OK};
  char out[400];
  gmds_soup_init(&soup, &memory, 3);
  gmds_soup_init(&back, &memory, 3);
  gmds_soup_init(&again, &memory, 3);
  whole_mesh_init(&m, NULL);
  ck_assert_msg(gmds_read_soup(path, 0, &error, &soup) == GMDS_OK, "%s", error.text);
  ck_assert_msg(whole_from_soup(&m, &soup, &error) == GMDS_OK, "%s: %s", path, error.text);
  ck_assert_msg(whole_check(&m, &memory, &error) == GMDS_OK, "%s: %s", path, error.text);
  ck_assert_uint_eq(whole_count_3(&m), f->regions);
  if (f->edges) {
    ck_assert_uint_eq(bounding(&m, 1, f->regions ? 3 : 2), f->edges);
    ck_assert_uint_eq(f->regions ? bounding(&m, 2, 3) : whole_count_2(&m), f->faces);
  }
  ck_assert_msg(whole_to_soup(&m, &back, &error) == GMDS_OK, "%s: %s", path, error.text);
  compare_soups(&soup, &back);
  snprintf(out, sizeof out, "%s/out%s", scratch, f->extension);
  ck_assert_msg(gmds_write_soup(out, &back, &error) == GMDS_OK, "%s: %s", path, error.text);
  ck_assert_msg(gmds_read_soup(out, 0, &error, &again) == GMDS_OK, "%s: %s", out, error.text);
  compare_soups(&soup, &again);
  printf("%s%s: %zu nodes, %zu edges, %zu faces, %zu regions\n", f->name, f->extension, whole_count_0(&m),
         whole_count_1(&m), whole_count_2(&m), whole_count_3(&m));
  whole_mesh_clear(&m);
  gmds_soup_clear(&soup);
  gmds_soup_clear(&back);
  gmds_soup_clear(&again);
  ck_assert_uint_eq(memory.live, 0);
}

START_TEST(real_volumes_become_meshes_with_all_relations_and_come_back)
{
  const char *folder = data_folder("real volumes");
  if (!folder)
    return;
  gmds_memory_init(&memory, NULL);
  snprintf(scratch, sizeof scratch, "/tmp/gmds_volumes_XXXXXX");
  ck_assert(mkdtemp(scratch) != NULL);
  for (size_t k = 0; k < sizeof files / sizeof *files; k++)
    go_through(unpack(folder, &files[k]), &files[k]);
  char command[400];
  snprintf(command, sizeof command, "rm -r '%s'", scratch);
  ck_assert_int_eq(system(command), 0);
}
END_TEST

START_TEST(a_file_of_another_program_is_refused_by_name)
{
  const char *folder = data_folder("a file of another program");
  char path[600];
  gmds_error error = {.status = GMDS_OK};
  gmds_soup soup;
  if (!folder)
    return;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 3);
  snprintf(path, sizeof path, "%s/volumes/mfem_fichera-mixed.mesh", folder);
  ck_assert_int_ne(gmds_read_soup(path, 0, &error, &soup), GMDS_OK);
  ck_assert_msg(strstr(error.text, "MFEM") != NULL, "%s", error.text);
}
END_TEST

RUN_SUITE("files", real_volumes_become_meshes_with_all_relations_and_come_back,
          a_file_of_another_program_is_refused_by_name)
