# Builds the site and checks it: all symbols resolve, no link is broken.
foreach(command "${DOCS}/build_site.py;--check;--out;${FOLDER}/site;--kreda;${KREDA}" "${DOCS}/check_site.py;${FOLDER}/site")
  execute_process(COMMAND ${PYTHON} ${command} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "${command} failed")
  endif()
endforeach()
