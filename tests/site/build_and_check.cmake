# Builds the site and checks it: no link is broken, no picture is missing.
foreach(command "${DOCS}/build_site.py;--out;${FOLDER}/site;--kreda;${KREDA}" "${DOCS}/check_site.py;${FOLDER}/site")
  execute_process(COMMAND ${PYTHON} ${command} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "${command} failed")
  endif()
endforeach()
