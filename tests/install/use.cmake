# cmake -DMODE=... -P use.cmake: installs the project and uses it from outside, see the modes at the end.
cmake_minimum_required(VERSION 3.25)
set(ENV{LC_ALL} C)
set(strict -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wundef -Werror)
set(example ${SOURCE}/examples/square.c)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})

# Runs a command; ends the test if it fails.
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${failed}): ${command}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

function(must_print_two_triangles program)
  must(${program})
  if(NOT said STREQUAL "2 triangles\n")
    message(FATAL_ERROR "${program} prints ${said}")
  endif()
endfunction()

function(public_headers result)
  file(GLOB headers RELATIVE ${PREFIX}/include ${PREFIX}/include/gmds/*.h)
  list(REMOVE_ITEM headers gmds/mesh.h gmds/end.h)
  set(${result} "${headers}" PARENT_SCOPE)
endfunction()

function(use_by_cmake prefix)
  list(GET COMPILERS 0 compiler)
  must(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/package -B ${SCRATCH}/package -G ${GENERATOR}
    "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_C_COMPILER=${compiler} -DSOURCE=${example}
    "-DCMAKE_C_FLAGS=-Wall -Wextra -Werror")
  must(${CMAKE_COMMAND} --build ${SCRATCH}/package)
  must_print_two_triangles(${SCRATCH}/package/square)
endfunction()

function(use_by_pkg_config prefix)
  file(GLOB_RECURSE pc ${prefix}/*/gmds.pc)
  cmake_path(GET pc PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} "${folder}")
  must(${PKG_CONFIG} --cflags --libs gmds)
  separate_arguments(flags UNIX_COMMAND "${said}")
  foreach(compiler ${COMPILERS})
    foreach(standard c11 c17)
      must(${compiler} -std=${standard} ${strict} ${example} -o ${SCRATCH}/square ${flags})
      must_print_two_triangles(${SCRATCH}/square)
    endforeach()
    must(${compiler} -std=c17 ${strict} ${SOURCE}/examples/cube.c -o ${SCRATCH}/cube ${flags})
    must(${SCRATCH}/cube)
    if(NOT said STREQUAL "12 tetrahedra, 12 of them at the middle\n")
      message(FATAL_ERROR "cube prints ${said}")
    endif()
  endforeach()
endfunction()

if(MODE STREQUAL "stage") # installs into PREFIX
  file(REMOVE_RECURSE "${PREFIX}")
  must(${CMAKE_COMMAND} --install ${BUILD} --prefix "${PREFIX}")

elseif(MODE STREQUAL "files") # every header of the tree, and no source, build file or link is installed
  file(GLOB_RECURSE tree RELATIVE ${SOURCE} ${SOURCE}/include/gmds/*.h ${SOURCE}/models/*.h ${SOURCE}/algorithms/*.h)
  list(TRANSFORM tree REPLACE "^include/gmds/" "")
  list(APPEND tree config.h)
  list(SORT tree)
  list(REMOVE_DUPLICATES tree)
  file(GLOB_RECURSE installed RELATIVE ${PREFIX}/include/gmds ${PREFIX}/include/*)
  list(SORT installed)
  if(NOT tree STREQUAL installed)
    message(FATAL_ERROR "headers of the tree: ${tree}\nheaders installed: ${installed}")
  endif()
  file(GLOB_RECURSE all LIST_DIRECTORIES TRUE ${PREFIX}/*)
  foreach(file ${all})
    if(IS_SYMLINK "${file}" OR file MATCHES "\\.(c|cpp|in)$|CMakeLists.txt$")
      message(SEND_ERROR "installed: ${file}")
    endif()
  endforeach()

elseif(MODE STREQUAL "package") # find_package(gmds)
  use_by_cmake("${PREFIX}")

elseif(MODE STREQUAL "pkg_config") # pkg-config and a compiler, no warning by any
  use_by_pkg_config("${PREFIX}")

elseif(MODE STREQUAL "headers") # each header by itself
  public_headers(headers)
  foreach(header ${headers} gmds/models/tables.h gmds/models/choice.h)
    file(WRITE ${SCRATCH}/alone.c "#include <${header}>\n#include <${header}>\ntypedef int not_empty;\n")
    foreach(compiler ${COMPILERS})
      must(${compiler} -std=c11 ${strict} "-I${PREFIX}/include" -c ${SCRATCH}/alone.c -o ${SCRATCH}/alone.o)
    endforeach()
    if(CXX)
      file(COPY_FILE ${SCRATCH}/alone.c ${SCRATCH}/alone.cpp)
      must(${CXX} -std=c++17 -Wall -Wextra -Werror "-I${PREFIX}/include" -c ${SCRATCH}/alone.cpp -o ${SCRATCH}/alone.o)
    endif()
  endforeach()

  file(GLOB named RELATIVE ${PREFIX}/include ${PREFIX}/include/gmds/named/*.h)
  list(LENGTH named n)
  if(n LESS 10)
    message(FATAL_ERROR "only ${n} named models are installed")
  endif()
  foreach(header ${named}) # each named model opens, on tetrahedra, on its usual cells, and twice in one file
    file(WRITE ${SCRATCH}/named.c
      "#define GMDS_PREFIX one\n#define GMDS_REGIONS TETRAHEDRON\n#include <${header}>\n#include <gmds/end.h>\n"
      "#define GMDS_PREFIX other\n#include <${header}>\n#include <gmds/end.h>\n"
      "one_mesh a;\nother_mesh b;\n")
    foreach(compiler ${COMPILERS})
      must(${compiler} -std=c11 ${strict} "-I${PREFIX}/include" -c ${SCRATCH}/named.c -o ${SCRATCH}/alone.o)
    endforeach()
  endforeach()

elseif(MODE STREQUAL "cpp") # all headers in one C++ program
  public_headers(headers)
  list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
  string(CONCAT headers ${headers})
  file(WRITE ${SCRATCH}/every_header.h "${headers}")
  file(GLOB_RECURSE library ${PREFIX}/lib*/libgmds.*)
  must(${CXX} -std=c++17 -Wall -Wextra -Werror -I${SCRATCH} "-I${PREFIX}/include"
    ${SOURCE}/tests/install/every_header.cpp -o ${SCRATCH}/every_header "${library}" ${LIBRARIES} -lm)
  must(${SCRATCH}/every_header)

