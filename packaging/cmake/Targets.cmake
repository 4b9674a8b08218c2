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

# robotcontrol_moc(TARGET): runs moc on those with QObjects. What moc needs of a file stands in it; all that the file includes it
# would read only to find macros, for half a second each.
function(robotcontrol_moc target)
  set(script ${CMAKE_BINARY_DIR}/moc_without_includes)
  if(NOT EXISTS ${script})
    get_target_property(moc Qt5::moc IMPORTED_LOCATION)
    file(WRITE ${script} "#!/bin/sh
for word do
  shift
  case $word in -I*) ;; *) set -- \"$@\" \"$word\" ;; esac
done
exec '${moc}' \"$@\"
")
    file(CHMOD ${script} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endif()
  # Nor need it wait until what the headers belong to can be linked.
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${script} AUTOGEN_ORIGIN_DEPENDS OFF)
endfunction()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # What it keeps of sources with precompiled headers it keeps only if it is told that the headers' macros do not matter. It asks
  # the compiler what a source includes, instead of preprocessing the source before it compiles it.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1 ${CCACHE})
endif()

option(ROBOTCONTROL_UNITY "Compile the sources of a target several at a time, which takes a third of the time" OFF)
# For those who change the code: presets of theirs and .ci/run set it. Another compiler may see what ours does not, which must not
# keep anybody from building.
set(ROBOTCONTROL_WERROR_DEFAULT OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13 AND NOT ROBOTCONTROL_UNITY)
  set(ROBOTCONTROL_WERROR_DEFAULT ON)
endif()
option(ROBOTCONTROL_WERROR "Warnings are errors" ${ROBOTCONTROL_WERROR_DEFAULT})
if(ROBOTCONTROL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # g++ collects its garbage again and again while a large source fills its memory; above 1 GB is early enough, and a tenth faster.
  add_compile_options("SHELL:--param ggc-min-heapsize=1000000")
endif()
# So many sources at a time: enough that their common headers are read seldom. Those who edit choose fewer (CONTRIBUTING.md).
set(ROBOTCONTROL_UNITY_BATCH 80 CACHE STRING "How many sources a unity build compiles at a time at most")

# robotcontrol_unity(TARGET): in unity builds the target's sources are compiled together, as if they were one file. So names
# in anonymous namespaces have to be unique in a target. A source that needs flags of its own is compiled by itself.
function(robotcontrol_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ROBOTCONTROL_UNITY})
  # Later folders may add sources.
  cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]] CALL robotcontrol_even_batches [[${target}]])")
endfunction()

# robotcontrol_even_batches(TARGET): as few batches as the limit allows, all of the same size, so that none is waited for.
function(robotcontrol_even_batches target)
  get_target_property(sources ${target} SOURCES)
  set(count 0)
  foreach(source IN LISTS sources)
    get_source_file_property(alone ${source} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
    if(NOT alone)
      math(EXPR count "${count} + 1")
    endif()
  endforeach()
  set(limit ${ROBOTCONTROL_UNITY_BATCH})
  math(EXPR size "${count}")
  if(limit GREATER 0 AND count GREATER limit)
    math(EXPR batches "(${count} + ${limit} - 1) / ${limit}")
    math(EXPR size "(${count} + ${batches} - 1) / ${batches}")
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${size})

  get_target_property(precompiled ${target} ROBOTCONTROL_PRECOMPILED)
  if(precompiled AND TARGET ${precompiled})
    set_property(TARGET ${target} PROPERTY PRECOMPILE_HEADERS)  # what it has in other builds
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
endfunction()

