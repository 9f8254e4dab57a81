# SPDX-License-Identifier: MIT
# Uses the package as a stranger would: cmake -D CASE=... -P run.cmake
#
#   installed          installs into a fresh prefix, find_package, builds, runs, compares the output
#   missing_component  asks that installation for a component it has not; the message must name it
#   pkg_config         compiles the program by hand with what pkg-config says
#   subproject         add_subdirectory, builds, runs, compares the output
#
# Given: SOURCE and BUILD (Hodograph's folders), WORK (a folder to use), COMPONENTS, COMPILER.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
  set(status "${status}" PARENT_SCOPE)
endfunction()

function(must_run)
  run(${ARGN})
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(check_program program)
  must_run("${program}")
  file(READ "${CMAKE_CURRENT_LIST_DIR}/expected_output.txt" expected)
  if(NOT output STREQUAL expected)
    message(FATAL_ERROR "expected\n${expected}\nbut the program printed\n${output}")
  endif()
endfunction()

set(prefix "${WORK}/prefix")
set(tree "${WORK}/${CASE}")
file(REMOVE_RECURSE "${tree}")
set(common -G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_COMPILER=${COMPILER}")

if(CASE STREQUAL "install")
  file(REMOVE_RECURSE "${prefix}")
  must_run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
elseif(CASE STREQUAL "installed")
  must_run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/installed" -B "${tree}" ${common}
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCOMPONENTS=${COMPONENTS}")
  must_run("${CMAKE_COMMAND}" --build "${tree}")
  check_program("${tree}/consumer")
elseif(CASE STREQUAL "missing_component")
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/installed" -B "${tree}" ${common}
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCOMPONENTS=core,teleport")
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  if(status EQUAL 0 OR NOT output MATCHES "component 'teleport' is not in this installation")
    message(FATAL_ERROR "a missing component is not named (${status}):\n${output}")
  endif()
elseif(CASE STREQUAL "pkg_config")
  file(GLOB_RECURSE files "${prefix}/*/hodograph.pc")
  get_filename_component(folder "${files}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} "${folder}")
  must_run(pkg-config --cflags --libs hodograph)
  separate_arguments(flags UNIX_COMMAND "${output}")
  file(MAKE_DIRECTORY "${tree}")
  must_run("${COMPILER}" -std=c++20 "${CMAKE_CURRENT_LIST_DIR}/main.cpp" -o "${tree}/consumer"
    ${flags})
  check_program("${tree}/consumer")
elseif(CASE STREQUAL "subproject")
  must_run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/subproject" -B "${tree}" ${common}
    "-DHODOGRAPH_SOURCE=${SOURCE}")
  must_run("${CMAKE_COMMAND}" --build "${tree}" --target consumer)
  check_program("${tree}/consumer")
else()
  message(FATAL_ERROR "there is no case '${CASE}'")
endif()
