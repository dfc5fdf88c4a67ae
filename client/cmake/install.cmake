# What `cmake --install` puts down of the client: the CLI, and in the component client_development
# the library with all that `find_package(remeshd)` needs.
include(CMakePackageConfigHelpers)

if(TARGET remesh)
  install(TARGETS remesh RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# Documents to begin with, and what editors check them by; the image does without.
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/examples/models/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/remeshd/examples COMPONENT documentation
  FILES_MATCHING PATTERN "*.json")
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/schema/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/remeshd/schema COMPONENT documentation
  FILES_MATCHING PATTERN "*.json")
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/docs/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/remeshd/docs COMPONENT documentation
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "generate" EXCLUDE)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/remeshd)
target_include_directories(remeshd_client
  INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_include_directories(remeshd_proto SYSTEM
  INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
set_target_properties(remeshd_client PROPERTIES EXPORT_NAME client)
set_target_properties(remeshd_proto PROPERTIES EXPORT_NAME proto)
set_target_properties(remeshd_checksum PROPERTIES EXPORT_NAME checksum)

install(TARGETS remeshd_client remeshd_proto remeshd_checksum EXPORT remeshdTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT client_development)
install(EXPORT remeshdTargets NAMESPACE remeshd:: DESTINATION ${package_dir}
  COMPONENT client_development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/remeshdConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/remeshdConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/remeshdConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/remeshdConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/remeshdConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT client_development)

# Whoever hands the library on hands its licence on.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSES/Apache-2.0.txt
  DESTINATION ${CMAKE_INSTALL_DATADIR}/remeshd COMPONENT client_development)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/remeshd
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT client_development)
install(DIRECTORY ${PROJECT_BINARY_DIR}/proto/generated/remesh
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT client_development
  FILES_MATCHING PATTERN "*.pb.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/proto/remesh
  DESTINATION ${CMAKE_INSTALL_DATADIR}/remeshd/proto COMPONENT client_development
  FILES_MATCHING PATTERN "*.proto")
