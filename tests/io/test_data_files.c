/* Real files of the data folder: as many points and cells as its own census says, and those of volumes go through every
 * format that holds them. */
#include "soup_tools.h"

/* X(file, points, vertices, edges, faces, volumes) */
#define MESH_LIST(X)                                                        \
  X("surfaces/bff_kitten.obj.xz", 53123, 0, 0, 106246, 0)                   \
  X("surfaces/cinolib_bamboo_pen.obj.xz", 1146, 0, 0, 1160, 0)              \
  X("surfaces/geometry-central_moebius.obj", 280, 0, 0, 224, 0)             \
  X("surfaces/gpjs_soccerball.obj.xz", 28740, 0, 0, 57600, 0)               \
  X("surfaces/loopycuts_dancer.obj.xz", 16004, 0, 0, 32008, 0)              \
  X("surfaces/openscad_far-out-ring.stl.xz", 1536, 0, 0, 3072, 0)           \
  X("surfaces/vtkdata_turbineblade.ply.xz", 99519, 0, 0, 199034, 0)         \
  X("surfaces/cgal_3torus.off", 19, 0, 0, 23, 0)                            \
  X("surfaces/cgal_armadillo.off.xz", 26002, 0, 0, 52000, 0)                \
  X("surfaces/cgal_blade_open.off.xz", 8231, 0, 0, 16222, 0)                \
  X("surfaces/cgal_bones.off.xz", 2154, 0, 0, 4204, 0)                      \
  X("surfaces/cgal_cheese.off.xz", 8629, 0, 0, 17786, 0)                    \
  X("surfaces/cgal_cow.off.xz", 2904, 0, 0, 5804, 0)                        \
  X("surfaces/cgal_double-torus-example.off", 231, 0, 0, 220, 0)            \
  X("surfaces/cgal_elephant.off.xz", 2775, 0, 0, 5558, 0)                   \
  X("surfaces/cgal_knot2.off.xz", 5760, 0, 0, 11520, 0)                     \
  X("surfaces/cgal_turbine.off.xz", 9210, 0, 0, 18460, 0)                   \
  X("surfaces/cinolib_lion_vase_poly.off.xz", 46206, 0, 0, 23105, 0)        \
  X("surfaces/derived_lobsterCT_poly.off.xz", 148104, 0, 0, 147834, 0)      \
  X("surfaces/derived_lobsterCT_tri.off.xz", 282184, 0, 0, 564460, 0)       \
  X("surfaces/simnibs_fsaverage_lh_sphere.off.xz", 163842, 0, 0, 327680, 0) \
  X("surfaces/surfice_BrainMesh_Ch2.off.xz", 53469, 0, 0, 107398, 0)        \
  X("surfaces/vmas_neptune.off.xz", 14814, 0, 0, 29636, 0)                  \
  X("volumes/cinolib_rockerarm_hex.mesh.xz", 12751, 0, 0, 4076, 10600)      \
  X("volumes/gmds072_easy2_polydata.vtk.xz", 5609, 0, 0, 11218, 0)          \
  X("volumes/gmds_B80.vtk.xz", 749, 8, 102, 1062, 2832)                     \
  X("volumes/gmds_ElipticSmoothTest2_quads.vtk.xz", 6820, 0, 0, 6633, 0)    \
  X("volumes/gmds_HolesInSquare2.mesh.xz", 1143, 0, 162, 2120, 0)           \
  X("volumes/gmds_HolesInSquare2.vtk.xz", 1143, 9, 162, 2120, 0)            \
  X("volumes/gmds_mambo_B31.vtk.xz", 12291, 24, 544, 10944, 59058)          \
  X("volumes/gmds_several_types.vtk", 14, 0, 0, 0, 4)                       \
  X("volumes/gmds_tet_in_box.vtk", 29, 0, 0, 0, 61)                         \
  X("volumes/hexsmoothing_mixedElementMesh.vtk.xz", 1201, 0, 0, 883, 1628)  \
  X("volumes/libigl_hand.mesh.xz", 7234, 0, 0, 9556, 29998)                 \
  X("volumes/mfem_homology.asc.v22.msh.xz", 1961, 0, 707, 6106, 7392)       \
  X("volumes/mmg_naca.mesh.xz", 15102, 0, 102, 30100, 0)                    \
  X("volumes/polyfem_microstructure_P1.msh.xz", 1585, 0, 0, 0, 6414)        \
  X("malformed/trimesh_comments_valid.off", 8, 0, 0, 6, 0)                  \
  X("points/cgal_cube8.xyz", 8, 0, 0, 0, 0)                                 \
  X("points/cgal_kitten.xyz.xz", 5210, 0, 0, 0, 0)                          \
  X("points/cgal_norway_coast_endpoints.xy.xz", 81156, 0, 0, 0, 0)          \
  X("points/cgal_radar.xyz.xz", 20950, 0, 0, 0, 0)                          \
  X("points/d3_issue891_duplicates.xy", 42, 0, 0, 0, 0)                     \
  X("points/delaunator_issue13.xy", 17, 0, 0, 0, 0)                         \
  X("points/delaunator_issue43.xy", 5, 0, 0, 0, 0)                          \
  X("points/delaunator_robustness1.xy", 79, 0, 0, 0, 0)                     \
  X("points/delaunator_robustness2.xy", 1000, 0, 0, 0, 0)                   \
  X("points/delaunator_ukraine.xy", 874, 0, 0, 0, 0)                        \
  X("points/geonames_cities1000_lonlat.xy.xz", 144563, 0, 0, 0, 0)          \
  X("points/gmt_ship_15.xyz.xz", 82651, 0, 0, 0, 0)                         \
  X("points/pdal_autzen_trim_lidar.xyz.xz", 110000, 0, 0, 0, 0)             \
  X("points/tsplib_d18512.xy.xz", 18512, 0, 0, 0, 0)                        \
  X("points/tsplib_pla33810.xy.xz", 33810, 0, 0, 0, 0)                      \
  X("points/tsplib_u2319.xy", 2319, 0, 0, 0, 0)

