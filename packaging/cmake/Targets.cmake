# SPDX-License-Identifier: GPL-3.0-or-later
# How targets are made here: the same language level, warnings and sanitizers for all of them.
include_guard()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# Linking is a tenth of all work with the linker that compilers take by themselves; others need a quarter of its time.
# Sanitizers keep theirs.
if(NOT ROBOTCONTROL_SANITIZE)
  find_program(ROBOTCONTROL_LINKER NAMES ld.mold ld.lld ld.gold DOC "A linker that is faster than the default")
  if(ROBOTCONTROL_LINKER MATCHES "ld\\.(mold|lld|gold)$")
    add_link_options(-fuse-ld=${CMAKE_MATCH_1})
  endif()
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

option(ROBOTCONTROL_UNITY "Compile the sources of a target several at a time, which takes a third of the time" OFF)
# For those who change the code: presets of theirs and .ci/run set it. Another compiler may see what ours does not, which must not
# keep anybody from building.
set(ROBOTCONTROL_WERROR_DEFAULT OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13 AND NOT ROBOTCONTROL_UNITY)
  set(ROBOTCONTROL_WERROR_DEFAULT ON)
endif()
option(ROBOTCONTROL_WERROR "Warnings are errors" ${ROBOTCONTROL_WERROR_DEFAULT})
# So many sources at a time: enough that their common headers are read seldom. Those who edit choose fewer (CONTRIBUTING.md).
set(ROBOTCONTROL_UNITY_BATCH 48 CACHE STRING "How many sources a unity build compiles at a time")

# robotcontrol_unity(TARGET): in unity builds the target's sources are compiled together, as if they were one file. So names
# in anonymous namespaces have to be unique in a target. A source that needs flags of its own is compiled by itself.
function(robotcontrol_unity target)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${ROBOTCONTROL_UNITY} UNITY_BUILD_BATCH_SIZE ${ROBOTCONTROL_UNITY_BATCH})
endfunction()

