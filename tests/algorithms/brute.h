/* A soup of regions taken apart, and what is said of it by looking everywhere. */
#ifndef GMDS_TESTS_BRUTE_H
#define GMDS_TESTS_BRUTE_H

#include <gmds/complex.h>
#include <gmds/soup.h>

enum { BRUTE_SIDES = 8 };

typedef struct brute_cycle {
  size_t n;
  gmds_id v[BRUTE_SIDES];
} brute_cycle;

typedef struct brute {
  size_t n_nodes, n_regions, n_walls;
  const double *points;
  gmds_cell_type *type;
  gmds_id (*nodes)[8]; /* of regions with a shape */
  size_t *first;       /* of region r the walls first[r] to first[r + 1] - 1 */
  size_t *owner;       /* the region of a wall */
  brute_cycle *wall;
  size_t *group; /* of a wall the first with the same nodes */
  size_t *on;    /* of such a first wall how many there are */
} brute;

void brute_begin(brute *b, const gmds_soup *soup);
void brute_end(brute *b);

/* The wall of region r with these nodes, or n_walls. */
size_t brute_wall(const brute *b, size_t r, size_t n, const gmds_id *nodes);
int brute_same_cycle(const brute_cycle *wall, const gmds_id *nodes);

/* The volume between the origin and the triangles of the sides of a face with its mean. */
double brute_cone(const brute *b, size_t n, const gmds_id *nodes);

/* The number of each region's component; how many there are. */
size_t brute_components(const brute *b, gmds_id *number);

/* How many fans of regions are at node v, or, unless x is GMDS_NONE, at the edge from v to x. */
size_t brute_fans(const brute *b, gmds_id v, gmds_id x);

int brute_is_inner(const brute *b, gmds_id v);

/* Whether the rows of i -> j between these cells are what their nodes say. */
void brute_check_relation(const brute *b, const gmds_complex *cells, int i, int j, const gmds_csr *csr);

#endif
