# What `cmake --install` leaves: the program and the module that reads images (component runtime), and what other programs
# need to use the rooms (component development): headers, libraries, and a package for find_package(kreda).
install(TARGETS kreda RUNTIME DESTINATION bin COMPONENT runtime)

set(rooms raster lighting shadows scene)
foreach(room IN LISTS rooms)
  set_target_properties(kreda_${room} PROPERTIES EXPORT_NAME ${room})
  add_library(kreda::${room} ALIAS kreda_${room})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION include/kreda COMPONENT development
    FILES_MATCHING PATTERN "*.hpp" PATTERN "gltf_*" EXCLUDE)
endforeach()
install(TARGETS kreda_raster kreda_lighting kreda_shadows kreda_scene kreda_flags glm_headers tinyobjloader_lib
  tomlplusplus_headers EXPORT kreda_targets ARCHIVE DESTINATION lib COMPONENT development)
install(EXPORT kreda_targets NAMESPACE kreda:: DESTINATION lib/cmake/kreda COMPONENT development)

include(CMakePackageConfigHelpers)
configure_package_config_file(cmake/kredaConfig.cmake.in ${PROJECT_BINARY_DIR}/kredaConfig.cmake
  INSTALL_DESTINATION lib/cmake/kreda)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kredaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kredaConfig.cmake ${PROJECT_BINARY_DIR}/kredaConfigVersion.cmake
  DESTINATION lib/cmake/kreda COMPONENT development)

# Debian packages: `cpack -G DEB` in the build folder makes kreda, and libkreda-dev with the libraries.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/kreda RENAME copyright COMPONENT runtime)
set(CPACK_PACKAGE_NAME kreda)
set(CPACK_PACKAGE_VENDOR "The authors of Kreda")
set(CPACK_PACKAGE_CONTACT "The authors of Kreda <kreda@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME kreda)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS gnuplot-nox)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkreda-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "kreda (= ${PROJECT_VERSION}), libglm-dev, libpng-dev, libtinyobjloader-dev")
include(CPack)
