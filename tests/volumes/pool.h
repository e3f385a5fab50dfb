/* What meshes are made of: regions and faces that fit each other or mislead, on nodes 0 to 27; and random
 * operations. */
#ifndef GMDS_TESTS_POOL_H
#define GMDS_TESTS_POOL_H

#include "volumes/subject.h"

typedef struct item {
  gmds_cell_type type;
  gmds_id nodes[8];
} item;

extern const item pool[];
extern const size_t n_pool;

/* Adds nodes until there are 28. */
void pool_nodes(subject *s);

/* Adds what the model allows of an item; two polyhedra. */
void pool_add(subject *s, const item *it);
void pool_add_polyhedra(subject *s);

/* One random creation or deletion. */
void pool_step(subject *s);

#endif
