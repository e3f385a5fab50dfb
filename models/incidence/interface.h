/* What a mesh can do: the functions of an opened model, each under the model's prefix (tri_mesh_init, ...). This is the
 * interface that algorithms are written against; they know no backend.
 *
 * Identifiers are local: nodes, edges and faces are numbered from 0 each, with holes after deletions. Unless said
 * otherwise a call that is given an identifier refuses one that is not alive with GMDS_ERR_CELL, and a call that fails
 * has changed nothing. Calls on a const mesh may run concurrently, each with lists of its own. */

typedef struct mesh mesh;

/* ---- life

 * An empty mesh. allocator: where its memory comes from; NULL stands for the C library's. Allocates nothing. Do not
 * copy or move the structure while it is in use. GMDS_OK, always: the status begins a chain of calls. */
static inline gmds_status mesh_init(mesh *m, const gmds_allocator *allocator);

/* Frees everything. The mesh is empty and usable; memory.peak goes on. */
static inline void mesh_clear(mesh *m);

/* Removes every cell and frees its room. The attributes stay, without values. */
static inline void empty(mesh *m);

/* Room for at least this many cells in all, exactly if there was less. GMDS_OK, GMDS_ERR_MEMORY, GMDS_ERR_TOO_MANY. */
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces);

/* Gives back the room that is not used. Identifiers stay. GMDS_OK or GMDS_ERR_MEMORY (valid, trimmed in part).
 * O(mesh). */
static inline gmds_status trim(mesh *m);

/* Closes the holes: cells numbered below the count keep their identifiers, the others move into the holes in the order
 * they have. maps[i], if not NULL, receives the new identifier of each old i-cell, GMDS_NONE for holes; it has room for
 * end_i of them. maps may be NULL. GMDS_OK or GMDS_ERR_MEMORY. Constant when there is no hole; O(holes) for edges where
 * N2E comes with E2N and F2E with E2F, and for faces of one type where N2F comes with F2N, F2F with F2N, and E2F with
 * F2E, or with F2N and N2E; else O(mesh). */
static inline gmds_status compact(mesh *m, gmds_id *maps[3]);

/* ---- cells: how many are alive; whether one is; the first from `id` on, or GMDS_NONE.

 *     for (gmds_id f = tri_next_2(&m, 0); f != GMDS_NONE; f = tri_next_2(&m, f + 1))
 * meets every face that lives all along, once, whatever is created or deleted in the loop. */
static inline size_t count_0(const mesh *m);
static inline size_t count_1(const mesh *m);
static inline size_t count_2(const mesh *m);
static inline int has_0(const mesh *m, gmds_id v);
static inline int has_1(const mesh *m, gmds_id e);
static inline int has_2(const mesh *m, gmds_id f);
static inline gmds_id next_0(const mesh *m, gmds_id v);
static inline gmds_id next_1(const mesh *m, gmds_id e);
static inline gmds_id next_2(const mesh *m, gmds_id f);

/* The 2 or 3 coordinates of a live node (not checked, in either call); valid until a node is added. */
static inline const double *point(const mesh *m, gmds_id v);
static inline void set_point(mesh *m, gmds_id v, const double *x);

/* The coordinates of all nodes, row major, for scans and for setting many: those of node v from 2 v or 3 v on, with
 * room for as many nodes as were reserved. Valid until a node is added or the room changes. */
static inline double *coordinates(mesh *m);

/* One past the largest identifier in use: how long an array over all i-cells must be. */
static inline size_t end_0(const mesh *m);
static inline size_t end_1(const mesh *m);
static inline size_t end_2(const mesh *m);

/* The memory that the mesh counts in: its live and peak bytes and its limit; algorithms take their working space from
 * it. */
static inline gmds_memory *mesh_memory(mesh *m);

/* ---- attributes: named columns of values beside the cells of one dimension (cells.h), which grow and move with them.

 * Adds a column to the i-cells, i from 0 to 2. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_ARGUMENT (no such dimension, no name,
 * no component, unknown type); GMDS_ERR_CONFLICT (the name is taken). */
static inline gmds_status add_attribute(mesh *m, int i, const char *name, gmds_value type, size_t components,
                                        gmds_attribute **attribute);

/* The column of a name, or NULL. */
static inline gmds_attribute *find_attribute(const mesh *m, int i, const char *name);