/* Puts the file under its own name, unpacked where it is compressed, and returns the path. */
static const char *unpacked(const char *folder, const char *data, const char *file)
{
  static char path[512];
  char command[1200], block[65536];
  const char *name = strrchr(file, '/') + 1;
  size_t n = strlen(name), packed = n > 3 && !strcmp(name + n - 3, ".xz");
  if (!packed) {
    snprintf(path, sizeof path, "%s/%s", data, file);
    return path;
  }
  snprintf(path, sizeof path, "%s/%.*s", folder, (int)(n - 3), name);
  snprintf(command, sizeof command, "xz -dc '%s/%s'", data, file);
  FILE *in = popen(command, "r"), *out = fopen(path, "wb");
  ck_assert(in && out);
  for (size_t got; (got = fread(block, 1, sizeof block, in)) > 0;)
    ck_assert_uint_eq(fwrite(block, 1, got, out), got);
  ck_assert_int_eq(fclose(out), 0);
  ck_assert_int_eq(pclose(in), 0);
  return path;
}

START_TEST(real_files_have_the_counts_of_their_census)
{
  static const struct {
    const char *file;
    size_t n[5];
  } files[] = {
#define ROW(file, p, v, e, f, r) {file, {p, v, e, f, r}},
      MESH_LIST(ROW)
#undef ROW
  };
  const char *data = data_folder("real mesh files");
  if (!data)
    return;
  const char *folder = fresh_folder();
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    held *h = held_new(2);
    size_t count[4];
    const char *path = unpacked(folder, data, files[i].file);
    ck_assert_msg(gmds_read_soup(path, 0, &h->error, &h->soup) == GMDS_OK, "%s", h->error.text);
    gmds_soup_count(&h->soup, count);
    ck_assert_msg(h->soup.n_points == files[i].n[0], "%s: %zu points", files[i].file, h->soup.n_points);
    for (int d = 0; d < 4; d++)
      ck_assert_msg(count[d] == files[i].n[d + 1], "%s: %zu cells of dimension %d", files[i].file, count[d], d);
    ck_assert_uint_eq(h->soup.degenerate, 0);
    if (strncmp(path, data, strlen(data)))
      unlink(path);
    held_free(h);
  }
  rmdir(folder);
}
END_TEST

