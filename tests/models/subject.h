/* A mesh of one model beside its reference. Each operation here is done by the model, held against what the reference
 * says must happen (its status, the identifiers it gives), and then done to the reference. */
#ifndef GMDS_TESTS_SUBJECT_H
#define GMDS_TESTS_SUBJECT_H

#include "harness.h"
#include "models/model.h"
#include "models/reference.h"

typedef struct subject {
  const model *m;
  void *mesh;
  reference ref;
  uint64_t seed;
  int64_t tags;       /* given to cells so far */
  gmds_memory memory; /* of the lists of the test */
  gmds_ids list;
  failing from;         /* the allocator of the mesh */
  int inject;           /* let the k-th allocation of every operation fail, for every k until it succeeds */
  long attempt;         /* the k under way */
  size_t done, refused; /* operations that the model carried out, and refused as it had to */
} subject;

/* What a caller of add_face may know. */
typedef enum knows { KNOWS_NOTHING, KNOWS_EDGES, KNOWS_FACES, KNOWS_BOTH } knows;

void subject_begin(subject *s, const model *m, uint64_t seed);
void subject_end(subject *s); /* also asserts that nothing leaked */

/* Repeats an operation with one more allocation granted as long as it runs out of memory:
 *   begin_attempts(s);
 *   do
 *     status = ...;
 *   while (again(s, status)); */
void begin_attempts(subject *s);
int again(subject *s, gmds_status status);

gmds_id subject_add_node(subject *s);
void subject_add_edge(subject *s, gmds_id a, gmds_id b);
gmds_status subject_add_face(subject *s, size_t n, const gmds_id *nodes, knows known);
void subject_remove_face(subject *s, gmds_id f, gmds_edges edges);
void subject_remove_edge(subject *s, gmds_id e, gmds_around around);
void subject_remove_node(subject *s, gmds_id v, gmds_around around);
void subject_compact(subject *s);

/* Converts the mesh to another model and compares it. What the model before could not tell (how a triangle turns, which
 * of two edges with the same faces lies where) the reference takes from the mesh. Returns the status, which is GMDS_OK
 * unless the new model cannot hold the mesh or the old one does not determine it; then nothing has changed. */
gmds_status subject_become(subject *s, const model *to);

/* Asserts that the mesh is what the reference says: cells, coordinates, attributes, every query of one cell and of the
 * whole mesh, and that it passes its own check. */
void subject_compare(subject *s);

/* What a mask implies. */
int stores(const model *m, int i, int j);
int links_edges(const model *m);        /* edges know nodes, or nodes edges */
int makes_edges(const model *m);        /* faces find or make their edges */
int finds_faces(const model *m);        /* the faces at a side can be looked up */
int needs_links(const model *m);        /* add_face cannot look up what it must link */
int allows(const model *m, size_t n);   /* faces of n sides */
gmds_edges usual_edges(const model *m); /* what becomes of the edges of faces: unlinked ones must not stay alone */

#define subject_fail(s, ...) subject_fail_at(s, __LINE__, __VA_ARGS__)
__attribute__((noreturn, format(printf, 3, 4))) void subject_fail_at(const subject *s, int line, const char *format,
                                                                     ...);

#endif
