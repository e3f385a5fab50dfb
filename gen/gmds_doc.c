/* The pages of docs/ that are computed, never typed: gmds_doc composition | models
 * Prints the composition tables, or what every two-dimensional model answers and on which faces, as Markdown. */
#include <gmds/census.h>
#include <gmds/models/tables.h>
#include <stdio.h>
#include <string.h>

static void row_1(int i, int j)
{
  printf("| %d → %d | %d → %d | stored, or the inverse by one traversal | |\n", i, j, i, j);
}

static void row(int table, const int *cells, int hops, const int *keep)
{
  printf("| %d → %d | ", cells[0], cells[hops]);
  for (int s = 0; s <= hops; s++)
    printf("%s%d", s ? " → " : "", cells[s]);
  printf(" | ");
  for (int s = hops - 1; s >= 1; s--)
    printf("Keep<sub>%d</sub> ∘ Adj<sub>%d</sub> ∘ ", keep[s], cells[s + 1]);
  printf("Adj<sub>%d</sub>(x)%s | ", cells[1], cells[0] == cells[hops] ? " − {x}" : "");
  if (table)
    printf("Table %d ", table);
  printf("|\n");
}

static void print_composition(void)
{
  printf(
      "# Composition tables\n\nComputed by `gmds_doc composition` from `models/tables.h`, the one list from which the "
      "preprocessor chooses the path of each query, the census counts, and the tests compare. Source: de Bellabre, "
      "Ledoux, Weill 2012, Tables 1 to 3; rows without a table are the relation itself and the two diagonal queries "
      "that its matrices use.\n\n"
      "A hop a → b follows a2b where it is stored, else it is a traversal of b2a. Among the rows of a pair the one "
      "with the fewest traversals is taken, then the first; the relation's own inverse comes before other rows with "
      "one traversal. Keep<sub>n</sub> keeps what occurs at least n times.\n\n"
      "| query | path | term | source |\n|---|---|---|---|\n");
#define P1(id, i, j) row_1(i, j);
#define P2(id, t, i, k, j, n) row(t, (const int[]){i, k, j}, 2, (const int[]){1, n});
#define P3(id, t, i, k, l, j, o, n) row(t, (const int[]){i, k, l, j}, 3, (const int[]){1, o, n});
#define P4(id, t, i, k, l, m, j, o, p, n) row(t, (const int[]){i, k, l, m, j}, 4, (const int[]){1, o, p, n});
#define PAIR(i, j, PATHS) PATHS(P1, P2, P3, P4)
  GMDS_PAIR_LIST(PAIR)
}

static const char *mark(unsigned mask, int i, int j)
{
  const gmds_path p = gmds_path_of(mask, i, j);
  static const char *const exact[] = {"D", "L", "G", "M", "–"}, *const triangles[] = {"D*", "L*", "G*", "M*", "–"};
  return p.cost == GMDS_COST_NONE || p.exact == 7 ? exact[p.cost] : triangles[p.cost];
}

static void print_models(void)
{
  size_t count[4] = {0};
  printf(
      "# What each model answers\n\nComputed by `gmds_doc models`, one row for each of the 128 sets of the seven "
      "relations; `gmds models --dim 2 --csv` prints the same.\n\n"
      "D: stored. L: composed of stored relations, in time that does not grow with the mesh. G: one traversal of the "
      "mesh. M: a series with at least one traversal. –: cannot be answered (does not compile). An asterisk: on faces "
      "that are no triangles the stored relations do not decide it, so it exists only with "
      "`#define GMDS_FACES TRIANGLE` (a quadrilateral whose diagonal is an edge elsewhere cannot be told from its "
      "sides); without an asterisk the answer is exact on every face.\n\n"
      "| model | 0→0 | 0→1 | 0→2 | 1→0 | 1→1 | 1→2 | 2→0 | 2→1 | 2→2 | Delaunay | paper |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (size_t k = 0; k < gmds_census_size(2); k++) {
    char text[128];
    const gmds_census c = gmds_census_of(gmds_census_mask(2, k), 2);
    gmds_mask_text(c.mask, sizeof text, text);
    printf("| ");
    for (const char *t = text; *t; t++)
      printf(*t == '|' ? "\\|" : "%c", *t);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        printf(" | %s", mark(c.mask, i, j));
    printf(" | %s | %s |\n", c.computable ? "yes" : "", c.paper105 ? "yes" : "");
    count[0] += (size_t)c.computable;
    count[1] += (size_t)c.identified;
    count[2] += (size_t)c.paper105;
    count[3] += (size_t)c.complete;
  }
  printf("\n%zu compute 2→0 and 2→2, which Delaunay triangulation asks for; %zu of them tell edges by their nodes; %zu "
         "are "
         "the paper's; %zu of the 128 are complete.\n",
         count[0], count[1], count[2], count[3]);
}

int main(int argc, char **argv)
{
  if (argc == 2 && strcmp(argv[1], "composition") == 0)
    print_composition();
  else if (argc == 2 && strcmp(argv[1], "models") == 0)
    print_models();
  else {
    fprintf(stderr, "usage: gmds_doc composition | models\n");
    return 2;
  }
  return ferror(stdout) != 0;
}
