# cmake -DPROGRAM=... -DSOURCE=... -DFOLDER=... -DVARIANT=name [-DTHIRD=third]
#   [-DBUILT=... | -DCOMPILER=... -DFLAGS=... [-DMACHINE=aarch64]] -P compare.cmake
# Hashes from PROGRAM against those of the variant (the program BUILT, or one that is built here; VARIANT=kept: those
# of tests/variants/hashes.txt), line by line; says which scenes differ. MACHINE: COMPILER makes programs for that kind
# of processor, and qemu runs them.

function(run_hashes program out)
  execute_process(COMMAND ${program} ${ARGN} OUTPUT_VARIABLE text RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${program} ${ARGN} ended with ${code}")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/../same_lines.cmake)

run_hashes(${PROGRAM} expected 2 ${THIRD})
if(VARIANT STREQUAL "threads")
  run_hashes(${PROGRAM} one 1)
  run_hashes(${PROGRAM} seven 7)
  run_hashes(${PROGRAM} shuffled 2 shuffle)
  expect_same("1 thread" "${expected}" "${one}")
  expect_same("7 threads" "${expected}" "${seven}")
  expect_same("shuffled tiles" "${expected}" "${shuffled}")
  return()
endif()

if(VARIANT STREQUAL "kept")
  file(READ ${CMAKE_CURRENT_LIST_DIR}/hashes.txt kept)
  expect_same("tests/variants/hashes.txt" "${kept}" "${expected}")
  return()
endif()

if(BUILT)
  run_hashes(${BUILT} actual 2 ${THIRD})
  expect_same("${VARIANT}" "${expected}" "${actual}")
  return()
endif()

find_program(compiler_path ${COMPILER})
if(NOT compiler_path)
  message("SKIPPED: ${COMPILER} is not installed")
  return()
endif()
if(MACHINE)
  find_program(emulator qemu-${MACHINE})
  if(NOT emulator)
    message("SKIPPED: qemu-${MACHINE} is not installed (qemu-user)")
    return()
  endif()
  set(machine -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=${MACHINE})
  set(emulated ${emulator} -L /usr/${MACHINE}-linux-gnu)  # its libraries, as Debian's cross compiler has them
endif()
foreach(flag IN ITEMS avx2 avx512f)
  file(STRINGS /proc/cpuinfo has_${flag} REGEX "^flags.* ${flag}( |$)" LIMIT_COUNT 1)
endforeach()
if((FLAGS MATCHES "v3" AND NOT has_avx2) OR (FLAGS MATCHES "v4" AND NOT has_avx512f))
  message("SKIPPED: this processor cannot run ${FLAGS}")
  return()
endif()

set(build ${FOLDER}/${VARIANT})
if(FREQUENT)  # run by every `./course test`: a dozen sources at a time, which takes half as long
  set(unity -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12)
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G Ninja -DCMAKE_CXX_COMPILER=${compiler_path}
  -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=${FLAGS}" -DKREDA_TOOLS=OFF -DKREDA_TESTS=OFF -DKREDA_HASH_ONLY=ON
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON ${unity} ${machine}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --target hash_scenes OUTPUT_VARIABLE log RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${VARIANT} does not build:\n${log}")
endif()
run_hashes("${emulated};${build}/bin/hash_scenes" actual 2 ${THIRD})
expect_same("${COMPILER} ${FLAGS}" "${expected}" "${actual}")
