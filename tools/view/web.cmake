# Kreda as a WebAssembly module, and the page around it: what the preset `web` builds, with Debian's emscripten.
#   build/web/share/kreda/view.html     the page, without a scene; `kreda view` puts one in
#   build/web/bin/hash_scenes.js        a program for node that shows that the module draws the same bits
# The rooms are compiled as they are. Of scene/files only what needs OpenImageIO, libpng or other processes stays out:
# tools/view/web_images.cpp reads images instead.

# Debian's headers lie beside those of its own C library, which must not be seen: each package gets a folder of its own.
set(web_headers ${CMAKE_BINARY_DIR}/headers)
foreach(header IN ITEMS glm toml++ tiny_obj_loader.h tiny_gltf.h nlohmann stb)
  if(NOT EXISTS /usr/include/${header})
    message(FATAL_ERROR "/usr/include/${header} is missing: ./course build web installs what is needed")
  endif()
  file(MAKE_DIRECTORY ${web_headers})
  file(CREATE_LINK /usr/include/${header} ${web_headers}/${header} SYMBOLIC)
endforeach()
add_library(glm_headers INTERFACE)
target_include_directories(glm_headers SYSTEM INTERFACE ${web_headers})

# One thread unless asked for more; 128-bit lanes; exceptions as the browser has them; a double beyond all integers needs no branch. Loops are not
# unrolled, and types have no names: a twentieth of the bytes; pictures with an environment take 8 % longer. A broken contract between functions is a trap or a wrong picture in a box of
# its own: its messages stay out.
target_compile_options(kreda_flags INTERFACE -msimd128 -mnontrapping-fptoint -fwasm-exceptions -fno-unroll-loops -fno-rtti -Wno-unknown-pragmas -Wno-unused-variable
  "SHELL:-include ${PROJECT_SOURCE_DIR}/tools/view/web_std.hpp")
target_compile_definitions(kreda_flags INTERFACE NDEBUG TOML_HEADER_ONLY=1 TOML_ENABLE_FORMATTERS=0)
target_link_options(kreda_flags INTERFACE -fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB)

# The preset `web-threads`: the same module in as many threads as there are cores, for pages from a server that sends the
# two headers which browsers ask for before threads may share memory (docs/site/serve.py).
if(KREDA_WEB_THREADS)
  target_compile_options(kreda_flags INTERFACE -pthread -fopenmp)
  target_include_directories(kreda_flags INTERFACE ${PROJECT_SOURCE_DIR}/tools/view/openmp)
  target_link_options(kreda_flags INTERFACE -pthread "-sPTHREAD_POOL_SIZE='(Module.threads||7)-1'" -Wno-pthreads-mem-growth)
endif()

# emcc's own scripts look for Debian's packages, which another node than Debian's does not find.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")

kreda_room(raster PUBLIC glm_headers)
if(KREDA_WEB_THREADS)
  add_library(kreda_openmp STATIC ${PROJECT_SOURCE_DIR}/tools/view/openmp/web_openmp.cpp)
  target_link_libraries(kreda_openmp PUBLIC kreda_flags)
  target_link_libraries(kreda_raster PUBLIC kreda_openmp)
endif()
kreda_room(lighting PUBLIC kreda_raster)
kreda_room(shadows PUBLIC kreda_raster)
kreda_room(scene PUBLIC kreda_lighting kreda_shadows)
get_target_property(scene_sources kreda_scene SOURCES)
list(FILTER scene_sources EXCLUDE REGEX
  "/(image_file|open_image|image_module|image_message|child_process|png_bytes|deflate_strips|write_image|webp_file|environment_cache|whole_file)\\.cpp$")