/* Removes a column of the i-cells and frees it. */
static inline void remove_attribute(mesh *m, int i, gmds_attribute *attribute);

/* ---- queries: get_adj_i_j puts the j-cells incident (i != j) or adjacent (i = j) to one i-cell into a list of the
 * caller: a set, without repetition and without GMDS_NONE; for 2 -> 0 in order around the face where GMDS_ORDERED_2_0.
 * 0 -> 0 is being joined by an edge, kept or not; 1 -> 1 sharing a node; 2 -> 2 sharing a side.
 * GMDS_OK; GMDS_ERR_CELL; GMDS_ERR_MEMORY (the list's content is lost). Cost: docs/models.md, or `gmds models MASK`.
 * A query that the model cannot answer does not compile, and says what to add. */
#if GMDS__CAN_0_0
static inline gmds_status get_adj_0_0(const mesh *m, gmds_id v, gmds_ids *out);
#elif GMDS__PATH_0_0
GMDS__UNDECIDED(0, 0) gmds_status get_adj_0_0(const mesh *m, gmds_id v, gmds_ids *out);
#else
GMDS__SORRY(0, 0, GMDS_PATHS_0_0) gmds_status get_adj_0_0(const mesh *m, gmds_id v, gmds_ids *out);
#endif
#if GMDS__CAN_0_1
static inline gmds_status get_adj_0_1(const mesh *m, gmds_id v, gmds_ids *out);
#elif GMDS__PATH_0_1
GMDS__UNDECIDED(0, 1) gmds_status get_adj_0_1(const mesh *m, gmds_id v, gmds_ids *out);
#else
GMDS__SORRY(0, 1, GMDS_PATHS_0_1) gmds_status get_adj_0_1(const mesh *m, gmds_id v, gmds_ids *out);
#endif
#if GMDS__CAN_0_2
static inline gmds_status get_adj_0_2(const mesh *m, gmds_id v, gmds_ids *out);
#elif GMDS__PATH_0_2
GMDS__UNDECIDED(0, 2) gmds_status get_adj_0_2(const mesh *m, gmds_id v, gmds_ids *out);
#else
GMDS__SORRY(0, 2, GMDS_PATHS_0_2) gmds_status get_adj_0_2(const mesh *m, gmds_id v, gmds_ids *out);
#endif
#if GMDS__CAN_1_0
static inline gmds_status get_adj_1_0(const mesh *m, gmds_id e, gmds_ids *out);
#elif GMDS__PATH_1_0
GMDS__UNDECIDED(1, 0) gmds_status get_adj_1_0(const mesh *m, gmds_id e, gmds_ids *out);
#else
GMDS__SORRY(1, 0, GMDS_PATHS_1_0) gmds_status get_adj_1_0(const mesh *m, gmds_id e, gmds_ids *out);
#endif
#if GMDS__CAN_1_1
static inline gmds_status get_adj_1_1(const mesh *m, gmds_id e, gmds_ids *out);
#elif GMDS__PATH_1_1
GMDS__UNDECIDED(1, 1) gmds_status get_adj_1_1(const mesh *m, gmds_id e, gmds_ids *out);
#else
GMDS__CANNOT(1, 1, "E2N or N2E") gmds_status get_adj_1_1(const mesh *m, gmds_id e, gmds_ids *out);
#endif
#if GMDS__CAN_1_2
static inline gmds_status get_adj_1_2(const mesh *m, gmds_id e, gmds_ids *out);
#elif GMDS__PATH_1_2
GMDS__UNDECIDED(1, 2) gmds_status get_adj_1_2(const mesh *m, gmds_id e, gmds_ids *out);
#else
GMDS__SORRY(1, 2, GMDS_PATHS_1_2) gmds_status get_adj_1_2(const mesh *m, gmds_id e, gmds_ids *out);
#endif
#if GMDS__CAN_2_0
static inline gmds_status get_adj_2_0(const mesh *m, gmds_id f, gmds_ids *out);
#elif GMDS__PATH_2_0
GMDS__UNDECIDED(2, 0) gmds_status get_adj_2_0(const mesh *m, gmds_id f, gmds_ids *out);
#else
GMDS__SORRY(2, 0, GMDS_PATHS_2_0) gmds_status get_adj_2_0(const mesh *m, gmds_id f, gmds_ids *out);
#endif
#if GMDS__CAN_2_1
static inline gmds_status get_adj_2_1(const mesh *m, gmds_id f, gmds_ids *out);
#elif GMDS__PATH_2_1
GMDS__UNDECIDED(2, 1) gmds_status get_adj_2_1(const mesh *m, gmds_id f, gmds_ids *out);
#else
GMDS__SORRY(2, 1, GMDS_PATHS_2_1) gmds_status get_adj_2_1(const mesh *m, gmds_id f, gmds_ids *out);
#endif
#if GMDS__CAN_2_2
static inline gmds_status get_adj_2_2(const mesh *m, gmds_id f, gmds_ids *out);
#elif GMDS__PATH_2_2
GMDS__UNDECIDED(2, 2) gmds_status get_adj_2_2(const mesh *m, gmds_id f, gmds_ids *out);
#else
GMDS__SORRY(2, 2, GMDS_PATHS_2_2) gmds_status get_adj_2_2(const mesh *m, gmds_id f, gmds_ids *out);
#endif