/* X(file name, encoding, version) */
#define FORMAT_LIST(X)    \
  X("b.vtk", TEXT, 30)    \
  X("b.vtk", BINARY, 30)  \
  X("b.vtk", TEXT, 51)    \
  X("b.vtk", BINARY, 51)  \
  X("b.vtu", TEXT, 0)     \
  X("b.vtu", BINARY, 0)   \
  X("b.mesh", USUAL, 0)   \
  X("b.meshb", BINARY, 0) \
  X("b.msh", TEXT, 41)    \
  X("b.msh", BINARY, 41)  \
  X("b.msh", TEXT, 22)    \
  X("b.msh", BINARY, 22)

/* Medit lists cells by type: those of each are the same in their order, with their reference numbers. */
static void assert_same_by_type(const gmds_soup *a, const gmds_soup *b)
{
  static const gmds_cell_type order[] = {GMDS_SEGMENT, GMDS_TRIANGLE, GMDS_QUADRILATERAL, GMDS_TETRAHEDRON,
                                         GMDS_PYRAMID, GMDS_PRISM,    GMDS_HEXAHEDRON};
  const gmds_attribute *x = gmds_soup_find_attribute(a, GMDS_OF_CELLS, "ref");
  const gmds_attribute *y = gmds_soup_find_attribute(b, GMDS_OF_CELLS, "ref");
  size_t d = 0, same = 1;
  for (size_t t = 0; t < sizeof order / sizeof *order; t++)
    for (size_t c = 0; c < a->n_cells; c++) {
      if (a->types[c] != order[t])
        continue;
      size_t n = a->begin[c + 1] - a->begin[c];
      same &= b->types[d] == order[t] && b->begin[d + 1] - b->begin[d] == n &&
              memcmp(a->corners + a->begin[c], b->corners + b->begin[d], n * sizeof(gmds_id)) == 0 &&
              (x ? attribute_value(x, c) : 0) == (y ? attribute_value(y, d) : 0);
      d++;
    }
  ck_assert(same);
  ck_assert_uint_eq(d, b->n_cells);
}

/* Writes the soup and reads it back. */
static void go_through(const char *path, const gmds_soup *soup, const gmds_write_options *options)
{
  held *h = held_new(2);
  gmds_format format;
  size_t count[2][4];
  ck_assert_int_eq(gmds_format_of_path(path, NULL, &format), GMDS_OK);
  int is_medit = format == GMDS_FORMAT_MEDIT || format == GMDS_FORMAT_MESHB;
  gmds_status status = gmds_write_soup_as(path, soup, options, &h->error);
  if (status == GMDS_ERR_UNSUPPORTED &&
      (is_medit ? strstr(h->error.text, "vertex") : strstr(h->error.text, "4.1 has one"))) {
    held_free(h);
    return;
  }
  ck_assert_msg(status == GMDS_OK, "%s", h->error.text);
  if (GMDS_HAVE_EXPAT || format != GMDS_FORMAT_VTU) {
    ck_assert_msg(gmds_read_soup(path, soup->dim, &h->error, &h->soup) == GMDS_OK, "%s", h->error.text);
    gmds_soup_count(soup, count[0]);
    gmds_soup_count(&h->soup, count[1]);
    ck_assert_mem_eq(count[0], count[1], sizeof count[0]);
    ck_assert_uint_eq(soup->n_cells, h->soup.n_cells);
    if (is_medit) {
      assert_same_by_type(soup, &h->soup);
    } else {
      assert_same_soup(soup, &h->soup);
      assert_same_attributes(format, soup, &h->soup);
    }
    ck_assert_mem_eq(soup->points, h->soup.points, soup->n_points * (size_t)soup->dim * sizeof *soup->points);
  }
  unlink(path);
  held_free(h);
}

