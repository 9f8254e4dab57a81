# SPDX-License-Identifier: MIT
# Finds Ipopt (interior-point optimiser): the target Ipopt::Ipopt, Ipopt_FOUND. Its headers are
# included as <IpIpoptApplication.hpp>. Versions before 3.14 ask for HAVE_CSTDDEF.

find_path(Ipopt_INCLUDE_DIR IpIpoptApplication.hpp PATH_SUFFIXES coin-or coin)
find_library(Ipopt_LIBRARY ipopt)
mark_as_advanced(Ipopt_INCLUDE_DIR Ipopt_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt
  REQUIRED_VARS Ipopt_LIBRARY Ipopt_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian: apt-get install coinor-libipopt-dev")

if(Ipopt_FOUND AND NOT TARGET Ipopt::Ipopt)
  add_library(Ipopt::Ipopt INTERFACE IMPORTED)
  set_target_properties(Ipopt::Ipopt PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${Ipopt_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${Ipopt_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS "HAVE_CSTDDEF"
    INTERFACE_LINK_LIBRARIES "${Ipopt_LIBRARY}")
endif()
