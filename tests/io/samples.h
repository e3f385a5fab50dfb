/* A small valid file of every format, from which tests cut, in which they change bytes, and for which they refuse
 * memory. */
#ifndef GMDS_TESTS_SAMPLES_H
#define GMDS_TESTS_SAMPLES_H

#include "samples_vtu.h"
#include "soup_tools.h"

typedef struct sample {
  const char *text;
  gmds_format format;
  int dim;
  int counted; /* its end can be told: a file that is cut is refused */
  size_t n;    /* of bytes */
  char bytes[2000];
} sample;

#define SAMPLE_OFF                                                                             \
  "OFF # a square pyramid and a loose polygon\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1e0\n" \
  "4 0 3 2 1 255 0 0\n3 0 1 4\n5 0 1 2 3 4 0.5 0.5 0.5 1\n3 1 2 4\n"

#define SAMPLE_OBJ                                                                                                  \
  "# a square and more\nmtllib m.mtl\no square\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 .5\nvt 0 0\nvn 0 0 1\ng a b\n" \
  "usemtl red\ns 1\nf 1/1 2/1/1 3//1 4\nf -1 -2 \\\n-3\nl 1 2 3\np 4\nv 2 2 2\nf 1 2 3 4 5\n"

#define SAMPLE_PLY                                                                                                   \
  "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" \
  "property uchar red\nproperty list uchar int odd\nelement face 2\nproperty double q\n"                             \
  "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"             \
  "property double q\nelement tristrips 1\nproperty list int int vertex_index\nelement other 2\nproperty short a\n"  \
  "end_header\n0 0 0 1 0\n1 0 0 2 1 5\n1 1 0 3 0\n0 1 1 255 0\n0.5 4 0 1 2 3\nnan 3 0 1 2\n3 1 7.5\n7 0 1 2 3 -1 2 " \
  "3\n"                                                                                                              \
  "1\n2\n"

#define SAMPLE_STL                                                                                                    \
  "solid two\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"          \
  "facet normal nan 0 0\nouter loop\nvertex -0 1 0\nvertex 1 0 0\nvertex 1 1 2\nendloop\nendfacet\nfacet normal 0 0 " \
  "0\n"                                                                                                               \
  "outer loop\nvertex 1 1 2\nvertex 1 0 0\nvertex 1 0 -0\nendloop\nendfacet\nendsolid two\nsolid\nendsolid\n"

#define SAMPLE_MEDIT                                                                                            \
  "MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n1 0 1 1\n0 1 1 1\n"     \
  "Corners 2 1 2\nEdges 1\n1 2 7\nTriangles 1\n1 2 3 7\nQuadrilaterals 1\n1 2 5 4 0\nTetrahedra 1\n1 2 3 4 0\n" \
  "Pyramids 1\n1 2 5 4 3 0\nPrisms 1\n1 2 3 4 5 6 0\nNormals 1 0 0 1\nEnd\n"

#define SAMPLE_VTK                                                                                                    \
  "# vtk DataFile Version 3.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n0 0 0 1 0 0 1 1 0 0 1 0\n" \
  ".5 .5 1\nCELLS 4 17\n5 0 1 2 3 4\n4 0 1 2 3\n3 0 1 2\n1 4\nCELL_TYPES 4\n14 9\n5\n1\n"

#define SAMPLE_VTK_5                                                                                           \
  "# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\nMETADATA\n" \
  "INFORMATION 0\n\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 2 3\n"     \
  "POINT_DATA 4\nSCALARS s float\nLOOKUP_TABLE default\n1 2 3 nan\nVECTORS v int\n1 1 1 2 2 2 3 3 3 4 4 4\n"   \
  "CELL_DATA 2\nFIELD f 2\na 1 2 int\n1 2\nb 2 1 string\none\ntwo\n"

#define SAMPLE_VTK_POLYHEDRON                                                                                        \
  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n" \
  "CELLS 2 23\n17 4 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3\n4 0 1 2 4\nCELL_TYPES 2\n42 10\nCELL_DATA 2\n"                  \
  "SCALARS a%20b unsigned_char 2\nLOOKUP_TABLE t\n1 2 255 0\nLOOKUP_TABLE t 1\n0 0 0 1\nCOLOR_SCALARS c 1\n.5 1\n"   \
  "TENSORS t double\n1 2 3 4 5 6 7 8 9\n9 8 7 6 5 4 3 2 inf\n"

