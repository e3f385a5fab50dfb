/* A mesh of volumes without its model: points, cells with their attributes, and the nodes of every cell. Meshes of
 * different models are converted through it (<prefix>_get_volume and <prefix>_set_volume, models/volume/interface.h),
 * soups become meshes, and meshes soups. */
#ifndef GMDS_VOLUME_H
#define GMDS_VOLUME_H

#include <gmds/cells.h>
#include <gmds/complex.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Owned by the caller. */
typedef struct gmds_volume {
  gmds_memory *memory; /* where everything comes from; outlives the volume */
  gmds_cells cells[4]; /* which are alive, and their attributes */
  double *points;      /* 3 a node, cells[0].capacity of them */
  gmds_complex complex;
} gmds_volume;

/* Holds nothing. Allocates nothing. */
void gmds_volume_init(gmds_volume *volume, gmds_memory *memory);
void gmds_volume_clear(gmds_volume *volume);

/* Makes `to`, which has neither cells nor attributes, the same as `from`: identifiers, holes and attributes, with room
 * for as many cells as `from` has below its end. GMDS_OK; GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (it may have
 * attributes). */
gmds_status gmds_cells_copy(const gmds_cells *from, gmds_cells *to);

/* The same under other identifiers: maps give each live cell its own, from 0 to the count, each once (not checked); no
 * hole is left. The other volume, or cells, hold nothing. A complex that was joined is not joined there.
 * GMDS_OK; GMDS_ERR_MEMORY or GMDS_ERR_TOO_MANY (the volume is empty; the cells may have attributes). O(what there
 * is). */
gmds_status gmds_cells_copy_as(const gmds_cells *from, const gmds_id *map, gmds_cells *to);
gmds_status gmds_volume_copy_as(const gmds_volume *from, gmds_id *const maps[4], gmds_volume *to);

/* What the names of attributes begin with by which a mesh remembers how a soup listed its cells. A soup that is made a
 * volume has none such; what a mesh has under such a name is not written, but for what it stands for. */
#define GMDS_RESERVED "gmds:"

/* The attribute (GMDS_INT) by which a mesh remembers how often a soup that it was made from listed each of its nodes,
 * edges and faces as a cell. Where it is there, others are not written back. Another attribute, `gmds:turn 2` and so
 * on, says how the nodes were turned the second time. */
#define GMDS_LISTED GMDS_RESERVED "listed"

/* Fills a volume that holds nothing with the points and cells of a soup: vertices, segments, faces and regions.
 * Vertices, segments and faces with the same nodes are one cell, whose nodes are in the order of the first. Attributes
 * of points become those of nodes, attributes of cells those of every dimension of which the soup has cells; what a
 * second cell with the same nodes had goes into an attribute gmds:NAME (2), of a third into gmds:NAME (3), what
 * vertices had as cells into gmds:vertex NAME and gmds:again NAME (2). Regions are not compared. A soup of two
 * coordinates gets a third, 0. GMDS_OK; GMDS_ERR_ARGUMENT (a cell has a node twice, or not as many as its type; the
 * faces of a polyhedron do not close; an attribute has a name that is reserved or longer than 480 bytes), GMDS_ERR_CELL
 * (a point that does not exist), GMDS_ERR_CONFLICT (a face is listed in different orders around), all with a sentence
 * that names it; GMDS_ERR_MEMORY, GMDS_ERR_TOO_MANY. O(soup). */
gmds_status gmds_volume_from_soup(gmds_volume *volume, const gmds_soup *soup, gmds_error *error);

/* The reverse, into a soup that is initialised for three coordinates and empty: nodes, then the cells of each dimension
 * in their order, from 0 up. Nodes that are no listed vertices are points alone; edges and faces are written as often
 * as they were listed, or, where nothing is, when they bound nothing. The complex is joined.
 * GMDS_OK; GMDS_ERR_CONFLICT (attributes of one name and different types; `error` names it), GMDS_ERR_MEMORY,
 * GMDS_ERR_TOO_MANY. The soup stays empty after a failure. O(volume). */
gmds_status gmds_volume_to_soup(gmds_volume *volume, gmds_soup *soup, gmds_error *error);

#ifdef __cplusplus
}
#endif
#endif
