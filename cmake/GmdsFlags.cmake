# gmds_flags: how everything of the project is compiled. Predicates need IEEE arithmetic: contraction is off everywhere.
add_library(gmds_flags INTERFACE)
target_compile_features(gmds_flags INTERFACE c_std_17)
set(CMAKE_C_EXTENSIONS OFF)
target_compile_options(gmds_flags INTERFACE
  $<$<COMPILE_LANGUAGE:C>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wundef;-ffp-contract=off>
  $<$<BOOL:${GMDS_WERROR}>:-Werror>)
set(GMDS_SANITIZE "" CACHE STRING "Sanitizers to build with, for instance address,undefined or thread")
if(GMDS_SANITIZE)
  add_compile_options(-fsanitize=${GMDS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${GMDS_SANITIZE})
endif()
option(GMDS_COVERAGE "Build with coverage counters" OFF)
if(GMDS_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
