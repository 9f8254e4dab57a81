# SPDX-License-Identifier: MIT
# Finds Arb (ball arithmetic): the target Arb::Arb, Arb_FOUND.
# Arb is a library of its own up to 2.23 (header arb.h) and a part of FLINT from FLINT 3 on (header
# flint/arb.h); both are found, and `#include <arb.h>` works with both.

find_path(Arb_INCLUDE_DIR arb.h PATH_SUFFIXES flint)
find_path(Arb_FLINT_INCLUDE_DIR flint/flint.h)
find_library(Arb_LIBRARY NAMES flint-arb arb flint)
find_library(Arb_FLINT_LIBRARY flint)
mark_as_advanced(Arb_INCLUDE_DIR Arb_FLINT_INCLUDE_DIR Arb_LIBRARY Arb_FLINT_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS Arb_LIBRARY Arb_FLINT_LIBRARY Arb_INCLUDE_DIR Arb_FLINT_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian: apt-get install libflint-arb-dev libflint-dev")

if(Arb_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/HodographImport.cmake")
  hodograph_import(Arb::Arb
    INCLUDES "${Arb_INCLUDE_DIR}" "${Arb_FLINT_INCLUDE_DIR}"
    LIBRARIES "${Arb_LIBRARY}" "${Arb_FLINT_LIBRARY}")
endif()
