# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the client library into an empty folder, builds a template against it alone, and runs it.
# cmake -D SOURCE_DIR=... -D BUILD_DIR=... -D WORK_DIR=... -D GENERATOR=... -D CXX=... -P installed.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
  if(status)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --component arcos --prefix ${WORK_DIR}/prefix)

# Of the installed headers none may need what the library promises not to.
file(GLOB_RECURSE headers ${WORK_DIR}/prefix/include/*.h)
list(LENGTH headers count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} headers were installed")
endif()
set(all "")
foreach(header ${headers})
  file(READ ${header} text)
  if(text MATCHES "#include [<\"](Q[A-Z]|Qt|boost/|google/|[a-z/]*\\.pb\\.h)")
    message(FATAL_ERROR "${header} needs more than it should: ${CMAKE_MATCH_0}")
  endif()
  file(RELATIVE_PATH name ${WORK_DIR}/prefix/include/robotcontrol ${header})
  string(APPEND all "#include \"${name}\"\n")
endforeach()

# The template as a user has it: copied somewhere else. One more file includes every header.
file(COPY ${SOURCE_DIR}/resources/templates/pioneer/wander DESTINATION ${WORK_DIR})
file(WRITE ${WORK_DIR}/wander/headers.cpp "${all}")
file(APPEND ${WORK_DIR}/wander/CMakeLists.txt "target_sources(wander PRIVATE headers.cpp)\n")
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK_DIR}/wander -B ${WORK_DIR}/build -D CMAKE_CXX_COMPILER=${CXX}
    -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)

# There is no robot; it must say so, by the library's words.
execute_process(COMMAND ${WORK_DIR}/build/wander tcp://127.0.0.1:1 RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 1 OR NOT said MATCHES "nothing listens at 127.0.0.1:1")
  message(FATAL_ERROR "the template ended with ${status} and said: ${said}")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
