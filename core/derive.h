/* What a conversion between models derives from the stored relations of a mesh (derive.c), each when it is first asked
 * for. Private to the library. */
#ifndef GMDS_CORE_DERIVE_H
#define GMDS_CORE_DERIVE_H

#include <gmds/hops.h>
#include <gmds/parts.h>

/* A relation to be read: a stored one, or one that was built. */
typedef struct view {
  const gmds_part *part; /* NULL: the csr */
  gmds_csr csr;
} view;

/* The entries of cell c. In a column those of a dead cell are anything. */
static inline gmds_id *view_row(const view *v, size_t c, size_t *n)
{
  const gmds_part *p = v->part;
  if (!p) {
    *n = v->csr.begin[c + 1] - v->csr.begin[c];
    return *n ? v->csr.data + v->csr.begin[c] : NULL;
  }
  if (p->how.storage == GMDS_IN_ROWS)
    return gmds_rows_get(&p->rows, c, n);
  if (p->how.storage == GMDS_IN_PAIRS)
    return gmds_pairs_get(&p->pairs, c, n);
  *n = p->how.arity;
  return p->column.data + p->how.arity * c;
}

/* A side of a face is numbered by where its entry lies: the k-th of face f is view_base(v, f) + k < view_extent(v). For
 * relations of faces, which are never in pairs. */
static inline size_t view_base(const view *v, size_t f)
{
  return !v->part                               ? v->csr.begin[f]
         : v->part->how.storage == GMDS_IN_ROWS ? v->part->rows.start[f]
                                                : v->part->how.arity * f;
}

static inline size_t view_extent(const view *v)
{
  return !v->part                               ? v->csr.capacity
         : v->part->how.storage == GMDS_IN_ROWS ? v->part->rows.pool_used
                                                : v->part->column.capacity;
}

typedef struct derived {
  const gmds_parts *from;
  gmds_memory *memory; /* of all that is derived */
  gmds_error *error;
  size_t limit;     /* of edges that are made */
  int makes_edges;  /* there are none yet: one for each group of sides */
  size_t end_edges; /* identifiers of edges, once they are made too */
  int knows[4];     /* which of the following are there */
  view nodes;       /* of faces, in order */
  view aligned;     /* edges of faces: entry k is that of side k; else edge_of_group says */
  int has_aligned;
  gmds_part ends;             /* of edges: a column of two nodes each, GMDS_NONE where they are not known */
  const gmds_id *end_of_edge; /* that column, or the stored one */
  gmds_id *group;             /* of each side: sides between the same two nodes are one */
  size_t n_sides;             /* numbers of sides; the entries of `group` behind them are those of the edges */
  size_t n_grouped;           /* entries of `group` */
  size_t n_groups;
  gmds_id *edge_of_group;
} derived;

void derive_begin(derived *d, const gmds_parts *from, gmds_memory *memory, gmds_error *error);
void derive_end(derived *d);

/* Whether the parts store i2j; whether a mask links edges with nodes; whether its faces make edges. */
int derive_stores(const derived *d, int i, int j);
int mask_links_edges(unsigned mask);
int mask_makes_edges(unsigned mask);

/* Each makes sure that what it is called after is there. GMDS_OK or any status of gmds_parts_convert. */
gmds_status derive_nodes_of_faces(derived *d);
gmds_status derive_groups(derived *d);
gmds_status derive_edges_of_sides(derived *d); /* for side_edge */
gmds_status derive_ends(derived *d);           /* all known */

/* The faces of each group of sides. */
gmds_status derive_faces_of_groups(derived *d, gmds_csr *csr);

/* The edge of side k of face f. */
static inline gmds_id side_edge(const derived *d, size_t f, size_t k)
{
  size_t n = 0;
  return d->has_aligned ? view_row(&d->aligned, f, &n)[k] : d->edge_of_group[d->group[view_base(&d->nodes, f) + k]];
}

/* Reads a stored relation (i2j must be stored). */
view derive_stored(const derived *d, int i, int j);

/* The inverse of a view of i-cells towards n cells. */
gmds_status derive_inverse(const derived *d, int i, const view *v, size_t n, gmds_csr *csr);

#endif
