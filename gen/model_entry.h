/* What the command knows of a generated model. */
#ifndef GMDS_MODEL_ENTRY_H
#define GMDS_MODEL_ENTRY_H

#include <gmds/parts.h>
#include <gmds/soup.h>

typedef struct model_entry model_entry;

typedef struct model_task {
  size_t n;                 /* points */
  const double *xy;         /* n × 2, or n × 3 for a model of volumes */
  int verify;               /* also verify every stored relation */
  gmds_soup *soup;          /* receives nodes and cells, if not NULL */
  const model_entry *owner; /* the model that borrowed relations for the run, and has the mesh back after it; or NULL */
  double (*now)(void);
  int threads; /* 0 counts as 1 */
  int (*progress)(void *user, size_t done, size_t total);
  void *user;
  gmds_error *error;
} model_task;

typedef struct model_report {
  double seconds;
  int dimension;
  size_t duplicates, cells, bytes, peak_bytes;
  uint64_t sum; /* checksum of the triangles, or tetrahedra */
} model_report;

/* `gmds bench cells`: what is done with a mesh of triangles, and what came of it. */
typedef enum cells_work {
  CELLS_BULK,      /* a mesh from arrays, all faces at once */
  CELLS_CONSTRUCT, /* the same face by face, where that needs no traversal; this mesh is the one that is worked on */
  CELLS_AREA,
  CELLS_STARS,
  CELLS_EDGES,
  CELLS_MARKS,
  CELLS_ATTRIBUTES,
  CELLS_WORKS
} cells_work;

enum { CELLS_REPETITIONS = 7 };

typedef struct cells_task {
  size_t n_nodes, n_edges, n_triangles;
  const double *xy;     /* n_nodes × 2 */
  const gmds_id *nodes; /* n_triangles × 3 */
  double (*now)(void);
} cells_task;

typedef struct cells_report {
  gmds_memory memory; /* what answers are written to, beside the mesh */
  double seconds[CELLS_WORKS][CELLS_REPETITIONS];
  int done[CELLS_WORKS]; /* repetitions; 0: the model cannot */
  size_t nodes, edges, triangles, bytes, peak_bytes;
  double area;               /* of all triangles */
  size_t star_faces, marked; /* faces around all nodes; marked faces */
  uint64_t star_sum;         /* of their identifiers */
  double number_sum;         /* of the attribute */
} cells_report;

struct model_entry {
  const char *name; /* of what is no set of relations (`cmap`), which has no `give_back` and no `code`; else NULL */
  unsigned mask;
  int dim; /* 2, or 3 for a model of volumes, which has neither `cells` nor `give_back` */
  gmds_status (*triangulate)(const model_task *task, model_report *report);
  gmds_status (*cells)(const cells_task *task, cells_report *report);
  /* Takes what another model has triangulated since `begin`, and reports on it. */
  gmds_status (*give_back)(const model_task *task, double begin, gmds_parts *parts, model_report *report);
  int code[4][4]; /* the paths that the preprocessor chose (models/choice.h) */
};

#endif
