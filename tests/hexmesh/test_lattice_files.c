/* Claims about the surfaces of the data folder on the lattice. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "leaves.h"
#include <unistd.h>

/* All turned outwards, and none of their parts encloses or crosses another. */
static const char *const closed[] = {"bff_kitten.obj",
                                     "cgal_3torus.off",
                                     "cgal_armadillo.off",
                                     "cgal_bones.off",
                                     "cgal_cheese.off",
                                     "cgal_cow.off",
                                     "cgal_double-torus-example.off",
                                     "cgal_elephant.off",
                                     "cgal_knot2.off",
                                     "cgal_turbine.off",
                                     "cinolib_bamboo_pen.obj",
                                     "cinolib_lion_vase_poly.off",
                                     "derived_lobsterCT_poly.off",
                                     "derived_lobsterCT_tri.off",
                                     "gpjs_soccerball.obj",
                                     "loopycuts_dancer.obj",
                                     "openscad_far-out-ring.stl",
                                     "simnibs_fsaverage_lh_sphere.off",
                                     "surfice_BrainMesh_Ch2.off",
                                     "vmas_neptune.off",
                                     "vtkdata_turbineblade.ply"};
static const struct {
  const char *name, *text;
} open[] = {{"cgal_blade_open.off", "the surface is open: the edge of vertices 0 and 4185 has one face, 0"},
            {"geometry-central_moebius.obj", "the surface is open: the edge of vertices 0 and 1 has one face, 0"}};

static char scratch[256];

static const char *unpack(const char *folder, const char *name)
{
  static char path[600];
  char command[1400];
  snprintf(path, sizeof path, "%s/surfaces/%s", folder, name);
  if (access(path, R_OK) == 0)
    return path;
  snprintf(command, sizeof command, "xz -dc '%s.xz' > '%s/in%s'", path, scratch, strrchr(name, '.'));
  ck_assert_int_eq(system(command), 0);
  snprintf(path, sizeof path, "%s/in%s", scratch, strrchr(name, '.'));
  return path;
}

static void check_file(const char *path, const char *name)
{
  gmds_memory_init(&memory, NULL);
  gmds_error error = {.status = GMDS_OK};
  const gmds_lattice_options o = {.base = {1, 2, 1}, .threads = 2, .error = &error};
  gmds_soup soup;
  gmds_lattice l;
  gmds_lattice_leaves leaves;
  wide v[2];
  make(path, &soup);
  check_surface(&soup, &o, 5, v, &l, &leaves);
  const wide volume = volume_of(&l);
  ck_assert_msg(v[0] > 0 && v[0] <= volume && volume <= v[0] + v[1], "%s", name);
  ck_assert_msg(!l.n_turned && leaves.lowest == 0 && leaves.highest == 1, "%s", name);
  gmds_lattice_leaves_clear(&leaves);
  gmds_lattice_clear(&l);
  gmds_soup_clear(&soup);
  ck_assert_uint_eq(memory.live, 0);
}

START_TEST(surfaces_of_files_lie_between_their_inside_and_what_they_cut)
{
  const char *folder = data_folder("surfaces");
  if (!folder)
    return;
  snprintf(scratch, sizeof scratch, "%s/gmds-lattice-XXXXXX", getenv("TMPDIR") ? getenv("TMPDIR") : "/tmp");
  ck_assert_ptr_nonnull(mkdtemp(scratch));
  for (size_t k = 0; k < sizeof closed / sizeof *closed; k++)
    check_file(unpack(folder, closed[k]), closed[k]);
  for (size_t k = 0; k < 2; k++) {
    gmds_soup soup;
    gmds_memory_init(&memory, NULL);
    make(unpack(folder, open[k].name), &soup);
    refuse(&soup, (gmds_lattice_options){.threads = 1}, GMDS_ERR_ARGUMENT, open[k].text);
    gmds_soup_clear(&soup);
  }
  static const char *const extensions[] = {".off", ".obj", ".ply", ".stl"};
  for (size_t k = 0; k < 4; k++) {
    char path[300];
    snprintf(path, sizeof path, "%s/in%s", scratch, extensions[k]);
    (void)unlink(path);
  }
  ck_assert_int_eq(rmdir(scratch), 0);
}
END_TEST

RUN_SUITE("surfaces of files on the lattice", surfaces_of_files_lie_between_their_inside_and_what_they_cut)
