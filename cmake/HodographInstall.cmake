# SPDX-License-Identifier: MIT
# Install rules: libraries and headers of the components that were built, the program, the CMake
# package (find_package(hodograph COMPONENTS ...)) and a pkg-config file for the core.
include(CMakePackageConfigHelpers)

set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/hodograph")

foreach(component IN LISTS hodograph_components)
  install(TARGETS hodograph_${component} EXPORT hodograph-${component}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  install(EXPORT hodograph-${component} NAMESPACE hodograph::
    DESTINATION "${package_directory}" FILE hodograph-${component}-targets.cmake)
  get_target_property(modules hodograph_${component} HODOGRAPH_MODULES)
  foreach(module IN LISTS modules)
    if(EXISTS "${PROJECT_SOURCE_DIR}/include/hodograph/${module}")
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/hodograph/${module}"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/hodograph" FILES_MATCHING PATTERN "*.hpp")
    endif()
  endforeach()
endforeach()

if(TARGET hodograph_program)
  install(TARGETS hodograph_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  if(TARGET hodograph_step_module)
    install(TARGETS hodograph_step_module LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/hodograph")
  endif()
endif()

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/hodographConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/package/hodographConfig.cmake"
  INSTALL_DESTINATION "${package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/hodographConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/package/hodographConfig.cmake"
  "${PROJECT_BINARY_DIR}/package/hodographConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/HodographImport.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindArb.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindCLP.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindIpopt.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindOpenCASCADE.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindGeographicLib.cmake"
  DESTINATION "${package_directory}")

foreach(kind LIBDIR INCLUDEDIR)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${kind}}")
    set(pc_${kind} "${CMAKE_INSTALL_${kind}}")
  else()
    set(pc_${kind} "\${prefix}/${CMAKE_INSTALL_${kind}}")
  endif()
endforeach()
configure_file("${PROJECT_SOURCE_DIR}/cmake/hodograph.pc.in"
  "${PROJECT_BINARY_DIR}/package/hodograph.pc" @ONLY)
# The prefix is known only when installing (cmake --install --prefix), so it is written then.
install(CODE "
  file(READ \"${PROJECT_BINARY_DIR}/package/hodograph.pc\" text)
  string(REPLACE \"%PREFIX%\" \"\${CMAKE_INSTALL_PREFIX}\" text \"\${text}\")
  file(WRITE \"${PROJECT_BINARY_DIR}/package/installed/hodograph.pc\" \"\${text}\")")
install(FILES "${PROJECT_BINARY_DIR}/package/installed/hodograph.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