#define SAMPLE_GMSH_2                                                                                                  \
  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n$ any thing\n$EndComments\n$PhysicalNames\n1\n3 7 \"body\"\n"      \
  "$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n9 0 1 0\n4 0 0 1\n3 1 1 1\n$EndNodes\n$Elements\n4\n1 15 2 0 1 3\n" \
  "2 2 2 -5 1 1 2 9\n3 4 3 7 2 1 1 2 9 4\n3 4 2 7 2 3 4 9 2\n$EndElements\n$NodeData\n1\n\"a "                         \
  "view\"\n1\n0\n3\n0\n1\n2\n"                                                                                         \
  "9 1.5\n1 nan\n$EndNodeData\n$ElementData\n1\n\"v\"\n1\n0.5\n4\n2\n3\n1\n0\n3 1 2 3\n$EndElementData\n"              \
  "$ElementData\n1\n\"v\"\n0\n3\n3\n1\n1\n2 4\n$EndElementData\n"

#define SAMPLE_GMSH_4                                                                                                 \
  "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 1\n1 0 0 0 0\n1 0 0 0 1 0 0 1 4 1 1\n"                      \
  "1 0 0 0 1 1 0 2 -5 6 0\n2 0 0 0 1 1 1 1 7 1 -1\n$EndEntities\n$Nodes\n2 5 1 9\n2 1 1 2\n1\n2\n0 0 0 .1 .2\n1 0 0 " \
  "1 0\n"                                                                                                             \
  "3 2 0 3\n9\n4\n3\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n$Elements\n3 4 1 20\n0 1 15 1\n1 3\n2 1 2 1\n2 1 2 9\n3 2 4 2\n" \
  "3 1 2 9 4\n20 3 4 9 2\n$EndElements\n$Periodic\n0\n$EndPeriodic\n$ElementData\n1\n\"v\"\n1\n0.5\n3\n2\n3\n1\n"     \
  "20 1 2 3\n$EndElementData\n"

#define SAMPLE_NODE "# points\n4 2 1 1\n1 0 0 .5 1\n2 1 0 .5 1\n3 1 1 .5 0\n4 0 1 .5 0\n"
#define SAMPLE_TEXT "# x y\n0 0\n1,0\n1 , 1\n\n-0\t1e-310 # the last\n"

typedef struct sample_writer {
  char *bytes;
  size_t n;
} sample_writer;

static inline void put_text(sample_writer *w, const char *text)
{
  memcpy(w->bytes + w->n, text, strlen(text));
  w->n += strlen(text);
}

static inline void put_big_endian(sample_writer *w, uint64_t x, int bytes)
{
  while (bytes-- > 0)
    w->bytes[w->n++] = (char)(x >> 8 * bytes);
}

static inline void put_big_double(sample_writer *w, double x)
{
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  put_big_endian(w, bits, 8);
}

/* A binary file with what a tetrahedron and a voxel need, and attributes of several kinds behind them. */
static inline void make_binary_vtk(sample_writer *w)
{
  static const unsigned cells[] = {4, 0, 1, 2, 4, 8, 0, 1, 2, 3, 4, 5, 6, 7};
  put_text(w, "# vtk DataFile Version 4.2\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n");
  for (int p = 0; p < 8; p++)
    for (int k = 0; k < 3; k++)
      put_big_double(w, p >> k & 1);
  put_text(w, "\nCELLS 2 14\n");
  for (size_t k = 0; k < sizeof cells / sizeof *cells; k++)
    put_big_endian(w, cells[k], 4);
  put_text(w, "\nCELL_TYPES 2\n");
  put_big_endian(w, 10, 4);
  put_big_endian(w, 11, 4);
  put_text(w, "\nPOINT_DATA 8\nSCALARS b bit 1\nLOOKUP_TABLE default\n");
  put_big_endian(w, 0x0a, 1);
  put_text(w, "\nCELL_DATA 2\nFIELD f 2\nnames 1 2 string\n");
  put_big_endian(w, 0xc3, 1);
  put_text(w, "one");
  put_big_endian(w, 0x8003, 2);
  put_text(w, "two\nshorts 2 2 short\n");
  put_big_endian(w, 0x0a0a20200a0a2020u, 8);
  put_text(w, "\n");
}

