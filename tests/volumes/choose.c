/* Chooses the models that the tests of volumes compile, from the census: choose FOLDER, or choose FOLDER all for every
 * mask that identifies its cells. Writes files of a few models each, a list of all, and files.txt.
 *
 * The 64 models that take every path between them, in several flavours; more at random from a seed; and models with
 * what the census leaves out (N2N, E2E, F2F, R2R beside all others). */
#include <gmds/census.h>
#include <stdio.h>
#include <string.h>

enum { A_FILE = 8 };

static const char *folder;
static FILE *list, *names, *current;
static int in_file, n_files, n_models;

static FILE *open_file(const char *name)
{
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return fopen(path, "w");
}

static void close_current(void)
{
  if (current)
    fclose(current);
  current = NULL;
  in_file = 0;
}

static void write_model(unsigned mask, const char *regions)
{
  char text[256], name[64];
  gmds_mask_text(mask, sizeof text, text);
  if (!current) {
    snprintf(name, sizeof name, "volumes%d.c", n_files++);
    current = open_file(name);
    fprintf(names, "%s\n", name);
    fprintf(current, "#include \"volumes/volume.h\"\n");
  }
  fprintf(current,
          "#define GMDS_PREFIX v%d\n#define GMDS_MODEL (%s)\n#define GMDS_REGIONS (%s)\n#include <gmds/mesh.h>\n"
          "#include \"volumes/table.h\"\n#include <gmds/end.h>\n",
          n_models, text, regions);
  fprintf(list, "X(v%d_table)\n", n_models);
  n_models++;
  if (++in_file == A_FILE)
    close_current();
}

#define STANDARD "TETRAHEDRON|PYRAMID|PRISM|HEXAHEDRON"

static int holds_polyhedra(unsigned mask)
{
  const unsigned needed = GMDS_RELATION_BIT(3, 2) | GMDS_RELATION_BIT(2, 0);
  return (mask & needed) == needed;
}

static void write_flavours(unsigned mask, int turn)
{
  write_model(mask, "TETRAHEDRON");
  write_model(mask, STANDARD);
  if (turn % 3 == 0)
    write_model(mask, "HEXAHEDRON");
  else if (turn % 3 == 1)
    write_model(mask, turn % 2 ? "PRISM" : "PYRAMID");
  if (holds_polyhedra(mask))
    write_model(mask, STANDARD "|POLYHEDRON");
}

static unsigned next_random(unsigned *state)
{
  *state = *state * 1664525u + 1013904223u;
  return *state >> 8;
}

int main(int argc, char **argv)
{
  unsigned paths[GMDS_PATH_MODELS], seed = 20261122;
  if (argc < 2)
    return 2;
  folder = argv[1];
  list = open_file("list.h");
  names = open_file("files.txt");
  gmds_census_paths(paths);
  if (argc > 2)
    for (size_t k = 0; k < gmds_census_size(3); k++) {
      unsigned mask = gmds_census_mask(3, k);
      if (gmds_census_of(mask, 3).identified)
        write_model(mask, n_models % 2 ? STANDARD : "TETRAHEDRON");
    }
  for (int k = 0; k < GMDS_PATH_MODELS && argc == 2; k++)
    write_flavours(paths[k], k);
  for (int k = 0; k < 64 && argc == 2;) {
    unsigned mask = gmds_census_mask(3, next_random(&seed) % gmds_census_size(3));
    if (!gmds_census_of(mask, 3).identified)
      continue;
    if (k % 2 == 0) { /* with what the census leaves out */
      const unsigned more = next_random(&seed);
      mask |= more & 1 ? GMDS_RELATION_BIT(0, 0) : 0;
      if (mask & (GMDS_RELATION_BIT(0, 1) | GMDS_RELATION_BIT(1, 0)))
        mask |= more & 2 || !(more & 1) ? GMDS_RELATION_BIT(1, 1) : 0;
      if (mask & GMDS_F)
        mask |= more & 4 ? GMDS_RELATION_BIT(2, 2) : 0;
    }
    write_model(mask, k % 4 < 2 ? STANDARD : "TETRAHEDRON");
    k++;
  }
  if (argc == 2) {
    const unsigned r2 = GMDS_N | GMDS_R | GMDS_RELATION_BIT(0, 0) | GMDS_RELATION_BIT(0, 3) | GMDS_RELATION_BIT(3, 0) |
                        GMDS_RELATION_BIT(3, 3),
                   all = 0xfffff;
    write_flavours(r2, 0);
    write_flavours(all, 0);
    write_flavours(all & ~(unsigned)GMDS_RELATION_BIT(2, 0), 1);
  }
  close_current();
  fclose(list);
  fclose(names);
  return 0;
}
