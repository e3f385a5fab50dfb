/* gmds models: the census, computed. */
#include "command.h"
#include <gmds/map.h>
#include <string.h>

static const char letter[] = "NEFR";

static void census_header(int dim, const char *between)
{
  printf("model%scomputable%sidentified%spaper105%sfull%scomplete", between, between, between, between, between);
  for (int i = 0; i <= dim; i++)
    for (int j = 0; j <= dim; j++)
      printf("%scost_%d_%d", between, i, j);
  printf("\n");
}

static void census_row(unsigned mask, int dim, int csv)
{
  char text[128];
  const gmds_census c = gmds_census_of(mask, dim);
  const int flags[5] = {c.computable, c.identified, c.paper105, c.full, c.complete};
  static const int widths[5] = {10, 10, 8, 4, 8};
  gmds_mask_text(mask, sizeof text, text);
  printf(csv ? "%s" : "%-46s", text);
  for (int k = 0; k < 5; k++)
    if (csv)
      printf(",%d", flags[k]);
    else
      printf(" %*d", widths[k], flags[k]);
  for (int i = 0; i <= dim; i++)
    for (int j = 0; j <= dim; j++)
      printf(csv ? ",%s" : " %-8s", gmds_cost_text(gmds_path_of(mask, i, j).cost));
  printf("\n");
}

static int print_census(int dim, int csv)
{
  size_t n = gmds_census_size(dim), count[5] = {0};
  if (csv)
    census_header(dim, ",");
  else {
    printf("%-46s computable identified paper105 full complete", "model");
    for (int i = 0; i <= dim; i++)
      for (int j = 0; j <= dim; j++)
        printf(" cost_%d_%d", i, j);
    printf("\n");
  }
  for (size_t k = 0; k < n; k++) {
    const gmds_census c = gmds_census_of(gmds_census_mask(dim, k), dim);
    const int flags[5] = {c.computable, c.identified, c.paper105, c.full, c.complete};
    for (int f = 0; f < 5; f++)
      count[f] += (size_t)flags[f];
    census_row(c.mask, dim, csv);
  }
  if (!csv)
    printf("%zu masks: %zu computable, %zu identified, %zu of the paper's, %zu full, %zu complete\n", n, count[0],
           count[1], count[2], count[3], count[4]);
  return DONE;
}

/* The path as the paper writes it, with the relation behind each hop:
 * "0 -> 1 -> 2: N2E, traversal of F2E; keep 1, 1". */
static void print_path(unsigned mask, int i, int j)
{
  const gmds_path p = gmds_path_of(mask, i, j);
  printf("  %d -> %d  %-7s", i, j, gmds_cost_text(p.cost));
  if (!p.hops) {
    char advice[256];
    gmds_path_advice(i, j, sizeof advice, advice);
    printf("%s\n", advice);
    return;
  }
  for (int s = 0; s < p.hops; s++) {
    int a = p.cells[s], b = p.cells[s + 1];
    if (p.inverse >> s & 1)
      printf("%straversal of %c2%c", s ? ", " : "", letter[b], letter[a]);
    else
      printf("%s%c2%c", s ? ", " : "", letter[a], letter[b]);
    if (p.keep[s] > 1)
      printf(" (keep %d)", p.keep[s]);
  }
  if (i == j && p.cost != GMDS_COST_DIRECT)
    printf(", less the cell itself");
  if (p.table)
    printf("; Table %d", p.table);
  if (mask & GMDS_R) {
    if (p.exact_regions == 1)
      printf("; decided on tetrahedra only");
  } else if (p.exact == 1)
    printf("; decided on triangles only");
  printf("\n");
}

static void print_matrix(const char *name, char matrix[4][4])
{
  printf("%s\n", name);
  for (int i = 0; i < 4; i++)
    printf("  %c %c %c %c\n", matrix[i][0], matrix[i][1], matrix[i][2], matrix[i][3]);
}

static int print_model(unsigned mask, int dim)
{
  char text[128], direct[4][4], indirect[4][4];
  const gmds_census c = gmds_census_of(mask, dim);
  gmds_mask_text(mask, sizeof text, text);
  gmds_matrices(mask, direct, indirect);
  printf("model %s\n%s, %s, %s, %s%s\n", text, c.computable ? "computable" : "not computable",
         c.identified ? "identified" : "not identified", c.full ? "full" : "reduced",
         c.complete ? "complete" : "incomplete", c.paper105 ? ", one of the paper's 105" : "");
  print_matrix("direct matrix", direct);
  print_matrix("indirect matrix", indirect);
  printf("paths\n");
  for (int i = 0; i <= dim; i++)
    for (int j = 0; j <= dim; j++)
      if (mask & GMDS_CELL_BIT(i) && mask & GMDS_CELL_BIT(j))
        print_path(mask, i, j);
  return DONE;
}

/* What a combinatorial map takes and answers. */
static int print_maps(void)
{
  printf("cmap: combinatorial maps; queries between cells that are kept are orbits, all local\n");
  for (int n = 2; n <= GMDS_MAP_MOST; n++) {
    gmds_map map;
    gmds_map_init(&map, n, 3, 1, NULL);
    printf("  %d-map that keeps nodes: %zu bytes a dart, and %zu for each kind of cell kept beside them\n", n,
           (size_t)map.stride * sizeof(gmds_id), sizeof(gmds_id));
    gmds_map_clear(&map);
  }
  return DONE;
}

static int run(const verb *v, int argc, char **argv)
{
  const char *text = NULL, *dim_text = NULL;
  int csv = 0;
  const option options[] = {
      {"dim", 0, &dim_text, NULL, "2|3  dimension of the census (default 2; 3 for a mask with R)"},
      {"csv", 0, NULL, &csv, "print the census as CSV"}};
  int code = read_arguments(v, argc, argv, options, 2, &text, 0, 1);
  if (code >= 0)
    return code;
  unsigned long dim = 2;
  if (dim_text && !read_number(dim_text, 2, 3, &dim))
    return misused(v, "--dim is 2 or 3, not '%s'", dim_text);
  if (!text)
    return print_census((int)dim, csv);
  if (strcmp(text, "cmap") == 0)
    return print_maps();
  gmds_error error = {.status = GMDS_OK};
  unsigned mask = 0;
  if (read_mask(text, dim_text ? (int)dim : 3, &error, &mask) != GMDS_OK)
    return failed("%s", error.text);
  if (mask & GMDS_R) {
    if (dim_text && dim == 2)
      return failed("model '%s' keeps volumes: use --dim 3", text);
    dim = 3;
  }
  if (csv) {
    census_header((int)dim, ",");
    census_row(mask, (int)dim, 1);
    return DONE;
  }
  return print_model(mask, (int)dim);
}

const verb verb_models = {
    "models", "[MASK|NAME] [--dim 2|3] [--csv]",
    "what each mesh model can answer, and at what cost; for one mask, cmap, or one of the names F1 to F6 "
    "and R1 to R4 of models of volumes, its matrices and paths",
    run};
