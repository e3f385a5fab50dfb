/* What the command knows of a generated model. */
#ifndef GMDS_MODEL_ENTRY_H
#define GMDS_MODEL_ENTRY_H

#include <gmds/soup.h>

typedef struct model_task {
  size_t n;         /* points */
  const double *xy; /* n × 2 */
  int verify;       /* also verify every stored relation */
  gmds_soup *soup;  /* receives nodes and triangles, if not NULL */
  double (*now)(void);
  int threads; /* 0 counts as 1 */
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

typedef struct model_entry {
  unsigned mask;
  gmds_status (*triangulate)(const model_task *task, model_report *report);
  int code[3][3]; /* the paths that the preprocessor chose (models/choice.h) */
} model_entry;

#endif
