# SPDX-License-Identifier: MIT
# The options of the build. HODOGRAPH_WITH_<NAME> is AUTO (built if its library is found), ON (an
# error if it is not) or OFF. As a subproject only the core is built unless more is asked for.

set(hodograph_components core)

if(PROJECT_IS_TOP_LEVEL)
  set(hodograph_default_with AUTO)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()
else()
  set(hodograph_default_with OFF)
endif()

foreach(name PLANNING CERTIFY RATIONAL ORBIT CONTROL IO GEODESY CAD INTEROP PROGRAM PYTHON)
  set(HODOGRAPH_WITH_${name} ${hodograph_default_with} CACHE STRING
      "Build this component (GEODESY: this part of io; PYTHON: the package): AUTO, ON or OFF")
  set_property(CACHE HODOGRAPH_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
endforeach()

option(HODOGRAPH_BUILD_TESTS "Build the tests (needs GoogleTest and Boost)" OFF)
option(HODOGRAPH_TEST_CONSUMERS "Test the package from projects outside the tree" ON)
option(HODOGRAPH_BUILD_BENCHMARKS "Offer the targets of bench/, examples/ and tools/"
       ${PROJECT_IS_TOP_LEVEL})
option(HODOGRAPH_WIDE_KERNELS "Compile batch kernels for AVX2 and AVX-512 as well" ON)
option(HODOGRAPH_INSTALL "Write install rules" ${PROJECT_IS_TOP_LEVEL})
option(HODOGRAPH_WARNINGS_AS_ERRORS "Treat the warnings of our own sources as errors" OFF)

if(CMAKE_CXX_COMPILER_LAUNCHER)  # a compiler cache remembers file by file
  set(hodograph_default_join OFF)
else()
  set(hodograph_default_join ON)
endif()
option(HODOGRAPH_JOIN_SOURCES "Compile several sources of the program as one: half the time"
       ${hodograph_default_join})

# hodograph_find(<NAME> <package> [arguments of find_package])
# Sets hodograph_has_<name> where the component is wanted and its library is there.
function(hodograph_find NAME package)
  string(TOLOWER ${NAME} name)
  set(wanted "${HODOGRAPH_WITH_${NAME}}")
  if(wanted STREQUAL "AUTO")
    find_package(${package} ${ARGN} QUIET)
  elseif(wanted)
    find_package(${package} ${ARGN} REQUIRED)
  endif()
  if(wanted AND ${package}_FOUND)
    set(hodograph_has_${name} TRUE PARENT_SCOPE)
    set(hodograph_note_${name} "on" PARENT_SCOPE)
  else()
    set(hodograph_has_${name} FALSE PARENT_SCOPE)
    if(wanted)
      set(hodograph_note_${name} "off (${package} not found)" PARENT_SCOPE)
    else()
      set(hodograph_note_${name} "off" PARENT_SCOPE)
    endif()
  endif()
endfunction()

function(hodograph_summary)
  if(PROJECT_IS_TOP_LEVEL)
    message(STATUS "Hodograph ${PROJECT_VERSION} (${CMAKE_BUILD_TYPE}): core on"
                   ", planning ${hodograph_note_planning}"
                   ", certify ${hodograph_note_certify}, rational ${hodograph_note_rational}, orbit ${hodograph_note_orbit}"
                   ", control ${hodograph_note_control}"
                   ", io ${hodograph_note_io}, geodesy ${hodograph_note_geodesy}, cad ${hodograph_note_cad}"
                   ", interop ${hodograph_note_interop}"
                   ", program ${hodograph_note_program}, python ${hodograph_note_python}")
  endif()
endfunction()
