/* What a mesh of volumes can do: the functions of an opened model that keeps regions, each under the model's prefix
 * (tet_mesh_init, ...). Conventions, life, attributes and what is said of a call that fails are those of models without
 * regions (models/incidence/interface.h); this file says what differs, and repeats the declarations. Dimensions run
 * from 0 (nodes) to 3 (regions), arrays of maps have four entries. Local numbers of edges and faces: shapes.h. */

typedef struct mesh mesh;

/* Cells of regions and faces are made with them when something is stored about them; they are told by their nodes. */
#define GMDS__MAKES_EDGES (GMDS__LINKED_0_1 || GMDS__LINKED_1_2 || GMDS__LINKED_1_3 || GMDS__S_1_1)
#define GMDS__MAKES_FACES (GMDS__LINKED_0_2 || GMDS__LINKED_1_2 || GMDS__LINKED_2_3 || GMDS__S_2_2)
#define GMDS__TELLS_EDGES (!GMDS__MAKES_EDGES || GMDS__LINKED_0_1)
#define GMDS__TELLS_FACES (!GMDS__MAKES_FACES || GMDS__LINKED_0_2 || (GMDS__LINKED_1_2 && GMDS__LINKED_0_1))
#define GMDS__TELLS_REGIONS (!GMDS__S_3_3 || GMDS__KNOWS_WALLS || GMDS__LINKED_2_3)
#define GMDS__TELLS_SIDES (!GMDS__S_2_2 || GMDS__LINKED_1_2 || (GMDS__LINKED_0_2 && GMDS__KNOWS_SIDES))

/* The nodes of every face and region can be listed in order: what a mesh must know to be converted or written. */
#define GMDS__LISTS_FACES (!GMDS__MAKES_FACES || GMDS_ORDERED_2_0 || (GMDS__SIMPLICIAL && GMDS__CAN_2_0))
#define GMDS__LISTS_REGIONS \
  (GMDS_ORDERED_3_0 || GMDS__S_3_0 || (GMDS__TETRAHEDRA && GMDS__CAN_3_0) || (GMDS__CAN_3_2 && GMDS_ORDERED_2_0))
#define GMDS_LISTS_CELLS (GMDS__LISTS_FACES && GMDS__LISTS_REGIONS && GMDS__TELLS_EDGES)

/* add_face and add_region find by themselves what they have to link. */
#define GMDS_ADDS_FACES (GMDS__TELLS_EDGES && GMDS__TELLS_FACES && GMDS__TELLS_SIDES)
#define GMDS_ADDS_REGIONS                                                                                  \
  (GMDS_ADDS_FACES && GMDS__TELLS_REGIONS && (GMDS__LINKED_0_3 || GMDS__LINKED_1_3 || GMDS__LINKED_2_3) && \
   GMDS__CAN_3_0)

/* Where nodes know nodes and no edge tells them apart, the faces at a side must, or the regions at an edge. */
#define GMDS__JOINED_BY_FACES (GMDS__S_0_0 && !GMDS__LINKED_0_1 && GMDS__LINKED_0_2)
#define GMDS__JOINED_BY_REGIONS (GMDS__S_0_0 && !GMDS__LINKED_0_1 && !GMDS__LINKED_0_2 && GMDS__LINKED_0_3)

/* Where a region's own cells must be known for it to go without a trace. */
#define GMDS__ASKS_NODES (GMDS__S_0_3 || GMDS__JOINED_BY_REGIONS)

/* Whether what a removal has to ask can be asked: what regions bound, and what is bare. */
#define GMDS__FORGETS_REGIONS                                                                                    \
  ((!GMDS__S_1_3 || GMDS__CAN_3_1) && (!GMDS__S_2_3 || GMDS__CAN_3_2) && (!GMDS__ASKS_NODES || GMDS__CAN_3_0) && \
   (!GMDS__JOINED_BY_REGIONS || GMDS__KNOWS_WALLS))
#define GMDS__FORGETS_FACES                                              \
  ((!GMDS__S_1_2 || GMDS__CAN_2_1) && (!GMDS__S_0_2 || GMDS__CAN_2_0) && \
   (!GMDS__JOINED_BY_FACES || (GMDS_ORDERED_2_0 && GMDS__CAN_2_0) || (GMDS__SIMPLICIAL && GMDS__CAN_2_0)))
#define GMDS__KNOWS_BARE                                                              \
  ((!GMDS__MAKES_FACES || (GMDS__CAN_3_2 && GMDS__CAN_2_3 && GMDS__FORGETS_FACES)) && \
   (!GMDS__MAKES_EDGES ||                                                             \
    (GMDS__LINKED_0_1 && GMDS__CAN_3_1 && GMDS__CAN_1_3 && (!GMDS__MAKES_FACES || (GMDS__CAN_2_1 && GMDS__CAN_1_2)))))

