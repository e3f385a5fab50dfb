/* Scripts of operations that several tests run on their subjects. */
#ifndef GMDS_TESTS_SCRIPT_H
#define GMDS_TESTS_SCRIPT_H

#include "models/subject.h"

void script_nodes(subject *s, size_t n);

/* A face of a type that the model holds (GMDS_ERR_ARGUMENT otherwise), looked up where the model can. */
gmds_status script_add(subject *s, size_t n, const gmds_id *nodes);

/* A grid of w by h squares, cut in two (kind 0), whole (1), or mixed with hexagons (2), as far as the model holds such
 * faces, and two isolated nodes. */
void script_grid(subject *s, gmds_id w, gmds_id h, int kind);

/* A face on random nodes, added with some of what can be known. */
void script_face(subject *s);

/* A subject with the nodes of another, of the same seed, and with its faces added at once. *list holds their nodes. */
typedef struct face_list {
  size_t n, begin[MAX_FACES + 1];
  gmds_id nodes[MAX_FACES * MAX_SIDES];
} face_list;
void script_list(const subject *s, face_list *list);
gmds_status script_at_once(subject *s, const subject *like, const face_list *list, size_t *failed);

/* One random operation. */
void script_step(subject *s);

#endif