/* The same for every i-cell at once: row c of the csr (empty where c is not alive) is what get_adj_i_j gives for c.
 * The csr is initialised and empty, its memory is the caller's. GMDS_OK or GMDS_ERR_MEMORY (it stays empty). O(mesh),
 * the answer included: k faces on one edge have k (k - 1) neighbours. */
#if GMDS__CAN_0_0
static inline gmds_status all_adj_0_0(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_0_1
static inline gmds_status all_adj_0_1(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_0_2
static inline gmds_status all_adj_0_2(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_1_0
static inline gmds_status all_adj_1_0(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_1_1
static inline gmds_status all_adj_1_1(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_1_2
static inline gmds_status all_adj_1_2(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_2_0
static inline gmds_status all_adj_2_0(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_2_1
static inline gmds_status all_adj_2_1(const mesh *m, gmds_csr *csr);
#endif
#if GMDS__CAN_2_2
static inline gmds_status all_adj_2_2(const mesh *m, gmds_csr *csr);
#endif

/* ---- views: what a model stores, without copying. view_i_j gives the j-cells of a live i-cell (not checked) as they
 * are stored, and how many in *n: the set of get_adj_i_j in no order, that of 2 -> 0 and 2 -> 1 by sides: node k, and
 * the edge from node k to node k + 1. Valid until the mesh changes. Where all faces are triangles, the rows of faces f
 * and f + 1 follow each other, so that a loop over a column is one over an array.
 * In models that store the relation (GMDS_VIEW(i, j)); elsewhere it does not compile, and says so. F2F has no view: its
 * entries may be empty and carry a side; across() reads them. */
#if GMDS_VIEW(0, 0)
static inline const gmds_id *view_0_0(const mesh *m, gmds_id v, size_t *n);
#else
GMDS__NOT_STORED(0, 0) const gmds_id *view_0_0(const mesh *m, gmds_id v, size_t *n);
#endif
#if GMDS_VIEW(0, 1)
static inline const gmds_id *view_0_1(const mesh *m, gmds_id v, size_t *n);
#else
GMDS__NOT_STORED(0, 1) const gmds_id *view_0_1(const mesh *m, gmds_id v, size_t *n);
#endif
#if GMDS_VIEW(0, 2)
static inline const gmds_id *view_0_2(const mesh *m, gmds_id v, size_t *n);
#else
GMDS__NOT_STORED(0, 2) const gmds_id *view_0_2(const mesh *m, gmds_id v, size_t *n);
#endif
#if GMDS_VIEW(1, 0)
static inline const gmds_id *view_1_0(const mesh *m, gmds_id e, size_t *n);
#else
GMDS__NOT_STORED(1, 0) const gmds_id *view_1_0(const mesh *m, gmds_id e, size_t *n);
#endif
#if GMDS_VIEW(1, 1)
static inline const gmds_id *view_1_1(const mesh *m, gmds_id e, size_t *n);
#else
GMDS__NOT_STORED(1, 1) const gmds_id *view_1_1(const mesh *m, gmds_id e, size_t *n);
#endif
#if GMDS_VIEW(1, 2)
static inline const gmds_id *view_1_2(const mesh *m, gmds_id e, size_t *n);
#else
GMDS__NOT_STORED(1, 2) const gmds_id *view_1_2(const mesh *m, gmds_id e, size_t *n);
#endif
#if GMDS_VIEW(2, 0)
static inline const gmds_id *view_2_0(const mesh *m, gmds_id f, size_t *n);
#else
GMDS__NOT_STORED(2, 0) const gmds_id *view_2_0(const mesh *m, gmds_id f, size_t *n);
#endif
#if GMDS_VIEW(2, 1)
static inline const gmds_id *view_2_1(const mesh *m, gmds_id f, size_t *n);
#else
GMDS__NOT_STORED(2, 1) const gmds_id *view_2_1(const mesh *m, gmds_id f, size_t *n);
#endif
GMDS__NO_VIEW const gmds_id *view_2_2(const mesh *m, gmds_id f, size_t *n);

/* All edges of the faces, kept or not, with the nodes of each and the edges of each face (edges.h). Their numbers are
 * the table's, not those of edges that the mesh keeps; edges without a face are not among them. The table is
 * initialised and empty, its memory is the caller's. GMDS_OK, GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (it stays empty).
 * O(mesh). In models that keep the order of a face's nodes, or hold triangles only. */
#if GMDS_ORDERED_2_0 || (GMDS__CAN_2_0 && GMDS__SIMPLICIAL)
static inline gmds_status all_edges(const mesh *m, gmds_edge_table *table);
#endif

/* Reading 2 -> 0 and 0 -> 2 for the length of an algorithm that changes neither: prepare_i_j fills a csr (initialised
 * and empty, owned and cleared by the caller) unless the relation is stored; read_i_j gives the j-cells of a live
 * i-cell (not checked), in place where they are stored, with their number. GMDS_OK or GMDS_ERR_MEMORY (the csr stays
 * empty). O(mesh) or constant; then constant time a cell. */
#if GMDS__CAN_2_0
static inline gmds_status prepare_2_0(const mesh *m, gmds_csr *csr);
static inline const gmds_id *read_2_0(const mesh *m, const gmds_csr *csr, gmds_id f, size_t *n);
#endif
#if GMDS__CAN_0_2
static inline gmds_status prepare_0_2(const mesh *m, gmds_csr *csr);
static inline const gmds_id *read_0_2(const mesh *m, const gmds_csr *csr, gmds_id v, size_t *n);
#endif

/* ---- creation
 *
 * New cells take the identifiers of deleted ones: constant time without holes, else a search of O(end / 64) at worst.
 *
 * A node with the model's 2 or 3 coordinates. GMDS_OK, GMDS_ERR_MEMORY, GMDS_ERR_TOO_MANY. */
static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id);

/* n nodes at once, numbered from *first on without a gap. x: n × 2 or 3 coordinates, row major, or NULL: they are to be
 * set (set_point). Statuses as above. O(n). */
static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first);

/* The edge between two nodes, found or made. Also GMDS_ERR_ARGUMENT (a == b). O(edges at a) with N2E, else O(edges).
 * In models that link edges and nodes (E2N or N2E). */
#if GMDS__K_1 && (GMDS__S_0_1 || GMDS__S_1_0)
static inline gmds_status add_edge(mesh *m, gmds_id a, gmds_id b, gmds_id *id);
#endif

/* A face of n distinct nodes, listed around it; its edges are found or made. Every stored relation is kept true.
 * GMDS_OK; GMDS_ERR_ARGUMENT (n is not of the model's types, or a node occurs twice); GMDS_ERR_CELL (a node that does
 * not exist); GMDS_ERR_CONFLICT (F2F holds two faces a side, this would be the third); GMDS_ERR_UNSUPPORTED (the model
 * has no way to find what is at a side, GMDS_ADDS_FACES is 0: use add_face_linked); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY.
 * Local where the model finds faces and edges locally (GMDS_ADDS_LOCALLY is 1), else a traversal a side. */
static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id);
static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id);
static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);

/* Many faces at once, in time linear in their sides whatever the model: face f has the nodes nodes[begin[f]] to
 * nodes[begin[f + 1] - 1], or three of them where begin is NULL. In a mesh that holds no edge and no face, so that they
 * get the identifiers 0 to n - 1. As n times add_face, and GMDS_ERR_ARGUMENT where there are edges or faces already, or
 * where begin descends;
 * *failed, if not NULL, is the face that could not be added, or n where none is to blame. */
static inline gmds_status add_faces(mesh *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed);

/* add_face when the caller knows what is at the sides: nothing is looked up, in any model. What it says is believed;
 * F2F still refuses a third face. links NULL: as add_face. */
static inline gmds_status add_face_linked(mesh *m, size_t n, const gmds_id *nodes, const gmds_links *links,
                                          gmds_id *id);

/* ---- deletion: nothing that remains names what is gone.

 * A face; its edges stay, or go when they bound no other face (GMDS_DROP_BARE_EDGES). GMDS_OK; GMDS_ERR_CELL;
 * GMDS_ERR_MEMORY; GMDS_ERR_UNSUPPORTED (the model cannot tell what is to be forgotten). The cost of 2 -> 0 and 2 ->
 * 1. */
static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_edges edges);

/* An edge or a node: refused with GMDS_ERR_CONFLICT while something is on it, or after that has gone (GMDS_CASCADE; the
 * edges of faces that go stay, save those at the node; in a model that links no edges with nodes they go when they
 * bound no other face). The rest as remove_face. */
#if GMDS__K_1
static inline gmds_status remove_edge(mesh *m, gmds_id e, gmds_around around);
#endif
static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around);

