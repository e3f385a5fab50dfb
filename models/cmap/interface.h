/* What a combinatorial map can do: the functions of a model opened with GMDS_BACKEND GMDS_CMAP, each under the model's
 * prefix (map3_mesh_init, map3_sew, ...). n stands for GMDS_DIM. Defined before <gmds/mesh.h> is included:
 *
 *     GMDS_PREFIX map3
 *     GMDS_BACKEND GMDS_CMAP
 *     GMDS_DIM 3                             2, 3 or 4
 *     GMDS_MODEL (N|R)                       cells that are numbered and may have attributes: N always, E, F, R; DIM2
 *                                            or DIM3: coordinates of a node (else 2 in a 2-map, 3 in others)
 *
 * A map is a set of darts and its links (map.h: definitions, after [dmaps] 2.1 and Damiand and Lienhardt, Combinatorial
 * Maps, 2014). A dart takes n + 1 identifiers and one more for each kind of cell that is kept, 4 bytes each, and a bit;
 * a cell takes one, and a bit; a node its coordinates. GMDS_NONE stands for the link of a free dart.
 *
 * Darts and cells are numbered from 0 each, with holes after deletions. All darts of an orbit carry the same cell, and
 * each cell belongs to one orbit: calls keep that true, link and unlink do not (restore_cells repairs it). Unless said
 * otherwise a call that is given a dart or a cell that is not alive refuses with GMDS_ERR_CELL, everything is tested
 * before anything is changed, and a call that fails has changed nothing. Calls on a const map may run at the same time,
 * each with lists of its own; marks are bit arrays of the caller (bits.h). What costs O(cells) costs the sizes of the
 * cells around. */

typedef struct mesh mesh;

/* ---- life: as of meshes of stored relations (models/incidence/interface.h)

 * reserve makes room for this many cells in all, and for darts as if faces were triangles (regions tetrahedra);
 * reserve_darts for darts. trim gives back what is not used. compact closes the holes among cells and darts: maps[i]
 * and dart_map, which may be NULL as maps may, receive the new identifiers. permute gives cells other numbers.
 * GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. */
static inline gmds_status mesh_init(mesh *m, const gmds_allocator *allocator);
static inline void mesh_clear(mesh *m);
static inline void empty(mesh *m);
#if GMDS__N == 2
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces);
#else
static inline gmds_status reserve(mesh *m, size_t nodes, size_t edges, size_t faces, size_t regions);
#endif
static inline gmds_status reserve_darts(mesh *m, size_t darts);
static inline gmds_status trim(mesh *m);
static inline gmds_status compact(mesh *m, gmds_id **maps);
static inline gmds_status compact_darts(mesh *m, gmds_id **maps, gmds_id *dart_map);
static inline gmds_status permute(mesh *m, gmds_id *const *maps);
static inline gmds_memory *mesh_memory(mesh *m);

/* Bytes that each dart takes, but for its bit: known at compile time. */
static inline size_t bytes_per_dart(void);

/* ---- darts and cells: how many; whether one is alive; the first from `id` on, or GMDS_NONE; one past the largest. Of
 * cells that are not kept there is none. */
static inline size_t count_darts(const mesh *m);
static inline int has_dart(const mesh *m, gmds_id d);
static inline gmds_id next_dart(const mesh *m, gmds_id d);
static inline size_t end_darts(const mesh *m);
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

/* How many i-cells there are, kept or not, i from 0 to n. Working space from `memory`. GMDS_OK; GMDS_ERR_ARGUMENT;
 * GMDS_ERR_MEMORY. O(map). */
static inline gmds_status count_cells(const mesh *m, int i, gmds_memory *memory, size_t *count);

/* The coordinates of a live node, and of all (not checked). */
static inline const double *point(const mesh *m, gmds_id v);
static inline void set_point(mesh *m, gmds_id v, const double *x);
static inline double *coordinates(mesh *m);

/* ---- attributes of the cells that are kept (cells.h). on_change says what becomes of values when two cells become one
 * and when one becomes two (map.h; NULL: the first's value stays, both have it). GMDS_OK; GMDS_ERR_ARGUMENT (i-cells
 * are not kept, no name, ...); GMDS_ERR_CONFLICT (the name is taken); GMDS_ERR_MEMORY. */
static inline gmds_status add_attribute(mesh *m, int i, const char *name, gmds_value type, size_t components,
                                        gmds_attribute **attribute);