add_library(robotcontrol_options INTERFACE)
target_include_directories(robotcontrol_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(robotcontrol_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${ROBOTCONTROL_WERROR}>:-Werror>
  # Results must not depend on which expressions the compiler fuses.
  -ffp-contract=off)
if(ROBOTCONTROL_UNITY)
  # Where a compiler takes several sources for one, these warn of what is right in each of them: of parameters with the name of
  # a function of another source, and of members whose type is the source's own. Builds that are not unity have both.
  target_compile_options(robotcontrol_options INTERFACE
    -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> -Wno-subobject-linkage)
endif()
if(ROBOTCONTROL_SANITIZE)
  # The compilers' own macros differ, and one of them is taken away below.
  target_compile_definitions(robotcontrol_options INTERFACE ROBOTCONTROL_SANITIZED)
  target_compile_options(robotcontrol_options INTERFACE
    -fsanitize=${ROBOTCONTROL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(robotcontrol_options INTERFACE -fsanitize=${ROBOTCONTROL_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # With sanitizers g++ 12 falsely reports these inside of std::regex and std::string.
    target_compile_options(robotcontrol_options INTERFACE
      -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow)
  endif()
  if(ROBOTCONTROL_SANITIZE MATCHES thread)
    # Debian's protobuf library lays its maps out without the members that this macro adds. The standard library gets its own:
    # without it, the last owner of an object counts in a way that the sanitizer does not see.
    target_compile_options(robotcontrol_options INTERFACE -U__SANITIZE_THREAD__)
    target_compile_definitions(robotcontrol_options INTERFACE _GLIBCXX_TSAN=1)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      # Boost.Asio has fences, which the sanitizer does not see; ours lie within what one thread does.
      target_compile_options(robotcontrol_options INTERFACE -Wno-tsan)
    endif()
  endif()
endif()

# Programs share the libraries with their plug-ins, which find them beside their own folder, as programs do.
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/robotcontrol)
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../lib/robotcontrol")
set(ROBOTCONTROL_LIBRARY_KIND SHARED)
if(ROBOTCONTROL_ARCOS_ONLY)
  set(ROBOTCONTROL_LIBRARY_KIND STATIC)  # becomes the one archive of the client library
endif()

# robotcontrol_installed(TARGET PUBLIC|INTERNAL): a shared library that is installed with the programs; a PUBLIC one belongs to the
# package RobotControl, with which plug-ins are built (PluginPackage.cmake).
function(robotcontrol_installed name kind)
  set_target_properties(${name} PROPERTIES DEFINE_SYMBOL "")
  # Calls inside of a library are as direct as in a program.
  target_link_options(${name} PRIVATE -Wl,-Bsymbolic-functions)
  if(NOT ROBOTCONTROL_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,-z,defs)  # it names all libraries that it uses
  endif()
  target_compile_features(${name} INTERFACE cxx_std_20)
  set_property(GLOBAL APPEND PROPERTY ROBOTCONTROL_${kind}_LIBRARIES ${name})
endfunction()

# robotcontrol_library(NAME [OBJECT] [INTERNAL] SOURCES file... [PUBLIC lib...] [PRIVATE lib...] [MOC])
# One folder's target, a shared library; plug-ins cannot use an INTERNAL one. OBJECT is for folders of solutions and adapters, which only programs have: a linker may drop
# a library of which nobody names anything. MOC is for those with QObjects.
function(robotcontrol_library name)
  cmake_parse_arguments(ARG "OBJECT;INTERNAL;MOC" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(kind ${ROBOTCONTROL_LIBRARY_KIND})
  if(ARG_OBJECT)
    set(kind OBJECT)
  endif()
  if(NOT ARG_SOURCES)
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE $<BUILD_INTERFACE:robotcontrol_options> ${ARG_PUBLIC})
    return()
  endif()
  add_library(${name} ${kind} ${ARG_SOURCES})
  robotcontrol_unity(${name})
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:robotcontrol_options> ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  if(kind STREQUAL SHARED AND ARG_INTERNAL)
    robotcontrol_installed(${name} INTERNAL)
  elseif(kind STREQUAL SHARED)
    robotcontrol_installed(${name} PUBLIC)
  endif()
  if(ARG_MOC)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_compile_definitions(${name} PUBLIC $<BUILD_INTERFACE:QT_NO_KEYWORDS> $<BUILD_INTERFACE:QT_NO_CAST_FROM_ASCII>)
  endif()
endfunction()

# robotcontrol_schemas(NAME LIBS lib... SCHEMAS file...): Protocol Buffers that are compiled to C++. Generated code has the sanitizers'
# flags of everything else, but no warnings of its own.
function(robotcontrol_schemas name)
  cmake_parse_arguments(ARG "" "" "LIBS;SCHEMAS" ${ARGN})
  add_library(${name} SHARED ${ARG_SCHEMAS})
  protobuf_generate(TARGET ${name} LANGUAGE cpp
    IMPORT_DIRS ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/robotlink/packages)
  target_include_directories(${name} SYSTEM PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}>)
  target_link_libraries(${name} PUBLIC protobuf::libprotobuf ${ARG_LIBS})
  if(ROBOTCONTROL_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${ROBOTCONTROL_SANITIZE} -U__SANITIZE_THREAD__)
    target_link_options(${name} PRIVATE -fsanitize=${ROBOTCONTROL_SANITIZE})
  endif()
  robotcontrol_installed(${name} PUBLIC)
endfunction()

# Tests run for a moment and are compiled for minutes: without optimization that takes three quarters of the time. Those that
# compute (LOOPS) are optimized a little.
function(robotcontrol_quick_compilation name)
  cmake_parse_arguments(ARG "LOOPS" "" "" ${ARGN})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${ARG_LOOPS}>,-O1,-O0>>)
endfunction()

# What GoogleTest programs include most, compiled once for all of them: tests_precompiled, and tests_precompiled_loops for those
# that are optimized.
function(robotcontrol_precompile_tests)
  file(WRITE ${CMAKE_BINARY_DIR}/tests_precompiled.cpp "// Carries the precompiled headers of the tests.\nint main() {}\n")
  foreach(kind "" LOOPS)
    set(name tests_precompiled)
    if(kind)
      set(name tests_precompiled_loops)
    endif()
    add_executable(${name} EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/tests_precompiled.cpp)
    target_link_libraries(${name} PRIVATE robotcontrol_options Eigen3::Eigen protobuf::libprotobuf GTest::gmock_main)
    robotcontrol_quick_compilation(${name} ${kind})
    target_precompile_headers(${name} PRIVATE
      <gmock/gmock.h> <gtest/gtest.h> <Eigen/Geometry> <google/protobuf/message.h> <functional> <map> <memory> <string> <vector>)
  endforeach()
endfunction()

# What a test labeled slow does is bounded by the test itself: by simulated time, inputs or bytes. On a machine that does other
# things, too, it may take as long as it takes; this limit, in seconds, ends what hangs.
set(ROBOTCONTROL_SLOW_TIMEOUT 3600)

# robotcontrol_add_test(NAME COMMAND word... [LABELS label...] [TIMEOUT seconds]): what ctest knows of a program of tests.
function(robotcontrol_add_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "COMMAND;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  if("slow" IN_LIST ARG_LABELS)
    set(ARG_TIMEOUT ${ROBOTCONTROL_SLOW_TIMEOUT})
  endif()
  if(ROBOTCONTROL_SANITIZE)
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 10")  # what sanitizers cost at most, on a machine that does other things, too
  endif()
  add_test(NAME ${name} COMMAND ${ARG_COMMAND})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}"
    # A program that runs no test tests nothing; QtTest counts what it does before and after as two.
    FAIL_REGULAR_EXPRESSION "Running 0 tests from;Totals: [0-2] passed, 0 failed, 0 skipped"
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/lsan.supp:print_suppressions=0;TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/tsan.supp")
endfunction()

# robotcontrol_test_program(NAME [QT] [LOOPS] [SOURCES file...] LIBS lib...): a program of tests that ctest does not know yet.
function(robotcontrol_test_program name)
  cmake_parse_arguments(ARG "QT;LOOPS" "" "SOURCES;LIBS" ${ARGN})
  set(precompiled tests_precompiled)
  set(loops)
  if(ARG_LOOPS)
    set(precompiled tests_precompiled_loops)
    set(loops LOOPS)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  robotcontrol_unity(${name})
  robotcontrol_quick_compilation(${name} ${loops})
  target_compile_definitions(${name} PRIVATE
    ROBOTCONTROL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(${name} PRIVATE robotcontrol_options ${ARG_LIBS} Qt5::Test)
  else()
    target_link_libraries(${name} PRIVATE robotcontrol_options ${ARG_LIBS} GTest::gmock_main)
    target_precompile_headers(${name} REUSE_FROM ${precompiled})
  endif()
endfunction()

# robotcontrol_filter(VARIABLE file...): what --gtest_filter needs to run the tests in these files, but those that are called slow.
function(robotcontrol_filter variable)
  set(patterns)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} tests REGEX "^((TYPED_)?TEST(_F|_P)?|INSTANTIATE_(TYPED_)?TEST_SUITE_P)\\(")
    foreach(test IN LISTS tests)
      # What is instantiated may be written in a header.
      string(REGEX REPLACE "^INSTANTIATE[A-Z_]+\\([A-Za-z0-9_]*, *" "(" test "${test}")
      string(REGEX REPLACE "^[A-Z_]*\\(([A-Za-z0-9_]+),.*" "\\1" suite "${test}")
      list(APPEND patterns "${suite}.*" "*/${suite}.*" "${suite}/*" "*/${suite}/*")
    endforeach()
    if(tests)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES patterns)
  list(JOIN patterns ":" filter)
  set(${variable} "${filter}:-Slow*" PARENT_SCOPE)
