# SPDX-License-Identifier: MIT
# Finds Clp (linear programs): the target CLP::CLP, CLP_FOUND. Its headers are included as
# <Clp_C_Interface.h>.

find_path(CLP_INCLUDE_DIR Clp_C_Interface.h PATH_SUFFIXES coin coin-or)
find_library(CLP_LIBRARY Clp)
mark_as_advanced(CLP_INCLUDE_DIR CLP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CLP
  REQUIRED_VARS CLP_LIBRARY CLP_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian: apt-get install coinor-libclp-dev")

if(CLP_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/HodographImport.cmake")
  hodograph_import(CLP::CLP INCLUDES "${CLP_INCLUDE_DIR}" LIBRARIES "${CLP_LIBRARY}")
endif()
