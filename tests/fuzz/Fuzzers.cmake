# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzing of what reads files of others. To add a target: write a source like logplayer/fuzz/McapReaderFuzz.cpp (see
# FuzzTarget.h), and a line in its folder's CMakeLists.txt.
#
# In every build a driver runs it over mutated seeds: for a moment with the other tests, for a minute labeled slow. The targets of a
# folder share one program, since each by itself takes longer to compile than to run.
# ./test --fuzz SECONDS runs all of them with libFuzzer, each for so long. One alone:
#   cmake --preset fuzz && ninja -C build/fuzz mcap_reader_libfuzzer logplayer_fuzz
#   build/fuzz/bin/logplayer_fuzz mcap_reader --write-seeds corpus
#   build/fuzz/bin/mcap_reader_libfuzzer -max_total_time=3600 corpus
include_guard()
add_custom_target(fuzzers)

# robotcontrol_fuzzer(NAME PROGRAM program SOURCES file... LIBS lib... [INPUTS n]): a target of the program, and NAME_libfuzzer in the
# preset fuzz. INPUTS: how many the brief test runs.
function(robotcontrol_fuzzer name)
  cmake_parse_arguments(ARG "" "INPUTS;PROGRAM" "SOURCES;LIBS" ${ARGN})
  if(NOT ARG_INPUTS)
    set(ARG_INPUTS 300)
  endif()
  if(NOT TARGET ${ARG_PROGRAM})
    robotcontrol_fuzz_program(${ARG_PROGRAM} ${PROJECT_SOURCE_DIR}/tests/fuzz/FuzzDriver.cpp)
  endif()
  target_sources(${ARG_PROGRAM} PRIVATE ${ARG_SOURCES})
  target_link_libraries(${ARG_PROGRAM} PRIVATE ${ARG_LIBS})
  if(ROBOTCONTROL_FUZZ)
    robotcontrol_fuzz_program(${name}_libfuzzer ${PROJECT_SOURCE_DIR}/tests/fuzz/LibFuzzerEntry.cpp)
    target_sources(${name}_libfuzzer PRIVATE ${ARG_SOURCES})
    target_link_libraries(${name}_libfuzzer PRIVATE ${ARG_LIBS})
    set_target_properties(${name}_libfuzzer PROPERTIES EXCLUDE_FROM_ALL ON)
    target_link_options(${name}_libfuzzer PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers ${ARG_PROGRAM} ${name}_libfuzzer)
  endif()
  robotcontrol_add_test(${name}_fuzz COMMAND ${ARG_PROGRAM} ${name} --inputs ${ARG_INPUTS})
  robotcontrol_add_test(${name}_fuzz_minute COMMAND ${ARG_PROGRAM} ${name} --seconds 60 LABELS slow)
endfunction()

# robotcontrol_fuzz_program(NAME file...): a program with the main() in these sources.
function(robotcontrol_fuzz_program name)
  add_executable(${name} ${ARGN})
  robotcontrol_unity(${name})
  robotcontrol_quick_compilation(${name})
  target_link_libraries(${name} PRIVATE robotcontrol_options)
  target_compile_definitions(${name} PRIVATE ROBOTCONTROL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
