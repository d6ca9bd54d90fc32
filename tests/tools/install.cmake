# cmake -DBUILD=... -DFOLDER=... -DSCENE=... -DCONSUMER=... -DCOMPILER=... -P install.cmake
# Installs into an empty folder and renders a scene with textures there: program and module must find each other. Then a
# program of somebody else is built against what was installed, in a folder of its own, and draws the same bits.
file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/prefix)

# run(WHAT COMMAND...): stops the test with all that was printed when the command fails; leaves that in `log`.
macro(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what}:\n${log}")
  endif()
endmacro()

run("cannot be installed" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run("the installed kreda does not render" ${CMAKE_COMMAND} -E env LD_DEBUG=files
  ${prefix}/bin/kreda render ${SCENE} --size 64x36 --samples 1 -o ${FOLDER}/program.exr)
if(log MATCHES "libstdc" AND NOT log MATCHES "${prefix}/lib/kreda/libkreda_images.so")
  message(FATAL_ERROR "the installed kreda does not load the module that was installed with it")
endif()

run("a program with find_package(kreda) cannot be configured" ${CMAKE_COMMAND} -S ${CONSUMER} -B ${FOLDER}/consumer
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER})
run("a program with find_package(kreda) cannot be built" ${CMAKE_COMMAND} --build ${FOLDER}/consumer)
run("a program with find_package(kreda) does not run" ${CMAKE_COMMAND} -E env LD_DEBUG=files
  ${FOLDER}/consumer/consumer ${SCENE} ${FOLDER}/consumer.exr)
if(log MATCHES "libstdc" AND NOT log MATCHES "${prefix}/lib/kreda/libkreda_images.so")
  message(FATAL_ERROR "a program with find_package(kreda) does not load the installed module")
endif()
run("the program and the library draw different pictures"
  ${prefix}/bin/kreda compare ${FOLDER}/program.exr ${FOLDER}/consumer.exr)
