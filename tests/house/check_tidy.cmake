# cmake -DSOURCE=folder -DFOLDER=scratch -DCLANG_TIDY=program -DTINYGLTF=folder -DFREETYPE=folders -DWHAT=headers|ROOM
#   -P check_tidy.cmake
# The list of .clang-tidy holds: for all headers together, or for the sources of a room, of which twelve of a folder are
# looked at together. Most of the time goes into the headers of libraries, so that is seven times as fast as one by one.
if(NOT CLANG_TIDY)
  message("SKIPPED: clang-tidy is not installed")
  return()
endif()
set(rooms raster lighting shadows scene tools examples)
# These do not belong to one program: lessons' exercises, pages that take a lesson's place, a file for who has no tinygltf.
set(left_out "^examples/assignments/|/live\\.cpp$|^scene/files/gltf_absent\\.cpp$")
# OpenImageIO's header is not looked at, nor what stands in for LLVM's OpenMP in a browser, under reserved names.
string(APPEND left_out "|^scene/files/(image_file|open_image)\\.[ch]pp$|^tools/view/openmp/")
if(NOT TINYGLTF)
  string(APPEND left_out "|/gltf_(accessor|file|lights|material|model|nodes|primitive)\\.[ch]pp$")
endif()
if(NOT FREETYPE)
  string(APPEND left_out "|^tools/draw/type\\.cpp$")
endif()
file(REMOVE_RECURSE ${FOLDER}/${WHAT})
file(MAKE_DIRECTORY ${FOLDER}/${WHAT})

# Append an include to a file of those that are looked at.
function(look_at file name)
  file(APPEND ${FOLDER}/${WHAT}/${file}.cpp "#include \"${name}\"\n")
endfunction()

if(WHAT STREQUAL "headers")
  list(TRANSFORM rooms APPEND "/*.hpp" OUTPUT_VARIABLE patterns)
else()
  set(patterns "${WHAT}/*.cpp")
endif()
list(TRANSFORM patterns PREPEND "${SOURCE}/")
file(GLOB_RECURSE names RELATIVE ${SOURCE} ${patterns})
list(FILTER names EXCLUDE REGEX "${left_out}")
set(last_folder "")
foreach(name IN LISTS names)
  get_filename_component(folder ${name} DIRECTORY)
  if(WHAT STREQUAL "headers")
    look_at(all ${name})
  elseif(name MATCHES "^examples/|/web_[a-z]+\\.cpp$")  # a program by itself
    string(MAKE_C_IDENTIFIER ${name} alone)
    look_at(${alone} ${name})
  else()
    if(NOT folder STREQUAL last_folder)
      set(count 0)
    endif()
    set(last_folder ${folder})
    math(EXPR part "${count} / 12")
    math(EXPR count "${count} + 1")
    string(MAKE_C_IDENTIFIER ${folder} together)
    look_at(${together}_${part} ${name})
  endif()
endforeach()

set(flags -std=c++20 -I${SOURCE} -DGLM_FORCE_XYZW_ONLY -DTOML_HEADER_ONLY=1 -DTOML_ENABLE_FORMATTERS=0
  -Wno-unknown-pragmas -DKREDA_EXAMPLE_FOLDER="" -DKREDA_VERSION="" -DKREDA_IMAGES_OF_BUILD=""
  -DKREDA_IMAGES_PACKAGE="" -DKREDA_COURSE_FOLDER="" -DKREDA_VIEW_PAGE_OF_BUILD="")
foreach(folder IN LISTS FREETYPE)
  list(APPEND flags -isystem${folder})
endforeach()
list(JOIN rooms "|" rooms)
file(GLOB files ${FOLDER}/${WHAT}/*.cpp)
set(report "")
foreach(file IN LISTS files)
  execute_process(COMMAND ${CLANG_TIDY} --quiet --config-file=${SOURCE}/.clang-tidy
    "--header-filter=/(${rooms})/.*[.][ch]pp$" ${file} -- ${flags}
    OUTPUT_VARIABLE found ERROR_VARIABLE ignored RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message("${found}")
    string(APPEND report "${found}")
  endif()
endforeach()
if(report)
  message(FATAL_ERROR "clang-tidy's chosen list does not hold")
endif()
