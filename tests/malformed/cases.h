/* Files that are not what they should be, and the sentence that each is refused with. */
#ifndef GMDS_TESTS_MALFORMED_CASES_H
#define GMDS_TESTS_MALFORMED_CASES_H

#define BAD_VTK "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_VTK_5 "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_POLYDATA "# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\n"
#define BAD_BINARY "# vtk DataFile Version 2.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_TRIANGLE "POINTS 3 int\n0 0 0 1 0 0 0 1 0\n"
#define BAD_MSH "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
#define BAD_MSH_4 "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
#define BAD_MSH_WORDS "$MeshFormat\n4.1 1 8\n\1\0\0\0\n$EndMeshFormat\n"
#define BAD_MSH_NODES BAD_MSH "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
#define BAD_MSH_4_NODES BAD_MSH_4 "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
#define BAD_VTU "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>"
#define BAD_VTU_PIECE(points, cells) BAD_VTU "<Piece NumberOfPoints=\"" points "\" NumberOfCells=\"" cells "\">\n"
#define BAD_VTU_POINTS(content) \
  "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" " content "</DataArray></Points>\n"
#define BAD_VTU_END "</Piece></UnstructuredGrid></VTKFile>\n"
#define BAD_VTU_TRIANGLE BAD_VTU_PIECE("3", "1") BAD_VTU_POINTS("format=\"ascii\">0 0 0 1 0 0 0 1 0")
#define BAD_VTU_CELLS(connectivity, offsets, types)                                       \
  "<Cells><DataArray type=\"Int32\" Name=\"connectivity\">" connectivity "</DataArray>\n" \
  "<DataArray type=\"Int32\" Name=\"offsets\">" offsets "</DataArray>\n"                  \
  "<DataArray type=\"Int32\" Name=\"types\">" types "</DataArray></Cells>\n"
#define BAD_MESHB "\1\0\0\0\1\0\0\0\3\0\0\0\0\0\0\0\3\0\0\0"
#define BAD_MEDIT "MeshVersionFormatted 1\nDimension 2\n"
#define BAD_MEDIT_TRIANGLE BAD_MEDIT "Vertices 3\n0 0 1\n1 0 1\n0 1 1\n"

