# `cmake --install BUILD --component karcher`: the library, its headers and what `find_package(karcher)`
# reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(KARCHER_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/karcher)

install(TARGETS karcher EXPORT karcherTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT karcher)
install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/ DESTINATION include/karcher COMPONENT karcher
  FILES_MATCHING PATTERN *.h PATTERN peers EXCLUDE)
install(EXPORT karcherTargets NAMESPACE karcher:: DESTINATION ${KARCHER_PACKAGE} COMPONENT karcher)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/karcherConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/karcherConfig.cmake
  ${PROJECT_BINARY_DIR}/karcherConfigVersion.cmake
  DESTINATION ${KARCHER_PACKAGE} COMPONENT karcher)
