# SPDX-License-Identifier: MIT
# Finds the part of OpenCASCADE that writes STEP: the target OpenCASCADE::STEP, OpenCASCADE_FOUND.
# Its own package names every library it has, the viewer's and its dependencies' included; these
# are the ones that are needed.

find_path(OpenCASCADE_INCLUDE_DIR STEPControl_Writer.hxx PATH_SUFFIXES opencascade occt)
set(OpenCASCADE_STEP_LIBRARIES)
set(OpenCASCADE_required OpenCASCADE_INCLUDE_DIR)
foreach(name TKSTEP TKXSBase TKTopAlgo TKBRep TKG3d TKMath TKernel)
  find_library(OpenCASCADE_${name} ${name})
  list(APPEND OpenCASCADE_STEP_LIBRARIES "${OpenCASCADE_${name}}")
  list(APPEND OpenCASCADE_required OpenCASCADE_${name})
endforeach()
mark_as_advanced(${OpenCASCADE_required})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCASCADE
  REQUIRED_VARS ${OpenCASCADE_required}
  REASON_FAILURE_MESSAGE "on Debian: apt-get install libocct-data-exchange-dev")

if(OpenCASCADE_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/HodographImport.cmake")
  hodograph_import(OpenCASCADE::STEP
    INCLUDES "${OpenCASCADE_INCLUDE_DIR}"
    LIBRARIES ${OpenCASCADE_STEP_LIBRARIES})
endif()
