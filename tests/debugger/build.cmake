# cmake -DSOURCE=... -DBUILD=... -DCOMPILER=... -DTARGETS=a,b,c -P build.cmake
# Builds programs as the preset `debug` does: a debugger shows nothing useful of optimised ones. At -O0 nearly all time
# goes into reading headers and linking: sources are compiled a dozen at a time (CMake's unity build).
string(REPLACE "," ";" targets "${TARGETS}")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -g" -DKREDA_TESTS=OFF -DKREDA_HASH_ONLY=ON
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "cannot configure:\n${log}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${targets}
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "does not build:\n${log}")
endif()