/* The same cells as OFFSETS and CONNECTIVITY, points as float. */
static inline void make_binary_vtk_5(sample_writer *w)
{
  static const unsigned cells[] = {0, 1, 2, 4, 0, 1, 2, 3, 4, 5, 6, 7};
  put_text(w, "# vtk DataFile Version 5.1\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n");
  for (int p = 0; p < 8; p++)
    for (int k = 0; k < 3; k++)
      put_big_endian(w, p >> k & 1 ? 0x3f800000u : 0, 4);
  put_text(w, "\nCELLS 3 12\nOFFSETS vtktypeint64\n");
  put_big_endian(w, 0, 8);
  put_big_endian(w, 4, 8);
  put_big_endian(w, 12, 8);
  put_text(w, "\nCONNECTIVITY vtktypeint64\n");
  for (size_t k = 0; k < sizeof cells / sizeof *cells; k++)
    put_big_endian(w, cells[k], 8);
  put_text(w, "\nCELL_TYPES 2\n");
  put_big_endian(w, 10, 4);
  put_big_endian(w, 11, 4);
}

static inline void put_little_endian(sample_writer *w, uint64_t x, int bytes)
{
  for (int k = 0; k < bytes; k++)
    w->bytes[w->n++] = (char)(x >> 8 * k);
}

static inline void put_little_double(sample_writer *w, double x)
{
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  put_little_endian(w, bits, 8);
}

/* Version 4.1: a tetrahedron and a triangle with numbers from 5 on, a value of each node. */
static inline void make_binary_gmsh_4(sample_writer *w)
{
  static const int elements[2][6] = {{4, 8, 5, 6, 7, 8}, {2, 9, 5, 6, 7}};
  put_text(w, "$MeshFormat\n4.1 1 8\n");
  put_little_endian(w, 1, 4);
  put_text(w, "\n$EndMeshFormat\n$Entities\n");
  for (int dim = 0; dim < 4; dim++)
    put_little_endian(w, dim == 3, 8);
  put_little_endian(w, 3, 4);
  for (int k = 0; k < 6; k++)
    put_little_double(w, k > 2);
  put_little_endian(w, 1, 8);
  put_little_endian(w, 11, 4);
  put_little_endian(w, 0, 8);
  put_text(w, "\n$EndEntities\n$Nodes\n");
  for (int k = 0; k < 4; k++)
    put_little_endian(w, (uint64_t[]){1, 4, 5, 8}[k], 8);
  for (int k = 0; k < 3; k++)
    put_little_endian(w, (uint64_t[]){3, 3, 0}[k], 4);
  put_little_endian(w, 4, 8);
  for (int p = 0; p < 4; p++)
    put_little_endian(w, (uint64_t)p + 5, 8);
  for (int p = 0; p < 4; p++)
    for (int k = 0; k < 3; k++)
      put_little_double(w, p == k + 1);
  put_text(w, "\n$EndNodes\n$Elements\n");
  for (int k = 0; k < 4; k++)
    put_little_endian(w, (uint64_t[]){2, 2, 8, 9}[k], 8);
  for (int e = 0; e < 2; e++) {
    put_little_endian(w, e ? 2 : 3, 4);
    put_little_endian(w, 3, 4);
    put_little_endian(w, (uint64_t)elements[e][0], 4);
    put_little_endian(w, 1, 8);
    for (int k = 1; k < (e ? 5 : 6); k++)
      put_little_endian(w, (uint64_t)elements[e][k], 8);
  }
  put_text(w, "\n$EndElements\n$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n4\n");
  for (int p = 0; p < 4; p++) {
    put_little_endian(w, (uint64_t)p + 5, 4);
    put_little_double(w, p * 0.5);
  }
  put_text(w, "\n$EndNodeData\n");
}

/* Version 2.2 from a machine with the other order of bytes: the same, the elements in two blocks. */
static inline void make_binary_gmsh_2(sample_writer *w)
{
  static const int elements[2][7] = {{8, 11, 3, 5, 6, 7, 8}, {9, 0, 3, 5, 6, 7}};
  put_text(w, "$MeshFormat\n2.2 1 8\n");
  put_big_endian(w, 1, 4);
  put_text(w, "\n$EndMeshFormat\n$Nodes\n4\n");
  for (int p = 0; p < 4; p++) {
    put_big_endian(w, (uint64_t)p + 5, 4);
    for (int k = 0; k < 3; k++)
      put_big_double(w, p == k + 1);
  }
  put_text(w, "\n$EndNodes\n$Elements\n2\n");
  for (int e = 0; e < 2; e++) {
    put_big_endian(w, e ? 2 : 4, 4);
    put_big_endian(w, 1, 4);
    put_big_endian(w, 2, 4);
    for (int k = 0; k < (e ? 6 : 7); k++)
      put_big_endian(w, (uint64_t)elements[e][k], 4);
  }
  put_text(w, "\n$EndElements\n");
}