/* X(format, status, bytes, sentence). The bytes are a literal, which may hold 0 bytes. */
#define MALFORMED_LIST(X)                                                                                              \
  X(OFF, FORMAT, "", "name:1: expected OFF, found the end of the file")                                                \
  X(OFF, FORMAT, "ply\n", "name:1: expected OFF, found 'ply'")                                                         \
  X(OFF, FORMAT, "\0\0\0\0", "name:1: expected OFF, found '\?\?\?\?'")                                                 \
  X(OFF, FORMAT, "\x1b[31mOFF", "name:1: expected OFF, found '?[31mOFF'")                                              \
  X(OFF, UNSUPPORTED, "4OFF\n1 0 0\n", "name:1: 4OFF: only points in space are read, OFF")                             \
  X(OFF, UNSUPPORTED, "OFF BINARY\n", "name:1: OFF BINARY: only OFF as text is read")                                  \
  X(OFF, FORMAT, "OFF\n", "name:2: expected a number of points, found the end of the file")                            \
  X(OFF, FORMAT, "OFF\n-1 0 0\n", "name:2: expected a number of points, found '-1'")                                   \
  X(OFF, FORMAT, "OFF\n3.5 0 0\n", "name:2: expected a number of points, found '3.5'")                                 \
  X(OFF, FORMAT, "OFF\n99999999999999999999999 0\n",                                                                   \
    "name:2: expected a number of points, found '99999999999999999999999', which is too large")                        \
  X(OFF, FORMAT, "OFF\n1000000000000 0 0\n0 0 0\n",                                                                    \
    "name:2: 1000000000000 points are declared, but only 11 bytes remain")                                             \
  X(OFF, FORMAT, "OFF\n1 4000000000 0\n0 0 0\n", "name:2: 4000000000 faces are declared, but only 9 bytes remain")     \
  X(OFF, FORMAT, "OFF\n1 0 0 0\n0 0 0\n", "name:2: expected the end of the line, found '0'")                           \
  X(OFF, FORMAT, "OFF\n1 0 0\n0\n", "name:3: expected 2 or 3 coordinates, found 1")                                    \
  X(OFF, FORMAT, "OFF\n2 0 0\n0 0 0\n0 0\n", "name:4: expected 3 coordinates, found 2")                                \
  X(OFF, FORMAT, "OFF\n1 0 0\n0 0 0 0\n", "name:3: expected 3 coordinates, found more")                                \
  X(OFF, FORMAT, "OFF\n1 0 0\n0 x 0\n", "name:3: expected a coordinate, found 'x'")                                    \
  X(OFF, FORMAT, "OFF\n1 0 0\n0 0x1p3 0\n", "name:3: expected a coordinate, found '0x1p3'")                            \
  X(OFF, COORDINATE, "OFF\n1 0 0\n0 nan 0\n",                                                                          \
    "name:3: a coordinate of point 0 (from 0) is not a finite number: 'nan'")                                          \
  X(OFF, COORDINATE, "OFF\n2 0 0\n0 0 0\n0 0 -1e999\n",                                                                \
    "name:4: a coordinate of point 1 (from 0) is not a finite number: '-1e999'")                                       \
  X(OFF, FORMAT, "COFF\n1 0 0\n0 0 0 red\n", "name:3: expected a colour, normal or texture coordinate, found 'red'")   \
  X(OFF, FORMAT, "OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 1 2\n", "name:5: expected an index from 0 to 1, found '2'")            \
  X(OFF, FORMAT, "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 -1\n", "name:5: expected an index from 0 to 1, found '-1'")            \
  X(OFF, FORMAT, "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 4294967296\n",                                                         \
    "name:5: expected an index from 0 to 1, found '4294967296'")                                                       \
  X(OFF, FORMAT, "OFF\n0 1 0\n1 0 \n", "name:3: index '0', but there are no points")                                   \
  X(OFF, FORMAT, "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1\n2\n",                                                              \
    "name:6: expected an index of a point, found the end of the line")                                                 \
  X(OFF, FORMAT, "OFF\n1 1 0\n0 0 0\n0  \n", "name:4: a face without points")                                          \
  X(OFF, FORMAT, "OFF\n1 1 0\n0 0 0\n900 0 0\n", "name:4: 900 points of a face are declared, but only 5 bytes remain") \
  X(OFF, FORMAT, "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2 red\n", "name:6: expected a colour, found 'red'")                 \
  X(OFF, FORMAT, "OFF\n1 0 0\n0 0 0\nrubbish\n", "name:4: expected the end of the file, found 'rubbish'")              \
  X(TEXT, FORMAT, "1\n", "name:1: expected 2 or 3 coordinates, found 1")                                               \
  X(TEXT, FORMAT, "1 2\n1 2 3\n", "name:2: expected 2 coordinates, found 3")                                           \
  X(TEXT, FORMAT, "1 2 3 4\n", "name:1: expected 3 coordinates, found more")                                           \
  X(TEXT, FORMAT, "x,y\n1,2\n", "name:1: expected a coordinate, found 'x'")                                            \
  X(TEXT, FORMAT, "1,,2\n", "name:1: expected a coordinate, found ','")                                                \
  X(TEXT, FORMAT, ",1,2\n", "name:1: expected a coordinate, found ','")                                                \
  X(TEXT, FORMAT, "1,2,\n", "name:1: expected a coordinate, found the end of the line")                                \
  X(TEXT, FORMAT, "1;2\n", "name:1: expected a coordinate, found '1;2'")                                               \
  X(TEXT, COORDINATE, "\n1 2\n1 inf\n", "name:3: a coordinate of point 1 (from 0) is not a finite number: 'inf'")      \
  X(NODE, FORMAT, "", "name:1: expected a number of points, found the end of the file")                                \
  X(NODE, FORMAT, "1000 2 0 0\n", "name:1: 1000 points are declared, but only 7 bytes remain")                         \
  X(NODE, FORMAT, "1 4 0 0\n1 1 1\n", "name:1: expected 2 or 3 coordinates a point, found '4'")                        \
  X(NODE, FORMAT, "1 2 0 2\n1 1 1\n", "name:1: expected 0 or 1 markers, found '2'")                                    \
  X(NODE, FORMAT, "1 2 18446744073709551615 1\n1 1 1\n",                                                               \
    "name:1: 18446744073709551615 attributes a point are declared, but only 7 bytes remain")                           \
  X(NODE, FORMAT, "2 2 0 0\n2 0 0\n3 1 1\n", "name:2: expected point 0, found 2")                                      \
  X(NODE, FORMAT, "2 2 0 0\n1 0 0\n1 1 1\n", "name:3: expected point 2, found 1")                                      \
  X(NODE, FORMAT, "2 2 0 0\n1 0\n2 1 1\n", "name:2: expected 2 coordinates, found 1")                                  \
  X(NODE, FORMAT, "1 2 1 0\n1 0 0\n", "name:2: expected an attribute or marker, found the end of the line")            \
  X(NODE, FORMAT, "1 2 0 0\n1 0 0 0\n", "name:2: expected the end of the line, found '0'")                             \
  X(NODE, FORMAT, "1 2 0 0\n1 0 0\n2 0 0\n", "name:3: expected the end of the file, found '2'")                        \
  X(F64, FORMAT, "12345678", "name: byte 0: expected a multiple of 16 bytes (2 doubles a point), found 8")             \
  X(F64, COORDINATE, "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xf0\x7f",                                                           \
    "name: byte 8: a coordinate of point 0 (from 0) is not a finite number: 'inf'")                                    \
  X(MEDIT, FORMAT, "", "name:1: expected MeshVersionFormatted, found the end of the file")                             \
  X(MEDIT, UNSUPPORTED, "MFEM mesh v1.0\n", "name:1: this is a mesh of MFEM; only Medit's .mesh is read")              \
  X(MEDIT, UNSUPPORTED, "MeshVersionFormatted 9\n", "name:1: expected a version from 1 to 4, found 9")                 \
  X(MEDIT, UNSUPPORTED, "MeshVersionFormatted 1\nDimension 4\n", "name:2: expected the dimension, 2 or 3, found 4")    \
  X(MEDIT, FORMAT, BAD_MEDIT, "name:3: expected a keyword or End, found the end of the file")                          \
  X(MEDIT, FORMAT, BAD_MEDIT "Points 1\n", "name:3: Points: 0 numbers are not 1 rows")                                 \
  X(MEDIT, FORMAT, BAD_MEDIT "Points 2\n1 2 3\nEnd\n", "name:4: Points: 3 numbers are not 2 rows")                     \
  X(MEDIT, FORMAT, BAD_MEDIT "Points 2\n1 2 ?\nEnd\n", "name:4: expected a number, found '?'")                         \
  X(MEDIT, FORMAT, BAD_MEDIT "12 Points\n", "name:3: expected a keyword of Medit, found '12'")                         \
  X(MEDIT, UNSUPPORTED, BAD_MEDIT "TrianglesP2 1\n", "name:3: TrianglesP2: only cells of the first order are read")    \
  X(MEDIT, FORMAT, BAD_MEDIT "Vertices 4000000000\n0 0 0\n",                                                           \
    "name:3: 4000000000 Vertices are declared, but only 7 bytes remain")                                               \
  X(MEDIT, FORMAT, BAD_MEDIT "Vertices 1\n0 0 0 0 0 End\n", "name:4: expected the end of the line, found '0'")         \
  X(MEDIT, FORMAT, BAD_MEDIT_TRIANGLE "Vertices 1\n0 0 1\nEnd\n", "name:7: Vertices are listed a second time")         \
  X(MEDIT, FORMAT, BAD_MEDIT_TRIANGLE "Triangles 1\n0 1 2 5\nEnd\n",                                                   \
    "name:8: expected an index from 1 to 3, found '0'")                                                                \
  X(MEDIT, FORMAT, BAD_MEDIT_TRIANGLE "Triangles 1\n1 2 4 5\nEnd\n",                                                   \
    "name:8: expected an index from 1 to 3, found '4'")                                                                \
  X(MEDIT, FORMAT, BAD_MEDIT_TRIANGLE "Triangles 1\n1 2 3 a\nEnd\n", "name:8: expected a reference number, found 'a'") \
  X(MEDIT, FORMAT, BAD_MEDIT "Corners 1000000\n1\nEnd\n",                                                              \
    "name:3: 1000000 Corners are declared, but only 7 bytes remain")                                                   \
  X(MEDIT, FORMAT, BAD_MEDIT "Corners 1\nx\nEnd\n", "name:4: expected a number, found 'x'")                            \
  X(MEDIT, FORMAT, BAD_MEDIT "End\nmore", "name:4: expected the end of the file, found 'more'")                        \
  X(VTK, FORMAT, "", "name:1: expected #, found the end of the file")                                                  \
  X(VTK, FORMAT, "<?xml version=\"1.0\"?>", "name:1: expected #, found '<?xml'")                                       \
  X(VTK, UNSUPPORTED, "# vtk DataFile Version 9.0\nt\nASCII\n", "name:1: expected a version from 1 to 5, found 9.0")   \
  X(VTK, FORMAT, "# vtk DataFile Version 2.0\nt\nTEXT\n", "name:3: expected ASCII or BINARY, found 'TEXT'")            \
  X(VTK, UNSUPPORTED, "# vtk DataFile Version 2.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",                             \
    "name:4: STRUCTURED_POINTS: only UNSTRUCTURED_GRID and POLYDATA are read")                                         \
  X(VTK, FORMAT, "# vtk DataFile Version 2.0\nt\nASCII\nDATASET TREE\n",                                               \
    "name:4: expected UNSTRUCTURED_GRID or POLYDATA, found 'TREE'")                                                    \
  X(VTK, FORMAT, BAD_VTK, "name:5: expected POINTS, found the end of the file")                                        \
  X(VTK, FORMAT, BAD_VTK "POINTS 1 real\n0 0 0\n", "name:5: expected a type of numbers, found 'real'")                 \
  X(VTK, FORMAT, BAD_VTK "POINTS 1 string\n0 0 0\n", "name:5: expected coordinates as numbers, found string")          \
  X(VTK, FORMAT, BAD_VTK "POINTS 100 float\n0 0 0\n", "name:5: 100 points are declared, but only 13 bytes remain")     \
  X(VTK, FORMAT, BAD_VTK "POINTS 18446744073709551615 float\n",                                                        \
    "name:5: 18446744073709551615 points are declared, but only 7 bytes remain")                                       \
  X(VTK, FORMAT, BAD_VTK "POINTS 2 float\n0 0 0 1 1\n\n\n",                                                            \
    "name:9: expected a coordinate, found the end of the file")                                                        \
  X(VTK, FORMAT, BAD_VTK "POINTS 1 float\n0 0 0\nPOINTS 1 float\n0 0 0\n", "name:7: POINTS are listed a second time")  \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n3 0 1 2\n",                                                          \
    "name:9: expected CELL_TYPES, found the end of the file")                                                          \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELL_TYPES 1\n5\n", "name:7: CELL_TYPES without CELLS before them")             \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 5 4\n3 0 1 2\n", "name:7: 5 cells in 4 numbers")                          \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 400\n3 0 1 2\n",                                                        \
    "name:7: 400 numbers are declared, but only 9 bytes remain")                                                       \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n",                                       \
    "name:9: expected the types of 1 cells, found those of 2")                                                         \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n3 0 1 3\nCELL_TYPES 1\n5\n",                                         \
    "name:8: expected an index from 0 to 2, found '3'")                                                                \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n4 0 1 2\nCELL_TYPES 1\n5\n",                                         \
    "name:8: a cell of 4 points, but only 3 indices remain")                                                           \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n2 0 1 2\nCELL_TYPES 1\n3\n",                                         \
    "name:8: numbers left behind the last cell: 1")                                                                    \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n9\n",                                         \
    "name:8: a quadrilateral has 4 points, found 3")                                                                   \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n7\n",                                           \
    "name:8: a polygon has at least 3 points, found 2")                                                                \
  X(VTK, UNSUPPORTED, BAD_VTK BAD_TRIANGLE "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n22\n",                                   \
    "name:8: cells of VTK's type 22 are not read")                                                                     \
  X(VTK, UNSUPPORTED, BAD_VTK BAD_TRIANGLE "CELLS 1 1\n0\nCELL_TYPES 1\n0\n",                                          \
    "name:8: cells of VTK's type 0 are not read")                                                                      \
  X(VTK, FORMAT, BAD_VTK "CELLS 1 2\n1 0\nCELL_TYPES 1\n1\n", "name:6: index '0', but there are no points")            \
  X(VTK, FORMAT, BAD_VTK_5 BAD_TRIANGLE "CELLS 2 3\nOFFSETS float\n",                                                  \
    "name:8: OFFSETS: expected whole numbers, found float")                                                            \
  X(VTK, FORMAT,                                                                                                       \
    BAD_VTK_5 BAD_TRIANGLE                                                                                             \
    "CELLS 2 3\nOFFSETS vtktypeint64\n1 3\nCONNECTIVITY vtktypeint64\n0 1 2\nCELL_TYPES 1\n5\n",                       \
    "name:9: expected 0 as the first offset, found 1")                                                                 \
  X(VTK, FORMAT,                                                                                                       \
    BAD_VTK_5 BAD_TRIANGLE                                                                                             \
    "CELLS 3 3\nOFFSETS vtktypeint64\n0 3 1\nCONNECTIVITY vtktypeint64\n0 1 2\nCELL_TYPES 2\n5 1\n",                   \
    "name:9: expected an offset from 3, found 1")                                                                      \
  X(VTK, FORMAT,                                                                                                       \
    BAD_VTK_5 BAD_TRIANGLE                                                                                             \
    "CELLS 2 3\nOFFSETS vtktypeint64\n0 9\nCONNECTIVITY vtktypeint64\n0 1 2\nCELL_TYPES 1\n5\n",                       \
    "name:10: a cell of 9 points, but only 3 indices remain")                                                          \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "LINES 1 3\n2 0 1\n", "name:7: expected a section of VTK, found 'LINES'")        \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "LINES 1 2\n1 0\n", "name:8: a poly-line has at least 2 points, found 1")   \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "SCALARS s int\n", "name:7: expected a section of VTK, found 'SCALARS'")    \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "POINT_DATA 3\nSCALARS s int\nLOOKUP_TABLE default\n1 2\n",                 \
    "name:11: expected a whole number, found the end of the file")                                                     \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "POINT_DATA 18446744073709551615\nVECTORS s int\n1 2\n",                    \
    "name:7: expected the attributes of 3 points, found those of 18446744073709551615")                                \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "FIELD f 1\na 3 18446744073709551615 int\n1 2\n",                           \
    "name:8: 18446744073709551615 tuples of 3 numbers are more than a file holds")                                     \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "POINT_DATA 3\nSCALARS s int\n1 2\n",                                       \
    "name:9: expected LOOKUP_TABLE, found '1'")                                                                        \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "FIELD f 1\na 1 2 int\n1 b\n", "name:9: expected a number, found 'b'")      \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "FIELD f 2\na 1 1 int\n1\n",                                                \
    "name:10: expected the name of an array, found the end of the file")                                               \
  X(VTK, FORMAT, BAD_BINARY "POINTS 1 double\n0123456789",                                                             \
    "name: byte 78: 3 coordinates are declared, but only 10 bytes remain")                                             \
  X(VTK, COORDINATE, BAD_BINARY "POINTS 1 float\n\0\0\0\0\x7f\xc0\0\0\0\0\0\0",                                        \
    "name: byte 81: a coordinate of point 0 (from 0) is not a finite number: 'nan'")                                   \
  X(VTK, FORMAT,                                                                                                       \
    BAD_BINARY "POINTS 1 float\n\0\0\0\0\0\0\0\0\0\0\0\0\nCELLS 1 2\n\0\0\0\x01\xff\xff\xff\xff\n"                     \
               "CELL_TYPES 1\n\0\0\0\x01\n",                                                                           \
    "name: byte 104: expected an index of a point, found -1")                                                          \
  X(VTK, FORMAT,                                                                                                       \
    BAD_BINARY "POINTS 1 float\n\0\0\0\0\0\0\0\0\0\0\0\0\nCELLS 1 2\n\0\0\0\x01\0\0\0\x01\n"                           \
               "CELL_TYPES 1\n\0\0\0\x01\n",                                                                           \
    "name: byte 104: expected an index below 1, found 1")                                                              \
  X(OBJ, FORMAT, "v 0 0\n", "name:1: expected a coordinate, found the end of the line")                                \
  X(OBJ, FORMAT, "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "name:3: expected an index from 1 to 2, found '3'")                    \
  X(OBJ, FORMAT, "v 0 0 0\nv 1 0 0\nf 1 2 0\n", "name:3: expected an index from 1 to 2, found '0'")                    \
  X(OBJ, FORMAT, "v 0 0 0\nv 1 0 0\nf 1 2 -3\n", "name:3: an index 3 back of 2 points")                                \
  X(OBJ, FORMAT, "v 0 0 0\nv 1 0 0\nf 1 2\n", "name:3: a face of 2 points")                                            \
  X(OBJ, FORMAT, "v 0 0 0\nl 1\n", "name:2: a line of 1 points")                                                       \
  X(OBJ, UNSUPPORTED, "cstype bezier\n", "name:1: cstype: free-form curves and surfaces are not read")                 \
  X(OBJ, FORMAT, "solid\n", "name:1: expected a keyword of OBJ, found 'solid'")                                        \
  X(PLY, FORMAT, "plx\n", "name:1: expected ply, found 'plx'")                                                         \
  X(PLY, FORMAT, "ply\nformat odd 1.0\n",                                                                              \
    "name:2: expected ascii, binary_little_endian or binary_big_endian, found 'odd'")                                  \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nproperty int x\n", "name:3: a property before any element")                   \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n",                                         \
    "name:4: expected a type of numbers, found 'real'")                                                                \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\n",                      \
    "name:5: a property is there a second time")                                                                       \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float a\nproperty float a\n",                      \
    "name:5: the attribute 'a' of points is there a second time")                                                      \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",                         \
    "name:6: an element lacks coordinates or indices of points")                                                       \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 900\nproperty float x\nproperty float y\nend_header\n0 0\n",   \
    "name:7: 900 elements are declared, but only 4 bytes remain")                                                      \
  X(PLY, FORMAT, "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n0 0\n",                                         \
    "name:5: an element lacks coordinates or indices of points")                                                       \
  X(PLY, FORMAT,                                                                                                       \
    "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty double "                      \
    "y\nend_header\n0123456789",                                                                                       \
    "name: byte 108: expected a number, found the end of the file")                                                    \
  X(STL, FORMAT, "solid\nfacet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0\n",                                     \
    "name:3: expected a coordinate, found the end of the file")                                                        \
  X(STL, FORMAT, "solid\n", "name:2: expected facet or endsolid, found the end of the file")                           \
  X(STL, FORMAT, "stl\n", "name:1: expected solid, found 'stl'")                                                       \
  X(STL, FORMAT, "solid\nendsolid\nmore\n", "name:3: expected solid, found 'more'")                                    \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 3\n2 1 0\nCELL_TYPES 1\n42\n",                                          \
    "name:8: expected a polyhedron of 4 faces or more, each of 3 points or more")                                      \
  X(VTK, FORMAT, BAD_VTK BAD_TRIANGLE "CELLS 1 18\n17 4 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3\nCELL_TYPES 1\n42\n",          \
    "name:8: a polyhedron with an index beyond the 3 points")                                                          \
  X(VTK, FORMAT,                                                                                                       \
    BAD_POLYDATA BAD_TRIANGLE                                                                                          \
    "POINT_DATA 3\nSCALARS s int\nLOOKUP_TABLE t\n1 2 3\nSCALARS s int\nLOOKUP_TABLE t\n1 2 3\n",                      \
    "name:12: the attribute 's' of points is there a second time")                                                     \
  X(VTK, FORMAT, BAD_POLYDATA BAD_TRIANGLE "POINT_DATA 3\nSCALARS s unsigned_char\nLOOKUP_TABLE t\n1 2 256\n",         \
    "name:10: expected a whole number that its type holds, found '256'")                                               \
  X(VTK, UNSUPPORTED, BAD_POLYDATA BAD_TRIANGLE "POLYGONS 0 0\nLINES 0 0\n",                                           \
    "name:8: LINES behind POLYGONS: only the usual order is read")                                                     \
  X(MESHB, FORMAT, "MeshVersionFormatted 2", "name: byte 0: expected the number 1 as an int")                          \
  X(MESHB, UNSUPPORTED, "\1\0\0\0\7\0\0\0", "name: byte 8: expected a version from 1 to 4, found 7")                   \
  X(MESHB, FORMAT, BAD_MESHB, "name: byte 20: expected a keyword, found the end of the file")                          \
  X(MESHB, FORMAT, BAD_MESHB "\4\0\0\0\0\0\0\0\4\0\0\0",                                                               \
    "name: byte 32: 4 Vertices are declared, but only 0 bytes remain")                                                 \
  X(MESHB, FORMAT, BAD_MESHB "\5\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\2\0\0\0\0\0\0\0",                                       \
    "name: byte 32: expected an index from 1 to 0, found 1")                                                           \
  X(MESHB, UNSUPPORTED, BAD_MESHB "\x18\0\0\0\0\0\0\0",                                                                \
    "name: byte 28: TrianglesP2: only cells of the first order are read")                                              \
  X(MESHB, FORMAT, BAD_MESHB "\x63\0\0\0\5\0\0\0", "name: byte 28: expected a position from here to the end, found 5") \
  X(GMSH, FORMAT, "", "name:1: expected $MeshFormat, found the end of the file")                                       \
  X(GMSH, UNSUPPORTED, "$MeshFormat\n4.0 0 8\n", "name:2: version 4: only 2.2 and 4.1 are read")                       \
  X(GMSH, UNSUPPORTED, "$MeshFormat\n4.1 0 4\n", "name:2: expected 0 or 1 and a size of 8, found 0 and 4")             \
  X(GMSH, FORMAT, "$MeshFormat\n4.1 1 8\n\1\1\1\1\n", "name: byte 20: expected the number 1 as an int")                \
  X(GMSH, FORMAT, BAD_MSH, "name:4: expected $Nodes, found the end of the file")                                       \
  X(GMSH, FORMAT, BAD_MSH "Nodes\n", "name:4: expected a section of MSH, found 'Nodes'")                               \
  X(GMSH, FORMAT, BAD_MSH "$Other\n$EndNodes\n", "name:4: the section $Other has no end")                              \
  X(GMSH, FORMAT, BAD_MSH "$Nodes\n100\n1 0 0 0\n", "name:5: 100 nodes are declared, but only 9 bytes remain")         \
  X(GMSH, FORMAT, BAD_MSH "$Nodes\n1\n1 0 x 0\n", "name:6: expected a coordinate, found 'x'")                          \
  X(GMSH, COORDINATE, BAD_MSH "$Nodes\n1\n1 0 inf 0\n",                                                                \
    "name:6: a coordinate of point 0 (from 0) is not a finite number: 'inf'")                                          \
  X(GMSH, FORMAT, BAD_MSH "$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n", "name:7: 2 nodes have the number 1")             \
  X(GMSH, FORMAT, BAD_MSH "$Nodes\n1\n1 0 0 0\n2 0 0 0\n$EndNodes\n", "name:7: expected $EndNodes, found '2'")         \
  X(GMSH, FORMAT, BAD_MSH_NODES "$Nodes\n0\n$EndNodes\n", "name:10: $Nodes are listed a second time")                  \
  X(GMSH, FORMAT, BAD_MSH_NODES "$Elements\n1\n1 2 2 0 0 1 2 4\n", "name:12: no node has the number 4")                \
  X(GMSH, FORMAT, BAD_MSH_NODES "$Elements\n1\n1 2 2 0 0 1 2\n",                                                       \
    "name:13: expected the number of a node, found the end of the file")                                               \
  X(GMSH, UNSUPPORTED, BAD_MSH_NODES "$Elements\n1\n1 9 2 0 0 1 2 3 1 2 3\n",                                          \
    "name:12: second-order triangles (Gmsh's type 9): only the first order is read")                                   \
  X(GMSH, UNSUPPORTED, BAD_MSH_NODES "$Elements\n1\n1 99 2 0 0 1 2 3\n",                                               \
    "name:12: elements of Gmsh's type 99 are not read")                                                                \
  X(GMSH, FORMAT, BAD_MSH_NODES "$Elements\n1\n1 2 900 0 0 1 2 3\n",                                                   \
    "name:12: 900 tags are declared, but only 11 bytes remain")                                                        \
  X(GMSH, FORMAT, BAD_MSH_NODES "$NodeData\n1\n\"a\"\n0\n2\n0\n1\n",                                                   \
    "name:16: expected a time step, components and a number of rows")                                                  \
  X(GMSH, FORMAT, BAD_MSH_NODES "$NodeData\n1\n\"a\"\n0\n3\n0\n1\n1\n7 0.5\n", "name:18: no node has the number 7")    \
  X(GMSH, FORMAT, BAD_MSH_NODES "$NodeData\n1\n\"a\"\n0\n3\n0\n1\n1000\n7 0.5\n",                                      \
    "name:17: 1000 rows are declared, but only 7 bytes remain")                                                        \
  X(GMSH, FORMAT, BAD_MSH_4 "$Nodes\n1 2 1 2\n2 1 0 3\n1 2 3\n0 0 0 0 0 0 0 0 0\n",                                    \
    "name:6: a block of 3 nodes, but only 2 are left")                                                                 \
  X(GMSH, FORMAT, BAD_MSH_4 "$Nodes\n0 1 1 1\n$EndNodes\n", "name:5: 1 nodes are missing")                             \
  X(GMSH, FORMAT, BAD_MSH_4_NODES "$Elements\n1 1 1 1\n2 1 2 2\n1 1 2 3\n",                                            \
    "name:16: a block of 2 elements, but only 1 are left")                                                             \
  X(GMSH, FORMAT, BAD_MSH_4 "$Entities\n0 0 0 4000\n1 0 0 0\n",                                                        \
    "name:5: 4000 entities are declared, but only 9 bytes remain")                                                     \
  X(GMSH, FORMAT, BAD_MSH_WORDS "$Nodes\n\1\0\0",                                                                      \
    "name: byte 47: expected a number of blocks, found the end of the file")

