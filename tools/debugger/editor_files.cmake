# Writes .vscode/launch.json and tasks.json with a configuration for every example:
#   cmake -P tools/debugger/editor_files.cmake
# With -DCHECK=ON it writes nothing and fails where they are not what it would write.
if(NOT SOURCE)
  get_filename_component(SOURCE ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
endif()

file(GLOB mains RELATIVE ${SOURCE}/examples ${SOURCE}/examples/[0-9][0-9]_*/main.cpp)
set(configurations "")
set(tasks "")

function(add_program name arguments)
  set(launch "    {
      \"name\": \"${name}\",
      \"type\": \"cppdbg\",
      \"request\": \"launch\",
      \"program\": \"\${workspaceFolder}/build/debug/bin/${name}\",
      \"args\": [${arguments}],
      \"cwd\": \"\${workspaceFolder}\",
      \"environment\": [{ \"name\": \"OMP_NUM_THREADS\", \"value\": \"1\" }],
      \"stopAtEntry\": true,
      \"MIMode\": \"gdb\",
      \"setupCommands\": [
        { \"text\": \"-enable-pretty-printing\" },
        { \"text\": \"source \${workspaceFolder}/tools/debugger/kreda.py\" }
      ],
      \"preLaunchTask\": \"build ${name}\"
    }")
  set(task "    {
      \"label\": \"build ${name}\",
      \"type\": \"shell\",
      \"command\": \"./course\",
      \"args\": [\"build\", \"debug\", \"${name}\"],
      \"options\": { \"cwd\": \"\${workspaceFolder}\" },
      \"problemMatcher\": [\"\$gcc\"],
      \"group\": \"build\"
    }")
  set(configurations ${configurations} "${launch}" PARENT_SCOPE)
  set(tasks ${tasks} "${task}" PARENT_SCOPE)
endfunction()

foreach(main ${mains})
  get_filename_component(name ${main} DIRECTORY)
  add_program(${name} "\"--out\", \"out\", \"--draft\"")
endforeach()
add_program(kreda "\"render\", \"-o\", \"out/debugged.png\"")

function(write_or_check path text)
  set(old "")
  if(EXISTS ${SOURCE}/${path})
    file(READ ${SOURCE}/${path} old)
  endif()
  if(CHECK AND NOT old STREQUAL text)
    message(FATAL_ERROR "${path} does not fit the examples; run: cmake -P tools/debugger/editor_files.cmake")
  elseif(NOT old STREQUAL text)
    file(WRITE ${SOURCE}/${path} "${text}")
    message("wrote ${path}")
  endif()
endfunction()

list(JOIN configurations ",\n" configurations)
list(JOIN tasks ",\n" tasks)
set(note "// Written by tools/debugger/editor_files.cmake; docs/debugging.md says how to use it.\n")
write_or_check(.vscode/launch.json "${note}{\n  \"version\": \"0.2.0\",\n  \"configurations\": [\n${configurations}\n  ]\n}\n")
write_or_check(.vscode/tasks.json "${note}{\n  \"version\": \"2.0.0\",\n  \"tasks\": [\n${tasks}\n  ]\n}\n")
