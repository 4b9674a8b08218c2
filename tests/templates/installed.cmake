# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the client library into an empty folder and builds the templates against it alone, into WORK_DIR/bin.
# cmake -D SOURCE_DIR=... -D BUILD_DIR=... -D WORK_DIR=... -D GENERATOR=... -D CXX=... -D TEMPLATES=a;b -P installed.cmake
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
if("${headers}" MATCHES "/arcos/server/")
  message(FATAL_ERROR "headers of the robot's side were installed")
endif()
file(GLOB_RECURSE archive ${WORK_DIR}/prefix/*.a)
execute_process(COMMAND nm -C ${archive} OUTPUT_VARIABLE symbols ERROR_QUIET)
if(NOT symbols MATCHES "PioneerRobot::begin" OR symbols MATCHES "arcos::(ServerSession|RobotPorts)::")
  message(FATAL_ERROR "${archive} lacks the client's side, or has the robot's side, too")
endif()
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

# The templates as users have them: copied somewhere else. One of them gets a file that includes every header.
file(COPY ${SOURCE_DIR}/resources/templates/pioneer DESTINATION ${WORK_DIR})
file(WRITE ${WORK_DIR}/pioneer/wander/headers.cpp "${all}")
file(APPEND ${WORK_DIR}/pioneer/wander/CMakeLists.txt "target_sources(wander PRIVATE headers.cpp)\n")
foreach(template ${TEMPLATES})
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK_DIR}/pioneer/${template} -B ${WORK_DIR}/build/${template}
      -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
      -D CMAKE_RUNTIME_OUTPUT_DIRECTORY=${WORK_DIR}/bin)
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/build/${template})
endforeach()

# What the guide for programmers shows works as it is pasted from there.
function(paste first file)
  file(READ ${SOURCE_DIR}/robotlink/arcos/CLIENT.md guide)
  if(NOT guide MATCHES "\n(    ${first}[^\n]*\n((    [^\n]*)?\n)*)")
    message(FATAL_ERROR "CLIENT.md has no block that begins with ${first}")
  endif()
  string(REGEX REPLACE "(^|\n)    " "\\1" block "${CMAKE_MATCH_1}")
  file(WRITE ${file} "${block}")
endfunction()
paste("cmake_minimum_required" ${WORK_DIR}/pasted/CMakeLists.txt)
paste("#include <iostream>" ${WORK_DIR}/pasted/main.cpp)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK_DIR}/pasted -B ${WORK_DIR}/build/pasted -D CMAKE_CXX_COMPILER=${CXX}
    -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build/pasted)

# The library alone is configured where there are few packages.
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE_DIR} -B ${WORK_DIR}/build/alone -D CMAKE_CXX_COMPILER=${CXX}
    -D ROBOTCONTROL_ARCOS_ONLY=ON -D CMAKE_DISABLE_FIND_PACKAGE_Qt5=ON -D CMAKE_DISABLE_FIND_PACKAGE_Protobuf=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)

# There is no robot; it must say so, by the library's words.
execute_process(COMMAND ${WORK_DIR}/bin/wander tcp://127.0.0.1:1 RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 1 OR NOT said MATCHES "nothing listens at 127.0.0.1:1")
  message(FATAL_ERROR "the template ended with ${status} and said: ${said}")
endif()