/* X(format, status, bytes, sentence): these need Expat. */
#define MALFORMED_VTU_LIST(X)                                                                                     \
  X(VTU, FORMAT, "", "name:1: this is not XML: no element found")                                                 \
  X(VTU, FORMAT, "<VTKFile type=\"UnstructuredGrid\">\n<x></VTKFile>", "name:2: this is not XML: mismatched tag") \
  X(VTU, FORMAT,                                                                                                  \
    BAD_VTU "<Piece NumberOfPoints=\"3\" NumberOfCells=\"0\"><PointData><DataArray type=\"Int8\" "                \
            "Name=\"a\"><AppendedData encoding=\"raw\">_1",                                                       \
    "name:2: AppendedData is not behind the grid")                                                                \
  X(VTU, FORMAT, "<vtk/>", "name:1: expected VTKFile, found 'vtk'")                                               \
  X(VTU, UNSUPPORTED, "<VTKFile type=\"PolyData\"/>", "name:1: type PolyData: only UnstructuredGrid is read")     \
  X(VTU, FORMAT, "<VTKFile type=\"UnstructuredGrid\" byte_order=\"Middle\"/>",                                    \
    "name:1: expected LittleEndian or BigEndian, found 'Middle'")                                                 \
  X(VTU, FORMAT, "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt8\"/>",                                    \
    "name:1: expected UInt32 or UInt64, found 'UInt8'")                                                           \
  X(VTU, UNSUPPORTED, "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZ4DataCompressor\"/>",                 \
    "name:1: vtkLZ4DataCompressor: only vtkZLibDataCompressor is read")                                           \
  X(VTU, FORMAT, BAD_VTU_PIECE("x", "1") BAD_VTU_END, "name:2: expected NumberOfPoints, found 'x'")               \
  X(VTU, FORMAT, BAD_VTU_PIECE("3", "0") BAD_VTU_END, "name:2: the piece has no array of Points")                 \
  X(VTU, FORMAT, BAD_VTU_PIECE("900", "0") BAD_VTU_POINTS("format=\"ascii\">0 0 0") BAD_VTU_END,                  \
    "name:3: 2700 numbers are declared, but only 5 bytes remain")                                                 \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"ascii\">0 0 0 0") BAD_VTU_END,                  \
    "name:3: expected the end of the array, found '0'")                                                           \
  X(VTU, COORDINATE, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"ascii\">\n0 nan 0") BAD_VTU_END,            \
    "name:4: a coordinate of point 0 (from 0) is not a finite number: 'nan'")                                     \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"odd\">0 0 0") BAD_VTU_END,                      \
    "name:3: expected ascii, binary or appended, found 'odd'")                                                    \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"binary\">DAAAAAAAAAAAAAAAAAAA") BAD_VTU_END,    \
    "name:3: the array ends before its numbers do, or is not base64")                                             \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"binary\">CAAAAAAAAAAAAAAA") BAD_VTU_END,        \
    "name:3: expected 3 numbers of 4 bytes, found 8 bytes")                                                       \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"binary\">DAAAAAA*AAAAAAAAAAAA") BAD_VTU_END,    \
    "name:3: the array ends before its numbers do, or is not base64")                                             \
  X(VTU, FORMAT, BAD_VTU_PIECE("1", "0") BAD_VTU_POINTS("format=\"appended\" offset=\"5\">") BAD_VTU_END,         \
    "name:3: the array is appended at 5, where there is nothing")                                                 \
  X(VTU, FORMAT, BAD_VTU_TRIANGLE BAD_VTU_CELLS("0 1 3", "3", "5") BAD_VTU_END,                                   \
    "name:4: expected an index from 0 to 2, found '3'")                                                           \
  X(VTU, FORMAT, BAD_VTU_TRIANGLE BAD_VTU_CELLS("0 1 2", "900", "5") BAD_VTU_END,                                 \
    "name:4: 900 numbers are declared, but only 5 bytes remain")                                                  \
  X(VTU, FORMAT, BAD_VTU_TRIANGLE BAD_VTU_CELLS("0 1 2", "-1", "5") BAD_VTU_END,                                  \
    "name:5: expected an offset, found -1")                                                                       \
  X(VTU, UNSUPPORTED, BAD_VTU_TRIANGLE BAD_VTU_CELLS("0 1 2", "3", "22") BAD_VTU_END,                             \
    "name:4: cells of VTK's type 22 are not read")                                                                \
  X(VTU, FORMAT, BAD_VTU_TRIANGLE BAD_VTU_CELLS("0 1 2", "3", "42") BAD_VTU_END,                                  \
    "name:2: the piece has no array of faceoffsets")                                                              \
  X(VTU, FORMAT, BAD_VTU_TRIANGLE BAD_VTU_END, "name:2: the piece has no array of offsets")                       \
  X(VTU, FORMAT,                                                                                                  \
    BAD_VTU_TRIANGLE BAD_VTU_CELLS(                                                                               \
        "0 1 2", "3",                                                                                             \
        "5") "<CellData><DataArray type=\"Int8\" Name=\"a\">3000000000</DataArray></CellData>" BAD_VTU_END,       \
    "name:7: expected a whole number that its type holds, found '3000000000'")
#endif
