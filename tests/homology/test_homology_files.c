/* The Betti numbers of every surface of the data folder, against its census. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "harness.h"
#include <gmds/homology.h>
#include <gmds/io.h>
#include <unistd.h>

typedef struct file {
  const char *name, *extension;
  size_t vertices, edges, faces, betti[3];
  int closed, orientable;
} file;
static const file files[] = {{"bff_kitten", ".obj", 53123, 159369, 106246, {1, 2, 1}, 1, 1},
                             {"cgal_3torus", ".off", 19, 46, 23, {1, 6, 1}, 1, 1},
                             {"cgal_armadillo", ".off", 26002, 78000, 52000, {1, 0, 1}, 1, 1},
                             {"cgal_blade_open", ".off", 8231, 24453, 16222, {1, 1, 0}, 0, 1},
                             {"cgal_bones", ".off", 2154, 6306, 4204, {26, 0, 26}, 1, 1},
                             {"cgal_cheese", ".off", 8629, 26679, 17786, {1, 266, 1}, 1, 1},
                             {"cgal_cow", ".off", 2904, 8706, 5804, {1, 0, 1}, 1, 1},
                             {"cgal_double-torus-example", ".off", 231, 453, 220, {1, 4, 1}, 1, 1},
                             {"cgal_elephant", ".off", 2775, 8337, 5558, {1, 6, 1}, 1, 1},
                             {"cgal_knot2", ".off", 5760, 17280, 11520, {2, 4, 2}, 1, 1},
                             {"cgal_turbine", ".off", 9210, 27690, 18460, {1, 22, 1}, 1, 1},
                             {"cinolib_bamboo_pen", ".obj", 1146, 2320, 1160, {1, 16, 1}, 1, 1},
                             {"cinolib_lion_vase_poly", ".off", 46206, 69309, 23105, {1, 0, 1}, 1, 1},
                             {"derived_lobsterCT_poly", ".off", 148104, 296208, 147834, {285, 840, 285}, 1, 1},
                             {"derived_lobsterCT_tri", ".off", 282184, 846690, 564460, {299, 644, 299}, 1, 1},
                             {"geometry-central_moebius", ".obj", 280, 504, 224, {1, 1, 0}, 0, 0},
                             {"gpjs_soccerball", ".obj", 28740, 86400, 57600, {1, 62, 1}, 1, 1},
                             {"loopycuts_dancer", ".obj", 16004, 48012, 32008, {1, 2, 1}, 1, 1},
                             {"openscad_far-out-ring", ".stl", 1536, 4608, 3072, {1, 2, 1}, 1, 1},
                             {"simnibs_fsaverage_lh_sphere", ".off", 163842, 491520, 327680, {1, 0, 1}, 1, 1},
                             {"surfice_BrainMesh_Ch2", ".off", 53469, 161097, 107398, {2, 234, 2}, 1, 1},
                             {"vmas_neptune", ".off", 14814, 44454, 29636, {1, 6, 1}, 1, 1},
                             {"vtkdata_turbineblade", ".ply", 99519, 298551, 199034, {1, 0, 1}, 1, 1}};

static char scratch[256];

static const char *unpack(const char *folder, const file *f)
{
  static char path[600];
  char command[1400];
  snprintf(path, sizeof path, "%s/surfaces/%s%s", folder, f->name, f->extension);
  if (access(path, R_OK) == 0)
    return path;
  snprintf(command, sizeof command, "xz -dc '%s.xz' > '%s/in%s'", path, scratch, f->extension);
  ck_assert_int_eq(system(command), 0);
  snprintf(path, sizeof path, "%s/in%s", scratch, f->extension);
  return path;
}

static void check_file(const char *path, const file *f)
{
  gmds_memory memory;
  gmds_soup soup;
  gmds_surface s;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 3);
  gmds_surface_init(&s, &memory);
  ck_assert_msg(gmds_make_surface(path, &error, &soup) == GMDS_OK, "%s", error.text);
  uint16_t *labels = malloc(soup.n_points * sizeof *labels);
  ck_assert_int_eq(gmds_grid_labels(soup.n_points, 3, soup.points, 8, 2, labels, NULL), GMDS_OK);
  ck_assert_msg(gmds_surface_take_soup(&s, &soup, 2, &error) == GMDS_OK, "%s: %s", path, error.text);
  for (int way = 0; way < 3; way++) {
    const gmds_homology_options o = {.threads = 2,
                                     .clustering = way == 2 ? GMDS_BY_LABELS : GMDS_BY_RANGES,
                                     .ranges = (unsigned)way,
                                     .labels = labels,
                                     .generators = 1};
    gmds_homology h;
    gmds_homology_init(&h, &memory);
    ck_assert_int_eq(gmds_homology_of(&s, &o, &h), GMDS_OK);
    ck_assert_uint_eq(h.vertices, f->vertices);
    ck_assert_uint_eq(h.edges, f->edges);
    ck_assert_uint_eq(h.faces, f->faces);
    ck_assert_uint_eq(h.components, f->betti[0]);
    for (int i = 0; i < 3; i++)
      ck_assert_msg(h.betti[i] == f->betti[i], "%s: Betti number %d is %zu", f->name, i, h.betti[i]);
    ck_assert_int_eq(h.closed, f->closed);
    ck_assert_int_eq(h.orientable, f->orientable);
    ck_assert_uint_eq(h.inner + h.critical + h.border, f->faces - f->betti[2]);
    ck_assert_uint_eq(h.dangling + h.contracted, f->vertices - f->betti[0]);
    ck_assert_uint_eq(h.h1.n, f->betti[1]);
    gmds_homology_clear(&h);
  }
  free(labels);
  gmds_surface_clear(&s);
  ck_assert_uint_eq(memory.live, 0);
}

START_TEST(every_surface_has_the_numbers_of_its_census)
{
  const char *folder = data_folder("surfaces");
  if (!folder)
    return;
  snprintf(scratch, sizeof scratch, "%s/gmds-surfaces-XXXXXX", getenv("TMPDIR") ? getenv("TMPDIR") : "/tmp");
  ck_assert_ptr_nonnull(mkdtemp(scratch));
  for (size_t k = 0; k < sizeof files / sizeof *files; k++)
    check_file(unpack(folder, &files[k]), &files[k]);
  static const char *const extensions[] = {".off", ".obj", ".ply", ".stl"};
  for (size_t k = 0; k < 4; k++) {
    char path[300];
    snprintf(path, sizeof path, "%s/in%s", scratch, extensions[k]);
    (void)unlink(path);
  }
  ck_assert_int_eq(rmdir(scratch), 0);
}
END_TEST

RUN_SUITE("homology of files", every_surface_has_the_numbers_of_its_census)
