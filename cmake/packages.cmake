# Packages from outside; README.md lists the Debian names, ./course installs them.
find_package(OpenMP)

find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
add_library(glm_headers INTERFACE)
target_include_directories(glm_headers SYSTEM INTERFACE ${GLM_INCLUDE_DIR})

if(KREDA_TOOLS)
  # Debian's OpenImageIO CMake config names a folder that is not installed; its pkg-config file works.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)

  find_path(TINYOBJ_INCLUDE_DIR tiny_obj_loader.h REQUIRED)
  find_library(TINYOBJ_LIBRARY tinyobjloader REQUIRED)
  add_library(tinyobjloader_lib INTERFACE)
  target_include_directories(tinyobjloader_lib SYSTEM INTERFACE ${TINYOBJ_INCLUDE_DIR})
  target_link_libraries(tinyobjloader_lib INTERFACE ${TINYOBJ_LIBRARY})

  find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)
  add_library(tomlplusplus_headers INTERFACE)
  target_include_directories(tomlplusplus_headers SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE_DIR})
  target_compile_definitions(tomlplusplus_headers INTERFACE TOML_HEADER_ONLY=1 TOML_ENABLE_FORMATTERS=0)

  # Without it Kreda reads OBJ alone.
  find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h)

  find_package(PNG REQUIRED)
  find_package(Freetype REQUIRED)
  find_package(ZLIB REQUIRED)
  find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
  find_path(NLOHMANN_INCLUDE_DIR nlohmann/json.hpp REQUIRED)
  add_library(command_line_headers INTERFACE)
  target_include_directories(command_line_headers SYSTEM INTERFACE ${CLI11_INCLUDE_DIR} ${NLOHMANN_INCLUDE_DIR})
endif()

if(KREDA_TESTS)
  find_path(DOCTEST_INCLUDE_DIR doctest/doctest.h REQUIRED)
  add_library(doctest_headers INTERFACE)
  target_include_directories(doctest_headers SYSTEM INTERFACE ${DOCTEST_INCLUDE_DIR})
endif()
