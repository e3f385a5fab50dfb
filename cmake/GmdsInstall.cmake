# cmake --install: headers (templates included), library, package files for find_package(gmds) and pkg-config. What is
# installed can be moved as a whole: the package files find the rest from where they lie.
include(CMakePackageConfigHelpers)
set(GMDS_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/gmds)
install(TARGETS gmds EXPORT gmdsTargets)
install(DIRECTORY include/gmds/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gmds
  FILES_MATCHING PATTERN "*.h" PATTERN models EXCLUDE PATTERN algorithms EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/include/gmds/config.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gmds)
install(DIRECTORY models algorithms DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gmds FILES_MATCHING PATTERN "*.h")
install(EXPORT gmdsTargets NAMESPACE gmds:: DESTINATION ${GMDS_PACKAGE_DIR})
configure_package_config_file(cmake/gmdsConfig.cmake.in ${PROJECT_BINARY_DIR}/gmdsConfig.cmake
  INSTALL_DESTINATION ${GMDS_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gmdsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gmdsConfig.cmake ${PROJECT_BINARY_DIR}/gmdsConfigVersion.cmake
  DESTINATION ${GMDS_PACKAGE_DIR})

set(GMDS_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
set(GMDS_PC_LIBDIR ${CMAKE_INSTALL_FULL_LIBDIR})
set(GMDS_PC_INCLUDEDIR ${CMAKE_INSTALL_FULL_INCLUDEDIR})
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
    OUTPUT_VARIABLE up)
  set(GMDS_PC_PREFIX "\${pcfiledir}/${up}")
  set(GMDS_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(GMDS_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
  endif()
endif()
list(JOIN GMDS_OPTIONAL_LIBRARIES " " GMDS_PC_PRIVATE)
set(GMDS_PC_LIBS "-lgmds")
if(NOT BUILD_SHARED_LIBS AND GMDS_PC_PRIVATE) # who links a static library links what it needs
  string(APPEND GMDS_PC_LIBS " ${GMDS_PC_PRIVATE}")
endif()
configure_file(cmake/gmds.pc.in ${PROJECT_BINARY_DIR}/gmds.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/gmds.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
