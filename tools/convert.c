/* gmds convert, info, check: files of meshes. */
#include "command.h"
#include <string.h>

#define GMDS_PREFIX full
#define GMDS_MODEL (DIM3 | N | E | F | N2E | N2F | E2N | E2F | F2N | F2E)
#include <gmds/mesh.h>
#include <gmds/algorithms/manifold.h>
#include <gmds/algorithms/quality.h>
#include <gmds/end.h>

gmds_status write_any(const char *path, const gmds_soup *soup, gmds_error *error)
{
  return is_svg(path) ? write_picture(path, soup, error) : gmds_write_soup(path, soup, error);
}

/* What --dim says: 2 or 3 coordinates a point, 0 as many as the file has. Returns -1 to go on. */
static int read_dim(const verb *v, const char *text, int *dim)
{
  unsigned long number = 0;
  if (text && !read_number(text, 2, 3, &number))
    return misused(v, "--dim is 2 or 3, not '%s'", text);
  *dim = (int)number;
  return -1;
}

#define DIM_HELP "2|3  coordinates a point (as many as the file has; 2 for .f64, which does not say)"

static const char *place_text(int place)
{
  return place == GMDS_OF_POINTS ? "points" : "cells";
}

/* A name of a file with nothing in it that a terminal would obey. */
static void put_name(FILE *file, const char *name)
{
  for (; *name; name++)
    putc((unsigned char)*name < ' ' || *name == 0x7f ? '?' : *name, file);
}

/* A file, or points made up. */
static gmds_status read_any(const char *input, int dim, gmds_error *error, gmds_soup *soup)
{
  gmds_format format;
  static const char *const made_up[] = {"random:", "grid:", "circle:", "clusters:"};
  for (size_t k = 0; k < sizeof made_up / sizeof *made_up; k++)
    if (strncmp(input, made_up[k], strlen(made_up[k])) == 0)
      return gmds_make_points(input, dim ? dim : 2, error, soup);
  if (!dim && gmds_format_of_path(input, NULL, &format) == GMDS_OK && format == GMDS_FORMAT_F64)
    dim = 2;
  return gmds_read_soup(input, dim, error, soup);
}

/* The version of a format, `2.2`, as ten times that; 0 where there is no text. Returns -1 to go on. */
static int read_version(const verb *v, const char *text, int *version)
{
  *version = 0;
  if (!text)
    return -1;
  if (strlen(text) != 3 || text[0] < '1' || text[0] > '9' || text[1] != '.' || text[2] < '0' || text[2] > '9')
    return misused(v, "--format-version is a number like 4.1, not '%s'", text);
  *version = (text[0] - '0') * 10 + (text[2] - '0');
  return -1;
}

/* Names on stderr what the mesh has and the file has no place for. */
static void note_left_out(const char *path, const gmds_soup *soup)
{
  gmds_format format;
  int n = 0;
  if (soup->unread)
    fprintf(stderr, "gmds: %zu arrays or sections that are no part of a mesh were left out\n", soup->unread);
  if (gmds_format_of_path(path, NULL, &format) != GMDS_OK)
    return;
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next)
      if (!gmds_format_holds(format, soup, (gmds_place)place, a)) {
        fputs(n++ ? ", " : "gmds: attributes left out: ", stderr);
        put_name(stderr, a->name);
        fprintf(stderr, " of %s", place_text(place));
      }
  if (n)
    putc('\n', stderr);
}

static gmds_status write_soup(const char *path, const gmds_soup *soup, const gmds_write_options *options,
                              gmds_error *error)
{
  if (!is_svg(path))
    return gmds_write_soup_as(path, soup, options, error);
  if (options->encoding != GMDS_ENCODING_USUAL || options->version)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "%.200s: a picture has no encodings and versions", path);
  return write_picture(path, soup, error);
}

static int run_convert(const verb *v, int argc, char **argv)
{
  const char *path[2] = {NULL, NULL}, *dim_text = NULL, *version_text = NULL;
  int dim = 0, text = 0, binary = 0;
  gmds_write_options how = {GMDS_ENCODING_USUAL, 0};
  const option options[] = {
      {"dim", 0, &dim_text, NULL, DIM_HELP},
      {"text", 0, NULL, &text, "write numbers as text (what is usual for .vtk and .msh)"},
      {"binary", 0, NULL, &binary, "write them in binary (what is usual for .vtu)"},
      {"format-version", 0, &version_text, NULL, "V  of the format: .vtk 3.0 (usual) or 5.1, .msh 4.1 (usual) or 2.2"}};
  int code = read_arguments(v, argc, argv, options, 4, path, 2, 2);
  if (code < 0)
    code = read_dim(v, dim_text, &dim);
  if (code < 0)
    code = read_version(v, version_text, &how.version);
  if (code < 0 && text && binary)
    code = misused(v, "either --text or --binary");
  if (code >= 0)
    return code;
  how.encoding = text ? GMDS_ENCODING_TEXT : binary ? GMDS_ENCODING_BINARY : GMDS_ENCODING_USUAL;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  gmds_status status = read_any(path[0], dim, &error, &soup);
  if (status == GMDS_OK)
    status = write_soup(path[1], &soup, &how, &error);
  if (status == GMDS_OK && soup.degenerate)
    fprintf(stderr, "gmds: %zu cells with two equal points were left out\n", soup.degenerate);
  if (status == GMDS_OK)
    note_left_out(path[1], &soup);
  gmds_soup_clear(&soup);
  return status == GMDS_OK ? DONE : failed("%s", error.text);
}

