# SPDX-License-Identifier: MIT
# hodograph_component(<name> MODULES <folder>... [FOLDERS <folder>...] [DEPENDS <component>...]
#                     [LINK <target>...])
#
# One library, hodograph::<name>, of the sources src/<folder>/*.cpp, FOLDERS being those inside a
# module; without sources (yet) it carries only its headers. DEPENDS and LINK are passed on to whoever links it.

function(hodograph_component name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "MODULES;FOLDERS;DEPENDS;LINK")
  set(target hodograph_${name})
  list(TRANSFORM arg_DEPENDS PREPEND hodograph::)

  set(sources)
  foreach(module IN LISTS arg_MODULES arg_FOLDERS)
    file(GLOB found CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${module}/*.cpp")
    list(APPEND sources ${found})
  endforeach()

  if(sources)
    add_library(${target} ${sources})
    set(scope PUBLIC)
    hodograph_warnings(${target})
    if(PROJECT_IS_TOP_LEVEL)  # one precompiled header for all components
      if(name STREQUAL "core")
        target_precompile_headers(${target} PRIVATE
          <algorithm> <array> <cmath> <cstddef> <functional> <limits> <optional> <span> <string>
          <utility> <vector> <hodograph/path/path.hpp>)
      else()
        target_precompile_headers(${target} REUSE_FROM hodograph_core)
      endif()
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(hodograph::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    OUTPUT_NAME hodograph_${name}
    HODOGRAPH_MODULES "${arg_MODULES}"
    POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${arg_DEPENDS} ${arg_LINK})
  string(TOUPPER ${name} NAME)
  if(NOT name STREQUAL "core")
    target_compile_definitions(${target} ${scope} HODOGRAPH_HAS_${NAME}=1)
  endif()

  # A compiler that fuses a*b + c into one rounding breaks the error bounds of the enclosures and
  # makes results differ between machines. Much of the library is templates, compiled in the user's
  # files, so the option is passed on to whoever links the library.
  target_compile_options(${target} ${scope}
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang,IntelLLVM>:-ffp-contract=off>")

  # GCC copies and clears objects of up to 8 KiB by `rep movs` and `rep stos`, which take some thirty
  # cycles to start; curves and results are a few hundred bytes. (A seventh of the time of one climb.)
  if(sources AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$"
     AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(strategy "unrolled_loop:1024:noalign,libcall:-1:noalign")
    target_compile_options(${target} PRIVATE
      "$<$<CONFIG:Release>:-mmemcpy-strategy=${strategy};-mmemset-strategy=${strategy}>")
  endif()

  list(APPEND hodograph_components ${name})
  list(REMOVE_DUPLICATES hodograph_components)
  set(hodograph_components "${hodograph_components}" PARENT_SCOPE)
endfunction()

# The warnings of our own targets; never passed on. Templates over a degree are instantiated for
# degree 0 as well, where `i < n` is always false: GCC would warn of that with -Wtype-limits. Its
# -Wmaybe-uninitialized is wrong about unions it has inlined (GCC 12, variants and JSON values), and
# -Warray-bounds, -Wrestrict and -Wstringop-over... about short strings it has inlined (GCC 12,
# strings made by substr and +); the sanitizers look for what they mean.
function(hodograph_warnings target)
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion>"
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-type-limits;-Wno-maybe-uninitialized>"
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overread;-Wno-stringop-overflow>")
  if(HODOGRAPH_WARNINGS_AS_ERRORS)
    set_target_properties(${target} PROPERTIES COMPILE_WARNING_AS_ERROR ON)
  endif()
endfunction()

# Options for what takes long to compile and little time to run, in the presets that test: such
# targets gain nothing from the optimiser. (In the configuration Develop every warning still works.)
set(hodograph_quick_to_compile
  "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Develop>>:-O1>"
  "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Sanitize>>:-O0>")
