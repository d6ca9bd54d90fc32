# glTF is read where tinygltf is installed; it and the JSON library are headers, so no program is slower to start.
get_target_property(scene_sources kreda_scene SOURCES)
if(TINYGLTF_INCLUDE_DIR)
  list(REMOVE_ITEM scene_sources ${PROJECT_SOURCE_DIR}/scene/files/gltf_absent.cpp)
  target_include_directories(kreda_scene SYSTEM PRIVATE ${TINYGLTF_INCLUDE_DIR} ${NLOHMANN_INCLUDE_DIR})
  # Compiled once and never changed: long to compile, and the reading of text is no place for speed.
  set_source_files_properties(scene/files/gltf_model.cpp PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O1>" SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
else()
  list(FILTER scene_sources EXCLUDE REGEX "/scene/files/gltf_(accessor|file|lights|material|model|nodes|primitive)\\.cpp$")
  message(STATUS "tinygltf is not installed (libtinygltf-dev): glTF files are not read")
endif()
set_target_properties(kreda_scene PROPERTIES SOURCES "${scene_sources}")
