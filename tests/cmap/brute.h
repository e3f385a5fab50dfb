/* A combinatorial map as plain arrays: what the tests hold the library against. Orbits are closures by brute force,
 * every rule is written as it is defined. */
#ifndef GMDS_TESTS_CMAP_BRUTE_H
#define GMDS_TESTS_CMAP_BRUTE_H

#include <gmds/map.h>

enum { BRUTE_MOST = 1024, BRUTE_BETAS = 5 };

typedef struct brute {
  int n;
  size_t end; /* darts are numbered below */
  uint8_t alive[BRUTE_MOST];
  gmds_id beta[BRUTE_BETAS][BRUTE_MOST];
} brute;

void brute_init(brute *b, int n);

/* The links of a map, with the same numbers. */
void brute_copy(brute *b, const gmds_map *map);

/* Whether the map has these links; prints nothing. */
int brute_equals(const brute *b, const gmds_map *map);

/* in[d]: whether d is in the orbit of `d` under the betas of a mask (GMDS_BETA), or of the same origin; how many are.
 * */
size_t brute_orbit(const brute *b, gmds_id d, unsigned betas, uint8_t *in);
unsigned brute_cell(const brute *b, int i);

/* Whether the links make an n-map. */
int brute_is_map(const brute *b);

/* Holds the cells of a map against the orbits of its links: an assertion fails where they differ. */
void brute_check_cells(const gmds_map *map);

/* sew and unsew as they are defined: 0 where they are refused (nothing is changed then). */
int brute_sew(brute *b, int i, gmds_id d, gmds_id e);
int brute_unsew(brute *b, int i, gmds_id d);

/* Removal and contraction of a cell; 0 where they are refused. */
int brute_remove(brute *b, int i, gmds_id d);
int brute_contract(brute *b, int i, gmds_id d);

#endif
