# SPDX-License-Identifier: MIT
# Finds GeographicLib (places on the Earth): the target GeographicLib::GeographicLib,
# GeographicLib_FOUND. Its own package where there is one (version 2.2 and later, or built from
# source), else the header and the library (Debian 12).

find_package(GeographicLib CONFIG QUIET)
if(NOT TARGET GeographicLib::GeographicLib)
  find_path(GeographicLib_INCLUDE_DIR GeographicLib/LocalCartesian.hpp)
  find_library(GeographicLib_LIBRARY NAMES GeographicLib Geographic)
  mark_as_advanced(GeographicLib_INCLUDE_DIR GeographicLib_LIBRARY)

  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(GeographicLib
    REQUIRED_VARS GeographicLib_LIBRARY GeographicLib_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "on Debian: apt-get install libgeographiclib-dev")

  if(GeographicLib_FOUND)
    include("${CMAKE_CURRENT_LIST_DIR}/HodographImport.cmake")
    hodograph_import(GeographicLib::GeographicLib
      INCLUDES "${GeographicLib_INCLUDE_DIR}"
      LIBRARIES "${GeographicLib_LIBRARY}")
  endif()
else()
  set(GeographicLib_FOUND TRUE)
endif()
