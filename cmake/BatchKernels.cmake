# SPDX-License-Identifier: MIT
# Compiles the batch kernels (src/*/kernels/*_<instruction set>.cpp) once for every instruction set; the
# program chooses at run time (src/path/kernel_dispatch.cpp). No flag reaches any other file. Every
# instruction set compiles the same templates, so one of them is enough where the sanitizers look
# (HODOGRAPH_WIDE_KERNELS=OFF), and there the optimiser would only take time.

set(kernel_options
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-fno-math-errno;-fno-trapping-math;-Wno-psabi>"
    "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<NOT:$<CONFIG:Debug,Sanitize>>>:-O3>")

# The kernels of one instruction set, with the flags that name it.
function(hodograph_kernels instruction_set)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/*/kernels/*_${instruction_set}.cpp")
  target_sources(hodograph_core PRIVATE ${files})
  set_source_files_properties(${files} PROPERTIES
    COMPILE_OPTIONS "${kernel_options};${ARGN}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()

hodograph_kernels(baseline)
if(HODOGRAPH_WIDE_KERNELS AND CMAKE_SIZEOF_VOID_P EQUAL 8
   AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$"
   AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  hodograph_kernels(avx2 -mavx2)
  hodograph_kernels(avx512 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/src/path/kernel_dispatch.cpp"
    "${PROJECT_SOURCE_DIR}/src/frame/rolled_frames.cpp"
    "${PROJECT_SOURCE_DIR}/src/construction/hermite_batch.cpp"
    "${PROJECT_SOURCE_DIR}/src/construction/planar_batch.cpp"
    PROPERTIES COMPILE_DEFINITIONS HODOGRAPH_X86_KERNELS=1)
endif()
