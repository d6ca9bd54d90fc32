# The module kreda_images: what needs OpenImageIO, as a shared library that kreda_scene opens when it is needed. Loading
# the 200 libraries that OpenImageIO brings takes longer than drawing most pictures.
set(KREDA_IMAGE_SOURCES scene/files/image_file.cpp scene/files/open_image.cpp)  # these may include OpenImageIO; they are no part of kreda_scene

set(KREDA_IMAGE_HELPERS child_process file_content icc_profile image_color image_orientation quoted_text radiance_header webp_file)  # in both
list(TRANSFORM KREDA_IMAGE_HELPERS REPLACE "(.+)" "scene/files/\\1.cpp")
add_library(kreda_images MODULE ${KREDA_IMAGE_SOURCES} ${KREDA_IMAGE_HELPERS} scene/error.cpp
  raster/aligned_vector.cpp)
target_link_libraries(kreda_images PRIVATE kreda_flags glm_headers PkgConfig::OpenImageIO)
# The program has functions of the same names; hidden ones are not mixed up. Folders are the same in the build and after
# `cmake --install`: bin/kreda and lib/kreda/libkreda_images.so.
set_target_properties(kreda_images PROPERTIES PREFIX lib SUFFIX .so CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/kreda)
if(NOT KREDA_SANITIZE AND NOT APPLE)
  target_link_options(kreda_images PRIVATE -Wl,--no-undefined)  # a missing function is an error of the build
endif()
install(TARGETS kreda_images LIBRARY DESTINATION lib/kreda COMPONENT runtime)

get_target_property(scene_sources kreda_scene SOURCES)
foreach(source ${KREDA_IMAGE_SOURCES})
  list(REMOVE_ITEM scene_sources ${PROJECT_SOURCE_DIR}/${source})
endforeach()
set_target_properties(kreda_scene PROPERTIES SOURCES "${scene_sources}")
add_dependencies(kreda_scene kreda_images)  # whoever builds a program gets the module
target_link_libraries(kreda_scene PRIVATE ${CMAKE_DL_LIBS})
string(REGEX MATCH "^[0-9]+\\.[0-9]+" image_version ${OpenImageIO_VERSION})
set_source_files_properties(scene/files/image_module.cpp PROPERTIES COMPILE_DEFINITIONS
  "KREDA_IMAGES_OF_BUILD=\"${CMAKE_BINARY_DIR}/lib/kreda/libkreda_images.so\";KREDA_IMAGES_PACKAGE=\"libopenimageio${image_version}\"")
