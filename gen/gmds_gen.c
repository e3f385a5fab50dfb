/* The generator of model-specialised builds: gmds_gen FOLDER
 *
 * Writes one small file per model of the census of the plane that computes what Delaunay triangulation asks for (2 -> 0
 * and 2 -> 2), and one per model of volumes that the command holds:
 * a block of defines, the includes, and the shell that gives the command its entry points (entry.h); and registry.h and
 * files.txt, the list of all, which the command and CMake read. The models come from the composition tables, never from
 * a list. */
#include <gmds/census.h>
#include <gmds/named.h>
#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* The prefix of a model: its mask in lower case, with _ for |. */
static void prefix_of(const char *mask, char prefix[128])
{
  size_t k = 0;
  for (; mask[k] && k < 127; k++)
    prefix[k] = mask[k] == '|' ? '_' : (char)tolower((unsigned char)mask[k]);
  prefix[k] = 0;
}

/* Writes a file unless it holds just that already, so that what is up to date is not built again. */
static int write_file(const char *folder, const char *name, const char *text)
{
  static char old[1 << 16];
  char path[4096];
  if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
    return 0;
  FILE *file = fopen(path, "r");
  if (file) {
    size_t n = fread(old, 1, sizeof old - 1, file);
    old[n] = 0;
    fclose(file);
    if (strcmp(old, text) == 0)
      return 1;
  }
  file = fopen(path, "w");
  return file && fputs(text, file) >= 0 && fclose(file) == 0;
}

/* A model of volumes. */
static int write_volume(const char *folder, const char *mask, const char *prefix)
{
  char name[160], text[1024];
  snprintf(name, sizeof name, "%s.c", prefix);
  snprintf(text, sizeof text,
           "/* Written by gmds_gen: one mesh model of volumes and what the command runs on it. */\n"
           "#define GMDS_PREFIX %s\n"
           "#define GMDS_MODEL (%s)\n"
           "#define GMDS_REGIONS TETRAHEDRON\n"
           "#include <gmds/mesh.h>\n"
           "#include <gmds/algorithms/delaunay.h>\n"
           "#include \"volume_entry.h\"\n"
           "#include <gmds/end.h>\n",
           prefix, mask);
  return write_file(folder, name, text);
}

static int write_model(const char *folder, const char *mask, const char *prefix)
{
  char name[160], text[1024];
  snprintf(name, sizeof name, "%s.c", prefix);
  snprintf(text, sizeof text,
           "/* Written by gmds_gen: one mesh model and what the command runs on it. */\n"
           "#define GMDS_PREFIX %s\n"
           "#define GMDS_MODEL (%s)\n"
           "#define GMDS_FACES TRIANGLE\n"
           "#include <gmds/mesh.h>\n"
           "#include <gmds/algorithms/delaunay.h>\n"
           "#include \"cells_entry.h\"\n"
           "#include \"entry.h\"\n"
           "#include <gmds/end.h>\n",
           prefix, mask);
  return write_file(folder, name, text);
}

/* A text that grows by lines; what does not fit marks it. */
typedef struct growing {
  char text[1 << 15];
  size_t used;
} growing;

static void add(growing *g, const char *format, const char *a, const char *b)
{
  int n = snprintf(g->text + g->used, sizeof g->text - g->used, format, a, b);
  g->used = n < 0 || g->used + (size_t)n >= sizeof g->text ? sizeof g->text : g->used + (size_t)n;
}

/* The models of volumes that the command holds: those that take every path, the named ones, the one for Delaunay
 * triangulations (N|R|R2N|R2R), and what is between it and R1. */
enum { MOST_VOLUMES = GMDS_PATH_MODELS + 16 };

static size_t list_volumes(unsigned masks[MOST_VOLUMES])
{
#define MASK(name, mask, why) mask,
  static const char *const others[] = {GMDS_NAMED_LIST(MASK) "N|R|R2N|R2R", "N|R|R2N", "N|R|N2R|R2N|R2R"};
#undef MASK
  size_t n = GMDS_PATH_MODELS;
  gmds_census_paths(masks);
  for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
    unsigned mask = 0;
    int known = gmds_mask_parse(others[k], NULL, &mask) != GMDS_OK;
    for (size_t q = 0; q < n; q++)
      known |= masks[q] == mask;
    if (!known)
      masks[n++] = mask;
  }
  return n;
}

int main(int argc, char **argv)
{
  static growing registry, list;
  if (argc != 2) {
    fprintf(stderr, "usage: gmds_gen FOLDER\n");
    return 2;
  }
  int ok = 1;
  add(&registry, "/* Written by gmds_gen: the models of the command. X(prefix, mask as text) */\n%s(X)%s",
      "#define GMDS_REGISTRY", "");
  for (size_t k = 0; k < gmds_census_size(2); k++) {
    unsigned mask = gmds_census_mask(2, k);
    char text[128], prefix[128];
    if (!gmds_census_of(mask, 2).computable)
      continue;
    gmds_mask_text(mask, sizeof text, text);
    prefix_of(text, prefix);
    ok = ok && write_model(argv[1], text, prefix);
    add(&registry, " \\\n  X(%s, \"%s\")", prefix, text);
    add(&list, "%s%s\n", prefix, ".c");
  }
  unsigned volumes[MOST_VOLUMES];
  const size_t n_volumes = list_volumes(volumes);
  for (size_t k = 0; k < n_volumes; k++) {
    char text[128], prefix[128];
    gmds_mask_text(volumes[k], sizeof text, text);
    prefix_of(text, prefix);
    ok = ok && write_volume(argv[1], text, prefix);
    add(&registry, " \\\n  X(%s, \"%s\")", prefix, text);
    add(&list, "%s%s\n", prefix, ".c");
  }
  add(&registry, "%s%s", "\n", "");
  ok = ok && registry.used < sizeof registry.text && list.used < sizeof list.text &&
       write_file(argv[1], "registry.h", registry.text) && write_file(argv[1], "files.txt", list.text);
  if (!ok)
    fprintf(stderr, "gmds_gen: cannot write in %s\n", argv[1]);
  return !ok;
}