/* VTU whose arrays are appended as they are, big-endian: a triangle and a value of its points. */
static inline void make_raw_vtu(sample_writer *w)
{
  put_text(
      w, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"BigEndian\">\n<UnstructuredGrid>"
         "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"appended\" offset=\"0\"/></Points>\n<Cells><DataArray type=\"Int32\" Name=\"connectivity\" "
         "format=\"appended\" offset=\"40\"/><DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\" "
         "offset=\"56\"/>"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"appended\" offset=\"68\"/></Cells>\n<PointData>"
         "<DataArray type=\"UInt16\" Name=\"t\" format=\"appended\" offset=\"73\"><InformationKey name=\"k\">x"
         "</InformationKey></DataArray></PointData></Piece></UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n _");
  put_big_endian(w, 36, 4);
  for (int k = 0; k < 9; k++)
    put_big_endian(w, k == 3 || k == 7 ? 0x3f800000u : 0, 4);
  put_big_endian(w, 12, 4);
  for (unsigned k = 0; k < 3; k++)
    put_big_endian(w, k, 4);
  put_big_endian(w, 8, 4);
  put_big_endian(w, 3, 8);
  put_big_endian(w, 1, 4);
  put_big_endian(w, 5, 1);
  put_big_endian(w, 6, 4);
  put_big_endian(w, 0x000a00ff8000u, 6);
  put_text(w, "\n</AppendedData></VTKFile>\n");
}

static inline void make_binary_ply(sample_writer *w)
{
  put_text(w, "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
              "property short t\nelement face 1\nproperty list uchar uint vertex_index\nend_header\n");
  for (int p = 0; p < 3; p++) {
    put_big_double(w, p == 1);
    put_big_double(w, p == 2);
    put_big_endian(w, (uint64_t)p + 0xffff, 2);
  }
  put_big_endian(w, 3, 1);
  for (unsigned k = 0; k < 3; k++)
    put_big_endian(w, k, 4);
}

/* Its header begins as a text does. */
static inline void make_binary_stl(sample_writer *w)
{
  static const unsigned char corners[2][3] = {{0, 1, 2}, {2, 1, 3}};
  put_text(w, "solid but binary                                                                ");
  put_little_endian(w, 2, 4);
  for (int t = 0; t < 2; t++) {
    put_little_endian(w, 0, 8);
    put_little_endian(w, 0, 4);
    for (int c = 0; c < 3; c++)
      for (int k = 0; k < 3; k++)
        put_little_endian(w, corners[t][c] >> k & 1 ? 0x3f800000u : 0, 4);
    put_little_endian(w, t ? 0x1f : 0, 2);
  }
}

/* Version 1, big-endian: a triangle with references, and a keyword that is not known. */
static inline void make_meshb(sample_writer *w)
{
  static const unsigned head[] = {1, 1, 3, 20, 2, 4, 80, 3};
  static const unsigned tail[] = {13, 96, 1, 2, 6, 124, 1, 1, 2, 3, 0xfffffff9u, 54, 0};
  for (size_t k = 0; k < 8; k++)
    put_big_endian(w, head[k], 4);
  for (unsigned p = 0; p < 3; p++) {
    put_big_endian(w, p == 1 ? 0x3f800000u : 0, 4);
    put_big_endian(w, p == 2 ? 0x3f800000u : 0, 4);
    put_big_endian(w, p, 4);
  }
  for (size_t k = 0; k < 3; k++) /* to the position that was announced */
    put_big_endian(w, 0, 4);
  for (size_t k = 0; k < sizeof tail / sizeof *tail; k++)
    put_big_endian(w, tail[k], 4);
}

static inline void make_raw(sample_writer *w)
{
  for (int k = 0; k < 6; k++) {
    double x = k * 0.25;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    for (int b = 0; b < 8; b++)
      w->bytes[w->n++] = (char)(bits >> 8 * b);
  }
}