list(FILTER scene_sources EXCLUDE REGEX "/gltf_absent\\.cpp$")
set_source_files_properties(${PROJECT_SOURCE_DIR}/scene/files/gltf_model.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
set_target_properties(kreda_scene PROPERTIES SOURCES "${scene_sources}")

# What is done once for a file or a change takes no time worth its bytes: it is compiled for size. emcc forbids with -Oz to put calls in line, though
# the body of a small function takes fewer bytes than a call of it.
set(for_size -Oz -finline-functions)
set(once "/scene/(files|plan)/|/scene/[a-z_]+\\.cpp$|/lighting/(energy|light|reflect|spectrum|spectrum_data)\\.cpp$"
  "|/scene/render/(bake_passes|debug_pixel|frame_done|frame_passes|frame_shadows|render|walk_passes)\\.cpp$"
  "|/lighting/environment/(bake_cost|environment|progress)\\.cpp$|/shadows/light_view\\.cpp$"
  "|/raster/(camera|corner_clusters|film|mesh_checks|normals|polygon|rasterize_reference|reference_pipeline|shapes|specks|tangents|teapot|texture|torus_knot)\\.cpp$")
string(CONCAT once ${once})
set(once_sources ${PROJECT_SOURCE_DIR}/tools/view/web_images.cpp ${PROJECT_SOURCE_DIR}/tools/view/web_libraries.cpp)
foreach(room IN ITEMS raster lighting shadows scene)
  get_target_property(always kreda_${room} SOURCES)
  set(of_room ${always})
  list(FILTER of_room INCLUDE REGEX "${once}")
  list(FILTER always EXCLUDE REGEX "${once}")
  list(APPEND once_sources ${of_room})
  set_target_properties(kreda_${room} PROPERTIES SOURCES "${always}")
endforeach()
# What these loops call is longer than clang puts in line by itself, and a loop with a call in it stays scalar: one triangle or texel
# after the other instead of four at once. `-Rpass=loop-vectorize` lists the loops that got vectors.
set(in_line raster/rasterize_tile raster/judge_lanes raster/texture_passes lighting/environment/prefilter lighting/environment/environment_image)
list(TRANSFORM in_line REPLACE ".+" "${PROJECT_SOURCE_DIR}/\\0.cpp")
set_source_files_properties(${in_line} PROPERTIES COMPILE_OPTIONS "-mllvm;-inline-threshold=3000")
add_library(kreda_once STATIC ${once_sources})
target_compile_options(kreda_once PRIVATE ${for_size})
target_link_libraries(kreda_once PUBLIC kreda_scene)
target_link_libraries(kreda_raster PUBLIC kreda_once)  # each calls the other

file(GLOB explain_sources ${PROJECT_SOURCE_DIR}/tools/explain/*.cpp)
list(FILTER explain_sources EXCLUDE REGEX "_command\\.cpp$")
add_library(kreda_explain OBJECT ${explain_sources})
target_link_libraries(kreda_explain PUBLIC kreda_scene)
target_compile_options(kreda_explain PRIVATE ${for_size})

add_executable(kreda_web ${PROJECT_SOURCE_DIR}/tools/view/web_module.cpp
  ${PROJECT_SOURCE_DIR}/tools/view/viewer.cpp ${PROJECT_SOURCE_DIR}/tools/view/explain_on_screen.cpp
  ${PROJECT_SOURCE_DIR}/tools/view/scene_text.cpp
  ${PROJECT_SOURCE_DIR}/tools/keys_json.cpp ${PROJECT_SOURCE_DIR}/tools/mesh_scene.cpp)
target_link_libraries(kreda_web PRIVATE kreda_scene kreda_explain)
set_target_properties(kreda_web PROPERTIES UNITY_BUILD OFF)
target_compile_options(kreda_web PRIVATE ${for_size})
set_source_files_properties(${PROJECT_SOURCE_DIR}/tools/view/viewer.cpp PROPERTIES COMPILE_OPTIONS -O3)
target_link_options(kreda_web PRIVATE --no-entry -sMODULARIZE=1 -sEXPORT_NAME=makeKreda -sEXPORTED_RUNTIME_METHODS=ccall,FS
  -sEXPORTED_FUNCTIONS=_malloc,_free -sENVIRONMENT=web,worker,node -sFILESYSTEM=1 -O2)  # -Oz here: 7 KB less, pictures a fifth slower

# What packs the module for the page, for node, and what unpacks it, for the page.
foreach(tool IN ITEMS packer unpacker)
  add_executable(${tool} ${PROJECT_SOURCE_DIR}/tools/view/pack/web_packer.cpp)
  target_compile_features(${tool} PRIVATE cxx_std_20)
  target_compile_options(${tool} PRIVATE -O2 -fno-unroll-loops -msimd128 -mnontrapping-fptoint -ffp-contract=off -fno-exceptions -fno-rtti)
  target_link_options(${tool} PRIVATE -O2 --no-entry -sSTANDALONE_WASM=1 -sINITIAL_MEMORY=192MB)
  set_target_properties(${tool} PROPERTIES SUFFIX .wasm)
endforeach()
target_compile_definitions(packer PRIVATE KREDA_PACK=1)

set(view_page ${CMAKE_BINARY_DIR}/share/kreda/view.html)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/kreda)
file(GLOB page_parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/view/page/*)
add_custom_command(OUTPUT ${view_page} BYPRODUCTS ${CMAKE_BINARY_DIR}/share/kreda/view_module.txt DEPENDS kreda_web packer unpacker ${page_parts} ${PROJECT_SOURCE_DIR}/tools/view/bundle.mjs
  COMMAND ${NODE_JS_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/view/bundle.mjs
          $<TARGET_FILE:kreda_web> $<TARGET_FILE_DIR:kreda_web>/kreda_web.wasm $<TARGET_FILE:packer> $<TARGET_FILE:unpacker> ${view_page}
  COMMENT "Writing share/kreda/view.html" VERBATIM)
add_custom_target(view_page ALL DEPENDS ${view_page})

# Assignments in the browser: what grades them, without the box; tools/view/edit compiles and runs the student's file.
file(GLOB grade_sources ${PROJECT_SOURCE_DIR}/tools/grade/assignment/*.cpp)
list(FILTER grade_sources INCLUDE REGEX
  "/(a[0-9]_[a-z_]+|argument_text|assignment|light_columns|rubric|scene_case|scene_record|score|stage_check|stage_table|table_reader)\\.cpp$")
set(tools ${PROJECT_SOURCE_DIR}/tools)
add_library(grade_assignments OBJECT EXCLUDE_FROM_ALL ${grade_sources})
target_link_libraries(grade_assignments PUBLIC kreda_scene)
set_target_properties(grade_assignments PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
target_compile_options(grade_assignments PRIVATE ${for_size})
add_executable(grade_web EXCLUDE_FROM_ALL ${tools}/view/web_grade.cpp
  ${tools}/view/web_png.cpp ${tools}/base64.cpp ${tools}/grade/result_json.cpp ${tools}/grade/plain_text.cpp
  ${tools}/escape_html.cpp ${tools}/compare/compare.cpp ${tools}/compare/compare_pictures.cpp)
target_link_libraries(grade_web PRIVATE kreda_scene kreda_explain grade_assignments)
set_target_properties(grade_web PROPERTIES UNITY_BUILD OFF)
target_compile_options(grade_web PRIVATE ${for_size})
target_link_options(grade_web PRIVATE --no-entry -sMODULARIZE=1 -sEXPORT_NAME=makeKreda -sEXPORTED_RUNTIME_METHODS=ccall,FS
  -sEXPORTED_FUNCTIONS=_malloc,_free -sENVIRONMENT=web,worker,node -sFILESYSTEM=1 -O2)

# Programs for node, not built unless they are asked for: `node hash_scenes.js`, `node time_passes.js 30 SCENE.toml`.
add_executable(hash_scenes EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/variants/hash_scenes.cpp)
target_link_options(hash_scenes PRIVATE -O1 -sENVIRONMENT=node -sSINGLE_FILE=1 -sEXIT_RUNTIME=1)
target_link_libraries(hash_scenes PRIVATE kreda_scene)
add_executable(time_passes EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/view/time_passes.cpp)
target_link_options(time_passes PRIVATE -O2 -sENVIRONMENT=node -sSINGLE_FILE=1 -sNODERAWFS=1)
target_link_libraries(time_passes PRIVATE kreda_scene)
