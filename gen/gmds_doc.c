/* The pages of docs/ that are computed, never typed: gmds_doc composition | models | volumes
 * Prints the composition tables, or what every two-dimensional model answers and on which faces, or the named models of
 * volumes and those that take every path, as Markdown. */
#include <gmds/census.h>
#include <gmds/named.h>
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

static void print_mask(unsigned mask)
{
  char text[128];
  gmds_mask_text(mask, sizeof text, text);
  for (const char *t = text; *t; t++)
    printf(*t == '|' ? "\\|" : "%c", *t);
}

static void print_answers(unsigned mask)
{
  static const char *const all[] = {"D", "L", "G", "M", "–"}, *const tetrahedra[] = {"D*", "L*", "G*", "M*", "–"};
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {
      const gmds_path p = gmds_path_of(mask, i, j);
      const int kept = (mask & GMDS_CELL_BIT(i)) && (mask & GMDS_CELL_BIT(j));
      printf(" | %s", !kept                                               ? ""
                      : p.cost == GMDS_COST_NONE || p.exact_regions == 31 ? all[p.cost]
                                                                          : tetrahedra[p.cost]);
    }
  printf(" |\n");
}

static void print_volumes(void)
{
  static const char head[] =
      " | 0→0 | 0→1 | 0→2 | 0→3 | 1→0 | 1→1 | 1→2 | 1→3 | 2→0 | 2→1 | 2→2 | 2→3 | 3→0 | 3→1 | 3→2 | 3→3 "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  unsigned masks[GMDS_PATH_MODELS], mask = 0;
  size_t count[3] = {0};
  for (size_t k = 0; k < gmds_census_size(3); k++) {
    const gmds_census c = gmds_census_of(gmds_census_mask(3, k), 3);
    count[0] += (size_t)c.computable;
    count[1] += (size_t)c.identified;
    count[2] += (size_t)c.complete;
  }
  printf(
      "# Models of volumes\n\nComputed by `gmds_doc volumes`. Of the %zu sets of the thirteen relations that the "
      "census "
      "counts (N2N, E2E and F2F may be stored beside them) %zu compute 3→0 and 3→3, %zu also tell every kept cell by "
      "its "
      "nodes, and %zu are complete. `gmds models --dim 3 --csv` prints them all.\n\n"
      "D: stored. L: composed of stored relations, in time that does not grow with the mesh. G: one traversal of the "
      "mesh. M: a series with at least one traversal. –: cannot be answered (does not compile). An asterisk: beyond "
      "tetrahedra the stored relations do not decide it, so it exists only with `#define GMDS_REGIONS TETRAHEDRON`; "
      "without an asterisk the answer is exact on every region. Blank: one of the two is not kept.\n\n"
      "## Named models\n\nThe full and reduced representations of Garimella (2002); each has a header, "
      "`<gmds/named/f1.h>` and so on.\n\n| | relations | when to choose it |\n|---|---|---|\n",
      gmds_census_size(3), count[0], count[1], count[2]);
#define REASON(name, text, why)             \
  (void)gmds_mask_parse(text, NULL, &mask); \
  printf("| %s | ", #name);                 \
  print_mask(mask);                         \
  printf(" | %s |\n", why);
  GMDS_NAMED_LIST(REASON)
#undef REASON
  printf("\n|%s", head);
#define ANSWERS(name, text, why)            \
  (void)gmds_mask_parse(text, NULL, &mask); \
  printf("| %s", #name);                    \
  print_answers(mask);
  GMDS_NAMED_LIST(ANSWERS)
#undef ANSWERS
  printf(
      "\n## The models that take every path\n\nChosen by the census (`gmds_census_paths`): between them they take each "
      "path that any model which tells its cells takes. `gmds sweep --dim 3 --models paths` runs them.\n\n| model%s",
      head);
  gmds_census_paths(masks);
  for (size_t k = 0; k < GMDS_PATH_MODELS; k++) {
    printf("| ");
    print_mask(masks[k]);
    print_answers(masks[k]);
  }
}

int main(int argc, char **argv)
{
  if (argc == 2 && strcmp(argv[1], "composition") == 0)
    print_composition();
  else if (argc == 2 && strcmp(argv[1], "models") == 0)
    print_models();
  else if (argc == 2 && strcmp(argv[1], "volumes") == 0)
    print_volumes();
  else {
    fprintf(stderr, "usage: gmds_doc composition | models | volumes\n");
    return 2;
  }
  return ferror(stdout) != 0;
}