#if GMDS_HAVE_EXPAT
#  define VTU_SAMPLES(X)                                                \
    X("VTU", GMDS_FORMAT_VTU, 0, 1, SAMPLE_VTU_TEXT, NULL)              \
    X("VTU base64", GMDS_FORMAT_VTU, 0, 1, SAMPLE_VTU_BASE64, NULL)     \
    X("VTU appended", GMDS_FORMAT_VTU, 0, 0, SAMPLE_VTU_APPENDED, NULL) \
    X("VTU raw", GMDS_FORMAT_VTU, 0, 0, "", make_raw_vtu)
#else
#  define VTU_SAMPLES(X)
#endif
#if GMDS_HAVE_EXPAT && GMDS_HAVE_ZLIB
#  define ZIP_SAMPLES(X) X("VTU compressed", GMDS_FORMAT_VTU, 0, 1, SAMPLE_VTU_ZIP, NULL)
#else
#  define ZIP_SAMPLES(X)
#endif

/* X(text, format, dim, whether its end can be told, bytes as text or NULL, maker or NULL) */
#define SAMPLE_LIST(X)                                                    \
  X("OFF", GMDS_FORMAT_OFF, 0, 1, SAMPLE_OFF, NULL)                       \
  X("Medit", GMDS_FORMAT_MEDIT, 0, 1, SAMPLE_MEDIT, NULL)                 \
  X("OBJ", GMDS_FORMAT_OBJ, 0, 0, SAMPLE_OBJ, NULL)                       \
  X("PLY", GMDS_FORMAT_PLY, 0, 1, SAMPLE_PLY, NULL)                       \
  X("PLY of words", GMDS_FORMAT_PLY, 0, 0, "", make_binary_ply)           \
  X("STL", GMDS_FORMAT_STL, 0, 0, SAMPLE_STL, NULL)                       \
  X("STL of words", GMDS_FORMAT_STL, 0, 0, "", make_binary_stl)           \
  X("VTK", GMDS_FORMAT_VTK, 0, 0, SAMPLE_VTK, NULL)                       \
  X("VTK 5", GMDS_FORMAT_VTK, 0, 0, SAMPLE_VTK_5, NULL)                   \
  X("VTK binary", GMDS_FORMAT_VTK, 0, 0, "", make_binary_vtk)             \
  X("VTK 5 binary", GMDS_FORMAT_VTK, 0, 0, "", make_binary_vtk_5)         \
  X("VTK polyhedron", GMDS_FORMAT_VTK, 0, 0, SAMPLE_VTK_POLYHEDRON, NULL) \
  VTU_SAMPLES(X)                                                          \
  ZIP_SAMPLES(X)                                                          \
  X("Medit of words", GMDS_FORMAT_MESHB, 0, 0, "", make_meshb)            \
  X("Gmsh 2.2", GMDS_FORMAT_GMSH, 0, 0, SAMPLE_GMSH_2, NULL)              \
  X("Gmsh 4.1", GMDS_FORMAT_GMSH, 0, 0, SAMPLE_GMSH_4, NULL)              \
  X("Gmsh 2.2 of words", GMDS_FORMAT_GMSH, 0, 0, "", make_binary_gmsh_2)  \
  X("Gmsh 4.1 of words", GMDS_FORMAT_GMSH, 0, 0, "", make_binary_gmsh_4)  \
  X(".node", GMDS_FORMAT_NODE, 2, 1, SAMPLE_NODE, NULL)                   \
  X("raw", GMDS_FORMAT_F64, 3, 0, "", make_raw)                           \
  X("text", GMDS_FORMAT_TEXT, 0, 0, SAMPLE_TEXT, NULL)

#define SAMPLE_ONE(...) +1
enum { N_SAMPLES = 0 SAMPLE_LIST(SAMPLE_ONE) };
#undef SAMPLE_ONE

static inline sample sample_at(size_t i)
{
#define ROW(text, format, dim, counted, bytes, maker) {text, format, dim, counted, bytes, maker},
  static const struct {
    const char *text;
    gmds_format format;
    int dim, counted;
    const char *bytes;
    void (*make)(sample_writer *);
  } rows[] = {SAMPLE_LIST(ROW)};
#undef ROW
  sample s = {.text = rows[i].text, .format = rows[i].format, .dim = rows[i].dim, .counted = rows[i].counted};
  sample_writer w = {s.bytes, 0};
  put_text(&w, rows[i].bytes);
  if (rows[i].make)
    rows[i].make(&w);
  s.n = w.n;
  return s;
}
#endif
