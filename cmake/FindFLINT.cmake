# SPDX-License-Identifier: MIT
# Finds FLINT (exact arithmetic): the target FLINT::FLINT, FLINT_FOUND. Its headers are included as
# <fmpq_poly.h>. Inline functions in them call GMP, which is linked with it.

find_path(FLINT_INCLUDE_DIR fmpq_poly.h PATH_SUFFIXES flint)
find_path(FLINT_PREFIXED_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_library(FLINT_GMP_LIBRARY gmp)
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_PREFIXED_INCLUDE_DIR FLINT_LIBRARY FLINT_GMP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT
  REQUIRED_VARS FLINT_LIBRARY FLINT_GMP_LIBRARY FLINT_INCLUDE_DIR FLINT_PREFIXED_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian: apt-get install libflint-dev")

if(FLINT_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/HodographImport.cmake")
  hodograph_import(FLINT::FLINT
    INCLUDES "${FLINT_INCLUDE_DIR}" "${FLINT_PREFIXED_INCLUDE_DIR}"
    LIBRARIES "${FLINT_LIBRARY}" "${FLINT_GMP_LIBRARY}")
endif()