static inline gmds_attribute *find_attribute(const mesh *m, int i, const char *name);
static inline void remove_attribute(mesh *m, int i, gmds_attribute *attribute);
static inline gmds_status on_change(mesh *m, int i, const gmds_attribute *attribute, gmds_merge merge, gmds_split split,
                                    void *user);

/* ---- links (d is alive, i in range: not checked)

 * beta_i(d), i from 0 to n, or GMDS_NONE; the i-cell of d, i from 0 to 3, GMDS_NONE where i-cells are not kept; a dart
 * of an i-cell that is kept, GMDS_NONE of a node that no dart has. Constant. */
static inline gmds_id beta(const mesh *m, int i, gmds_id d);
static inline int is_free(const mesh *m, int i, gmds_id d);
static inline gmds_id cell_of(const mesh *m, int i, gmds_id d);
static inline gmds_id dart_of(const mesh *m, int i, gmds_id c);

/* The darts of an orbit into a list of the caller, d first: of the i-cell of d, i from 0 to n, kept or not; under a set
 * of betas (GMDS_BETA(1) | GMDS_BETA(3), ...). A loop over one dart a cell goes over the darts with a bit array of its
 * own and sets the bits of each orbit, or, of cells that are kept, over next_i and dart_of.
 * GMDS_OK; GMDS_ERR_CELL; GMDS_ERR_ARGUMENT; GMDS_ERR_MEMORY (the list's content is lost). O(orbit). */
static inline gmds_status cell_darts(const mesh *m, int i, gmds_id d, gmds_ids *list);
static inline gmds_status orbit(const mesh *m, gmds_id d, unsigned betas, gmds_ids *list);

/* ---- elementary changes

 * One dart that is free everywhere, a cell of its own in each dimension that is kept; n of them. remove_dart refuses
 * one that is not free (GMDS_ERR_CONFLICT). */
static inline gmds_status add_dart(mesh *m, gmds_id *d);
static inline gmds_status remove_dart(mesh *m, gmds_id d);

/* beta_i(d) = e and its inverse, nothing else: the map need not be one afterwards, and cells are not what orbits say
 * until restore_cells has been called. i from 1 to n. GMDS_OK; GMDS_ERR_ARGUMENT (no such i, d == e for i > 1);
 * GMDS_ERR_CELL; GMDS_ERR_CONFLICT (d or e is not free, or, to unlink, d is). */
static inline gmds_status link(mesh *m, int i, gmds_id d, gmds_id e);
static inline gmds_status unlink(mesh *m, int i, gmds_id d);

/* Gives each orbit one cell: the first that its darts had and no orbit before it has, else a new one with the values of
 * that; cells that are left over go. GMDS_OK; GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. O(map). */
static inline gmds_status restore_cells(mesh *m);

/* Sews d with e for beta_i, i from 1 to n, and with them all that must go along: the orbits of both under the betas
 * that do not touch i - 1, i, i + 1 are isomorphic and free (Damiand and Lienhardt 2014, chapter 6). Cells that meet
 * become one. unsew takes the links of such an orbit apart; cells that fall apart become two.
 * GMDS_OK; GMDS_ERR_ARGUMENT; GMDS_ERR_CELL; GMDS_ERR_CONFLICT (not sewable; to unsew, free); GMDS_ERR_MEMORY;
 * GMDS_ERR_TOO_MANY. O(cells). is_sewable takes its working space from `memory`. */
static inline gmds_status is_sewable(const mesh *m, int i, gmds_id d, gmds_id e, gmds_memory *memory, int *sewable);
static inline gmds_status sew(mesh *m, int i, gmds_id d, gmds_id e);
static inline gmds_status unsew(mesh *m, int i, gmds_id d);

/* ---- making cells, sewn with nothing, with nodes, edges, faces and regions of their own

 * x: one row of coordinates a node, or NULL: the origin. An edge is two darts, 2-sewn and 1-sewn with each other. A
 * polygon has k nodes; d receives its dart 0, from node 0 to node 1. GMDS_OK; GMDS_ERR_ARGUMENT (k < 3);
 * GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. */
static inline gmds_status make_edge(mesh *m, const double *x, gmds_id *d);
static inline gmds_status make_polygon(mesh *m, size_t k, const double *x, gmds_id *d);

/* Nodes, and faces, in the order of shapes.h: d receives the first dart of face 0. A polyhedron has n_nodes nodes and
 * n_faces faces, face k around corners[begin[k]] to corners[begin[k + 1] - 1], local numbers from 0, all turned alike
 * (outwards). Also GMDS_ERR_ARGUMENT: a face of fewer than three, a node on no face, or the faces are no closed surface
 * in one piece: every edge on two of them, once each way, and those at a node one fan. In maps of dimension 3 or more.
 * */