# robotcontrol_no_loops(TARGET): for what waits for people, files and lines: wiring, dialogs, commands. A little optimization, which
# inlines small functions only, is enough there, and takes two thirds of the time to compile.
function(robotcontrol_no_loops target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:SHELL:-mllvm -inline-threshold=10>")
  endif()
  set_target_properties(${target} PROPERTIES ROBOTCONTROL_PRECOMPILED robotcontrol_precompiled_no_loops)
endfunction()

# robotcontrol_declarations(TARGET): for what declares options, reads a command line and prints, once in a run: not optimized, it
# takes half of the time to compile.
function(robotcontrol_declarations target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  robotcontrol_not_precompiled(${target})
endfunction()

# robotcontrol_not_precompiled(TARGET): for what includes little of the precompiled headers, or has flags that they do not have.
function(robotcontrol_not_precompiled target)
  set_target_properties(${target} PROPERTIES ROBOTCONTROL_PRECOMPILED "")
endfunction()

# What sources include most, compiled once for all libraries: robotcontrol_precompiled, and robotcontrol_precompiled_no_loops for
# those that are optimized a little, which wire packages of all kinds. A target takes the one that its property
# ROBOTCONTROL_PRECOMPILED names. Builds that are not unity have none, and so find what a source has not included; g++ 12 has none,
# since with them it reports false warnings inside of std::string.
set(ROBOTCONTROL_PRECOMPILES OFF)
if(ROBOTCONTROL_UNITY AND NOT ROBOTCONTROL_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  set(ROBOTCONTROL_PRECOMPILES ON)
endif()
function(robotcontrol_precompile)
  if(NOT ROBOTCONTROL_PRECOMPILES)
    return()
  endif()
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "// Carries the precompiled headers of the libraries.\n")
  foreach(name robotcontrol_precompiled robotcontrol_precompiled_no_loops)
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${name} PRIVATE robotcontrol_options Eigen3::Eigen protobuf::libprotobuf tl::expected)
    target_precompile_headers(${name} PRIVATE
      <Eigen/Geometry> <google/protobuf/descriptor.h> <google/protobuf/map.h> <google/protobuf/message.h> <google/protobuf/repeated_field.h>
      <tl/expected.hpp>
      <algorithm> <array> <atomic> <chrono> <cmath> <condition_variable> <deque> <filesystem> <fstream> <functional> <iomanip> <iostream>
      <map> <memory> <mutex> <numeric> <optional> <set> <span> <sstream> <string> <thread> <unordered_map> <utility> <variant> <vector>)
  endforeach()
  robotcontrol_no_loops(robotcontrol_precompiled_no_loops)
  target_link_libraries(robotcontrol_precompiled_no_loops PRIVATE nlohmann_json::nlohmann_json)
  # To link them would be to wait for all of them.
  target_include_directories(robotcontrol_precompiled_no_loops SYSTEM PRIVATE
    $<TARGET_PROPERTY:robotlink_schemas,INTERFACE_SYSTEM_INCLUDE_DIRECTORIES>)
  add_dependencies(robotcontrol_precompiled_no_loops robotlink_schemas_code)
  target_precompile_headers(robotcontrol_precompiled_no_loops PRIVATE
    <nlohmann/json.hpp> <robotcontrol/Debugging.pb.h> <robotcontrol/Requests.pb.h>)
endfunction()

add_library(robotcontrol_options INTERFACE)
target_include_directories(robotcontrol_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(robotcontrol_options INTERFACE
  # Conversions between signed and unsigned numbers: g++ does not count them as -Wconversion.
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion $<$<BOOL:${ROBOTCONTROL_WERROR}>:-Werror>
  # Results must not depend on which expressions the compiler fuses.
  -ffp-contract=off)
if(ROBOTCONTROL_UNITY)
  # Where a compiler takes several sources for one, these warn of what is right in each of them: of parameters with the name of
  # a function of another source, and of members whose type is the source's own. Builds that are not unity have both.
  target_compile_options(robotcontrol_options INTERFACE
    -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local -Wno-subobject-linkage>)
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
  set_target_properties(${name} PROPERTIES ROBOTCONTROL_PRECOMPILED robotcontrol_precompiled)
  robotcontrol_unity(${name})
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:robotcontrol_options> ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  if(kind STREQUAL SHARED AND NOT ROBOTCONTROL_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,-z,defs)  # it names all libraries that it uses
  endif()
  if(kind STREQUAL SHARED AND ARG_INTERNAL)
    robotcontrol_installed(${name} INTERNAL)
  elseif(kind STREQUAL SHARED)
    robotcontrol_installed(${name} PUBLIC)
  endif()
  if(ARG_MOC)
    robotcontrol_moc(${name})
    target_compile_definitions(${name} PUBLIC $<BUILD_INTERFACE:QT_NO_KEYWORDS> $<BUILD_INTERFACE:QT_NO_CAST_FROM_ASCII>)
  endif()
endfunction()

# robotcontrol_schemas(NAME [FLAT] SOURCES file.proto... IMPORT folder... [USES name]): messages of Protocol Buffers. What protoc
# makes of them is compiled as one source; the names that all of its sources have are made unique for that. FLAT: headers are
# included without the folders that the files lie in. USES: other schemas, whose files these import.
function(robotcontrol_schemas name)
  cmake_parse_arguments(ARG "FLAT" "USES" "SOURCES;IMPORT" ${ARGN})
  set(flat)
  if(ARG_FLAT)
    set(flat APPEND_PATH)
  endif()
  add_library(${name} SHARED ${ARG_SOURCES})
  protobuf_generate(TARGET ${name} LANGUAGE cpp IMPORT_DIRS ${ARG_IMPORT} OUT_VAR generated ${flat})
  add_custom_target(${name}_code DEPENDS ${generated})
  target_include_directories(${name} SYSTEM PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}>)
  target_link_libraries(${name} PUBLIC protobuf::libprotobuf)
  if(ARG_USES)
    # To link them would be to wait for all of them before protoc runs.
    target_include_directories(${name} SYSTEM PRIVATE $<TARGET_PROPERTY:${ARG_USES},INTERFACE_SYSTEM_INCLUDE_DIRECTORIES>)
    target_link_libraries(${name} INTERFACE ${ARG_USES})
    add_dependencies(${name} ${ARG_USES}_code)
  endif()
  # Generated code: the sanitizers' flags of everything else, but no warnings of its own.
  if(ROBOTCONTROL_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${ROBOTCONTROL_SANITIZE} -U__SANITIZE_THREAD__)
    target_link_options(${name} PRIVATE -fsanitize=${ROBOTCONTROL_SANITIZE})
  endif()
  robotcontrol_installed(${name} PUBLIC)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${ROBOTCONTROL_UNITY} UNITY_BUILD_BATCH_SIZE 0 UNITY_BUILD_UNIQUE_ID SCHEMA_ID
    UNITY_BUILD_CODE_BEFORE_INCLUDE "#include <google/protobuf/generated_message_reflection.h>
#define SCHEMA_JOINED(name, id) name##id
#define SCHEMA_UNIQUE(name, id) SCHEMA_JOINED(name, id)
#define schemas SCHEMA_UNIQUE(schemas_, SCHEMA_ID)
#define file_default_instances SCHEMA_UNIQUE(file_default_instances_, SCHEMA_ID)"
    UNITY_BUILD_CODE_AFTER_INCLUDE "#undef schemas
#undef file_default_instances
#undef SCHEMA_UNIQUE
#undef SCHEMA_JOINED")
endfunction()

# Tests run for a moment and are compiled for minutes: without optimization that takes three quarters of the time. Those that
# compute (LOOPS) are optimized a little.
function(robotcontrol_quick_compilation name)
  cmake_parse_arguments(ARG "LOOPS" "" "" ${ARGN})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${ARG_LOOPS}>,-O1,-O0>>)
