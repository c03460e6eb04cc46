# What `cmake --install` gives: headers, library, CMake package, pkg-config file and, where it is
# built, the program and what it shares. All paths inside are relative, so that the tree may be moved.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/groundgrid)

install(TARGETS groundgrid EXPORT groundgridTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/groundgrid
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT groundgridTargets NAMESPACE groundgrid:: DESTINATION ${package_dir})
# A shared library brings what it is linked with; a static one leaves that to its user.
set(package_needs_tbb OFF)
set(package_needs_hwy OFF)
set(package_needs_threads OFF)
set(pkgconfig_requires "eigen3 >= 3.4")
set(pkgconfig_libs "")
get_target_property(library_type groundgrid TYPE)
if(library_type STREQUAL "STATIC_LIBRARY")
  set(package_needs_hwy ON)
  string(APPEND pkgconfig_requires ", libhwy")
endif()
if(library_type STREQUAL "STATIC_LIBRARY" AND GROUNDGRID_STD_THREAD)
  set(package_needs_threads ON)
  set(pkgconfig_libs " -pthread")
elseif(library_type STREQUAL "STATIC_LIBRARY")
  set(package_needs_tbb ON)
  string(APPEND pkgconfig_requires ", tbb")
endif()
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/groundgridConfig.cmake.in groundgridConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(groundgridConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/groundgridConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/groundgridConfigVersion.cmake
  DESTINATION ${package_dir})

file(RELATIVE_PATH pkgconfig_to_prefix
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pkgconfig_to_prefix "${pkgconfig_to_prefix}")
file(RELATIVE_PATH prefix_to_include ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(RELATIVE_PATH prefix_to_library ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
configure_file(${PROJECT_SOURCE_DIR}/cmake/groundgrid.pc.in groundgrid.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/groundgrid.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(TARGET groundgrid_executable)
  file(RELATIVE_PATH program_to_library ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(groundgrid_executable PROPERTIES
    INSTALL_RPATH "$ORIGIN/${program_to_library}")
  install(TARGETS groundgrid_executable RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/semantic-kitti-api
    DESTINATION ${CMAKE_INSTALL_DATADIR}/groundgrid)
endif()
