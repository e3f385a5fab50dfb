/* What the command knows of a generated model. */
#ifndef GMDS_MODEL_ENTRY_H
#define GMDS_MODEL_ENTRY_H

#include <gmds/parts.h>
#include <gmds/soup.h>

typedef struct model_entry model_entry;

typedef struct model_task {
  size_t n;                 /* points */
  const double *xy;         /* n × 2 */
  int verify;               /* also verify every stored relation */
  gmds_soup *soup;          /* receives nodes and triangles, if not NULL */
  const model_entry *owner; /* the model that borrowed relations for the run, and has the mesh back after it; or NULL */
  double (*now)(void);
  int (*progress)(void *user, size_t done, size_t total);
  void *user;
  gmds_error *error;
} model_task;

typedef struct model_report {
  double seconds;
  int dimension;
  size_t duplicates, triangles, bytes, peak_bytes;
  uint64_t sum; /* checksum of the triangles */
} model_report;

struct model_entry {
  unsigned mask;
  gmds_status (*triangulate)(const model_task *task, model_report *report);
  /* Takes what another model has triangulated since `begin`, and reports on it. */
  gmds_status (*give_back)(const model_task *task, double begin, gmds_parts *parts, model_report *report);
  int code[3][3]; /* the paths that the preprocessor chose (models/choice.h) */
};

#endif
