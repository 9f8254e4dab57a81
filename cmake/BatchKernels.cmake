# SPDX-License-Identifier: MIT
# Compiles the batch kernels (src/<folder>/kernels/*_<instruction set>.cpp) once for every instruction set;
# the program chooses at run time (src/path/kernel_dispatch.cpp). No flag reaches any other file. Every
# instruction set compiles the same templates, so one of them is enough where the sanitizers look
# (HODOGRAPH_WIDE_KERNELS=OFF), and there the optimiser would only take time.

set(hodograph_kernel_options
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-fno-math-errno;-fno-trapping-math;-Wno-psabi>"
    "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<NOT:$<CONFIG:Debug,Sanitize>>>:-O3>")
set(hodograph_instruction_sets baseline)
set(hodograph_flags_of_baseline)
if(HODOGRAPH_WIDE_KERNELS AND CMAKE_SIZEOF_VOID_P EQUAL 8
   AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$"
   AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  list(APPEND hodograph_instruction_sets avx2 avx512)
  set(hodograph_flags_of_avx2 -mavx2 -mfma)
  set(hodograph_flags_of_avx512 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/src/path/kernel_dispatch.cpp"
    "${PROJECT_SOURCE_DIR}/src/frame/rolled_frames.cpp"
    "${PROJECT_SOURCE_DIR}/src/frame/minimising_frames.cpp"
    "${PROJECT_SOURCE_DIR}/src/construction/hermite_batch.cpp"
    "${PROJECT_SOURCE_DIR}/src/construction/planar_batch.cpp"
    "${PROJECT_SOURCE_DIR}/src/control/reference_batch.cpp"
    PROPERTIES COMPILE_DEFINITIONS HODOGRAPH_X86_KERNELS=1)
endif()

# hodograph_kernels(<target> <folder>...): the kernels of these folders belong to the target.
function(hodograph_kernels target)
  foreach(instruction_set IN LISTS hodograph_instruction_sets)
    foreach(folder IN LISTS ARGN)
      file(GLOB files CONFIGURE_DEPENDS
        "${PROJECT_SOURCE_DIR}/src/${folder}/kernels/*_${instruction_set}.cpp")
      target_sources(${target} PRIVATE ${files})
      # Long bodies of small operations: the sanitizers' checks of each take the optimiser minutes.
      set_source_files_properties(${files} PROPERTIES
        COMPILE_OPTIONS "${hodograph_kernel_options};${hodograph_flags_of_${instruction_set}};$<$<CONFIG:Sanitize>:-O0>"
        SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
  endforeach()
endfunction()

hodograph_kernels(hodograph_core path frame construction)