/* What info and check are given: a file, --json, --dim. Returns -1 to go on, as read_arguments. */
static int read_file_arguments(const verb *v, int argc, char **argv, const char **path, int *json, int *dim)
{
  const char *text = NULL;
  const option options[] = {{"json", 0, NULL, json, "print one JSON object"}, {"dim", 0, &text, NULL, DIM_HELP}};
  int code = read_arguments(v, argc, argv, options, 2, path, 1, 1);
  return code < 0 ? read_dim(v, text, dim) : code;
}

/* ---- info */

static void bounding_box(const gmds_soup *soup, double low[3], double high[3])
{
  for (int k = 0; k < 3; k++)
    low[k] = high[k] = 0;
  for (size_t v = 0; v < soup->n_points; v++)
    for (int k = 0; k < soup->dim; k++) {
      double x = soup->points[v * (size_t)soup->dim + (size_t)k];
      low[k] = !v || x < low[k] ? x : low[k];
      high[k] = !v || x > high[k] ? x : high[k];
    }
}

static void print_attributes(const gmds_soup *soup, int json)
{
  const char *comma = "";
  for (int place = 0; place < GMDS_PLACE_COUNT; place++)
    for (const gmds_attribute *a = soup->attributes[place]; a; a = a->next) {
      if (!json) {
        printf("  of %-11s ", place_text(place));
        put_name(stdout, a->name);
        printf(": %s", gmds_value_text(a->type));
        printf(a->components > 1 ? " x %zu\n" : "\n", a->components);
        continue;
      }
      printf("%s{\"of\":\"%s\",\"name\":", comma, place_text(place));
      json_text(stdout, a->name);
      printf(",\"type\":\"%s\",\"components\":%zu}", gmds_value_text(a->type), a->components);
      comma = ",";
    }
}

static void print_info(const gmds_soup *soup, const char *path, int json)
{
  size_t count[GMDS_CELL_TYPE_COUNT] = {0};
  double low[3], high[3];
  bounding_box(soup, low, high);
  for (size_t c = 0; c < soup->n_cells; c++)
    count[soup->types[c]]++;
  if (json) {
    printf("{\"file\":");
    json_text(stdout, path);
    printf(",\"dim\":%d,\"points\":%zu,\"degenerate\":%zu,\"cells\":{", soup->dim, soup->n_points, soup->degenerate);
    const char *comma = "";
    for (int t = 0; t < GMDS_CELL_TYPE_COUNT; t++)
      if (count[t]) {
        printf("%s\"%s\":%zu", comma, gmds_cell_type_text((gmds_cell_type)t), count[t]);
        comma = ",";
      }
    printf("},\"low\":[%.17g,%.17g,%.17g],\"high\":[%.17g,%.17g,%.17g],\"attributes\":[", low[0], low[1], low[2],
           high[0], high[1], high[2]);
    print_attributes(soup, json);
    printf("],\"unread\":%zu}\n", soup->unread);
    return;
  }
  printf("%s: %zu points of %d coordinates\n", path, soup->n_points, soup->dim);
  for (int t = 0; t < GMDS_CELL_TYPE_COUNT; t++)
    if (count[t])
      printf("  %-14s %zu\n", gmds_cell_type_text((gmds_cell_type)t), count[t]);
  if (soup->degenerate)
    printf("  left out       %zu (two of their points are the same)\n", soup->degenerate);
  printf("  from %.9g %.9g %.9g to %.9g %.9g %.9g\n", low[0], low[1], low[2], high[0], high[1], high[2]);
  print_attributes(soup, json);
  if (soup->unread)
    printf("  not read       %zu arrays or sections that are no part of a mesh\n", soup->unread);
}

static int run_info(const verb *v, int argc, char **argv)
{
  const char *path = NULL;
  int json = 0, dim = 0;
  int code = read_file_arguments(v, argc, argv, &path, &json, &dim);
  if (code >= 0)
    return code;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory memory;
  gmds_soup soup;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  gmds_status status = read_any(path, dim, &error, &soup);
  if (status == GMDS_OK)
    print_info(&soup, path, json);
  gmds_soup_clear(&soup);
  return status == GMDS_OK ? DONE : failed("%s", error.text);
}

/* ---- check */

typedef struct findings {
  size_t nodes, edges, faces, isolated_nodes;
  gmds_surface_report report;
  gmds_quality measured;
} findings;

