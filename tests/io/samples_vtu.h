/* VTU: five points, a tetrahedron, the same as a polyhedron, a triangle, an attribute of points and one of cells; as
 * text, in base64, in base64 of blocks that are compressed, and appended in base64. */
#ifndef GMDS_TESTS_SAMPLES_VTU_H
#define GMDS_TESTS_SAMPLES_VTU_H

#define SAMPLE_VTU_TEXT                                                                                             \
  "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<Unst"   \
  "ructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n<Points><DataArray type=\"Float64\" Name=\"Po"    \
  "ints\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n</DataArray>\n</Points><Ce"    \
  "lls><DataArray type=\"Int32\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">\n0 1 2 3 0 1 2"   \
  " 3 4 2 1\n</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" NumberOfComponents=\"1\" format=\"ascii\">\n" \
  "4 8 11\n</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">\n10 4" \
  "2 5\n</DataArray>\n<DataArray type=\"Int32\" Name=\"faces\" NumberOfComponents=\"1\" format=\"ascii\">\n4 3 0 2" \
  " 1 3 0 1 3 3 0 3 2 3 1 2 3\n</DataArray>\n<DataArray type=\"Int32\" Name=\"faceoffsets\" NumberOfComponent"      \
  "s=\"1\" format=\"ascii\">\n-1 17 -1\n</DataArray>\n</Cells><PointData><DataArray type=\"Float32\" Name=\"t\" Nu" \
  "mberOfComponents=\"1\" format=\"ascii\">\n1.5 2.5 3.5 4.5 nan\n</DataArray>\n</PointData><CellData><DataArr"     \
  "ay type=\"Int16\" Name=\"ids\" NumberOfComponents=\"1\" format=\"ascii\">\n7 -8 9\n</DataArray>\n</CellData></P" \
  "iece></UnstructuredGrid></VTKFile>\n"

#define SAMPLE_VTU_BASE64                                                                                        \
  "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"><Unstr" \
  "ucturedGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"3\"><Points><DataArray type=\"Float64\" Name=\"Poin"  \
  "ts\" NumberOfComponents=\"3\" format=\"binary\">eAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAA"    \
  "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAADwPwAAAAAAA"         \
  "PA/AAAAAAAA8D8=</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" NumberOfCompo"     \
  "nents=\"1\" format=\"binary\">LAAAAAAAAAAAAAAAAQAAAAIAAAADAAAAAAAAAAEAAAACAAAAAwAAAAQAAAACAAAAAQAAAA==</"     \
  "DataArray><DataArray type=\"Int32\" Name=\"offsets\" NumberOfComponents=\"1\" format=\"binary\">DAAAAAAAAAAE" \
  "AAAACAAAAAsAAAA=</DataArray><DataArray type=\"UInt8\" Name=\"types\" NumberOfComponents=\"1\" format=\"bina"  \
  "ry\">AwAAAAAAAAAKKgU=</DataArray><DataArray type=\"Int32\" Name=\"faces\" NumberOfComponents=\"1\" format=\"" \
  "binary\">RAAAAAAAAAAEAAAAAwAAAAAAAAACAAAAAQAAAAMAAAAAAAAAAQAAAAMAAAADAAAAAAAAAAMAAAACAAAAAwAAAAEAAAAC"        \
  "AAAAAwAAAA==</DataArray><DataArray type=\"Int32\" Name=\"faceoffsets\" NumberOfComponents=\"1\" format=\"bi"  \
  "nary\">DAAAAAAAAAD/////EQAAAP////8=</DataArray></Cells><PointData><DataArray type=\"Float32\" Name=\"t\" "    \
  "NumberOfComponents=\"1\" format=\"binary\">FAAAAAAAAAAAAMA/AAAgQAAAYEAAAJBAAADAfw==</DataArray></PointDa"     \
  "ta><CellData><DataArray type=\"Int16\" Name=\"ids\" NumberOfComponents=\"1\" format=\"binary\">BgAAAAAAAAAHA" \
  "Pj/CQA=</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>\n"

