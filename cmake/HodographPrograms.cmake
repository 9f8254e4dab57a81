# SPDX-License-Identifier: MIT
# Benchmarks, examples and tools: every bench/*.cpp, examples/*.cpp and tools/*.cpp is one program,
# named after its file, built on request: the targets `bench`, `examples` and each program's own.

find_package(Boost QUIET)

function(hodograph_programs folder prefix)
  add_custom_target(${folder})
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*.cpp")
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    set(target ${prefix}${name})
    add_executable(${target} EXCLUDE_FROM_ALL ${source})
    set_target_properties(${target} PROPERTIES
      OUTPUT_NAME ${name}
      RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${folder}")
    hodograph_warnings(${target})
    foreach(component IN LISTS hodograph_components)
      target_link_libraries(${target} PRIVATE hodograph::${component})
    endforeach()
    if(TARGET Boost::headers)
      target_link_libraries(${target} PRIVATE Boost::headers)
    endif()
    add_dependencies(${folder} ${target})
  endforeach()
endfunction()

hodograph_programs(bench bench_)
hodograph_programs(examples example_)
hodograph_programs(tools "")
