/* Files and made-up input. Numbers are read and written without regard to the locale; what is written reads back bit
 * for bit. A reader never trusts a count: each is held against the bytes that remain before anything is allocated.
 *
 * What stands beside points and cells becomes attributes of the soup: arrays of VTK and VTU in the type that holds
 * them; reference numbers of Medit as int "ref"; physical and geometrical tags of Gmsh as int "physical" and
 * "geometrical" (in version 4.1 the first group of the entity), its node and element data as doubles. Tags that are all
 * 0 make no attribute. What a soup has no place for is counted in `unread`: strings, fields of a whole grid and tables
 * of colours of VTK, names of groups and periodic links of Gmsh, corners and ridges of Medit, texture coordinates,
 * normals and groups of OBJ, lists of PLY that are not of points, what follows the points and faces of OFF and .node;
 * metadata and comments are not, nor what follows from the mesh. Prisms are taken over as they are listed, although
 * VTK's documents turn their triangles the other way than Medit's and Gmsh's: programs that write them do the same. */
#ifndef GMDS_IO_H
#define GMDS_IO_H

#include <gmds/soup.h>

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, extension, text) */
#define GMDS_FORMAT_LIST(X)                               \
  X(GMDS_FORMAT_OFF, ".off", "OFF")                       \
  X(GMDS_FORMAT_OBJ, ".obj", "OBJ")                       \
  X(GMDS_FORMAT_PLY, ".ply", "PLY")                       \
  X(GMDS_FORMAT_STL, ".stl", "STL")                       \
  X(GMDS_FORMAT_VTK, ".vtk", "VTK legacy")                \
  X(GMDS_FORMAT_VTU, ".vtu", "VTU")                       \
  X(GMDS_FORMAT_MEDIT, ".mesh", "Medit")                  \
  X(GMDS_FORMAT_MESHB, ".meshb", "binary Medit")          \
  X(GMDS_FORMAT_GMSH, ".msh", "Gmsh")                     \
  X(GMDS_FORMAT_NODE, ".node", "Triangle points")         \
  X(GMDS_FORMAT_F64, ".f64", "raw little-endian doubles") \
  X(GMDS_FORMAT_TEXT, ".txt", "points as text")

#define GMDS_FORMAT_ENUM_(name, extension, text) name,
typedef enum gmds_format { GMDS_FORMAT_LIST(GMDS_FORMAT_ENUM_) GMDS_FORMAT_COUNT } gmds_format;
#undef GMDS_FORMAT_ENUM_

/* The format that the extension of `path` stands for (any case; .xy, .xyz and .csv are text too).
 * GMDS_OK or GMDS_ERR_UNSUPPORTED (the sentence lists the extensions known). */
gmds_status gmds_format_of_path(const char *path, gmds_error *error, gmds_format *format);

/* Reads a mesh file, its format taken from the extension (point formats give a soup without cells).
 *   dim        2 or 3: points get that many coordinates; 0: as many as are needed (3 when any third one is not 0 or
 *              there is a cell of dimension 3, else 2). From 3 to 2 the third coordinate must be 0 and no cell of
 *              dimension 3, unless the file holds points only, whose third coordinate is dropped
 * GMDS_OK; GMDS_ERR_OPEN, _READ, _FORMAT, _COORDINATE (NaN or infinity), _UNSUPPORTED (curved cells, and VTU where the
 * library was built without Expat, or without zlib and the file is compressed, among others), _TOO_MANY, _MEMORY, and
 * _ARGUMENT (another dim, raw doubles with dim 0, a soup that is not empty). `error` names file, line (or byte) and
 * what was expected. The soup must be initialised and empty; on failure it stays so. On success soup->dim is what came
 * out and its arrays have no room to spare. */
gmds_status gmds_read_soup(const char *path, int dim, gmds_error *error, gmds_soup *soup);

/* The same for the n bytes of a file that is in memory; `name` stands for the file in sentences. */
gmds_status gmds_read_soup_from_memory(gmds_format format, const char *name, const void *bytes, size_t n, int dim,
                                       gmds_error *error, gmds_soup *soup);

/* How a file is written, where its format leaves a choice. Zero-initialised: as is usual for the format. */
typedef enum gmds_encoding { GMDS_ENCODING_USUAL, GMDS_ENCODING_TEXT, GMDS_ENCODING_BINARY } gmds_encoding;

typedef struct gmds_write_options {
  gmds_encoding
      encoding; /* PLY, STL, VTK legacy, Gmsh: text unless asked; VTU: base64 unless asked; the rest: no choice */
  int version;  /* ten times the format's: VTK legacy 30 or 51, Gmsh 41 or 22; 0: the first of these (Gmsh:
                             the second where cells of one geometrical tag have several physical ones) */
} gmds_write_options;

/* Writes a mesh file, its format taken from the extension, under a temporary name in the same folder first: on failure
 * nothing stays under `path` that was not there before. A symbolic link is replaced by the file.
 *   options   may be NULL
 * GMDS_OK; GMDS_ERR_OPEN, _WRITE, _UNSUPPORTED (a cell that the format cannot hold; an encoding or version in which it
 * is not written), _COORDINATE (NaN or infinity, which no reader takes), _MEMORY. Medit lists cells by type, so their
 * order may change; STL has the points of its triangles alone, equal ones once, and in binary refuses coordinates that
 * are no floats; every other order is kept. An attribute is left out where gmds_format_holds says 0. */
gmds_status gmds_write_soup(const char *path, const gmds_soup *soup, gmds_error *error);
gmds_status gmds_write_soup_as(const char *path, const gmds_soup *soup, const gmds_write_options *options,
                               gmds_error *error);

/* Whether a file of this format has a place for an attribute of the soup: VTK legacy and VTU for every one (VTU: whose
 * name is UTF-8 without control characters); Medit for the reference numbers of points and cells, one int "ref"; Gmsh
 * for the tags of cells, one int "physical" and one "geometrical", and for what has 1, 3 or 9 components that a double
 * holds; PLY for what has one component, no blank in its name, and a type that PLY has (no long); others for none.
 * O(points or cells). */
int gmds_format_holds(gmds_format format, const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute);

/* The points that SPEC stands for: `random:N:SEED`, `grid:N` (N points a side), `circle:N` (N points about a circle,
 * rounded to doubles), `clusters:N:SEED`, or the points of a file of any format. dim: 2 or 3. Coordinates are drawn as
 * a 64-bit Mersenne twister and the usual map to [0, 1) give them, so that other programs can make the same points.
 * Status, error and soup as gmds_read_soup; GMDS_ERR_ARGUMENT for a SPEC of the wrong form. */
gmds_status gmds_make_points(const char *spec, int dim, gmds_error *error, gmds_soup *soup);

/* The surface that SPEC stands for, of points with three coordinates: `torus:N` (N >= 3: N² points, 2N² triangles),
 * `sphere:N` (N >= 2: 2N(N - 1) + 2 points, 4N(N - 1) triangles), all turned outwards, or the mesh of a file of any
 * format. Status, error and soup as gmds_read_soup; GMDS_ERR_ARGUMENT for a SPEC of the wrong form. */
gmds_status gmds_make_surface(const char *spec, gmds_error *error, gmds_soup *soup);

#ifdef __cplusplus
}
#endif
#endif
