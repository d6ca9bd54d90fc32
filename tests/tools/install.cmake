# cmake -DBUILD=... -DFOLDER=... -DSCENE=... -P install.cmake
# Installs into an empty folder and renders a scene with textures there: program and module must find each other.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "cannot be installed:\n${log}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_DEBUG=files
  ${FOLDER}/bin/kreda render ${SCENE} --size 64x36 -o ${FOLDER}/picture.png
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(NOT code EQUAL 0 OR NOT EXISTS ${FOLDER}/picture.png)
  message(FATAL_ERROR "the installed kreda does not render:\n${log}")
endif()
if(log MATCHES "libstdc" AND NOT log MATCHES "${FOLDER}/lib/kreda/libkreda_images.so")
  message(FATAL_ERROR "the installed kreda does not load the module that was installed with it")
endif()