elseif(MODE STREQUAL "width") # a program compiled for other identifiers names what it misses
  math(EXPR other "96 - ${ID_BITS}")
  file(COPY ${PREFIX}/include DESTINATION ${SCRATCH})
  file(READ ${SCRATCH}/include/gmds/config.h config)
  string(REPLACE "GMDS_ID_BITS ${ID_BITS}" "GMDS_ID_BITS ${other}" config "${config}")
  file(WRITE ${SCRATCH}/include/gmds/config.h "${config}")
  file(GLOB_RECURSE library ${PREFIX}/lib*/libgmds.*)
  foreach(compiler ${COMPILERS})
    foreach(optimised -O0 -O2)
      must(${compiler} ${optimised} -I${SCRATCH}/include -c ${example} -o ${SCRATCH}/square.o)
      execute_process(COMMAND ${compiler} ${SCRATCH}/square.o "${library}" ${LIBRARIES} -lm -o ${SCRATCH}/square
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
      if(NOT failed OR NOT said MATCHES "gmds_compiled_for_${other}_bit_ids")
        message(FATAL_ERROR "${compiler} ${optimised} links identifiers of ${other} bits (${failed})\n${said}")
      endif()
    endforeach()
  endforeach()

elseif(MODE STREQUAL "shared") # the library alone, shared, from a configuration of its own
  set(prefix "${SCRATCH}/a prefix with blanks")
  list(GET COMPILERS 0 compiler)
  must(${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH}/build -G ${GENERATOR} -DCMAKE_C_COMPILER=${compiler}
    -DBUILD_SHARED_LIBS=ON -DGMDS_BUILD_TOOLS=OFF -DGMDS_BUILD_TESTS=OFF -DCMAKE_BUILD_TYPE=Release -DGMDS_WERROR=ON
    -DGMDS_ID_BITS=${ID_BITS} "-DCMAKE_INSTALL_PREFIX=${prefix}")
  must(${CMAKE_COMMAND} --build ${SCRATCH}/build)
  must(${CMAKE_COMMAND} --install ${SCRATCH}/build)
  use_by_cmake("${prefix}")
  file(GLOB_RECURSE library ${prefix}/libgmds.so ${prefix}/libgmds.dylib)
  if(NOT library)
    message(FATAL_ERROR "no shared library in ${prefix}")
  endif()
  cmake_path(GET library PARENT_PATH folder)
  set(ENV{LD_LIBRARY_PATH} "${folder}")
  if(PKG_CONFIG)
    use_by_pkg_config("${prefix}")
  endif()

else()
  message(FATAL_ERROR "no such mode: '${MODE}'")
endif()
