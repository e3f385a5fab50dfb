/* A mesh of one compiled model beside the reference: every operation is done to both, and they are compared. */
#ifndef GMDS_TESTS_VOLUME_SUBJECT_H
#define GMDS_TESTS_VOLUME_SUBJECT_H

#include "harness.h"
#include "volumes/reference.h"
#include "volumes/volume.h"

typedef struct subject {
  const volume_model *m;
  void *mesh;
  reference ref;
  gmds_memory memory;
  gmds_ids list;
  uint64_t seed;
  size_t done, refused, unsupported;
} subject;

void subject_begin(subject *s, const volume_model *m, uint64_t seed);
void subject_end(subject *s);
void subject_fail(const subject *s, const char *format, ...) __attribute__((format(printf, 2, 3), noreturn));

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

/* Compacts and trims both. */
void subject_compact(subject *s);

/* Every query of every cell, alone and of the whole mesh, against brute force. */
void subject_compare(subject *s);

#endif