endfunction()

# robotcontrol_test(NAME [PROGRAM program] SOURCES file... LIBS lib... [LABELS label...] [TIMEOUT seconds] [QT] [LOOPS])
# One GoogleTest program of a folder; QT makes it a QtTest program that runs offscreen. Tests with the same PROGRAM are compiled and
# linked together, which takes less than half of the time, and run each by itself.
function(robotcontrol_test name)
  cmake_parse_arguments(ARG "QT;LOOPS" "PROGRAM;TIMEOUT" "SOURCES;LIBS;LABELS" ${ARGN})
  set(kind)
  foreach(option QT LOOPS)
    if(ARG_${option})
      list(APPEND kind ${option})
    endif()
  endforeach()
  if(NOT ARG_PROGRAM)
    robotcontrol_test_program(${name} ${kind} SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS})
    robotcontrol_add_test(${name} COMMAND ${name} LABELS ${ARG_LABELS} TIMEOUT ${ARG_TIMEOUT})
    return()
  endif()
  if(NOT TARGET ${ARG_PROGRAM})
    robotcontrol_test_program(${ARG_PROGRAM} ${kind} LIBS ${ARG_LIBS})
  endif()
  target_sources(${ARG_PROGRAM} PRIVATE ${ARG_SOURCES})
  target_link_libraries(${ARG_PROGRAM} PRIVATE ${ARG_LIBS})
  robotcontrol_filter(filter ${ARG_SOURCES})
  robotcontrol_add_test(${name} COMMAND ${ARG_PROGRAM} --gtest_filter=${filter} LABELS ${ARG_LABELS} TIMEOUT ${ARG_TIMEOUT})
endfunction()

# robotcontrol_gui_test(NAME PROGRAM file [NO_OPENGL] [TIMEOUT seconds]): adds the class in a file, which has its name, to a
# program of tests whose main() is that of tests/widgets/GuiTestMain.cpp. ctest runs each class by itself; NO_OPENGL: as on a
# computer without it.
function(robotcontrol_gui_test name program file)
  cmake_parse_arguments(ARG "NO_OPENGL" "TIMEOUT" "" ${ARGN})
  cmake_path(GET file STEM class)
  target_sources(${program} PRIVATE ${file})
  robotcontrol_add_test(${name} COMMAND ${program} ${class} LABELS gui TIMEOUT ${ARG_TIMEOUT})
  if(ARG_NO_OPENGL)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null)
  endif()
endfunction()

# robotcontrol_benchmark(NAME SOURCES file... LIBS lib...): a Google Benchmark program; never a timed test.
function(robotcontrol_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  if(ROBOTCONTROL_BENCHMARKS)
    add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE robotcontrol_options ${ARG_LIBS} benchmark::benchmark_main)
    add_dependencies(benchmarks ${name})
  endif()
endfunction()
add_custom_target(benchmarks)
