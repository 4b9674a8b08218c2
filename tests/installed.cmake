# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the programs into an empty folder, moves that, and runs them from there, without the sources' resources.
# cmake -D BUILD_DIR=... -D GUI=ON|OFF -P installed.cmake
function(run)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=ROBOTCONTROL_RESOURCES QT_QPA_PLATFORM=offscreen
                          XDG_CONFIG_HOME=${WORK_DIR}/config ${ARGN}
                  WORKING_DIRECTORY / RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(status)
    list(JOIN ARGN " " command)
    file(REMOVE_RECURSE ${WORK_DIR})
    message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Not below the sources, where programs would find the resources above their own folder.
set(temporary $ENV{TMPDIR})
if(NOT temporary)
  set(temporary /tmp)
endif()
string(RANDOM LENGTH 12 name)
set(WORK_DIR ${temporary}/robotcontrol-${name})
file(MAKE_DIRECTORY ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix "${WORK_DIR}/first place")
file(RENAME "${WORK_DIR}/first place" "${WORK_DIR}/another place")
set(prefix "${WORK_DIR}/another place")

run("${prefix}/bin/robotctl" sim "${prefix}/share/robotcontrol/scenes/field2002.sdf" --seconds 1 --seed 1 --json)
if(GUI)
  run("${prefix}/bin/robotcontrol" --version)
  run("${prefix}/bin/robotcontrol" --screenshot "${WORK_DIR}/window.png" --after 1)
  foreach(file "${WORK_DIR}/window.png" "${prefix}/share/robotcontrol/translations/robotcontrol_de.qm" "${prefix}/share/applications/robotcontrol.desktop"
          "${prefix}/share/icons/hicolor/scalable/apps/robotcontrol.svg")
    if(NOT EXISTS "${file}")
      message(FATAL_ERROR "there is no ${file}")
    endif()
  endforeach()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