/* ---- sides: side k of a face joins its nodes k and k + 1

 * The three nodes of a live triangle (not checked) in order. In models with GMDS_ORDERED_2_0. */
#if GMDS_ORDERED_2_0
static inline void triangle_nodes(const mesh *m, gmds_id f, gmds_id v[3]);

/* Node k of a live face, k below the number of its nodes (not checked). The same models. Constant. */
static inline gmds_id face_node(const mesh *m, gmds_id f, size_t k);
#endif

/* How many sides a live face has (not checked). In models that store a relation of faces. */
#if GMDS__INLINE || GMDS__S_2_0 || GMDS__S_2_1 || GMDS__S_2_2
static inline size_t face_sides(const mesh *m, gmds_id f);
#endif

/* Entry k of F2F of a live face, k below face_sides (neither checked): the face there, or GMDS_NONE. Where the order is
 * kept (GMDS_ORDERED_2_0) it is what lies beyond side k. In models that store F2F. Constant. */
#if GMDS__S_2_2
static inline gmds_id face_beside(const mesh *m, gmds_id f, size_t k);
#endif

/* The face beyond side k of a live face (not checked), or GMDS_NONE; *arrival is the number of the side there.
 * In models with GMDS_ACROSS. Constant, or the fewer of the faces or edges at its two nodes. */
