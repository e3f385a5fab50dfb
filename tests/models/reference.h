/* The reference of the tests of models: a mesh without a model, and the definition of every query by brute force.
 *
 * Cells are kept under the identifiers that the model under test gave. A face is its nodes in order; an edge is a pair
 * of nodes, whatever the model knows of it. */
#ifndef GMDS_TESTS_REFERENCE_H
#define GMDS_TESTS_REFERENCE_H

#include <gmds/ids.h>

enum { MAX_NODES = 128, MAX_EDGES = 512, MAX_FACES = 256, MAX_SIDES = 8, MAX_ANSWER = 512 };

typedef struct reference_node {
  int alive;
  double x[3];
  int64_t tag; /* the value of the attribute of the tests */
} reference_node;

typedef struct reference_edge {
  int alive;
  gmds_id a, b;
  int64_t tag;
} reference_edge;

typedef struct reference_face {
  int alive;
  size_t n;
  gmds_id nodes[MAX_SIDES];
  int64_t tag;
} reference_face;

typedef struct reference {
  reference_node nodes[MAX_NODES];
  reference_edge edges[MAX_EDGES];
  reference_face faces[MAX_FACES];
  size_t end[3]; /* identifiers in use are below */
} reference;

/* A set of cells, or a face's nodes in order. */
typedef struct answer {
  size_t n;
  gmds_id data[MAX_ANSWER];
} answer;

int reference_has(const reference *r, int i, gmds_id c);
size_t reference_count(const reference *r, int i);

/* A live cell at random, or GMDS_NONE. */
gmds_id reference_pick(const reference *r, int i, uint64_t *seed);

/* The edge between a and b, or GMDS_NONE. */
gmds_id reference_edge_between(const reference *r, gmds_id a, gmds_id b);

/* Whether face f has the side from a to b, in either direction. */
int reference_has_side(const reference *r, gmds_id f, gmds_id a, gmds_id b);

/* The faces on a side, in the order of their identifiers. */
void reference_faces_on(const reference *r, gmds_id a, gmds_id b, answer *out);

/* i -> j as mesh.h defines it, sorted; 2 -> 0 and 2 -> 1 in the order of the face. */
void reference_query(const reference *r, int i, int j, gmds_id c, answer *out);

void answer_add(answer *a, gmds_id x); /* unless it is there */
int answer_has(const answer *a, gmds_id x);
void answer_sort(answer *a);
int answer_equal(const answer *a, const answer *b);

#endif
