/* A mesh of one compiled model beside the reference: every operation is done to both, and they are compared. */
#ifndef GMDS_TESTS_VOLUME_SUBJECT_H
#define GMDS_TESTS_VOLUME_SUBJECT_H

#include "harness.h"
#include "volumes/reference.h"
#include "volumes/volume.h"

typedef struct subject {
  const volume_model *m;
  void *mesh;
  failing from; /* what the mesh allocates with */
  int inject;   /* every operation fails at its first allocation, its second, ... until it succeeds */
  long attempt;
  uint64_t before; /* the mesh as it was */
  reference ref;
  gmds_memory memory;
  gmds_ids list;
  uint64_t seed;
  size_t done, refused, unsupported;
} subject;

void subject_begin(subject *s, const volume_model *m, uint64_t seed);
void subject_end(subject *s);
void subject_fail(const subject *s, const char *format, ...) __attribute__((format(printf, 2, 3), noreturn));

/* Around an operation of the mesh:
 *     subject_attempt(s);
 *     do
 *       status = ...;
 *     while (subject_again(s, status));
 * with `inject` it is tried until it has all the memory it asks for, and whenever it has not nothing may have
 * changed. */
void subject_attempt(subject *s);
int subject_again(subject *s, gmds_status status);

/* A number that depends on every cell, coordinate and entry of the mesh, in order. */
uint64_t subject_fingerprint(subject *s);

/* What can be made in a model: a type of region, a face of n nodes. */
int subject_allows(const subject *s, gmds_cell_type type);
int subject_allows_face(const subject *s, size_t n);
int subject_stores(const subject *s, int i, int j);

void subject_add_node(subject *s);
void subject_add_edge(subject *s, gmds_id a, gmds_id b);
void subject_add_face(subject *s, const cycle *c);
void subject_add_region(subject *s, gmds_cell_type type, const gmds_id *nodes);
void subject_add_polyhedron(subject *s, size_t n, const cycle *walls);
void subject_remove_region(subject *s, gmds_id r, gmds_bare bare);
void subject_remove_face(subject *s, gmds_id f, gmds_around around, gmds_bare bare);
void subject_remove_edge(subject *s, gmds_id e, gmds_around around);
void subject_remove_node(subject *s, gmds_id v, gmds_around around);

/* Compacts and trims both; trims the mesh alone. */
void subject_compact(subject *s);
void subject_trim(subject *s);

/* Every query of every cell, alone and of the whole mesh, against brute force. */
void subject_compare(subject *s);

#endif