#if GMDS__N > 2
static inline gmds_status make_tetrahedron(mesh *m, const double *x, gmds_id *d);
static inline gmds_status make_pyramid(mesh *m, const double *x, gmds_id *d);
static inline gmds_status make_prism(mesh *m, const double *x, gmds_id *d);
static inline gmds_status make_hexahedron(mesh *m, const double *x, gmds_id *d);
static inline gmds_status make_polyhedron(mesh *m, size_t n_nodes, const double *x, size_t n_faces, const size_t *begin,
                                          const gmds_id *corners, gmds_id *d);
#endif

/* The same upon nodes that exist, the darts sewn with nothing. Where the nodes had darts, cells are not what orbits say
 * until match_nodes and restore_cells have been called. Also GMDS_ERR_CELL (a node that does not exist),
 * GMDS_ERR_ARGUMENT (one twice). */
static inline gmds_status place_polygon(mesh *m, size_t k, const gmds_id *nodes, gmds_id *d);
#if GMDS__N > 2
static inline gmds_status place_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *d);
#endif

/* Sews all edges of faces (n = 2), or faces of volumes (n = 3), that two of them have in common and that turn against
 * each other there, all at once: told by their nodes, or by equal coordinates (-0 and +0 are equal). A third one stays
 * free. Cells that meet become one: the smallest number stays. *sewn, which may be NULL, receives how many. GMDS_OK;
 * GMDS_ERR_MEMORY. Expected O(map), whatever the order. */
#if GMDS__N < 4
static inline gmds_status match_nodes(mesh *m, size_t *sewn);
static inline gmds_status match_points(mesh *m, size_t *sewn);
#endif

/* ---- operations. All change nothing when they are refused (GMDS_ERR_CONFLICT). O(cells).

 * A node in the edge of d, at x (NULL: the origin): *made receives the dart after d, whose origin it is. */
static inline gmds_status insert_vertex_in_edge(mesh *m, gmds_id d, const double *x, gmds_id *made);

/* A node in the face of d, joined with its nodes: k faces of three sides; *made begins at the new node. Refused where
 * the face is open (a dart is 1-free). */
static inline gmds_status insert_vertex_in_face(mesh *m, gmds_id d, const double *x, gmds_id *made);

/* An edge across the face of d, from the origin of d to that of e; *made is its dart from the origin of d. Refused
 * unless both are different darts of one closed face, on the same side of it. */
static inline gmds_status insert_edge_in_face(mesh *m, gmds_id d, gmds_id e, gmds_id *made);

/* An edge into the face of d from the origin of d to a new node at x; *made begins at the origin of d. Refused where d
 * is 0-free. */
static inline gmds_status insert_dangling_edge(mesh *m, gmds_id d, const double *x, gmds_id *made);

/* A face across a volume of a 3-map, along a closed path of n darts of it: dart k ends at the node where dart k + 1
 * begins. *made is a dart of the face, beta_2 of path[0]. Refused unless the path is one, each dart of it once. */
#if GMDS__N == 3
static inline gmds_status insert_face_in_volume(mesh *m, size_t n, const gmds_id *path, gmds_id *made);
#endif

/* Removal of the i-cell of d, i from 0 to n - 1: the (i+1)-cells around it become one. An i-cell can be removed when i
 * is n - 1, or when no more than two (i+1)-cells are around it ([homology] 3.1, Damiand and Lienhardt 2014, chapter 6).
 * Contraction, i from 1 to n: its (i-1)-cells become one; possible when i is 1, or no more than two (i-1)-cells are on
 * it. GMDS_ERR_CONFLICT where it is not, or where faces around it are open and what is left would be no map;
 * GMDS_ERR_ARGUMENT (no such i). */
static inline gmds_status is_removable(const mesh *m, int i, gmds_id d, gmds_memory *memory, int *removable);
static inline gmds_status remove_cell(mesh *m, int i, gmds_id d);
static inline gmds_status is_contractible(const mesh *m, int i, gmds_id d, gmds_memory *memory, int *contractible);
static inline gmds_status contract_cell(mesh *m, int i, gmds_id d);

/* Adds i-cells, i from 2 to n, beyond all that is i-free, one for each piece of border; *made, which may be NULL,
 * receives how many darts. Refused (GMDS_ERR_CONFLICT) where a dart on the border is free for a smaller beta. O(map).
 * */
static inline gmds_status close(mesh *m, int i, size_t *made);