#if GMDS_ACROSS
static inline gmds_id across(const mesh *m, gmds_id f, unsigned k, unsigned *arrival);
#endif

/* ---- the cavity operator: see topology.h for the cavity

 * Replaces n_faces triangles by the n_sides triangles (sides[i].a, sides[i].b, apex). The sides are in order: the end
 * of each is the beginning of the next. The apex is a node that nothing is on. ids[i] receives the triangle on side i;
 * the identifiers of the cavity are used again. Attributes of reused cells stay as they were. That the apex, the faces
 * and the sides are what they are said to be is not checked.
 * GMDS_OK; GMDS_ERR_ARGUMENT (n_sides is not n_faces + 2); GMDS_ERR_INVARIANT (an edge that should be there is not);
 * GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. Nothing is looked up in models where F2E or N2E, or no edge, is stored.
 * In models that hold triangles, answer 2 -> 0 and do not store E2E. */
#if GMDS__TRIANGLES && GMDS__CAN_2_0 && !GMDS__S_1_1
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                               const gmds_cavity_side *sides, gmds_id *ids);
#endif

/* The same by several threads at once, in models in which a star writes nothing but the rows of its faces and the
 * entries that name them in the faces beyond its sides (GMDS_CONCURRENT_STARS: triangles with F2N and F2F,
 * no other relation and no edges). Calls may run at the same time when their cavities and apexes differ, no face is in
 * one cavity and beyond a side of another, and no other call changes the mesh; queries of faces that no star touches
 * may run beside them.
 *
 * take_faces: n faces, numbered from *first on without a gap, alive and without rows: until each has become part of a
 * star, or was given back, queries and traversals must not meet it. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. O(n).
 * drop_faces: gives back faces [first, first + n), of which no row was written.
 * star_of: as star, where ids[n_faces] and ids[n_faces + 1] are such faces; nothing is checked, nothing fails. */
