# `cmake --install BUILD --component karcher` installs the library, its public headers
# (headers.cmake) and the files that `find_package(karcher)` reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(KARCHER_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/karcher)

install(TARGETS karcher EXPORT karcherTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT karcher)
install(CODE "
  include(\"${CMAKE_CURRENT_LIST_DIR}/headers.cmake\")
  karcher_write_headers(\"${CMAKE_CURRENT_LIST_DIR}\" \"${PROJECT_BINARY_DIR}/include\" read)
" COMPONENT karcher)
install(DIRECTORY ${PROJECT_BINARY_DIR}/include/karcher DESTINATION include COMPONENT karcher)
install(EXPORT karcherTargets NAMESPACE karcher:: DESTINATION ${KARCHER_PACKAGE} COMPONENT karcher)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/karcherConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/karcherConfig.cmake
  ${PROJECT_BINARY_DIR}/karcherConfigVersion.cmake
  DESTINATION ${KARCHER_PACKAGE} COMPONENT karcher)