/* ---- the whole map

 * Verifies the axioms of an n-map (inverse, involutions, no fixed points of these, beta_j after beta_i an involution
 * for j >= i + 2), then that cells are orbits. GMDS_OK; GMDS_ERR_INVARIANT: `error` says it in a sentence, `report`
 * (either may be NULL) names rule, dart, what was expected and what found (map.h); GMDS_ERR_MEMORY. O(map). */
static inline gmds_status check(const mesh *m, gmds_memory *memory, gmds_error *error);
static inline gmds_status check_map(const mesh *m, gmds_memory *memory, gmds_map_report *report, gmds_error *error);

/* Whether there is a bijection of darts that keeps all betas, and, if asked for, the coordinates of origins. O(map)
 * where what distinguishes darts is near them; for maps that look alike everywhere each pair of components O(darts
 * squared) at worst. components counts the pieces. GMDS_OK or GMDS_ERR_MEMORY. */
static inline gmds_status is_isomorphic(const mesh *m, const mesh *other, int with_points, gmds_memory *memory,
                                        int *same);
static inline gmds_status components_of_darts(const mesh *m, gmds_memory *memory, size_t *count);

/* A number that isomorphic maps have in common, whatever their numbering: from what is around each dart, two steps far
 * with coordinates, sixteen without, summed over all (refinement as of Weisfeiler and Leman, 1968). Maps that are
 * regular everywhere, without coordinates, may have the same and be different. GMDS_OK or GMDS_ERR_MEMORY. O(map). */
static inline gmds_status dart_checksum(const mesh *m, int with_points, gmds_memory *memory, uint64_t *sum);

/* The map as bytes that any machine reads: darts and cells numbered without holes, links, coordinates, attributes of
 * cells; version 1. `bytes` (its memory set) is replaced. read_bytes fills an empty map without attributes, of the same
 * dimension, coordinates and kept cells, and verifies all: GMDS_OK; GMDS_ERR_ARGUMENT (the map is not empty);
 * GMDS_ERR_FORMAT (not such bytes: the sentence says which); GMDS_ERR_UNSUPPORTED (of another kind of map, or version);
 * GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. O(map). */
static inline gmds_status write_bytes(const mesh *m, gmds_map_bytes *bytes);
static inline gmds_status read_bytes(mesh *m, size_t n, const unsigned char *data, gmds_error *error);

/* ---- as a model: queries between cells that are kept, by orbits

 * get_adj_i_j puts the j-cells incident (i != j) or adjacent to i-cell c into a list: a set; 2 -> 0 and 2 -> 1 in order
 * around the face, from its dart on. 0 -> 0 is being joined by an edge, 1 -> 1 sharing a node, 2 -> 2 an edge, 3 -> 3 a
 * face. all_adj_i_j does so for every i-cell. GMDS_OK; GMDS_ERR_CELL; GMDS_ERR_MEMORY. O(cells), sorting included;
 * O(map). A query of cells that are not kept does not compile and says what to keep. */
#include <gmds/models/cmap/declarations.h>

/* Nodes without darts. */
static inline gmds_status add_node(mesh *m, const double *x, gmds_id *id);
static inline gmds_status add_nodes(mesh *m, size_t n, const double *x, gmds_id *first);

/* A node and all n-cells at it (GMDS_CASCADE; other nodes stay), or refused while a dart begins there (GMDS_REFUSE,
 * GMDS_ERR_CONFLICT). */
static inline gmds_status remove_node(mesh *m, gmds_id v, gmds_around around);

/* A face of a 2-map upon n distinct nodes, 2-sewn with what is at its sides. GMDS_OK; GMDS_ERR_ARGUMENT; GMDS_ERR_CELL;
 * GMDS_ERR_CONFLICT (a side has two faces, or one that turns the same way there; or a node would have two fans: add the
 * faces of a fan one beside the other, or all at once by add_faces); GMDS_ERR_MEMORY; GMDS_ERR_TOO_MANY. O(darts at its
 * nodes). add_faces adds many, as models/incidence/interface.h says, in a map without darts; nodes whose faces make
 * several fans are split, one for each: the first keeps its number. GMDS_ERR_CONFLICT: *failed cannot be sewn. O(map).
 * */
#if GMDS__N == 2
static inline gmds_status add_face(mesh *m, size_t n, const gmds_id *nodes, gmds_id *id);
static inline gmds_status add_triangle(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id *id);
static inline gmds_status add_quadrilateral(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);
#endif
#if GMDS__N == 2 && GMDS__K_2
static inline gmds_status remove_face(mesh *m, gmds_id f, gmds_edges edges);
#endif

