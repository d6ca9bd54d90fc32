# Flags that every target of the project shares.
#
# Exactness: -ffp-contract=off keeps a*b+c two roundings on every machine, so images are the same to the last bit.
# -Wno-restrict: GCC 12 warns falsely about `"text" + std::to_string(n)` (GCC bug 105651).
# Speed without changing a result: -fno-math-errno lets sqrt become one instruction, -fno-trapping-math lets
# the compiler turn `condition ? a : b` into a select, which is what makes a loop vectorize.
add_library(kreda_flags INTERFACE)
# Programs that use the installed library get what exactness asks for, and choose warnings and instruction set themselves.
target_compile_options(kreda_flags INTERFACE
  $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra> $<BUILD_INTERFACE:-Wshadow>
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>
  -ffp-contract=off -fno-math-errno -fno-trapping-math)
# GCC tidies its own memory every few megabytes; not before a gigabyte, a build takes a tenth less time.
target_compile_options(kreda_flags INTERFACE $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>>)
if(KREDA_WERROR)
  target_compile_options(kreda_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(KREDA_MARCH)
  target_compile_options(kreda_flags INTERFACE $<BUILD_INTERFACE:-march=${KREDA_MARCH}>)
endif()
if(KREDA_MULTIVERSION AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_definitions(kreda_flags INTERFACE KREDA_MULTIVERSION=1)
endif()
if(KREDA_SANITIZE)
  target_compile_options(kreda_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # with sanitizers GCC 12 takes the moves of std::regex for reads of what was never set
    target_compile_options(kreda_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
  target_compile_definitions(kreda_flags INTERFACE KREDA_SANITIZED=1)
  target_link_options(kreda_flags INTERFACE -fsanitize=address,undefined)
endif()
if(KREDA_COVERAGE)
  target_compile_options(kreda_flags INTERFACE --coverage -fprofile-abs-path -fprofile-update=atomic)
  target_compile_definitions(kreda_flags INTERFACE KREDA_COVERAGE=1)
  target_link_options(kreda_flags INTERFACE --coverage)
endif()
if(KREDA_FUZZ)  # what is executed is counted, so that the fuzzer sees new ways
  # toml++ 3.3 says of letters between U+00A1 and U+0499 where a space may stand that they cannot come; they are refused all the same.
  target_compile_options(kreda_flags INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=unreachable)
endif()
# Users of GLM see x, y, z in a debugger instead of three names for each component.
target_compile_definitions(kreda_flags INTERFACE GLM_FORCE_XYZW_ONLY)
target_include_directories(kreda_flags INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/kreda>)
target_compile_features(kreda_flags INTERFACE cxx_std_20)

# A room is a folder of headers and sources, inner rooms included, that becomes one static library, kreda_<room>.
function(kreda_room room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp)
  if(sources)
    add_library(kreda_${room} STATIC ${sources})
    target_link_libraries(kreda_${room} PUBLIC kreda_flags ${ARGN})
    if(OpenMP_CXX_FOUND)
      target_link_libraries(kreda_${room} PUBLIC OpenMP::OpenMP_CXX)
    else()
      target_compile_options(kreda_${room} PRIVATE -Wno-unknown-pragmas)
    endif()
  else()
    add_library(kreda_${room} INTERFACE)
    list(FILTER ARGN EXCLUDE REGEX "^(PUBLIC|PRIVATE)$")
    target_link_libraries(kreda_${room} INTERFACE kreda_flags ${ARGN})
  endif()
endfunction()

# kreda_optimize(TARGET -O1): the release build compiles the target at this level, not at the preset's. Its formulas have
# the same bits.
function(kreda_optimize target level)
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${level}>")
endfunction()

# Text, command lines and JSON take long to compile and no time to run: such a target is compiled for the compiler's sake.
function(kreda_compile_lightly target)
  kreda_optimize(${target} -Og)
endfunction()