#define GMDS_STARS (GMDS__HAS_TETRAHEDRA && GMDS_ADDS_REGIONS && GMDS__FORGETS_REGIONS && GMDS__KNOWS_BARE)

#define GMDS__MAKES_NONE                                                                                              \
  GMDS_UNAVAILABLE(                                                                                                   \
      "gmds: model '" GMDS_TEXT(GMDS_PREFIX) "' cannot make regions: it does not tell their edges, faces "            \
                                             "or neighbours by nodes: add E2N where edges are kept, F2N where faces " \
                                             "are, R2N where R2R is stored")

/* ---- life */
static inline gmds_status mesh_init(mesh *m, const gmds_allocator *allocator);
static inline void mesh_clear(mesh *m);
static inline void empty(mesh *m);
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces, size_t regions);
static inline gmds_status trim(mesh *m);

/* Closes the holes; maps[i] receives the new identifiers of the i-cells. Constant when there is no hole, O(holes) for
 * regions of N|R|R2N|R2R of tetrahedra, else O(mesh). */
static inline gmds_status compact(mesh *m, gmds_id *maps[4]);

/* ---- cells: how many are alive; whether one is; the first from `id` on, or GMDS_NONE; one past the largest */
static inline size_t count_0(const mesh *m);
static inline size_t count_1(const mesh *m);
static inline size_t count_2(const mesh *m);
static inline size_t count_3(const mesh *m);
static inline int has_0(const mesh *m, gmds_id v);
static inline int has_1(const mesh *m, gmds_id e);
static inline int has_2(const mesh *m, gmds_id f);
static inline int has_3(const mesh *m, gmds_id r);
static inline gmds_id next_0(const mesh *m, gmds_id v);
static inline gmds_id next_1(const mesh *m, gmds_id e);
static inline gmds_id next_2(const mesh *m, gmds_id f);
static inline gmds_id next_3(const mesh *m, gmds_id r);
static inline size_t end_0(const mesh *m);
static inline size_t end_1(const mesh *m);
static inline size_t end_2(const mesh *m);
static inline size_t end_3(const mesh *m);
static inline gmds_memory *mesh_memory(mesh *m);

/* The three coordinates of a live node (not checked). */
static inline const double *point(const mesh *m, gmds_id v);
static inline void set_point(mesh *m, gmds_id v, const double *x);
static inline double *coordinates(mesh *m);

/* The type of a live region (not checked): GMDS_TETRAHEDRON to GMDS_POLYHEDRON. */
static inline gmds_cell_type region_type(const mesh *m, gmds_id r);

/* ---- attributes of the i-cells, i from 0 to 3 */
static inline gmds_status add_attribute(mesh *m, int i, const char *name, gmds_value type, size_t components,
                                        gmds_attribute **attribute);
static inline gmds_attribute *find_attribute(const mesh *m, int i, const char *name);
static inline void remove_attribute(mesh *m, int i, gmds_attribute *attribute);

/* ---- queries: get_adj_i_j(m, c, out) puts the j-cells incident or adjacent to the i-cell c into a list: a set. 0 -> 0
 * is being joined by an edge, kept or not; 1 -> 1 sharing a node; 2 -> 2 a side; 3 -> 3 a face. 2 -> 0 comes in order
 * around the face where GMDS_ORDERED_2_0, 3 -> 0 in the order of the type where GMDS_ORDERED_3_0; 3 -> 1 and 3 -> 2 in
 * the local order where they are stored. GMDS_OK; GMDS_ERR_CELL; GMDS_ERR_MEMORY (the list's content is lost).
 * all_adj_i_j(m, csr) does so for every i-cell at once: O(mesh). view_i_j(m, c, &n) shows a stored row where it lies.
 * What the model cannot answer, cannot decide, or does not store does not compile, and says what to add. */
#include <gmds/models/volume/declarations.h>

/* ---- creation
 *
 * Edges and faces are told by the set of their nodes: one that is there is found, and not made again. Regions make what
 * the model keeps of their edges and faces. Local where the model finds edges by N2E, faces by N2F or E2F, and regions
 * (for R2R) by N2R or F2R; else a traversal for each.
 *
 * Two faces with the same nodes in different orders around, as of a quadrilateral and one that crosses itself, cannot
 * stand beside each other: where the model keeps faces, or R2R, the second is refused with GMDS_ERR_CONFLICT, alone or
 * as a face of a region, in all calls that make or fill. (Where faces keep N2F alone no order is known, and the first
 * is found.) Models that keep neither do not compare regions with each other; manifold() finds such faces there. */
static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id);
static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first);

/* The edge between two nodes, found or made. In models that link edges and nodes. */
#if GMDS__LINKED_0_1
static inline gmds_status add_edge(mesh *m, gmds_id a, gmds_id b, gmds_id *id);
#endif

