/* A compiled model as a table of functions over an opaque mesh, so that what is compiled once for each model stays
 * small: every test of this folder is written once over this table. */
#ifndef GMDS_TESTS_MODEL_H
#define GMDS_TESTS_MODEL_H

#include <gmds/cells.h>
#include <gmds/delaunay.h>
#include <gmds/edges.h>
#include <gmds/hops.h>
#include <gmds/parts.h>
#include <gmds/rows.h>
#include <gmds/soup.h>
#include <gmds/topology.h>

/* How the entries of one stored relation lie in memory. */
typedef struct stored_relation {
  gmds_rows *rows;     /* in pooled rows, or */
  gmds_pairs *pairs;   /* two inline as a rule, or */
  gmds_column *column; /* inline, `arity` entries a cell */
  size_t arity;
  int coded; /* entries are 4 * face + side */
} stored_relation;

/* What only some of the models are compiled with: conversions, the checksum, and where the model can triangulate. */
typedef struct model_algorithms {
  gmds_status (*do_from_soup)(void *m, const gmds_soup *soup, gmds_error *error);
  gmds_status (*do_to_soup)(const void *m, gmds_soup *soup);
  gmds_status (*do_checksum)(const void *m, gmds_memory *memory, uint64_t *sum);
  gmds_status (*do_delaunay)(void *m, size_t n, const double *xy, const gmds_delaunay_options *options,
                             gmds_delaunay_result *result);
} model_algorithms;

typedef struct model {
  const char *name;
  unsigned mask;  /* cells and relations, no DIM */
  unsigned faces; /* the bits of GMDS_FACE_TYPE_LIST that it holds */
  int dim;
  size_t bytes; /* of a mesh */
  int path[3][3], can[3][3], view[3][3];
  int ordered, crosses; /* GMDS_ORDERED_2_0, GMDS_ACROSS */
  int adds_locally;     /* GMDS_ADDS_LOCALLY */
  void (*do_init)(void *m, const gmds_allocator *allocator);
  void (*do_clear)(void *m);
  gmds_cells *(*do_cells)(void *m); /* three of them */
  gmds_memory *(*do_memory)(void *m);
  const double *(*do_point)(const void *m, gmds_id v);
  gmds_status (*do_query)(const void *m, int i, int j, gmds_id c, gmds_ids *out);
  gmds_status (*do_bulk)(const void *m, int i, int j, gmds_csr *csr);
  const gmds_id *(*do_view)(const void *m, int i, int j, gmds_id c, size_t *n);
  gmds_status (*do_all_edges)(const void *m, gmds_edge_table *table); /* NULL where a face's sides are not known */
  gmds_id (*do_across)(const void *m, gmds_id f, unsigned k, unsigned *arrival);
  gmds_status (*do_add_node)(void *m, const double *x, gmds_id *id);
  gmds_status (*do_add_edge)(void *m, gmds_id a, gmds_id b, gmds_id *id); /* NULL where edges know no nodes */
  gmds_status (*do_add_face)(void *m, size_t n, const gmds_id *nodes, const gmds_links *links, gmds_id *id);
  gmds_status (*do_add_faces)(void *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed);
  gmds_status (*do_remove_face)(void *m, gmds_id f, gmds_edges edges);
  gmds_status (*do_remove_edge)(void *m, gmds_id e, gmds_around around); /* NULL where there are no edges */
  gmds_status (*do_remove_node)(void *m, gmds_id v, gmds_around around);
  gmds_status (*do_trim)(void *m);
  gmds_status (*do_compact)(void *m, gmds_id *maps[3]);
  gmds_status (*do_check)(const void *m, gmds_memory *memory, gmds_error *error);
  void (*do_give)(void *m, gmds_parts *parts);
  gmds_status (*do_take)(void *m, gmds_parts *parts, gmds_error *error);
  stored_relation (*do_stored)(void *m, int i, int j);
  const model_algorithms *algorithms; /* may be NULL */
} model;

/* Every compiled model; the list is generated. */
extern const model *const all_models[];
extern const size_t n_models;

#endif
