# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzing of what reads files of others. To add a target: write a source like logplayer/fuzz/McapReaderFuzz.cpp (see
# FuzzTarget.h), and a line in its folder's CMakeLists.txt.
#
# In every build a driver runs it over mutated seeds: for a moment with the other tests, for a minute labeled slow.
# ./test --fuzz SECONDS runs all of them with libFuzzer, each for so long. One alone:
#   cmake --preset fuzz && ninja -C build/fuzz mcap_reader_libfuzzer mcap_reader_fuzz
#   build/fuzz/bin/mcap_reader_fuzz --write-seeds corpus
#   build/fuzz/bin/mcap_reader_libfuzzer -max_total_time=3600 corpus
include_guard()
add_custom_target(fuzzers)

# robotcontrol_fuzzer(NAME SOURCES file... LIBS lib... [INPUTS n]): NAME_fuzz, and NAME_libfuzzer in the preset fuzz.
# INPUTS: how many the brief test runs.
function(robotcontrol_fuzzer name)
  cmake_parse_arguments(ARG "" "INPUTS" "SOURCES;LIBS" ${ARGN})
  if(NOT ARG_INPUTS)
    set(ARG_INPUTS 300)
  endif()
  add_executable(${name}_fuzz ${ARG_SOURCES} ${PROJECT_SOURCE_DIR}/tests/fuzz/FuzzDriver.cpp)
  set(targets ${name}_fuzz)
  if(ROBOTCONTROL_FUZZ)
    add_executable(${name}_libfuzzer EXCLUDE_FROM_ALL ${ARG_SOURCES})
    target_link_options(${name}_libfuzzer PRIVATE -fsanitize=fuzzer)
    list(APPEND targets ${name}_libfuzzer)
    add_dependencies(fuzzers ${name}_fuzz ${name}_libfuzzer)
  endif()
  foreach(target ${targets})
    robotcontrol_unity(${target})
    robotcontrol_quick_compilation(${target})
    target_link_libraries(${target} PRIVATE robotcontrol_options ${ARG_LIBS})
    target_compile_definitions(${target} PRIVATE ROBOTCONTROL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    # What libFuzzer found to be worth keeping, see packaging/fuzz.sh.
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}.txt)
      target_compile_definitions(${target} PRIVATE FUZZ_CORPUS="${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}.txt")
    endif()
  endforeach()
  robotcontrol_add_test(${name}_fuzz COMMAND ${name}_fuzz --inputs ${ARG_INPUTS})
  robotcontrol_add_test(${name}_fuzz_minute COMMAND ${name}_fuzz --seconds 60 LABELS slow)
endfunction()
