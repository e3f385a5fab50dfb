/* Files that are not what they should be, and the sentence that each is refused with. */
#ifndef GMDS_TESTS_MALFORMED_CASES_H
#define GMDS_TESTS_MALFORMED_CASES_H

#define BAD_VTK "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_VTK_5 "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_POLYDATA "# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\n"
#define BAD_BINARY "# vtk DataFile Version 2.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
#define BAD_TRIANGLE "POINTS 3 int\n0 0 0 1 0 0 0 1 0\n"
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
    "name: byte 104: expected an index below 1, found 1")
#endif