/* The face of n distinct nodes, listed around it, found or made. GMDS_OK; GMDS_ERR_ARGUMENT (n is not of the model's
 * types, or a node occurs twice); GMDS_ERR_CELL (a node that does not exist); GMDS_ERR_CONFLICT (one has these nodes in
 * another order); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. In models that link faces with nodes, or with edges that are
 * linked with nodes (GMDS_ADDS_FACES). */
#if GMDS_ADDS_FACES && GMDS__MAKES_FACES
static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id);
static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id);
static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);
#endif

/* A region of a type, its nodes in the order of shapes.h. GMDS_OK; GMDS_ERR_ARGUMENT (not a type of the model, or a
 * node occurs twice); GMDS_ERR_CELL; GMDS_ERR_CONFLICT (R2R holds two regions a face, this would be the third; or a
 * face is there with its nodes in another order); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. In models that can tell
 * edges and faces, if they keep any, by their nodes (GMDS_ADDS_REGIONS). Orientation is not checked. */
#if GMDS_ADDS_REGIONS
static inline gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id);
static inline gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);

/* The polyhedron that n faces bound. Also GMDS_ERR_ARGUMENT (fewer than four, one twice, or they do not close: an edge
 * is not on two of them). O(squares of the sides). */
#  if GMDS__POLYHEDRA
static inline gmds_status add_polyhedron(mesh *m, size_t n, const gmds_id *faces, gmds_id *id);
#  endif
#else
GMDS__MAKES_NONE gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id);
GMDS__MAKES_NONE gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);
#endif

/* ---- deletion
 *
 * bare: what becomes of the faces that bound no region and the edges that bound nothing afterwards, of those that the
 * cell had (topology.h). around: whether cells of higher dimension refuse the removal (GMDS_ERR_CONFLICT) or go first;
 * what these leave bare stays. GMDS_OK; GMDS_ERR_CELL; GMDS_ERR_CONFLICT; GMDS_ERR_UNSUPPORTED (the model cannot tell
 * what the cell has, or what is bare); GMDS_ERR_MEMORY. */
static inline gmds_status remove_region(mesh *m, gmds_id r, gmds_bare bare);

/* All regions of a list that the caller owns, or none. Also GMDS_ERR_CELL (one does not exist) and GMDS_ERR_ARGUMENT
 * (one is named twice). */
static inline gmds_status remove_regions(mesh *m, const gmds_ids *regions, gmds_bare bare);
#if GMDS__K_2
static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_around around, gmds_bare bare);
#endif
#if GMDS__K_1
static inline gmds_status remove_edge(mesh *m, gmds_id e, gmds_around around);
#endif
static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around);

/* ---- nodes and neighbours without a list
 *
 * How many sides a live face has (not checked). In models with GMDS_ORDERED_2_0. */
#if GMDS_ORDERED_2_0
static inline size_t face_sides(const mesh *m, gmds_id f);
#endif

/* The four nodes of a live tetrahedron in order (not checked). In models with GMDS_ORDERED_3_0 that hold tetrahedra. */
#if GMDS__HAS_TETRAHEDRA && GMDS_ORDERED_3_0
static inline void tetrahedron_nodes(const mesh *m, gmds_id r, gmds_id v[4]);
#endif

/* The region beyond face k of a live tetrahedron (not checked), or GMDS_NONE; *arrival is the number of the face there.
 * In models with GMDS_ACROSS. Constant. */
#if GMDS_ACROSS
static inline gmds_id across(const mesh *m, gmds_id r, unsigned k, unsigned *arrival);

/* The same for all faces of one that has a region beyond each: beyond[k] is 4 * region + the number of the face
 * there. */
static inline void across_all(const mesh *m, gmds_id r, gmds_id beyond[4]);
#endif

/* Tells the processor that what is stored of region r will be read. Nothing else; r need not be alive. */
static inline void prefetch_3(const mesh *m, gmds_id r);

/* The checksum of the regions (checksum.h). GMDS_OK or GMDS_ERR_MEMORY. O(mesh). */
#if GMDS__CAN_3_0
static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum);
#endif

/* ---- the cavity operator
 *
 * Replaces the tetrahedra ids[0 .. n_regions), a cavity, by the n_walls tetrahedra (node[0], node[1], node[2], apex) of
 * its walls (topology.h). The apex is a node that nothing is on. What the model keeps of edges and faces goes with the
 * cavity and comes with the star. ids, which has room for both, receives the tetrahedron on each wall; identifiers are
 * used again. That cavity and walls are what they are said to be is not checked. GMDS_OK; GMDS_ERR_MEMORY,
 * GMDS_ERR_TOO_MANY: where all regions are tetrahedra, R2N is stored and neither edges nor faces are kept, nothing has
 * changed; in other models the mesh is valid, but the cavity may be gone and a part of the star be there. In the former
 * the cost is that of the rows of the nodes and nothing is looked up in the mesh; in others it is that of
 * add_tetrahedron for each. In models that hold tetrahedra (GMDS_STARS). */
