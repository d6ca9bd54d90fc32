# cmake -DCOMPILER=g++ -DSOURCE=folder -DFILE=lighting/batch/passes.cpp -P check.cmake
# Compiles FILE for AVX2 as `release` does and asks GCC which loops became vector code. Every loop over lanes,
# "for (int i = 0; i < lanes; ++i)", must be among them, unless its line says "// not vectorized: why".
# A loop in a generic lambda is compiled once a formula; "// 4 formulas" on its line says how many must become vector code.
# noipa: a loop must vectorize by what its own function says. Compiled once for each machine it knows no more of its callers.
set(flags)
if(FILE MATCHES "^lighting/")
  set(flags -fno-thread-jumps)  # as the room is built
endif()
execute_process(COMMAND ${COMPILER} -std=c++20 -O3 -march=x86-64-v3 -fopenmp -ffp-contract=off -fno-math-errno -fno-trapping-math ${flags}
  -DKREDA_MULTIVERSION=1 -DGLM_FORCE_XYZW_ONLY "-DKREDA_BATCH_LOOP=__attribute__((flatten, noipa))" -I${SOURCE}
  -fopt-info-vec-optimized -c ${SOURCE}/${FILE} -o /dev/null
  ERROR_VARIABLE report RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${FILE} does not compile:\n${report}")
endif()
file(READ ${SOURCE}/${FILE} text)
string(REPLACE ";" "," text "${text}")
string(REPLACE "[" "(" text "${text}")
string(REPLACE "]" ")" text "${text}")
string(REPLACE "\n" ";" lines "${text}")
set(number 0)
set(loops 0)
set(scalar "")
foreach(line IN LISTS lines)
  math(EXPR number "${number} + 1")
  if(NOT line MATCHES "for .int i = 0, i < lanes, ..i." OR line MATCHES "// not vectorized: ")
    continue()
  endif()
  math(EXPR loops "${loops} + 1")
  string(REGEX MATCHALL "${FILE}:${number}:[0-9]+: optimized: loop vectorized using 32 byte vectors" found "${report}")
  list(LENGTH found times)
  set(wanted 1)
  if(line MATCHES "// ([0-9]+) formulas")
    set(wanted ${CMAKE_MATCH_1})
  endif()
  if(times LESS wanted)
    list(APPEND scalar "${FILE}:${number}: ${line} (${times} of ${wanted})")
  endif()
endforeach()
if(scalar)
  string(REPLACE ";" "\n" scalar "${scalar}")
  message(FATAL_ERROR "not vectorized:\n${scalar}")
endif()
if(loops EQUAL 0)
  message(FATAL_ERROR "${FILE} holds no loop over lanes: has the pattern changed?")
endif()
message("${loops} loops over lanes, all vectorized")