endfunction()

# What GoogleTest programs include most, compiled once for all of them: tests_precompiled, and tests_precompiled_loops for those
# that are optimized. Tests of views share tests_precompiled_views.
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
    if(ROBOTCONTROL_PRECOMPILES)
      target_precompile_headers(${name} PRIVATE
        <google/protobuf/descriptor.h> <google/protobuf/map.h> <tl/expected.hpp>
        <algorithm> <chrono> <condition_variable> <deque> <filesystem> <fstream> <iostream> <mutex> <optional> <set> <span> <sstream>
        <thread> <unordered_map> <variant>)
    endif()
  endforeach()
  if(ROBOTCONTROL_GUI AND ROBOTCONTROL_PRECOMPILES)
    add_library(tests_precompiled_views OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/tests_precompiled.cpp)
    target_link_libraries(tests_precompiled_views PRIVATE robotcontrol_options Eigen3::Eigen protobuf::libprotobuf Qt5::Widgets Qt5::Test)
    target_compile_definitions(tests_precompiled_views PRIVATE QT_NO_KEYWORDS QT_NO_CAST_FROM_ASCII)
    robotcontrol_quick_compilation(tests_precompiled_views)
    target_precompile_headers(tests_precompiled_views PRIVATE
      <QAction> <QApplication> <QComboBox> <QImage> <QLabel> <QMenu> <QPushButton> <QSignalSpy> <QTest> <QTreeView> <QWidget>
      <Eigen/Geometry> <google/protobuf/descriptor.h> <google/protobuf/map.h> <google/protobuf/message.h> <tl/expected.hpp>
      <algorithm> <chrono> <deque> <filesystem> <fstream> <functional> <map> <memory> <mutex> <optional> <set> <span> <sstream> <string>
      <thread> <variant> <vector>)
  endif()
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
  # Where ctest has not measured yet how long they take, those that may take longest begin, so that none is waited for at the end.
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} COST ${ARG_TIMEOUT} LABELS "${ARG_LABELS}"
    # A program that runs no test tests nothing; QtTest counts what it does before and after as two.
    FAIL_REGULAR_EXPRESSION "Running 0 tests from;Totals: [0-2] passed, 0 failed, 0 skipped"
    # Texts are in English, whatever the language of who runs the tests.
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8;LANGUAGE=;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/lsan.supp:print_suppressions=0;TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/tsan.supp")
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
    robotcontrol_moc(${name})
    set_target_properties(${name} PROPERTIES ROBOTCONTROL_PRECOMPILED tests_precompiled_views)
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
