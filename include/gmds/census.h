/* The census of mesh models: what a mask can answer, along which path, at what cost. Computed from the composition
 * tables (models/tables.h), the same data from which the preprocessor chooses the paths of an opened model. */
#ifndef GMDS_CENSUS_H
#define GMDS_CENSUS_H

#include <gmds/relations.h>
#include <gmds/status.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, word): cost classes of a query, from the cheapest ([models] 2.3.1). DIRECT: stored. LOCAL: composed of stored
 * relations. GLOBAL: one traversal of the mesh. MIXED: a series with at least one traversal. NONE: cannot be
 * answered. */
#define GMDS_COST_LIST(X)       \
  X(GMDS_COST_DIRECT, "direct") \
  X(GMDS_COST_LOCAL, "local")   \
  X(GMDS_COST_GLOBAL, "global") \
  X(GMDS_COST_MIXED, "mixed")   \
  X(GMDS_COST_NONE, "none")

#define GMDS_COST_ENUM_(name, word) name,
typedef enum gmds_cost { GMDS_COST_LIST(GMDS_COST_ENUM_) GMDS_COST_COUNT } gmds_cost;
#undef GMDS_COST_ENUM_

const char *gmds_cost_text(gmds_cost cost); /* never NULL */

/* How j-cells are reached from an i-cell in a model. */
typedef struct gmds_path {
  int code;         /* as the preprocessor's choice: 16 * row + inverse hops; 0 where there is no path */
  int table;        /* 1 to 3: the table of the paper; 0: the relation itself, 0 -> 0 and 1 -> 1 */
  int hops;         /* 0 (no path) to 4 */
  int cells[5];     /* dimensions along the path, hops + 1 of them */
  int keep[4];      /* copies kept after each hop */
  unsigned inverse; /* bit s: hop s is a traversal */
  gmds_cost cost;
  unsigned exact; /* for i, j <= 2: the face types (bits of GMDS_FACE_TYPE_LIST) on which the answer is exact in a
                      model that holds no others, or, with all three bits, in any model; 0 for a query of volumes */
  unsigned
      exact_regions; /* in a model that keeps regions: the region types (bits of GMDS_REGION_TYPE_LIST) on which the
                             answer is exact */
} gmds_path;

/* The path that a mask takes from i to j, 0 <= i, j <= 3. Constant time. */
gmds_path gmds_path_of(unsigned mask, int i, int j);

/* What the census says of one model of dimension 2 or 3. */
typedef struct gmds_census {
  unsigned mask;  /* with the bits of its cells */
  int computable; /* 2 -> 0 and 2 -> 2 (3 -> 0 and 3 -> 3) can be answered */
  int identified; /* every kept cell between nodes and the top can be told by its nodes */
  int paper105;   /* one of the 105 models of [models] 4.2 (dimension 2) */
  int full;       /* every cell up to the dimension is kept */
  int complete;   /* every query between kept cells is direct or local */
} gmds_census;

gmds_census gmds_census_of(unsigned mask, int dim);

/* How many masks the census of dimension 2 or 3 has (128 or 8192), and the k-th: incidences between nodes and cells up
 * to the dimension and the adjacency of the top cells, with the bits of the cells that they mention, of nodes and of
 * top cells. */
size_t gmds_census_size(int dim);
unsigned gmds_census_mask(int dim, size_t k);

/* GMDS_PATH_MODELS masks of dimension 3 that identify their cells and between them take every path (gmds_path.code)
 * that such a mask takes: chosen greedily, the one with the most new paths first; what is left over is filled with
 * those of the fewest relations that are computed without a traversal from volumes to nodes and volumes. */
enum { GMDS_PATH_MODELS = 64 };
void gmds_census_paths(unsigned masks[GMDS_PATH_MODELS]);

/* Reads a mask as the paper and the preprocessor write it: names of cells and relations with | between, blanks allowed;
 * the cells that a relation mentions may be left out of the text and are added. GMDS_OK or GMDS_ERR_ARGUMENT (the
 * sentence names the word that is no cell and no relation). */
gmds_status gmds_mask_parse(const char *text, gmds_error *error, unsigned *mask);

/* Writes a mask as the parser reads it: cells first, relations in the order of GMDS_RELATION_LIST. `text` holds `size`
 * bytes; 128 are always enough. */
void gmds_mask_text(unsigned mask, size_t size, char *text);

/* One sentence about what must be added to a mask so that i -> j can be answered, for instance
 * "add F2N, or F2E with E2N (the inverse of a relation will do, at the cost of a traversal)". `text` holds `size`
 * bytes; 256 are always enough. */
void gmds_path_advice(int i, int j, size_t size, char *text);

/* The direct and indirect matrices of [models] 2.2: entry [i][j] is '0' or '1', and 'x' (stored), '0' to '3' (the first
 * cell on the shortest local connection) or '-'. */
void gmds_matrices(unsigned mask, char direct[4][4], char indirect[4][4]);

#ifdef __cplusplus
}
#endif
#endif
