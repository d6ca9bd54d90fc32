# Headers that nearly every source includes, parsed once a target instead of once a file: a third of the time of a build.
# Each file still includes what it uses: a build with -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows what is missing, and
# the variants in tests/variants are built so.
set(KREDA_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional>
  <random> <span> <sstream> <string> <string_view> <utility> <vector>
  <glm/common.hpp> <glm/geometric.hpp> <glm/mat3x3.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp> <glm/trigonometric.hpp>
  <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp>)

# kreda_precompile(TARGET [HEADER...]): the common headers and these. Not for the rooms of formulas: with a precompiled
# <string> GCC 12 takes std::string's own code for ours and warns falsely about it, so two warnings are off here.
set(KREDA_PRECOMPILED_WARNINGS
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
function(kreda_precompile target)
  target_precompile_headers(${target} PRIVATE ${KREDA_COMMON_HEADERS} ${ARGN})
  target_compile_options(${target} PRIVATE ${KREDA_PRECOMPILED_WARNINGS})
endfunction()

# kreda_compile_together(TARGET): sources of text, JSON and command lines, whose headers take longer than they do, are
# compiled several at a time (CMake's unity build), in a third of the time: a folder at once, or where a target has one
# folder eight files. Names in unnamed namespaces are therefore unlike within a folder (CONTRIBUTING.md).
# KREDA_COMPILE_TOGETHER=OFF compiles each file by itself again.
option(KREDA_COMPILE_TOGETHER "Compile tools and tests several sources at a time" ON)
function(kreda_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREDA_COMPILE_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
endfunction()
function(kreda_compile_folders_together target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${source})
    string(REGEX REPLACE "/[^/]*$" "" folder ${name})
    string(REPLACE "/" "_" folder ${folder})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREDA_COMPILE_TOGETHER} UNITY_BUILD_MODE GROUP)
endfunction()
