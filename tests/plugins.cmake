# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the programs into an empty folder, builds the shipped examples of plug-ins there with find_package(RobotControl), without the
# sources, and uses what they add.
# cmake -D BUILD_DIR=... -D GUI=ON|OFF -D COMPILER=... -D LAUNCHER=... -D WERROR=ON|OFF -D PYTHON=... -D CONTROLLERS=.../controllers.py -P plugins.cmake
set(temporary $ENV{TMPDIR})
if(NOT temporary)
  set(temporary /tmp)
endif()
string(RANDOM LENGTH 12 name)
set(WORK_DIR ${temporary}/robotcontrol-${name})
file(MAKE_DIRECTORY ${WORK_DIR})

function(fail)
  file(REMOVE_RECURSE ${WORK_DIR})
  message(FATAL_ERROR ${ARGN})
endfunction()

# run(STATUS word...): runs a command; its outputs together are in `output`.
function(run expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=ROBOTCONTROL_RESOURCES --unset=DISPLAY --unset=WAYLAND_DISPLAY QT_QPA_PLATFORM=offscreen
                          XDG_CONFIG_HOME=${WORK_DIR}/config ${ARGN}
                  WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_VARIABLE errors)
  if(NOT status EQUAL expected)
    list(JOIN ARGN " " command)
    fail("${command}\nended with ${status}:\n${printed}${errors}")
  endif()
  set(output "${printed}${errors}" PARENT_SCOPE)
endfunction()

function(expect text)
  string(FIND "${output}" "${text}" at)
  if(at EQUAL -1)
    fail("'${text}' is not in this:\n${output}")
  endif()
endfunction()

run(0 ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix "${WORK_DIR}/prefix")
set(prefix "${WORK_DIR}/prefix")
set(flags)
if(WERROR)
  set(flags "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
endif()
run(0 ${CMAKE_COMMAND} -S "${prefix}/share/robotcontrol/examples/plugins" -B "${WORK_DIR}/build" -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${flags})
run(0 ${CMAKE_COMMAND} --build "${WORK_DIR}/build" --parallel 2)
set(robotctl "${prefix}/bin/robotctl" --plugin "${WORK_DIR}/build/mean_ball.so" --plugin "${WORK_DIR}/build/diary_log.so")

# A solution, with its parameters, in a program of its own, too.
run(0 ${robotctl} plugins)
expect("mean-ball 1.0")
expect("diary-log 1.0")
set(scene "${prefix}/share/robotcontrol/scenes/field2002.sdf")
run(0 ${robotctl} sim "${scene}" --seconds 1 --seed 1 --json --solution ball-model=mean)
run(0 ${robotctl} sim "${scene}" --seconds 1 --seed 1 --json --solution ball-model=mean --own-process all)
run(1 "${prefix}/bin/robotctl" sim "${scene}" --seconds 1 --seed 1 --json --solution ball-model=mean)
expect("mean")

# A log format.
file(WRITE "${WORK_DIR}/night.txt" "# diary\n0.5 all is quiet\nnonsense\n2 a door opens\n")
run(3 ${robotctl} log import "${WORK_DIR}/night.txt" "${WORK_DIR}/night.mcap")
expect("2 messages of the diary")
expect("line 3 is no entry")
run(0 "${prefix}/bin/robotctl" log search "${WORK_DIR}/night.mcap" "log.message =~ \"door\"")
expect("a door opens")

# A controller of scenes.
set(patrol "${prefix}/share/robotcontrol/examples/plugins/patrol/patrol.sdf")
run(0 "${prefix}/bin/robotctl" --plugin "${WORK_DIR}/build/patrol.so" scene check "${patrol}" --seconds 3 --json)
expect("cart")
run(1 "${prefix}/bin/robotctl" scene check "${patrol}" --seconds 1)
expect("there is no controller 'patrol'")
expect("patrol.sdf:12")

# A remote controller, in C++.
run(0 ${CMAKE_COMMAND} -S "${prefix}/share/robotcontrol/examples/controllers" -B "${WORK_DIR}/controllers" -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${flags})
run(0 ${CMAKE_COMMAND} --build "${WORK_DIR}/controllers")
run(2 "${WORK_DIR}/controllers/wander")
expect("wander SERVER ROBOT")
run(0 ${PYTHON} ${CONTROLLERS} "${prefix}/bin/robotctl" "${prefix}/share/robotcontrol/examples/controllers" "${prefix}/share/robotcontrol/scenes/pioneer.sdf"
    "${WORK_DIR}/controllers/wander" "{url}" p3at1 --start)
expect("the controller steers the robot")

# Those in the user's folder are loaded, others go on without one that fails.
file(COPY "${WORK_DIR}/build/mean_ball.so" DESTINATION "${WORK_DIR}/config/robotcontrol/plugins")
file(WRITE "${WORK_DIR}/config/robotcontrol/plugins/broken.so" "no library")
run(1 "${prefix}/bin/robotctl" plugins)
expect("mean-ball 1.0")
expect("broken.so  not loaded: this is no plug-in of RobotControl")
run(0 "${prefix}/bin/robotctl" --no-plugins plugins)

# A view, a toolbar and a command.
if(GUI)
  file(WRITE "${WORK_DIR}/use.script" [[
view.show ball-distance
wait until simulation.time > 0.5
ball.require-near 100
screenshot ball-distance picture.png
]])
  run(0 "${prefix}/bin/robotcontrol" --plugin "${WORK_DIR}/build/ball_distance.so" --script "${WORK_DIR}/use.script" "${scene}")
  if(NOT EXISTS "${WORK_DIR}/picture.png")
    fail("there is no picture of the view:\n${output}")
  endif()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
