# SPDX-License-Identifier: MIT
# What the modules Find<package>.cmake of this folder share.

# hodograph_import(<target> INCLUDES <directory>... LIBRARIES <library>...)
# The imported target <target> for libraries that were found; nothing where it exists.
function(hodograph_import target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "INCLUDES;LIBRARIES")
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED)
    set_target_properties(${target} PROPERTIES
      INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${arg_INCLUDES}"
      INTERFACE_INCLUDE_DIRECTORIES "${arg_INCLUDES}"
      INTERFACE_LINK_LIBRARIES "${arg_LIBRARIES}")
  endif()
endfunction()