#if GMDS_STARS
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                               gmds_id *ids);
#endif

/* The same by several threads at once, in models in which a star writes nothing but the rows of its regions and the
 * entries that name them beyond its walls (GMDS_CONCURRENT_STARS: tetrahedra with R2N and R2R, no other relation, no
 * edges and no faces). Calls may run at the same time when their cavities and apexes differ, no region is in one cavity
 * and beyond a wall of another, and no other call changes the mesh; queries of regions that no star touches may run
 * beside them.
 *
 * take_regions: at most n regions, as many as there is room for without growing, numbered from *first on without a gap,
 * alive and without rows: until each has become part of a star, or was given back, queries and traversals must not meet
 * it. How many. O(n).
 * drop_regions: gives back regions [first, first + n) of which nothing is named by others.
 * star_of: the star of n_walls walls, at most GMDS_STAR_OF_WALLS, on the regions ids: those of the cavity and such
 * regions. Those of the cavity that are not among them are the caller's, as if taken. Nothing is checked, nothing
 * fails. */
#if GMDS_CONCURRENT_STARS
#  define GMDS_STAR_OF_WALLS 124
static inline size_t take_regions(mesh *m, size_t n, gmds_id *first);
static inline void drop_regions(mesh *m, gmds_id first, size_t n);
static inline void star_of(mesh *m, gmds_id apex, size_t n_walls, const gmds_cavity_wall *walls, const gmds_id *ids);
#endif

/* ---- the whole mesh
 *
 * Verifies every stored relation against the nodes of all cells, where the model can list them (GMDS_LISTS_CELLS), else
 * relations that are stored both ways against each other. GMDS_OK; GMDS_ERR_INVARIANT (`error` names the first
 * violation); GMDS_ERR_MEMORY. O(mesh). */
static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error);

/* Fills an empty mesh from a soup (volume.h): points become nodes; edges and faces that the soup lists come first, in
 * its order, then the faces of its polyhedra, then what the model keeps of the edges and faces of regions; lower cells
 * that the model does not keep are left out. Vertices, edges and faces with the same nodes are one; regions with the
 * same nodes are as many as are listed (manifold() finds them). GMDS_OK; GMDS_ERR_ARGUMENT (the mesh is not empty or
 * has attributes, and is unchanged; a cell has a node twice, or not as many as its type; the faces of a polyhedron do
 * not close; an attribute has a reserved name); GMDS_ERR_CELL (a point that does not exist); GMDS_ERR_UNSUPPORTED (a
 * type of cell that the model does not hold); GMDS_ERR_CONFLICT (R2R, and a third region on a face; a face listed in
 * two orders); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY: the sentence names the cell, the mesh is empty. O(soup). */
static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error);

/* Fills an empty mesh with a volume (volume.h) that a mesh of any model has listed: cells keep their identifiers, edges
 * and faces that this model keeps more come behind them (the volume has them too then), those that it does not keep are
 * left out. Statuses as from_soup. O(volume). */
static inline gmds_status set_volume(mesh *m, gmds_volume *volume, gmds_error *error);

#if GMDS_LISTS_CELLS
/* Lists what the mesh holds, attributes and holes included, for set_volume of any model. A tetrahedron whose order is
 * not stored is turned so that its volume is positive, and so are other regions that only know their faces
 * (gmds_shape_turn_outwards). GMDS_OK; GMDS_ERR_INVARIANT (the faces of a region do not make one of its type);
 * GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY: the volume is unchanged. O(mesh). */
static inline gmds_status get_volume(const mesh *m, gmds_volume *volume, gmds_error *error);

/* Writes the mesh into a soup of three coordinates (what it held is freed), renumbered without holes:
 * gmds_volume_to_soup. Statuses as get_volume, and GMDS_ERR_CONFLICT (attributes of one name and different types); the
 * soup is unchanged after a failure. O(mesh). */
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup, gmds_error *error);

/* Lists the nodes of all cells in a complex (complex.h) that is initialised and empty, and joins it: what algorithms
 * that look at a whole mesh ask once. Cells keep their identifiers and are turned as by get_volume. Statuses as
 * get_volume; after a failure the complex is empty. O(mesh). */
static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error);

/* Gives every cell another identifier: maps[i][c] is that of the live i-cell c, from 0 to count_i - 1, each once (not
 * checked), in four arrays. Attributes, coordinates and orders go along; no hole is left. Statuses as get_volume;
 * nothing has changed after a failure. O(mesh); the mesh is there twice in between, and as a volume. */
static inline gmds_status permute(mesh *m, gmds_id *const maps[4]);
#endif