/* The same of regions in a 3-map: 3-sewn with what is at their faces. Regions that share an edge or a node but no face,
 * also by way of others, are refused. */
#if GMDS__N == 3
static inline gmds_status add_region(mesh *m, gmds_cell_type type, const gmds_id *nodes, gmds_id *id);
static inline gmds_status add_tetrahedron(mesh *m, gmds_id a, gmds_id b, gmds_id c, gmds_id d, gmds_id *id);
#endif
#if GMDS__N == 3 && GMDS__K_3
static inline gmds_status remove_region(mesh *m, gmds_id r, gmds_bare bare);
#endif

/* Sides: side k of a face is its k-th dart, from that of the face on. As models/incidence/interface.h; face_beside and
 * across in 2-maps. O(k). */
#if GMDS__K_2
static inline size_t face_sides(const mesh *m, gmds_id f);
static inline gmds_id side_dart(const mesh *m, gmds_id f, size_t k);
static inline gmds_id face_node(const mesh *m, gmds_id f, size_t k);
static inline void triangle_nodes(const mesh *m, gmds_id f, gmds_id v[3]);
static inline gmds_status prepare_2_0(const mesh *m, gmds_csr *csr);
static inline const gmds_id *read_2_0(const mesh *m, const gmds_csr *csr, gmds_id f, size_t *n);
static inline gmds_status prepare_0_2(const mesh *m, gmds_csr *csr);
static inline const gmds_id *read_0_2(const mesh *m, const gmds_csr *csr, gmds_id v, size_t *n);
static inline gmds_status all_edges(const mesh *m, gmds_edge_table *table);
#endif
#if GMDS_ACROSS
static inline gmds_id face_beside(const mesh *m, gmds_id f, size_t k);
static inline gmds_id across(const mesh *m, gmds_id f, unsigned k, unsigned *arrival);
#endif
static inline void prefetch_3(const mesh *m, gmds_id r);

/* The cavity operator of models/incidence/interface.h (2-maps with F) and of models/volume/interface.h (3-maps with R,
 * without E and F; the cavity and its neighbours are tetrahedra): the darts of the cavity are used again, those of a
 * triangle together. That cavity and boundary are what they are said to be is not checked. A failure changes nothing.
 * */
#if GMDS__N == 2 && GMDS__K_2
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_faces, const gmds_cavity_face *faces, size_t n_sides,
                               const gmds_cavity_side *sides, gmds_id *ids);
#elif GMDS_STARS
static inline gmds_status star(mesh *m, gmds_id apex, size_t n_regions, size_t n_walls, const gmds_cavity_wall *walls,
                               gmds_id *ids);
#endif

/* ---- from and to other models, by way of gmds_soup, gmds_volume and gmds_complex; checksum is that of the cells of
 * the highest dimension (checksum.h), as of any model. In 2-maps with F and 3-maps with R.
 *
 * from_soup fills an empty map without attributes: points become nodes; faces (n = 2), regions (n = 3) become cells,
 * cells of other dimensions are kept where a kept cell has their nodes (their attributes with them), else left out.
 * Cells that turn against the first of their component are turned; nodes whose cells make several fans (pinched), and
 * edges, are split, one for each. GMDS_ERR_CONFLICT: a side (face) has three cells, or the cells cannot be turned
 * alike: the sentence names two; GMDS_ERR_UNSUPPORTED: a third coordinate that is not 0 where nodes have two; else as
 * models/volume/interface.h. to_soup writes nodes and cells. Attributes go along both ways. */
#if GMDS_LISTS_CELLS
static inline gmds_status from_soup(mesh *m, const gmds_soup *soup, gmds_error *error);
#  if GMDS__N == 2
static inline gmds_status add_faces(mesh *m, size_t n, const size_t *begin, const gmds_id *nodes, size_t *failed);
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup);
#  else
static inline gmds_status to_soup(const mesh *m, gmds_soup *soup, gmds_error *error);
#  endif
static inline gmds_status write_soup(const mesh *m, gmds_soup *soup, gmds_error *error);
static inline gmds_status get_complex(const mesh *m, gmds_complex *complex, gmds_error *error);
static inline gmds_status get_volume(const mesh *m, gmds_volume *volume, gmds_error *error);
static inline gmds_status set_volume(mesh *m, gmds_volume *volume, gmds_error *error);
static inline gmds_status checksum(const mesh *m, gmds_memory *memory, uint64_t *sum);
#endif