static gmds_status look(full_mesh *m, gmds_ids *list, findings *f)
{
  *f = (findings){.nodes = full_count_0(m), .edges = full_count_1(m), .faces = full_count_2(m)};
  for (gmds_id v = full_next_0(m, 0); v != GMDS_NONE; v = full_next_0(m, v + 1)) {
    GMDS_TRY(full_get_adj_0_1(m, v, list));
    f->isolated_nodes += list->n == 0;
  }
  GMDS_TRY(full_manifold(m, &f->report));
  return full_quality(m, NULL, NULL, &f->measured);
}

static void print_findings(const char *path, const findings *f, size_t degenerate, int json)
{
  const gmds_surface_report *r = &f->report;
  long long euler = (long long)f->nodes - (long long)f->isolated_nodes - (long long)f->edges + (long long)f->faces;
  if (json) {
    printf("{\"file\":");
    json_text(stdout, path);
    printf(",\"nodes\":%zu,\"edges\":%zu,\"faces\":%zu,\"euler\":%lld,\"isolated_nodes\":%zu,\"border_edges\":%zu,"
           "\"nonmanifold_edges\":%zu,\"nonmanifold_nodes\":%zu,\"inconsistent_edges\":%zu,\"orientable\":%s,"
           "\"degenerate\":%zu,\"area\":%.17g,\"quality\":{\"min\":%.17g,\"mean\":%.17g,\"max\":%.17g}}\n",
           f->nodes, f->edges, f->faces, euler, f->isolated_nodes, r->border.count, r->crowded.count, r->pinched.count,
           r->turned.count, r->orientable ? "true" : "false", degenerate, f->measured.size, f->measured.min,
           f->measured.mean, f->measured.max);
    return;
  }
  printf("%s: %zu nodes, %zu edges, %zu faces, Euler characteristic %lld of what is used\n"
         "  %zu isolated nodes, %zu border edges, %zu edges with more than two faces,\n"
         "  %zu nodes with more than one fan of faces, %zu edges whose faces are oriented against each other,\n"
         "  %s be oriented, %zu degenerate cells left out\n",
         path, f->nodes, f->edges, f->faces, euler, f->isolated_nodes, r->border.count, r->crowded.count,
         r->pinched.count, r->turned.count, r->orientable ? "can" : "cannot", degenerate);
  print_quality(&f->measured, "area");
  printf("  every relation of N|E|F|N2E|N2F|E2N|E2F|F2N|F2E agrees with the others\n");
}

static gmds_status check_soup(const gmds_soup *soup, full_mesh *m, gmds_error *error, findings *f)
{
  gmds_ids list;
  GMDS_TRY(full_from_soup(m, soup, error));
  GMDS_TRY(full_check(m, &m->memory, error));
  gmds_ids_init(&list, &m->memory);
  gmds_status status = look(m, &list, f);
  gmds_ids_clear(&list);
  return status == GMDS_OK ? status : gmds_fail(error, status, "%s", gmds_status_text(status));
}

static int run_check(const verb *v, int argc, char **argv)
{
  const char *path = NULL;
  int json = 0, dim = 0;
  int code = read_file_arguments(v, argc, argv, &path, &json, &dim);
  if (code >= 0)
    return code;
  gmds_error error = {.status = GMDS_OK};
  gmds_memory memory;
  gmds_soup soup;
  full_mesh m;
  findings f;
  gmds_memory_init(&memory, NULL);
  gmds_soup_init(&soup, &memory, 2);
  full_mesh_init(&m, NULL);
  gmds_status status = read_any(path, dim, &error, &soup);
  size_t count[4] = {0, 0, 0, 0};
  if (status != GMDS_OK)
    code = failed("%s", error.text);
  else {
    gmds_soup_count(&soup, count);
    const int solid = count[3] || soup.degenerate_regions; /* volumes, though none may be left */
    status = solid ? check_volumes(path, &soup, json, &error) : check_soup(&soup, &m, &error, &f);
    if (status != GMDS_OK)
      code = failed("%s: %s", path, error.text);
    else if (!solid)
      print_findings(path, &f, soup.degenerate, json);
  }
  full_mesh_clear(&m);
  gmds_soup_clear(&soup);
  return status == GMDS_OK ? DONE : FAILED;
}

const verb verb_convert = {
    "convert", "IN OUT [--dim 2|3] [--text|--binary] [--format-version V]",
    "a mesh or points from one format to another (.off .obj .ply .stl .vtk .vtu .mesh .meshb .msh .node "
    ".txt .f64; a picture for .svg), with its attributes where the format has a place for them",
    run_convert};
const verb verb_info = {"info", "FILE [--json] [--dim 2|3]",
                        "what a file holds: points, cells by type, bounding box, attributes", run_info};
const verb verb_check = {
    "check", "FILE [--json] [--dim 2|3]",
    "builds the mesh of a file with every relation, verifies them, and reports borders and the like", run_check};