#define SAMPLE_VTU_ZIP                                                                                           \
  "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\" compre" \
  "ssor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"3\"><Points><"   \
  "DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"binary\">BAAAACAAAAAYAAAADgAAAA" \
  "4AAAAOAAAAEAAAAA==eNpjYMAHPtgDAAI/ATB42mNgwAc+2AMAAj8BMHjaY2DABz7YAwACPwEweNpjYACBD/YMaDQAIt0Djg==</"         \
  "DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" NumberOfComponents=\"1\" format="   \
  "\"binary\">AgAAACAAAAAMAAAAFgAAABEAAAA=eNpjYGBgYARiJiBmZoAAZD4AANAADXjaY2FgYGACYkYgBgAAUAAI</DataArray"       \
  "><DataArray type=\"Int32\" Name=\"offsets\" NumberOfComponents=\"1\" format=\"binary\">AQAAACAAAAAMAAAAEQAAA" \
  "A==eNpjYWBg4ABibiAGAACoABg=</DataArray><DataArray type=\"UInt8\" Name=\"types\" NumberOfComponents=\"1\" f"   \
  "ormat=\"binary\">AQAAACAAAAADAAAACwAAAA==eNrj0mIFAAB6ADo=</DataArray><DataArray type=\"Int32\" Name=\"fac"    \
  "es\" NumberOfComponents=\"1\" format=\"binary\">AwAAACAAAAAEAAAAFgAAABYAAAAMAAAAeNpjYWBgYGaAACYgZkTig9gAA"    \
  "VQAD3jaY2ZgYGBmgAAQzQSlGaFsAAFkABJ42mNmYGAAAAAQAAQ=</DataArray><DataArray type=\"Int32\" Name=\"faceoff"      \
  "sets\" NumberOfComponents=\"1\" format=\"binary\">AQAAACAAAAAMAAAAEwAAAA==eNr7////f0EGBgYg9R8ANGAICg==</D"    \
  "ataArray></Cells><PointData><DataArray type=\"Float32\" Name=\"t\" NumberOfComponents=\"1\" format=\"binary"  \
  "\">AQAAACAAAAAUAAAAGQAAAA==eNpjYDhgz8Cg4MDAkADEE4D4QD0AI2IEDw==</DataArray></PointData><CellData><Dat"        \
  "aArray type=\"Int16\" Name=\"ids\" NumberOfComponents=\"1\" format=\"binary\">AQAAACAAAAAGAAAADgAAAA==eNpjZ/" \
  "jxn5MBAAcfAgg=</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>\n"

#define SAMPLE_VTU_APPENDED                                                                                         \
  "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"><Unstr"    \
  "ucturedGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"3\"><Points><DataArray type=\"Float64\" Name=\"Poin"     \
  "ts\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points><Cells><DataArray type=\"Int32\" Nam"   \
  "e=\"connectivity\" NumberOfComponents=\"1\" format=\"appended\" offset=\"172\"/><DataArray type=\"Int32\" Name"  \
  "=\"offsets\" NumberOfComponents=\"1\" format=\"appended\" offset=\"244\"/><DataArray type=\"UInt8\" Name=\"type" \
  "s\" NumberOfComponents=\"1\" format=\"appended\" offset=\"272\"/><DataArray type=\"Int32\" Name=\"faces\" Numbe" \
  "rOfComponents=\"1\" format=\"appended\" offset=\"288\"/><DataArray type=\"Int32\" Name=\"faceoffsets\" NumberO"  \
  "fComponents=\"1\" format=\"appended\" offset=\"392\"/></Cells><PointData><DataArray type=\"Float32\" Name=\"t"   \
  "\" NumberOfComponents=\"1\" format=\"appended\" offset=\"420\"/></PointData><CellData><DataArray type=\"Int1"    \
  "6\" Name=\"ids\" NumberOfComponents=\"1\" format=\"appended\" offset=\"460\"/></CellData></Piece></Unstructur"   \
  "edGrid><AppendedData encoding=\"base64\">_eAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAA"          \
  "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAADwPwAAAAAAAPA/"            \
  "AAAAAAAA8D8=LAAAAAAAAAAAAAAAAQAAAAIAAAADAAAAAAAAAAEAAAACAAAAAwAAAAQAAAACAAAAAQAAAA==DAAAAAAAAAAEAAAA"            \
  "CAAAAAsAAAA=AwAAAAAAAAAKKgU=RAAAAAAAAAAEAAAAAwAAAAAAAAACAAAAAQAAAAMAAAAAAAAAAQAAAAMAAAADAAAAAAAAAAMA"            \
  "AAACAAAAAwAAAAEAAAACAAAAAwAAAA==DAAAAAAAAAD/////EQAAAP////8=FAAAAAAAAAAAAMA/AAAgQAAAYEAAAJBAAADAfw=="            \
  "BgAAAAAAAAAHAPj/CQA=</AppendedData></VTKFile>\n"

#endif
