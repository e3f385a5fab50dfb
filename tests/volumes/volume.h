/* A compiled model of volumes as a table of functions over an opaque mesh, so that what is compiled once for each model
 * stays small: every test of this folder is written once over this table. */
#ifndef GMDS_TESTS_VOLUME_H
#define GMDS_TESTS_VOLUME_H

#include <gmds/cells.h>
#include <gmds/delaunay.h>
#include <gmds/hops.h>
#include <gmds/pairs.h>
#include <gmds/soup.h>
#include <gmds/topology.h>
#include <gmds/volume.h>

/* How the entries of one stored relation lie in memory. */
typedef struct stored_relation {
  gmds_rows *rows;     /* in pooled rows, or */
  gmds_pairs *pairs;   /* two inline as a rule, or */
  gmds_column *column; /* inline, `arity` entries a cell */
  size_t arity;
  int coded; /* entries are 4 * region + face */
} stored_relation;

typedef struct volume_model {
  const char *name;
  unsigned mask;    /* cells and relations, no DIM */
  unsigned faces;   /* the bits of GMDS_FACE_TYPE_LIST that it holds */
  unsigned regions; /* the bits of GMDS_REGION_TYPE_LIST that it holds */
  size_t bytes;     /* of a mesh */
  int path[4][4], can[4][4];
  int adds_regions, makes_edges, makes_faces;
  int ordered_2_0, ordered_3_0;
  void (*do_init)(void *m, const gmds_allocator *allocator);
  void (*do_clear)(void *m);
  gmds_cells *(*do_cells)(void *m); /* four of them */
  gmds_memory *(*do_memory)(void *m);
  const double *(*do_point)(const void *m, gmds_id v);
  gmds_cell_type (*do_type)(const void *m, gmds_id r);
  gmds_status (*do_query)(const void *m, int i, int j, gmds_id c, gmds_ids *out);
  gmds_status (*do_bulk)(const void *m, int i, int j, gmds_csr *csr);
  const gmds_id *(*do_view)(const void *m, int i, int j, gmds_id c, size_t *n); /* NULL where it is not stored */
  stored_relation (*do_stored)(void *m, int i, int j);
  gmds_status (*do_add_node)(void *m, const double *x, gmds_id *id);
  gmds_status (*do_add_edge)(void *m, gmds_id a, gmds_id b, gmds_id *id);           /* NULL where edges know no nodes */
  gmds_status (*do_add_face)(void *m, size_t n, const gmds_id *nodes, gmds_id *id); /* NULL where none are made */
  gmds_status (*do_add_region)(void *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id);
  gmds_status (*do_add_polyhedron)(void *m, size_t n, const gmds_id *faces, gmds_id *id); /* NULL where none are held */
  gmds_status (*do_remove_region)(void *m, gmds_id r, gmds_bare bare);
  gmds_status (*do_remove_face)(void *m, gmds_id f, gmds_around around, gmds_bare bare); /* NULL without faces */
  gmds_status (*do_remove_edge)(void *m, gmds_id e, gmds_around around);                 /* NULL without edges */
  gmds_status (*do_remove_node)(void *m, gmds_id v, gmds_around around);
  gmds_status (*do_trim)(void *m);
  gmds_status (*do_compact)(void *m, gmds_id *maps[4]);
  gmds_status (*do_check)(const void *m, gmds_memory *memory, gmds_error *error);
  gmds_status (*do_get_volume)(const void *m, gmds_volume *volume,
                               gmds_error *error); /* NULL where nodes are not told */
  gmds_status (*do_set_volume)(void *m, gmds_volume *volume, gmds_error *error);
  gmds_status (*do_to_soup)(const void *m, gmds_soup *soup, gmds_error *error); /* NULL as do_get_volume */
  gmds_status (*do_from_soup)(void *m, const gmds_soup *soup, gmds_error *error);
  gmds_status (*do_delaunay)(void *m, size_t n, const double *xyz, const gmds_delaunay_options *options,
                             gmds_delaunay_result *result); /* NULL where there are more than tetrahedra, or no star */
  gmds_status (*do_star)(void *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                         gmds_id *ids); /* NULL where there is none */
  int stars_or_nothing;                 /* a star that fails changes nothing */
  gmds_status (*do_checksum)(const void *m, gmds_memory *memory, uint64_t *sum);
} volume_model;

/* Every compiled model; the list is generated. */
extern const volume_model *const volume_models[];
extern const size_t n_volume_models;

#endif