START_TEST(real_volumes_go_through_every_format)
{
  static const char *const files[] = {
#define ROW(file, ...) file,
      MESH_LIST(ROW)
#undef ROW
  };
  static const struct {
    const char *name;
    gmds_write_options options;
  } formats[] = {
#define ROW(name, encoding, version) {name, {GMDS_ENCODING_##encoding, version}},
      FORMAT_LIST(ROW)
#undef ROW
  };
  const char *data = data_folder("real volumes through every format");
  if (!data)
    return;
  const char *folder = fresh_folder();
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    if (strncmp(files[i], "volumes/", 8) != 0)
      continue;
    held *h = held_new(2);
    const char *path = unpacked(folder, data, files[i]);
    ck_assert_msg(gmds_read_soup(path, 0, &h->error, &h->soup) == GMDS_OK, "%s", h->error.text);
    if (strncmp(path, data, strlen(data)))
      unlink(path);
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++)
      go_through(path_in(folder, formats[k].name), &h->soup, &formats[k].options);
    held_free(h);
  }
  rmdir(folder);
}
END_TEST

START_TEST(malformed_files_and_those_of_other_programs_are_refused)
{
  static const char *const files[] = {"malformed/assimp_ant-half_truncated.ply",
                                      "malformed/assimp_empty.off",
                                      "malformed/assimp_invalid.off",
                                      "malformed/assimp_malformed.obj",
                                      "malformed/openscad_unparseable.stl",
                                      "malformed/tinyobj_test-nan.obj",
                                      "malformed/tinyobj_issue-140-zero-face-idx.obj",
                                      "volumes/mfem_fichera-mixed.mesh"};
  const char *data = data_folder("malformed files");
  if (!data)
    return;
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    held *h = held_new(2);
    char path[512];
    snprintf(path, sizeof path, "%s/%s", data, files[i]);
    ck_assert_int_ne(gmds_read_soup(path, 0, &h->error, &h->soup), GMDS_OK);
    ck_assert_msg(strstr(h->error.text, strrchr(files[i], '/')) != NULL, "%s", h->error.text);
    ck_assert(!strstr(files[i], "mfem") || strstr(h->error.text, "MFEM"));
    ck_assert_uint_eq(h->memory.live, 0);
    held_free(h);
  }
}
END_TEST

/* The same bytes under every extension: refused or read, never more. */
START_TEST(a_file_under_a_wrong_extension_does_no_harm)
{
  static const char *const files[] = {"malformed/assimp_malformed.obj",          "malformed/openscad_unparseable.stl",
                                      "malformed/assimp_ant-half_truncated.ply", "points/CDT_kidney.txt",
                                      "volumes/gmds_several_types.vtk",          "surfaces/cgal_3torus.off"};
  const char *data = data_folder("files under wrong extensions");
  if (!data)
    return;
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    char path[512], *bytes = malloc(1 << 20);
    ck_assert_ptr_nonnull(bytes);
    snprintf(path, sizeof path, "%s/%s", data, files[i]);
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    size_t n = fread(bytes, 1, 1 << 20, file);
    fclose(file);
    for (int format = 0; format < GMDS_FORMAT_COUNT; format++) {
      held *h = held_new(2);
      if (read_bytes(h, (gmds_format)format, bytes, n, 2) != GMDS_OK)
        ck_assert_uint_eq(h->memory.live, 0);
      held_free(h);
    }
    free(bytes);
  }
}
END_TEST

RUN_SUITE("data files", real_files_have_the_counts_of_their_census, real_volumes_go_through_every_format,
          malformed_files_and_those_of_other_programs_are_refused, a_file_under_a_wrong_extension_does_no_harm)