#if GMDS_CONCURRENT_STARS
static inline gmds_status take_faces(mesh *m, size_t n, gmds_id *first);
static inline void drop_faces(mesh *m, gmds_id first, size_t n);
static inline void star_of(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                           const gmds_cavity_side *sides, gmds_id *ids);
#endif

/* ---- the whole mesh

 * Verifies every stored relation against all others. GMDS_OK; GMDS_ERR_INVARIANT (`error` names the first violation);
 * GMDS_ERR_MEMORY. Working space comes from `memory`. O(mesh), for N2N, E2E and F2F also the squares of the numbers of
 * neighbours (check.h). */
static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error);

/* Fills an empty mesh from a soup: its points become nodes in their order, its faces faces; edges are added where the
 * model can hold them. Faces take linear time in any model, edges that no face has that of add_edge. GMDS_OK or any
 * status of add_node, add_edge and add_face (`error` names the cell; the mesh is empty, its attributes stay);
 * GMDS_ERR_UNSUPPORTED for volumes and for a third coordinate that is not 0 in a model of two. */
static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error);

/* Writes the nodes and faces into a soup (what it held is freed), renumbered without holes. In models that keep the
 * order of a face's nodes, or hold triangles only. GMDS_OK or GMDS_ERR_MEMORY (the soup is unchanged). O(mesh). */
#if GMDS_ORDERED_2_0 || (GMDS__CAN_2_0 && GMDS__SIMPLICIAL)
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup);
#endif

/* Lists the nodes of all cells in a complex (complex.h) that is initialised and empty, and joins it: what algorithms
 * that look at a whole mesh ask once. Faces keep their identifiers, and edges where the model answers 1 -> 0; others
 * are not listed. GMDS_OK, GMDS_ERR_MEMORY, GMDS_ERR_TOO_MANY (the complex stays empty). O(mesh). In models that keep
 * the order of a face's nodes, or hold triangles only. */
#define GMDS_LISTS_CELLS (GMDS_ORDERED_2_0 || (GMDS__CAN_2_0 && GMDS__SIMPLICIAL))
#if GMDS_LISTS_CELLS
static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error);
#endif

/* Hands over all that the mesh holds, in constant time: cells, points, attributes, relations, and its memory with the
 * counts, so that `peak` goes on in whoever takes them. What `parts` (initialised, see parts.h) held is freed. The mesh
 * is empty and usable. Lists of the caller that took their memory from the mesh (mesh_memory) are cleared before. */
static inline void give_parts(mesh *m, gmds_parts *parts);

/* Gives every cell another identifier: maps[i][c] is that of the live i-cell c, from 0 to count_i - 1, each once (not
 * checked), in three arrays. Attributes, coordinates and orders go along; no hole is left. GMDS_OK; GMDS_ERR_MEMORY or
 * GMDS_ERR_TOO_MANY (nothing has changed). O(mesh); as much room as the mesh takes is needed once more. */
static inline gmds_status permute(mesh *m, gmds_id *const maps[3]);

/* Makes an empty mesh of this model hold the parts that a mesh of any model gave. What both models store is moved, what
 * this one stores more is built, what it stores less is freed. Cells keep their identifiers and attributes; edges go
 * where this model keeps none, and come, one for each two nodes that a face joins, where the other had none. What the
 * mesh held (room, attributes without values) is freed, its memory becomes that of the parts. Edges that no relation of
 * this model links with anything else are kept, and only counted.
 * GMDS_OK (no parts are left); GMDS_ERR_ARGUMENT (the mesh is not empty, or there are no parts) or any status of
 * gmds_parts_convert: mesh and parts are as they were, and the mesh that gave the parts can take them again, which
 * allocates nothing. `error` may be NULL. O(cells and entries); constant time where both models store the same. */
static inline gmds_status take_parts(mesh *m, gmds_parts *parts, gmds_error *error);

/* The checksum of the faces (checksum.h). GMDS_OK or GMDS_ERR_MEMORY. O(mesh). */
#if GMDS__CAN_2_0
static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum);
#endif
