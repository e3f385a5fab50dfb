/* The reference mesh: cells as lists of nodes, every query by brute force over all cells. Numbers are given as the
 * meshes give them: the lowest that is free. */
#ifndef GMDS_TESTS_VOLUME_REFERENCE_H
#define GMDS_TESTS_VOLUME_REFERENCE_H

#include <gmds/ids.h>
#include <gmds/soup.h>
#include <gmds/topology.h>

enum { MAX_CELLS = 700, MAX_SIDES = 8, MAX_WALLS = 12 };

typedef struct cycle {
  size_t n;
  gmds_id nodes[MAX_SIDES];
} cycle;

typedef struct reference_cell {
  int alive;
  cycle nodes; /* of a face, of an edge */
  gmds_cell_type type;
  size_t n_walls;
  cycle walls[MAX_WALLS]; /* of a region, in local order */
  size_t n_corners;       /* of a region: its nodes in local order */
  gmds_id corners[2 * MAX_SIDES];
} reference_cell;

typedef struct reference {
  int makes_edges, makes_faces;
  gmds_id end[4];
  reference_cell cells[4][MAX_CELLS];
} reference;

typedef struct answer {
  size_t n;
  gmds_id cells[MAX_CELLS];
} answer;

int reference_has(const reference *r, int i, gmds_id c);
size_t reference_count(const reference *r, int i);

/* A live i-cell by chance, or GMDS_NONE. */
gmds_id reference_pick(const reference *r, int i, uint64_t *seed);

/* The edge between two nodes, the face with a set of nodes; GMDS_NONE where there is none. */
gmds_id reference_edge(const reference *r, gmds_id a, gmds_id b);
gmds_id reference_face(const reference *r, const cycle *c);

/* Found or made. */
gmds_id reference_add_node(reference *r);
gmds_id reference_add_edge(reference *r, gmds_id a, gmds_id b);
gmds_id reference_add_face(reference *r, const cycle *c);
gmds_id reference_add_region(reference *r, gmds_cell_type type, const gmds_id *nodes);
gmds_id reference_add_polyhedron(reference *r, size_t n, const gmds_id *faces);

/* How many regions have a face with these nodes. */
size_t reference_regions_on(const reference *r, const cycle *c);

/* What bounds nothing, of the cells of a region or face that was removed, goes too where `bare` says so. */
void reference_remove_region(reference *r, gmds_id c, gmds_bare bare);
void reference_remove_face(reference *r, gmds_id f, gmds_bare bare);
void reference_remove(reference *r, int i, gmds_id c); /* with all that has it */

/* The j-cells of i-cell c, sorted. */
void reference_query(const reference *r, int i, int j, gmds_id c, answer *out);

/* The walls of a type by their local nodes. */
size_t reference_walls(gmds_cell_type type, const gmds_id *nodes, cycle *walls);

#endif
